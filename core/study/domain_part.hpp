#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/diagram/diagram.hpp"

namespace analogon {

/// A signal connector with its unit.
struct SignalPort {
    std::string name, unit;
};

/// The basic class of one domain as a part of a model that is being composed.
struct DomainPart {
    std::string name;     // of the instance: "motor"
    std::string package;  // "ElectricMechanical"
    std::string className;
    std::vector<Port> ports;  // flanges and heat ports
    std::vector<SignalPort> inputs, outputs;
    std::map<std::string, std::string> values;  // modifications
    Point centre;                               // in the diagram
};

/// A connector whose class ends in _b gives on, one whose class ends in _a takes.
bool isOutgoing(const Port& port);

/// The part of a domain ("electric-thermal") with its connectors. Fault: a domain that the library does not know.
Outcome<DomainPart> readDomainPart(const Library& library, const std::string& domain);

/// Domains that the library knows: a package `ElectricThermal` with a class `BasicElectricThermal` is
/// "electric-thermal".
std::vector<std::string> knownDomains(const Library& library);

}  // namespace analogon
