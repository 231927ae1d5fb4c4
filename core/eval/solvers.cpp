#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/stop.hpp"
#include "core/eval/block_matrix.hpp"
#include "core/eval/machine.hpp"
#include "core/eval/program_code.hpp"
#include "core/eval/rank_deficient.hpp"

namespace analogon {

bool factorise(std::span<double> matrix, std::span<int> pivots, std::span<double> scale) {
    const auto n = pivots.size();
    for (std::size_t row = 0; row < n; ++row) {
        double largest = 0;
        for (std::size_t column = 0; column < n; ++column)
            largest = std::max(largest, std::fabs(matrix[row * n + column]));
        if (!(largest > 0) || !std::isfinite(largest)) return false;
        scale[row] = 1 / largest;
    }
    for (std::size_t k = 0; k < n; ++k) {
        if (k % 64 == 63 && isStopped()) return false;
        std::size_t best = k;
        double most = 0, before = 0;
        for (std::size_t row = 0; row < n; ++row) {
            const double size = std::fabs(matrix[row * n + k]) * scale[row];
            if (row < k)
                before = std::max(before, size);
            else if (size > most)
                most = size, best = row;
        }
        // What is left of a column after elimination is rounding when it is this small beside what was there.
        if (!(most > 4 * std::numeric_limits<double>::epsilon() * before) || !std::isfinite(most)) return false;
        pivots[k] = static_cast<int>(best);
        if (best != k) {
            for (std::size_t column = 0; column < n; ++column)
                std::swap(matrix[k * n + column], matrix[best * n + column]);
            std::swap(scale[k], scale[best]);
        }
        const double inverse = 1 / matrix[k * n + k];
        for (std::size_t row = k + 1; row < n; ++row) {
            const double factor = matrix[row * n + k] *= inverse;
            if (factor == 0) continue;
            for (std::size_t column = k + 1; column < n; ++column)
                matrix[row * n + column] -= factor * matrix[k * n + column];
        }
    }
    return true;
}

void substitute(std::span<const double> matrix, std::span<const int> pivots, double* right, int stride, int width) {
    const auto n = pivots.size();
    const auto at = [&](std::size_t row) { return right + row * static_cast<std::size_t>(stride); };
    for (std::size_t k = 0; k < n; ++k)
        if (const auto p = static_cast<std::size_t>(pivots[k]); p != k) std::swap_ranges(at(k), at(k) + width, at(p));
    for (std::size_t row = 1; row < n; ++row)
        for (std::size_t k = 0; k < row; ++k) {
            const double factor = matrix[row * n + k];
            for (int j = 0; j < width; ++j) at(row)[j] -= factor * at(k)[j];
        }
    for (std::size_t row = n; row-- > 0;) {
        for (std::size_t k = row + 1; k < n; ++k) {
            const double factor = matrix[row * n + k];
            for (int j = 0; j < width; ++j) at(row)[j] -= factor * at(k)[j];
        }
        const double inverse = 1 / matrix[row * n + row];
        for (int j = 0; j < width; ++j) at(row)[j] *= inverse;
    }
}

namespace {

void fail(Registers& r, const std::string& name) {
    r.failure = name;
    r.failedToSolve = true;
}

double* tangentsAt(Registers& r, std::uint32_t reg) {
    return r.tangents.data() + static_cast<std::size_t>(reg) * static_cast<std::size_t>(r.lanes);
}

/// What a block computes from its unknowns: by machine code where the workspace has it.
class Body {
public:
    Body(std::size_t number, const ProgramTables& tables, Registers& registers, int mode)
        : block_(tables.nonlinear[number]), tables_(tables), r_(registers), mode_(static_cast<TangentMode>(mode)) {
        Registers::Code& code = r_.code[mode < 0 ? InputsConstant : mode_];
        if (!code.made || code.made->tables != &tables) return;
        functions_ = &code.made->bodies[number];
        scratch_ = &code.bodies[number];
    }
    void values() {
        if (functions_)
            (*functions_->values.function)(r_.values.data(), r_.tangents.data(), scratch_->values.data(), &r_);
        else
            runBodyValues(block_.body, tables_, r_);
    }
    void tangents() {
        if (functions_)
            (*functions_->tangents.function)(r_.values.data(), r_.tangents.data(), scratch_->tangents.data(), &r_);
        else
            runBodyTangents(block_.body, tables_, r_, mode_);
    }

private:
    const NonlinearBlock& block_;
    const ProgramTables& tables_;
    Registers& r_;
    TangentMode mode_;
    const SystemCode::Body* functions_{};
    Registers::Code::Body* scratch_{};
};

/// Newton's method for one block (Deuflhard 2004, section 3: damping by halving), with the row scaling of its
/// first Jacobian.
class NewtonIteration {
public:
    NewtonIteration(const NonlinearBlock& block, Body& body, BlockFactors* kept, Registers& registers)
        : block_(block),
          body_(body),
          r_(registers),
          n_(block.unknowns.size()),
          jacobian_(block.jacobian, block.entries, n_, kept, registers) {}

    bool from(std::span<const double> start) { return n_ == 1 ? fromOne(start[0]) : fromMany(start); }
    /// A single unknown: looks for a change of sign around the start and closes in on it.
    bool byBracket(double start);
    /// Factors the Jacobian at the solution.
    bool factoriseHere() {
        evaluate();
        jacobian_.load();
        return jacobian_.factorise();
    }
    /// With these factors.
    void solve(double* right, int width) const { jacobian_.solve(right, width); }

private:
    bool fromOne(double start);
    bool fromMany(std::span<const double> start);
    double& unknown(std::size_t i) { return r_.values[block_.unknowns[i]]; }
    double residual(std::size_t i) const { return r_.values[block_.residuals[i]]; }
    void evaluate() { body_.values(); }
    double norm() const;
    void setRowScale();
    double valueAt(double z) {
        unknown(0) = z;
        evaluate();
        return residual(0);
    }

    const NonlinearBlock& block_;
    Body& body_;
    Registers& r_;
    std::size_t n_;
    BlockMatrix jacobian_;
};

void NewtonIteration::setRowScale() {
    std::fill_n(r_.rowScale.begin(), n_, 0.0);
    jacobian_.visit([&](std::size_t i, std::size_t j, double value) {
        r_.rowScale[i] = std::max(r_.rowScale[i], std::fabs(value) * block_.nominal[j]);
    });
    for (std::size_t i = 0; i < n_; ++i) {
        const double largest = r_.rowScale[i];
        r_.rowScale[i] = largest > 0 && std::isfinite(largest) ? 1 / largest : 1;
    }
}

double NewtonIteration::norm() const {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i) {
        const double scaled = residual(i) * r_.rowScale[i];
        sum += scaled * scaled;
    }
    return std::sqrt(sum);
}

constexpr int mostSteps = 60, mostHalvings = 30;
constexpr double converged = 1e-11, good = 1e-7;

/// Whether a full step reaches the solution: it is small, or the one before it was so much larger that the error it
/// leaves, which falls quadratically, is.
bool reaches(double step, double before) {
    return step <= converged || (step <= 1e-3 * before && step * step * step <= 0.1 * converged * before * before);
}

/// One unknown: no matrix, and the residual is measured as it is.
bool NewtonIteration::fromOne(double start) {
    double z = start, value = valueAt(z), before = 0;
    for (int step = 0; step < mostSteps; ++step) {
        if (value == 0) return true;
        const double change = value / r_.values[block_.jacobian[0]];
        const double relative = std::fabs(change) / (std::fabs(z) + block_.nominal[0]);
        if (!std::isfinite(relative)) return false;
        double fraction = 1, reached = value;
        for (int halving = 0; halving < mostHalvings; ++halving, fraction /= 2) {
            reached = valueAt(z - fraction * change);
            if (halving == 0 && reaches(relative, before) && std::isfinite(reached)) return true;
            if (std::fabs(reached) < std::fabs(value)) break;
        }
        if (!(std::fabs(reached) < std::fabs(value))) {
            valueAt(z);
            return relative <= good;
        }
        z -= fraction * change;
        value = reached;
        before = fraction == 1 ? relative : 0;
    }
    return false;
}

bool NewtonIteration::fromMany(std::span<const double> start) {
    for (std::size_t i = 0; i < n_; ++i) unknown(i) = start[i];
    evaluate();
    jacobian_.load();
    setRowScale();
    double size = norm(), before = 0;
    for (int step = 0; step < mostSteps; ++step) {
        if (size == 0) return true;
        if (!std::isfinite(size) || isStopped()) return false;
        if (!jacobian_.factorise()) return false;
        for (std::size_t i = 0; i < n_; ++i) r_.vector[i] = residual(i);
        jacobian_.solve(r_.vector.data(), 1);
        double relative = 0;
        for (std::size_t i = 0; i < n_; ++i) {
            r_.trial[i] = unknown(i);
            relative = std::max(relative, std::fabs(r_.vector[i]) / (std::fabs(unknown(i)) + block_.nominal[i]));
        }
        if (!std::isfinite(relative)) return false;
        double fraction = 1, reached = size;
        for (int halving = 0; halving < mostHalvings; ++halving, fraction /= 2) {
            for (std::size_t i = 0; i < n_; ++i) unknown(i) = r_.trial[i] - fraction * r_.vector[i];
            evaluate();
            reached = norm();
            // What it leaves is decided by rounding: take it as it is.
            if (halving == 0 && reaches(relative, before) && std::isfinite(reached)) return true;
            if (reached < size) break;
        }
        if (!(reached < size)) {
            for (std::size_t i = 0; i < n_; ++i) unknown(i) = r_.trial[i];
            return relative <= good;
        }
        size = reached;
        before = fraction == 1 ? relative : 0;
        jacobian_.load();
    }
    return false;
}

bool NewtonIteration::byBracket(double start) {
    double low = start, high = start, atLow = valueAt(start), atHigh = atLow;
    if (atLow == 0) return true;
    double width = 1e-3 * (std::fabs(start) + block_.nominal[0]);
    for (int i = 0; i < 80 && !(atLow * atHigh < 0); ++i, width *= 2) {
        const double below = valueAt(start - width), above = valueAt(start + width);
        if (std::isfinite(below) && below * atHigh <= 0) {
            low = start - width, atLow = below;
        } else if (std::isfinite(above) && above * atLow <= 0) {
            high = start + width, atHigh = above;
        }
        if (below == 0) return unknown(0) = start - width, evaluate(), true;
        if (above == 0) return unknown(0) = start + width, evaluate(), true;
    }
    if (!(atLow * atHigh < 0)) return false;
    for (int i = 0; i < 200 && high - low > 4e-16 * (std::fabs(low) + std::fabs(high)); ++i) {
        const double middle = 0.5 * (low + high), value = valueAt(middle);
        if (value == 0) return true;
        if (!std::isfinite(value)) return false;
        if (value * atLow < 0)
            high = middle;
        else
            low = middle, atLow = value;
    }
    unknown(0) = 0.5 * (low + high);
    evaluate();
    return true;
}

/// The starts that are tried in turn: the last solution, the model's start values, and some way off them.
bool iterate(const NonlinearBlock& block, NewtonIteration& newton, Registers& r) {
    const auto n = block.unknowns.size();
    const std::span<double> start(r.start.data(), n);
    if (r.hasGuess[block.guess]) {
        for (std::size_t i = 0; i < n; ++i) start[i] = r.guesses[block.guess + i];
        if (newton.from(start)) return true;
        if (n == 1 && newton.byBracket(start[0])) return true;
    }
    for (const double offset : {0.0, 1.0, -1.0, 1e-3, -1e-3, 1e3, -1e3}) {
        for (std::size_t i = 0; i < n; ++i) start[i] = r.values[block.starts[i]] + offset * block.nominal[i];
        if (newton.from(start)) return true;
        if (n == 1 && offset == 0 && newton.byBracket(start[0])) return true;
    }
    return false;
}

/// Tangents of a single unknown, whose equation was evaluated last at its solution: dz = -dr / (dr/dz). Where the
/// solution moves infinitely fast (w of k*w*abs(w) = tau at standstill) the slope counts as 0, as with the root at 0.
void moveOne(const NonlinearBlock& block, Registers& r, int mode) {
    const auto lanes = static_cast<std::size_t>(r.lanes);
    const double slope = r.values[block.jacobian[0]];
    const bool moves = block.activeOf[0][static_cast<std::size_t>(mode)] != 0 && slope != 0 && std::isfinite(slope);
    const double inverse = moves ? -1 / slope : 0;
    const double* const d = tangentsAt(r, block.residuals[0]);
    double* const to = tangentsAt(r, block.unknowns[0]);
    for (std::size_t k = 0; k < lanes; ++k) to[k] = moves ? inverse * d[k] : 0;
}

/// Equations that repeat each other: the smallest solution, where whoever simulates takes one.
bool solveRepeating(const LinearBlock& block, Registers& r) {
    UndecidedScope* const scope = UndecidedScope::inForce();
    if (!scope) return false;
    const auto n = block.unknowns.size();
    for (std::size_t i = 0; i < n * n; ++i) r.matrix[i] = r.values[block.matrix[i]];
    for (std::size_t i = 0; i < n; ++i) r.vector[i] = -r.values[block.constant[i]];
    const auto solution = solveRankDeficient({r.matrix.data(), n * n}, {r.vector.data(), n}, scope->shift);
    if (!solution) return false;
    for (std::size_t i = 0; i < n; ++i) {
        r.values[block.unknowns[i]] = solution->values[i];
        if (solution->isUndecided[i]) scope->names.insert(block.names[i]);
    }
    return true;
}

}  // namespace

bool solveLinear(std::size_t number, const ProgramTables& tables, Registers& r, int mode) {
    const LinearBlock& block = tables.linear[number];
    const auto n = block.unknowns.size();
    BlockMatrix matrix(block.matrix, block.entries, n, keptOf(r.linear, number, tables.linear.size(), n), r);
    matrix.load();
    if (!matrix.factorise()) {
        if (mode < 0 && solveRepeating(block, r)) return true;
        fail(r, block.names.front());
        return false;
    }
    for (std::size_t i = 0; i < n; ++i) r.vector[i] = -r.values[block.constant[i]];
    matrix.solve(r.vector.data(), 1);
    for (std::size_t i = 0; i < n; ++i) r.values[block.unknowns[i]] = r.vector[i];
    if (mode < 0 || !block.active[static_cast<std::size_t>(mode)]) return true;

    // A dz = -(db + dA z)
    const auto m = static_cast<std::size_t>(mode);
    const auto lanes = static_cast<std::size_t>(r.lanes);
    std::fill_n(r.rows.begin(), n * lanes, 0.0);
    const auto subtract = [&](std::size_t i, std::uint32_t reg, double factor) {
        double* row = r.rows.data() + i * lanes;
        const double* d = tangentsAt(r, reg);
        for (std::size_t k = 0; k < lanes; ++k) row[k] -= factor * d[k];
    };
    for (std::size_t i = 0; i < n; ++i)
        if (block.activeOf[n * n + i][m]) subtract(i, block.constant[i], 1);
    for (const std::uint32_t e : block.entries)
        if (block.activeOf[e][m]) subtract(e / n, block.matrix[e], r.vector[e % n]);
    matrix.solve(r.rows.data(), r.lanes);
    for (std::size_t i = 0; i < n; ++i) std::copy_n(r.rows.data() + i * lanes, lanes, tangentsAt(r, block.unknowns[i]));
    return true;
}

bool solveNonlinear(std::size_t number, const ProgramTables& tables, Registers& r, int mode) {
    const NonlinearBlock& block = tables.nonlinear[number];
    const auto n = block.unknowns.size();
    Body body(number, tables, r, mode);
    NewtonIteration newton(block, body, keptOf(r.nonlinear, number, tables.nonlinear.size(), n), r);
    if (!iterate(block, newton, r)) {
        fail(r, block.names.front());
        return false;
    }
    for (std::size_t i = 0; i < n; ++i) {
        r.guesses[block.guess + i] = r.values[block.unknowns[i]];
        r.hasGuess[block.guess + i] = 1;
    }
    if (mode < 0 || !block.active[static_cast<std::size_t>(mode)]) return true;
    if (n == 1) {
        body.tangents();
        moveOne(block, r, mode);
        return true;
    }

    // Implicit function theorem: J dz = -(partial derivatives of the residuals along the directions).
    const bool isRegular = newton.factoriseHere();
    body.tangents();
    const auto m = static_cast<std::size_t>(mode);
    const auto lanes = static_cast<std::size_t>(r.lanes);
    bool anyMoves = false;
    for (std::size_t i = 0; i < n; ++i) {
        double* row = r.rows.data() + i * lanes;
        const double* d = tangentsAt(r, block.residuals[i]);
        for (std::size_t k = 0; k < lanes; ++k) {
            row[k] = block.activeOf[i][m] ? -d[k] : 0;
            anyMoves = anyMoves || row[k] != 0;
        }
    }
    if (!isRegular && anyMoves) {
        fail(r, block.names.front());
        return false;
    }
    if (isRegular) newton.solve(r.rows.data(), r.lanes);
    for (std::size_t i = 0; i < n; ++i) std::copy_n(r.rows.data() + i * lanes, lanes, tangentsAt(r, block.unknowns[i]));
    return true;
}

}  // namespace analogon
