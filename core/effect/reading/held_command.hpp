#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/effect/model/null_model.hpp"

namespace analogon {

/// Whether a column stays where it is for samples on end and jumps between neighbours, never seen on its way: a command
/// that is held, as far as its shape tells (a step that was logged as a short ramp looks the same).
bool looksHeld(const Eigen::VectorXd& column);

/// Whether one of the inputs that are joined by straight lines does, in all fitted recordings.
bool anyLooksHeld(const EstimationTask& task);

/// The inputs on straight lines that are asked whether they are held: none of so long records that half a sample of
/// them is next to nothing.
std::vector<std::string> inputsToAsk(const EstimationTask& task);

/// Whether holding an input whose shape does not tell promises enough to be fitted: by the squares that would be left
/// at the parameters on lines, and those that the lines leave.
bool isPromising(double promised, double onLines);

/// Whether what inputs leave that are held, and what a delay of half a sample or one of an output leaves, speaks for
/// the inputs (sums of squares, each fitted). `looksSo`: by the shape of the columns they are held; that may leave as
/// much.
bool isBetterThanDelay(double held, double delayed, bool looksSo);

/// Inputs that are joined by straight lines, and are held by what the outputs say.
struct HeldReading {
    std::vector<std::string> inputs;
    double errorPercent{};  // [%] that the model is left with when they are held, its parameters fitted to that
    bool isLikeDeadTime{};  // on straight lines that come half a sample late the model is left with nearly as little
};

/// Straight lines make of a held command one that comes half a sample early; what is left then is held against the same
/// inputs held, and against inputs that come later by half a sample and by a whole one: no dead time and no lag may
/// explain as much. Nothing: the lines leave noise alone, or holding them explains no more.
std::optional<HeldReading> heldReading(const NullModel& onLines, const FitOptions& options, const Progress& progress);

/// Holds these inputs in all recordings.
void holdInputs(EstimationTask& task, const std::vector<std::string>& inputs);

/// What is to be done about it. `isReckonedWith`: the parameters that are reported already are those with them held.
std::vector<Text> heldRemarks(const EstimationTask& task, const HeldReading& reading, double errorOnLines,
                              bool isReckonedWith);

}  // namespace analogon
