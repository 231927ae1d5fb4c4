#include "core/simulate/event_run.hpp"

#include <fmt/format.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <unordered_map>

#include "core/base/stopwatch.hpp"
#include "core/eval/rank_deficient.hpp"
#include "core/simulate/delay_history.hpp"
#include "core/simulate/recorded_drive.hpp"
#include "core/simulate/sundials_owner.hpp"

namespace analogon {
namespace {

constexpr double localShare = 0.1;    // of the tolerance, for one step
constexpr double hysteresis = 1e-10;  // of a relation, beside the sizes that it compares
constexpr int mostIterations = 200;   // of the discrete quantities at one time
constexpr double never = std::numeric_limits<double>::infinity();

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
bool isUpward(Operation operation) { return operation == Operation::Greater || operation == Operation::GreaterEqual; }

/// A sample: when it came, and how often.
struct Clock {
    double start{}, interval{}, count{};
    double next() const { return start + count * interval; }
};

class EventRun {
public:
    EventRun(const HybridModel& model, const System& system, const std::vector<std::string>& names,
             const EventRunOptions& options, const Progress& progress, RecordedDrive* drive = nullptr)
        : model_(model),
          system_(system),
          names_(names),
          options_(options),
          progress_(progress),
          drive_(drive),
          tangents_(drive ? drive->tangents : nullptr),
          workspace_(system.workspace(0)),
          n_(static_cast<std::size_t>(system.stateCount())),
          slots_(model.starts),
          readings_(model.readings.size()),
          x_(std::max<std::size_t>(1, n_)),
          u_(static_cast<std::size_t>(system.slotCount())),
          began_(std::chrono::steady_clock::now()) {
        std::unordered_map<std::string, int> slotOf;
        for (std::size_t i = 0; i < model.slots.size(); ++i) slotOf.emplace(model.slots[i], static_cast<int>(i));
        std::vector<std::string> observed;
        for (const std::string& name : names) {
            const auto slot = slotOf.find(name);
            source_.emplace_back(slot == slotOf.end() ? -1 : slot->second, static_cast<int>(observed.size()));
            if (slot == slotOf.end()) observed.push_back(name);
        }
        handles_ = system.observe(observed);
        for (const std::string& slot : model.slots) slotAt_.push_back(system.parameterIndex(slot));
        for (const std::string& reading : model.readings) readingAt_.push_back(system.outputIndex(reading));
        parameters_.resize(static_cast<std::size_t>(system.parameterCount()));
        if (drive) parameters_ = drive->parameters;
        outputs_.resize(static_cast<std::size_t>(system.outputCount()));
        for (const HybridModel::Delay& delay : model.delays) {
            delays_.emplace_back(delay.time);
            delayedInputs_.push_back(system.inputIndex(delay.input));
        }
    }

    Outcome<EventTrajectory> run() {
        time_ = options_.start;
        if (!initialise()) return faults_;
        if (!setUp()) return fail(phrase("the integrator could not be set up"));
        if (!areRatesDecided()) return faults_;
        const double interval = rowInterval();
        grid_ = 1;
        if (isTerminated_) return std::move(result_);
        while (time_ < options_.stop) {
            if (drive_) drive_->reached = time_;
            if (!advance(interval)) return faults_;
            if (isTerminated_) break;
        }
        if (drive_) return takeLastSamples() ? Outcome<EventTrajectory>(std::move(result_)) : faults_;
        if (!isTerminated_ && model_.terminal >= 0) {
            slots_[static_cast<std::size_t>(model_.terminal)] = 1;
            if (!event({})) return faults_;
        }
        tellUndecided();
        return std::move(result_);
    }

private:
    /// As asked for, and not so wide that what the rows show between events would be lost.
    double rowInterval() const {
        constexpr double fewest = 2500;
        const double whole = options_.stop - options_.start;
        if (!(options_.interval > 0)) return whole / fewest;
        return options_.interval / std::max(1.0, std::ceil(fewest * options_.interval / whole));
    }

    /// Whatever the equations leave open must not reach the states: there it would decide how the model moves.
    bool areRatesDecided() {
        if (undecided_.names.empty() || n_ == 0) return true;
        if (!takeSlots()) return hasNoValue(system_.failure(workspace_));
        takeDelayed(time_);
        std::vector<double> smallest(n_), other(n_);
        if (!system_.derivatives(workspace_, time_, {x_.data(), n_}, u_, smallest))
            return hasNoValue(system_.failure(workspace_));
        undecided_.shift = 1;
        const bool isRound = system_.derivatives(workspace_, time_, {x_.data(), n_}, u_, other);
        undecided_.shift = 0;
        for (std::size_t i = 0; i < n_; ++i)
            if (!isRound || std::fabs(other[i] - smallest[i]) > 1e-9 * (1 + std::fabs(smallest[i])))
                return failed(phrase("the equations leave '{}' open, and '{}' depends on it", *undecided_.names.begin(),
                                     system_.states()[i].name));
        return true;
    }

    void tellUndecided() {
        if (undecided_.names.empty()) return;
        const std::vector<std::string> names(undecided_.names.begin(), undecided_.names.end());
        result_.remarks.push_back(
            warning(phrase("the equations leave {} open for a time, since they repeat each "
                           "other: the smallest values are taken",
                           fmt::format("'{}'", fmt::join(names, "', '")))));
    }

    Diagnostics fail(Text message, Text hint = {}) {
        if (drive_) drive_->reached = time_;
        faults_.push_back(numericalError(phrase("at t = {:.6g} s: {}", time_, message), std::move(hint)));
        return faults_;
    }
    bool failed(Text message, Text hint = {}) {
        fail(std::move(message), std::move(hint));
        return false;
    }

    // ------------------------------------------------------------------------------------------ the model as it is

    bool takeSlots() {
        if (taken_ == slots_ && !taken_.empty()) return true;
        taken_ = slots_;
        for (std::size_t s = 0; s < slots_.size(); ++s)
            if (slotAt_[s] >= 0) parameters_[static_cast<std::size_t>(slotAt_[s])] = slots_[s];
        return system_.setParameters(workspace_, parameters_);
    }

    bool read(double t, const double* x, std::vector<double>& readings) {
        takeDelayed(t);
        if (!system_.outputs(workspace_, t, {x, n_}, u_, outputs_)) return false;
        for (std::size_t r = 0; r < readings.size(); ++r)
            readings[r] = outputs_[static_cast<std::size_t>(readingAt_[r])];
        return true;
    }

    // ------------------------------------------------------------------------------------------------- a recording

    EventPoint point() {
        inputRates_.assign(u_.size(), 0);
        if (drive_) drive_->signals.slopes(time_, inputRates_.data());
        return {time_, {x_.data(), n_}, u_, inputRates_, parameters_, slots_, readings_, values_};
    }

    bool takeSample() {
        if (!takeSlots() || !read(time_, x_.data(), readings_)) return hasNoValue(system_.failure(workspace_));
        if (!drive_->take(static_cast<int>(grid_), point(), workspace_, outputs_))
            return hasNoValue(system_.failure(workspace_));
        return true;
    }

    /// Those at the end, and what a model that ended before would have shown.
    bool takeLastSamples() {
        const auto count = static_cast<long>(drive_->signals.time().size());
        if (isTerminated_ && grid_ + 1 < count) return failed(phrase("the model ends the simulation"));
        for (; grid_ < count; ++grid_)
            if (!takeSample()) return false;
        return true;
    }

    double gridTime(double interval) const {
        if (!drive_) return options_.start + static_cast<double>(grid_) * interval;
        const std::vector<double>& time = drive_->signals.time();
        return grid_ < static_cast<long>(time.size()) ? time[static_cast<std::size_t>(grid_)] : never;
    }

    bool isStopped(Text reason, bool isCancelled) {
        if (drive_) (isCancelled ? drive_->isCancelled : drive_->isTooLong) = true;
        return failed(std::move(reason));
    }

    bool hasNoTangent() { return failed(phrase("the sensitivities are not finite")); }

    /// The tangents up to an event; by what it is known.
    bool beginTangents(const std::set<int>& crossed) {
        if (!tangents_) return true;
        if (!takeSlots() || !read(time_, x_.data(), readings_)) return hasNoValue(system_.failure(workspace_));
        model_.program.run(slots_, readings_, time_, values_);
        return tangents_->begin(point(), momentOf(crossed)) || hasNoTangent();
    }

    EventMoment momentOf(const std::set<int>& crossed) const {
        const auto isNow = [&](double t) { return std::fabs(t - time_) < 1e-12 * std::max(1.0, std::fabs(time_)); };
        const auto relations = static_cast<int>(model_.relations.size());
        for (const int k : crossed)
            return {k < relations ? model_.relations[static_cast<std::size_t>(k)].reading
                                  : model_.wholes[static_cast<std::size_t>(k - relations) / 2].reading};
        for (const HybridModel::Relation& r : model_.relations)
            if (r.isOfTime && isNow(-offsetOf(r.offset) / r.factor)) return {-1, r.offset, r.factor};
        for (const HybridModel::Whole& w : model_.wholes) {
            const double value = w.factor * time_ + offsetOf(w.offset);
            if (w.isOfTime && isNow(time_ + (std::round(value) - value) / w.factor)) return {-1, w.offset, w.factor};
        }
        for (std::size_t k = 0; k < pending_.size() && !clockTangents_.empty(); ++k)
            for (std::size_t c = 0; c < clocks_.size(); ++c)
                if (model_.samples[c].slot == pending_[k]) {
                    EventMoment moment;
                    for (std::size_t j = 0; j < clockTangents_[c].first.size(); ++j)
                        moment.given.push_back(clockTangents_[c].first[j] +
                                               (clocks_[c].count - 1) * clockTangents_[c].second[j]);
                    return moment;
                }
        return {};
    }

    // ---------------------------------------------------------------------------------------------- delayed signals

    /// What arrives at this time. Until the history begins: the signals themselves (takeStarts).
    void takeDelayed(double t) {
        if (drive_) drive_->signals.at(t, u_.data());
        for (std::size_t d = 0; d < delays_.size(); ++d) {
            const int input = delayedInputs_[d];
            if (input < 0 || delays_[d].isEmpty()) continue;  // nobody reads it
            u_[static_cast<std::size_t>(input)] = delays_[d].at(t);
            if (system_.needsInputDerivative())
                u_[static_cast<std::size_t>(system_.inputCount() + input)] = delays_[d].slopeAt(t);
        }
    }

    /// Before the run begins a delayed signal is what it is at the begin. Whether that has changed.
    bool takeStarts() {
        bool isNew = false;
        for (std::size_t d = 0; d < delays_.size(); ++d) {
            if (delayedInputs_[d] < 0 || !delays_[d].isEmpty()) continue;
            double& input = u_[static_cast<std::size_t>(delayedInputs_[d])];
            isNew = isNew || input != readings_[static_cast<std::size_t>(model_.delays[d].reading)];
            input = readings_[static_cast<std::size_t>(model_.delays[d].reading)];
        }
        return isNew;
    }

    /// The delayed signals as they are now, behind an event.
    bool rememberEvent() {
        if (delays_.empty()) return true;
        if (!takeSlots() || !read(time_, x_.data(), readings_)) return hasNoValue(system_.failure(workspace_));
        for (std::size_t d = 0; d < delays_.size(); ++d)
            delays_[d].addBehindEvent(time_, readings_[static_cast<std::size_t>(model_.delays[d].reading)]);
        return true;
    }

    /// The delayed signals over the step that was made, between which straight lines will do.
    bool rememberStep(double begin, double end) {
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

    double offsetOf(int step) const { return step >= 0 ? values_[static_cast<std::size_t>(step)] : 0; }

    /// Relations and whole numbers from the readings; with memory where they lie on the border.
    void judge(const std::set<int>& crossed, bool isFirst, bool isSingle) {
        std::vector<std::size_t> switching;
        for (std::size_t k = 0; k < model_.relations.size(); ++k) {
            const HybridModel::Relation& r = model_.relations[k];
            double& slot = slots_[static_cast<std::size_t>(r.slot)];
            double difference = readings_[static_cast<std::size_t>(r.reading)];
            if (r.isOfTime) {
                // exact where it crosses, and then as right behind it
                const double zero = -offsetOf(r.offset) / r.factor;
                difference = time_ == zero || std::fabs(time_ - zero) < 2e-13 * std::max(1.0, std::fabs(zero))
                                 ? r.factor
                                 : r.factor * (time_ - zero);
                slot = holds(r.operation, difference);
                continue;
            }
            if (crossed.count(static_cast<int>(k))) {
                slot = slot == 0;
                continue;
            }
            double next = slot;
            if (isFirst || difference == 0)  // exactly there the relation itself decides
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
    bool hasNoValue(const std::string& variable) {
        for (const HybridModel::Subscript& s : model_.subscripts) {
            if (values_.empty()) break;  // nothing was worked out yet
            const double index = values_[static_cast<std::size_t>(s.index)];
            if (index >= 1 && index <= s.extent) continue;
            faults_.push_back(error(phrase("at t = {:.6g} s: '{}' has no value: the subscript {} is outside 1:{}",
                                           time_, variable, index, s.extent),
                                    s.span));
            faults_.back().isNumerical = true;
            return false;
        }
        return failed(phrase("'{}' has no value", variable));
    }

    void name(std::string& changed, int slot) { changed = model_.slots[static_cast<std::size_t>(slot)]; }

    /// Continuous and discrete quantities in turn, until neither moves.
    bool settle(const std::set<int>& crossed, bool isInitial) {
        std::string changed;
        for (int round = 0; round < mostIterations; ++round) {
            const std::vector<double> before = slots_;
            if (!takeSlots()) return hasNoValue(system_.failure(workspace_));
            if (isInitial && n_ > 0 && !system_.initialise(workspace_, time_, u_, x_))
                isRound_ = false;
            else
                isRound_ = read(time_, x_.data(), readings_);
            const bool isStart = isRound_ && takeStarts();
            if (!isRound_ && round > 20) return hasNoValue(system_.failure(workspace_));
            model_.program.run(slots_, readings_, time_, values_);
            judge(round == 0 ? crossed : std::set<int>{}, isInitial && round < 20, round >= 10);
            model_.program.run(slots_, readings_, time_, values_);
            for (const HybridModel::Assignment& a : model_.assignments) {
                double& slot = slots_[static_cast<std::size_t>(a.slot)];
                const double value = values_[static_cast<std::size_t>(a.step)];
                if (value != slot) name(changed, a.slot);
                slot = value;
                if (std::isnan(value) && isRound_ && !isStart) return hasNoValue(changed);
            }
            if (slots_ == before && isRound_ && !isStart)
                return !tangents_ || isInitial || tangents_->settled(point()) || hasNoTangent();
            if (round > 0 && slots_ != before) {
                for (std::size_t i = 0; i < slots_.size(); ++i)
                    if (slots_[i] != before[i]) changed = model_.slots[i];
            }
        }
        return failed(phrase("the discrete quantities find no rest: '{}' keeps switching", changed));
    }

    /// Resets states where a reinit is in force; whether any was.
    bool reinitialise(bool& isDone) {
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

    bool check() {
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
    bool event(const std::set<int>& crossed) {
        std::set<int> first = crossed;
        if (tangents_) tangents_->takeLeftLimits();
        for (const auto& [before, reading] : model_.leftLimits)
            slots_[static_cast<std::size_t>(before)] = readings_[static_cast<std::size_t>(reading)];
        for (int round = 0; round < mostIterations; ++round) {
            if (!settle(first, false)) return false;
            first.clear();
            if (!check()) return false;
            bool isReset = false;
            if (!reinitialise(isReset)) return false;
            bool moved = isReset;
            for (const HybridModel::Sample& s : model_.samples) {
                moved = moved || slots_[static_cast<std::size_t>(s.slot)] != 0;
                slots_[static_cast<std::size_t>(s.slot)] = 0;
            }
            std::string changed;
            for (const auto& [before, of] : model_.pres) {
                double& old = slots_[static_cast<std::size_t>(before)];
                const double now = slots_[static_cast<std::size_t>(of)];
                if (old != now) {
                    moved = true;
                    name(changed, of);
                }
                old = now;
            }
            if (tangents_) tangents_->shift();
            if (tangents_ && !isReset) tangents_->takeLeftLimits();
            for (const auto& [before, reading] : model_.leftLimits)
                if (!isReset) slots_[static_cast<std::size_t>(before)] = readings_[static_cast<std::size_t>(reading)];
            if (!moved) return true;
            if (round + 1 == mostIterations)
                return failed(phrase("the event finds no end: '{}' keeps switching", changed));
        }
        return true;
    }

    bool initialise() {
        if (model_.initial >= 0) slots_[static_cast<std::size_t>(model_.initial)] = 1;
        // twice: what is assigned at the start may read what the start decides
        for (int round = 0; round < 2; ++round) {
            model_.program.run(slots_, readings_, time_, values_);
            for (const HybridModel::Assignment& a : model_.initialAssignments)
                slots_[static_cast<std::size_t>(a.slot)] = values_[static_cast<std::size_t>(a.step)];
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

    // ----------------------------------------------------------------------------------------------- integration

    /// When each sample comes, by what the start has found.
    bool startClocks() {
        for (const HybridModel::Sample& sample : model_.samples) {
            Clock clock{values_[static_cast<std::size_t>(sample.start)],
                        values_[static_cast<std::size_t>(sample.interval)], 0};
            if (!(clock.interval > 0) || !std::isfinite(clock.start)) {
                faults_.push_back(
                    error(phrase("'sample' begins at {} s with an interval of {} s: it needs a number and "
                                 "an interval above 0",
                                 clock.start, clock.interval),
                          sample.span));
                return false;
            }
            clock.count = std::max(0.0, std::ceil((options_.start - clock.start) / clock.interval - 1e-9));
            clocks_.push_back(clock);
            if (tangents_)
                clockTangents_.emplace_back(tangents_->ofStep(sample.start), tangents_->ofStep(sample.interval));
        }
        return true;
    }

    /// The next time at which something happens that is known in advance.
    double nextTimeEvent() const {
        double next = never;
        for (const Clock& clock : clocks_) next = std::min(next, clock.next());
        for (const DelayHistory& delay : delays_) next = std::min(next, delay.nextArrival());
        const double least = time_ + 2e-13 * std::max(1.0, std::fabs(time_));
        for (const HybridModel::Relation& r : model_.relations) {
            if (!r.isOfTime) continue;
            const double zero = -offsetOf(r.offset) / r.factor;
            if (zero > least) next = std::min(next, zero);
        }
        for (const HybridModel::Whole& w : model_.wholes) {
            if (!w.isOfTime) continue;
            const double whole = slots_[static_cast<std::size_t>(w.slot)];
            const double edge = ((w.factor > 0 ? whole + 1 : whole) - offsetOf(w.offset)) / w.factor;
            if (edge > least) next = std::min(next, edge);
        }
        return next;
    }

    std::size_t rootCount() const { return model_.relations.size() + 2 * model_.wholes.size(); }

    void rootValues(const std::vector<double>& readings, double* values) const {
        for (std::size_t k = 0; k < model_.relations.size(); ++k) {
            const HybridModel::Relation& r = model_.relations[k];
            if (r.isOfTime) {
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
            to[0] = w.isOfTime ? 1 : value - slot + border;
            to[1] = w.isOfTime ? 1 : slot + 1 + border - value;
        }
    }

    static int rates(double t, N_Vector y, N_Vector ydot, void* self) {
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
    static int tangentRates(int K, double t, N_Vector y, N_Vector, N_Vector* yS, N_Vector* ySdot, void* self,
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
    void putTangents() {
        const auto K = static_cast<std::size_t>(tangents_->count());
        for (std::size_t k = 0; k < K; ++k)
            for (std::size_t i = 0; i < n_; ++i)
                (*sensitivities_)[static_cast<int>(k)][i] = tangents_->state()[i * K + k];
    }
    bool takeTangents(double t) {
        if (!tangents_) return true;
        if (CVodeGetSensDky(cvodes_.get(), t, 0, sensitivities_->get()) != CV_SUCCESS) return hasNoTangent();
        const auto K = static_cast<std::size_t>(tangents_->count());
        for (std::size_t k = 0; k < K; ++k)
            for (std::size_t i = 0; i < n_; ++i)
                tangents_->state()[i * K + k] = (*sensitivities_)[static_cast<int>(k)][i];
        return true;
    }

    bool setUpTangents() {
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
    void findScales() {
        const auto K = static_cast<std::size_t>(tangents_ ? tangents_->count() : 0);
        scales_.assign(K, 1);
        for (std::size_t k = 0; k < K; ++k) {
            double scale = 0;
            for (std::size_t i = 0; i < parameters_.size(); ++i)
                if (const double part = std::fabs(tangents_->direction(static_cast<int>(i), static_cast<int>(k)));
                    part > 0)
                    scale = std::max(scale, std::fabs(parameters_[i]) / part);
            if (scale > 0) scales_[k] = scale;
        }
    }

    static int roots(double t, N_Vector y, double* values, void* self) {
        auto& run = *static_cast<EventRun*>(self);
        if (!run.read(t, N_VGetArrayPointer(y), run.rootReadings_)) return -1;
        run.rootValues(run.rootReadings_, values);
        return 0;
    }

    bool setUp() {
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
        return ok && setUpTangents();
    }

    bool restart() {
        std::copy(x_.begin(), x_.end(), N_VGetArrayPointer(y_.get()));
        if (CVodeReInit(cvodes_.get(), time_, y_.get()) != CV_SUCCESS) return false;
        if (!tangents_) return true;
        putTangents();
        return CVodeSensReInit(cvodes_.get(), CV_STAGGERED, sensitivities_->get()) == CV_SUCCESS;
    }

    /// One step of the integrator, with the grid points within it, and the event at its end if there is one.
    bool advance(double interval) {
        const double kink = drive_ ? drive_->signals.nextStop() : never;
        const double known = drive_ && drive_->signals.isJumpNext() ? std::min(kink, nextTimeEvent()) : nextTimeEvent();
        const double stop = std::min({known, kink, options_.stop});
        const bool isKnown = known <= stop + 1e-13 * std::max(1.0, std::fabs(stop));
        if (!takeSlots()) return hasNoValue(system_.failure(workspace_));
        if (stop <= time_ + 1e-13 * std::max(1.0, std::fabs(time_))) {
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

    bool timeEvent(bool isEvent) {
        const bool isStop = drive_ && drive_->signals.nextStop() <= time_ + 1e-13 * std::max(1.0, std::fabs(time_));
        if (!isEvent) {
            if (isStop) drive_->signals.passStop();
            return record() && (!isStop || restart());
        }
        for (std::size_t k = 0; k < model_.samples.size(); ++k)
            if (clocks_[k].next() <= time_ + 1e-13 * std::max(1.0, std::fabs(time_))) {
                pending_.push_back(model_.samples[k].slot);
                ++clocks_[k].count;
            }
        return handle({}, isStop);
    }

    bool handle(const std::set<int>& crossed, bool isStop = false) {
        if (++result_.events > static_cast<long>(options_.mostEvents))
            return failed(phrase("more than {} events", options_.mostEvents));
        if (!record() || !beginTangents(crossed)) return false;  // as it was right before
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
        return restart() || failed(phrase("the integrator could not restart"));
    }

    bool checkHere() {
        if (model_.checks.empty() && model_.subscripts.empty()) return true;
        if (!read(time_, x_.data(), readings_)) return hasNoValue(system_.failure(workspace_));
        model_.program.run(slots_, readings_, time_, values_);
        return check();
    }

    bool record() {
        if (!takeSlots()) return hasNoValue(system_.failure(workspace_));
        takeDelayed(time_);
        if (drive_) return checkHere();
        std::vector<double> observed(handles_.size());
        if (!system_.observed(workspace_, time_, {x_.data(), n_}, u_, handles_, observed))
            return hasNoValue(system_.failure(workspace_));
        if (!checkHere()) return false;
        std::vector<double> row(source_.size());
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = source_[i].first >= 0 ? slots_[static_cast<std::size_t>(source_[i].first)]
                                           : observed[static_cast<std::size_t>(source_[i].second)];
        if (!model_.subscripts.empty())
            for (std::size_t i = 0; i < row.size(); ++i)
                if (std::isnan(row[i])) return hasNoValue(names_[i]);
        result_.time.push_back(time_);
        result_.rows.push_back(std::move(row));
        return true;
    }

    const HybridModel& model_;
    const System& system_;
    const std::vector<std::string>& names_;
    const EventRunOptions& options_;
    const Progress& progress_;
    RecordedDrive* drive_;     // null: a class by itself
    EventTangents* tangents_;  // null: none
    Workspace workspace_;
    std::size_t n_;
    std::vector<double> slots_, readings_, rootReadings_, x_, u_, values_, taken_;
    std::vector<std::pair<int, int>> source_;  // by name: slot, or -1 and which of the observed
    std::vector<int> handles_;
    std::vector<int> slotAt_, readingAt_;  // parameter, output of the system
    std::vector<double> parameters_, outputs_, inputRates_, scales_, dx_, dxdot_;
    std::vector<std::pair<std::vector<double>, std::vector<double>>> clockTangents_;  // of start and interval
    std::vector<Clock> clocks_;                                                       // by sample
    std::vector<DelayHistory> delays_;
    std::vector<int> delayedInputs_;  // by delay; -1: nobody reads it
    std::size_t lastSwitched_{};      // relation
    std::vector<int> pending_;        // samples that come true at this event
    std::set<std::size_t> warned_;
    UndecidedScope undecided_;
    EventTrajectory result_;
    Diagnostics faults_;
    double time_{}, lastEvent_{-never};
    long grid_{};
    int crowded_{};
    bool isTerminated_{}, isRound_{};
    std::chrono::steady_clock::time_point began_;
    Owned<SUNContext, FreeContext> context_;
    Owned<N_Vector, FreeVector> y_;
    Owned<N_Vector, FreeVector> absolute_;
    Owned<SUNMatrix, FreeMatrix> matrix_;
    Owned<SUNLinearSolver, FreeSolver> solver_;
    std::unique_ptr<VectorArray> sensitivities_;
    std::unique_ptr<void, FreeCvodes> cvodes_;
};

}  // namespace

Outcome<EventTrajectory> simulateWithEvents(const HybridModel& model, const System& system,
                                            const std::vector<std::string>& names, const EventRunOptions& options,
                                            const Progress& progress) {
    return EventRun(model, system, names, options, progress).run();
}

Outcome<EventTrajectory> simulateRecorded(const HybridModel& model, const System& system, RecordedDrive& drive,
                                          const EventRunOptions& options, const Progress& progress) {
    const std::vector<std::string> none;
    return EventRun(model, system, none, options, progress, &drive).run();
}

}  // namespace analogon
