#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/range.hpp"
#include "core/base/unit_factors.hpp"
#include "core/effect/model/null_model.hpp"

/// The terms from which a law is made that no class has, and the choice of those that explain most.
namespace analogon {

/// A quantity that a law may contain.
struct LawQuantity {
    std::string name;                 // in the class: "w", "x1"
    std::string variable;             // of the model; empty: one of the place's own
    std::string shown;                // in the equation that people read
    std::optional<UnitFactors> unit;  // nothing: not known
    Range range{};                    // of what the class takes: the difference to `origin`
    double origin{};                  // a number near its first value, where only differences matter

    double largest() const { return std::max(std::abs(range.low), std::abs(range.high)); }
};

struct Term {
    std::string text, shown;
    std::optional<UnitFactors> unit;
    int complexity{};  // 1: of the place's own quantities; 2, 3: with others
};

/// q, q|q|, q², q³, |q| and, where asked for, a smooth stand-in for the sign.
void addPowers(const LawQuantity& q, bool withSign, int complexity, std::vector<Term>& terms);
Term productOf(const LawQuantity& a, const LawQuantity& b, int complexity);
/// ab, a|b|, ab² and, where asked for, b sign(a) and |b| sign(a).
void addProducts(const LawQuantity& a, const LawQuantity& b, bool withSign, int complexity, std::vector<Term>& terms);
/// What sets in above or below a value: an overflow, a stop, a valve.
void addHinges(const LawQuantity& q, const Range& range, std::vector<Term>& terms);
/// Waves of an angle, once to thrice a turn, in two phases: an eccentric wheel, a bent scale.
void addWaves(const LawQuantity& q, std::vector<Term>& terms);

/// Terms that a law may consist of, and how much they explain to first order.
struct TermSet {
    std::vector<std::size_t> terms;
    double explained{};
};

/// Of the traces of terms in the residual: single terms that explain most, no two of them alike, and the best with the
/// one that adds most to it (orthogonal least squares, Chen, Billings and Luo 1989).
std::vector<TermSet> likeliestSets(const NullModel& null, const std::vector<Term>& terms,
                                   const Eigen::MatrixXd& columns);

/// Variables over the fitted experiments.
using Series = std::map<std::string, std::vector<Eigen::VectorXd>>;

/// What moves of these variables of a model; empty where it cannot be simulated.
Series movingSeries(const NullModel& null, const PreparedTask& held, const std::vector<std::string>& names,
                    const SimulationOptions& simulation);

/// The names of variables, with their units.
using NamedUnits = std::vector<std::pair<std::string, std::string>>;

/// Inputs, outputs and states of a model with their units: what a law may contain beside the place's own quantities.
NamedUnits quantitiesOf(const System& system);

/// A quantity of these courses.
LawQuantity quantityOf(std::string name, std::string variable, std::string shown, const std::string& unit,
                       const std::vector<Eigen::VectorXd>& values, double origin);

/// A number near the first value, for quantities (temperatures, angles) of which the differences matter.
double originOf(const Eigen::VectorXd& values);

}  // namespace analogon
