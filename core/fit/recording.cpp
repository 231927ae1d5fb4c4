#include "core/fit/recording.hpp"

#include <algorithm>

namespace analogon {

bool Recording::isHeld(const std::string& input) const {
    return std::find(held.begin(), held.end(), input) != held.end();
}

double Recording::between(Eigen::Index input, Eigen::Index sample, double part) const {
    if (part == 0 || isHeld(inputNames[static_cast<std::size_t>(input)])) return inputs(input, sample);
    return (1 - part) * inputs(input, sample) + part * inputs(input, sample + 1);
}

void Recording::addInput(std::string input, const Eigen::VectorXd& values) {
    inputNames.push_back(std::move(input));
    inputs.conservativeResize(inputs.rows() + 1, values.size());
    inputs.bottomRows(1) = values.transpose();
}

}  // namespace analogon
