#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/fit/estimation_task.hpp"
#include "core/residual/noise.hpp"

/// What a fit or a discovery found: plain values, from which the report, the study and the screen are made.
/// Names and meaning follow the report format (contract, section 6).
namespace analogon {

struct OutputState {
    std::string name;
    std::string unit;
    ErrorFigures figures;
    Eigen::VectorXd measured;  // NaN: not measured
    Eigen::VectorXd simulated;
    /// Standard deviation of the simulated value, since the parameters are uncertain; empty: not known.
    Eigen::VectorXd deviation{};
};

struct ExperimentState {
    std::string name;
    Role role{Role::Fit};
    double errorPercent{};  // root mean square over its outputs
    std::vector<double> time;
    std::vector<OutputState> outputs;
    SimulationFailure failure;
    std::vector<FitEstimate> starts{};  // its own start values, where they were estimated from this recording alone
};

/// A model with its values, held against every experiment.
struct ModelState {
    std::string modelText;  // with fitted values written in
    std::vector<FitEstimate> parameters;
    std::vector<ExperimentState> experiments;
    std::map<std::string, ResidualSummary> residual;  // per output, over the fitted experiments
    FitStatus status{FitStatus::Failed};
    Text message;
    std::vector<Text> remarks;
    int simulations{};
    double seconds{};  // that the fit took
};

enum class Way { Attach, Insert, Specialise, Bridge };
const char* name(Way way);  // "attach" …

struct EffectValue {
    std::string name;
    double value{};
    double standardError{};
    std::string unit;
};

/// An effect of a library at a place, as the table of a finding names it.
struct EffectChoice {
    std::string className, at;

    bool operator==(const EffectChoice&) const = default;
};

/// Where an effect was put and how it did, compared with the chosen one.
struct Alternative {
    std::string kind, at;
    double deltaBic{};  // on the scale of the chosen one
    bool equivalent{};
};

struct Evidence {
    double score{};  // z² of the screening or F-like statistic, in units of the noise
    double pValue{};
    double deltaBic{};  // negative: better
    double heldOut{};   // H of the blocks left out in turn, -1 … 1
    double errorPercentBefore{}, errorPercentAfter{};
};

/// How a model foretells what was left out of its fit, without an effect and with it.
struct Prediction {
    double errorPercentBefore{}, errorPercentAfter{};  // root mean square, of the range of each output
    int blocks{}, betterIn{};                          // parts that were left out, and those in which it is better
    bool areRecordings{};                              // the parts are whole recordings
    int clearlyIn{};                                   // parts in which it is better by a good part of the error
    /// Evidence [BIC] for the effect beside the flow that is likeliest with it, where it was chosen by that: a flow
    /// that nobody measured leaves as much, and may hide how much better the model predicts.
    std::optional<double> besideFlow{};

    /// Share of the error of what was left out.
    double removed() const { return errorPercentBefore > 0 ? 1 - errorPercentAfter / errorPercentBefore : 0; }
};

/// Established: nothing else accounts for an effect, neither noise nor a disturbance. Indicated: structure remains, but
/// with it the model predicts clearly better, and nothing named does as well.
enum class Confidence { Established, Indicated };
const char* name(Confidence confidence);  // "established", "indicated"

/// How an effect stands in the model.
struct EffectInModel {
    Way way{Way::Attach};
    std::string instance;           // the component's name in the model
    std::string newInput, channel;  // top-level input that was added, and the recorded channel it carries
};

/// What would do nearly as well as an effect.
struct InsteadOfEffect {
    std::vector<Alternative> effects;
    /// Values of parameters that the study holds or bounds and that would explain as much: "core.C = 302 J/K".
    std::vector<Text> values{};
};

struct AddedEffect {
    std::string kind, className, at;
    std::string description;  // of the class
    EffectInModel wired;
    std::vector<EffectValue> parameters;
    Evidence evidence;
    Confidence confidence{Confidence::Established};
    std::optional<Prediction> prediction{};  // of one that is indicated
    InsteadOfEffect instead;
};

enum class Verdict { Chosen, Equivalent, Weaker, NotSignificant, Absorbed, WrongSign, FailsHeldOut, Failed };
const char* name(Verdict verdict);  // "chosen", "not significant" …

/// What the screening of a candidate tells.
struct ScreeningResult {
    double score{};
    double strength{};                    // estimate
    std::vector<std::string> absorbedBy;  // parameters
};

struct CandidateResult {
    std::string kind, at, className;
    ScreeningResult screening;
    std::optional<double> deltaBic;  // when it was refitted
    Verdict verdict{Verdict::NotSignificant};
    int round{};
    Text failure{};         // why it could not be tried
    Text reason{};          // why it is not in the model; empty: it is, or the run is of before reasons were kept
    std::string channel{};  // recorded, not used by the model, that would drive it; empty: it needs none
};

struct Correlate {
    std::string variable;
    double correlation{};

    bool isWorthAWord() const { return std::abs(correlation) >= 0.15; }
};

/// Errors of a model with something else in it. [%], negative: not known
struct ErrorsWith {
    double fit{-1}, validate{-1};
};

/// An equation without a name, offered for what is left.
struct ProposedEquation {
    Text equation;                          // empty: none is offered
    std::string className{};                // block that has it; empty: none
    std::string block{};                    // its text, where it is not of the library
    ErrorsWith errors{};                    // with all that is proposed
    double errorValidateWithout{-1};        // [%] of the model that is reported; negative: not known
    std::vector<std::string> equalNodes{};  // at which the same equation explains as much

    /// Whether recordings that were not fitted speak against it.
    bool worsensValidation() const {
        constexpr double byMoreThanChance = 1.02;
        return errorValidateWithout >= 0 && errors.validate > byMoreThanChance * errorValidateWithout;
    }
};

struct Remainder {
    std::string output, node;
    double evidence{};
    double from{}, to{};  // [s]
    std::string experiment;
    std::vector<Correlate> movesWith;
    ProposedEquation proposal;
};

/// A flow that nobody measured, as what is left tells it: a Gaussian process about 0 whose correlation falls to 1/e
/// within the time constant.
struct UnmeasuredFlow {
    std::string node;  // a connector
    double size{};     // root mean square
    std::string unit;
    double timeConstant{};  // [s]
};

/// An equation with the values of what it names: "y = min(u, y_max) with y_max = 4.2".
Text withValues(const std::string& equation, const std::vector<EffectValue>& values);

/// The model with all equations that are proposed, as they were fitted: what a study becomes when they are accepted.
struct ProposedModel {
    ModelState state;                              // without the traces
    std::map<std::string, std::string> newInputs;  // top-level inputs that were added, and the recorded channel of each
};

/// Interrupted: the search was stopped before it could say anything else.
enum class FindingKind { Adequate, Effect, Partial, Unexplained, Interrupted };
const char* name(FindingKind kind);  // "adequate" …

/// What named effects leave.
struct Unexplained {
    std::vector<Remainder> remainders;
    std::optional<UnmeasuredFlow> disturbance{};  // empty: no flow alone looks like what is left
    std::optional<ProposedModel> proposed{};      // empty: no equation is, or no block says it
};

/// How a search ended.
struct SearchEnd {
    Text notSearched{};  // why no effect was looked for; empty: they were
    bool interrupted{};  // or ended at its limit of work
    bool isAtLimitOfWork{};
    double seconds{};
};

struct Finding {
    FindingKind kind{FindingKind::Adequate};
    ModelState baseline;
    ModelState final;
    std::vector<AddedEffect> effects;
    std::vector<CandidateResult> candidates;
    Unexplained unexplained;
    Text nextExperiment;
    std::vector<Text> warnings;
    std::vector<std::string> heldInputs{};  // that the study joins by straight lines; all is told with them held
    SearchEnd end;
};

}  // namespace analogon
