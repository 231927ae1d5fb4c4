#include "core/study/json_fault.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace analogon {

namespace {

/// The parser's own words without its number and counted position.
std::string reason(const std::string& what) {
    const std::size_t dash = what.find(" - ");
    const std::size_t colon = what.rfind(": ");
    std::string text = dash != std::string::npos    ? what.substr(dash + 3)
                       : colon != std::string::npos ? what.substr(colon + 2)
                                                    : what;
    if (const std::size_t last = text.find("; last read"); last != std::string::npos) {
        const std::size_t next = text.find(';', last + 1);
        text.erase(last, next == std::string::npos ? std::string::npos : next - last);
    }
    return text;
}

Span spanOf(const SourcePtr& source, std::size_t begin, std::size_t end) {
    return {source.get(), static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

bool isOfWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-' || c == '+'; }

/// The bare word at a place: NaN, True, -Infinity.
Span wordAt(const SourcePtr& source, std::size_t at) {
    const std::string_view text = source->text();
    std::size_t begin = at, end = at;
    while (begin > 0 && isOfWord(text[begin - 1])) --begin;
    while (end < text.size() && isOfWord(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    const bool isWord =
        std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::isalpha(c) != 0; }) &&
        (std::isalpha(static_cast<unsigned char>(word.front())) || word.front() == '-' || word.front() == '+');
    const bool isValue = word == "true" || word == "false" || word == "null";
    const bool isQuoted = (begin > 0 && text[begin - 1] == '"') || (end < text.size() && text[end] == '"');
    return isWord && !isValue && !isQuoted ? spanOf(source, begin, end) : Span{};
}

/// Where a number stands outside of texts in quotation marks; invalid: nowhere.
Span numberIn(const SourcePtr& source, std::string_view number) {
    const std::string_view text = source->text();
    bool isInside = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && isInside)
            ++i;
        else if (text[i] == '"')
            isInside = !isInside;
        else if (!isInside && text.substr(i).starts_with(number))
            return spanOf(source, i, i + number.size());
    }
    return {};
}

}  // namespace

Diagnostic jsonFault(const SourcePtr& source, const nlohmann::ordered_json::exception& failure) {
    const std::string what = failure.what();
    const std::size_t size = source->text().size();
    if (const std::size_t quote = what.find('\''); what.find("number overflow") != std::string::npos) {
        const std::string number = what.substr(quote + 1, what.rfind('\'') - quote - 1);
        return error(phrase("the number {} is too large", number), numberIn(source, number),
                     phrase("The largest that can be computed with is 1.8e308."));
    }
    const auto* const parsing = dynamic_cast<const nlohmann::ordered_json::parse_error*>(&failure);
    if (!parsing) return fileError(phrase("this is not valid JSON: {}", reason(what)), source->name());
    const std::size_t at = std::min(parsing->byte > 0 ? parsing->byte - 1 : 0, size == 0 ? 0 : size - 1);
    const bool isName = what.find("parsing object key") != std::string::npos;
    if (const Span word = size > 0 && !isName ? wordAt(source, at) : Span{}; word.valid())
        return error(phrase("this is not valid JSON: {} is no value", word.text()), word,
                     phrase("A value is a number, a \"text\", true, false, null, a list […] or an object {{…}}."));
    return error(phrase("this is not valid JSON: {}", reason(what)), spanOf(source, at, std::min(at + 1, size)),
                 phrase("A comma, bracket or quotation mark is missing or one too many near here."));
}

}  // namespace analogon
