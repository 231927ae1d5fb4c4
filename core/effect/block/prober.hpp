#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/effect/block/screen.hpp"

namespace analogon {

constexpr double quarterTurn = 1.5707963267948966;  // [rad]

/// The parameters of effects whose traces are taken: along the free ones, with any values of those that are kept.
struct TracedParameters {
    std::vector<FitParameter> free;
    std::vector<std::string> kept;

    /// The strength first, then those that are linear beside it; its shapes are kept.
    void add(const PlacedEffect& placed);
};

/// Takes the traces of one wired candidate: the outputs' slopes, or secants, along its strength.
class Prober {
public:
    /// `course`: of the variable that a wave goes along, in each fitted experiment.
    Prober(const NullModel& null, const Variant& wired, const std::vector<std::vector<double>>& course,
           const SimulationOptions& simulation, const Progress& progress)
        : null_(null),
          course_(course),
          placed_(wired.effects.back()),
          wired_(wired),
          simulation_(simulation),
          progress_(progress) {}

    Outcome<Done> compile();

    /// One trace; false when the simulation failed.
    bool take(const std::map<std::string, double>& shape, double secant, Probe& probe);

    /// States beside those of the model.
    int addedStates() const;

private:
    Eigen::VectorXd off() const;

    /// Traces of the strength and of the further linear parameters, in units of the noise.
    std::optional<Eigen::MatrixXd> traces(double secant) { return traces(secant, plans_); }

    std::optional<Eigen::MatrixXd> traces(double secant, const std::vector<GridPlan>& plans);

    /// Steps short enough for a wave that the model itself, without the effect, need not follow.
    std::vector<GridPlan> plansFor(double waves) const;

    /// A wave of any phase is the sum of two a quarter turn apart: strength and phase both come from them.
    bool takeWave(const std::map<std::string, double>& shape, Probe& probe);

    const NullModel& null_;
    const std::vector<std::vector<double>>& course_;
    const PlacedEffect& placed_;
    const Variant& wired_;
    std::vector<GridPlan> plans_;
    const SimulationOptions& simulation_;
    const Progress& progress_;
    PreparedTask held_;
};

}  // namespace analogon
