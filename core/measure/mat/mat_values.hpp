#pragma once

#include <matio.h>

#include <memory>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/base/progress.hpp"
#include "core/measure/recording.hpp"

/// Values of libmatio's variables.
namespace analogon::mat {

struct FileCloser {
    void operator()(mat_t* file) const { Mat_Close(file); }
};
struct VariableFreer {
    void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using FilePtr = std::unique_ptr<mat_t, FileCloser>;
using VariablePtr = std::unique_ptr<matvar_t, VariableFreer>;

/// How to get from a variable to values within it.
struct FieldStep {
    std::string field;    // of a structure
    std::size_t index{};  // in an array of structures
};
/// Where a channel has its values: `count` from `first` on, `stride` apart; value = number * scale + offset.
struct VariablePlace {
    std::string variable;
    std::vector<FieldStep> steps{};
    std::size_t first{}, stride{1}, count{};
    double scale{1}, offset{0};
};

const matvar_t* fieldOf(const matvar_t& structure, const std::string& name, std::size_t index);

bool isNumeric(const matvar_t& variable);
std::size_t valuesOf(const matvar_t& variable);

/// `count` values from `first` on, `step` apart; `variable` is numeric, real and has its data.
std::vector<double> numbers(const matvar_t& variable, std::size_t first, std::size_t step, std::size_t count);

/// Rows of a character array, without blanks at the end.
std::vector<std::string> textRows(const matvar_t& variable);

/// Rows of a character array, or the texts of a cell array. Empty: something else.
std::vector<std::string> textList(const matvar_t& variable);

/// The values at each place; a variable is read once. Faults: the file, or a variable, cannot be read; stopped.
Outcome<std::vector<ChannelValues>> readPlaces(const std::string& file, const std::vector<VariablePlace>& places,
                                               const Progress& progress);

}  // namespace analogon::mat
