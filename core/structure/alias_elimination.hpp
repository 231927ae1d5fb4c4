#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/structure/alias.hpp"
#include "core/structure/alias_classes.hpp"

namespace analogon {

/// Equal and constant variables become one: linear equations merge their classes (rows), then each class gets a
/// variable that stands for it (representatives). For eliminateAliases() alone.
class AliasElimination {
public:
    explicit AliasElimination(FoldedModel folded)
        : folded_(std::move(folded)), system_(folded_.system), pool_(*system_.pool) {}

    Outcome<AliasedSystem> run();

private:
    using Signed = AliasClasses::Signed;
    /// A linear equation with constant coefficients: sum of coefficient * entity + constant = 0.
    struct Row {
        std::vector<std::pair<int, double>> terms;
        double constant{};
        std::size_t equation{};
        bool isOpen{true};
    };

    // alias_rows.cpp: what linear equations tell
    void createEntities();
    int entityOf(ExpressionId node);
    bool round();
    void joinEqualSides();
    std::optional<Row> rowOf(const Equation& equation);
    bool addTerms(ExpressionId of, double scale, Row& row);
    Row seen(const Row& row, double largest) const;
    void process(Row& row);
    void letWait(const Row& row, int number);
    std::vector<int> takeWaiting(int root);
    void refuse(const Equation& equation, const Text& why);
    void addLeftEquations();
    void closeInputs();
    Text slopesOf(int derivativeClass);

    // alias.cpp: what stands for each class, and the unknowns that are left
    void chooseRepresentatives();
    int score(VariableId id, const Signed& root) const;
    ExpressionId signedNode(ExpressionId node, int sign) { return sign < 0 ? pool_.negate(node) : node; }
    ExpressionId representative(ExpressionId node);
    void rewriteEquations();
    std::vector<char> idleDerivatives();
    void listUnknowns();
    void mergeAttributes();
    void mergeStart(VariableId id, int sign, Unknown& unknown, VariableId& fixedBy);

    bool isUnknownVariable(const FlatVariable& v) const {
        return v.variability == FlatVariability::Continuous && v.type != FlatType::String;
    }

    FoldedModel folded_;
    EquationSystem& system_;
    ExpressionPool& pool_;
    AliasClasses classes_;
    std::vector<int> entityOfNode_;        // by node id
    std::vector<ExpressionId> nodeOf_;     // by entity
    std::vector<ExpressionId> standsFor_;  // by root: the node that stands for the class (times sign of its entity)
    std::vector<char> isOpen_;             // by equation: still an equation
    std::vector<char> isDifferentiated_;   // by variable
    std::vector<Equation> redundant_;
    Diagnostics faults_;
};

}  // namespace analogon
