#include "core/base/memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace analogon {
namespace {

TEST(LargeMemory, IsThereForAnySizeAndAnyBeginning) {
    constexpr std::size_t MB = 1 << 20;
    std::vector<char> bytes(9 * MB, 'a');
    for (const std::size_t first : {std::size_t{0}, std::size_t{1}, std::size_t{4097}})
        for (const std::size_t count : {std::size_t{0}, std::size_t{1}, 4 * MB, 8 * MB})
            useHugePages(bytes.data() + first, count);
    EXPECT_EQ(std::count(bytes.begin(), bytes.end(), 'a'), 9 * MB) << "what stands there stays";
}

/// Whether the mapping that holds this address asks for huge pages (proc(5), VmFlags); none where nobody can tell.
std::optional<bool> asksForHugePages(const void* address) {
    std::ifstream maps("/proc/self/smaps");
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    bool isIn = false;
    for (std::string line; std::getline(maps, line);) {
        std::uintptr_t first{}, last{};
        if (std::sscanf(line.c_str(), "%lx-%lx ", &first, &last) == 2) isIn = first <= at && at < last;
        if (isIn && line.starts_with("VmFlags:")) return line.find(" hg") != std::string::npos;
    }
    return std::nullopt;
}

TEST(LargeMemory, AsksForHugePages) {
    if (!std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled")) GTEST_SKIP() << "the system has no huge pages";
    constexpr std::size_t bytes = 64 << 20;
    const std::unique_ptr<void, decltype(&std::free)> memory(std::malloc(bytes), &std::free);
    const void* middle = static_cast<char*>(memory.get()) + bytes / 2;
    const std::optional<bool> before = asksForHugePages(middle);
    if (!before) GTEST_SKIP() << "the system does not tell how memory is mapped";
    EXPECT_FALSE(*before);
    useHugePages(memory.get(), bytes);
    EXPECT_TRUE(*asksForHugePages(middle));
}

TEST(LargeMemory, IsWhatAHeapThatWasGrownHandsOut) {
    if (!std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled")) GTEST_SKIP() << "the system has no huge pages";
    growHeap();
    constexpr std::size_t bytes = 100'000, count = 160;  // no hole of the heap is as large
    std::vector<std::unique_ptr<char[]>> blocks;
    for (std::size_t i = 0; i < count; ++i) blocks.push_back(std::make_unique<char[]>(bytes));
    const std::optional<bool> asks = asksForHugePages(blocks[count / 2].get());
    if (!asks) GTEST_SKIP() << "the system does not tell how memory is mapped";
    EXPECT_TRUE(*asks);
}

/// Of a matrix, only what resizeLarge() asks of it.
struct Columns {
    using Scalar = double;
    std::ptrdiff_t rows() const { return rows_; }
    std::ptrdiff_t cols() const { return columns_; }
    std::ptrdiff_t size() const { return rows_ * columns_; }
    double* data() { return values_.data(); }
    void resize(std::ptrdiff_t rows, std::ptrdiff_t columns) {
        rows_ = rows, columns_ = columns;
        values_.assign(static_cast<std::size_t>(rows * columns), 0.0);
    }
    std::ptrdiff_t rows_{}, columns_{};
    std::vector<double> values_;
};

TEST(LargeMemory, OfAMatrixIsMadeOnlyForAnotherSize) {
    Columns matrix;
    resizeLarge(matrix, 700'000, 2);
    EXPECT_EQ(matrix.values_.size(), 1'400'000u);
    matrix.values_[5] = 7.0;
    resizeLarge(matrix, 700'000, 2);
    EXPECT_EQ(matrix.values_[5], 7.0);
    resizeLarge(matrix, 2, 700'000);
    EXPECT_EQ(matrix.rows(), 2);
    EXPECT_EQ(matrix.values_[5], 0.0);
}

}  // namespace
}  // namespace analogon
