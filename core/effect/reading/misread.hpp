#pragma once

#include <functional>
#include <vector>

#include "core/effect/model/null_model.hpp"

/// The recordings read otherwise than they say, beside the model as it stands: whether nothing but that is wrong.
namespace analogon {

/// Whether so much is left that another reading may be all there is to it.
bool mayBeMisread(const NullModel& null);

/// The model with its recordings read in one way.
struct Reread {
    Variant variant;                     // at the start values of the study
    std::vector<Eigen::VectorXd> noise;  // of its outputs, as in NullModel
};

/// Sum of squares that it would leave, to first order at its start values; infinite where it cannot be simulated there.
double promisedLeft(const Reread& reread, const SimulationOptions& simulation, const Progress& progress);

/// One of several readings, by its number among them.
struct PromisingReading {
    std::size_t number{};
    double left{};  // promisedLeft()
};

/// A reading with which the model as it stands, fitted to it, leaves next to nothing of all that it leaves without.
struct FittedReading {
    std::size_t number{};
    NullModel read;
};

/// Fits the few that promise to leave least, each from the start values of the study; that which leaves least first.
/// `reread`: a reading by its number.
std::vector<FittedReading> readingsThatExplain(const NullModel& null, std::vector<PromisingReading> promising,
                                               const std::function<Reread(std::size_t)>& reread,
                                               const FitOptions& options, const Progress& progress);

/// Whether what one reading leaves more than the best is less than tells them apart.
bool leavesAsLittle(const NullModel& read, const NullModel& best);

}  // namespace analogon
