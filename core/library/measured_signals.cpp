#include "core/library/measured_signals.hpp"

#include <fmt/format.h>

namespace analogon {
namespace {

// It is kept as a class that no model refers to, one literal a signal: so it goes along wherever the library is varied.
constexpr std::string_view holder = "Analogon.MeasuredSignals", compared = "compared", driven = "driven";

std::string literalOf(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

}  // namespace

Outcome<Library> withMeasured(const Library& library, const MeasuredSignals& signals) {
    std::string text =
        fmt::format("within Analogon;\ntype MeasuredSignals = enumeration(of {}", literalOf(signals.className));
    std::size_t count = 0;
    for (const std::string& name : signals.compared)
        text += fmt::format(", {}{} {}", compared, ++count, literalOf(name));
    for (const std::string& name : signals.driven) text += fmt::format(", {}{} {}", driven, ++count, literalOf(name));
    return library.withSource(std::make_shared<const Source>("measured signals", text + ");\n"));
}

MeasuredSignals measuredOf(const Library& library, std::string_view className) {
    MeasuredSignals signals;
    const LibraryClass* const of = library.find(holder);
    if (!of || of->definition->enumerationDescriptions.empty()) return signals;
    const auto& names = of->definition->enumerationDescriptions;
    if (names.front() != className) return signals;
    signals.className = names.front();
    for (std::size_t i = 1; i < names.size(); ++i)
        (of->definition->enumeration[i].starts_with(compared) ? signals.compared : signals.driven).push_back(names[i]);
    return signals;
}

}  // namespace analogon
