#pragma once

#include <string>
#include <vector>

#include "core/base/outcome.hpp"

namespace analogon {

/// Numbers in rows.
struct Matrix {
    std::size_t rows{}, columns{};
    std::vector<double> values;
    double operator()(std::size_t i, std::size_t j) const { return values[i * columns + j]; }
};

/// A matrix of a text file (`double name(rows, columns)` behind a line #1) , of a CSV or of a MATLAB file.
Outcome<Matrix> readTableFile(const std::string& file, const std::string& name, const std::string& delimiter,
                              int headerLines);

}  // namespace analogon
