#include <fmt/format.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "core/base/stopwatch.hpp"
#include "core/simulate/grid.hpp"
#include "core/simulate/moving_jump.hpp"
#include "core/simulate/sample_recorder.hpp"
#include "core/simulate/sliding.hpp"
#include "core/simulate/state_jacobian.hpp"
#include "core/simulate/sundials_owner.hpp"

namespace analogon {

namespace {

/// The errors of single steps add up: each may have this part of the tolerance that is asked for the whole.
constexpr double localShare = 0.05;

/// What switches more often, or faster than this part of the whole time, is not followed but named.
constexpr std::size_t mostEvents = 100'000;
constexpr double shortestPart = 1e-6;

/// CVODES with backward differentiation formulas from kink to kink of the inputs (Hindmarsh et al. 2005), roots
/// located and the integration restarted there, tangents by staggered forward sensitivities.
class AdaptivePass final : public StateInterpolant {
public:
    AdaptivePass(Dynamics& dynamics, const SampledInputs& inputs, bool keepStates, const SimulationOptions& options,
                 const Progress& progress, Trajectory& result)
        : dynamics_(dynamics),
          inputs_(inputs),
          options_(options),
          progress_(progress),
          result_(result),
          last_(static_cast<int>(inputs.time.size()) - 1),
          n_(dynamics.shape().states),
          K_(dynamics.shape().directions),
          slots_(dynamics, inputs),
          recorder_(dynamics, slots_, inputs, 0, last_, keepStates, result),
          sliding_(
              dynamics, [this](double t) { slotsAt(t, nullptr); }, u_),
          moving_(dynamics, slots_),
          started_(std::chrono::steady_clock::now()) {
        const auto n = static_cast<std::size_t>(n_), K = static_cast<std::size_t>(K_);
        u_.resize(static_cast<std::size_t>(dynamics.shape().slots));
        if (slots_.hasTangents()) du_.resize(u_.size() * K);
        x_.resize(n);
        dx_.resize(n * K);
        dxdot_.resize(n * K);
        // What holds the state between the two sides of a switch couples states that the model does not.
        if (dynamics.pattern() && dynamics.shape().roots == 0)
            sparse_ = std::make_unique<StepPattern>(*dynamics.pattern());
        jacobian_.resize(sparse_ ? dynamics.pattern()->entries() : n * n);
    }

    void execute() {
        double* const du = du_.empty() ? nullptr : du_.data();
        time_ = inputs_.time.front();
        slots_.atSample(0, u_.data(), du);
        if (!dynamics_.initialise(time_, u_.data(), du, x_.data(), K_ > 0 ? dx_.data() : nullptr) ||
            !recorder_.start(x_.data(), dx_.data())) {
            return fail(0, dynamics_.failure(), recorder_.reason());
        }
        nextSample_ = 1;
        if (last_ == 0) return;
        if (n_ == 0) return sampleOnly();
        joinWhatHolds();
        if (!setUp()) return fail(nextSample_, {}, "the integrator could not be set up");
        findStops();
        for (std::size_t i = 0; i < stops_.size(); ++i) {
            // Just inside the piece that begins here, whatever rounding did to the time.
            interval_ = slots_.intervalOf(time_, interval_);
            if (i == 0) enterPiece(stops_[i]);
            if (!integrateTo(stops_[i])) return;
            if (i + 1 == stops_.size()) break;
            const bool isJump = std::binary_search(jumps_.begin(), jumps_.end(), stops_[i]);
            if (!restartsAtKinks_ && !isJump) {
                enterPiece(stops_[i + 1]);
                continue;
            }
            CVodeGetDky(cvodes_.get(), time_, 0, y_.get());
            if (isJump && !passJump(stops_[i + 1])) return;
            if (!isJump) enterPiece(stops_[i + 1]);
            restart();
        }
    }

    // The solver's own polynomial over its last step.
    bool at(double t, double* x, double* dx, double* xdot) override {
        if (CVodeGetDky(cvodes_.get(), t, 0, y_.get()) != CV_SUCCESS) return false;
        std::copy_n(N_VGetArrayPointer(y_.get()), n_, x);
        if (xdot) {
            if (CVodeGetDky(cvodes_.get(), t, 1, y_.get()) != CV_SUCCESS) return false;
            std::copy_n(N_VGetArrayPointer(y_.get()), n_, xdot);
        }
        if (dx && K_ > 0) {
            if (CVodeGetSensDky(cvodes_.get(), t, 0, sensitivities_->get()) != CV_SUCCESS) return false;
            gather(sensitivities_->get(), dx);
        }
        return true;
    }

private:
    bool setUp();
    bool setUpSensitivities();

    /// Without states everything is algebraic.
    void sampleOnly() {
        class Nothing final : public StateInterpolant {
        public:
            bool at(double, double*, double*, double*) override { return true; }
        } nothing;
        for (; nextSample_ <= last_; ++nextSample_) {
            time_ = sampleTime(nextSample_);
            if (!recorder_.advance(nothing, time_, nextSample_ - 1) ||
                !recorder_.record(nextSample_, x_.data(), dx_.data())) {
                return fail(nextSample_, dynamics_.failure(), recorder_.reason());
            }
        }
    }

    /// The piece that begins here ends at this stop: while it lasts, whatever the rounding of a time, held inputs have
    /// the values that they have in it.
    void enterPiece(double stop) {
        if (!slots_.hasHeld()) return;
        interval_ = slots_.intervalOf(time_, interval_);
        lastInterval_ = slots_.intervalOf(stop, interval_);
        if (lastInterval_ > interval_ && stop == sampleTime(lastInterval_)) --lastInterval_;
        const double within = 0.5 * (time_ + stop);
        if (!slots_.heldDelays().empty()) slots_.holdLines(within);
        if (moving_.any() && time_ == inputs_.time.front()) moving_.begin(within);
    }

    /// A held input jumps here: what held the model between two sides may end, or begin.
    bool passJump(double nextStop) {
        const double within = 0.5 * (time_ + nextStop);
        enterPiece(nextStop);
        double* const x = N_VGetArrayPointer(y_.get());
        if (moving_.any()) {
            slotsAt(time_, nullptr);
            CVodeGetSensDky(cvodes_.get(), time_, 0, sensitivities_->get());
            gather(sensitivities_->get(), dx_.data());
            if (!moving_.pass(time_, within, u_.data(), x, dx_.data()))
                return fail(nextSample_, dynamics_.failure(), "not finite"), false;
            hasMoved_ = true;
        }
        if (sliding_.isActive()) sliding_.leave(time_, x);
        std::copy_n(x, n_, x_.begin());
        joinWhatHolds();
        std::copy_n(x_.begin(), n_, x);
        return true;
    }

    /// Steps must not straddle a kink. With few kinks the integration restarts at each; with a kink in almost every
    /// sample it runs on at its order, unless the slopes of the inputs themselves enter the equations. At the jumps of
    /// a held input it always does.
    void findStops() {
        const std::vector<int> kinks = trueKinks(inputs_);
        for (int k : kinks) {
            if (k > 0) stops_.push_back(sampleTime(k));
        }
        const std::vector<double> delayed = arrivalsOf(kinks);
        stops_.insert(stops_.end(), delayed.begin(), delayed.end());
        std::sort(stops_.begin(), stops_.end());
        stops_.erase(std::unique(stops_.begin(), stops_.end()), stops_.end());
        if (slots_.hasHeld()) {
            const std::vector<int> jumps = jumpsOf(inputs_);
            jumps_ = arrivalsOf(jumps);
            for (int k : jumps) jumps_.push_back(sampleTime(k));
            std::sort(jumps_.begin(), jumps_.end());
        }
        restartsAtKinks_ =
            dynamics_.shape().needsInputDerivative || stops_.size() * 4 < static_cast<std::size_t>(last_);
    }

    /// When a kink at these samples arrives by the delays; beside a jump no piece may be as short as rounding.
    std::vector<double> arrivalsOf(const std::vector<int>& samples) {
        std::vector<double> arrivals = slots_.delayedTimes(samples);
        if (!slots_.hasHeld()) return arrivals;
        const double rounding = 1e-9 * (inputs_.time.back() - inputs_.time.front()) / last_;
        int near = 0;
        for (double& t : arrivals) {
            near = slots_.intervalOf(t, near);
            for (const int k : {near, near + 1})
                if (std::abs(t - sampleTime(k)) <= rounding) t = sampleTime(k);
        }
        return arrivals;
    }

    bool integrateTo(double stop) {
        CVodeSetStopTime(cvodes_.get(), stop);
        while (time_ < stop) {
            if (!isWithinLimits()) return false;
            const double before = time_;
            const int flag = CVode(cvodes_.get(), stop, y_.get(), &time_, CV_ONE_STEP);
            if (flag >= 0) {
                if (const std::vector<int> hidden = hiddenRoots(before, flag == CV_ROOT_RETURN); !hidden.empty()) {
                    if (!repeatStep(before, hidden)) return false;
                    CVodeSetStopTime(cvodes_.get(), stop);
                    continue;
                }
                relaxSteps();
            }
            if (flag < 0) {
                // What held the state may have ended within the step.
                if (!sliding_.isActive() || !isAllowedAnEvent()) return explain(flag);
                sliding_.release();
                if (!restart()) return explain(flag);
                CVodeSetStopTime(cvodes_.get(), stop);
                continue;
            }
            std::copy_n(N_VGetArrayPointer(y_.get()), n_, x_.begin());
            if (!recordUpTo(time_)) return false;
            if (flag == CV_ROOT_RETURN) {
                if (eventTimes_.size() >= mostEvents)
                    return fail(nextSample_, stateBehind(lastRoots()), "more than 100000 events"), false;
                if (!isAllowedAnEvent())
                    return fail(nextSample_, stateBehind(lastRoots()), "events without end"), false;
                passEvent();
                if (!restart()) return fail(nextSample_, {}, "the integrator could not restart"), false;
                CVodeSetStopTime(cvodes_.get(), stop);
            } else if (isStalled() && joinWhatHolds()) {
                std::copy(x_.begin(), x_.end(), N_VGetArrayPointer(y_.get()));
                if (!restart()) return fail(nextSample_, {}, "the integrator could not restart"), false;
                CVodeSetStopTime(cvodes_.get(), stop);
            }
            if (flag == CV_TSTOP_RETURN) break;
        }
        return true;
    }

    bool recordUpTo(double reached) {
        if (recorder_.needsInterpolant(reached) && !recorder_.advance(*this, reached, interval_)) {
            return fail(nextSample_, dynamics_.failure(), recorder_.reason()), false;
        }
        for (; nextSample_ <= last_ && sampleTime(nextSample_) <= reached; ++nextSample_) {
            if (!at(sampleTime(nextSample_), sampleX().data(), K_ > 0 ? sampleDx().data() : nullptr, nullptr) ||
                !recorder_.record(nextSample_, sampleX_.data(), sampleDx_.data())) {
                return fail(nextSample_, dynamics_.failure(), recorder_.reason()), false;
            }
        }
        return true;
    }

    /// Events that pile up at one time: chattering that nothing holds, or a ball that bounces ever lower.
    bool isAllowedAnEvent() {
        constexpr std::size_t most = 200;
        constexpr double window = 1e-6;  // of the whole time
        eventTimes_.push_back(time_);
        if (eventTimes_.size() <= most) return true;
        return time_ - eventTimes_[eventTimes_.size() - 1 - most] >
               window * (inputs_.time.back() - inputs_.time.front());
    }

    /// Relations that switch forth and back within the step, which root finding between its ends cannot see. `atRoot`:
    /// the step ends where one is 0.
    std::vector<int> hiddenRoots(double before, bool atRoot) {
        const auto count = static_cast<std::size_t>(dynamics_.shape().roots);
        // Below this a root that was located a rounding error too early would be seen again.
        const double least = 1e-5 * shortestPart * (inputs_.time.back() - inputs_.time.front());
        if (count == 0 || sliding_.isActive() || time_ - before < least) return {};
        // At no simple fraction of the step: a relation with a period would be seen at the same phase.
        constexpr double places[] = {0.1871, 0.4423, 0.7639, 1.0};
        const std::span<const double> looked(places, atRoot ? 3 : 4);
        std::vector<double> values, x(x_.size());
        for (const double place : looked) {
            const double t = before + place * (time_ - before);
            values.resize(values.size() + count);
            if (!at(t, x.data(), nullptr, nullptr)) return {};
            slotsAt(t, nullptr);
            if (!dynamics_.roots(t, x.data(), u_.data(), values.data() + values.size() - count)) return {};
        }
        CVodeGetDky(cvodes_.get(), time_, 0, y_.get());
        const auto changes = [&](std::size_t j, double tolerance) {
            bool above = false, below = false;
            for (std::size_t i = j; i < values.size(); i += count) {
                above = above || values[i] > tolerance;
                below = below || values[i] < -tolerance;
            }
            return above && below;
        };
        std::vector<int> hidden;
        std::vector<double> tolerance;
        for (std::size_t j = 0; j < count; ++j) {
            if (!changes(j, 0)) continue;
            if (tolerance.empty()) tolerance = rootTolerances(time_, x);
            if (tolerance.empty()) return {};
            if (changes(j, tolerance[j])) hidden.push_back(static_cast<int>(j));
        }
        return hidden;
    }

    /// Back to where the step began, with shorter steps from now on.
    bool repeatStep(double before, const std::vector<int>& hidden) {
        longestStep_ = 0.5 * (time_ - before);
        quietSteps_ = 0;
        if (longestStep_ < shortestPart * (inputs_.time.back() - inputs_.time.front())) {
            std::copy_n(N_VGetArrayPointer(y_.get()), n_, x_.begin());
            return fail(nextSample_, stateBehind(hidden), "events faster than the steps"), false;
        }
        time_ = before;
        if (CVodeGetDky(cvodes_.get(), time_, 0, y_.get()) != CV_SUCCESS || !restart() ||
            CVodeSetMaxStep(cvodes_.get(), longestStep_) != CV_SUCCESS)
            return fail(nextSample_, {}, "the integrator could not restart"), false;
        return true;
    }

    /// After a while without a hidden event the steps may grow again.
    void relaxSteps() {
        if (longestStep_ == 0 || ++quietSteps_ < 200) return;
        quietSteps_ = 0;
        longestStep_ *= 2;
        if (longestStep_ > inputs_.time.back() - inputs_.time.front()) longestStep_ = 0;
        CVodeSetMaxStep(cvodes_.get(), longestStep_);  // 0: as long as it likes
    }

    /// Where both sides of a surface lead back to it an implicit step across has no solution: steps become tiny.
    bool isStalled() const {
        if (dynamics_.shape().roots == 0) return false;
        double step = 0;
        CVodeGetLastStep(cvodes_.get(), &step);
        return step < 1e-6 * (inputs_.time.back() - inputs_.time.front());
    }

    /// How much each root function changes by what the states are uncertain by; empty when they cannot be evaluated.
    std::vector<double> rootTolerances(double t, std::vector<double> x) {
        std::vector<double> values(static_cast<std::size_t>(dynamics_.shape().roots)), moved(values.size()),
            tolerance(values.size(), 1e-14);
        slotsAt(t, nullptr);
        if (!dynamics_.roots(t, x.data(), u_.data(), values.data())) return {};
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double here = x[i];
            x[i] += options_.relativeTolerance * std::abs(here) +
                    options_.absoluteTolerance * dynamics_.shape().stateNominal[i];
            const bool isKnown = dynamics_.roots(t, x.data(), u_.data(), moved.data());
            x[i] = here;
            for (std::size_t j = 0; isKnown && j < moved.size(); ++j) tolerance[j] += std::abs(moved[j] - values[j]);
        }
        return tolerance;
    }

    /// The roots whose surface is nearer than the tolerance of the states.
    std::vector<int> nearRoots() {
        const std::vector<double> tolerance = rootTolerances(time_, x_);
        std::vector<double> values(tolerance.size());
        if (values.empty() || !dynamics_.roots(time_, x_.data(), u_.data(), values.data())) return {};
        std::vector<int> near;
        for (std::size_t j = 0; j < values.size(); ++j)
            if (std::abs(values[j]) <= tolerance[j]) near.push_back(static_cast<int>(j));
        return near;
    }

    /// Joins the surfaces on which the state lies, and that hold it.
    bool joinWhatHolds() {
        if (dynamics_.shape().roots == 0 || !sliding_.join(time_, x_.data(), nearRoots())) return false;
        remarkHeld();
        return true;
    }

    void remarkHeld() {
        constexpr std::size_t most = 20;
        if (result_.remarks.size() >= most) return;
        result_.remarks.push_back(
            phrase("from t = {:.6g} s a relation of {} holds the model between its two sides (sliding)", time_,
                   stateBehind(sliding_.surfaces())));
    }

    /// At a root: surfaces that no longer hold the state are left, one that was reached and holds it is joined.
    void passEvent() {
        CVodeGetDky(cvodes_.get(), time_, 0, y_.get());
        double* const x = N_VGetArrayPointer(y_.get());
        bool isLeft = false;
        std::vector<int> reached;
        for (const int j : lastRoots()) {
            if (sliding_.holds(j))
                isLeft = true;
            else
                reached.push_back(j);
        }
        if (isLeft) sliding_.leave(time_, x);
        std::copy_n(x, n_, x_.begin());
        // An event may also end what kept the state off another surface.
        const std::vector<int> near = nearRoots();
        reached.insert(reached.end(), near.begin(), near.end());
        if (sliding_.join(time_, x_.data(), reached)) remarkHeld();
        std::copy_n(x_.begin(), n_, x);
    }

    /// The relations that the last event came from.
    std::vector<int> lastRoots() {
        std::vector<int> found(static_cast<std::size_t>(dynamics_.shape().roots), 0), roots;
        CVodeGetRootInfo(cvodes_.get(), found.data());
        for (std::size_t j = 0; j < found.size(); ++j)
            if (found[j] != 0) roots.push_back(static_cast<int>(j));
        return roots;
    }

    /// The state that these relations depend on most.
    std::string stateBehind(const std::vector<int>& roots) {
        std::vector<double> values(static_cast<std::size_t>(dynamics_.shape().roots)), moved(values.size()), x = x_;
        std::string name = dynamics_.shape().stateNames.front();
        slotsAt(time_, nullptr);
        if (!dynamics_.roots(time_, x.data(), u_.data(), values.data())) return name;
        double largest = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += 1e-3 * dynamics_.shape().stateNominal[i];
            const bool isKnown = dynamics_.roots(time_, x.data(), u_.data(), moved.data());
            x[i] = x_[i];
            for (const int j : roots) {
                const auto at = static_cast<std::size_t>(j);
                if (!isKnown || std::abs(moved[at] - values[at]) <= largest) continue;
                largest = std::abs(moved[at] - values[at]);
                name = dynamics_.shape().stateNames[i];
            }
        }
        return name;
    }

    /// Starts anew from where it is: y holds the state.
    bool restart() {
        if (K_ > 0) CVodeGetSensDky(cvodes_.get(), time_, 0, sensitivities_->get());
        if (std::exchange(hasMoved_, false))
            for (int k = 0; k < K_; ++k)
                for (int i = 0; i < n_; ++i) (*sensitivities_)[k][i] = dx_[static_cast<std::size_t>(i * K_ + k)];
        interval_ = slots_.intervalOf(time_, interval_);
        if (CVodeReInit(cvodes_.get(), time_, y_.get()) != CV_SUCCESS) return false;
        return K_ == 0 || CVodeSensReInit(cvodes_.get(), CV_STAGGERED, sensitivities_->get()) == CV_SUCCESS;
    }

    bool isWithinLimits() {
        if (++steps_ > options_.stepLimit) return fail(nextSample_, worstState(), "step limit"), false;
        if (progress_.stopRequested()) return fail(nextSample_, {}, "cancelled"), false;
        if ((steps_ & 255) != 1) return true;  // the clock is not read at every step
        if (secondsSince(started_) > options_.wallClockLimit)
            return fail(nextSample_, worstState(), "time limit"), false;
        if (options_.reached) options_.reached(static_cast<double>(nextSample_) / std::max(1, last_));
        if (standsStill()) return fail(nextSample_, worstState(), "the step became too small for the tolerance"), false;
        return true;
    }

    /// Whether the steps since the clock was last read were no longer than rounding: a state that grows without bound
    /// in finite time is followed for ever otherwise.
    bool standsStill() {
        constexpr double rounding = 256 * std::numeric_limits<double>::epsilon();
        const double before = std::exchange(timeAtClock_, time_);
        return time_ - before <= rounding * std::abs(time_) && steps_ > 256;
    }

    /// The state whose error test was worst in the last step.
    std::string worstState() const {
        Owned<N_Vector, FreeVector> weights(N_VClone(y_.get())), errors(N_VClone(y_.get()));
        if (CVodeGetErrWeights(cvodes_.get(), weights.get()) != CV_SUCCESS ||
            CVodeGetEstLocalErrors(cvodes_.get(), errors.get()) != CV_SUCCESS) {
            return {};
        }
        double largest = -1.0;
        int worst = 0;
        for (int i = 0; i < n_; ++i) {
            const double size = std::abs(N_VGetArrayPointer(weights.get())[i] * N_VGetArrayPointer(errors.get())[i]);
            if (size <= largest) continue;
            largest = size;
            worst = i;
        }
        return dynamics_.shape().stateNames[static_cast<std::size_t>(worst)];
    }

    bool explain(int flag) {
        const bool isEvaluation = flag == CV_RHSFUNC_FAIL || flag == CV_REPTD_RHSFUNC_ERR ||
                                  flag == CV_FIRST_RHSFUNC_ERR || flag == CV_UNREC_RHSFUNC_ERR;
        std::string variable = isEvaluation ? dynamics_.failure() : worstState();
        const char* reason = "not finite";
        if (flag == CV_ERR_FAILURE) reason = "the step became too small for the tolerance";
        if (flag == CV_CONV_FAILURE || flag == CV_LSETUP_FAIL || flag == CV_LSOLVE_FAIL) {
            reason = "no convergence of an implicit step";
        }
        if (flag == CV_TOO_CLOSE || flag == CV_TOO_MUCH_ACC) reason = "the tolerance is beyond the machine's accuracy";
        return fail(nextSample_, variable.empty() ? worstState() : variable, reason), false;
    }

    void fail(int sample, std::string variable, const char* reason) {
        recorder_.abandon(std::min(sample, last_));
        result_.failure = {true, time_, std::move(variable), reason};
    }

    double sampleTime(int k) const { return inputs_.time[static_cast<std::size_t>(k)]; }
    std::vector<double>& sampleX() {
        sampleX_.resize(x_.size());
        return sampleX_;
    }
    std::vector<double>& sampleDx() {
        sampleDx_.resize(dx_.size());
        return sampleDx_;
    }
    void gather(N_Vector* from, double* to) const {
        for (int k = 0; k < K_; ++k) {
            const double* column = N_VGetArrayPointer(from[k]);
            for (int i = 0; i < n_; ++i) to[i * K_ + k] = column[i];
        }
    }
    void slotsAt(double t, double* du) {
        // The piece in force: a time on its end still belongs to it.
        int k = slots_.intervalOf(t, interval_);
        if (k > interval_ && t == sampleTime(k)) --k;
        if (slots_.hasHeld()) k = std::max(interval_, std::min(k, lastInterval_));
        slots_.at(k, t, u_.data(), du);
    }

    static int derivatives(double t, N_Vector y, N_Vector ydot, void* self);
    static int jacobian(double t, N_Vector y, N_Vector fy, SUNMatrix J, void* self, N_Vector, N_Vector, N_Vector);
    bool sparseJacobian(double t, const double* x, double* rates, SUNMatrix J);
    bool makeLinearSolver();
    static int sensitivityRates(int count, double t, N_Vector y, N_Vector ydot, N_Vector* yS, N_Vector* ySdot,
                                void* self, N_Vector, N_Vector);
    static int rootFunctions(double t, N_Vector y, double* values, void* self);

    Dynamics& dynamics_;
    const SampledInputs& inputs_;
    const SimulationOptions& options_;
    const Progress& progress_;
    Trajectory& result_;
    int last_{}, n_{}, K_{};
    InputSlots slots_;
    SampleRecorder recorder_;
    Sliding sliding_;
    MovingJumps moving_;
    std::chrono::steady_clock::time_point started_;
    std::vector<double> u_, du_, x_, dx_, dxdot_, jacobian_, sampleX_, sampleDx_;
    std::unique_ptr<StepPattern> sparse_;  // null: full matrices
    std::vector<double> stops_, jumps_;
    bool hasMoved_{};     // the tangents in dx_, at a jump that depends on the parameters
    int lastInterval_{};  // of the piece under way, where inputs are held
    bool restartsAtKinks_{true};
    double time_{};
    int interval_{}, nextSample_{};
    std::vector<double> eventTimes_;
    double longestStep_{};  // 0: not limited
    int quietSteps_{};      // since it was limited
    long steps_{};
    double timeAtClock_{};
    // Freed in the opposite order: the solver before what it uses, the context last.
    Owned<SUNContext, FreeContext> context_;
    Owned<N_Vector, FreeVector> y_;
    Owned<SUNMatrix, FreeMatrix> matrix_;
    Owned<SUNLinearSolver, FreeSolver> solver_;
    std::unique_ptr<VectorArray> sensitivities_;
    std::unique_ptr<void, FreeCvodes> cvodes_;
};

int AdaptivePass::derivatives(double t, N_Vector y, N_Vector ydot, void* self) {
    auto& pass = *static_cast<AdaptivePass*>(self);
    if (pass.sliding_.isActive())
        return pass.sliding_.derivatives(t, N_VGetArrayPointer(y), N_VGetArrayPointer(ydot)) ? 0 : 1;
    pass.slotsAt(t, nullptr);
    return pass.dynamics_.derivatives(t, N_VGetArrayPointer(y), pass.u_.data(), N_VGetArrayPointer(ydot)) ? 0 : 1;
}

int AdaptivePass::jacobian(double t, N_Vector y, N_Vector, SUNMatrix J, void* self, N_Vector scratch, N_Vector,
                           N_Vector) {
    auto& pass = *static_cast<AdaptivePass*>(self);
    pass.slotsAt(t, nullptr);
    const double* const x = N_VGetArrayPointer(y);
    if (pass.sparse_) return pass.sparseJacobian(t, x, N_VGetArrayPointer(scratch), J) ? 0 : 1;
    const bool isKnown =
        pass.sliding_.isActive()
            ? pass.sliding_.jacobian(t, x, pass.jacobian_.data())
            : pass.dynamics_.jacobian(t, x, pass.u_.data(), N_VGetArrayPointer(scratch), pass.jacobian_.data());
    if (!isKnown) return 1;
    for (int i = 0; i < pass.n_; ++i) {
        for (int j = 0; j < pass.n_; ++j) {
            SM_ELEMENT_D(J, i, j) = pass.jacobian_[static_cast<std::size_t>(i * pass.n_ + j)];
        }
    }
    return 0;
}

/// The solver clears the matrix with its pattern before.
bool AdaptivePass::sparseJacobian(double t, const double* x, double* rates, SUNMatrix J) {
    if (!dynamics_.sparseJacobian(t, x, u_.data(), rates, jacobian_.data())) return false;
    std::copy(sparse_->starts.begin(), sparse_->starts.end(), SM_INDEXPTRS_S(J));
    std::copy(sparse_->rows.begin(), sparse_->rows.end(), SM_INDEXVALS_S(J));
    for (std::size_t e = 0; e < jacobian_.size(); ++e) SM_DATA_S(J)[sparse_->places[e]] = jacobian_[e];
    return true;
}

bool AdaptivePass::makeLinearSolver() {
    if (sparse_) {
        const auto entries = static_cast<sunindextype>(sparse_->rows.size());
        matrix_.reset(SUNSparseMatrix(n_, n_, entries, CSC_MAT, context_.get()));
        solver_.reset(SUNLinSol_KLU(y_.get(), matrix_.get(), context_.get()));
    } else {
        matrix_.reset(SUNDenseMatrix(n_, n_, context_.get()));
        solver_.reset(SUNLinSol_Dense(y_.get(), matrix_.get(), context_.get()));
    }
    return matrix_ && solver_;
}

int AdaptivePass::sensitivityRates(int count, double t, N_Vector y, N_Vector, N_Vector* yS, N_Vector* ySdot, void* self,
                                   N_Vector scratch, N_Vector) {
    auto& pass = *static_cast<AdaptivePass*>(self);
    double* const du = pass.du_.empty() ? nullptr : pass.du_.data();
    pass.slotsAt(t, du);
    pass.gather(yS, pass.dx_.data());
    const double* const x = N_VGetArrayPointer(y);
    double* const rates = N_VGetArrayPointer(scratch);
    const bool isKnown =
        pass.sliding_.isActive()
            ? pass.sliding_.derivatives(t, x, pass.dx_.data(), du, rates, pass.dxdot_.data())
            : pass.dynamics_.derivatives(t, x, pass.dx_.data(), pass.u_.data(), du, rates, pass.dxdot_.data());
    if (!isKnown) return 1;
    for (int k = 0; k < count; ++k) {
        double* column = N_VGetArrayPointer(ySdot[k]);
        for (int i = 0; i < pass.n_; ++i) column[i] = pass.dxdot_[static_cast<std::size_t>(i * count + k)];
    }
    return 0;
}

int AdaptivePass::rootFunctions(double t, N_Vector y, double* values, void* self) {
    auto& pass = *static_cast<AdaptivePass*>(self);
    pass.slotsAt(t, nullptr);
    if (!pass.dynamics_.roots(t, N_VGetArrayPointer(y), pass.u_.data(), values)) return -1;
    return !pass.sliding_.isActive() || pass.sliding_.exits(t, N_VGetArrayPointer(y), values) ? 0 : -1;
}

bool AdaptivePass::setUp() {
    SUNContext context{};
    if (SUNContext_Create(nullptr, &context) != 0) return false;
    context_.reset(context);
    y_.reset(N_VNew_Serial(n_, context));
    std::copy(x_.begin(), x_.end(), N_VGetArrayPointer(y_.get()));
    if (!makeLinearSolver()) return false;
    cvodes_.reset(CVodeCreate(CV_BDF, context));
    void* const memory = cvodes_.get();
    if (!memory) return false;
    // What went wrong is told in our words, not printed.
    CVodeSetErrHandlerFn(
        memory, [](int, const char*, const char*, char*, void*) {}, nullptr);
    if (CVodeInit(memory, derivatives, time_, y_.get()) != CV_SUCCESS) return false;
    Owned<N_Vector, FreeVector> absolute(N_VClone(y_.get()));
    for (int i = 0; i < n_; ++i) {
        N_VGetArrayPointer(absolute.get())[i] =
            localShare * options_.absoluteTolerance * dynamics_.shape().stateNominal[static_cast<std::size_t>(i)];
    }
    bool ok = CVodeSVtolerances(memory, localShare * options_.relativeTolerance, absolute.get()) == CV_SUCCESS &&
              CVodeSetUserData(memory, this) == CV_SUCCESS &&
              CVodeSetLinearSolver(memory, solver_.get(), matrix_.get()) == CV_SUCCESS &&
              CVodeSetJacFn(memory, jacobian) == CV_SUCCESS && CVodeSetMaxErrTestFails(memory, 20) == CV_SUCCESS &&
              CVodeSetMaxConvFails(memory, 30) == CV_SUCCESS;
    if (ok && dynamics_.shape().roots > 0) {
        ok = CVodeRootInit(memory, dynamics_.shape().roots, rootFunctions) == CV_SUCCESS;
        CVodeSetNoInactiveRootWarn(memory);
    }
    return ok && (K_ == 0 || setUpSensitivities());
}

bool AdaptivePass::setUpSensitivities() {
    void* const memory = cvodes_.get();
    sensitivities_ = std::make_unique<VectorArray>(y_.get(), K_);
    VectorArray absolute(y_.get(), K_);
    for (int k = 0; k < K_; ++k) {
        for (int i = 0; i < n_; ++i) {
            const double start = dx_[static_cast<std::size_t>(i * K_ + k)];
            (*sensitivities_)[k][i] = start;
            absolute[k][i] = options_.absoluteTolerance * dynamics_.shape().stateNominal[static_cast<std::size_t>(i)] /
                             dynamics_.shape().directionScale[static_cast<std::size_t>(k)];
        }
    }
    return CVodeSensInit(memory, K_, CV_STAGGERED, sensitivityRates, sensitivities_->get()) == CV_SUCCESS &&
           CVodeSensSVtolerances(memory, options_.relativeTolerance, absolute.get()) == CV_SUCCESS &&
           CVodeSetSensErrCon(memory, SUNTRUE) == CV_SUCCESS;
}

}  // namespace

Trajectory runAdaptive(Dynamics& dynamics, const SampledInputs& inputs, bool keepStates,
                       const SimulationOptions& options, const Progress& progress) {
    Trajectory result;
    result.engine = Engine::Adaptive;
    if (inputs.time.empty()) {
        result.failure = {true, 0.0, {}, "no samples"};
        return result;
    }
    AdaptivePass(dynamics, inputs, keepStates, options, progress, result).execute();
    return result;
}

}  // namespace analogon
