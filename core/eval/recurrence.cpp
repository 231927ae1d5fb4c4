#include "core/eval/recurrence.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {
namespace {

/// A square matrix with K tangents: [value; tangent 1; …], each row-major.
class TangentMatrix {
public:
    TangentMatrix(int size, int directions)
        : size_(static_cast<std::size_t>(size)),
          count_(static_cast<std::size_t>(1 + directions)),
          entries_(size_ * size_ * count_) {}

    double& at(std::size_t i, std::size_t j, std::size_t k = 0) { return entries_[(k * size_ + i) * size_ + j]; }
    double at(std::size_t i, std::size_t j, std::size_t k = 0) const { return entries_[(k * size_ + i) * size_ + j]; }

    void scale(double factor) {
        for (double& entry : entries_) entry *= factor;
    }
    /// In variables that are 2^e times as small.
    void scaleVariables(const std::vector<int>& exponents) {
        for (std::size_t k = 0; k < count_; ++k)
            for (std::size_t i = 0; i < size_; ++i)
                for (std::size_t j = 0; j < size_; ++j)
                    at(i, j, k) = std::ldexp(at(i, j, k), exponents[j] - exponents[i]);
    }
    void addIdentity() {
        for (std::size_t i = 0; i < size_; ++i) at(i, i) += 1;
    }
    friend TangentMatrix operator*(const TangentMatrix& a, const TangentMatrix& b) {
        TangentMatrix product(static_cast<int>(a.size_), static_cast<int>(a.count_) - 1);
        product.add(a, 0, b, 0, 0);
        for (std::size_t k = 1; k < a.count_; ++k) {
            product.add(a, k, b, 0, k);
            product.add(a, 0, b, k, k);
        }
        return product;
    }
    double norm() const {
        double largest = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            double sum = 0;
            for (std::size_t j = 0; j < size_; ++j) sum += std::fabs(at(i, j));
            largest = std::max(largest, sum);
        }
        return largest;
    }

private:
    /// Adds the product of two layers to a third.
    void add(const TangentMatrix& a, std::size_t layerA, const TangentMatrix& b, std::size_t layerB,
             std::size_t layer) {
        for (std::size_t i = 0; i < size_; ++i)
            for (std::size_t j = 0; j < size_; ++j) {
                const double factor = a.at(i, j, layerA);
                if (factor == 0) continue;
                const double* from = &b.entries_[(layerB * size_ + j) * size_];
                double* to = &entries_[(layer * size_ + i) * size_];
                for (std::size_t l = 0; l < size_; ++l) to[l] += factor * from[l];
            }
    }

    std::size_t size_, count_;
    std::vector<double> entries_;
};

int squaringsFor(double norm) {
    return std::isfinite(norm) && norm > 0.5 ? static_cast<int>(std::ceil(std::log2(norm / 0.5))) : 0;
}

/// Exponents e of the scales 2^e of the variables in which rows and columns of a matrix are alike in size (Osborne,
/// J. ACM 7 (1960) 338-345; Parlett & Reinsch, Numer. Math. 13 (1969) 293-304). What nothing acts on, or what acts on
/// nothing, is made no larger than 1.
std::vector<int> balanceOf(const TangentMatrix& matrix, std::size_t size) {
    constexpr int mostSweeps = 20;
    std::vector<int> exponents(size);
    bool changed = true;
    for (int sweep = 0; sweep < mostSweeps && changed; ++sweep) {
        changed = false;
        for (std::size_t i = 0; i < size; ++i) {
            double column = 0, row = 0;
            for (std::size_t j = 0; j < size; ++j) {
                if (j == i) continue;
                column += std::ldexp(std::fabs(matrix.at(j, i)), exponents[i] - exponents[j]);
                row += std::ldexp(std::fabs(matrix.at(i, j)), exponents[j] - exponents[i]);
            }
            double exponent = 0;
            if (column > 0 && row > 0)
                exponent = 0.5 * (std::log2(row) - std::log2(column));
            else if (column > 1)
                exponent = -std::log2(column);
            else if (row > 1)
                exponent = std::log2(row);
            if (!(std::fabs(exponent) >= 1)) continue;
            exponents[i] += static_cast<int>(std::lround(exponent));
            changed = true;
        }
    }
    return exponents;
}

/// exp(M) by scaling and squaring. Where that takes many squarings for what the units of the variables do alone (a
/// factor of 1e10 beside one of 1), each of which costs a digit of what is small, it is taken of the balanced matrix.
TangentMatrix exponential(TangentMatrix matrix, std::size_t size, std::size_t directions) {
    constexpr int many = 8;
    int squarings = squaringsFor(matrix.norm());
    std::vector<int> exponents;
    if (squarings > many) {
        exponents = balanceOf(matrix, size);
        TangentMatrix balanced = matrix;
        balanced.scaleVariables(exponents);
        const int fewer = squaringsFor(balanced.norm());
        if (fewer + many < squarings) {
            matrix = std::move(balanced);
            squarings = fewer;
        } else {
            exponents.clear();
        }
    }
    matrix.scale(std::ldexp(1.0, -squarings));
    TangentMatrix sum(static_cast<int>(size), static_cast<int>(directions));
    sum.addIdentity();
    constexpr int terms = 14;  // 0.5^15 / 15! is below rounding
    for (int k = terms; k >= 1; --k) {
        sum = matrix * sum;
        sum.scale(1.0 / k);
        sum.addIdentity();
    }
    for (int s = 0; s < squarings; ++s) sum = sum * sum;
    for (int& exponent : exponents) exponent = -exponent;
    if (!exponents.empty()) sum.scaleVariables(exponents);
    return sum;
}

}  // namespace

LinearRecurrence recurrenceOf(const LinearRates& rates, double h) {
    // Over the time of a step as unit: x' = h (A x + B u + c), u' = u1 - u0, both slopes and 1 constant.
    const auto n = static_cast<std::size_t>(rates.states), m = static_cast<std::size_t>(rates.slots);
    const auto K = static_cast<std::size_t>(rates.directions), columns = n + m + 1;
    const std::size_t size = n + 2 * m + 1;
    TangentMatrix matrix(static_cast<int>(size), rates.directions);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < columns; ++j) {
            const std::size_t to = j < n + m ? j : size - 1, entry = i * columns + j;
            matrix.at(i, to) = h * rates.matrix[entry];
            for (std::size_t k = 0; k < K; ++k) matrix.at(i, to, k + 1) = h * rates.tangents[entry * K + k];
        }
    for (std::size_t j = 0; j < m; ++j) matrix.at(n + j, n + m + j) = 1;
    const TangentMatrix result = exponential(std::move(matrix), size, K);

    LinearRecurrence recurrence;
    recurrence.matrix.resize(n * size);
    recurrence.tangents.resize(n * size * K);
    for (std::size_t k = 0; k <= K; ++k)
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < size; ++j) {
                // What multiplies u0 is the hold less the ramp, what multiplies u1 is the ramp.
                double entry = result.at(i, j, k);
                if (j >= n && j < n + m) entry -= result.at(i, j + m, k);
                if (k == 0) {
                    recurrence.matrix[i * size + j] = entry;
                } else {
                    recurrence.tangents[(i * size + j) * K + k - 1] = entry;
                }
            }
    return recurrence;
}

void holdInputs(LinearRecurrence& recurrence, std::size_t n, std::size_t m, const std::vector<char>& held) {
    const std::size_t size = n + 2 * m + 1, K = recurrence.tangents.size() / (n * size);
    for (std::size_t j = 0; j < std::min(m, held.size()); ++j) {
        if (held[j] == 0) continue;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t begin = i * size + n + j, end = begin + m;
            recurrence.matrix[begin] += recurrence.matrix[end];
            recurrence.matrix[end] = 0;
            for (std::size_t k = 0; k < K; ++k) {
                recurrence.tangents[begin * K + k] += recurrence.tangents[end * K + k];
                recurrence.tangents[end * K + k] = 0;
            }
        }
    }
}

void emitRecurrence(const SystemPrograms& s, ProgramEmitter& emitter, const std::vector<VectorCode::Entity>& begin,
                    const std::vector<VectorCode::Entity>& end, std::vector<std::uint32_t>& entries,
                    std::vector<std::uint32_t>& slopes) {
    using Op = VectorCode::Operation;
    VectorCode& out = emitter.code();
    const std::size_t n = s.states.size(), m = static_cast<std::size_t>(s.layout.slots), size = n + 2 * m + 1;
    const std::size_t chunks = emitter.chunks().size();

    std::vector<VectorCode::Entity> factors;  // what each column multiplies
    for (std::size_t j = 0; j < n; ++j) factors.push_back(emitter.value(s.firstState + static_cast<std::uint32_t>(j)));
    factors.insert(factors.end(), begin.begin(), begin.end());
    factors.insert(factors.end(), end.begin(), end.end());
    factors.push_back(emitter.constant(1));

    std::vector<VectorCode::Entity> values(n), tangents(n * chunks);
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<VectorCode::Entity> sums(chunks);
        for (std::size_t c = 0; c < chunks; ++c) sums[c] = emitter.zero(c);
        VectorCode::Entity value{};
        for (std::size_t j = 0; j < size; ++j) {
            const VectorCode::Entity entry = emitter.inMemory(1);
            entries.push_back(emitter.offsetOf(entry));
            value = j == 0 ? out.emit(Op::Multiply, 1, factors[j], entry)
                           : out.emit(Op::MultiplyAdd, 1, factors[j], entry, value);
            for (std::size_t c = 0; c < chunks; ++c) {
                const int width = emitter.chunks()[c].width;
                const VectorCode::Entity slope = emitter.inMemory(width);
                for (int lane = 0; lane < width; ++lane)
                    slopes.push_back(emitter.offsetOf(slope) + static_cast<std::uint32_t>(lane));
                sums[c] = out.emit(Op::MultiplyAdd, width, factors[j], slope, sums[c]);
                if (j >= n) continue;
                const VectorCode::Entity dx = emitter.tangent(s.firstState + static_cast<std::uint32_t>(j), c);
                sums[c] = out.emit(Op::MultiplyAdd, width, entry, dx, sums[c]);
            }
        }
        values[i] = value;
        for (std::size_t c = 0; c < chunks; ++c) tangents[i * chunks + c] = sums[c];
    }
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint32_t reg = s.firstState + static_cast<std::uint32_t>(i);
        emitter.bind(reg, values[i]);
        for (std::size_t c = 0; c < chunks; ++c) emitter.bindTangent(reg, c, tangents[i * chunks + c]);
        emitter.storeResult({reg, {1, 1}});
    }
}

std::shared_ptr<const RecurrenceCode> compileRecurrence(const SystemPrograms& s, int lanes, VectorTarget target) {
    auto code = std::make_shared<RecurrenceCode>();
    ProgramEmitter emitter(s, lanes, target, code->program);
    std::vector<VectorCode::Entity> slots[2];
    for (int p = 0; p < 2; ++p)
        for (int i = 0; i < s.layout.slots; ++i) {
            slots[p].push_back(emitter.inMemory(1));
            if (i == 0) (p == 0 ? code->begin : code->end) = emitter.offsetOf(slots[p].back());
        }
    emitRecurrence(s, emitter, slots[0], slots[1], code->entries, code->tangents);
    if (!emitter.finish()) return nullptr;
    return code;
}

}  // namespace analogon
