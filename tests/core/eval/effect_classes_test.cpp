#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/eval/system.hpp"
#include "tests/core/eval/tangent_check.hpp"

namespace analogon {
namespace {

/// A place for an effect in one of two models of the block library.
struct Case {
    std::string effect;      // class in Analogon.Effects
    std::string parameters;  // modification of the effect
    std::string wiring;      // equations that put it in its place
    std::string lifted;      // equation of the host that the effect replaces
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.effect << "(" << c.parameters << ")"; }

std::string without(std::string text, const std::string& part) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return part.empty() ? text : text.erase(at, part.size());
}

const char* const pump = R"(
  Analogon.Interfaces.RealInput v(unit="V");
  Analogon.Interfaces.RealOutput i(unit="A");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=0.8, L=1e-3, k=0.02);
  Analogon.Mechanics.BasicMechanics shaft(r=1, J1=6e-5, J2=4e-5, c=60, d=0.03);
  Analogon.Mechanics.QuadraticLoad load(k_q=2e-5);
  Analogon.Sensors.SpeedSensor sensor;
  EFFECT
equation
  connect(v, motor.v);
  connect(motor.flange, shaft.flange_a);
  connect(shaft.flange_b, load.flange);
  connect(shaft.flange_b, sensor.flange);
  connect(motor.i, i);
  connect(sensor.w, w);
)";

const char* const heater = R"(
  Analogon.Interfaces.RealInput v(unit="V");
  Analogon.Interfaces.RealInput T_gas(unit="K");
  Analogon.Interfaces.RealOutput i(unit="A");
  Analogon.ElectricThermal.BasicElectricThermal coil(R=3, alpha=4e-3);
  Analogon.ThermalFluid.BasicThermalFluid element(C=2, c_o=0.5, A=2e-4, T_start=300);
  Analogon.Sources.PrescribedTemperature gas;
  EFFECT
equation
  connect(v, coil.v);
  connect(coil.i, i);
  connect(coil.heatPort, element.solid);
  connect(T_gas, gas.T);
  connect(element.fluid, gas.port);
)";

std::shared_ptr<const System> hostWith(const std::string& host, const Case& c) {
    const Outcome<Library> builtIn = builtInLibrary();
    EXPECT_TRUE(builtIn) << format(builtIn.diagnostics());
    if (!builtIn) return nullptr;
    std::string text = without(host, c.lifted);
    text.replace(text.find("EFFECT"), 6, "Analogon.Effects." + c.effect + " e(" + c.parameters + ");");
    text = "model M" + text + c.wiring + "\nend M;\n";
    const Outcome<Library> library = builtIn->withSource(std::make_shared<const Source>("model.mo", text));
    EXPECT_TRUE(library) << format(library.diagnostics());
    if (!library) return nullptr;
    StructureOptions options;
    const Outcome<FlatModel> flat = flatten(*library, "M");
    EXPECT_TRUE(flat) << format(flat.diagnostics());
    if (!flat) return nullptr;
    for (const FlatVariable& variable : flat->variables)
        if (variable.name.starts_with("e.") && variable.variability == FlatVariability::Parameter &&
            variable.type == FlatType::Real && variable.binding.valid())
            options.keep.push_back(variable.name);
    EXPECT_FALSE(options.keep.empty());
    const Outcome<SystemPtr> system = compile(*library, "M", options);
    EXPECT_TRUE(system) << format(system.diagnostics());
    return system ? *system : nullptr;
}

class MechanicalEffect : public ::testing::TestWithParam<Case> {};

TEST_P(MechanicalEffect, HasTheTangentsOfItsEquations) {
    const auto system = hostWith(pump, GetParam());
    ASSERT_TRUE(system);
    std::vector<double> x, u(static_cast<std::size_t>(system->slotCount()), 4.0);
    for (int i = 0; i < system->stateCount(); ++i) x.push_back(0.4 + 0.13 * i);
    test::checkTangents(*system, x, u);
}

INSTANTIATE_TEST_SUITE_P(
    Library, MechanicalEffect,
    ::testing::Values(
        Case{"Mechanics.CoulombFriction", "tau_c=0.01, w_eps=0.5", "connect(e.flange, shaft.flange_b);", ""},
        Case{"Mechanics.CoulombFriction", "tau_c=0, w_eps=0.5", "connect(e.flange, motor.flange);", ""},
        Case{"Mechanics.ViscousFriction", "b=0", "connect(e.flange, load.flange);", ""},
        Case{"Mechanics.QuadraticDrag", "k_q=1e-4", "connect(e.flange, shaft.flange_a);", ""},
        Case{"Mechanics.ConstantTorque", "tau_0=0", "connect(e.flange, shaft.flange_b);", ""},
        Case{"Mechanics.ReturnSpring", "c_r=0.3", "connect(e.flange, shaft.flange_b);", ""},
        Case{"Mechanics.AddedInertia", "J=0", "connect(e.flange, shaft.flange_b);", ""},
        Case{"Mechanics.AddedInertia", "J=1e-4", "connect(e.flange, motor.flange);", ""},
        Case{"Sensor.Lag", "T=0.02", "connect(sensor.w, e.u); connect(e.y, w);", "connect(sensor.w, w);"},
        Case{"Sensor.Delay", "T=0.02", "connect(sensor.w, e.u); connect(e.y, w);", "connect(sensor.w, w);"},
        Case{"Sensor.Offset", "", "connect(motor.i, e.u); connect(e.y, i);", "connect(motor.i, i);"},
        Case{"Actuator.Delay", "T=0.02", "connect(v, e.u); connect(e.y, motor.v);", "connect(v, motor.v);"},
        Case{"Actuator.DeadZone", "b=0.1", "connect(v, e.u); connect(e.y, motor.v);", "connect(v, motor.v);"}));

class ThermalEffect : public ::testing::TestWithParam<Case> {};

TEST_P(ThermalEffect, HasTheTangentsOfItsEquations) {
    const auto system = hostWith(heater, GetParam());
    ASSERT_TRUE(system);
    std::vector<double> x, u(static_cast<std::size_t>(system->slotCount()), 5.0);
    for (int i = 0; i < system->stateCount(); ++i) x.push_back(340 + 13.0 * i);
    u[static_cast<std::size_t>(system->inputIndex("T_gas"))] = 310;
    test::checkTangents(*system, x, u);
}

INSTANTIATE_TEST_SUITE_P(Library, ThermalEffect,
                         ::testing::Values(Case{"Thermal.Loss", "G=0.02", "connect(e.port, element.solid);", ""},
                                           Case{"Thermal.Loss", "G=0", "connect(e.port, coil.heatPort);", ""},
                                           Case{"Thermal.Radiation", "k_r=1e-11", "connect(e.port, element.solid);",
                                                ""},
                                           Case{"Thermal.Mass", "C2=0.5", "connect(e.port, element.solid);", ""}));

}  // namespace
}  // namespace analogon
