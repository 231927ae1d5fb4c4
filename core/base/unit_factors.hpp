#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace analogon {

/// A unit as the product of the symbols it is written with, so that the unit of a product of quantities reads as an
/// engineer would write it (N.m.s/rad, not kg.m2/s). No symbol is taken apart and none converted.
class UnitFactors {
public:
    UnitFactors() = default;
    /// Of a Modelica unit: "W/(m2.K)", "rad/s", "s-1"; nothing for what is not a product of symbols ("%").
    static std::optional<UnitFactors> of(std::string_view unit);

    UnitFactors times(const UnitFactors& other, int power = 1) const;
    UnitFactors toThe(int power) const { return UnitFactors().times(*this, power); }

    /// "W/(m2.K)"; "1" for none.
    std::string text() const;

private:
    struct Factor {
        std::string symbol;
        int power{};
    };
    std::vector<Factor> factors_;
};

}  // namespace analogon
