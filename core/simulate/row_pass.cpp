#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/stopwatch.hpp"
#include "core/simulate/all_finite.hpp"
#include "core/simulate/grid.hpp"
#include "core/simulate/sample_recorder.hpp"
#include "core/simulate/step_method.hpp"

namespace analogon {

namespace {

constexpr int kMostRows = 256;                // a chunk of them stays in the cache
constexpr int kMostSubsteps = 128;            // of a sample interval
constexpr std::size_t kMostTerms = 3u << 20;  // doubles that may be kept

/// Fills rows of steps (RowLayout) from the samples.
class RowTable {
public:
    RowTable(const RowLayout& layout, Dynamics& dynamics, const SampledInputs& inputs, const InputTerms* terms)
        : layout_(layout), dynamics_(dynamics), inputs_(inputs), kept_(terms), held_(inputs.heldInputs()) {
        const auto capacity = static_cast<std::size_t>(kMostRows + kMostSubsteps + 1);
        rows_.resize(capacity * static_cast<std::size_t>(layout.size()));
        slots_.resize(capacity * static_cast<std::size_t>(layout.slots));
        terms_.resize(capacity * static_cast<std::size_t>(layout.terms()));
    }

    void clear() { count_ = 0; }
    int count() const { return count_; }
    const double* row(int i) const { return rows_.data() + static_cast<std::ptrdiff_t>(i) * layout_.size(); }

    /// Intervals of one step each.
    void addSingles(int first, int count) {
        const int size = layout_.size(), slots = layout_.slots;
        const double* const times = inputs_.time.data() + first;
        const double* from = sample(first);
        double* to = rows_.data() + static_cast<std::ptrdiff_t>(count_) * size;
        for (int k = 0; k < count; ++k, to += size) {
            to[RowLayout::time] = times[k];
            to[RowLayout::step] = times[k + 1] - times[k];
            for (int i = 0; i < slots; ++i) to[RowLayout::firstSlot + i] = *from++;
        }
        count_ += count;
    }

    /// The steps of an interval.
    void add(int interval, int substeps) {
        if (substeps == 1) return addSingles(interval, 1);
        const double begin = time(interval), h = (time(interval + 1) - begin) / substeps;
        const double* const left = sample(interval);
        const double* const right = left + layout_.slots;
        for (int s = 0; s < substeps; ++s) {
            double* const to = next();
            to[RowLayout::time] = begin + s * h;
            to[RowLayout::step] = h;
            const double fraction = static_cast<double>(s) / substeps;
            for (int i = 0; i < layout_.slots; ++i) to[layout_.slot() + i] = left[i] + fraction * (right[i] - left[i]);
            for (const int i : held_) to[layout_.slot() + i] = left[i];
        }
    }

    /// What the last step ends at; then the rows are complete.
    void close(int sampleAtEnd) {
        double* const to = next();
        --count_;
        put(to, time(sampleAtEnd), 0.0, sample(sampleAtEnd));
        if (layout_.terms() == 0) return;
        if (kept_) {
            putTerms(kept_->begin.data() + used_ * static_cast<std::size_t>(layout_.terms()), layout_.terms(),
                     layout_.rateTerm(0), layout_.terms());
            putTerms(kept_->middle.data() + used_ * static_cast<std::size_t>(layout_.rateTerms), layout_.rateTerms,
                     layout_.rateTerm(1), layout_.rateTerms);
            used_ += static_cast<std::size_t>(count_);
            tabulateBegins(count_, 1);
        } else {
            tabulateBegins(0, count_ + 1);
            tabulateMiddles();
        }
    }

    /// Appends the terms of the rows at hand.
    void keep(InputTerms& to) const {
        appendTerms(to.begin, layout_.rateTerm(0), layout_.terms());
        appendTerms(to.middle, layout_.rateTerm(1), layout_.rateTerms);
    }

private:
    double time(int sample) const { return inputs_.time[static_cast<std::size_t>(sample)]; }
    const double* sample(int k) const {
        return inputs_.values.data() + static_cast<Eigen::Index>(k) * inputs_.values.rows();
    }
    double* next() { return rows_.data() + static_cast<std::ptrdiff_t>(count_++) * layout_.size(); }

    void put(double* to, double time, double step, const double* slots) const {
        to[RowLayout::time] = time;
        to[RowLayout::step] = step;
        for (int i = 0; i < layout_.slots; ++i) to[layout_.slot() + i] = slots[i];
    }

    void tabulateBegins(int first, int count) {
        double* slots = slots_.data();
        for (int j = 0; j < count; ++j)
            for (int i = 0; i < layout_.slots; ++i) *slots++ = row(first + j)[layout_.slot() + i];
        dynamics_.tabulate(slots_.data(), terms_.data(), count);
        const double* terms = terms_.data();
        double* to = rows_.data() + static_cast<std::ptrdiff_t>(first) * layout_.size() + layout_.rateTerm(0);
        for (int j = 0; j < count; ++j, to += layout_.size())
            for (int i = 0; i < layout_.terms(); ++i) to[i] = *terms++;
    }
    void tabulateMiddles() {
        for (int j = 0; j < count_; ++j)
            for (int i = 0; i < layout_.slots; ++i)
                slots_[static_cast<std::size_t>(j * layout_.slots + i)] =
                    0.5 * (row(j)[layout_.slot() + i] + row(j + 1)[layout_.slot() + i]);
        dynamics_.tabulate(slots_.data(), terms_.data(), count_);
        putTerms(terms_.data(), layout_.terms(), layout_.rateTerm(1), layout_.rateTerms);
    }
    void appendTerms(std::vector<double>& to, int place, int many) const {
        const std::size_t before = to.size();
        to.resize(before + static_cast<std::size_t>(count_ * many));
        const double* from = rows_.data() + place;
        double* at = to.data() + before;
        for (int j = 0; j < count_; ++j, from += layout_.size())
            for (int i = 0; i < many; ++i) *at++ = from[i];
    }
    void putTerms(const double* from, int stride, int place, int many) {
        const int size = layout_.size(), count = count_;
        for (int i = 0; i < many; ++i) {
            double* to = rows_.data() + place + i;
            const double* term = from + i;
            for (int j = 0; j < count; ++j, term += stride, to += size) *to = *term;
        }
    }

    const RowLayout& layout_;
    Dynamics& dynamics_;
    const SampledInputs& inputs_;
    const InputTerms* kept_{};
    std::size_t used_{};     // rows taken from what was kept
    std::vector<int> held_;  // inputs
    int count_{};
    std::vector<double> rows_, slots_, terms_;
};

/// The state walks over the samples inside the machine code, a chunk of steps a call.
class RowPass {
public:
    RowPass(Dynamics& dynamics, const SampledInputs& inputs, const GridRun& run, const SimulationOptions& options,
            const Progress& progress, const RowLayout& layout, Trajectory& result)
        : dynamics_(dynamics),
          inputs_(inputs),
          run_(run),
          options_(options),
          progress_(progress),
          layout_(layout),
          result_(result),
          table_(layout, dynamics, inputs, termsOf(run)),
          slots_(dynamics, inputs, run.gaps),
          last_(run.last < 0 ? static_cast<int>(inputs.time.size()) - 1 : run.last),
          K_(dynamics.shape().directions) {}

    bool execute() {
        allocate();
        if (!begin()) return false;
        const auto started = std::chrono::steady_clock::now();
        for (int k = run_.first; k < last_;) {
            if (dynamics_.evaluations() > options_.evaluationLimit) return stop(k, "step limit");
            if (progress_.stopRequested()) return stop(k, "cancelled");
            if (secondsSince(started) > options_.wallClockLimit) return stop(k, "time limit");
            if (options_.reached) options_.reached(run_.part(k, last_));
            const bool isImplicit = run_.plan.methodIn(k) == GridMethod::Esdirk;
            if (!(isImplicit ? implicitStretch(k) : explicitStretch(k))) return false;
        }
        if (!look(last_)) return false;
        deliver();
        if (!dynamics_.isStateFinite()) return false;
        if (run_.sink) return true;  // it sees for itself what it was given
        return std::all_of(result_.tangents.begin(), result_.tangents.end(),
                           [](const Eigen::MatrixXd& t) { return allFinite(t.data(), t.size()); }) &&
               allFinite(result_.outputs.data(), result_.outputs.size());
    }

private:
    double time(int sample) const { return inputs_.time[static_cast<std::size_t>(sample)]; }

    const InputTerms* termsOf(const GridRun& run) const {
        const InputTerms* const terms = run.plan.terms.get();
        const bool fits = terms && run.first == 0 && terms->owner == dynamics_.identity() &&
                          terms->count == layout_.terms() && terms->held == inputs_.held;
        return fits ? terms : nullptr;
    }

    void allocate() {
        const Dynamics::Shape& shape = dynamics_.shape();
        const auto n = static_cast<std::size_t>(shape.states), K = static_cast<std::size_t>(K_);
        x_.resize(n);
        dx_.resize(n * K);
        u_.resize(static_cast<std::size_t>(shape.slots));
        dy_.resize(static_cast<std::size_t>(shape.outputs) * K);
        results_.resize(static_cast<std::size_t>(kMostRows + 1) * static_cast<std::size_t>(layout_.resultSize()));
        delivered_ = run_.first;
        makeRoom(result_, dynamics_, last_ - run_.first + 1, run_.keepStates, run_.sink != nullptr);
        if (run_.sink) run_.sink->restart();
    }

    bool begin() {
        if (run_.startState) {
            std::copy_n(run_.startState, x_.size(), x_.data());
        } else {
            slots_.atSample(run_.first, u_.data());
            if (!dynamics_.initialise(time(run_.first), u_.data(), nullptr, x_.data(), K_ > 0 ? dx_.data() : nullptr)) {
                return false;
            }
        }
        dynamics_.loadState(x_.data(), dx_.data());
        return true;
    }

    double* resultOf(int sample) {
        return results_.data() + static_cast<std::ptrdiff_t>(sample - delivered_) * layout_.resultSize();
    }

    /// As many intervals with explicit steps as a chunk holds; k goes on behind them.
    bool explicitStretch(int& k) {
        deliver();
        const int first = k;
        table_.clear();
        while (k < last_ && table_.count() < kMostRows && k - first < kMostRows) {
            if (const int singles = singlesFrom(k, std::min(last_ - k, kMostRows - table_.count())); singles > 0) {
                table_.addSingles(k, singles);
                k += singles;
                continue;
            }
            if (run_.plan.methodIn(k) == GridMethod::Esdirk) break;
            table_.add(k, run_.plan.substepsIn(k));
            ++k;
        }
        table_.close(k);
        int row = 0;
        for (int j = first; j < k;) {
            if (const int singles = singlesFrom(j, k - j); singles > 0) {
                if (!dynamics_.walk(table_.row(row), resultOf(j), singles)) return false;
                row += singles;
                j += singles;
                continue;
            }
            const int substeps = run_.plan.substepsIn(j);
            if (!dynamics_.walk(table_.row(row), resultOf(j), 1)) return false;
            if (!dynamics_.stepOver(table_.row(row + 1), substeps - 1)) return false;
            row += substeps;
            ++j;
        }
        pending_ = k - delivered_;
        return true;
    }

    /// How many intervals from this one on take one explicit step each; at most `most`.
    int singlesFrom(int interval, int most) const {
        const auto isSingle = [&](int k) {
            return run_.plan.methodIn(k) != GridMethod::Esdirk && run_.plan.substepsIn(k) == 1;
        };
        if (!run_.plan.steps) return isSingle(interval) ? most : 0;
        int count = 0;
        while (count < most && isSingle(interval + count)) ++count;
        return count;
    }

    /// The state comes out of the machine code's memory and goes back.
    bool implicitStretch(int& k) {
        if (!implicit_) implicit_ = makeStepMethod(GridMethod::Esdirk, dynamics_, slots_, options_);
        deliver();
        dynamics_.storeState(x_.data(), dx_.data());
        for (const int first = k; k < last_ && k - first < kMostRows; ++k) {
            if (run_.plan.methodIn(k) != GridMethod::Esdirk) break;
            // steps that do not converge are halved many times: the limit must not wait for the end of the stretch
            if (dynamics_.evaluations() > options_.evaluationLimit || progress_.stopRequested()) return true;
            if (!look(k)) return false;
            const Substeps steps = slots_.gaps().implicitSteps(k, run_.plan.substepsIn(k));
            for (int s = 0; s < steps.count; ++s)
                if (!implicit_->step(k, steps.time(s), steps.length(s), x_.data(), K_ > 0 ? dx_.data() : nullptr))
                    return false;
            dynamics_.loadState(x_.data(), dx_.data());
        }
        return true;
    }

    /// Outputs of a single sample.
    bool look(int sample) {
        slots_.atSample(sample, u_.data());
        double* const to = resultOf(sample);
        if (!dynamics_.outputsOfState(time(sample), u_.data(), to + layout_.value(0), K_ > 0 ? dy_.data() : nullptr))
            return false;
        for (int o = 0; o < layout_.outputs && K_ > 0; ++o) {
            std::fill_n(to + layout_.tangent(o), layout_.lanes, 0.0);
            std::copy_n(dy_.data() + static_cast<std::ptrdiff_t>(o) * K_, K_, to + layout_.tangent(o));
        }
        dynamics_.storeState(to + layout_.state(0), nullptr);
        pending_ = sample + 1 - delivered_;
        return true;
    }

    void deliver() {
        if (pending_ == 0) return;
        const Eigen::Index column = delivered_ - run_.first, stride = layout_.resultSize();
        const double* const from = results_.data();
        if (run_.keepStates)
            for (int j = 0; j < pending_; ++j)
                std::copy_n(from + j * stride + layout_.state(0), layout_.states,
                            result_.states.data() + (column + j) * layout_.states);
        if (run_.sink) {
            run_.sink->takeRows(delivered_ - run_.first, pending_, from, layout_, K_);
        } else {
            for (int j = 0; j < pending_; ++j)
                std::copy_n(from + j * stride + layout_.value(0), layout_.outputs,
                            result_.outputs.data() + (column + j) * layout_.outputs);
            for (std::size_t o = 0; o < result_.tangents.size(); ++o)
                for (int k = 0; k < K_; ++k) {
                    double* to = result_.tangents[o].data() + k * result_.tangents[o].rows() + column;
                    const double* slope = from + layout_.tangent(static_cast<int>(o)) + k;
                    for (int j = 0; j < pending_; ++j, slope += stride) *to++ = *slope;
                }
        }
        delivered_ += pending_;
        pending_ = 0;
    }

    /// Ended from outside before sample k.
    bool stop(int k, const char* reason) {
        deliver();
        if (run_.marksUnreached(progress_)) result_.leaveOpen(last_ - k + 1);
        result_.failure = {true, time(k), {}, reason};
        return true;
    }

    Dynamics& dynamics_;
    const SampledInputs& inputs_;
    const GridRun& run_;
    const SimulationOptions& options_;
    const Progress& progress_;
    const RowLayout& layout_;
    Trajectory& result_;
    RowTable table_;
    InputSlots slots_;
    std::unique_ptr<StepMethod> implicit_;
    int last_{}, K_{};
    int delivered_{}, pending_{};  // samples handed on; further ones in results_
    std::vector<double> x_, dx_, u_, dy_, results_;
};

/// In one sample interval.
int mostExplicitSteps(const GridPlan& plan) {
    if (!plan.steps) return plan.substeps;
    return plan.steps->empty() ? 0 : *std::max_element(plan.steps->begin(), plan.steps->end());
}

/// Whether rows can be made of this, and how: nothing, or the step of exact ones (0: Runge-Kutta).
const RowLayout* rowsFor(Dynamics& dynamics, const SampledInputs& inputs, const GridPlan& plan) {
    const Dynamics::Shape& shape = dynamics.shape();
    constexpr std::size_t fewest = 100;  // samples: below, the interpreter is done before the code is made
    if (shape.states == 0 || shape.slots != shape.inputs || inputs.time.size() <= fewest) return nullptr;
    if (plan.method == GridMethod::Exact) {
        const std::optional<double> h = equidistantStep(inputs);
        return h ? dynamics.prepareRows(*h) : nullptr;
    }
    if (plan.method != GridMethod::RungeKutta4 && !plan.steps) return nullptr;
    if (mostExplicitSteps(plan) > kMostSubsteps) return nullptr;
    return dynamics.prepareRows(0.0);
}

}  // namespace

std::optional<double> equidistantStep(const SampledInputs& inputs) {
    const std::size_t count = inputs.time.size();
    if (count < 3) return std::nullopt;
    const double h = (inputs.time.back() - inputs.time.front()) / static_cast<double>(count - 1);
    double worst = 0.0;
    for (std::size_t k = 0; k + 1 < count; ++k)
        worst = std::max(worst, std::abs(inputs.time[k + 1] - inputs.time[k] - h));
    if (!(worst <= 1e-8 * h)) return std::nullopt;
    return h;
}

bool runRows(Dynamics& dynamics, const SampledInputs& inputs, const GridRun& run, const SimulationOptions& options,
             const Progress& progress, Trajectory& result) {
    if (dynamics.observedCount() > 0) return false;
    const RowLayout* const layout = rowsFor(dynamics, inputs, run.plan);
    return layout && RowPass(dynamics, inputs, run, options, progress, *layout, result).execute();
}

std::shared_ptr<const InputTerms> tabulateTerms(Dynamics& dynamics, const SampledInputs& inputs, const GridPlan& plan,
                                                const Progress& progress) {
    const RowLayout* const layout = rowsFor(dynamics, inputs, plan);
    if (!layout || layout->terms() == 0) return nullptr;
    const int intervals = static_cast<int>(inputs.time.size()) - 1;
    std::size_t rows = 0;
    for (int k = 0; k < intervals; ++k)
        if (plan.methodIn(k) != GridMethod::Esdirk) rows += static_cast<std::size_t>(plan.substepsIn(k));
    if (2 * rows * static_cast<std::size_t>(layout->terms()) > kMostTerms) return nullptr;
    auto terms = std::make_shared<InputTerms>();
    terms->owner = dynamics.identity();
    terms->count = layout->terms();
    terms->held = inputs.held;
    terms->begin.reserve(rows * static_cast<std::size_t>(layout->terms()));
    terms->middle.reserve(rows * static_cast<std::size_t>(layout->rateTerms));
    RowTable table(*layout, dynamics, inputs, nullptr);
    for (int k = 0; k < intervals;) {
        table.clear();
        for (; k < intervals && table.count() < kMostRows; ++k) {
            if (plan.methodIn(k) == GridMethod::Esdirk) {
                if (table.count() > 0) break;
                continue;
            }
            table.add(k, plan.substepsIn(k));
        }
        if (progress.stopRequested()) return nullptr;
        if (table.count() == 0) continue;
        table.close(k);
        table.keep(*terms);
    }
    return terms;
}

}  // namespace analogon
