#pragma once

#include <string>

#include "core/syntax/ast.hpp"

/// A tree as text, every field of it but the spans: two trees are equal when their texts are.
namespace analogon::syntax {

class TreeText {
public:
    static std::string of(const Expression& expression) { return TreeText().add(expression).text_; }
    static std::string of(const ClassDefinition& definition) { return TreeText().add(definition).text_; }
    static std::string of(const StoredDefinition& stored) {
        TreeText text;
        if (stored.within) text.word("within").add(*stored.within);
        for (const ClassPtr& one : stored.classes) text.add(*one);
        return text.text_;
    }

private:
    TreeText& word(const std::string& text) {
        text_ += text;
        text_ += ' ';
        return *this;
    }
    TreeText& flag(bool isSet, const char* name) { return isSet ? word(name) : *this; }
    TreeText& quoted(const std::string& text) { return text.empty() ? *this : word("<" + text + ">"); }
    template <class T>
    TreeText& list(const char* name, const std::vector<T>& items) {
        if (items.empty()) return *this;
        word(std::string(name) + "[");
        for (const T& item : items) add(item);
        return word("]");
    }
    template <class T>
    TreeText& optional(const char* name, const std::optional<T>& item) {
        if (item) word(name).add(*item);
        return *this;
    }

    TreeText& add(const Name& name) {
        flag(name.absolute, ".");
        for (const NamePart& part : name.parts) word(part.identifier).list("subscripts", part.subscripts);
        return *this;
    }
    TreeText& add(const NamedArgument& argument) { return word(argument.name + "=").add(argument.value); }
    TreeText& add(const Expression& e) {
        static const char* kinds[] = {"Number", "String", "Boolean", "Reference", "Unary", "Binary", "If",
                                      "Call",   "Array",  "Range",   "Colon",     "End",   "Tuple"};
        word(std::string("(") + kinds[static_cast<int>(e.kind)]);
        if (e.kind == Expression::Kind::Number || e.kind == Expression::Kind::Boolean) {
            word(std::to_string(e.number)).flag(e.isInteger, "integer");
        }
        quoted(e.text).add(e.name);
        for (const Expression& operand : e.operands) add(operand);
        list("named", e.named);
        for (const auto& [name, range] : e.iterators) word("for " + name).list("in", range);
        return word(")");
    }
    TreeText& add(const Modification& m) {
        flag(m.each, "each").flag(m.isFinal, "final").flag(m.isReplaceable, "replaceable").add(m.name);
        flag(m.hasArguments, "()").list("arguments", m.arguments).optional("=", m.value).quoted(m.description);
        if (m.redeclaredComponent) add(*m.redeclaredComponent);
        if (m.redeclaredClass) add(*m.redeclaredClass);
        return word(";");
    }
    TreeText& add(const Annotation& annotation) { return list("annotation", annotation.arguments); }
    TreeText& add(const Component& c) {
        flag(c.isProtected, "protected").flag(c.isRedeclare, "redeclare").flag(c.isFinal, "final");
        flag(c.isReplaceable, "replaceable").flag(c.isInner, "inner").flag(c.isOuter, "outer").flag(c.isFlow, "flow");
        word("variability" + std::to_string(static_cast<int>(c.variability)));
        word("causality" + std::to_string(static_cast<int>(c.causality)));
        add(c.type).word(c.name).list("dimensions", c.dimensions).list("modifications", c.modifications);
        optional("=", c.binding).optional("if", c.condition).optional("constrainedby", c.constrainedBy);
        list("constraint", c.constrainedByModifications).quoted(c.description).optional("", c.annotation);
        return word(";");
    }
    TreeText& add(const Equation& e) {
        word("equation" + std::to_string(static_cast<int>(e.kind))).add(e.left).add(e.right);
        for (const Equation::Branch& branch : e.branches) {
            word("branch").optional("if", branch.condition).list("body", branch.body);
        }
        for (const Equation::Iterator& iterator : e.iterators) word("for " + iterator.name).add(iterator.range);
        return list("body", e.body).quoted(e.description).optional("", e.annotation).word(";");
    }
    TreeText& add(const ClassDefinition& d) {
        word(keyword(d.restriction)).word(d.name).quoted(d.description);
        flag(d.isPartial, "partial").flag(d.isFinal, "final").flag(d.isEncapsulated, "encapsulated");
        flag(d.isReplaceable, "replaceable").flag(d.isRedeclare, "redeclare").flag(d.isProtected, "protected");
        for (const Import& one : d.imports) word("import " + one.alias).add(one.name).flag(one.wildcard, "*");
        for (const Extends& one : d.bases) {
            word("extends").flag(one.isProtected, "protected").add(one.base);
            list("modifications", one.modifications).optional("", one.annotation);
        }
        for (const ClassPtr& one : d.classes) add(*one);
        for (const Component& one : d.components) add(one);
        for (const EquationSection& one : d.equationSections) {
            word(one.isInitial ? "initial-section" : "section").list("equations", one.equations);
        }
        flag(d.isShort, "short").add(d.shortBase).word(std::to_string(static_cast<int>(d.shortCausality)));
        list("dimensions", d.shortDimensions).list("modifications", d.shortModifications);
        flag(d.isEnumeration, "enumeration");
        for (const std::string& literal : d.enumeration) word(literal);
        for (const std::string& text : d.enumerationDescriptions) word("<" + text + ">");
        optional("constrainedby", d.constrainedBy).list("constraint", d.constrainedByModifications);
        return optional("", d.annotation).word("end");
    }

    std::string text_;
};

}  // namespace analogon::syntax
