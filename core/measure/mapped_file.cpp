#include "core/measure/mapped_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace analogon {

namespace {

Diagnostic cannotRead(const std::filesystem::path& file, int code) {
    return fileError(phrase("this cannot be read: {}", std::generic_category().message(code)), file.string());
}

}  // namespace

Outcome<std::shared_ptr<const MappedFile>> MappedFile::open(const std::filesystem::path& file) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);  // a pipe may never be filled
    if (descriptor < 0) return cannotRead(file, errno);
    struct stat status {};
    const int known = fstat(descriptor, &status);
    const int code = errno;
    if (known != 0 || !S_ISREG(status.st_mode)) {
        ::close(descriptor);
        if (known != 0) return cannotRead(file, code);
        if (S_ISDIR(status.st_mode)) return cannotRead(file, EISDIR);
        return fileError(phrase("this is a pipe or a device, not a file"), file.string(), 0, 0,
                         phrase("Copy what it gives into a file."));
    }
    const auto size = static_cast<std::size_t>(status.st_size);
    void* memory = size == 0 ? nullptr : mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
    const int mapped = errno;
    ::close(descriptor);
    if (memory == MAP_FAILED) return cannotRead(file, mapped);
    return std::shared_ptr<const MappedFile>(new MappedFile(ByteView(static_cast<const std::uint8_t*>(memory), size)));
}

void MappedFile::letGo() const {
    if (!bytes_.empty()) madvise(const_cast<std::uint8_t*>(bytes_.data()), bytes_.size(), MADV_DONTNEED);
}

MappedFile::~MappedFile() {
    if (!bytes_.empty()) munmap(const_cast<std::uint8_t*>(bytes_.data()), bytes_.size());
}

}  // namespace analogon
