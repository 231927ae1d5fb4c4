#include "core/campaign/campaign_run.hpp"

#include <istream>
#include <ostream>
#include <sstream>

#include "core/base/owned_directory.hpp"
#include "core/base/stopwatch.hpp"
#include "core/campaign/unit_run.hpp"
#include "core/campaign/worker_pool.hpp"

namespace analogon {

namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// Gives units to workers and tells of each when it has ended.
Outcome<Done> work(const Campaign& campaign, const CampaignTemplate& study, std::vector<std::size_t> units,
                   const std::filesystem::path& out, const CampaignRunOptions& options,
                   const std::function<void(std::size_t)>& begins,
                   const std::function<void(std::size_t, UnitRecord)>& ends, const std::function<void()>& meanwhile) {
    WorkerPool pool(options.worker, std::min(options.jobs, static_cast<int>(units.size())));
    std::size_t next = 0, running = 0;
    while ((next < units.size() || running > 0) && !options.stop.stop_requested()) {
        for (; next < units.size() && pool.isFree(); ++next, ++running) {
            if (Outcome<Done> given = pool.give(units[next], campaign.units[units[next]].name); !given) return given;
            begins(units[next]);
        }
        Outcome<std::vector<WorkerEvent>> events = pool.wait(milliseconds(20));
        if (!events) return events.diagnostics();
        for (const WorkerEvent& event : *events) {
            --running;
            ends(event.unit, recordAfter(campaign, study, event.unit, event.death, out));
        }
        meanwhile();
    }
    return Done{};
}

}  // namespace

std::optional<UnitRecord> recordThatHolds(const Campaign& campaign, const CampaignTemplate& study, std::size_t unit,
                                          const std::filesystem::path& out) {
    const CampaignUnit& one = campaign.units[unit];
    const Outcome<std::string> fingerprint = fingerprintOf(campaign, study, one);
    std::optional<UnitRecord> record = readUnitRecord(out, one.name);
    if (record && record->fingerprint != (fingerprint ? *fingerprint : std::string())) record.reset();
    return record;
}

UnitRecord recordAfter(const Campaign& campaign, const CampaignTemplate& study, std::size_t unit,
                       const std::string& death, const std::filesystem::path& out) {
    // a process that dies may have ended its work before
    if (std::optional<UnitRecord> record = recordThatHolds(campaign, study, unit, out)) return std::move(*record);
    const CampaignUnit& one = campaign.units[unit];
    const Outcome<std::string> fingerprint = fingerprintOf(campaign, study, one);
    return recordFailure(one, fingerprint ? *fingerprint : std::string(),
                         fingerprint     ? death
                         : death.empty() ? faultLine(fingerprint.diagnostics())
                                         : death,
                         out);
}

Diagnostic tableHasChanged(const Campaign& campaign) {
    return fileError(phrase("the table of units was changed while the campaign ran"), campaign.table.string(), 0, 0,
                     phrase("Start the campaign again: it goes on with the units as they are now."));
}

Outcome<Done> runCampaign(const Campaign& campaign, const CampaignTemplate& study, CampaignState& state,
                          const CampaignRunOptions& options) {
    constexpr double betweenWrites = 1;  // [s]
    TimeLeft left(options.jobs);
    auto lastWritten = steady_clock::now();
    const auto report = [&] {
        const CampaignCounts counts = state.counts();
        if (options.report) options.report({counts, left.of(counts.waiting + counts.running)});
    };
    report();
    const Outcome<Done> worked = work(
        campaign, study, state.waiting(), state.out(), options, [&](std::size_t unit) { state.begin(unit); },
        [&](std::size_t unit, UnitRecord record) {
            left.add(record.seconds);
            state.end(unit, std::move(record));
            report();
        },
        [&] {
            if (secondsSince(lastWritten) < betweenWrites) return;
            lastWritten = steady_clock::now();
            (void)state.write(campaign);  // it is written at the end, and what hinders that is told then
        });
    for (std::size_t i = 0; i < campaign.units.size(); ++i)
        if (state.of(i) == UnitState::Running) state.lose(i);
    // directories of a worker that was killed right after it had put its results in their place; our own alone
    removeAbandoned(state.out() / "units", ".");
    const Outcome<Done> written = state.write(campaign);
    return worked ? written : worked;
}

Outcome<Done> serveUnits(const Campaign& campaign, const CampaignTemplate& study, const std::filesystem::path& out,
                         const RunOptions& options, std::istream& in, std::ostream& answers) {
    answers << "ready" << std::endl;
    for (std::string line; std::getline(in, line);) {
        const std::size_t end = line.find(' ');
        const std::string name = end == std::string::npos ? std::string() : line.substr(end + 1);
        std::size_t unit = campaign.units.size();
        std::istringstream(line) >> unit;
        if (unit >= campaign.units.size() || campaign.units[unit].name != name) return tableHasChanged(campaign);
        runUnit(campaign, study, campaign.units[unit], out, options);
        answers << unit << std::endl;
    }
    return Done{};
}

}  // namespace analogon
