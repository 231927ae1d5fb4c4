#pragma once

#include "core/fit/fit.hpp"

namespace analogon {

/// By how much twice the logarithm of the likelihood falls to the ends of the interval: the 95 % quantile of chi-square
/// with one degree of freedom.
inline constexpr double profileThreshold = 3.841458820694124;

/// The profile of the likelihood of one parameter: it is held at values away from its estimate, all others are fitted
/// anew, and the interval ends where twice the logarithm of the likelihood has fallen by the 95 % quantile of
/// chi-square with one degree of freedom (Venzon & Moolgavkar 1988). Unlike a standard error it shows how the data
/// tell the two sides apart, and where they do not limit the parameter at all. With priors it is that of the posterior.
/// `best`: the result of fit(problem). Both sides run side by side with options.threads > 1.
ConfidenceInterval profile(const FitProblem& problem, const FitResult& best, int parameter,
                           const FitOptions& options = {}, const Progress& progress = {});

}  // namespace analogon
