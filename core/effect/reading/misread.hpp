#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/effect/model/null_model.hpp"

/// The recordings read otherwise than they say, beside the model as it stands: whether nothing but that is wrong.
namespace analogon {

/// Where the values of a channel stand in a recording.
struct ChannelRow {
    bool isInput{};
    Eigen::Index row{};

    auto of(Recording& r) const { return (isInput ? r.inputs : r.outputs).row(row); }
    auto of(const Recording& r) const { return (isInput ? r.inputs : r.outputs).row(row); }
};
/// Nothing: the recording does not have it.
std::optional<ChannelRow> channelRow(const Recording& recording, const std::string& channel);

/// The column from which a channel was read; empty: that is not known.
std::string columnBehind(const Recording& recording, const std::string& channel);
/// "T_in ('TC1')", or without the column where it is not known.
std::string nameWithColumn(const Recording& recording, const std::string& channel);

/// Where recordings may be other than they say: in all, and, where several are fitted, in each of these alone.
std::vector<std::vector<int>> whereMisread(const EstimationTask& task);

/// Whether so much is left that another reading may be all there is to it.
bool mayBeMisread(const NullModel& null);

/// Whether the recordings read in another way, as the model as it stands was then fitted, leave next to nothing of what
/// is left without: so much that no effect need be looked for beside it.
bool explainsAll(const NullModel& null, const FitResult& read);

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
