#include "core/library/moved_classes.hpp"

#include <algorithm>
#include <array>

namespace analogon {

namespace {

/// After the release notes of the library (Modelica.UsersGuide.ReleaseNotes, versions 3.0 and 4.0.0). What lies deeper
/// stands before what holds it.
constexpr std::array moved{
    MovedClass{"Modelica.SIunits.Conversions.NonSIunits", "Modelica.Units.NonSI"},
    MovedClass{"Modelica.SIunits.Conversions", "Modelica.Units.Conversions"},
    MovedClass{"Modelica.SIunits.Icons", "Modelica.Units.Icons"},
    MovedClass{"Modelica.SIunits", "Modelica.Units.SI"},
    MovedClass{"Modelica.Electrical.Analog.Basic.EMF", "Modelica.Electrical.Analog.Basic.RotationalEMF"},
    MovedClass{"Modelica.Electrical.MultiPhase", "Modelica.Electrical.Polyphase"},
    MovedClass{"Modelica.Electrical.QuasiStationary", "Modelica.Electrical.QuasiStatic"},
    MovedClass{"Modelica.Blocks.Tables.CombiTable1D", "Modelica.Blocks.Tables.CombiTable1Dv"},
    MovedClass{"Modelica.Blocks.Tables.CombiTable2D", "Modelica.Blocks.Tables.CombiTable2Ds"},
    MovedClass{"Modelica.Mechanics.Rotational.Inertia", "Modelica.Mechanics.Rotational.Components.Inertia"},
    MovedClass{"Modelica.Mechanics.Rotational.Spring", "Modelica.Mechanics.Rotational.Components.Spring"},
    MovedClass{"Modelica.Mechanics.Rotational.Damper", "Modelica.Mechanics.Rotational.Components.Damper"},
    MovedClass{"Modelica.Mechanics.Rotational.SpringDamper", "Modelica.Mechanics.Rotational.Components.SpringDamper"},
    MovedClass{"Modelica.Mechanics.Rotational.Fixed", "Modelica.Mechanics.Rotational.Components.Fixed"},
    MovedClass{"Modelica.Mechanics.Rotational.IdealGear", "Modelica.Mechanics.Rotational.Components.IdealGear"},
    MovedClass{"Modelica.Mechanics.Rotational.Torque", "Modelica.Mechanics.Rotational.Sources.Torque"},
    MovedClass{"Modelica.Thermal.HeatTransfer.HeatCapacitor", "Modelica.Thermal.HeatTransfer.Components.HeatCapacitor"},
    MovedClass{"Modelica.Thermal.HeatTransfer.ThermalConductor",
               "Modelica.Thermal.HeatTransfer.Components.ThermalConductor"},
    MovedClass{"Modelica.Thermal.HeatTransfer.Convection", "Modelica.Thermal.HeatTransfer.Components.Convection"},
    MovedClass{"Modelica.Thermal.HeatTransfer.BodyRadiation", "Modelica.Thermal.HeatTransfer.Components.BodyRadiation"},
};

}  // namespace

const MovedClass* movedClass(std::string_view name) {
    const auto found = std::find_if(moved.begin(), moved.end(), [&](const MovedClass& m) {
        return name.starts_with(m.before) && (name.size() == m.before.size() || name[m.before.size()] == '.');
    });
    return found == moved.end() ? nullptr : &*found;
}

std::string newName(std::string_view name) {
    const MovedClass* const entry = movedClass(name);
    return entry ? std::string(entry->now) + std::string(name.substr(entry->before.size())) : std::string();
}

}  // namespace analogon
