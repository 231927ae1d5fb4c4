#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <tuple>

#include "core/simulate/gap_steps.hpp"
#include "core/simulate/input_slots.hpp"
#include "core/simulate/plan_ladder.hpp"
#include "core/simulate/state_jacobian.hpp"
#include "core/simulate/step_schedule.hpp"

namespace analogon {

namespace {

constexpr int kLongestWindow = 700;  // samples looked at in detail at the start and where the record is liveliest
constexpr int kGlanced = 100;        // samples looked at, of four times as many
constexpr long kMostEvaluations = 400'000'000;  // of the model, in planning

struct Window {
    int first{}, last{};
    std::vector<double> state;  // at `first`; empty: the model's start
};

class Planner {
public:
    Planner(Dynamics& dynamics, const SampledInputs& inputs, const SimulationOptions& options, const Progress& progress)
        : dynamics_(dynamics),
          inputs_(inputs),
          options_(options),
          progress_(progress),
          tolerance_(plannedError * options.relativeTolerance),
          sampleCount_(static_cast<int>(inputs.time.size())),
          ladder_(options_, tolerance_) {
        limited_ = options;
        limited_.evaluationLimit = std::min(options.evaluationLimit, kMostEvaluations);
    }

    GridPlan choose(const GridPlan* inForce) {
        if (sampleCount_ < 2 || dynamics_.shape().states == 0) {
            return {options_.method == GridMethod::Esdirk ? GridMethod::Esdirk : GridMethod::RungeKutta4,
                    std::max(1, options_.substeps), 0.0};
        }
        const bool mayBeExact = options_.method == GridMethod::Auto || options_.method == GridMethod::Exact;
        if (mayBeExact && options_.byRecurrence && options_.substeps == 0 && canBeExact(dynamics_, inputs_))
            return {GridMethod::Exact, 1, 0.0};
        if (options_.method == GridMethod::Exact) options_.method = GridMethod::Auto;
        if (isFree() && dynamics_.shape().delays.empty()) gaps_.emplace(inputs_, recordGaps_);
        takeTerms(inForce);
        // a survey tells of single steps at less cost, where the model is smooth
        const bool isSingle = inForce && *inForce == oneStep();
        if (!isSingle)
            if (const std::optional<GridPlan> plan = stillHolding(inForce)) return *plan;
        if (!surveyWholeRecord() || progress_.stopRequested()) return ladder_.fallback();
        if (const std::optional<GridPlan> plan = singleSteps()) return *plan;
        if (isSingle)
            if (const std::optional<GridPlan> plan = stillHolding(inForce)) return *plan;
        if (isFree()) {
            const std::optional<GridPlan> plan =
                scheduleSteps(dynamics_, inputs_, recordGaps_, surveyRun_, tolerance_, limited_, progress_, &taken_);
            if (plan) return *plan;
        }
        if (progress_.stopRequested()) return ladder_.fallback();
        takeSurvey(surveyRun_);
        for (int round = 0; round < 4 && !progress_.stopRequested(); ++round) {
            const GridPlan plan = ladder_.cheapest([this](const auto& a, const auto& b) { return difference(a, b); });
            if (plan.method == survey_.method && plan.substeps == survey_.substeps) return acrossGaps(plan);
            // A plan chosen on parts must hold on the whole.
            const GridPlan before = survey_;
            const Trajectory whole = run(plan, wholeRecord(), true);
            if (!whole.failure.failed) {
                survey_ = plan;
                if (!surveyedTooWide(whole)) return acrossGaps(plan);
                takeSurvey(whole);
                continue;
            }
            survey_ = before;
            addWindowAround(whole.failure.time);
            ladder_.passOver(plan);
        }
        return ladder_.fallback();
    }

    /// The run over the record with the steps that were chosen, or finer ones, where there was one.
    std::optional<Trajectory>& taken() { return taken_; }

private:
    Window wholeRecord() const { return {0, sampleCount_ - 1, {}}; }

    bool isFree() const { return options_.method == GridMethod::Auto && options_.substeps == 0; }
    bool hasGaps() const { return gaps_ && !gaps_->isEmpty(); }
    bool isGap(int interval) const { return gaps_ && gaps_->has(interval); }
    std::span<const int> gapIntervals() const { return gaps_ ? std::span(gaps_->intervals()) : std::span<const int>(); }
    GridPlan acrossGaps(const GridPlan& plan) const { return gaps_ ? gaps_->across(plan) : plan; }

    static GridPlan oneStep() { return {GridMethod::RungeKutta4, 1, 0.0}; }

    /// What depends on the inputs alone, for the plan that is looked at most.
    void takeTerms(const GridPlan* inForce) {
        if (hasGaps()) return;
        const bool isKnown = inForce && inForce->terms && *inForce == oneStep() &&
                             inForce->terms->owner == dynamics_.identity() && inForce->terms->held == inputs_.held;
        terms_ = isKnown ? inForce->terms : tabulateTerms(dynamics_, inputs_, oneStep(), progress_);
    }

    /// Steps that served near here before, where halving them tells that they still do (with half as many, where far
    /// less is asked for now): to choose them anew takes three times as long.
    std::optional<GridPlan> stillHolding(const GridPlan* known) {
        if (!isFree() || !known || known->method == GridMethod::Exact) return std::nullopt;
        if (known->steps && static_cast<int>(known->steps->size()) + 1 != sampleCount_) return std::nullopt;
        GridPlan same = acrossGaps(*known);
        same.terms.reset();
        const auto scaled = [&](const auto& change) {
            if (!same.steps) return GridPlan{same.method, change(same.substeps), 0.0};
            std::vector<std::int16_t> steps;
            for (const std::int16_t own : *same.steps)
                steps.push_back(static_cast<std::int16_t>(own < 0 ? -change(-own) : change(own)));
            for (const int gap : gapIntervals())
                steps[static_cast<std::size_t>(gap)] = (*same.steps)[static_cast<std::size_t>(gap)];
            return planOf(std::move(steps));
        };
        const bool isWhole = !options_.isGlance || sampleCount_ < 2 * kGlanced || !dynamics_.shape().delays.empty();
        Trajectory taken = run(same, wholeRecord(), !isWhole || hasGaps());
        if (taken.failure.failed) return std::nullopt;
        const std::vector<Window> windows =
            betweenGaps(isWhole ? std::vector<Window>{wholeRecord()} : glancesOf(taken), taken);
        const GridPlan doubled = scaled([](int n) { return 2 * n; });
        std::vector<Trajectory> fine;
        for (const Window& w : windows) {
            fine.push_back(run(doubled, w, false));
            if (fine.back().failure.failed) return std::nullopt;
        }
        const Eigen::VectorXd ranges = rangesOf(isWhole && !hasGaps() ? fine.front() : taken);
        const auto error = [&](const Eigen::MatrixXd& coarse, std::size_t window) {
            const double largest =
                ((coarse - fine[window].outputs).array().abs().colwise() / ranges.array()).maxCoeff();
            return std::isfinite(largest) ? largest : std::numeric_limits<double>::infinity();
        };
        for (std::size_t w = 0; w < windows.size(); ++w) {
            const Window& window = windows[w];
            const Eigen::MatrixXd own = taken.outputs.middleCols(window.first, window.last - window.first + 1);
            same.errorEstimate = std::max(w == 0 ? 0.0 : same.errorEstimate, error(own, w));
        }
        if (!(same.errorEstimate <= tolerance_)) return std::nullopt;
        taken_ = std::move(taken);
        GridPlan coarser = scaled([](int n) { return (n + 1) / 2; });
        if (!(same.errorEstimate < farBelow_ * tolerance_) || coarser == same) return same;
        for (std::size_t w = 0; w < windows.size(); ++w) {
            const Trajectory coarse = run(coarser, windows[w], false);
            const double now =
                coarse.failure.failed ? std::numeric_limits<double>::infinity() : error(coarse.outputs, w);
            coarser.errorEstimate = std::max(coarser.errorEstimate, now);
        }
        return coarser.errorEstimate <= 0.5 * tolerance_ ? coarser : same;
    }

    /// A quarter of the record, from its states in a run over all of it.
    std::vector<Window> glancesOf(const Trajectory& whole) const {
        std::vector<Window> windows;
        for (int first = 0; first + 1 < sampleCount_; first += 4 * kGlanced)
            windows.push_back(windowFrom(whole, first, kGlanced));
        return windows;
    }

    /// The parts of windows that lie between gaps, each from its states in a run over all of the record.
    std::vector<Window> betweenGaps(const std::vector<Window>& windows, const Trajectory& whole) const {
        if (!hasGaps()) return windows;
        std::vector<Window> parts;
        for (const Window& window : windows) {
            Window part = window;
            for (const int gap : gapIntervals()) {
                if (gap < part.first || gap >= window.last) continue;
                if (gap > part.first) parts.push_back({part.first, gap, part.state});
                part = windowFrom(whole, gap + 1, window.last - gap);
            }
            if (part.last > part.first) parts.push_back(std::move(part));
        }
        return parts;
    }

    static constexpr double farBelow_ = 0.1;  // of the tolerance

    /// One explicit step an interval, where that is far more exact than asked for, in a model without kinks: what is
    /// seen at the start, where the record is liveliest, and at the eigenvalues here and there then speaks for all of
    /// it. Nothing: it takes a closer look.
    std::optional<GridPlan> singleSteps() {
        if (!isFree() || !(survey_ == oneStep()) || sampleCount_ < 2 * kLongestWindow || !dynamics_.isSmooth() ||
            !dynamics_.shape().delays.empty() || !isFarFromStiff()) {
            return std::nullopt;
        }
        takeSurvey(surveyRun_);
        constexpr double margin = 1e-3;
        const std::optional<double> moved = difference(survey_, {GridMethod::RungeKutta4, 2, 0.0});
        if (!moved || *moved > margin * tolerance_) return std::nullopt;
        GridPlan plan = oneStep();
        plan.errorEstimate = *moved;
        plan.terms = terms_;
        return acrossGaps(plan);
    }

    bool isFarFromStiff() {
        constexpr int places = 50;
        constexpr double reach = 0.5;  // of the 2.8 at which the method fails
        const auto n = static_cast<std::size_t>(dynamics_.shape().states);
        std::vector<double> xdot(n), u(static_cast<std::size_t>(dynamics_.shape().slots));
        StateJacobian jacobian(dynamics_);
        InputSlots slots(dynamics_, inputs_);
        for (int i = 0; i < places; ++i) {
            const int k = static_cast<int>(static_cast<long>(i) * (sampleCount_ - 2) / (places - 1));
            if (isGap(k)) continue;
            const double t = inputs_.time[static_cast<std::size_t>(k)];
            slots.atSample(k, u.data());
            if (!jacobian.evaluate(t, surveyRun_.states.col(k).data(), u.data(), xdot.data())) return false;
            const double h = inputs_.time[static_cast<std::size_t>(k) + 1] - t;
            const double enough = (1.0 - 1e-9) * reach / h;
            if (!(jacobian.radius(enough) * h <= reach)) return false;
        }
        return true;
    }

    Trajectory run(const GridPlan& plan, const Window& window, bool keepStates) {
        GridRun grid;
        grid.plan = acrossGaps(plan);
        if (plan == oneStep()) grid.plan.terms = terms_;
        grid.first = window.first;
        grid.last = window.last;
        grid.startState = window.state.empty() ? nullptr : window.state.data();
        grid.keepStates = keepStates;
        grid.isTrial = true;
        grid.gaps = &recordGaps_;
        return runGrid(dynamics_, inputs_, grid, limited_, progress_);
    }

    /// A plan that gets through the record at all: range of each output and where it is liveliest. Single steps
    /// first; an explicit method at its limit of stability would show ranges that are not there.
    bool surveyWholeRecord() {
        std::vector<GridPlan> plans = ladder_.plans();
        std::stable_partition(plans.begin(), plans.end(), [](const GridPlan& plan) { return plan.substeps == 1; });
        for (const GridPlan& plan : plans) {
            if (progress_.stopRequested()) return false;
            Trajectory whole = run(plan, wholeRecord(), true);
            const auto failsInGap = [&] {
                return hasGaps() && whole.failure.failed && gaps_->holds(whole.failure.time);
            };
            while (failsInGap() && gaps_->refineAt(whole.failure.time) && !progress_.stopRequested())
                whole = run(plan, wholeRecord(), true);
            if (failsInGap() && plan.method == GridMethod::Esdirk)
                return false;  // shorter steps elsewhere do not lead through it
            if (whole.failure.failed || !isPlausible(whole)) {
                if (gaps_) gaps_->reset();
                continue;
            }
            survey_ = plan;
            surveyRun_ = std::move(whole);
            if (gaps_) gaps_->resolve(dynamics_, limited_, surveyRun_.states, tolerance_, progress_);
            return true;
        }
        return false;
    }

    static bool isPlausible(const Trajectory& trajectory) { return trajectory.states.array().abs().maxCoeff() < 1e100; }

    Eigen::VectorXd rangesOf(const Trajectory& trajectory) const {
        const Eigen::MatrixXd& y = trajectory.outputs;
        Eigen::VectorXd ranges(y.rows());
        for (Eigen::Index i = 0; i < y.rows(); ++i) {
            const double low = y.row(i).minCoeff(), high = y.row(i).maxCoeff();
            const double nominal = dynamics_.shape().outputNominal[static_cast<std::size_t>(i)];
            ranges[i] = std::max(
                {high - low, 1e-6 * std::max(std::abs(low), std::abs(high)), options_.absoluteTolerance * nominal});
        }
        return ranges;
    }

    void takeSurvey(const Trajectory& whole) {
        ranges_ = rangesOf(whole);
        windows_.clear();
        runs_.clear();
        if (sampleCount_ <= 2 * kLongestWindow) {
            windows_ = betweenGaps({wholeRecord()}, whole);
            return;
        }
        windows_.push_back({0, kLongestWindow - 1, {}});
        // Liveliest: where the outputs travel farthest.
        std::vector<double> travel(static_cast<std::size_t>(sampleCount_), 0.0);  // to each sample
        const Eigen::Index outputs = whole.outputs.rows();
        for (Eigen::Index o = 0; o < outputs; ++o) {
            const double perRange = 1.0 / ranges_[o];
            const double* y = whole.outputs.data() + o;
            for (std::size_t k = 1; k < travel.size(); ++k, y += outputs)
                travel[k] += std::abs(y[outputs] - y[0]) * perRange;
        }
        double sum = 0.0, most = -1.0;
        int first = kLongestWindow;
        for (int k = 1; k < sampleCount_; ++k) {
            sum += travel[static_cast<std::size_t>(k)];
            if (k >= kLongestWindow) sum -= travel[static_cast<std::size_t>(k - kLongestWindow + 1)];
            if (k >= 2 * kLongestWindow && sum > most) {
                most = sum;
                first = k - kLongestWindow + 1;
            }
        }
        windows_.push_back(windowFrom(whole, first));
        windows_ = betweenGaps(windows_, whole);
        statesOfSurvey_ = whole.states;
    }

    Window windowFrom(const Trajectory& whole, int first, int length = kLongestWindow) const {
        const auto state = whole.states.col(first);
        return {first, std::min(first + length, sampleCount_) - 1, {state.data(), state.data() + state.size()}};
    }

    void addWindowAround(double time) {
        if (sampleCount_ <= 2 * kLongestWindow || statesOfSurvey_.cols() != sampleCount_) return;
        const auto at = std::lower_bound(inputs_.time.begin(), inputs_.time.end(), time);
        const int sample = static_cast<int>(at - inputs_.time.begin());
        Trajectory whole;
        whole.states = statesOfSurvey_;
        const Window around = windowFrom(whole, std::clamp(sample - kLongestWindow / 2, 0, sampleCount_ - 2));
        for (Window& part : betweenGaps({around}, whole)) windows_.push_back(std::move(part));
    }

    /// An unstable run that stayed finite makes the ranges, and with them the tolerance, too wide.
    bool surveyedTooWide(const Trajectory& whole) const {
        return (ranges_.array() > 2.0 * rangesOf(whole).array()).any();
    }

    /// Largest difference of the outputs over all windows, relative to the range; nothing: a run failed.
    std::optional<double> difference(const GridPlan& coarse, const GridPlan& fine) {
        double worst = 0.0;
        for (std::size_t w = 0; w < windows_.size(); ++w) {
            const Trajectory& a = windowRun(coarse, w);
            if (a.failure.failed) return std::nullopt;
            const Trajectory& b = windowRun(fine, w);
            if (b.failure.failed) return std::nullopt;
            const Eigen::ArrayXXd gap = (a.outputs - b.outputs).array().abs().colwise() / ranges_.array();
            const double largest = gap.size() ? gap.maxCoeff() : 0.0;
            if (!(largest < 1e100)) return std::nullopt;
            worst = std::max(worst, largest);
        }
        return worst;
    }

    const Trajectory& windowRun(const GridPlan& plan, std::size_t window) {
        const auto key = std::make_tuple(plan.method == GridMethod::Esdirk, plan.substeps, windows_[window].first);
        const auto found = runs_.find(key);
        if (found != runs_.end()) return found->second;
        return runs_.emplace(key, run(plan, windows_[window], false)).first->second;
    }

    Dynamics& dynamics_;
    const SampledInputs& inputs_;
    SimulationOptions options_, limited_;
    const Progress& progress_;
    double tolerance_{};
    int sampleCount_{};
    PlanLadder ladder_;
    const Gaps recordGaps_{inputs_};           // where the recording was interrupted
    std::optional<GapSteps> gaps_;             // there, where the steps are free
    std::shared_ptr<const InputTerms> terms_;  // of single steps
    std::optional<Trajectory> taken_;
    GridPlan survey_;
    Trajectory surveyRun_;
    Eigen::VectorXd ranges_;
    Eigen::MatrixXd statesOfSurvey_;
    std::vector<Window> windows_;
    std::map<std::tuple<bool, int, int>, Trajectory> runs_;
};

}  // namespace

GridPlan choosePlan(Dynamics& dynamics, const SampledInputs& inputs, const SimulationOptions& options,
                    const Progress& progress, const GridPlan* inForce, std::optional<Trajectory>* taken) {
    Planner planner(dynamics, inputs, options, progress);
    GridPlan plan = planner.choose(inForce);
    if (taken) *taken = std::move(planner.taken());
    return plan;
}

}  // namespace analogon
