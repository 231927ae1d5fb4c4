#include "core/effect/search/first_fit.hpp"

#include <algorithm>

#include "core/effect/search/context.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::firstFit;

FitOptions beginningAnywhere(FitOptions options) {
    options.otherStarts = startsAnywhere;
    return options;
}

FitOptions beginningNear(FitOptions options) {
    options.starts = 1 + otherStarts;
    options.startsWithin = startsWithin;
    return options;
}

double toleranceBeside(const NullModel& base, double asked) {
    return std::clamp(integrationShare * quietest(base), asked, coarsestTolerance);
}

bool beginElsewhere(SearchContext& search, NullModel& null) {
    if (isNoise(null) || null.fit.estimates.empty() || isDirect(search.options.fit.method)) return false;
    FitOptions around = beginningNear(search.options.fit);
    around.simulation = limited(null, around.simulation);
    const std::optional<FitResult> other = fitBeside(null, search.readings.searched, around, search.progress);
    if (!other || search.progress.stopRequested()) return false;
    const double chi2Decrease = null.sumOfSquares() - other->optimum.residuals.squaredNorm();
    if (!(chi2Decrease > equivalenceMargin)) return false;
    Variant begin = search.readings.searched;
    begin.values = valuesOf(*other);
    Outcome<NullModel> better = fitNull(begin, null.noise, NoiseLevel::Estimate, search.options.fit, search.progress);
    if (!better) return false;
    search.readings.searched.values = search.readings.full.values = begin.values;
    null = std::move(*better);
    search.journal.model("other starts", null, "better");
    return true;
}

bool isAstray(const NullModel& last, const NullModel& own) {
    return last.fit.optimum.residuals.size() == own.fit.optimum.residuals.size() &&
           !(reducedChi(last.fit) <= threshold::acceptance::largeResidual * reducedChi(own.fit));
}

}  // namespace analogon
