#include "core/flat/messages.hpp"

#include <fmt/format.h>

namespace analogon {

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

void Messages::warning(const Text& message, const Span& span, const Text& hint) {
    if (quiet_ == 0 && isNew(message, span)) diagnostics_.push_back(analogon::warning(message, span, hint));
}

Text didYouMean(std::string_view misspelt, const std::vector<std::string>& names) {
    const std::string best = suggestion(misspelt, names);
    return best.empty() ? Text() : phrase("did you mean '{}'?", best);
}

}  // namespace analogon
