#pragma once

#include <set>
#include <string>

#include "core/flat/flattening.hpp"

namespace analogon {

/// As many equations as unknowns in each model and block, as many flows as potentials in each connector
/// (Modelica 3.6, sections 4.7 and 9.3.1).
class Balance {
public:
    explicit Balance(Flattening& work) : work_(work) {}

    void check();
    /// Connectors alone: needs no equations.
    void checkConnectors();

private:
    void countUnknowns();
    void checkComponents();
    struct Unused {
        std::string names;
        bool areOutputs{};  // of the model, all of them
    };
    Unused unused(const Instance& component) const;

    Flattening& work_;
    std::set<std::string> reported_;
};

}  // namespace analogon
