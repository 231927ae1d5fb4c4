#include "core/simulate/event_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/stopwatch.hpp"
#include "core/simulate/event_runner.hpp"

namespace analogon {

EventRun::EventRun(const HybridModel& model, const System& system, const std::vector<std::string>& names,
                   const EventRunOptions& options, const Progress& progress, RecordedDrive* drive)
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

Outcome<EventTrajectory> EventRun::run() {
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

/// Whatever the equations leave open must not reach the states: there it would decide how the model moves.
bool EventRun::areRatesDecided() {
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

void EventRun::tellUndecided() {
    if (undecided_.names.empty()) return;
    const std::vector<std::string> names(undecided_.names.begin(), undecided_.names.end());
    result_.remarks.push_back(
        warning(phrase("the equations leave {} open for a time, since they repeat each "
                       "other: the smallest values are taken",
                       fmt::format("'{}'", fmt::join(names, "', '")))));
}

Diagnostics EventRun::fail(Text message, Text hint) {
    if (drive_) drive_->reached = time_;
    faults_.push_back(numericalError(phrase("at t = {:.6g} s: {}", time_, message), std::move(hint)));
    return faults_;
}

bool EventRun::failed(Text message, Text hint) {
    fail(std::move(message), std::move(hint));
    return false;
}

bool EventRun::takeSlots() {
    if (taken_ == slots_ && !taken_.empty()) return true;
    taken_ = slots_;
    hasSlopes_ = false;
    for (std::size_t s = 0; s < slots_.size(); ++s)
        if (slotAt_[s] >= 0) parameters_[static_cast<std::size_t>(slotAt_[s])] = slots_[s];
    return system_.setParameters(workspace_, parameters_);
}

bool EventRun::read(double t, const double* x, std::vector<double>& readings) {
    takeDelayed(t);
    if (!system_.outputs(workspace_, t, {x, n_}, u_, outputs_)) return false;
    for (std::size_t r = 0; r < readings.size(); ++r) readings[r] = outputs_[static_cast<std::size_t>(readingAt_[r])];
    return true;
}

EventPoint EventRun::point() {
    inputRates_.assign(u_.size(), 0);
    if (drive_) drive_->signals.slopes(time_, inputRates_.data());
    return {time_, {x_.data(), n_}, u_, inputRates_, parameters_, slots_, readings_, values_};
}

bool EventRun::takeSample() {
    if (!takeSlots() || !read(time_, x_.data(), readings_)) return hasNoValue(system_.failure(workspace_));
    if (!drive_->take(static_cast<int>(grid_), point(), workspace_, outputs_))
        return hasNoValue(system_.failure(workspace_));
    return true;
}

/// Those at the end, and what a model that ended before would have shown.
bool EventRun::takeLastSamples() {
    const auto count = static_cast<long>(drive_->signals.time().size());
    if (isTerminated_ && grid_ + 1 < count) return failed(phrase("the model ends the simulation"));
    for (; grid_ < count; ++grid_)
        if (!takeSample()) return false;
    return true;
}

double EventRun::gridTime(double interval) const {
    if (!drive_) return options_.start + static_cast<double>(grid_) * interval;
    const std::vector<double>& time = drive_->signals.time();
    return grid_ < static_cast<long>(time.size()) ? time[static_cast<std::size_t>(grid_)] : never;
}

bool EventRun::isStopped(Text reason, bool isCancelled) {
    if (drive_) (isCancelled ? drive_->isCancelled : drive_->isTooLong) = true;
    return failed(std::move(reason));
}

bool EventRun::hasNoTangent() { return failed(phrase("the sensitivities are not finite")); }

/// The tangents up to an event; by what it is known.
bool EventRun::beginTangents(const std::set<int>& crossed) {
    if (!tangents_) return true;
    if (!takeSlots() || !read(time_, x_.data(), readings_)) return hasNoValue(system_.failure(workspace_));
    model_.program.update(slots_, readings_, time_, values_, isDue_);
    return tangents_->begin(point(), momentOf(crossed)) || hasNoTangent();
}

EventMoment EventRun::momentOf(const std::set<int>& crossed) const {
    const auto isNow = [&](double t) { return std::fabs(t - time_) < 1e-12 * sizeOf(time_); };
    const auto relations = static_cast<int>(model_.relations.size());
    for (const int k : crossed)
        return {k < relations ? model_.relations[static_cast<std::size_t>(k)].reading
                              : model_.wholes[static_cast<std::size_t>(k - relations) / 2].reading};
    for (const HybridModel::Relation& r : model_.relations)
        if (r.isOfTime && r.isWatched && isNow(-offsetOf(r.offset) / r.factor)) return {-1, r.offset, r.factor};
    for (const HybridModel::Whole& w : model_.wholes) {
        const double value = w.factor * time_ + offsetOf(w.offset);
        if (w.isOfTime && w.isWatched && isNow(time_ + (std::round(value) - value) / w.factor))
            return {-1, w.offset, w.factor};
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
