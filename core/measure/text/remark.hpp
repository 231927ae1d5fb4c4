#pragma once

#include <string>
#include <utility>

#include "core/base/diagnostic.hpp"

namespace analogon {

/// Something that was found out about a file: no fault and no doubt.
inline Diagnostic remark(Text message, const std::string& file, int line = 0, Text hint = {}) {
    Diagnostic told = fileError(std::move(message), file, line, 0, std::move(hint));
    told.severity = Severity::Note;
    return told;
}

/// Something that is doubtful.
inline Diagnostic doubt(Text message, const std::string& file, int line = 0, Text hint = {}) {
    Diagnostic told = fileError(std::move(message), file, line, 0, std::move(hint));
    told.severity = Severity::Warning;
    return told;
}

}  // namespace analogon
