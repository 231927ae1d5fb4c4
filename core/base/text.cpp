#include "core/base/text.hpp"

#include <algorithm>
#include <ostream>
#include <utility>

namespace analogon {

namespace {

void replaceIn(std::string& words, std::string_view from, std::string_view to) {
    for (std::size_t at = words.find(from); at != std::string::npos; at = words.find(from, at + to.size()))
        words.replace(at, from.size(), to);
}

}  // namespace

Text Text::number(std::string digits) {
    Text text(std::move(digits));
    text.isNumber_ = true;
    return text;
}

Text& Text::operator+=(const Text& next) {
    if (next.empty()) return *this;
    if (empty()) return *this = next;
    const bool isSequence = pattern_.empty() && !arguments_.empty();
    if (!isSequence) {
        Text first = *this;
        pattern_.clear();
        isNumber_ = false;
        arguments_ = {std::move(first)};
    }
    english_ += next.english_;
    arguments_.push_back(next);
    return *this;
}

void Text::replaceAll(std::string_view from, std::string_view to) {
    if (from.empty()) return;
    replaceIn(english_, from, to);
    for (Text& argument : arguments_) argument.replaceAll(from, to);
}

std::ostream& operator<<(std::ostream& stream, const Text& text) { return stream << text.english(); }

Text listed(const std::vector<std::string>& names) {
    if (names.size() < 2) return names.empty() ? Text() : Text(names.front());
    std::string first = names.front();
    for (std::size_t i = 1; i + 1 < names.size(); ++i) first += ", " + names[i];
    return phrase("{} and {}", first, names.back());
}

std::vector<std::string> formatsOf(std::string_view pattern, std::size_t arguments) {
    std::vector<std::string> formats(arguments);
    std::size_t next = 0;
    for (std::size_t at = 0; at < pattern.size(); ++at) {
        if (pattern[at] != '{') continue;
        if (at + 1 < pattern.size() && pattern[at + 1] == '{') {  // a brace that is meant
            ++at;
            continue;
        }
        const std::size_t end = std::min(pattern.find('}', at), pattern.size());
        const std::string_view field = pattern.substr(at + 1, end - at - 1);
        const std::size_t colon = std::min(field.find(':'), field.size());
        std::size_t argument = 0;
        for (const char digit : field.substr(0, colon))
            argument = 10 * argument + static_cast<std::size_t>(digit - '0');
        if (colon == 0) argument = next++;
        if (argument < arguments && colon < field.size()) formats[argument] = field.substr(colon + 1);
        at = end;
    }
    return formats;
}

}  // namespace analogon
