#include "core/base/diagnostic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

#include "core/base/visible.hpp"

namespace analogon {

namespace {

constexpr std::size_t widestExcerpt = 120;    // characters of a line that a message shows
constexpr std::size_t longestLine = 1 << 20;  // bytes of a line that a message keeps
constexpr std::size_t longestWords = 4000;    // bytes of a message, and of a hint
constexpr std::size_t mostMessages = 100;

/// One printable character of a line with the byte it starts at.
struct Glyph {
    std::string text;
    std::size_t offset;
};

/// Length of the UTF-8 sequence at `at`; 0 when the bytes there are none.
std::size_t sequenceLength(std::string_view line, std::size_t at) {
    const auto lead = static_cast<unsigned char>(line[at]);
    const std::size_t length = lead < 0x80             ? 1
                               : (lead & 0xe0) == 0xc0 ? 2
                               : (lead & 0xf0) == 0xe0 ? 3
                               : (lead & 0xf8) == 0xf0 ? 4
                                                       : 0;
    if (length == 0 || at + length > line.size()) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((static_cast<unsigned char>(line[at + i]) & 0xc0) != 0x80) return 0;
    }
    return length;
}

/// The line as characters of width one: tabs become blanks, what cannot be shown becomes '?'.
std::vector<Glyph> glyphs(std::string_view line) {
    std::vector<Glyph> result;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t length = sequenceLength(line, at);
        const auto byte = static_cast<unsigned char>(line[at]);
        const std::string_view glyph = line.substr(at, length);
        if (byte == '\t')
            result.push_back({" ", at});
        else if (length == 0 || visibleName(glyph) != glyph)
            result.push_back({"?", at});
        else
            result.push_back({std::string(glyph), at});
        at += std::max<std::size_t>(length, 1);
    }
    return result;
}

/// Where to cut a long line so that only the neighbourhood of the column is split into characters.
std::size_t cutBefore(std::string_view line, std::size_t column) {
    constexpr std::size_t reach = 4 * widestExcerpt;
    std::size_t cut = std::min(column > reach ? column - reach : 0, line.size());
    while (cut > 0 && cut < line.size() && (static_cast<unsigned char>(line[cut]) & 0xc0) == 0x80) ++cut;
    return cut;
}

/// "    source line" and "        ^~~~" below it.
std::string excerpt(const Place& place) {
    if (place.lineText.empty() || place.column < 1) return {};
    const auto wanted = static_cast<std::size_t>(place.column - 1);
    const std::size_t cutBytes = cutBefore(place.lineText, wanted);
    const std::string_view near = std::string_view(place.lineText).substr(cutBytes, 8 * widestExcerpt);
    const auto characters = glyphs(near);
    const auto indexOf = [&](std::size_t byte) {
        return static_cast<std::size_t>(std::count_if(
            characters.begin(), characters.end(), [&](const Glyph& glyph) { return glyph.offset + cutBytes < byte; }));
    };
    const std::size_t caret = indexOf(wanted);
    const std::size_t underlineEnd =
        std::max(caret + 1, indexOf(wanted + static_cast<std::size_t>(std::max(place.length, 1))));

    // Show the head of the line without its indentation when the caret is near it, else a window around the caret.
    const bool cutLeft = cutBytes > 0 || caret >= widestExcerpt * 3 / 4;
    std::size_t first = cutLeft ? caret - std::min(caret, widestExcerpt / 2) : 0;
    while (!cutLeft && first < caret && characters[first].text == " ") ++first;
    const std::size_t last = std::min(characters.size(), first + widestExcerpt);
    const bool cutRight = last < characters.size() || cutBytes + near.size() < place.lineText.size();

    std::string text = cutLeft ? "…" : "";
    for (std::size_t i = first; i < last; ++i) text += characters[i].text;
    if (cutRight) text += "…";
    while (!text.empty() && text.back() == ' ') text.pop_back();

    std::string marks(caret - first + (cutLeft ? 1 : 0), ' ');
    marks += '^';
    for (std::size_t i = caret + 1; i < std::min(underlineEnd, std::max(last, caret + 1)); ++i) marks += '~';
    return fmt::format("    {}\n    {}\n", text, marks);
}

const char* label(Severity severity) {
    switch (severity) {
        case Severity::Error:
            return "error";
        case Severity::Warning:
            return "warning";
        case Severity::Note:
            return "note";
    }
    return "error";
}

std::string lowered(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// Optimal string alignment: insertions, deletions, replacements and swaps of neighbours cost 1 each.
std::size_t editDistance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> beforeLast(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
        std::swap(beforeLast, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

}  // namespace

Place placeOf(const Span& span) {
    if (!span.valid()) return {};
    const Position begin = span.source->position(span.begin);
    const std::string_view line = span.source->line(begin.line);
    const auto restOfLine = static_cast<int>(line.size()) - (begin.column - 1);
    const int length = std::clamp(static_cast<int>(span.end - span.begin), 0, std::max(restOfLine, 0));
    // A file of one line may be large, and have many faults: each would hold it all.
    const std::string_view kept = line.size() <= longestLine ? line : std::string_view();
    return {span.source->name(), begin.line, begin.column, length, std::string(kept)};
}

Diagnostic error(Text message, const Span& span, Text hint) {
    return {Severity::Error, std::move(message), placeOf(span), std::move(hint)};
}

Diagnostic warning(Text message, const Span& span, Text hint) {
    return {Severity::Warning, std::move(message), placeOf(span), std::move(hint)};
}

Diagnostic fileError(Text message, std::string file, int line, int column, Text hint) {
    return {Severity::Error, std::move(message), Place{std::move(file), line, column, 0, {}}, std::move(hint)};
}

Diagnostic numericalError(Text message, Text hint) {
    return {Severity::Error, std::move(message), Place{}, std::move(hint), true};
}

bool hasError(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

std::string format(const Diagnostic& diagnostic) {
    const Place& place = diagnostic.place;
    std::string text;
    if (!place.file.empty() || place.line > 0) {
        text += place.file.empty() ? std::string("input") : visibleName(place.file, std::string::npos);
        if (place.line > 0) text += fmt::format(":{}", place.line);
        if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
        text += ": ";
    }
    const auto words = [](const Text& said) { return visibleName(said.english(), longestWords); };
    text += fmt::format("{}: {}\n", label(diagnostic.severity), words(diagnostic.message));
    text += excerpt(place);
    if (!diagnostic.hint.empty()) text += fmt::format("    hint: {}\n", words(diagnostic.hint));
    return text;
}

std::string format(const Diagnostics& diagnostics) {
    std::string text;
    const std::size_t shown = std::min(diagnostics.size(), mostMessages);
    for (std::size_t i = 0; i < shown; ++i) text += format(diagnostics[i]);
    if (shown < diagnostics.size()) text += fmt::format("and {} more messages\n", diagnostics.size() - shown);
    return text;
}

std::string suggestion(std::string_view misspelt, const std::vector<std::string>& names) {
    constexpr std::size_t longestName = 200;  // bytes; the distance of two takes the product of their lengths
    if (misspelt.size() > longestName) return {};
    const std::string wanted = lowered(misspelt);
    std::size_t least = wanted.size() / 3 + 1;
    const std::string* best = nullptr;
    for (const std::string& name : names) {
        const std::size_t lengthGap =
            name.size() > wanted.size() ? name.size() - wanted.size() : wanted.size() - name.size();
        if (lengthGap > least || name.size() > 2 * longestName) continue;
        const std::size_t distance = editDistance(wanted, lowered(name));
        // Of names that are equally like, the one that begins alike: 'sinn' means sin rather than sign.
        const auto common = [&](const std::string& other) {
            const std::string text = lowered(other);
            return std::mismatch(wanted.begin(), wanted.end(), text.begin(), text.end()).first - wanted.begin();
        };
        if (distance < least || (best && distance == least && common(name) > common(*best))) {
            least = distance;
            best = &name;
        }
    }
    return best ? *best : std::string{};
}

}  // namespace analogon
