#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/structure/hybrid.hpp"

namespace analogon {

/// The work of partition(): what changes at events alone is taken out of a model.
class Partition {
public:
    Partition(const FlatModel& model, Signals signals, const std::vector<std::string>& symbolic);
    Outcome<HybridModel> run();

private:
    ExpressionPool& pool();
    FlatVariable& variable(VariableId id);
    bool isSlot(VariableId id) const;
    int addSlot(VariableId id);
    VariableId addVariable(std::string name, FlatType type);
    void findSlots();
    std::optional<VariableId> lone(ExpressionId id);
    bool isUnknownSlot(std::optional<VariableId> id);
    bool isContinuousVariable(std::optional<VariableId> id);
    bool isDiscreteTyped(std::optional<VariableId> id);

    struct DiscreteEquation {
        FlatEquation equation;
        std::vector<std::pair<VariableId, ExpressionId>> ways;  // variable := expression
    };
    void splitEquations();
    void splitInitialEquations();
    bool augment(std::size_t equation, std::vector<char>& seen);
    void match();
    bool runs(ExpressionId id);
    int readingOf(ExpressionId expression);
    bool isOpen(VariableId id);
    bool speaksOfOpen(ExpressionId id);
    std::optional<double> number(ExpressionId of);

    /// factor*time + rest, where the rest keeps still between events.
    struct OfTime {
        double factor{};
        ExpressionId rest;
    };
    std::optional<OfTime> ofTime(ExpressionId id);
    bool isAtEventsAlone(ExpressionId id);
    bool isChange(ExpressionId a, ExpressionId b, bool isOfOpposites);
    std::string textOf(Operation operation, ExpressionId a, ExpressionId b);
    void addRelation(Operation operation, ExpressionId a, ExpressionId b);
    void addWhole(ExpressionId of);
    ExpressionId relationSlot(Operation operation, ExpressionId a, ExpressionId b);
    ExpressionId wholeSlot(ExpressionId of);
    ExpressionId frozen(ExpressionId id);
    ExpressionId frozenAtEvents(ExpressionId id);
    ExpressionId delayed(const ExpressionNode& node);
    static bool hasParts(const ExpressionNode& node);
    ExpressionId frozenOf(const ExpressionNode& node, ExpressionId a, ExpressionId b);
    ExpressionId frozenChoice(const ExpressionNode& node);
    void rewriteContinuous();
    void rewriteDiscrete();
    int step(ExpressionId id);
    int append(const DiscreteProgram::Step& made);
    void buildProgram();
    void findReaders();
    void finish();
    std::shared_ptr<const FlatModel> outside();
    double startOf(const FlatVariable& v);

    Signals signals_;
    std::set<std::string> symbolic_;
    std::map<std::uint32_t, bool> isOpen_;  // by parameter
    std::shared_ptr<FlatModel> model_;
    FlatEvents events_;
    HybridModel out_;
    Diagnostics faults_;
    std::vector<int> slotOf_;    // by variable; -1: none
    std::vector<char> isKnown_;  // by variable: a slot that no equation sets
    std::vector<VariableId> slotIds_, readingIds_;
    std::vector<std::pair<VariableId, VariableId>> running_;  // pre(x) and x, which is no slot
    std::vector<DiscreteEquation> discrete_;
    std::vector<std::pair<VariableId, ExpressionId>> initial_;
    std::map<std::uint32_t, std::size_t> equationOf_;  // by variable
    std::map<std::uint32_t, ExpressionId> values_;     // by variable: what sets it
    std::map<std::uint32_t, bool> runs_;
    std::set<std::uint32_t> momentary_;              // flags that are set while an event is worked out only
    std::map<std::uint32_t, std::uint32_t> before_;  // by variable that is a slot: its pre()
    bool isAtEvents_{};                              // what is frozen now is asked for at events alone
    std::array<std::map<std::uint32_t, ExpressionId>, 2> frozen_;  // by isAtEvents_
    std::map<std::uint32_t, bool> isAtEventsAlone_;
    std::map<std::uint32_t, int> readings_, stepOf_;
    std::map<std::tuple<Operation, std::uint32_t, std::uint32_t>, std::size_t> relationOf_;
    std::map<std::uint32_t, std::size_t> wholeOf_;
    std::vector<std::pair<std::size_t, ExpressionId>> relationOffsets_, wholeOffsets_;
    std::set<std::uint32_t> open_, delayed_;
};

}  // namespace analogon
