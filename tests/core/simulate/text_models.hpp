#pragma once

#include <gtest/gtest.h>

#include "core/eval/system.hpp"

namespace analogon::test {

/// A model from plain text; parameters in `keep` stay free.
inline SystemPtr compileText(const std::string& text, const std::string& className,
                             std::vector<std::string> keep = {}) {
    Outcome<Library> library = Library().withSource(std::make_shared<const Source>("model.mo", text));
    EXPECT_TRUE(library) << format(library.diagnostics());
    if (!library) return nullptr;
    Outcome<SystemPtr> system = compile(*library, className, {std::move(keep)});
    EXPECT_TRUE(system) << format(system.diagnostics());
    return system ? *system : nullptr;
}

inline std::vector<double> ownParameters(const System& system) {
    std::vector<double> p;
    for (const SignalInfo& info : system.parameters()) p.push_back(info.value);
    return p;
}

/// A motor on an elastic shaft: 5 states (current, two angles, two speeds).
inline const char* const motorText = R"(
model Motor
  input Real v;
  output Real i_meas;
  output Real w_meas;
  parameter Real R = 1.2;
  parameter Real L = 0.004;
  parameter Real k = 0.05;
  parameter Real J1 = 2e-4;
  parameter Real J2 = 5e-4;
  parameter Real c = 5;
  parameter Real d = 0.01;
  parameter Real b = 1e-4;
  Real i(start = 0, fixed = true);
  Real phi1(start = 0, fixed = true);
  Real phi2(start = 0, fixed = true);
  Real w1(start = 0, fixed = true);
  Real w2(start = 0, fixed = true);
  Real tau;
equation
  L*der(i) = v - R*i - k*w1;
  der(phi1) = w1;
  der(phi2) = w2;
  tau = c*(phi1 - phi2) + d*(w1 - w2);
  J1*der(w1) = k*i - tau;
  J2*der(w2) = tau - b*w2;
  i_meas = i;
  w_meas = w2;
end Motor;
)";

}  // namespace analogon::test
