#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "core/base/diagnostic.hpp"
#include "core/base/file_fault.hpp"
#include "core/measure/cited.hpp"

namespace analogon {

/// Something that was found out about a file: no fault and no doubt.
inline Diagnostic remark(Text message, const std::string& file, int line = 0, Text hint = {}) {
    Diagnostic told = fileError(std::move(message), file, line, 0, std::move(hint));
    told.severity = Severity::Note;
    return told;
}

/// Something that is doubtful.
inline Diagnostic doubt(Text message, const std::string& file, int line = 0, Text hint = {}) {
    return asWarning(fileError(std::move(message), file, line, 0, std::move(hint)));
}

}  // namespace analogon
