#pragma once

#include <vector>

#include "core/base/text.hpp"

namespace analogon {

/// The channels that start values are read from, in SI units; empty: not measured. All of one length.
struct GuessData {
    std::vector<double> time, voltage, current, speed, bodyTemperature, surroundingTemperature;
};

/// A start value with the bounds within which a fit may look.
struct StartGuess {
    double value{};
    double min{}, max{};
    Text reason;  // "from voltage over current"; empty: a usual value
};

/// Order of magnitude of the time in which a signal changes by its own spread, in s.
double changeTime(const std::vector<double>& time, const std::vector<double>& signal);

/// Of a resistor: the median of voltage over current where both are large.
StartGuess guessResistance(const GuessData& data);
struct MotorGuess {
    StartGuess resistance, torqueConstant;
};
/// Of a motor: v = R*i + k*w by least squares; without a speed, R where the current is high (near standstill nothing
/// else limits it) and k from a usual speed.
MotorGuess guessMotor(const GuessData& data);
/// Of what turns, from the time constant J*R/k^2.
StartGuess guessInertia(const GuessData& data, double resistance, double torqueConstant);
/// Torque over the square of the speed, where it is fast.
StartGuess guessQuadraticLoad(const GuessData& data, double torqueConstant);
/// Torque over speed.
StartGuess guessFriction(const GuessData& data, double torqueConstant);
/// Between body and surroundings: mean power over mean temperature difference.
StartGuess guessConductance(const GuessData& data);
/// Of the body: conductance times the time in which it warms up.
StartGuess guessHeatCapacity(const GuessData& data, double conductance);

}  // namespace analogon
