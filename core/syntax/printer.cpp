#include "core/syntax/printer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace analogon::syntax {

namespace {

// How tightly an expression binds, by the grammar of Modelica 3.6, A.2.7.
enum Level {
    topLevel,
    rangeLevel,
    orLevel,
    andLevel,
    notLevel,
    relationLevel,
    sumLevel,
    productLevel,
    powerLevel,
    primaryLevel
};

// The parser regroups chains of more operands; printed chains stay below, so that a tree reads back as it was.
constexpr std::size_t longestChain = 64;

Level operatorLevel(std::string_view op) {
    if (op == "or") return orLevel;
    if (op == "and") return andLevel;
    if (op == "+" || op == "-" || op == ".+" || op == ".-") return sumLevel;
    if (op == "*" || op == "/" || op == ".*" || op == "./") return productLevel;
    if (op == "^" || op == ".^") return powerLevel;
    return relationLevel;
}

Level levelOf(const Expression& expression) {
    switch (expression.kind) {
        case Expression::Kind::If:
            return topLevel;
        case Expression::Kind::Range:
            return rangeLevel;
        case Expression::Kind::Binary:
            return operatorLevel(expression.text);
        case Expression::Kind::Unary:
            return expression.text == "not" ? notLevel : sumLevel;
        case Expression::Kind::Number:
            return expression.number < 0 ? sumLevel : primaryLevel;
        default:
            return primaryLevel;
    }
}

/// Writes trees into one growing text.
class Printer {
public:
    std::string take() { return std::move(out_); }

    void expression(const Expression& expression, Level needed = topLevel) {
        const bool isEnclosed = levelOf(expression) < needed;
        if (isEnclosed) out_ += '(';
        bare(expression);
        if (isEnclosed) out_ += ')';
    }

    void modification(const Modification& modification) {
        const bool isRedeclare = (modification.redeclaredComponent && modification.redeclaredComponent->isRedeclare) ||
                                 (modification.redeclaredClass && modification.redeclaredClass->isRedeclare);
        if (isRedeclare) out_ += "redeclare ";
        if (modification.each) out_ += "each ";
        if (modification.isFinal) out_ += "final ";
        if (modification.isReplaceable) out_ += "replaceable ";
        if (modification.isBreak) return broken(modification);
        if (modification.redeclaredClass) return classHead(*modification.redeclaredClass);
        if (modification.redeclaredComponent) return componentBody(*modification.redeclaredComponent);
        name(modification.name);
        if (modification.hasArguments || !modification.arguments.empty()) modifications(modification.arguments);
        if (modification.value) {
            out_ += '=';
            expression(*modification.value);
        }
        description(modification.description);
    }

    void component(const Component& component) {
        if (component.isRedeclare) out_ += "redeclare ";
        if (component.isFinal) out_ += "final ";
        if (component.isInner) out_ += "inner ";
        if (component.isOuter) out_ += "outer ";
        if (component.isReplaceable) out_ += "replaceable ";
        componentBody(component);
        out_ += ';';
    }

    void equation(const Equation& equation) {
        switch (equation.kind) {
            case Equation::Kind::Equality:
                // An equation begins with a simple expression (A.2.6).
                expression(equation.left, rangeLevel);
                out_ += " = ";
                expression(equation.right);
                break;
            case Equation::Kind::Connect:
                out_ += "connect(";
                expression(equation.left);
                out_ += ", ";
                expression(equation.right);
                out_ += ')';
                break;
            case Equation::Kind::If:
            case Equation::Kind::When:
            case Equation::Kind::While:
                branches(equation);
                break;
            case Equation::Kind::For:
                forEquation(equation);
                break;
            case Equation::Kind::Call:
                expression(equation.left);
                break;
            case Equation::Kind::Assign:
                expression(equation.left);
                out_ += " := ";
                expression(equation.right);
                break;
            case Equation::Kind::Break:
                out_ += "break";
                break;
            case Equation::Kind::Return:
                out_ += "return";
                break;
        }
        description(equation.description);
        annotation(equation.annotation);
        out_ += ';';
    }

    void definition(const ClassDefinition& definition) {
        if (definition.isRedeclare) out_ += "redeclare ";
        if (definition.isFinal) out_ += "final ";
        if (definition.isInner) out_ += "inner ";
        if (definition.isOuter) out_ += "outer ";
        if (definition.isReplaceable) out_ += "replaceable ";
        classHead(definition);
    }

    void stored(const StoredDefinition& stored) {
        if (stored.within) {
            out_ += "within";
            if (!stored.within->parts.empty()) out_ += ' ';
            name(*stored.within);
            out_ += ";\n";
        }
        for (const ClassPtr& one : stored.classes) {
            definition(*one);
            out_ += ";\n";
        }
    }

private:
    template <class List, class Write>
    void separated(const List& list, Write write) {
        bool isFirst = true;
        for (const auto& item : list) {
            if (!std::exchange(isFirst, false)) out_ += ", ";
            write(item);
        }
    }
    void expressions(const std::vector<Expression>& list) {
        separated(list, [this](const Expression& item) { expression(item); });
    }
    void modifications(const std::vector<Modification>& list) {
        out_ += '(';
        separated(list, [this](const Modification& item) { modification(item); });
        out_ += ')';
    }
    void broken(const Modification& modification) {
        out_ += "break ";
        if (modification.brokenConnect.empty()) return name(modification.name);
        out_ += "connect(";
        expressions(modification.brokenConnect);
        out_ += ')';
    }
    void subscripts(const std::vector<Expression>& list) {
        if (list.empty()) return;
        out_ += '[';
        expressions(list);
        out_ += ']';
    }
    void name(const Name& name) {
        for (std::size_t i = 0; i < name.parts.size(); ++i) {
            if (i > 0 || name.absolute) out_ += '.';
            out_ += name.parts[i].identifier;
            subscripts(name.parts[i].subscripts);
        }
    }
    void description(const std::string& text) {
        if (text.empty()) return;
        out_ += ' ';
        out_ += printString(text);
    }
    void annotation(const std::optional<Annotation>& annotation) {
        if (!annotation) return;
        out_ += " annotation";
        modifications(annotation->arguments);
    }

    void bare(const Expression& e) {
        switch (e.kind) {
            case Expression::Kind::Number:
                return number(e);
            case Expression::Kind::String:
                out_ += printString(e.text);
                return;
            case Expression::Kind::Boolean:
                out_ += e.number != 0 ? "true" : "false";
                return;
            case Expression::Kind::Reference:
                return name(e.name);
            case Expression::Kind::Unary:
                out_ += e.text;
                if (e.text == "not") out_ += ' ';
                return expression(e.operands[0], e.text == "not" ? relationLevel : productLevel);
            case Expression::Kind::Binary:
                return binary(e);
            case Expression::Kind::If:
                return ifExpression(e);
            case Expression::Kind::Call:
                return call(e);
            case Expression::Kind::Array:
                return array(e);
            case Expression::Kind::Range:
                return range(e);
            case Expression::Kind::Colon:
                out_ += ':';
                return;
            case Expression::Kind::End:
                out_ += "end";
                return;
            case Expression::Kind::Tuple:
                out_ += '(';
                expressions(e.operands);
                out_ += ')';
                return;
            case Expression::Kind::Matrix:
                return matrix(e);
            case Expression::Kind::Function:
                out_ += "function ";
                return call(e);
            case Expression::Kind::Select:
                out_ += '(';
                expression(e.operands[0]);
                out_ += ')';
                if (!e.name.parts[0].identifier.empty()) out_ += '.';
                return name(e.name);
            case Expression::Kind::Empty:
                return;
            case Expression::Kind::Break:
                out_ += "break";
                return;
        }
    }

    void number(const Expression& e) {
        if (e.isInteger) {
            out_ += fmt::format("{:.0f}", e.number);
            return;
        }
        const std::string text = printNumber(e.number);
        out_ += text;
        if (text.find_first_of(".eE") == std::string::npos) out_ += ".0";
    }

    void binary(const Expression& e) {
        const Level level = operatorLevel(e.text);
        if (level == relationLevel || level == powerLevel) {
            const Level operand = level == relationLevel ? sumLevel : primaryLevel;
            expression(e.operands[0], operand);
            operation(e.text);
            expression(e.operands[1], operand);
            return;
        }
        // Left-associative: a chain is printed in one go, without recursion over its left operands.
        std::vector<const Expression*> spine;
        const Expression* first = &e;
        while (first->kind == Expression::Kind::Binary && operatorLevel(first->text) == level &&
               spine.size() + 1 < longestChain) {
            spine.push_back(first);
            first = &first->operands[0];
        }
        const bool isChainLeft = first->kind == Expression::Kind::Binary && operatorLevel(first->text) == level;
        expression(*first, isChainLeft ? primaryLevel : level);
        for (auto link = spine.rbegin(); link != spine.rend(); ++link) {
            operation((*link)->text);
            expression((*link)->operands[1], static_cast<Level>(level + 1));
        }
    }

    void operation(const std::string& op) {
        const bool isTight = op == "*" || op == "/" || op == "^";
        if (!isTight) out_ += ' ';
        out_ += op;
        if (!isTight) out_ += ' ';
    }

    void ifExpression(const Expression& e) {
        std::size_t i = 0;
        for (; i + 1 < e.operands.size(); i += 2) {
            out_ += i == 0 ? "if " : " elseif ";
            expression(e.operands[i]);
            out_ += " then ";
            expression(e.operands[i + 1]);
        }
        out_ += " else ";
        expression(e.operands[i]);
    }

    void call(const Expression& e) {
        name(e.name);
        out_ += '(';
        expressions(e.operands);
        if (!e.operands.empty() && !e.named.empty()) out_ += ", ";
        separated(e.named, [this](const NamedArgument& argument) {
            out_ += argument.name;
            out_ += '=';
            expression(argument.value);
        });
        iterators(e);
        out_ += ')';
    }

    void matrix(const Expression& e) {
        out_ += '[';
        bool isFirst = true;
        for (const Expression& row : e.operands) {
            if (!std::exchange(isFirst, false)) out_ += "; ";
            expressions(row.operands);
        }
        out_ += ']';
    }

    void array(const Expression& e) {
        out_ += '{';
        expressions(e.operands);
        iterators(e);
        out_ += '}';
    }

    void iterators(const Expression& e) {
        if (e.iterators.empty()) return;
        out_ += " for ";
        separated(e.iterators, [this](const auto& iterator) {
            out_ += iterator.first;
            if (iterator.second.empty()) return;
            out_ += " in ";
            expression(iterator.second.front());
        });
    }

    void range(const Expression& e) {
        for (std::size_t i = 0; i < e.operands.size(); ++i) {
            if (i > 0) out_ += ':';
            expression(e.operands[i], orLevel);
        }
    }

    void newLine() {
        out_ += '\n';
        out_.append(indentation_, ' ');
    }

    void branches(const Equation& equation) {
        const bool isWhen = equation.kind == Equation::Kind::When, isWhile = equation.kind == Equation::Kind::While;
        const char* const word = isWhen ? "when" : isWhile ? "while" : "if";
        bool isFirst = true;
        for (const Equation::Branch& branch : equation.branches) {
            if (!isFirst) newLine();
            if (branch.condition) {
                if (!isFirst) out_ += "else";
                out_ += word;
                out_ += ' ';
                expression(*branch.condition);
                out_ += isWhile ? " loop" : " then";
            } else {
                out_ += "else";
            }
            isFirst = false;
            body(branch.body);
        }
        newLine();
        out_ += "end ";
        out_ += word;
    }

    void forEquation(const Equation& equation) {
        out_ += "for ";
        separated(equation.iterators, [this](const Equation::Iterator& iterator) {
            out_ += iterator.name;
            if (iterator.range.kind == Expression::Kind::Empty) return;
            out_ += " in ";
            expression(iterator.range);
        });
        out_ += " loop";
        body(equation.body);
        newLine();
        out_ += "end for";
    }

    void body(const std::vector<Equation>& list) {
        indentation_ += 2;
        for (const Equation& one : list) {
            newLine();
            equation(one);
        }
        indentation_ -= 2;
    }

    void componentBody(const Component& c) {
        if (c.isFlow) out_ += "flow ";
        if (c.isStream) out_ += "stream ";
        switch (c.variability) {
            case Variability::Continuous:
                break;
            case Variability::Discrete:
                out_ += "discrete ";
                break;
            case Variability::Parameter:
                out_ += "parameter ";
                break;
            case Variability::Constant:
                out_ += "constant ";
                break;
        }
        causality(c.causality);
        name(c.type);
        out_ += ' ';
        out_ += c.name;
        subscripts(c.dimensions);
        if (!c.modifications.empty() || c.modificationsSpan.begin != c.modificationsSpan.end) {
            modifications(c.modifications);
        }
        if (c.binding) {
            out_ += " = ";
            expression(*c.binding);
        }
        if (c.condition) {
            out_ += " if ";
            expression(*c.condition);
        }
        description(c.description);
        annotation(c.annotation);
        constraint(c.constrainedBy, c.constrainedByModifications);
    }

    void causality(Causality causality) {
        if (causality == Causality::Input) out_ += "input ";
        if (causality == Causality::Output) out_ += "output ";
    }

    void constraint(const std::optional<Name>& base, const std::vector<Modification>& list) {
        if (!base) return;
        out_ += " constrainedby ";
        name(*base);
        if (!list.empty()) modifications(list);
    }

    void classHead(const ClassDefinition& definition) {
        if (definition.isEncapsulated) out_ += "encapsulated ";
        if (definition.isPartial) out_ += "partial ";
        if (definition.isPure) out_ += "pure ";
        if (definition.isImpure) out_ += "impure ";
        if (definition.isExpandable) out_ += "expandable ";
        if (definition.isOperator) out_ += "operator ";
        out_ += keyword(definition.restriction);
        out_ += ' ';
        if (definition.extendsItself) out_ += "extends ";
        out_ += definition.name;
        if (definition.extendsItself && !definition.shortModifications.empty())
            modifications(definition.shortModifications);
        if (definition.isShort) {
            shortClass(definition);
        } else {
            longClass(definition);
        }
        constraint(definition.constrainedBy, definition.constrainedByModifications);
    }

    void shortClass(const ClassDefinition& definition) {
        out_ += " = ";
        if (definition.isEnumeration) {
            out_ += "enumeration(";
            if (definition.isOpenEnumeration) out_ += ':';
            for (std::size_t i = 0; i < definition.enumeration.size(); ++i) {
                if (i > 0) out_ += ", ";
                out_ += definition.enumeration[i];
                if (i < definition.enumerationDescriptions.size()) description(definition.enumerationDescriptions[i]);
            }
            out_ += ')';
        } else if (!definition.derivativeOf.empty()) {
            out_ += "der(";
            name(definition.shortBase);
            for (const std::string& input : definition.derivativeOf) out_ += ", " + input;
            out_ += ')';
        } else {
            causality(definition.shortCausality);
            name(definition.shortBase);
            subscripts(definition.shortDimensions);
            if (!definition.shortModifications.empty()) modifications(definition.shortModifications);
        }
        description(definition.description);
        annotation(definition.annotation);
    }

    void longClass(const ClassDefinition& definition) {
        description(definition.description);
        indentation_ += 2;
        bool isProtected = false;
        for (const Import& one : definition.imports) import(one);
        for (const Extends& base : definition.bases) extends(base, isProtected);
        for (const ClassPtr& nested : definition.classes) {
            visibility(nested->isProtected, isProtected);
            newLine();
            this->definition(*nested);
            out_ += ';';
        }
        for (const Component& one : definition.components) {
            visibility(one.isProtected, isProtected);
            newLine();
            component(one);
        }
        for (const EquationSection& one : definition.equationSections)
            section(one, one.isInitial ? "initial equation" : "equation");
        for (const EquationSection& one : definition.algorithmSections)
            section(one, one.isInitial ? "initial algorithm" : "algorithm");
        if (definition.external) external(*definition.external);
        if (definition.annotation) {
            newLine();
            out_ += "annotation";
            modifications(definition.annotation->arguments);
            out_ += ';';
        }
        indentation_ -= 2;
        newLine();
        out_ += "end ";
        out_ += definition.name;
    }

    void visibility(bool wanted, bool& current) {
        if (wanted == current) return;
        current = wanted;
        sectionWord(wanted ? "protected" : "public");
    }

    void sectionWord(std::string_view word) {
        indentation_ -= 2;
        newLine();
        out_ += word;
        indentation_ += 2;
    }

    void import(const Import& import) {
        newLine();
        out_ += "import ";
        const bool isRenamed =
            !import.wildcard && !import.name.parts.empty() && import.alias != import.name.parts.back().identifier;
        if (isRenamed) {
            out_ += import.alias;
            out_ += " = ";
        }
        name(import.name);
        if (import.wildcard) out_ += ".*";
        out_ += ';';
    }

    void extends(const Extends& base, bool& isProtected) {
        visibility(base.isProtected, isProtected);
        newLine();
        out_ += "extends ";
        name(base.base);
        if (!base.modifications.empty()) modifications(base.modifications);
        annotation(base.annotation);
        out_ += ';';
    }

    void external(const External& external) {
        sectionWord("external");
        if (!external.language.empty()) out_ += ' ' + printString(external.language);
        if (external.result) {
            out_ += ' ';
            expression(*external.result);
            out_ += " =";
        }
        if (!external.function.empty()) {
            out_ += ' ' + external.function + '(';
            expressions(external.arguments);
            out_ += ')';
        }
        annotation(external.annotation);
        out_ += ';';
    }

    void section(const EquationSection& section, std::string_view word) {
        sectionWord(word);
        for (const Equation& one : section.equations) {
            newLine();
            equation(one);
        }
    }

    std::string out_;
    std::size_t indentation_{};
};

}  // namespace

std::string print(const Expression& expression) {
    Printer printer;
    printer.expression(expression);
    return printer.take();
}

std::string print(const Modification& modification) {
    Printer printer;
    printer.modification(modification);
    return printer.take();
}

std::string print(const Equation& equation) {
    Printer printer;
    printer.equation(equation);
    return printer.take();
}

std::string print(const Component& component) {
    Printer printer;
    printer.component(component);
    return printer.take();
}

std::string print(const ClassDefinition& definition) {
    Printer printer;
    printer.definition(definition);
    return printer.take();
}

std::string print(const StoredDefinition& definition) {
    Printer printer;
    printer.stored(definition);
    return printer.take();
}

std::string printNumber(double value) {
    std::array<char, 64> buffer{};
    const auto format = [&](auto... how) {
        const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, how...).ptr;
        return std::string(buffer.data(), end);
    };
    // The shortest digits; few zeros are written out (0.001, 100000), many as an exponent (1e-6).
    const std::string scientific = format(std::chars_format::scientific);
    const auto e = scientific.find('e');
    if (e == std::string::npos) return scientific;
    const int exponent = std::atoi(scientific.c_str() + e + 1);
    if (exponent >= -4 && exponent < 7) return format(std::chars_format::fixed);
    return fmt::format("{}e{}", scientific.substr(0, e), exponent);
}

std::string printString(const std::string& text) {
    std::string result;
    result.reserve(text.size() + 2);
    result += '"';
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    result += '"';
    return result;
}

}  // namespace analogon::syntax
