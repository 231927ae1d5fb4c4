#include "core/study/study_places.hpp"

#include <algorithm>

namespace analogon {

StudyPlaces::StudyPlaces(const Study& study) {
    if (study.json) places_.emplace(study.json);
    file_ = study.directory.empty() ? "study.json" : (study.directory / "study.json").string();
}

Diagnostic StudyPlaces::fault(const std::string& pointer, Text message, Text hint) const {
    const Span span = places_ ? places_->value(pointer) : Span{};
    return span.valid() ? error(std::move(message), span, std::move(hint))
                        : fileError(std::move(message), file_, 0, 0, std::move(hint));
}

Diagnostic StudyPlaces::remark(const std::string& pointer, Text message, Text hint) const {
    Diagnostic said = fault(pointer, std::move(message), std::move(hint));
    said.severity = Severity::Warning;
    return said;
}

std::string joined(const std::vector<std::string>& names) {
    constexpr std::size_t shown = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
    return names.size() > shown ? text + ", …" : text;
}

Text meantOrAvailable(const std::string& name, const std::vector<std::string>& names, const Text& none) {
    const std::string alike = suggestion(name, names);
    if (!alike.empty()) return phrase("Did you mean '{}'?", alike);
    return names.empty() ? none : phrase("Available: {}.", joined(names));
}

}  // namespace analogon
