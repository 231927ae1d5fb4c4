#include <fmt/format.h>

#include <utility>

#include "core/syntax/grammar.hpp"

namespace analogon::syntax {

void Grammar::refuse(Text message, Text hint) {
    cursor_.report(error(std::move(message), cursor_.here(), std::move(hint)));
}

/// Whether the function that begins here says by its annotation that the program knows it itself:
/// `annotation (__Analogon(builtin = true))`. Its algorithm is for other tools.
bool Grammar::isBuiltinFunction() const {
    constexpr std::size_t farthest = 5000;  // words
    if (!cursor_.at("function") || !cursor_.atIdentifier(1)) return false;
    const std::string_view name = cursor_.text(1);
    for (std::size_t i = 2; i < farthest && cursor_.peek(i).kind != Token::Kind::End; ++i) {
        if (cursor_.at("end", i) && cursor_.text(i + 1) == name) return false;
        if (cursor_.text(i) == "__Analogon" && cursor_.at("(", i + 1) && cursor_.text(i + 2) == "builtin") return true;
    }
    return false;
}

/// A built-in function as a class without content.
std::shared_ptr<ClassDefinition> Grammar::builtinFunction() {
    const std::size_t begin = cursor_.index();
    auto definition = std::make_shared<ClassDefinition>();
    definition->source = cursor_.source();
    definition->restriction = ClassDefinition::Restriction::Function;
    cursor_.next();
    definition->name = cursor_.text();
    definition->nameSpan = cursor_.here();
    const std::size_t name = cursor_.index();
    cursor_.next();
    definition->description = description();
    cursor_.moveTo(name);
    skipClass();
    definition->span = cursor_.spanFrom(begin);
    return definition;
}

/// Functions, operators and expandable connectors are skipped as a whole, behind their `;`.
bool Grammar::refuseClassKind() {
    std::size_t ahead = 0;
    while (cursor_.at("encapsulated", ahead) || cursor_.at("partial", ahead) || cursor_.at("pure", ahead) ||
           cursor_.at("impure", ahead)) {
        ++ahead;
    }
    const bool isFunction = cursor_.at("function", ahead);
    const bool isOperator = cursor_.at("operator", ahead);
    const bool isExpandable = cursor_.at("expandable", ahead);
    if (!isFunction && !isOperator && !isExpandable) return false;
    if (isBuiltinFunction()) return false;
    cursor_.moveTo(cursor_.index() + ahead);
    if (isFunction) refuse(phrase("functions are not supported"), phrase("write the relation as equations of a block"));
    if (isOperator)
        refuse(phrase("operator classes are not supported"), phrase("write the relation as equations of a block"));
    if (isExpandable)
        refuse(phrase("expandable connectors are not supported"), phrase("list the variables in a plain connector"));
    cursor_.next();
    while (cursor_.peek().kind == Token::Kind::Keyword && !cursor_.atEnd() && !cursor_.at("end")) cursor_.next();
    skipClass();
    cursor_.take(";");
    return true;
}

/// From the name of a class to its `end Name`, or to the `;` of a short class, which is not consumed.
void Grammar::skipClass() {
    if (!cursor_.atIdentifier()) return;
    const std::string name(cursor_.text());
    const bool isShort = cursor_.at("=", 1);
    while (!cursor_.atEnd()) {
        if (isShort && cursor_.at(";")) return;
        if (cursor_.at("end") && cursor_.atIdentifier(1) && cursor_.text(1) == name) {
            cursor_.next();
            cursor_.next();
            return;
        }
        cursor_.next();
    }
}

/// Whether a section of imperative or foreign code began here: it is reported and skipped.
bool Grammar::refuseSection() {
    const bool isInitial = cursor_.at("initial");
    if (cursor_.at("algorithm") || (isInitial && cursor_.at("algorithm", 1))) {
        refuse(isInitial ? phrase("initial algorithm sections are not supported")
                         : phrase("algorithm sections are not supported"),
               phrase("write the relations as equations"));
        skipAlgorithm();
        return true;
    }
    if (cursor_.at("external")) {
        refuse(phrase("external functions are not supported"), phrase("write the relation as equations"));
        while (!cursor_.atEnd() && !cursor_.at(";") && !closesClass()) cursor_.next();
        cursor_.take(";");
        return true;
    }
    return false;
}

void Grammar::skipAlgorithm() {
    cursor_.take("initial");
    cursor_.next();
    bool startsStatement = true;
    while (!cursor_.atEnd() && !atSection() && !closesClass()) {
        if (startsStatement && cursor_.at("annotation")) return;
        startsStatement = cursor_.at(";");
        cursor_.next();
    }
}

/// Prefixes of the language that this subset leaves out; the fault skips the declaration.
void Grammar::refuseElementPrefix() {
    if (cursor_.at("inner") || cursor_.at("outer")) {
        cursor_.fault(phrase("\"{}\" components are not supported", cursor_.text()), cursor_.here(),
                      phrase("connect the component explicitly"));
    }
    if (cursor_.at("stream")) {
        cursor_.fault(phrase("stream variables are not supported"), cursor_.here(),
                      phrase("use a potential and a flow variable"));
    }
}

}  // namespace analogon::syntax
