#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/effect/block/candidate.hpp"
#include "core/effect/model/null_model.hpp"

namespace analogon {

/// One way to switch a candidate on: its shape, and the strength at which the trace was taken.
struct Probe {
    std::map<std::string, double> values;  // shape parameters
    double secant{};                       // 0: slope at strength 0
    ColumnScore plain;                     // against the residual as it is; its directions of the best probe alone
    ColumnScore whitened;                  // with the noise made white; without its directions
    Eigen::VectorXd column;                // trace of the strength, in units of the noise; once screened: none
    Eigen::VectorXd strengthIn;            // its projected trace in `plain.directions`, of length 1; of the best alone
    SharedColumns course;                  // its one direction, at some of the rows; empty: it has several
    bool isAlongRecorded{};                // of a wave along the recorded course of its variable
    double strength() const;               // best estimate, 0 when the sign is wrong
    std::vector<double> linear() const;    // of the further linear parameters
};

/// A candidate with what its probes show.
struct Screened {
    Candidate candidate;
    std::map<std::string, double> fixed;
    std::optional<std::vector<ParameterValue>> begin;  // values to start at; none: those without it
    std::shared_ptr<const Variant>
        recorded;               // the effect along the recorded course of its variable; null: none is told
    std::vector<Probe> probes;  // best first
    Text failure;               // why it could not be tried; empty: it was

    double score() const;  // decrease of chi-square of the best probe (right sign)
    double whitenedScore() const;
    bool isAbsorbed() const;  // no probe is visible
    bool isWrongSign() const;
    std::vector<std::string> absorbedBy;  // parameters that imitate it
};

/// What a candidate has to promise for a refit. Of its score those samples alone count that speak for themselves; the
/// score with the noise made white reckons with that already.
struct LeastPromise {
    double score{};   // decrease of chi-square
    double share{1};  // of the samples
    double of(const Screened& screened) const;
    bool isMetBy(const Screened& screened) const { return of(screened) > score; }
};

/// The effect in the model that it was screened beside, fixed values set, parameters not yet freed. The candidates of a
/// round do not keep it: the text of a model in each of them takes more room than all they tell.
Outcome<Variant> wiredIn(const NullModel& null, const Screened& screened);

/// The options with a limit on the effort of one simulation, the same on any machine: a candidate that is far too
/// stiff for the recording is given up.
SimulationOptions limited(const NullModel& null, SimulationOptions simulation);

/// Whether a course that was recorded is another one than the simulated course from which it is away by `lead` at most:
/// to the shortest of so many waves a turn, or, without waves, to all that is passed (`turn`, in the unit of the lead).
bool isAnotherCourse(double lead, double waves, double turn);

/// Takes a candidate's traces and scores them (Rao's score test; secants where the slope at 0 misleads).
Screened screen(const NullModel& null, const Candidate& candidate, const SimulationOptions& simulation,
                const Progress& progress);

}  // namespace analogon
