#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace analogon {

/// What is known of parameters that data cannot tell apart: a product of powers that changes in no direction which the
/// data leave open (Walter and Pronzato 1997, section 2.6: identifiable combinations).
struct KnownProduct {
    std::string name;  // "power.k/wall.G"
    double value{};
    double standardError{};
    std::string unit;  // "1": a pure number; empty: not known
};

/// A parameter where the fit ended.
struct FittedValue {
    std::string name;
    double value{};
    std::string unit;
};

/// `directions`: changes of the parameters that the data do not see, in their own units (zeros: not involved).
/// `covariance`: of the parameters on the directions that the data do see. For each direction one product for each
/// parameter that is involved but one, to which the others are related: the one that makes them known best, or nearly
/// so in simpler units. None of a direction that is no change by common factors with small whole exponents, shares
/// parameters with another, or has a value that is not positive.
std::vector<KnownProduct> knownProducts(const std::vector<FittedValue>& parameters,
                                        const std::vector<Eigen::VectorXd>& directions,
                                        const Eigen::MatrixXd& covariance);

/// What is known of two parameters far better than either, where each is uncertain by more than a tenth or they can
/// hardly be told apart: their sum (two lags one behind the other), difference, product or ratio. `covariance`: NaN
/// where not determined.
std::vector<KnownProduct> knownOfPairs(const std::vector<FittedValue>& parameters, const Eigen::MatrixXd& covariance);

}  // namespace analogon
