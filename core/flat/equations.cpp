#include "core/flat/equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/flat/binder.hpp"
#include "core/flat/connections.hpp"
#include "core/flat/events.hpp"
#include "core/flat/executor.hpp"
#include "core/flat/instantiator.hpp"
#include "core/flat/refused_construct.hpp"
#include "core/flat/translator.hpp"

namespace analogon {

using Kind = syntax::Equation::Kind;

namespace {

bool holdsConnection(const syntax::Equation& equation) {
    const auto holds = [](const std::vector<syntax::Equation>& body) {
        return std::any_of(body.begin(), body.end(), holdsConnection);
    };
    return equation.kind == Kind::Connect || holds(equation.body) ||
           std::any_of(equation.branches.begin(), equation.branches.end(),
                       [&](const auto& branch) { return holds(branch.body); });
}

}  // namespace

void Equations::translateAll() {
    const std::size_t before = work_.messages.diagnostics().size();
    for (const Pass pass : {Pass::Connections, Pass::Others}) {
        pass_ = pass;
        for (std::size_t c = 0; c < work_.components.size() && !work_.messages.full(); ++c)
            translateSections(*work_.components[c]);
        work_.connections->allAreRead();
    }
    work_.messages.sortFrom(before);
}

void Equations::translateSections(Instance& instance) {
    for (const Instance::Part& part : instance.parts) {
        for (const auto& section : part.definition->algorithmSections) {
            if (pass_ == Pass::Connections) break;
            work_.events->refuse(section.isInitial ? phrase("initial algorithm sections are not supported")
                                                   : phrase("algorithm sections are not supported"),
                                 section.keyword, phrase("write the relations as equations"));
            Executor(work_).section(section, {&instance, part.lexical});
        }
        for (const auto& section : part.definition->equationSections) {
            found_.clear();
            isInitial_ = section.isInitial;
            translate(section.equations, {&instance, part.lexical});
            auto& target = isInitial_ ? work_.model.initialEquations : work_.model.equations;
            std::ranges::move(found_, std::back_inserter(target));
            if (!isInitial_) instance.equations += static_cast<int>(found_.size());
        }
    }
}

void Equations::translate(const List& equations, const Scope& scope) {
    for (const auto& equation : equations) {
        if (work_.messages.full()) return;
        translate(equation, scope);
    }
}

void Equations::translate(const syntax::Equation& equation, const Scope& scope) {
    if (pass_ == Pass::Connections ? !holdsConnection(equation) : equation.kind == Kind::Connect) return;
    switch (equation.kind) {
        case Kind::Equality:
            return equality(equation, scope);
        case Kind::Connect:
            if (isInitial_ || isSwitched_) {
                work_.messages.error(isInitial_
                                         ? phrase("'connect' cannot stand in an initial equation section")
                                         : phrase("'connect' needs a condition that is known before the simulation"),
                                     equation.span);
                return;
            }
            return work_.connections->connect(equation, scope);
        case Kind::If:
            return conditional(equation, scope);
        case Kind::For:
            return loop(equation, 0, scope);
        case Kind::Call:
            return assertion(equation, scope);
        case Kind::When:
            if (isInitial_ || isSwitched_) {
                work_.messages.error(isInitial_ ? phrase("'when' cannot stand in an initial equation section")
                                                : phrase("'when' cannot stand within an 'if' that changes"),
                                     equation.keyword);
                return;
            }
            return work_.events->when(equation, scope);
        default:  // statements stand in algorithms
            return;
    }
}

void Equations::equality(const syntax::Equation& equation, const Scope& scope) {
    if (equation.left.kind == syntax::Expression::Kind::Tuple) return several(equation, scope);
    work_.translator->setTarget(true);
    const auto left = work_.translator->translate(equation.left, scope);
    work_.translator->setTarget(false);
    const auto right = work_.translator->translate(equation.right, scope);
    if (!left || !right) return;
    if (left->type == FlatType::String) return text(equation, *right, scope);
    equal(*left, *right, equation, scope);
}

/// A text that a variable has all the time: what is known of it now.
void Equations::text(const syntax::Equation& equation, const Value& value, const Scope& scope) {
    const bool isName = equation.left.kind == syntax::Expression::Kind::Reference && guards_.empty() && !isInitial_;
    const auto slice = isName ? work_.translator->resolve(equation.left.name, scope) : std::nullopt;
    if (!slice || value.type != FlatType::String || slice->dimensions != value.dimensions) {
        work_.messages.error(phrase("an equation of texts is: variable = text"), equation.span);
        return;
    }
    for (std::size_t k = 0; k < slice->variables.size(); ++k) {
        VariableRecord& record = work_.records[slice->variables[k].value];
        FlatVariable& variable = work_.model.variables[slice->variables[k].value];
        if (record.isBound) {
            work_.messages.error(phrase("the text '{}' is set twice", variable.name), equation.span);
            return;
        }
        record.isBound = true;
        variable.text = value.texts[k];
    }
}

/// `(x, , y) = f(u)`
void Equations::several(const syntax::Equation& equation, const Scope& scope) {
    const auto results = work_.translator->outputsOf(equation.right, scope);
    if (!results) return;
    const auto& targets = equation.left.operands;
    if (targets.size() > results->size()) {
        work_.messages.error(
            phrase("'{}' has {} outputs, not {}", equation.right.name.text(), results->size(), targets.size()),
            equation.span);
        return;
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        if (targets[i].kind == syntax::Expression::Kind::Empty) continue;
        const auto left = work_.translator->translate(targets[i], scope);
        if (left) equal(*left, (*results)[i], equation, scope);
    }
}

void Equations::equal(const Value& leftValue, const Value& rightValue, const syntax::Equation& equation,
                      const Scope& scope) {
    const Value *left = &leftValue, *right = &rightValue;
    if (left->isRecord() && right->isRecord()) {
        for (const auto& [name, member] : left->members) {
            const Value* const other = right->member(name);
            if (!other) {
                work_.messages.error(phrase("'{}' has no member '{}'", typeText(*right), name), equation.span);
                return;
            }
            equal(member, *other, equation, scope);
        }
        return;
    }
    const bool bothNumeric = left->isNumeric() && right->isNumeric();
    const bool sameType = left->type == right->type && left->enumeration == right->enumeration;
    if ((!bothNumeric && !sameType) || left->type == FlatType::String || left->isRecord() || right->isRecord()) {
        work_.messages.error(
            phrase("the sides of the equation differ in type: {} and {}", typeText(*left), typeText(*right)),
            equation.span);
        return;
    }
    if (left->dimensions != right->dimensions) {
        work_.messages.error(
            phrase("the sides of the equation differ in size: {} and {}", typeText(*left), typeText(*right)),
            equation.span);
        return;
    }
    // More equations than there can be unknowns have no solution.
    if (work_.model.equations.size() + found_.size() + left->elements.size() > Instantiator::mostScalars)
        return work_.messages.fatal(phrase("the model has more than {} equations", Instantiator::mostScalars),
                                    equation.span);
    const bool mayBeValue = isInitial_ && guards_.empty();  // known at once, what follows may need to know it
    for (std::size_t k = 0; k < left->elements.size(); ++k) {
        const FlatEquation one{left->elements[k], right->elements[k], equation.span, scope.instance->name, false};
        if (!mayBeValue || !work_.binder->takeInitialValue(one)) found_.push_back(one);
    }
}

/// Branches on parameters are chosen now; from the first condition that is not known yet on, the rest is switched.
void Equations::conditional(const syntax::Equation& equation, const Scope& scope) {
    for (std::size_t b = 0; b < equation.branches.size(); ++b) {
        const auto& branch = equation.branches[b];
        if (!branch.condition) return translate(branch.body, scope);
        const auto condition = work_.translator->translate(*branch.condition, scope);
        if (!condition) return;
        if (condition->type != FlatType::Boolean || !condition->isScalar()) {
            work_.messages.error(phrase("the condition after 'if' must be Boolean, not {}", typeText(*condition)),
                                 branch.condition->span);
            return;
        }
        const bool isParametric = work_.translator->isParametric(condition->elements[0]);
        const auto holds = isParametric ? work_.translator->constantNumber(condition->elements[0], true) : std::nullopt;
        if (!holds) return switched(equation, b, scope);  // it runs, or is found at the start
        if (*holds != 0) return translate(branch.body, scope);
    }
}

/// Branches with the same number of equations: 0 = if c then l1 - r1 else l2 - r2, each in turn (section 8.3.4).
void Equations::switched(const syntax::Equation& equation, std::size_t firstOpen, const Scope& scope) {
    std::vector<FlatEquation> outside;
    outside.swap(found_);
    const bool wasSwitched = std::exchange(isSwitched_, true);
    std::vector<ExpressionId> conditions;
    std::vector<std::vector<FlatEquation>> bodies;
    bool hasElse = false;
    for (std::size_t b = firstOpen; b < equation.branches.size(); ++b) {
        const auto& branch = equation.branches[b];
        hasElse = !branch.condition;
        if (branch.condition) {
            const auto condition = work_.translator->translate(*branch.condition, scope);
            conditions.push_back(condition && !condition->elements.empty() ? condition->elements[0]
                                                                           : work_.pool.constant(0));
        }
        ExpressionId here = work_.pool.constant(1);
        for (std::size_t c = 0; c < conditions.size(); ++c) {
            const bool isOwn = branch.condition && c + 1 == conditions.size();
            here = work_.pool.binary(Operation::And, here,
                                     isOwn ? conditions[c] : work_.pool.unary(Operation::Not, conditions[c]));
        }
        guards_.push_back(here);
        translate(branch.body, scope);
        guards_.pop_back();
        bodies.push_back(std::exchange(found_, {}));
    }
    isSwitched_ = wasSwitched;
    found_ = std::move(outside);
    bool sameCount = hasElse || bodies[0].empty();  // checks alone need no other branch
    for (const auto& body : bodies) sameCount = sameCount && body.size() == bodies[0].size();
    if (!sameCount) {
        work_.messages.error(phrase("an 'if' on a condition that changes needs as many equations in each branch"),
                             equation.span, phrase("add the missing branch, or use a parameter in the condition"));
        return;
    }
    ExpressionPool& pool = work_.pool;
    for (std::size_t k = 0; k < bodies[0].size(); ++k) {
        bool sameLeft = true;
        for (const auto& body : bodies) sameLeft = sameLeft && body[k].left == bodies[0][k].left;
        const auto side = [&](const FlatEquation& e) { return sameLeft ? e.right : pool.subtract(e.left, e.right); };
        ExpressionId chosen = side(bodies.back()[k]);
        for (std::size_t b = conditions.size(); b-- > 0;)
            chosen = pool.ifThenElse(conditions[b], side(bodies[b][k]), chosen);
        FlatEquation merged = bodies[0][k];
        merged.left = sameLeft ? merged.left : pool.constant(0);
        merged.right = chosen;
        found_.push_back(merged);
    }
}

void Equations::loop(const syntax::Equation& equation, std::size_t iterator, const Scope& scope) {
    if (iterator == equation.iterators.size()) return translate(equation.body, scope);
    const auto& [name, range, span] = equation.iterators[iterator];
    const auto values = work_.translator->rangeOf(equation, iterator, scope);
    if (!values) return;
    for (int k = 1; k <= values->dimensions[0] && !work_.messages.full(); ++k) {
        if (++turns_ > 4 * Instantiator::mostScalars) {
            work_.messages.fatal(phrase("the loops run through more than {} values", 4 * Instantiator::mostScalars),
                                 span);
            return;
        }
        work_.translator->pushIterator(name, values->part(k));
        loop(equation, iterator + 1, scope);
        work_.translator->popIterator();
    }
}

bool Equations::isWarning(const syntax::Expression& call, const Scope& scope) {
    const syntax::Expression* level = call.operands.size() > 2 ? &call.operands[2] : nullptr;
    for (const syntax::NamedArgument& argument : call.named)
        if (argument.name == "level") level = &argument.value;
    const auto value = level ? work_.translator->translate(*level, scope) : std::nullopt;
    const auto number = value && value->elements.size() == 1
                            ? work_.translator->constantNumber(value->elements[0], true)
                            : std::nullopt;
    return number && *number == 2;
}

/// assert on parameters is checked here; one on variables by whoever simulates with events.
void Equations::assertion(const syntax::Equation& equation, const Scope& scope) {
    const syntax::Expression& call = equation.left;
    const std::string name = call.name.text();
    if (name != "assert" && name != "terminate" && name != "reinit" && work_.lookup(call.name, scope.lexical)) {
        work_.translator->outputsOf(call, scope);  // a function that only looks, or tells
        return;
    }
    if (tellRefused(work_.messages, name, equation.span)) return;
    if (name != "assert" || call.operands.size() < 2) {
        work_.messages.error(phrase("'{}' cannot stand as an equation", name), equation.span,
                             phrase("write: left = right"));
        return;
    }
    const auto condition = work_.translator->translate(call.operands[0], scope);
    const auto text = work_.translator->translate(call.operands[1], scope);
    if (!condition || !text) return;
    if (condition->type != FlatType::Boolean || !condition->isScalar() || text->type != FlatType::String) {
        work_.messages.error(phrase("'assert' needs a Boolean condition and a text"), equation.span);
        return;
    }
    ExpressionId guard = work_.pool.constant(1);
    for (const ExpressionId each : guards_) guard = work_.pool.binary(Operation::And, guard, each);
    const auto holds = guards_.empty() ? work_.translator->constantNumber(condition->elements[0], false) : std::nullopt;
    if (!holds)
        work_.events->action(equation, guard, scope);
    else if (holds && *holds == 0 && !isWarning(call, scope))
        work_.messages.error(phrase("{}: {}", scope.instance->label(), text->texts[0]), equation.span,
                             phrase("the condition of 'assert' does not hold"));
}

}  // namespace analogon
