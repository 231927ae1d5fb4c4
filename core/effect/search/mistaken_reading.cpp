#include "core/effect/search/mistaken_reading.hpp"

#include "core/effect/judge/remainder.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/reading_remarks.hpp"

namespace analogon {
namespace {

/// The errors with which a reading lets the model as it is; empty: it cannot be simulated.
Text errorsRead(const SearchContext& search, const Finding& finding, EstimationTask task, const NullModel& read) {
    const Variant variant{std::move(task), {}, read.variant.values};
    const Outcome<ModelState> state =
        stateOf(variant, read.fit, search.options.fit.simulation, search.progress, Detail::Errors);
    if (!state) return {};
    const double was = errorPercentOf(finding.baseline, Role::Fit), is = errorPercentOf(*state, Role::Fit);
    const double wasUnfitted = validationErrorOf(finding.baseline), isUnfitted = validationErrorOf(*state);
    Text errors = phrase("read so, the model as it is leaves an error of {:.3g} % instead of {:.3g} %", is, was);
    if (isUnfitted >= 0)
        errors +=
            phrase(", and of {:.3g} % instead of {:.3g} % on recordings that were not fitted", isUnfitted, wasUnfitted);
    return errors;
}

/// A finding without a search, and why there was none.
Finding unsearched(const SearchContext& search, Finding finding, const NullModel& null, Text why) {
    finding.kind = FindingKind::Unexplained;
    finding.unexplained.remainders = leftovers(null, search.options.fit.simulation).structure;
    finding.end.notSearched = std::move(why);
    finding.warnings.push_back(finding.end.notSearched);
    for (Text& remark : recordingRemarks(search, null)) finding.warnings.push_back(std::move(remark));
    return finding;
}

}  // namespace

Finding besideMistake(const SearchContext& search, Finding finding, const NullModel& null,
                      const MistakenUnit& mistake) {
    const EstimationTask& task = search.readings.full.task;
    const Text channels = channelWords(task, mistake);
    Text why =
        mistake.asLikely.empty()
            ? phrase("the numbers of {} look like {} and not like the {} that is told", channels, mistake.likely,
                     mistake.unit)
            : phrase(
                  "the numbers of {} look like {} (or {}: other parameters make up for it) and not like the {} that "
                  "is told",
                  channels, mistake.likely, listed(mistake.asLikely), mistake.unit);
    if (const Text errors = errorsRead(search, finding, readAsLikely(task, mistake), mistake.read); !errors.empty())
        why = phrase("{}: {}; correct the header, or give the unit in the study, and search again", why, errors);
    return unsearched(search, std::move(finding), null, std::move(why));
}

Finding besideMistake(const SearchContext& search, Finding finding, const NullModel& null,
                      const std::vector<MistakenWiring>& alike) {
    const EstimationTask& task = search.readings.full.task;
    const MistakenWiring& first = alike.front();
    Text why = wiringWords(task, first);
    for (std::size_t i = 1; i < alike.size(); ++i)
        why = phrase("{}, or {} (the data do not tell which)", why, wiringWords(task, alike[i]));
    if (const Text errors = errorsRead(search, finding, readAsMeant(task, first), first.read); !errors.empty())
        why = first.isOfSign()
                  ? phrase("{}: {}; give the column \"scale\": -1 in the study, and search again", why, errors)
                  : phrase("{}: {}; give each channel the other's column in the study, and search again", why, errors);
    return unsearched(search, std::move(finding), null, std::move(why));
}

}  // namespace analogon
