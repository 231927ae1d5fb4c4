#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/base/stopwatch.hpp"
#include "core/simulate/event_runner.hpp"

/// What happens at one time: the discrete quantities, until they keep still.
namespace analogon {

namespace {

constexpr int mostIterations = 200;  // of the discrete quantities at one time
constexpr int mostPasses = 5;        // to the next values before, without rest
bool holds(Operation operation, double difference) {
    switch (operation) {
        case Operation::Less:
            return difference < 0;
        case Operation::LessEqual:
            return difference <= 0;
        case Operation::Greater:
            return difference > 0;
        default:
            return difference >= 0;
    }
}

}  // namespace

/// What arrives at this time. Until the history begins: the signals themselves (takeStarts).
void EventRun::takeDelayed(double t) {
    if (drive_) drive_->signals.at(t, u_.data());
    for (std::size_t d = 0; d < delays_.size(); ++d) {
        const int input = delayedInputs_[d];
        if (input < 0 || delays_[d].isEmpty()) continue;  // nobody reads it
        u_[static_cast<std::size_t>(input)] = delays_[d].at(t);
        if (system_.needsInputDerivative())
            u_[static_cast<std::size_t>(system_.inputCount() + input)] = delays_[d].slopeAt(t);
    }
}

/// The readings at this time; at the start with the states that it finds.
bool EventRun::readNow(bool isInitial) {
    if (isInitial && n_ > 0 && !system_.initialise(workspace_, time_, u_, x_)) return false;
    return read(time_, x_.data(), readings_);
}

/// Before the run begins a delayed signal is what it is at the begin. Whether that has changed.
bool EventRun::takeStarts() {
    bool isNew = false;
    for (std::size_t d = 0; d < delays_.size(); ++d) {
        if (delayedInputs_[d] < 0 || !delays_[d].isEmpty()) continue;
        double& input = u_[static_cast<std::size_t>(delayedInputs_[d])];
        const double signal = readings_[static_cast<std::size_t>(model_.delays[d].reading)];
        isNew = isNew || !(std::fabs(input - signal) <= 1e-12 * std::max(1.0, std::fabs(signal)));
        input = signal;
    }
    return isNew;
}

/// The same where signals and what they were wait for each other, as on a line that sends its waves to and fro: a step
/// of Newton's method from the readings as they are.
bool EventRun::solveStarts(bool isInitial) {
    std::vector<std::size_t> inputs, readings;
    for (std::size_t d = 0; d < delays_.size(); ++d) {
        if (delayedInputs_[d] < 0 || !delays_[d].isEmpty()) continue;
        inputs.push_back(static_cast<std::size_t>(delayedInputs_[d]));
        readings.push_back(static_cast<std::size_t>(model_.delays[d].reading));
    }
    const auto count = static_cast<Eigen::Index>(inputs.size());
    Eigen::VectorXd lacking(count);
    for (Eigen::Index i = 0; i < count; ++i)
        lacking[i] = readings_[readings[static_cast<std::size_t>(i)]] - u_[inputs[static_cast<std::size_t>(i)]];
    const std::vector<double> held = u_, seen = readings_;
    Eigen::MatrixXd slope = Eigen::MatrixXd::Identity(count, count);
    for (Eigen::Index j = 0; j < count; ++j) {
        double& input = u_[inputs[static_cast<std::size_t>(j)]];
        const double step = 1e-6 * std::max(1.0, std::fabs(input));
        input += step;
        if (!readNow(isInitial)) return false;
        for (Eigen::Index i = 0; i < count; ++i) {
            const std::size_t r = readings[static_cast<std::size_t>(i)];
            slope(i, j) -= (readings_[r] - seen[r]) / step;
        }
        u_ = held;
    }
    // the smallest step where several will do
    const Eigen::VectorXd by = slope.completeOrthogonalDecomposition().solve(lacking);
    for (Eigen::Index i = 0; i < count; ++i) u_[inputs[static_cast<std::size_t>(i)]] += by[i];
    return readNow(isInitial);
}

/// The delayed signals as they are now, behind an event.
bool EventRun::rememberEvent() {
    if (delays_.empty()) return true;
    if (!takeSlots() || !read(time_, x_.data(), readings_)) return hasNoValue(system_.failure(workspace_));
    for (std::size_t d = 0; d < delays_.size(); ++d)
        delays_[d].addBehindEvent(time_, readings_[static_cast<std::size_t>(model_.delays[d].reading)]);
    return true;
}

/// The delayed signals over the step that was made, between which straight lines will do.
bool EventRun::rememberStep(double begin, double end) {
    constexpr int points = 8;
    for (int k = 1; k <= points && !delays_.empty(); ++k) {
        const double t = k == points ? end : begin + (end - begin) * k / points;
        if (CVodeGetDky(cvodes_.get(), t, 0, y_.get()) != CV_SUCCESS) continue;
        if (!read(t, N_VGetArrayPointer(y_.get()), readings_)) return hasNoValue(system_.failure(workspace_));
        for (std::size_t d = 0; d < delays_.size(); ++d)
            delays_[d].add(t, readings_[static_cast<std::size_t>(model_.delays[d].reading)]);
    }
    return true;
}

double EventRun::offsetOf(int step) const { return step >= 0 ? values_[static_cast<std::size_t>(step)] : 0; }

/// Relations and whole numbers from the readings; with memory where they lie on the border.
void EventRun::judge(const std::set<int>& crossed, bool isFirst, bool isSingle) {
    std::vector<std::size_t> switching;
    for (std::size_t k = 0; k < model_.relations.size(); ++k) {
        const HybridModel::Relation& r = model_.relations[k];
        double& slot = slots_[static_cast<std::size_t>(r.slot)];
        double difference = readings_[static_cast<std::size_t>(r.reading)];
        if (r.isOfTime) {
            // exact where it crosses, and then as right behind it
            const double zero = -offsetOf(r.offset) / r.factor;
            difference =
                time_ == zero || std::fabs(time_ - zero) < 2e-13 * sizeOf(zero) ? r.factor : r.factor * (time_ - zero);
            slot = holds(r.operation, difference);
            continue;
        }
        if (crossed.count(static_cast<int>(k))) {
            hasSwitched_[k] = 1;
            slot = slot == 0;
            continue;
        }
        double next = slot;
        // Exactly there the relation itself decides; but what it has just decided may be what brought it there, such
        // as a friction that begins to slide where another one still holds: both sides are then right.
        if (isFirst || (difference == 0 && !hasSwitched_[k]))
            next = holds(r.operation, difference);
        else if (std::fabs(difference) > hysteresis)
            next = (difference > 0) == isUpward(r.operation);
        if (next != slot) switching.push_back(k);
    }
    // Relations that wait for each other find no rest when all of them switch at once: then one after the other.
    if (isSingle && switching.size() > 1) {
        const auto later =
            std::find_if(switching.begin(), switching.end(), [&](std::size_t k) { return k > lastSwitched_; });
        switching = {later == switching.end() ? switching.front() : *later};
    }
    for (const std::size_t k : switching) {
        double& slot = slots_[static_cast<std::size_t>(model_.relations[k].slot)];
        slot = slot == 0;
        hasSwitched_[k] = 1;
        lastSwitched_ = k;
    }
    const int relations = static_cast<int>(model_.relations.size());
    for (std::size_t k = 0; k < model_.wholes.size(); ++k) {
        const HybridModel::Whole& w = model_.wholes[k];
        double& slot = slots_[static_cast<std::size_t>(w.slot)];
        double value = readings_[static_cast<std::size_t>(w.reading)];
        if (w.isOfTime) value += 1e-13 * std::max(1.0, std::fabs(value));
        const bool wasCrossed = crossed.count(relations + 2 * static_cast<int>(k)) ||
                                crossed.count(relations + 2 * static_cast<int>(k) + 1);
        const double border = hysteresis * std::max(1.0, std::fabs(value));
        if (isFirst || w.isOfTime || value < slot - border || value >= slot + 1 + border)
            slot = std::floor(value);
        else if (wasCrossed)
            slot = std::round(value) > slot ? slot + 1 : slot - 1;
    }
}

/// Ends the run; where a subscript has left its array, that is why.
bool EventRun::hasNoValue(const std::string& variable) {
    for (const HybridModel::Subscript& s : model_.subscripts) {
        if (values_.empty()) break;  // nothing was worked out yet
        const double index = values_[static_cast<std::size_t>(s.index)];
        if (index >= 1 && index <= s.extent) continue;
        faults_.push_back(error(phrase("at t = {:.6g} s: '{}' has no value: the subscript {} is outside 1:{}", time_,
                                       variable, index, s.extent),
                                s.span));
        faults_.back().isNumerical = true;
        return false;
    }
    return failed(phrase("'{}' has no value", variable));
}

/// As people know it: a relation by its text.
std::string EventRun::nameOf(int slot) const {
    for (const HybridModel::Relation& r : model_.relations)
        if (r.slot == slot && !r.text.empty()) return r.text;
    return model_.slots[static_cast<std::size_t>(slot)];
}

/// One look at the continuous quantities, and what the discrete ones become by it; `moved`: one that did.
bool EventRun::settleOnce(const std::set<int>& crossed, int round, bool isInitial, bool isStart, int& moved) {
    model_.program.update(slots_, readings_, time_, values_, isDue_);
    judge(round == 0 ? crossed : std::set<int>{}, isInitial && round < 20, round >= 10);
    model_.program.update(slots_, readings_, time_, values_, isDue_);
    for (const HybridModel::Assignment& a : model_.assignments) {
        double& slot = slots_[static_cast<std::size_t>(a.slot)];
        const double value = values_[static_cast<std::size_t>(a.step)];
        if (value != slot) moved = a.slot;
        slot = value;
        if (std::isnan(value) && isRound_ && !isStart) return hasNoValue(nameOf(moved));
    }
    return true;
}

/// At the start a branch that nobody could judge yet may have no value (a current that is divided by a voltage of 0):
/// then the other branches are tried.
void EventRun::turnRelations() {
    for (const HybridModel::Relation& r : model_.relations)
        if (double& slot = slots_[static_cast<std::size_t>(r.slot)]; !r.isOfTime) slot = slot == 0;
}

/// Continuous and discrete quantities in turn, until neither moves.
bool EventRun::settle(const std::set<int>& crossed, bool isInitial) {
    int moved = 0;
    bool isTurned = false;
    const std::vector<double> entry = slots_;
    hasSwitched_.assign(model_.relations.size(), 0);
    for (int round = 0; round < mostIterations; ++round) {
        const std::vector<double> before = slots_;
        if (!takeSlots()) return hasNoValue(system_.failure(workspace_));
        isRound_ = readNow(isInitial);
        bool isStart = isRound_ && takeStarts();
        if (isStart && round >= 5) {
            isRound_ = readNow(isInitial) && solveStarts(isInitial);
            isStart = isRound_ && takeStarts();
        }
        if (!isRound_ && round > 20) {
            if (!isInitial || std::exchange(isTurned, true)) return hasNoValue(system_.failure(workspace_));
            turnRelations();
            round = 0;
            continue;
        }
        if (!settleOnce(crossed, round, isInitial, isStart, moved)) return false;
        if (slots_ == before && isRound_ && !isStart)
            return !tangents_ || isInitial || tangents_->settled(point()) || hasNoTangent();
        if (round > 0 && slots_ != before) {
            for (std::size_t i = 0; i < slots_.size(); ++i)
                if (slots_[i] != before[i]) moved = static_cast<int>(i);
        }
    }
    if (!isInitial && passes_++ < mostPasses) return pass(entry, crossed, moved);
    return failed(phrase("the discrete quantities find no rest: '{}' keeps switching", nameOf(moved)));
}

/// Where no values agree with each other and with those before, as those of a clutch that lets go may not, what was
/// before moves on after one look: pre(z) = z then finds those that do.
bool EventRun::pass(const std::vector<double>& entry, const std::set<int>& crossed, int moved) {
    slots_ = entry;
    hasSwitched_.assign(model_.relations.size(), 0);
    isPassing_ = true;
    if (!takeSlots()) return hasNoValue(system_.failure(workspace_));
    isRound_ = readNow(false);
    return settleOnce(crossed, 0, false, false, moved);
}

/// Resets states where a reinit is in force; whether any was.
bool EventRun::reinitialise(bool& isDone) {
    isDone = false;
    for (const HybridModel::Reinit& r : model_.reinits) {
        if (values_[static_cast<std::size_t>(r.condition)] == 0) continue;
        const auto& states = system_.states();
        const auto state =
            std::find_if(states.begin(), states.end(), [&](const SignalInfo& s) { return s.name == r.variable; });
        if (state == states.end()) {
            faults_.push_back(error(phrase("reinit: '{}' is no state of the model", r.variable), r.span,
                                    phrase("reinit a variable that is differentiated, and that no equation ties to "
                                           "another state")));
            return false;
        }
        x_[static_cast<std::size_t>(state - states.begin())] = values_[static_cast<std::size_t>(r.value)];
        if (tangents_) tangents_->reset(static_cast<int>(state - states.begin()), r.value);
        isDone = true;
    }
    return true;
}

bool EventRun::check() {
    for (std::size_t k = 0; k < model_.checks.size(); ++k) {
        const HybridModel::Check& c = model_.checks[k];
        const bool value = values_[static_cast<std::size_t>(c.condition)] != 0;
        if (c.isTerminate) {
            if (value) isTerminated_ = true;
            continue;
        }
        if (value) continue;
        if (!c.isWarning) {
            faults_.push_back(error(phrase("at t = {:.6g} s: {}", time_, c.message), c.span,
                                    phrase("the condition of 'assert' does not hold")));
            faults_.back().isNumerical = true;
            return false;
        }
        if (warned_.insert(k).second)
            result_.remarks.push_back(warning(phrase("at t = {:.6g} s: {}", time_, c.message), c.span));
    }
    return true;
}

/// Everything that happens at this time, until pre(z) = z.
bool EventRun::event(const std::set<int>& crossed) {
    std::set<int> first = crossed;
    passes_ = 0;
    if (tangents_) tangents_->takeLeftLimits();
    for (const auto& [before, reading] : model_.leftLimits)
        slots_[static_cast<std::size_t>(before)] = readings_[static_cast<std::size_t>(reading)];
    for (int round = 0; round < mostIterations; ++round) {
        if (!settle(first, false)) return false;
        first.clear();
        if (!isPassing_ && !check()) return false;
        bool isReset = false;
        if (!reinitialise(isReset)) return false;
        bool moved = isReset || std::exchange(isPassing_, false);
        for (const HybridModel::Sample& s : model_.samples) {
            moved = moved || slots_[static_cast<std::size_t>(s.slot)] != 0;
            slots_[static_cast<std::size_t>(s.slot)] = 0;
        }
        int last = 0;
        for (const auto& [before, of] : model_.pres) {
            double& old = slots_[static_cast<std::size_t>(before)];
            const double now = slots_[static_cast<std::size_t>(of)];
            if (old != now) {
                moved = true;
                last = of;
            }
            old = now;
        }
        if (tangents_) tangents_->shift();
        if (tangents_ && !isReset) tangents_->takeLeftLimits();
        for (const auto& [before, reading] : model_.leftLimits)
            if (!isReset) slots_[static_cast<std::size_t>(before)] = readings_[static_cast<std::size_t>(reading)];
        if (!moved) return true;
        if (round + 1 == mostIterations)
            return failed(phrase("the event finds no end: '{}' keeps switching", nameOf(last)));
    }
    return true;
}

bool EventRun::initialise() {
    if (model_.initial >= 0) slots_[static_cast<std::size_t>(model_.initial)] = 1;
    // twice: what is assigned at the start may read what the start decides
    for (int round = 0; round < 2; ++round) {
        model_.program.update(slots_, readings_, time_, values_, isDue_);
        for (const HybridModel::Assignment& a : model_.initialAssignments) {
            const double value = values_[static_cast<std::size_t>(a.step)];
            if (round > 0 || std::isfinite(value)) slots_[static_cast<std::size_t>(a.slot)] = value;
        }
        if (!settle({}, true)) return false;
    }
    if (tangents_ && !tangents_->start(point(), true)) return hasNoTangent();
    if (!startClocks()) return false;
    if (model_.initial >= 0) slots_[static_cast<std::size_t>(model_.initial)] = 0;
    for (const auto& [before, of] : model_.pres)
        slots_[static_cast<std::size_t>(before)] = slots_[static_cast<std::size_t>(of)];
    // sample() is false while the start is found, and true in the first event behind it (section 3.7.5)
    for (std::size_t k = 0; k < clocks_.size(); ++k)
        if (clocks_[k].next() <= time_) {
            slots_[static_cast<std::size_t>(model_.samples[k].slot)] = 1;
            ++clocks_[k].count;
        }
    if (tangents_) tangents_->shift();
    if (!beginTangents({}) || !event({}) || !rememberEvent()) return false;
    if (tangents_ && !tangents_->end(point())) return hasNoTangent();
    return drive_ ? takeSample() : record();
}

}  // namespace analogon
