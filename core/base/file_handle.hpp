#pragma once

#include <unistd.h>

#include <utility>

namespace analogon {

/// An open file or directory of the system; closed with the object.
class FileHandle {
public:
    explicit FileHandle(int number = -1) : number_(number) {}
    ~FileHandle() { reset(); }
    FileHandle(FileHandle&& other) noexcept : number_(other.release()) {}
    FileHandle& operator=(FileHandle&& other) noexcept {
        reset();
        number_ = other.release();
        return *this;
    }

    bool isOpen() const { return number_ >= 0; }
    int number() const { return number_; }
    int release() { return std::exchange(number_, -1); }
    void reset() {
        if (number_ >= 0) close(release());
    }

private:
    int number_;
};

}  // namespace analogon
