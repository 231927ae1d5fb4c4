#include "core/syntax/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/syntax/parser.hpp"

namespace analogon::syntax {
namespace {

constexpr std::size_t largestText = 64u << 20;
constexpr std::size_t mostFaults = 20;

// Sorted, for binary search.
constexpr auto keywords = std::to_array<std::string_view>({
    "algorithm",    "and",           "annotation",  "block",     "break",      "class",     "connect",  "connector",
    "constant",     "constrainedby", "der",         "discrete",  "each",       "else",      "elseif",   "elsewhen",
    "encapsulated", "end",           "enumeration", "equation",  "expandable", "extends",   "external", "false",
    "final",        "flow",          "for",         "function",  "if",         "import",    "impure",   "in",
    "initial",      "inner",         "input",       "loop",      "model",      "not",       "operator", "or",
    "outer",        "output",        "package",     "parameter", "partial",    "protected", "public",   "pure",
    "record",       "redeclare",     "replaceable", "return",    "stream",     "then",      "true",     "type",
    "when",         "while",         "within",
});
static_assert(std::is_sorted(keywords.begin(), keywords.end()));

}  // namespace

bool isKeyword(std::string_view word) { return std::binary_search(keywords.begin(), keywords.end(), word); }

namespace {

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Length of the UTF-8 character at `at`, 0 when the bytes there are none.
std::size_t characterLength(std::string_view text, std::size_t at) {
    const auto lead = static_cast<unsigned char>(text[at]);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xf5 ? 0 : lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc2 ? 2 : 0;
    if (at + length > text.size()) return 0;
    for (std::size_t k = 1; k < length; ++k) {
        if ((static_cast<unsigned char>(text[at + k]) & 0xc0) != 0x80) return 0;
    }
    return length;
}

class Lexer {
public:
    explicit Lexer(const Source& source) : source_(source), text_(source.text()) {}

    LexedText run() {
        if (isText()) {
            if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // byte order mark
            while (skipBlanks()) word();
        } else {
            result_.isCutShort = true;
        }
        const auto end = static_cast<std::uint32_t>(text_.size());
        result_.tokens.push_back({Token::Kind::End, end, end});
        return std::move(result_);
    }

private:
    Span span(std::size_t begin, std::size_t end) const {
        return {&source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
    }
    void fault(Text message, std::size_t begin, std::size_t end, Text hint = {}) {
        if (result_.faults.size() < mostFaults) {
            result_.faults.push_back(error(std::move(message), span(begin, end), std::move(hint)));
        }
    }
    char look(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
    void push(Token::Kind kind, std::size_t begin) {
        result_.tokens.push_back({kind, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)});
    }

    /// One message for a file that is no UTF-8 text at all, rather than one for each of its bytes.
    bool isText() {
        if (text_.size() > largestText) {
            fault(phrase("the text has {} bytes; at most {} are read", text_.size(), largestText), 0, 0);
            return false;
        }
        if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff")) {
            fault(phrase("the text is encoded as UTF-16"), 0, 0, phrase("save the file as UTF-8"));
            return false;
        }
        for (std::size_t i = 0; i < text_.size();) {
            const std::size_t length = characterLength(text_, i);
            if (text_[i] == '\0') {
                fault(phrase("a zero byte: this is not a Modelica text"), i, i + 1);
                return false;
            }
            if (length == 0) {
                fault(phrase("the byte 0x{:02x} is not valid UTF-8", static_cast<unsigned char>(text_[i])), i, i + 1,
                      phrase("a Modelica text is stored as UTF-8; is this a Modelica file?"));
                return false;
            }
            i += length;
        }
        return true;
    }

    /// Moves on to the next word; false at the end.
    bool skipBlanks() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v') {
                ++at_;
            } else if (c == '/' && look(1) == '/') {
                at_ = std::min(text_.find_first_of("\n\r", at_), text_.size());
            } else if (c == '/' && look(1) == '*') {
                const std::size_t end = text_.find("*/", at_ + 2);
                if (end == std::string_view::npos) {
                    fault(phrase("the comment is not closed"), at_, at_ + 2,
                          phrase("a comment that begins with /* ends with */"));
                    result_.isCutShort = true;
                    at_ = text_.size();
                } else {
                    at_ = end + 2;
                }
            } else {
                return true;
            }
        }
        return false;
    }

    void word() {
        const char c = look();
        if (isLetter(c)) return identifier();
        if (isDigit(c)) return number();
        if (c == '"') return quoted('"', Token::Kind::String);
        if (c == '\'') return quoted('\'', Token::Kind::Identifier);
        if (c == '.' && isDigit(look(1))) return bareFraction();
        symbol();
    }

    void identifier() {
        const std::size_t begin = at_;
        while (isLetter(look()) || isDigit(look())) ++at_;
        push(isKeyword(text_.substr(begin, at_ - begin)) ? Token::Kind::Keyword : Token::Kind::Identifier, begin);
    }

    void digits() {
        while (isDigit(look())) ++at_;
    }

    void number() {
        const std::size_t begin = at_;
        bool isReal = false;
        digits();
        if (look() == '.') {
            isReal = true;
            ++at_;
            digits();
        }
        if (look() == 'e' || look() == 'E') {
            const std::size_t sign = look(1) == '+' || look(1) == '-' ? 1 : 0;
            if (isDigit(look(1 + sign))) {
                isReal = true;
                at_ += 1 + sign;
                digits();
            }
        }
        if (isLetter(look())) {
            while (isLetter(look()) || isDigit(look())) ++at_;
            fault(phrase("\"{}\" is neither a number nor a name", text_.substr(begin, at_ - begin)), begin, at_,
                  phrase("a name begins with a letter; a product is written with *"));
        }
        push(isReal ? Token::Kind::Real : Token::Kind::Integer, begin);
    }

    /// `.5` is not Modelica; it is read as 0.5 so that the rest is still checked.
    void bareFraction() {
        const std::size_t begin = at_;
        ++at_;
        digits();
        fault(phrase("a number needs a digit before the point"), begin, at_,
              phrase("write 0{}", text_.substr(begin, at_ - begin)));
        push(Token::Kind::Real, begin);
    }

    void quoted(char quote, Token::Kind kind) {
        const std::size_t begin = at_++;
        while (at_ < text_.size() && text_[at_] != quote) at_ += text_[at_] == '\\' ? 2 : 1;
        if (at_ >= text_.size()) {
            const std::size_t lineEnd = std::min(text_.find_first_of("\r\n", begin), text_.size());
            fault(kind == Token::Kind::String ? phrase("the string is not closed")
                                              : phrase("the quoted name is not closed"),
                  begin, lineEnd, phrase("it ends with {}", quote));
            result_.isCutShort = true;
            at_ = text_.size();
            return;
        }
        ++at_;
        if (kind == Token::Kind::Identifier && at_ - begin == 2) fault(phrase("the quoted name is empty"), begin, at_);
        push(kind, begin);
    }

    void symbol() {
        static constexpr std::array<std::string_view, 10> pairs{
            "<=", ">=", "==", "<>", ":=", ".+", ".-", ".*", "./", ".^"};
        static constexpr std::string_view singles = "(){}[];,:=+-*/^.<>";
        const std::size_t begin = at_;
        if (std::find(pairs.begin(), pairs.end(), text_.substr(at_, 2)) != pairs.end()) {
            at_ += 2;
            return push(Token::Kind::Symbol, begin);
        }
        if (singles.find(text_[at_]) != std::string_view::npos) {
            ++at_;
            return push(Token::Kind::Symbol, begin);
        }
        strangeCharacters();
    }

    /// One message for a run of characters that no Modelica word holds.
    void strangeCharacters() {
        const std::size_t begin = at_;
        const std::size_t first = characterLength(text_, at_);
        do {
            at_ += characterLength(text_, at_);
        } while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) >= 0x80);
        const std::string_view character = text_.substr(begin, first);
        const bool isControl = first == 1 && static_cast<unsigned char>(character[0]) < 0x20;
        fault(isControl ? phrase("the control character 0x{:02x} has no meaning here", character[0])
                        : phrase("the character {} has no meaning here", character),
              begin, at_,
              first > 1 ? phrase("names hold ASCII letters, digits and _; others stand in quotes: 'T_α'") : Text());
    }

    const Source& source_;
    std::string_view text_;
    std::size_t at_{};
    LexedText result_;
};

}  // namespace

LexedText lex(const Source& source) { return Lexer(source).run(); }

}  // namespace analogon::syntax
