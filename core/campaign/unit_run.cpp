#include "core/campaign/unit_run.hpp"

#include "core/base/guard.hpp"
#include "core/base/stopwatch.hpp"
#include "core/base/work.hpp"
#include "core/study/results.hpp"

namespace analogon {

namespace {

Outcome<RunResult> result(const Campaign& campaign, const CampaignTemplate& study, const CampaignUnit& unit,
                          const RunOptions& options) {
    return guardedOutcome([&]() -> Outcome<RunResult> {
        const Outcome<Study> own = study.studyOf(campaign, unit);
        if (!own) return own.diagnostics();
        return campaign.command == CampaignCommand::Fit ? runFit(*own, options) : runDiscover(*own, options);
    });
}

}  // namespace

UnitRecord recordFailure(const CampaignUnit& unit, const std::string& fingerprint, const std::string& fault,
                         const std::filesystem::path& out) {
    UnitRecord record;
    record.unit = unit.name;
    record.fingerprint = fingerprint;
    record.fault = fault.empty() ? "failed without a reason" : fault;
    if (!unit.hasFolderName) return record;
    Outcome<ResultsPlace> place = ResultsPlace::take(folderOf(out, unit.name));
    const Outcome<Done> written = place ? place->writeUnit(unitJson(record)) : Outcome<Done>(place.diagnostics());
    if (!written) record.fault += "; " + faultLine(written.diagnostics());
    return record;
}

UnitRecord runUnit(const Campaign& campaign, const CampaignTemplate& study, const CampaignUnit& unit,
                   const std::filesystem::path& out, const RunOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    const Outcome<std::string> fingerprint = fingerprintOf(campaign, study, unit);
    if (!fingerprint) return recordFailure(unit, {}, faultLine(fingerprint.diagnostics()), out);
    Outcome<ResultsPlace> place = ResultsPlace::take(folderOf(out, unit.name));
    if (!place) return recordFailure(unit, *fingerprint, faultLine(place.diagnostics()), out);
    const WorkCount work;
    const Outcome<RunResult> found = result(campaign, study, unit, options);
    UnitRecord record;
    if (found) record = recordOf(*found, campaign.command);
    if (!found) record.fault = faultLine(found.diagnostics());
    record.unit = unit.name;
    record.fingerprint = *fingerprint;
    record.work = work.done();
    record.seconds = secondsSince(begin);
    const Outcome<Done> written = found ? place->write(*found, name(campaign.command), Traces::All, unitJson(record))
                                        : place->writeUnit(unitJson(record));
    if (!written && record.fault.empty()) record.fault = faultLine(written.diagnostics());
    return record;
}

}  // namespace analogon
