#include "core/flat/messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace analogon {

void Messages::sortFrom(std::size_t first) {
    std::map<std::string, std::size_t> files;  // in the order in which they came
    for (std::size_t i = first; i < diagnostics_.size(); ++i) files.emplace(diagnostics_[i].place.file, files.size());
    const auto at = [&](const Diagnostic& d) {
        return std::tuple(files.at(d.place.file), d.place.line, d.place.column);
    };
    std::stable_sort(diagnostics_.begin() + static_cast<std::ptrdiff_t>(first), diagnostics_.end(),
                     [&](const Diagnostic& a, const Diagnostic& b) { return at(a) < at(b); });
}

bool Messages::isNew(const std::string& message, const Span& span) {
    return !full() && seen_.emplace(message, span.source, span.begin).second;
}

void Messages::error(const Text& message, const Span& span, const Text& hint) {
    if (quiet_ > 0) return;
    hasErrors_ = true;
    if (isNew(message, span)) diagnostics_.push_back(analogon::error(message, span, hint));
}

void Messages::fatal(const Text& message, const Span& span, const Text& hint) {
    quiet_ = 0;  // nothing is tried any more
    error(message, span, hint);
    isStopped_ = true;
}

void Messages::refusal(const Text& message, const Span& span, const Text& hint) {
    if (quiet_ == 0) fatal(message, span, hint);
}

void Messages::warning(const Text& message, const Span& span, const Text& hint) {
    if (quiet_ == 0 && isNew(message, span)) diagnostics_.push_back(analogon::warning(message, span, hint));
}

Text didYouMean(std::string_view misspelt, const std::vector<std::string>& names) {
    const std::string best = suggestion(misspelt, names);
    return best.empty() ? Text() : phrase("did you mean '{}'?", best);
}

}  // namespace analogon
