#pragma once

#include <filesystem>
#include <string>
#include <system_error>

#include "core/base/diagnostic.hpp"

namespace analogon {

/// "this cannot be written: No space left on device", with what to check.
Diagnostic cannotWrite(const std::filesystem::path& file, const Text& reason);
Diagnostic cannotWrite(const std::filesystem::path& file, const std::error_code& code);

/// A fault that costs no more than what it is about: what else was read is good.
Diagnostic asWarning(Diagnostic fault);

}  // namespace analogon
