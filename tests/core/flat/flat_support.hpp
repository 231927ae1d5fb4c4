#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/flat/flat_model.hpp"

/// Small models as text, flattened, and what is asked of them.
namespace analogon::test {

/// Connectors and components of two domains, enough for connections.
inline const char* parts = R"(
package Parts
  type Angle = Real(final quantity = "Angle", unit = "rad", displayUnit = "deg");
  connector Flange
    Angle phi "angle";
    flow Real tau(unit = "N.m") "torque";
  end Flange;
  connector HeatPort
    Real T(unit = "K");
    flow Real Q_flow(unit = "W");
  end HeatPort;
  connector RealInput = input Real;
  connector RealOutput = output Real;
  partial model TwoFlanges
    Flange a;
    Flange b;
  end TwoFlanges;
  model Inertia
    extends TwoFlanges;
    parameter Real J(unit = "kg.m2", min = 0) = 1 "moment of inertia";
    Angle phi;
    Real w(unit = "rad/s", start = 0);
  equation
    phi = a.phi;
    phi = b.phi;
    w = der(phi);
    J*der(w) = a.tau + b.tau;
  end Inertia;
  model SpringDamper
    extends TwoFlanges;
    parameter Real c(unit = "N.m/rad");
    parameter Real d(unit = "N.m.s/rad") = 0;
  equation
    b.tau = c*(b.phi - a.phi) + d*der(b.phi - a.phi);
    a.tau = -b.tau;
  end SpringDamper;
  model Fixed
    parameter Angle phi0 = 0;
    Flange flange;
  equation
    flange.phi = phi0;
  end Fixed;
  model Torque
    RealInput tau(unit = "N.m");
    Flange flange;
  equation
    flange.tau = -tau;
  end Torque;
  model SpeedSensor
    Flange flange;
    RealOutput w(unit = "rad/s");
  equation
    w = der(flange.phi);
    flange.tau = 0;
  end SpeedSensor;
  model HeatCapacitor
    parameter Real C(unit = "J/K");
    parameter Real T_start(unit = "K") = 293.15;
    HeatPort port(T(start = T_start, fixed = true));
  equation
    C*der(port.T) = port.Q_flow;
  end HeatCapacitor;
  block Gain
    parameter Real k = 1;
    RealInput u;
    RealOutput y;
  equation
    y = k*u;
  end Gain;
end Parts;
)";

inline Library libraryOf(const std::string& text) {
    Library library;
    for (const std::string& source : {std::string(parts), text}) {
        auto next = library.withSource(std::make_shared<Source>("test.mo", source));
        EXPECT_TRUE(next) << format(next.diagnostics());
        if (next) library = *next;
    }
    return library;
}

/// Flattened, or a failed test.
inline FlatModel flatOf(const std::string& text, const std::string& name = "M") {
    auto model = flatten(libraryOf(text), name);
    EXPECT_TRUE(model) << format(model.diagnostics());
    return model ? std::move(*model) : FlatModel{};
}

/// The messages of a model that must not flatten, with their hints.
inline std::vector<std::string> faultsOf(const std::string& text, const std::string& name = "M") {
    std::vector<std::string> messages;
    const auto model = flatten(libraryOf(text), name);
    if (!model)
        for (const Diagnostic& d : model.diagnostics())
            messages.push_back(d.hint.empty() ? d.message : d.message + " | " + d.hint);
    return messages;
}

inline std::string text(const FlatModel& model, ExpressionId id) {
    return model.pool->print(id, [&](VariableId v) { return model[v].name; });
}

inline std::vector<std::string> texts(const FlatModel& model, const std::vector<FlatEquation>& equations) {
    std::vector<std::string> result;
    for (const FlatEquation& e : equations) result.push_back(text(model, e.left) + " = " + text(model, e.right));
    return result;
}

inline std::vector<std::string> equations(const FlatModel& model) { return texts(model, model.equations); }

inline const FlatVariable& variable(const FlatModel& model, const std::string& name) {
    static const FlatVariable none;
    const VariableId id = model.find(name);
    EXPECT_TRUE(id.valid()) << name;
    return id.valid() ? model[id] : none;
}

inline double valueOf(const FlatModel& model, const std::string& name) {
    const VariableId id = model.find(name);
    EXPECT_TRUE(id.valid()) << name;
    return id.valid() ? model.parameterValue(id).value_or(-1e300) : -1e300;
}

inline std::vector<std::string> names(const FlatModel& model) {
    std::vector<std::string> result;
    for (const FlatVariable& v : model.variables) result.push_back(v.name);
    return result;
}

}  // namespace analogon::test
