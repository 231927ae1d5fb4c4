#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/flat/flat_model.hpp"

namespace analogon {

/// Operations in an order in which each has what it needs; leaves are slots, readings and the time. What is set is read
/// as it is set, unless that goes round in a circle: then as it was before.
class DiscreteProgram {
public:
    struct Step {
        Operation operation{Operation::Constant};
        double value{};           // Constant; Table: its number
        int a{-1}, b{-1}, c{-1};  // steps
        int slot{-1};             // Variable: a slot …
        int reading{-1};          // … or a reading
    };

    /// All steps for these slots, readings and time; `values` is one number a step.
    void run(const std::vector<double>& slots, const std::vector<double>& readings, double time,
             std::vector<double>& values) const;
    /// The same where `values` are those of the last run or empty: only what depends on something that has changed
    /// is worked out again. `isDue` is room for it.
    void update(const std::vector<double>& slots, const std::vector<double>& readings, double time,
                std::vector<double>& values, std::vector<char>& isDue) const;
    /// Finds who reads which step; to be called when all steps stand.
    void findReaders();
    /// How the steps move with slots, readings and time, by the values of all of them: `slots` and `readings` are K
    /// tangents each, row-major, `time` K. What only jumps does not move.
    void runTangents(const std::vector<double>& values, const std::vector<double>& slots,
                     const std::vector<double>& readings, const std::vector<double>& time,
                     std::vector<double>& tangents) const;

    std::vector<Step> steps;
    std::vector<LookupTable> tables;

private:
    double valueOf(const Step& step, const std::vector<double>& slots, const std::vector<double>& readings, double time,
                   const std::vector<double>& values) const;

    std::vector<int> leaves_;                 // slots, readings and the time
    std::vector<int> readers_, firstReader_;  // by step: from its first to that of the next one
};

/// A model with events as two that take turns (Modelica 3.6, appendix B). Between events the discrete quantities (the
/// slots) keep their values: they are parameters of `continuous`. At an event its outputs (the readings) and the slots
/// decide what the slots become.
struct HybridModel {
    /// slot := step of the program.
    struct Assignment {
        int slot{}, step{};
    };
    /// A relation of continuous quantities: the slot holds whether it holds, the reading is left - right.
    struct Relation {
        int slot{}, reading{};
        Operation operation{};
        bool isOfTime{};  // factor*time + offset (a step): its crossing is known in advance
        double factor{};
        int offset{-1};
        std::string text{};  // as it is told: "x > 0"
        bool isWatched{};    // its crossing is an event; else it is asked for at events alone
    };
    /// The slot holds floor(reading).
    struct Whole {
        int slot{}, reading{};
        bool isOfTime{};
        double factor{};
        int offset{-1};
        bool isWatched{};
    };
    struct Sample {
        int slot{};
        int start{}, interval{};  // steps; what they read is found at the start and stays
        Span span;
    };
    /// A subscript that must lie in 1:extent.
    struct Subscript {
        int index{};  // a step
        int extent{};
        Span span;
    };
    struct Reinit {
        int condition{}, value{};  // steps
        std::string variable;
        Span span;
    };
    struct Check {
        int condition{};  // a step
        std::string message;
        bool isWarning{}, isTerminate{};
        Span span;
    };

    /// An input of the continuous model: a reading as it was some time before.
    struct Delay {
        std::string input;
        int reading{};
        double time{};  // [s], above 0
    };

    /// An output of the model itself: one of the continuous model, or a slot.
    struct Output {
        std::string name;
        int slot{-1};  // -1: of the continuous model
    };

    std::shared_ptr<const FlatModel> continuous;
    /// Where the signals of the model are kept: the same with its inputs and outputs alone, for whoever asks what goes
    /// in and comes out. A slot that is an output is a variable there, and the slot has another name (`outsideSlots`).
    std::shared_ptr<const FlatModel> outside;
    std::vector<std::string> outsideSlots;
    std::vector<Output> outputs;
    std::vector<std::string> slots;               // names: parameters of the continuous model
    std::vector<double> starts;                   // of the slots
    std::vector<char> isRead;                     // by slot: whether the motion between events depends on it
    std::vector<std::string> readings;            // names: its outputs, in order
    std::vector<std::pair<int, int>> pres;        // slot of pre(x), slot of x
    std::vector<std::pair<int, int>> leftLimits;  // slot of pre(x), reading of an x that runs
    int initial{-1}, terminal{-1};                // slots; -1: not used
    DiscreteProgram program;
    std::vector<Assignment> assignments;
    std::vector<Assignment> initialAssignments;  // to pre(x)
    std::vector<Relation> relations;
    std::vector<Whole> wholes;
    std::vector<Sample> samples;
    std::vector<Reinit> reinits;
    std::vector<Check> checks;
    std::vector<Subscript> subscripts;
    std::vector<Delay> delays;
};

/// What becomes of the model's own inputs and outputs. A class by itself has nobody who drives it: inputs stay at their
/// starts, outputs are variables like others.
enum class Signals { Dropped, Kept };

/// `symbolic`: parameters that may take other values than the model's own.
Outcome<HybridModel> partition(const FlatModel& model, Signals signals = Signals::Dropped,
                               const std::vector<std::string>& symbolic = {});

}  // namespace analogon
