#pragma once

#include <cstddef>

namespace analogon {

/// Asks the system to back memory that was not written yet with huge pages: fresh small ones are found one by one,
/// which costs more than most of what fills them (Linux: madvise(2), MADV_HUGEPAGE). A hint, without effect on less
/// than a few megabytes and where the system has no such pages.
void useHugePages(void* memory, std::size_t bytes);

/// Grows the heap once, in huge pages, by what it takes to read the library and a study: half of the time to the first
/// traces was spent on small pages. For the start of a program, before it has threads. Without effect where the C
/// library is not glibc.
void growHeap();

/// `matrix.resize(rows, columns)` of an Eigen matrix or vector that may be large; its old values are lost.
template <class Matrix>
void resizeLarge(Matrix& matrix, std::ptrdiff_t rows, std::ptrdiff_t columns) {
    if (matrix.rows() == rows && matrix.cols() == columns) return;
    matrix.resize(rows, columns);
    useHugePages(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(typename Matrix::Scalar));
}

}  // namespace analogon
