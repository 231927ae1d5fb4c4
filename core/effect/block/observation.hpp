#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/effect/model/null_model.hpp"
#include "core/effect/model/shape_value.hpp"

/// What a recording shows of the variables from which an effect takes its shapes.
namespace analogon {

/// Series of variables over the fitted experiments, simulated with the effect off.
class Observations {
public:
    void add(const std::string& variable, std::vector<std::vector<double>> series) {
        series_[variable] = std::move(series);
    }

    /// "range", "maxabs", "rms" …; NaN: not known.
    double statistic(const std::string& function, const std::string& variable) const;

    void setTimes(std::vector<std::vector<double>> times) { times_ = std::move(times); }

    /// By how much the variable was ahead of its simulation when it was recorded. What is asked of it is then told from
    /// the recording.
    void setLead(const std::string& variable, std::vector<Eigen::VectorXd> lead) {
        lead_ = std::move(lead);
        std::vector<std::vector<double>>& recorded = recorded_[variable] = series(variable);
        for (std::size_t e = 0; e < recorded.size(); ++e)
            for (std::size_t k = 0; k < recorded[e].size(); ++k)
                recorded[e][k] += lead_[e][static_cast<Eigen::Index>(k)];
    }
    /// Empty: nothing tells.
    const std::vector<Eigen::VectorXd>& lead() const { return lead_; }

    /// The samples of a variable in each fitted experiment; empty: it was not observed.
    const std::vector<std::vector<double>>& series(const std::string& variable) const {
        static const std::vector<std::vector<double>> none;
        const auto found = series_.find(variable);
        return found == series_.end() ? none : found->second;
    }

private:
    std::map<std::string, std::vector<std::vector<double>>> series_, recorded_;
    std::vector<std::vector<double>> times_;
    std::vector<Eigen::VectorXd> lead_;
};

/// Observes what the shapes of the newest effect of a variant name.
Outcome<Observations> observeFor(const NullModel& null, const Variant& off, const SimulationOptions& simulation);

/// The same of each of the `count` newest effects of a variant, in their order, all at once. `held`: of that variant.
Outcome<std::vector<Observations>> observeNewest(const NullModel& null, const Variant& off, std::size_t count,
                                                 const PreparedTask& held, const SimulationOptions& simulation);

/// By which the texts of an effect's shapes are evaluated. `observations` must outlive it.
ShapeContext contextOf(const NullModel& null, const Observations& observations);

/// The values that the recording gives the fixed parameters of an effect.
Outcome<std::map<std::string, double>> fixedOf(const EffectClass& effect, const ShapeContext& context);

/// The strengths at which an effect's traces are taken: those of its secants, or where it has none that is not 0, 0 for
/// the slope there.
Outcome<std::vector<double>> strengthsOf(const EffectClass& effect, const ShapeContext& context);

/// All combinations of the shape values that go with a strength, which they may name.
Outcome<std::vector<std::map<std::string, double>>> shapesOf(const EffectClass& effect, const ShapeContext& anyStrength,
                                                             double strength);

}  // namespace analogon
