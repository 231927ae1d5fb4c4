#pragma once

#include <cstddef>
#include <vector>

/// What is shared by all units of a campaign and what is of each one, of one parameter.
namespace analogon {

/// Random effects: y_i = mu + b_i + e_i with b_i ~ N(0, tau²) between the units and e_i ~ N(0, s_i²) within, s_i the
/// unit's standard error. Restricted likelihood (Viechtbauer, J. Educ. Behav. Stat. 30, 2005, eq. 9), w_i = 1/(tau² +
/// s_i²):
///   l(tau²) = -1/2 sum ln(tau² + s_i²) - 1/2 ln sum w_i - 1/2 sum w_i (y_i - mu)²,  mu = sum w_i y_i / sum w_i
/// Standard errors from the expected information: 1/sqrt(sum w_i) of mu; of tau² with
///   I = 1/2 (sum w² - 2 sum w³/sum w + (sum w²/sum w)²).
/// tau² = 0 lies on the bound: twice the difference of the likelihoods is a mixture of half a chi² with one degree of
/// freedom and half a 0 (Self and Liang, J. Am. Stat. Assoc. 82, 1987, case 5).
struct Population {
    std::size_t units{};
    double mean{}, meanError{};
    double between{}, betweenError{};  // tau² and its standard error
    double within{};                   // mean of s_i²
    double pCommon{1};                 // of what is seen if the parameter were common to all units
};

/// Values without a finite value or without a standard error above 0 are left out; fewer than 2: units says how many.
Population populationOf(const std::vector<double>& values, const std::vector<double>& errors);

/// A value that the others and its own standard error do not explain.
struct OddUnit {
    std::size_t unit{};
    double deviation{};  // in robust standard deviations
    double p{};          // of one comparison
};

/// Median m and spread 1.4826 times the median of the deviations from it (Rousseeuw and Croux, J. Am. Stat. Assoc. 88,
/// 1993), of which what the standard errors explain is taken off: tau_r² = max(0, spread² - median s²). The deviation
/// (y_i - m)/sqrt(tau_r² + s_i²) is held against Student's t with 0.37 (n - 1) degrees of freedom, 0.37 being the
/// efficiency of that spread. `level`: of one comparison, two-sided. Fewer than 5 values: none is odd.
std::vector<OddUnit> oddUnits(const std::vector<double>& values, const std::vector<double>& errors, double level);

/// The level of one of many comparisons such that one is wrong in any with this probability (Sidak).
double levelOfOne(double level, std::size_t comparisons);

/// Holm's corrected p values (Scand. J. Stat. 6, 1979), in the given order.
std::vector<double> holm(const std::vector<double>& p);

/// p of no monotonic connection: Spearman's rank correlation by its t distribution; mid-ranks for equal values.
struct RankCorrelation {
    double correlation{}, p{1};
    double slope{};  // least squares
};
RankCorrelation rankCorrelation(const std::vector<double>& x, const std::vector<double>& y);

/// p of all groups having the same distribution: Kruskal and Wallis (J. Am. Stat. Assoc. 47, 1952) with their
/// correction for ties, by chi². `groups`: 0 … of each value.
double kruskalWallis(const std::vector<std::size_t>& groups, const std::vector<double>& y);

}  // namespace analogon
