#pragma once

#include <matio.h>

#include <memory>
#include <string>
#include <vector>

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

bool isNumeric(const matvar_t& variable);
std::size_t valuesOf(const matvar_t& variable);

/// `count` values from `first` on, `step` apart; `variable` is numeric, real and has its data.
std::vector<double> numbers(const matvar_t& variable, std::size_t first, std::size_t step, std::size_t count);

/// Rows of a character array, without blanks at the end.
std::vector<std::string> textRows(const matvar_t& variable);

/// Rows of a character array, or the texts of a cell array. Empty: something else.
std::vector<std::string> textList(const matvar_t& variable);

}  // namespace analogon::mat
