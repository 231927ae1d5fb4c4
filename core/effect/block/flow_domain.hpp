#pragma once

#include <array>
#include <string_view>

namespace analogon {

/// What flows at a node and what drives it, by physical domain. Names are those of the connectors' variables.
struct FlowDomain {
    std::string_view flow, flowUnit;
    std::string_view lawName;        // of a class that holds a law for it
    std::string_view potentialUnit;  // of the variable that is equal at the node
    std::string_view rate{};         // derivative of the potential, on which a flow may depend too; empty: none does
    std::string_view rateUnit{};
};

/// The domain in which something is called so; an unknown one has no units.
constexpr FlowDomain flowDomain(std::string_view flow) {
    constexpr std::array<FlowDomain, 4> known{{{"tau", "N.m", "MissingTorque", "rad", "w", "rad/s"},
                                               {"f", "N", "MissingForce", "m", "v", "m/s"},
                                               {"i", "A", "MissingCurrent", "V"},
                                               {"Q_flow", "W", "MissingHeatFlow", "K"}}};
    for (const FlowDomain& domain : known)
        if (domain.flow == flow) return domain;
    return {flow, "", "MissingFlow", ""};
}

}  // namespace analogon
