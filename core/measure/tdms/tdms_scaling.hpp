#pragma once

#include <map>
#include <span>
#include <string>

#include "core/measure/tdms/tdms_segments.hpp"

namespace analogon::tdms {

/// From raw values to the quantity, by the properties NI_Scale[…] of a channel.
class Scaling {
public:
    explicit Scaling(const Object& channel);

    /// Names a scale that cannot be applied (a thermocouple, say); the values are then raw.
    const std::string& unreadable() const { return unreadable_; }
    bool isNone() const { return !isOn_; }
    void apply(std::span<double> values) const;

private:
    struct Step {
        enum class Kind { Linear, Polynomial, Table } kind{Kind::Linear};
        std::vector<double> numbers;  // slope and intercept; coefficients; keys
        std::vector<double> tableValues{};
    };
    bool readStep(const Object& channel, int scale, Step& step, double& source);

    std::vector<Step> steps_;  // in the order in which they are applied
    std::string unreadable_;
    bool isOn_{};
};

}  // namespace analogon::tdms
