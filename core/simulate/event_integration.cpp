#include <fmt/format.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/base/stopwatch.hpp"
#include "core/simulate/event_runner.hpp"

/// From one event to the next.
namespace analogon {

namespace {

constexpr double localShare = 0.1;  // of the tolerance, for one step

}  // namespace

/// When each sample comes, by what the start has found.
bool EventRun::startClocks() {
    for (const HybridModel::Sample& sample : model_.samples) {
        Clock clock{values_[static_cast<std::size_t>(sample.start)], values_[static_cast<std::size_t>(sample.interval)],
                    0};
        if (!(clock.interval > 0) || !std::isfinite(clock.start)) {
            faults_.push_back(error(phrase("'sample' begins at {} s with an interval of {} s: it needs a number and "
                                           "an interval above 0",
                                           clock.start, clock.interval),
                                    sample.span));
            return false;
        }
        clock.count = std::max(0.0, std::ceil((options_.start - clock.start) / clock.interval - 1e-9));
        clocks_.push_back(clock);
        if (tangents_) clockTangents_.emplace_back(tangents_->ofStep(sample.start), tangents_->ofStep(sample.interval));
    }
    return true;
}

/// The next time at which something happens that is known in advance.
double EventRun::nextTimeEvent() const {
    double next = never;
    for (const Clock& clock : clocks_) next = std::min(next, clock.next());
    for (const DelayHistory& delay : delays_) next = std::min(next, delay.nextArrival());
    const double least = time_ + 2e-13 * sizeOf(time_);
    for (const HybridModel::Relation& r : model_.relations) {
        if (!r.isOfTime || !r.isWatched) continue;
        const double zero = -offsetOf(r.offset) / r.factor;
        if (zero > least) next = std::min(next, zero);
    }
    for (const HybridModel::Whole& w : model_.wholes) {
        if (!w.isOfTime || !w.isWatched) continue;
        const double whole = slots_[static_cast<std::size_t>(w.slot)];
        const double edge = ((w.factor > 0 ? whole + 1 : whole) - offsetOf(w.offset)) / w.factor;
        if (edge > least) next = std::min(next, edge);
    }
    return next;
}

std::size_t EventRun::rootCount() const { return model_.relations.size() + 2 * model_.wholes.size(); }

void EventRun::rootValues(const std::vector<double>& readings, double* values) const {
    for (std::size_t k = 0; k < model_.relations.size(); ++k) {
        const HybridModel::Relation& r = model_.relations[k];
        if (r.isOfTime || !r.isWatched) {
            values[k] = 1;
            continue;
        }
        const double difference = readings[static_cast<std::size_t>(r.reading)];
        const bool isAbove = (slots_[static_cast<std::size_t>(r.slot)] != 0) == isUpward(r.operation);
        values[k] = isAbove ? difference + hysteresis : difference - hysteresis;
    }
    for (std::size_t k = 0; k < model_.wholes.size(); ++k) {
        const HybridModel::Whole& w = model_.wholes[k];
        const double value = readings[static_cast<std::size_t>(w.reading)];
        const double slot = slots_[static_cast<std::size_t>(w.slot)];
        double* const to = values + model_.relations.size() + 2 * k;
        const double border = hysteresis * std::max(1.0, std::fabs(slot));
        const bool isCrossed = w.isWatched && !w.isOfTime;
        to[0] = isCrossed ? value - slot + border : 1;
        to[1] = isCrossed ? slot + 1 + border - value : 1;
    }
}

int EventRun::rates(double t, N_Vector y, N_Vector ydot, void* self) {
    auto& run = *static_cast<EventRun*>(self);
    if (run.n_ == 0) {
        N_VGetArrayPointer(ydot)[0] = 0;
        return 0;
    }
    run.takeDelayed(t);
    return run.system_.derivatives(run.workspace_, t, {N_VGetArrayPointer(y), run.n_}, run.u_,
                                   {N_VGetArrayPointer(ydot), run.n_})
               ? 0
               : 1;
}

int EventRun::tangentRates(int K, double t, N_Vector y, N_Vector, N_Vector* yS, N_Vector* ySdot, void* self,
                           N_Vector scratch, N_Vector) {
    auto& run = *static_cast<EventRun*>(self);
    run.takeDelayed(t);
    std::vector<double>&dx = run.dx_, &dxdot = run.dxdot_;
    for (int k = 0; k < K; ++k)
        for (std::size_t i = 0; i < run.n_; ++i)
            dx[i * static_cast<std::size_t>(K) + static_cast<std::size_t>(k)] = N_VGetArrayPointer(yS[k])[i];
    if (run.n_ > 0 && !run.tangents_->rates(t, {N_VGetArrayPointer(y), run.n_}, dx.data(), run.u_,
                                            {N_VGetArrayPointer(scratch), run.n_}, dxdot.data()))
        return 1;
    for (int k = 0; k < K; ++k) {
        if (run.n_ == 0) N_VGetArrayPointer(ySdot[k])[0] = 0;
        for (std::size_t i = 0; i < run.n_; ++i)
            N_VGetArrayPointer(ySdot[k])[i] = dxdot[i * static_cast<std::size_t>(K) + static_cast<std::size_t>(k)];
    }
    return 0;
}

/// The sensitivities as they are into the vectors of the integrator, or from where it has come to.
void EventRun::putTangents() {
    const auto K = static_cast<std::size_t>(tangents_->count());
    for (std::size_t k = 0; k < K; ++k)
        for (std::size_t i = 0; i < n_; ++i) (*sensitivities_)[static_cast<int>(k)][i] = tangents_->state()[i * K + k];
}

bool EventRun::takeTangents(double t) {
    if (!tangents_) return true;
    if (CVodeGetSensDky(cvodes_.get(), t, 0, sensitivities_->get()) != CV_SUCCESS) return hasNoTangent();
    const auto K = static_cast<std::size_t>(tangents_->count());
    for (std::size_t k = 0; k < K; ++k)
        for (std::size_t i = 0; i < n_; ++i) tangents_->state()[i * K + k] = (*sensitivities_)[static_cast<int>(k)][i];
    return true;
}

bool EventRun::setUpTangents() {
    if (!tangents_) return true;
    void* const memory = cvodes_.get();
    const int K = tangents_->count();
    dx_.resize(n_ * static_cast<std::size_t>(K));
    dxdot_.resize(dx_.size());
    sensitivities_ = std::make_unique<VectorArray>(y_.get(), K);
    VectorArray absolute(y_.get(), K);
    for (int k = 0; k < K; ++k)
        for (std::size_t i = 0; i < x_.size(); ++i) {
            (*sensitivities_)[k][i] = 0;
            absolute[k][i] = N_VGetArrayPointer(absolute_.get())[i] * 300 / scales_[static_cast<std::size_t>(k)];
        }
    putTangents();
    return CVodeSensInit(memory, K, CV_STAGGERED, tangentRates, sensitivities_->get()) == CV_SUCCESS &&
           CVodeSensSVtolerances(memory, 30 * options_.tolerance, absolute.get()) == CV_SUCCESS &&
           CVodeSetSensErrCon(memory, SUNTRUE) == CV_SUCCESS;
}

/// How far one goes along each direction until a parameter has doubled.
void EventRun::findScales() {
    const auto K = static_cast<std::size_t>(tangents_ ? tangents_->count() : 0);
    scales_.assign(K, 1);
    for (std::size_t k = 0; k < K; ++k) {
        double scale = 0;
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            if (const double part = std::fabs(tangents_->direction(static_cast<int>(i), static_cast<int>(k))); part > 0)
                scale = std::max(scale, std::fabs(parameters_[i]) / part);
        if (scale > 0) scales_[k] = scale;
    }
}

/// df/dx along all states at once, exact: of stiff circuits the rates are differences of large numbers, which quotients
/// of differences do not survive.
int EventRun::slopes(double t, N_Vector y, N_Vector, SUNMatrix to, void* self, N_Vector scratch, N_Vector, N_Vector) {
    auto& run = *static_cast<EventRun*>(self);
    const std::size_t n = run.n_;
    if (!run.hasSlopes_) {
        const std::vector<double> still(run.parameters_.size() * n);
        if (!run.system_.setParameters(run.slopes_, run.parameters_, still)) return 1;
        run.hasSlopes_ = true;
    }
    run.takeDelayed(t);
    if (!run.system_.derivatives(run.slopes_, t, {N_VGetArrayPointer(y), n}, run.along_, run.u_, {},
                                 {N_VGetArrayPointer(scratch), n}, run.jacobian_))
        return 1;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k)
            if (!std::isfinite(run.jacobian_[i * n + k])) return -1;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k)
            SM_ELEMENT_D(to, static_cast<sunindextype>(i), static_cast<sunindextype>(k)) = run.jacobian_[i * n + k];
    return 0;
}

/// The matrix of small models by themselves; else the integrator finds it by differences.
bool EventRun::setUpSlopes() {
    constexpr std::size_t most = 64;
    if (drive_ || n_ == 0 || n_ > most) return true;
    slopes_ = system_.workspace(static_cast<int>(n_));
    along_.assign(n_ * n_, 0);
    for (std::size_t i = 0; i < n_; ++i) along_[i * n_ + i] = 1;
    jacobian_.resize(n_ * n_);
    isExact_ = true;
    return CVodeSetJacFn(cvodes_.get(), slopes) == CV_SUCCESS;
}

int EventRun::roots(double t, N_Vector y, double* values, void* self) {
    auto& run = *static_cast<EventRun*>(self);
    if (!run.read(t, N_VGetArrayPointer(y), run.rootReadings_)) return -1;
    run.rootValues(run.rootReadings_, values);
    return 0;
}

bool EventRun::setUp() {
    SUNContext context{};
    if (SUNContext_Create(nullptr, &context) != 0) return false;
    context_.reset(context);
    const auto n = static_cast<sunindextype>(x_.size());
    rootReadings_.resize(readings_.size());
    y_.reset(N_VNew_Serial(n, context));
    std::copy(x_.begin(), x_.end(), N_VGetArrayPointer(y_.get()));
    matrix_.reset(SUNDenseMatrix(n, n, context));
    solver_.reset(SUNLinSol_Dense(y_.get(), matrix_.get(), context));
    cvodes_.reset(CVodeCreate(CV_BDF, context));
    void* const memory = cvodes_.get();
    if (!memory) return false;
    CVodeSetErrHandlerFn(
        memory, [](int, const char*, const char*, char*, void*) {}, nullptr);
    absolute_.reset(N_VClone(y_.get()));
    for (std::size_t i = 0; i < x_.size(); ++i) {
        const double nominal = i < n_ ? system_.states()[i].nominal : 1;
        N_VGetArrayPointer(absolute_.get())[i] = localShare * options_.tolerance * nominal * 1e-2;
    }
    bool ok = CVodeInit(memory, rates, time_, y_.get()) == CV_SUCCESS &&
              CVodeSVtolerances(memory, localShare * options_.tolerance, absolute_.get()) == CV_SUCCESS &&
              CVodeSetUserData(memory, this) == CV_SUCCESS &&
              CVodeSetLinearSolver(memory, solver_.get(), matrix_.get()) == CV_SUCCESS &&
              CVodeSetMaxErrTestFails(memory, 20) == CV_SUCCESS && CVodeSetMaxConvFails(memory, 30) == CV_SUCCESS &&
              CVodeSetMaxNumSteps(memory, -1) == CV_SUCCESS;
    if (ok && rootCount() > 0) {
        ok = CVodeRootInit(memory, static_cast<int>(rootCount()), roots) == CV_SUCCESS;
        CVodeSetNoInactiveRootWarn(memory);
    }
    // relations are looked at between steps
    double longest = (options_.stop - options_.start) / (rootCount() > 0 ? 500 : 50);
    for (const DelayHistory& delay : delays_) longest = std::min(longest, delay.delay());
    CVodeSetMaxStep(memory, longest);
    findScales();
    return ok && setUpSlopes() && setUpTangents();
}

bool EventRun::restart() {
    std::copy(x_.begin(), x_.end(), N_VGetArrayPointer(y_.get()));
    if (CVodeReInit(cvodes_.get(), time_, y_.get()) != CV_SUCCESS) return false;
    if (!tangents_) return true;
    putTangents();
    return CVodeSensReInit(cvodes_.get(), CV_STAGGERED, sensitivities_->get()) == CV_SUCCESS;
}

/// One step of the integrator, with the grid points within it, and the event at its end if there is one.
bool EventRun::advance(double interval) {
    const double kink = drive_ ? drive_->signals.nextStop() : never;
    const double known = drive_ && drive_->signals.isJumpNext() ? std::min(kink, nextTimeEvent()) : nextTimeEvent();
    const double stop = std::min({known, kink, options_.stop});
    const bool isKnown = known <= stop + 1e-13 * sizeOf(stop);
    if (!takeSlots()) return hasNoValue(system_.failure(workspace_));
    if (stop <= time_ + 1e-13 * sizeOf(time_)) {
        time_ = stop;
        return timeEvent(isKnown);
    }
    CVodeSetStopTime(cvodes_.get(), stop);
    double reached = time_;
    const int flag = CVode(cvodes_.get(), stop, y_.get(), &reached, CV_ONE_STEP);
    if ((++result_.steps & 63) == 0) {
        if (progress_.stopRequested()) return isStopped(phrase("cancelled"), true);
        if (secondsSince(began_) > options_.secondsLimit) return isStopped(phrase("time limit"), false);
    }
    if (flag < 0 && std::exchange(isExact_, false)) {
        // some way from the solution exact slopes can mislead where differences do not: on with these from here
        return CVodeSetJacFn(cvodes_.get(), nullptr) == CV_SUCCESS && restart();
    }
    if (flag < 0) {
        const std::string variable = system_.failure(workspace_);
        return failed(variable.empty() ? phrase("the integration does not go on")
                                       : phrase("the integration does not go on at '{}'", variable));
    }
    if (!rememberStep(time_, reached)) return false;
    for (;; ++grid_) {
        const double t = gridTime(interval);
        if (t >= reached || t >= options_.stop) break;
        if (CVodeGetDky(cvodes_.get(), t, 0, y_.get()) != CV_SUCCESS) break;
        std::copy_n(N_VGetArrayPointer(y_.get()), x_.size(), x_.begin());
        time_ = t;
        if (!takeTangents(t) || !(drive_ ? takeSample() : record())) return false;
    }
    CVodeGetDky(cvodes_.get(), reached, 0, y_.get());
    std::copy_n(N_VGetArrayPointer(y_.get()), x_.size(), x_.begin());
    time_ = reached;
    if (!drive_) path_.push_back({time_, x_, {}});
    if (!takeTangents(reached)) return false;
    if (flag == CV_ROOT_RETURN) {
        std::vector<int> found(rootCount());
        CVodeGetRootInfo(cvodes_.get(), found.data());
        std::set<int> crossed;
        for (std::size_t k = 0; k < found.size(); ++k)
            if (found[k] != 0) crossed.insert(static_cast<int>(k));
        return handle(crossed);
    }
    if (flag == CV_TSTOP_RETURN || time_ >= stop) {
        time_ = stop;
        return timeEvent(isKnown);
    }
    return true;
}

bool EventRun::timeEvent(bool isEvent) {
    const bool isStop = drive_ && drive_->signals.nextStop() <= time_ + 1e-13 * sizeOf(time_);
    if (!isEvent) {
        if (isStop) drive_->signals.passStop();
        return record() && (!isStop || restart());
    }
    for (std::size_t k = 0; k < model_.samples.size(); ++k)
        if (clocks_[k].next() <= time_ + 1e-13 * sizeOf(time_)) {
            pending_.push_back(model_.samples[k].slot);
            ++clocks_[k].count;
        }
    return handle({}, isStop);
}

bool EventRun::handle(const std::set<int>& crossed, bool isStop) {
    if (++result_.events > static_cast<long>(options_.mostEvents))
        return failed(phrase("more than {} events", options_.mostEvents));
    if (!record() || !beginTangents(crossed)) return false;  // as it was right before
    const std::vector<double> slots = slots_, x = x_;
    const bool isMoved = isStop || !crossed.empty() || !delays_.empty();
    if (isStop) drive_->signals.passStop();
    for (DelayHistory& delay : delays_) delay.arriveUpTo(time_);
    if (!model_.leftLimits.empty() && !read(time_, x_.data(), readings_))
        return hasNoValue(system_.failure(workspace_));
    for (const int slot : pending_) slots_[static_cast<std::size_t>(slot)] = 1;
    pending_.clear();
    if (!event(crossed) || !rememberEvent() || !record()) return false;
    if (tangents_ && !tangents_->end(point())) return hasNoTangent();
    if (time_ - lastEvent_ < 1e-10 * (options_.stop - options_.start)) {
        if (++crowded_ > 2000) return failed(phrase("events without end"));
    } else {
        crowded_ = 0;
    }
    lastEvent_ = time_;
    if (!areRatesDecided()) return false;
    if (!isMoved && x == x_ && isSameMotion(slots)) return true;  // what the integrator knows of the past still holds
    return restart() || failed(phrase("the integrator could not restart"));
}

/// Whether nothing has changed that the motion between events depends on.
bool EventRun::isSameMotion(const std::vector<double>& slots) const {
    for (std::size_t s = 0; s < slots.size(); ++s)
        if (model_.isRead[s] && slots[s] != slots_[s]) return false;
    return true;
}

}  // namespace analogon
