#pragma once

#include <string>
#include <vector>

#include "core/base/source.hpp"
#include "core/base/text.hpp"

namespace analogon {

enum class Severity { Error, Warning, Note };

/// Where a message points. Owns its text, so a diagnostic outlives the source it speaks of.
struct Place {
    std::string file;      // name of the model or data file; empty: no file
    int line{};            // 1-based; 0: the file as a whole
    int column{};          // 1-based; 0: the line as a whole
    int length{};          // characters to underline
    std::string lineText;  // the line itself, for the caret
};

Place placeOf(const Span& span);

/// A message for the engineer: what is wrong, where, and what to try.
struct Diagnostic {
    Severity severity{Severity::Error};
    Text message;
    Place place;
    Text hint;           // what to try; may be empty
    bool isNumerical{};  // the numerics failed, the input is not at fault
};

using Diagnostics = std::vector<Diagnostic>;

Diagnostic error(Text message, const Span& span = {}, Text hint = {});
Diagnostic warning(Text message, const Span& span = {}, Text hint = {});
/// An error in a file that is not parsed text (a table, an archive); line 0: the file as a whole.
Diagnostic fileError(Text message, std::string file, int line = 0, int column = 0, Text hint = {});

/// The numerics failed: which experiment, at what time, which variable.
Diagnostic numericalError(Text message, Text hint = {});

bool hasError(const Diagnostics& diagnostics);

/// "file:line:column: error: message", the line with a caret under the place, and the hint.
std::string format(const Diagnostic& diagnostic);
std::string format(const Diagnostics& diagnostics);

/// Of all the names, the one most like the misspelt one (edit distance at most a third of it); else empty.
std::string suggestion(std::string_view misspelt, const std::vector<std::string>& names);

}  // namespace analogon
