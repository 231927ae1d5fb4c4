#include "core/base/memory.hpp"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>
#include <cstdlib>

namespace analogon {

void useHugePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t page = std::uintptr_t{2} << 20;  // the usual size; others are left to the system
    if (bytes < 2 * page) return;
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (begin + page - 1) & ~(page - 1), end = (begin + bytes) & ~(page - 1);
    // refused: small pages, as ever
    if (end > first) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

void growHeap() {
#ifdef __GLIBC__
    constexpr std::size_t bytes = std::size_t{28} << 20;  // the heap takes blocks of at most 32 MB
    // What was mapped and is freed comes from the heap the next time (mallopt(3), M_MMAP_THRESHOLD), and stays there.
    void* volatile memory = std::malloc(bytes);
    std::free(memory);
    memory = std::malloc(bytes);
    if (memory) useHugePages(memory, bytes);
    std::free(memory);
#endif
}

}  // namespace analogon
