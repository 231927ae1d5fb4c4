#include "core/syntax/cursor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace analogon::syntax {

namespace {

constexpr int deepestNesting = 128;
constexpr std::size_t mostFaults = 25;

}  // namespace

Cursor::Cursor(SourcePtr source, LexedText lexed)
    : source_(std::move(source)),
      text_(source_->text().data()),
      tokens_(std::move(lexed.tokens)),
      diagnostics_(std::move(lexed.faults)),
      isCutShort_(lexed.isCutShort) {}

Token Cursor::next() {
    const Token token = peek();
    if (index_ + 1 < tokens_.size()) ++index_;
    return token;
}

bool Cursor::take(std::string_view word) {
    if (!at(word)) return false;
    next();
    return true;
}

void Cursor::faultNoIdentifier(const Text& what) {
    Text hint;
    if (peek().kind == Token::Kind::Keyword)
        hint = phrase("\"{}\" is a word of the language; choose another name", text());
    faultExpected(what, std::move(hint));
}

void Cursor::noSemicolon(const Text& afterWhat) {
    const auto lineOf = [this](std::uint32_t offset) { return source_->position(offset).line; };
    const bool isNewLine = index_ > 0 && lineOf(tokens_[index_ - 1].end) < lineOf(peek().begin);
    const bool continues = isNewLine || at("end") || at("equation") || at("annotation") || at("protected");
    Text message = !continues || atEnd() ? phrase("expected \";\" after {}, found {}", afterWhat, describe(peek()))
                                         : phrase("expected \";\" after {}", afterWhat);
    if (!continues) fault(std::move(message), here());
    if (!(atEnd() && isCutShort_)) report(error(std::move(message), behind()));
}

Span Cursor::spanFrom(std::size_t index) const {
    const Token& first = tokens_[std::min(index, tokens_.size() - 1)];
    const std::uint32_t end = index_ > index ? tokens_[index_ - 1].end : first.begin;
    return {source_.get(), first.begin, end};
}

Span Cursor::behind() const {
    const std::uint32_t end = index_ > 0 ? tokens_[index_ - 1].end : 0;
    return {source_.get(), end, end};
}

void Cursor::report(Diagnostic diagnostic) {
    if (gaveUp_) return;
    diagnostics_.push_back(std::move(diagnostic));
    if (diagnostics_.size() >= mostFaults) {
        gaveUp_ = true;
        diagnostics_.push_back(error(phrase("too many faults: the rest of the text was not read"), here()));
    }
}

void Cursor::fault(Text message, const Span& span, Text hint) {
    // What lacks behind an open string or comment follows from that, and one place gets one message.
    const bool follows = (isCutShort_ && atEnd()) || span.begin == lastFaultAt_;
    lastFaultAt_ = span.begin;
    if (!follows) report(error(std::move(message), span, std::move(hint)));
    throw SyntaxFault{};
}

void Cursor::faultExpected(const Text& expected, Text hint) {
    // At the end of the text the caret stands behind the last word, not on an empty line.
    const Span span = atEnd() ? behind() : here();
    fault(phrase("expected {}, found {}", expected, describe(peek())), span, std::move(hint));
}

Text Cursor::describe(const Token& token) const {
    const std::string_view word = textOf(token);
    switch (token.kind) {
        case Token::Kind::End:
            return phrase("the end of the text");
        case Token::Kind::String:
            return word.size() > 30 ? phrase("a string") : phrase("the string {}", word);
        case Token::Kind::Integer:
        case Token::Kind::Real:
            return phrase("the number {:.30}", word);
        case Token::Kind::Identifier:
        case Token::Kind::Keyword:
        case Token::Kind::Symbol:
            return phrase("\"{:.60}\"", word);
    }
    return word;
}

Cursor::Nesting::Nesting(Cursor& cursor) : cursor_(cursor) {
    if (cursor.depth_ >= deepestNesting) {
        cursor.fault(phrase("nested deeper than {} levels", deepestNesting), cursor.here(),
                     phrase("name an intermediate result"));
    }
    ++cursor.depth_;
}

}  // namespace analogon::syntax
