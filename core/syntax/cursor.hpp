#pragma once

#include <concepts>
#include <string>
#include <string_view>

#include "core/syntax/lexer.hpp"

/// Where the parser stands in the words of a text, and how it tells a fault. Private to the parser.
namespace analogon::syntax {

/// Thrown after a fault was reported, caught where the parser can go on (the next element or equation). It never
/// leaves the parser.
struct SyntaxFault {};

class Cursor {
public:
    Cursor(SourcePtr source, LexedText lexed);

    const SourcePtr& source() const { return source_; }
    const Token& peek(std::size_t ahead = 0) const {
        const std::size_t index = index_ + ahead;
        return tokens_[index < tokens_.size() ? index : tokens_.size() - 1];
    }
    std::string_view text(std::size_t ahead = 0) const { return textOf(peek(ahead)); }
    std::string_view textOf(const Token& token) const { return {text_ + token.begin, token.end - token.begin}; }

    bool atEnd() const { return peek().kind == Token::Kind::End; }
    bool atIdentifier(std::size_t ahead = 0) const { return peek(ahead).kind == Token::Kind::Identifier; }
    /// Whether the word is this keyword or symbol.
    bool at(std::string_view word, std::size_t ahead = 0) const {
        const Token& token = peek(ahead);  // asked for every word many times over: the cheap questions first
        if (token.kind != Token::Kind::Keyword && token.kind != Token::Kind::Symbol) return false;
        if (token.end - token.begin != word.size() || text_[token.begin] != word[0]) return false;
        return textOf(token) == word;
    }

    Token next();
    /// Consumes the word if it is this one.
    bool take(std::string_view word);
    // What is expected is a sentence without arguments, or made (by a function) only where it is not there: sound texts
    // cost no sentences.

    /// Consumes this keyword or symbol or faults: `expected ")" after the modifications, found "="`.
    void expect(std::string_view word, const char* where, const char* hint = "") {
        if (!take(word)) faultExpected(phrase("\"{}\" {}", word, sentence(where)), sentence(hint));
    }
    template <std::invocable Where>
    void expect(std::string_view word, Where where) {
        if (!take(word)) faultExpected(phrase("\"{}\" {}", word, where()));
    }
    /// Consumes an identifier or faults.
    Token expectIdentifier(const char* what) {
        return expectIdentifier([what] { return sentence(what); });
    }
    template <std::invocable What>
    Token expectIdentifier(What what) {
        if (!atIdentifier()) faultNoIdentifier(what());
        return next();
    }
    /// A missing `;` before a new line is reported, but what follows is read as if it were there.
    void expectSemicolon(const char* afterWhat) {
        if (!take(";")) noSemicolon(sentence(afterWhat));
    }
    template <std::invocable What>
    void expectSemicolon(What afterWhat) {
        if (!take(";")) noSemicolon(afterWhat());
    }

    std::size_t index() const { return index_; }
    void moveTo(std::size_t index) { index_ = index; }

    Span spanOf(const Token& token) const { return {source_.get(), token.begin, token.end}; }
    Span here() const { return spanOf(peek()); }
    /// From the word at `index` to the last word consumed.
    Span spanFrom(std::size_t index) const;
    /// The empty span right behind the last word consumed.
    Span behind() const;

    void report(Diagnostic diagnostic);
    [[noreturn]] void fault(Text message, const Span& span, Text hint = {});
    [[noreturn]] void faultExpected(const Text& expected, Text hint = {});
    /// The word in a message: `"x"`, `the keyword "end"`, `the end of the text`.
    Text describe(const Token& token) const;

    Diagnostics& diagnostics() { return diagnostics_; }
    bool gaveUp() const { return gaveUp_; }

    /// Counts how deep constructs nest while it lives: no text, however hostile, exhausts the stack.
    class Nesting {
    public:
        explicit Nesting(Cursor& cursor);
        ~Nesting() { --cursor_.depth_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;

    private:
        Cursor& cursor_;
    };

private:
    static Text sentence(const char* words) { return *words ? Text(words, {}, words) : Text(); }
    [[noreturn]] void faultNoIdentifier(const Text& what);
    void noSemicolon(const Text& afterWhat);

    SourcePtr source_;
    const char* text_;
    std::vector<Token> tokens_;
    Diagnostics diagnostics_;
    std::size_t index_{};
    int depth_{};
    bool isCutShort_{};
    bool gaveUp_{};
    std::uint32_t lastFaultAt_{0xffffffffu};
};

}  // namespace analogon::syntax
