#pragma once

#include <vector>

namespace analogon {

/// The middle of the values, or the mean of the two middle ones; 0 of none.
double median(std::vector<double> values);

}  // namespace analogon
