#pragma once

#include <optional>
#include <string>

#include "core/base/file_handle.hpp"

namespace analogon {

/// Both ends of a pipe of the system; closed with the object, and in a program that is started meanwhile.
struct Pipe {
    FileHandle read{}, write{};

    /// None: the system refuses it; errno tells why.
    static std::optional<Pipe> make();
};

/// Waits for what comes and appends it; false: nothing will come any more.
bool readSome(int handle, std::string& text);

}  // namespace analogon
