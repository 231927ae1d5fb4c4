#include "core/base/file_fault.hpp"

#include <utility>

namespace analogon {

Diagnostic cannotWrite(const std::filesystem::path& file, const Text& reason) {
    return fileError(phrase("this cannot be written: {}", reason), file.string(), 0, 0,
                     phrase("Check that the directory exists, may be written and has room."));
}

Diagnostic cannotWrite(const std::filesystem::path& file, const std::error_code& code) {
    return cannotWrite(file, code.message());
}

Diagnostic asWarning(Diagnostic fault) {
    fault.severity = Severity::Warning;
    return fault;
}

}  // namespace analogon
