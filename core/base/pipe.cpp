#include "core/base/pipe.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>

namespace analogon {

std::optional<Pipe> Pipe::make() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return std::nullopt;
    return Pipe{FileHandle(ends[0]), FileHandle(ends[1])};
}

bool readSome(int handle, std::string& text) {
    std::array<char, 65536> buffer;
    ssize_t count = 0;
    do count = ::read(handle, buffer.data(), buffer.size());
    while (count < 0 && errno == EINTR);
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0;
}

}  // namespace analogon
