#include "core/effect/search/mistaken_reading.hpp"

#include "core/effect/judge/remainder.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/reading_remarks.hpp"

namespace analogon {

Finding besideMistake(const SearchContext& search, Finding finding, const NullModel& null,
                      const MistakenUnit& mistake) {
    finding.kind = FindingKind::Unexplained;
    finding.remainders = leftovers(null, search.options.fit.simulation).structure;
    const Text channels = channelWords(search.readings.full.task, mistake);
    finding.notSearched =
        mistake.asLikely.empty()
            ? phrase("the numbers of {} look like {} and not like the {} that is told", channels, mistake.likely,
                     mistake.unit)
            : phrase(
                  "the numbers of {} look like {} (or {}: other parameters make up for it) and not like the {} that "
                  "is told",
                  channels, mistake.likely, listed(mistake.asLikely), mistake.unit);
    const Variant read{readAsLikely(search.readings.full.task, mistake), {}, mistake.read.variant.values};
    if (const Outcome<ModelState> state =
            stateOf(read, mistake.read.fit, search.options.fit.simulation, search.progress, Detail::Errors)) {
        const double was = errorPercentOf(finding.baseline, Role::Fit), is = errorPercentOf(*state, Role::Fit);
        const double wasUnfitted = validationErrorOf(finding.baseline), isUnfitted = validationErrorOf(*state);
        Text errors = phrase("read so, the model as it is leaves an error of {:.3g} % instead of {:.3g} %", is, was);
        if (isUnfitted >= 0)
            errors += phrase(", and of {:.3g} % instead of {:.3g} % on recordings that were not fitted", isUnfitted,
                             wasUnfitted);
        finding.notSearched = phrase("{}: {}; correct the header, or give the unit in the study, and search again",
                                     finding.notSearched, errors);
    }
    finding.warnings.push_back(finding.notSearched);
    for (Text& remark : recordingRemarks(search, null)) finding.warnings.push_back(std::move(remark));
    return finding;
}

}  // namespace analogon
