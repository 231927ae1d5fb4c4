#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

/// The sources of the program as a test reads them: enough of C++ to find definitions, not to understand them.
namespace analogon {

struct Token {
    std::string text;
    int line{};
};

inline bool isNameStart(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_'; }
inline bool isNamePart(char c) { return isNameStart(c) || std::isdigit(static_cast<unsigned char>(c)); }

/// Names, numbers and punctuation of a source, without comments and lines for the preprocessor; a literal is one token.
class Lexer {
public:
    explicit Lexer(const std::string& text) : text_(text) {}

    std::vector<Token> tokens() {
        std::vector<Token> all;
        bool isLineStart = true;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (std::isspace(static_cast<unsigned char>(c))) {
                isLineStart = isLineStart || c == '\n';
                skip(1);
            } else if (text_.compare(at_, 2, "//") == 0 || (c == '#' && isLineStart)) {
                skipLine();
            } else if (text_.compare(at_, 2, "/*") == 0) {
                skipTo(text_.find("*/", at_ + 2), 2);
            } else {
                isLineStart = false;
                const int line = line_;
                const std::size_t begin = at_;
                literalOrWord(c);
                all.push_back({text_.substr(begin, at_ - begin), line});
            }
        }
        return all;
    }

private:
    void skip(std::size_t count) {
        for (; count > 0 && at_ < text_.size(); --count) line_ += text_[at_++] == '\n';
    }
    void skipTo(std::size_t end, std::size_t length) {
        skip(end == std::string::npos ? text_.size() : end + length - at_);
    }
    void skipLine() {
        for (; at_ < text_.size() && text_[at_] != '\n'; skip(1))
            if (text_[at_] == '\\') skip(1);
    }
    void literalOrWord(char c) {
        if (isNameStart(c)) {
            const std::size_t begin = at_;
            while (at_ < text_.size() && isNamePart(text_[at_])) skip(1);
            const bool isRaw = text_[at_ - 1] == 'R' && at_ - begin <= 3;
            if (isRaw && at_ < text_.size() && text_[at_] == '"') rawLiteral();
        } else if (std::isdigit(static_cast<unsigned char>(c))) {
            while (at_ < text_.size() && (isNamePart(text_[at_]) || text_[at_] == '.' || text_[at_] == '\'')) skip(1);
        } else if (c == '"' || c == '\'') {
            for (skip(1); at_ < text_.size() && text_[at_] != c; skip(1))
                if (text_[at_] == '\\') skip(1);
            skip(1);
        } else {
            skip(text_.compare(at_, 2, "::") == 0 ? 2 : 1);
        }
    }
    void rawLiteral() {
        const std::size_t open = text_.find('(', at_);
        if (open == std::string::npos) return skip(text_.size());
        const std::string end = ")" + text_.substr(at_ + 1, open - at_ - 1) + "\"";
        skipTo(text_.find(end, open), end.size());
    }

    const std::string& text_;
    std::size_t at_{};
    int line_{1};
};

using Tokens = std::vector<Token>;

inline std::string joined(Tokens::const_iterator begin, Tokens::const_iterator end) {
    std::string text;
    for (; begin != end; ++begin) {
        if (!text.empty() && isNamePart(text.back()) && isNamePart(begin->text.front())) text += ' ';
        text += begin->text;
    }
    return text;
}

/// Behind the bracket that closes the one at `open`.
inline Tokens::const_iterator pastBracket(Tokens::const_iterator open, Tokens::const_iterator end) {
    static const std::map<std::string, std::string> partners{{"<", ">"}, {"(", ")"}, {"[", "]"}, {"{", "}"}};
    const std::string &opens = open->text, &closes = partners.at(opens);
    int depth = 0;
    for (; open != end; ++open) {
        if (open->text == opens) ++depth;
        if (open->text == closes && --depth == 0) return open + 1;
    }
    return end;
}

inline bool isOneOf(const std::string& text, std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), text) != names.end();
}

}  // namespace analogon
