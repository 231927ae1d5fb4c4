#pragma once

#include <vector>

#include "core/flat/flattening.hpp"

namespace analogon {

/// Equation sections to scalar equations (Modelica 3.6, chapter 8).
class Equations {
public:
    explicit Equations(Flattening& work) : work_(work) {}

    void translateAll();

private:
    using List = std::vector<syntax::Equation>;
    enum class Pass { Connections, Others };  // cardinality() counts connections

    void translateSections(Instance& instance);

    void translate(const syntax::Equation& equation, const Scope& scope);
    void translate(const List& equations, const Scope& scope);
    void equality(const syntax::Equation& equation, const Scope& scope);
    void text(const syntax::Equation& equation, const Value& value, const Scope& scope);
    void several(const syntax::Equation& equation, const Scope& scope);
    void equal(const Value& left, const Value& right, const syntax::Equation& equation, const Scope& scope);
    bool isWarning(const syntax::Expression& call, const Scope& scope);
    void conditional(const syntax::Equation& equation, const Scope& scope);
    void switched(const syntax::Equation& equation, std::size_t firstOpen, const Scope& scope);
    void loop(const syntax::Equation& equation, std::size_t iterator, const Scope& scope);
    void assertion(const syntax::Equation& equation, const Scope& scope);

    Flattening& work_;
    Pass pass_{Pass::Connections};
    std::vector<FlatEquation> found_;
    bool isInitial_{};
    std::vector<ExpressionId> guards_;  // of the branches under way
    bool isSwitched_{};                 // below an `if` whose condition changes while the model runs
    std::size_t turns_{};
};

}  // namespace analogon
