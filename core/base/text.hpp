#pragma once

#include <fmt/format.h>

#include <iosfwd>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace analogon {

/// Words for people: the English text, and how it was made, so that a screen can say the same in another language. A
/// text is one of three things:
///   words as they are      a name, or a number               pattern and arguments empty
///   a sentence             "the range ends at {}" and "3"    made by phrase()
///   a sequence             sentences one behind the other    made by +=
/// Arguments are texts again; numbers among them keep the format of the English pattern, and are known as numbers:
/// their decimal sign is the language's, that of a name ("heater.R2.1") is not.
class Text {
public:
    Text() = default;
    Text(std::string words) : english_(std::move(words)) {}
    Text(std::string_view words) : english_(words) {}
    Text(const char* words) : english_(words) {}
    Text(std::string pattern, std::vector<Text> arguments, std::string english)
        : english_(std::move(english)), pattern_(std::move(pattern)), arguments_(std::move(arguments)) {}
    /// "3.14", "2e-5": digits with a decimal point.
    static Text number(std::string digits);

    const std::string& english() const { return english_; }
    operator const std::string&() const { return english_; }
    /// "the range ends at {} before it begins at {}"; empty: words as they are, or a sequence.
    const std::string& pattern() const { return pattern_; }
    const std::vector<Text>& arguments() const { return arguments_; }
    bool isNumber() const { return isNumber_; }

    bool empty() const { return english_.empty(); }
    std::size_t find(std::string_view part) const { return english_.find(part); }

    /// Behind this one.
    Text& operator+=(const Text& next);
    friend Text operator+(Text first, const Text& next) { return first += next; }
    /// Another name for something, wherever it stands in the words.
    void replaceAll(std::string_view from, std::string_view to);

    friend bool operator==(const Text& a, const Text& b) { return a.english_ == b.english_; }
    friend bool operator==(const Text& a, std::string_view b) { return a.english_ == b; }
    friend bool operator==(const Text& a, const char* b) { return a.english_ == b; }
    friend bool operator<(const Text& a, const Text& b) { return a.english_ < b.english_; }

private:
    std::string english_;
    std::string pattern_;
    std::vector<Text> arguments_;
    bool isNumber_{};
};

std::ostream& operator<<(std::ostream& stream, const Text& text);

/// "R", "R and k", "R, k and b"
Text listed(const std::vector<std::string>& names);

/// What stands between the braces of a pattern, behind the colon, for each argument: "{:.3g}" gives ".3g".
std::vector<std::string> formatsOf(std::string_view pattern, std::size_t arguments);

}  // namespace analogon

template <>
struct fmt::formatter<analogon::Text> : fmt::formatter<std::string_view> {
    template <class Context>
    auto format(const analogon::Text& text, Context& context) const {
        return fmt::formatter<std::string_view>::format(text.english(), context);
    }
};

namespace analogon {

inline Text argumentOf(const Text& text, const std::string&) { return text; }

template <class Value>
Text argumentOf(const Value& value, const std::string& format) {
    std::string words = fmt::format(fmt::runtime(format.empty() ? "{}" : "{:" + format + "}"), value);
    if constexpr (std::is_floating_point_v<Value>) return Text::number(std::move(words));
    return words;
}

/// A sentence with its arguments, in English by fmt. Every pattern has its translations in resources/translations,
/// under the context "core".
template <class... Args>
Text phrase(fmt::format_string<Args...> pattern, Args&&... args) {
    const std::string words(fmt::string_view(pattern).data(), fmt::string_view(pattern).size());
    [[maybe_unused]] const std::vector<std::string> formats = formatsOf(words, sizeof...(args));
    [[maybe_unused]] std::size_t next = 0;
    std::vector<Text> arguments;
    (arguments.push_back(argumentOf(args, formats[next++])), ...);
    return Text(words, std::move(arguments), fmt::vformat(words, fmt::make_format_args(args...)));
}

}  // namespace analogon
