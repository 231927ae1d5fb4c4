#pragma once

#include <functional>
#include <span>
#include <string>

#include "core/study/run_history.hpp"

/// A run as JSON and back, to the last digit. Long arrays are not part of the text: it holds the names under which they
/// are kept.
namespace analogon {

/// Keeps an array and gives its name; empty: it is not kept.
using KeepArray = std::function<std::string(std::span<const double>)>;
/// The array of a name; throws std::runtime_error where it is not there.
using FindArray = std::function<std::vector<double>(const std::string&)>;

std::string runJson(const PastRun& run, const KeepArray& keep);

/// Throws std::exception with a reason where the text is no run. `name`: of the text, for messages; `present`: the
/// study the history belongs to, which has the measurements.
PastRun parseRun(const std::string& text, const std::string& name, const Study& present, const FindArray& find);

}  // namespace analogon
