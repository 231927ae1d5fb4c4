#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "core/simulate/input_slots.hpp"
#include "core/simulate/step_schedule.hpp"

namespace analogon {

namespace {

constexpr int kLongestWindow = 700;  // samples looked at in detail at the start and where the record is liveliest
constexpr int kGlanced = 100;        // samples looked at, of four times as many
constexpr int kMostExplicit = 32;    // substeps beyond which an explicit method is not worth it
constexpr int kMostImplicit = 64;
constexpr long kMostEvaluations = 400'000'000;  // of the model, in planning

struct Window {
    int first{}, last{};
    std::vector<double> state;  // at `first`; empty: the model's start
};

/// Evaluations of the model a substep costs, in units of one with tangents.
double costOf(const GridPlan& plan) { return (plan.method == GridMethod::Esdirk ? 12.0 : 4.0) * plan.substeps; }

class Planner {
public:
    Planner(Dynamics& dynamics, const SampledInputs& inputs, const SimulationOptions& options, const Progress& progress)
        : dynamics_(dynamics),
          inputs_(inputs),
          options_(options),
          progress_(progress),
          tolerance_(10.0 * options.relativeTolerance),
          sampleCount_(static_cast<int>(inputs.time.size())) {
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
        takeTerms(inForce);
        // a survey tells of single steps at less cost, where the model is smooth
        const bool isSingle = inForce && *inForce == oneStep();
        if (!isSingle)
            if (const std::optional<GridPlan> plan = stillHolding(inForce)) return *plan;
        if (!surveyWholeRecord() || progress_.stopRequested()) return fallback();
        if (const std::optional<GridPlan> plan = singleSteps()) return *plan;
        if (isSingle)
            if (const std::optional<GridPlan> plan = stillHolding(inForce)) return *plan;
        if (options_.method == GridMethod::Auto && options_.substeps == 0) {
            const std::optional<GridPlan> plan =
                scheduleSteps(dynamics_, inputs_, surveyRun_, tolerance_, limited_, progress_, &taken_);
            if (plan) return *plan;
        }
        if (progress_.stopRequested()) return fallback();
        takeSurvey(surveyRun_);
        for (int round = 0; round < 4 && !progress_.stopRequested(); ++round) {
            const GridPlan plan = cheapestOnWindows();
            if (plan.method == survey_.method && plan.substeps == survey_.substeps) return plan;
            // A plan chosen on parts must hold on the whole.
            const GridPlan before = survey_;
            const Trajectory whole = run(plan, wholeRecord(), true);
            if (!whole.failure.failed) {
                survey_ = plan;
                if (!surveyedTooWide(whole)) return plan;
                takeSurvey(whole);
                continue;
            }
            survey_ = before;
            addWindowAround(whole.failure.time);
            least_ = costOf(plan) * 1.01;
        }
        return fallback();
    }

    /// The run over the record with the steps that were chosen, or finer ones, where there was one.
    std::optional<Trajectory>& taken() { return taken_; }

private:
    Window wholeRecord() const { return {0, sampleCount_ - 1, {}}; }

    static GridPlan oneStep() { return {GridMethod::RungeKutta4, 1, 0.0}; }

    /// What depends on the inputs alone, for the plan that is looked at most.
    void takeTerms(const GridPlan* inForce) {
        const bool isKnown = inForce && inForce->terms && *inForce == oneStep() &&
                             inForce->terms->owner == dynamics_.identity() && inForce->terms->held == inputs_.held;
        terms_ = isKnown ? inForce->terms : tabulateTerms(dynamics_, inputs_, oneStep(), progress_);
    }

    /// Steps that served near here before, where halving them tells that they still do (with half as many, where far
    /// less is asked for now): to choose them anew takes three times as long.
    std::optional<GridPlan> stillHolding(const GridPlan* known) {
        const bool isFree = options_.method == GridMethod::Auto && options_.substeps == 0;
        if (!isFree || !known || known->method == GridMethod::Exact) return std::nullopt;
        if (known->steps && static_cast<int>(known->steps->size()) + 1 != sampleCount_) return std::nullopt;
        const auto scaled = [&](const auto& change) {
            if (!known->steps) return GridPlan{known->method, change(known->substeps), 0.0};
            std::vector<std::int16_t> steps;
            for (const std::int16_t own : *known->steps)
                steps.push_back(static_cast<std::int16_t>(own < 0 ? -change(-own) : change(own)));
            return planOf(std::move(steps));
        };
        GridPlan same = *known;
        same.terms.reset();
        const bool isWhole = !options_.isGlance || sampleCount_ < 2 * kGlanced || !dynamics_.shape().delays.empty();
        Trajectory taken = run(same, wholeRecord(), !isWhole);
        if (taken.failure.failed) return std::nullopt;
        const std::vector<Window> windows = isWhole ? std::vector<Window>{wholeRecord()} : glancesOf(taken);
        std::vector<Trajectory> fine;
        for (const Window& w : windows) {
            fine.push_back(run(scaled([](int n) { return 2 * n; }), w, false));
            if (fine.back().failure.failed) return std::nullopt;
        }
        const Eigen::VectorXd ranges = rangesOf(isWhole ? fine.front() : taken);
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

    static constexpr double farBelow_ = 0.1;  // of the tolerance

    /// One explicit step an interval, where that is far more exact than asked for, in a model without kinks: what is
    /// seen at the start, where the record is liveliest, and at the eigenvalues here and there then speaks for all of
    /// it. Nothing: it takes a closer look.
    std::optional<GridPlan> singleSteps() {
        const bool isFree = options_.method == GridMethod::Auto && options_.substeps == 0;
        if (!isFree || !(survey_ == oneStep()) || sampleCount_ < 2 * kLongestWindow || !dynamics_.isSmooth() ||
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
        return plan;
    }

    bool isFarFromStiff() {
        constexpr int places = 50;
        constexpr double reach = 0.5;  // of the 2.8 at which the method fails
        const auto n = static_cast<std::size_t>(dynamics_.shape().states);
        std::vector<double> xdot(n), jacobian(n * n), scratch(n * n),
            u(static_cast<std::size_t>(dynamics_.shape().slots));
        InputSlots slots(dynamics_, inputs_);
        for (int i = 0; i < places; ++i) {
            const int k = static_cast<int>(static_cast<long>(i) * (sampleCount_ - 2) / (places - 1));
            const double t = inputs_.time[static_cast<std::size_t>(k)];
            slots.atSample(k, u.data());
            if (!dynamics_.jacobian(t, surveyRun_.states.col(k).data(), u.data(), xdot.data(), jacobian.data()))
                return false;
            const double h = inputs_.time[static_cast<std::size_t>(k) + 1] - t;
            const double enough = (1.0 - 1e-9) * reach / h;
            if (!(spectralRadius(jacobian.data(), scratch.data(), static_cast<int>(n), enough) * h <= reach))
                return false;
        }
        return true;
    }

    Trajectory run(const GridPlan& plan, const Window& window, bool keepStates) {
        GridRun grid;
        grid.plan = plan;
        if (plan == oneStep()) grid.plan.terms = terms_;
        grid.first = window.first;
        grid.last = window.last;
        grid.startState = window.state.empty() ? nullptr : window.state.data();
        grid.keepStates = keepStates;
        grid.isTrial = true;
        return runGrid(dynamics_, inputs_, grid, limited_, progress_);
    }

    std::vector<GridPlan> ladder() const {
        std::vector<GridPlan> plans;
        const auto add = [&](GridMethod method, int most) {
            if (options_.method != GridMethod::Auto && options_.method != method) return;
            if (options_.substeps > 0) {
                plans.push_back({method, options_.substeps, 0.0});
                return;
            }
            for (int s = 1; s <= most; s *= 2) plans.push_back({method, s, 0.0});
        };
        add(GridMethod::RungeKutta4, kMostExplicit);
        add(GridMethod::Esdirk, kMostImplicit);
        std::stable_sort(plans.begin(), plans.end(),
                         [](const GridPlan& a, const GridPlan& b) { return costOf(a) < costOf(b); });
        return plans;
    }

    /// A plan that gets through the record at all: range of each output and where it is liveliest. Single steps
    /// first; an explicit method at its limit of stability would show ranges that are not there.
    bool surveyWholeRecord() {
        std::vector<GridPlan> plans = ladder();
        std::stable_partition(plans.begin(), plans.end(), [](const GridPlan& plan) { return plan.substeps == 1; });
        for (const GridPlan& plan : plans) {
            if (progress_.stopRequested()) return false;
            Trajectory whole = run(plan, wholeRecord(), true);
            if (whole.failure.failed || !isPlausible(whole)) continue;
            survey_ = plan;
            surveyRun_ = std::move(whole);
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
            windows_.push_back(wholeRecord());
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
        windows_.push_back(windowFrom(whole, std::clamp(sample - kLongestWindow / 2, 0, sampleCount_ - 2)));
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

    /// Climbs the ladder by cost. Halving the steps shows the error of the coarser plan and, where the differences
    /// fall as the order promises, that of the finer one too.
    GridPlan cheapestOnWindows() {
        std::vector<GridPlan> judged;
        std::map<bool, double> lastDifference;
        for (GridPlan plan : ladder()) {
            if (costOf(plan) < least_) continue;
            const bool isImplicit = plan.method == GridMethod::Esdirk;
            GridPlan finer = plan;
            finer.substeps *= 2;
            const auto known = std::find_if(judged.begin(), judged.end(), [&](const GridPlan& p) {
                return p.method == plan.method && p.substeps == plan.substeps && p.errorEstimate <= tolerance_;
            });
            if (known != judged.end()) return *known;
            const std::optional<double> moved = difference(plan, finer);
            if (!moved) continue;
            plan.errorEstimate = *moved;
            judged.push_back(plan);
            if (*moved <= tolerance_ || options_.substeps > 0) return plan;
            const auto before = lastDifference.find(isImplicit);
            const double fall = before == lastDifference.end() ? 2.0 : before->second / std::max(*moved, 1e-300);
            finer.errorEstimate = *moved / std::clamp(fall, 1.0, isImplicit ? 8.0 : 16.0);
            if (finer.errorEstimate <= tolerance_ && finer.substeps <= (isImplicit ? kMostImplicit : kMostExplicit)) {
                judged.push_back(finer);
            }
            lastDifference[isImplicit] = *moved;
            if (isEnough(judged, plan)) break;
        }
        return bestOf(judged);
    }

    /// The cheapest plan with an error up to `factor` times the tolerance; null: none.
    const GridPlan* cheapestWithin(const std::vector<GridPlan>& judged, double factor) const {
        const GridPlan* best{};
        for (const GridPlan& plan : judged) {
            if (plan.errorEstimate <= factor * tolerance_ && (!best || costOf(plan) < costOf(*best))) best = &plan;
        }
        return best;
    }

    // Where the solution is not smooth (sticking, dead zones) the last digits cost too much: a tenfold error is taken
    // when less would cost this many times as much. A hundred times the tolerance is still below any sensor noise.
    static constexpr double worthIt_ = 5.0;

    bool isEnough(const std::vector<GridPlan>& judged, const GridPlan& current) const {
        const GridPlan* known = cheapestWithin(judged, 100.0);
        return known && costOf(current) >= worthIt_ * costOf(*known) &&
               (!cheapestWithin(judged, 10.0) || costOf(current) >= worthIt_ * costOf(*cheapestWithin(judged, 10.0)));
    }

    GridPlan bestOf(const std::vector<GridPlan>& judged) const {
        if (judged.empty()) return fallback();
        const GridPlan* best{};
        for (const double factor : {100.0, 10.0, 1.0}) {
            const GridPlan* better = cheapestWithin(judged, factor);
            if (better && (!best || costOf(*better) <= worthIt_ * costOf(*best))) best = better;
        }
        if (best) return *best;
        return *std::min_element(judged.begin(), judged.end(), [](const GridPlan& a, const GridPlan& b) {
            return a.errorEstimate < b.errorEstimate;
        });
    }

    /// Nothing got through: the most robust method, whose run will say where and why it fails.
    GridPlan fallback() const {
        const bool isExplicit = options_.method == GridMethod::RungeKutta4;
        return {isExplicit ? GridMethod::RungeKutta4 : GridMethod::Esdirk,
                options_.substeps > 0 ? options_.substeps : 4, 1.0};
    }

    Dynamics& dynamics_;
    const SampledInputs& inputs_;
    SimulationOptions options_, limited_;
    const Progress& progress_;
    double tolerance_{};
    int sampleCount_{};
    double least_{};                           // plans cheaper than this have failed on the whole record
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
