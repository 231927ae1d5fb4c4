#pragma once

#include <map>
#include <string>
#include <vector>

#include "model.hpp"
#include "random.hpp"

/// Six families of components with electric drive, each in several wirings, with random sizes and names.
namespace bench {

struct FitParameter {
    std::string path;
    double truth{}, start{}, low{}, high{};
    bool logarithmic{true};
};

struct Column {
    std::string name, unit;
};

/// A study before anything was recorded: the true plant without its hidden effect, and how it is driven and named.
struct Design {
    char system{};
    std::string systemName;
    Model model;  // with the true values
    std::vector<FitParameter> fitted;
    std::map<std::string, Column> columns;  // of each top-level signal
    std::vector<std::string> temperatures;  // "instance.T_start" of every heat capacity
    Column flow;                            // name empty: none recorded
    bool battery{}, pressure{}, oil{};      // further channels
    double dt{}, duration{};
    double top{};   // largest input
    double pace{};  // length of a typical stretch of constant input [s]
    int edge{1};    // samples a step takes
    bool bipolar{}, chirps{};
    double gasLow{}, gasHigh{}, gasPace{};  // imposed temperature [K], [s]
};

class Builder {
public:
    Builder(char system, Random& random) : random_(random) { d_.system = system; }

    Design design() {
        switch (d_.system) {
            case 'A':
                probe();
                break;
            case 'B':
                pump();
                break;
            case 'C':
                gearedMotor();
                break;
            case 'D':
                throttle();
                break;
            case 'E':
                coolantHeater();
                break;
            case 'F':
                fan();
                break;
            default:
                throw std::runtime_error("systems are A to F");
        }
        // The values a user would start from: 10 to 50 % away.
        for (auto& f : d_.fitted) {
            do {
                const double factor = random_.uniform(1.1, 1.5);
                f.start = rounded(random_.chance(0.5) ? f.truth * factor : f.truth / factor, 2);
            } while (std::abs(f.start / f.truth - 1.0) < 0.095 || std::abs(f.start / f.truth - 1.0) > 0.505);
        }
        return d_;
    }

private:
    using List = std::vector<std::string>;

    std::string name(const List& from) {
        std::string n;
        do n = random_.pick(from);
        while (used(n));
        return n;
    }
    bool used(const std::string& n) const {
        if (d_.model.part(n)) return true;
        for (const auto& s : d_.model.signals)
            if (s.name == n) return true;
        return false;
    }
    double sized(double typical, double spread = 1.35) {
        return rounded(random_.logUniform(typical / spread, typical * spread), 3);
    }

    std::string part(const std::string& type, const List& names, std::vector<std::pair<std::string, double>> values,
                     double x, double y) {
        const std::string n = name(names);
        d_.model.parts.push_back({type, n, std::move(values), x, y});
        return n;
    }
    std::string signal(bool input, const List& names, const std::string& unit, double x, double y, const List& columns,
                       const List& units) {
        const std::string n = name(names);
        d_.model.signals.push_back({n, unit, input, x, y});
        std::string column = random_.pick(columns);
        for (const auto& [other, c] : d_.columns)
            if (c.name == column) column += "_2";
        d_.columns[n] = {column, random_.pick(units)};
        return n;
    }
    void wire(const std::string& from, const std::string& to) { d_.model.wires.push_back({from, to}); }
    void fit(const std::string& path, double low, double high, bool logarithmic = true) {
        const auto dot = path.find('.');
        const double truth = d_.model.part(path.substr(0, dot))->value(path.substr(dot + 1), 0.0);
        d_.fitted.push_back({path, truth, truth, low, high, logarithmic});
    }
    void title(const std::string& system, const List& names, const std::string& comment) {
        d_.systemName = system;
        d_.model.name = random_.pick(names);
        d_.model.comment = comment;
    }
    /// The drive's voltage: an input in volts, or a duty cycle through a gain.
    void voltage(const std::string& drive, const List& names, const List& columns, double top, double x, double y,
                 bool milli) {
        if (random_.chance(0.3)) {
            const double supply = rounded(top * random_.uniform(1.05, 1.2), 3);
            const auto duty = signal(true, {"duty", "duty_in", "pwm", "dc_ratio"}, "1", x - 100, y,
                                     {"duty_cycle", "duty", "pwm_ratio"}, {"%", "1"});
            const auto stage =
                part("Signals.Gain", {"stage", "bridge", "driver", "power_stage"}, {{"k", supply}}, x - 50, y);
            wire(duty, stage + ".u");
            wire(stage + ".y", drive + ".v");
            d_.top = rounded(top / supply, 3);
        } else {
            const auto in = signal(true, names, "V", x - 100, y, columns, milli ? List{"V", "V", "mV"} : List{"V"});
            wire(in, drive + ".v");
            d_.top = top;
        }
    }
    void currentOut(const std::string& drive, const List& names, const List& columns) {
        const auto out = signal(false, names, "A", 200, 60, columns, {"A", "mA", "A"});
        wire(drive + ".i", out);
    }
    void speedOut(const std::string& flange, const List& names, const List& columns, const List& units, double x) {
        const auto sensor =
            part("Sensors.SpeedSensor", {"pickup", "tacho", "hall", "enc", "speed_sensor", "n_sensor"}, {}, x, -40);
        const auto out = signal(false, names, "rad/s", 200, -40, columns, units);
        wire(flange, sensor + ".flange");
        wire(sensor + ".w", out);
    }
    void temperatureOut(const std::string& port, const List& names, const List& columns, double x, double y) {
        const auto sensor =
            part("Sensors.TemperatureSensor", {"ntc", "pt100", "probe", "t_sensor", "thermo"}, {}, x, y);
        const auto out = signal(false, names, "K", 200, y, columns, {"degC", "degC", "K"});
        wire(port, sensor + ".port");
        wire(sensor + ".T", out);
    }
    void imposed(const std::string& port, const List& sources, const List& names, const List& columns, double x) {
        const auto source = part("Sources.PrescribedTemperature", sources, {}, x, 0);
        const auto in = signal(true, names, "K", -200, -100, columns, {"degC", "degC", "K"});
        wire(port, source + ".port");
        wire(in, source + ".T");
    }

    void probe();
    void pump();
    void gearedMotor();
    void throttle();
    void coolantHeater();
    void fan();

    Random& random_;
    Design d_;
};

// A: element with resistive heater in a gas stream.
inline void Builder::probe() {
    title("A heated probe", {"LambdaSensorHeating", "ProbeHeater", "NOxProbe", "GasSensorElement", "SootSensorHeater"},
          "Sensor element with electric heating in a gas stream");
    const double R = sized(2.7), alpha = sized(0.0027, 1.2), C = sized(0.9, 1.5), area = sized(2.5e-4, 1.15);
    const auto heater = part("ElectricThermal.BasicElectricThermal", {"heater", "coil", "meander", "filament"},
                             {{"R", R}, {"alpha", alpha}, {"T_ref", 293.15}}, -60, 0);
    const auto element = part("ThermalFluid.BasicThermalFluid", {"element", "ceramic", "tip", "body"},
                              {{"C", C}, {"c_o", sized(1.1)}, {"A", area}}, 0, 0);
    wire(heater + ".heatPort", element + ".solid");
    d_.temperatures.push_back(element + ".T_start");
    if (random_.chance(0.2)) {  // a holder of known mass on the element
        const auto holder =
            part("Thermal.HeatCapacitor", {"holder", "sheath", "socket"}, {{"C", rounded(0.4 * C, 2)}}, 0, 60);
        wire(element + ".solid", holder + ".port");
        d_.temperatures.push_back(holder + ".T_start");
    }
    voltage(heater, {"ctrl_var", "u_heat", "v_heater", "u_coil"}, {"heater_voltage", "U_H", "u_heater"},
            random_.uniform(11.0, 12.6), -110, 0, true);
    imposed(element + ".fluid", {"exhaust", "gas", "flue"}, {"T_amb", "T_gas", "T_stream"},
            {"T_exhaust", "T_gas_in", "T_pipe"}, 90);
    currentOut(heater, {"i_mod", "i_heat", "i_coil"}, {"current", "i_heater", "I_H"});
    if (random_.chance(0.5))
        temperatureOut(element + ".solid", {"T_tip", "T_el", "T_meas"}, {"T_element", "T_ceramic", "T_sensor"}, 60,
                       -60);
    fit(heater + ".R", 0.1, 50);
    fit(heater + ".alpha", 1e-4, 0.03, false);
    fit(element + ".C", 0.01, 50);
    fit(element + ".c_o", 0.01, 100);
    d_.flow = {random_.pick(List{"v_exhaust", "v_gas", "flow_speed"}), random_.pick(List{"m/s", "m/s", "km/h"})};
    d_.pressure = true;
    d_.dt = 0.05;
    d_.duration = random_.pick(std::vector<double>{120, 140, 160});
    d_.pace = 8.0;
    d_.gasLow = 440, d_.gasHigh = 900, d_.gasPace = random_.uniform(12.0, 45.0);
}

// B: pump, the driven wheel elastic or rigid on the motor.
inline void Builder::pump() {
    title("B electric pump", {"CirculationPump", "WaterPump", "CoolantPump", "OilPump", "FuelPump"},
          "Electric pump: motor, shaft, impeller");
    const double L = random_.chance(0.2) ? 0.0 : sized(3.5e-4), J = sized(3e-5), quadratic = sized(9e-7, 1.25);
    const auto motor = part("ElectricMechanical.BasicElectricMechanical", {"drive", "motor", "bldc", "machine"},
                            {{"R", sized(0.3)}, {"L", L}, {"k", sized(0.0248, 1.15)}}, -80, 0);
    std::string shaft, inertia;
    const int wiring = random_.integer(0, 2);
    if (wiring == 2) {
        const auto rotor = part("Mechanics.Inertia", {"rotor", "shaft", "core"}, {{"J", J}}, -20, 0);
        const auto wheel =
            part("Mechanics.Inertia", {"impeller", "wheel", "vane"}, {{"J", rounded(0.4 * J, 3)}}, 40, 0);
        wire(motor + ".flange", rotor + ".flange_a");
        wire(rotor + ".flange_b", wheel + ".flange_a");
        shaft = wheel + ".flange_b", inertia = rotor + ".J";
    } else {
        const double J2 = wiring == 0 ? 0.0 : rounded(0.4 * J, 3);
        const auto armature = part("Mechanics.BasicMechanics", {"armature", "shaft", "coupling"},
                                   {{"r", 1}, {"J1", J}, {"J2", J2}, {"c", sized(60)}, {"d", sized(0.03)}}, -20, 0);
        wire(motor + ".flange", armature + ".flange_a");
        shaft = armature + ".flange_b", inertia = armature + ".J1";
    }
    const auto load =
        part("Mechanics.QuadraticLoad", {"hydraulics", "load", "volute", "water"}, {{"k_q", quadratic}}, 100, 0);
    wire(shaft, load + ".flange");
    voltage(motor, {"v_cmd", "u_mean", "u_drv", "v_pump"}, {"U_M", "u_motor", "U_drive"}, random_.uniform(11.8, 12.8),
            -130, 0, false);
    currentOut(motor, {"i", "i_dc", "i_mot"}, {"i_motor", "I_M", "I_dc"});
    speedOut(shaft, {"w", "w_pump", "n_pump"}, {"omega", "n_pump", "speed"}, {"rpm", "rpm", "rad/s"}, 100);
    fit(motor + ".R", 0.01, 10);
    fit(motor + ".k", 0.001, 0.5);
    fit(inertia, 1e-6, 1e-3);
    fit(load + ".k_q", 1e-8, 1e-4);
    d_.battery = true;
    d_.dt = 0.005;
    d_.duration = random_.pick(std::vector<double>{12, 15, 18});
    d_.pace = 0.6;
    d_.edge = 2;
}

// C: motor with reducing gear and a driven part that moves both ways.
inline void Builder::gearedMotor() {
    title("C geared motor", {"WiperDrive", "WindowLift", "SeatAdjuster", "SunroofDrive", "TailgateDrive"},
          "Geared motor with a driven part");
    const double ratio = rounded(random_.uniform(36, 56), 3), L = random_.chance(0.2) ? 0.0 : sized(6.8e-4, 1.2);
    const double J2 = sized(0.0042, 1.3), J = sized(0.0242, 1.15);
    const auto motor = part("ElectricMechanical.BasicElectricMechanical", {"mot", "dc_motor", "motor", "drive"},
                            {{"R", sized(0.56, 1.2)}, {"L", L}, {"k", sized(0.0255, 1.2)}}, -80, 0);
    const bool lumped = random_.chance(0.3);
    const auto gear = part("Mechanics.BasicMechanics", {"worm", "gearbox", "gear", "reducer"},
                           {{"r", ratio},
                            {"J1", sized(2.2e-5)},
                            {"J2", lumped ? rounded(J + J2, 3) : J2},
                            {"c", sized(180, 1.2)},
                            {"d", sized(1.7, 1.15)}},
                           -20, 0);
    std::string shaft = gear + ".flange_b";
    wire(motor + ".flange", gear + ".flange_a");
    if (!lumped) {
        const auto arm = part("Mechanics.Inertia", {"spindle", "arm", "drum", "lever"}, {{"J", J}}, 40, 0);
        wire(gear + ".flange_b", arm + ".flange_a");
        shaft = arm + ".flange_b";
    }
    const auto load = part("Mechanics.ViscousLoad", {"rail", "wiper", "window", "guide"},
                           {{"b", rounded(random_.logUniform(0.26, 1.0), 3)}}, 100, 0);
    wire(shaft, load + ".flange");
    voltage(motor, {"v_in", "u", "u_motor", "v_arm"}, {"u_motor", "U_M", "u_mean"}, random_.uniform(11.5, 13.0), -130,
            0, false);
    currentOut(motor, {"i_in", "i", "i_arm"}, {"i_motor", "I_M", "I_arm"});
    speedOut(shaft, {"w_out", "w2", "w_drum"}, {"w_out", "omega_out", "n_out"}, {"rad/s", "rad/s", "rpm"}, 100);
    fit(motor + ".R", 0.05, 50);
    fit(motor + ".k", 0.002, 0.5);
    fit(gear + ".J1", 1e-7, 1e-3);
    fit(load + ".b", 1e-3, 50);
    d_.battery = d_.oil = true;
    const auto [dt, duration] =
        random_.pick(std::vector<std::pair<double, double>>{{0.005, 14}, {0.01, 20}, {0.01, 24}, {0.02, 48}});
    d_.dt = dt, d_.duration = duration;
    d_.pace = 1.3;
    d_.edge = static_cast<int>(std::lround(random_.uniform(0.04, 0.2) / dt));
    d_.bipolar = true;
}

// D: actuator against a return spring.
inline void Builder::throttle() {
    title("D throttle", {"ThrottleActuator", "ExhaustFlap", "SwirlFlap", "EgrValve", "IntakeFlap"},
          "Actuator with gear and return spring");
    const double ratio = rounded(random_.uniform(15, 23), 3), L = random_.chance(0.15) ? 0.0 : sized(2e-3, 1.25);
    const double R = sized(2.3, 1.2), k = sized(0.022, 1.15), spring = sized(0.51, 1.15), J2 = sized(5.5e-5, 1.2),
                 J = sized(1.2e-4, 1.2);
    const auto motor = part("ElectricMechanical.BasicElectricMechanical", {"drive", "motor", "actuator", "dc"},
                            {{"R", R}, {"L", L}, {"k", k}}, -80, 0);
    const int wiring = random_.integer(0, 3);  // 0: all inertia in the gear, 1: none of it, else both
    const double own = wiring == 0 ? rounded(J + J2, 3) : wiring == 1 ? 0.0 : J2;
    const auto gear =
        part("Mechanics.BasicMechanics", {"train", "gear", "gearing", "reduction"},
             {{"r", ratio}, {"J1", sized(4.2e-6, 1.25)}, {"J2", own}, {"c", sized(41, 1.2)}, {"d", sized(0.12, 1.15)}},
             -20, 0);
    wire(motor + ".flange", gear + ".flange_a");
    std::string shaft = gear + ".flange_b";
    if (wiring != 0) {
        const auto plate = part("Mechanics.Inertia", {"plate", "flap", "disc", "blade"}, {{"J", J}}, 40, 0);
        wire(gear + ".flange_b", plate + ".flange_a");
        shaft = plate + ".flange_b";
    }
    const auto load =
        part("Mechanics.ReturnSpring", {"spring", "return_spring", "torsion"}, {{"c_r", spring}, {"phi_r", 0}}, 100, 0);
    wire(shaft, load + ".flange");
    // 60 to 75 degrees at the largest voltage.
    voltage(motor, {"v_drive", "u_pwm", "u_act", "v_bridge"}, {"u_mean", "u_bridge", "U_act"},
            rounded(random_.uniform(1.05, 1.3) * spring * R / (ratio * k), 3), -130, 0, false);
    const auto sensor = part("Sensors.AngleSensor", {"pot", "angle", "position"}, {}, 100, -40);
    const auto out = signal(false, {"phi_flap", "phi_plate", "phi_out"}, "rad", 200, -40,
                            {"angle", "phi_meas", "position"}, {"deg", "rad", "deg"});
    wire(shaft, sensor + ".flange");
    wire(sensor + ".phi", out);
    currentOut(motor, {"i_drive", "i_mot", "i_act"}, {"I_M", "i_motor", "I_act"});
    fit(motor + ".R", 0.05, 50);
    fit(motor + ".k", 0.002, 0.5);
    fit(gear + ".J1", 1e-7, 1e-3);
    fit(load + ".c_r", 0.01, 20);
    d_.battery = true;
    d_.dt = 0.002;
    d_.duration = random_.pick(std::vector<double>{6, 7, 8});
    d_.pace = 0.35;
    d_.edge = random_.integer(1, 5);
    d_.chirps = true;
}

// E: electric heater whose housing gives its heat to the coolant.
inline void Builder::coolantHeater() {
    title("E coolant heater", {"CoolantHeater", "AuxHeater", "HvHeater", "CabinHeater", "BatteryHeater"},
          "High-voltage coolant heater: element, bond, housing in the coolant");
    const auto grid = part("ElectricThermal.BasicElectricThermal", {"grid", "ptc", "element", "track"},
                           {{"R", sized(30, 1.2)}, {"alpha", sized(0.0031, 1.2)}, {"T_ref", 293.15}}, -80, 0);
    const auto core =
        part("Thermal.HeatCapacitor", {"core", "fins", "mass", "plate"}, {{"C", sized(190, 1.25)}}, -40, 40);
    const auto bond =
        part("Thermal.ThermalConductor", {"bond", "wall", "paste", "interface"}, {{"G", sized(42, 1.2)}}, 0, 0);
    const auto housing = part("ThermalFluid.BasicThermalFluid", {"housing", "shell", "jacket"},
                              {{"C", sized(420, 1.25)}, {"c_o", sized(37, 1.2)}, {"A", sized(0.06, 1.1)}}, 50, 0);
    wire(grid + ".heatPort", core + ".port");
    wire(core + ".port", bond + ".port_a");
    wire(bond + ".port_b", housing + ".solid");
    d_.temperatures = {core + ".T_start", housing + ".T_start"};
    voltage(grid, {"u_hv", "u_supply", "v_dc"}, {"u_hv", "U_DC", "U_heater"}, random_.uniform(340, 380), -130, 0,
            false);
    imposed(housing + ".fluid", {"coolant", "water", "glycol"}, {"T_cool", "T_water", "T_fluid"},
            {"T_coolant", "T_inlet", "T_water"}, 110);
    temperatureOut(housing + ".solid", {"T_out", "T_shell", "T_house"}, {"T_housing", "T_case", "T_surface"}, 80, -40);
    currentOut(grid, {"i_hv", "i_supply", "i_dc"}, {"i_hv", "I_DC", "I_heater"});
    if (random_.chance(0.25)) temperatureOut(core + ".port", {"T_core", "T_fin"}, {"T_element", "T_core"}, 80, -80);
    fit(grid + ".R", 1, 500);
    fit(grid + ".alpha", 1e-5, 0.03, false);
    fit(core + ".C", 2, 5000);
    fit(bond + ".G", 0.5, 2000);
    fit(housing + ".C", 4, 10000);
    fit(housing + ".c_o", 0.3, 2000);
    d_.flow = {random_.pick(List{"flow_coolant", "q_coolant"}), "l/min"};
    d_.pressure = true;
    d_.dt = 0.05;
    d_.duration = random_.pick(std::vector<double>{120, 140, 160});
    d_.pace = 8.0;
    d_.gasLow = 275, d_.gasHigh = 333, d_.gasPace = random_.uniform(12.0, 45.0);
}

// F: fan motor that measures its winding temperature.
inline void Builder::fan() {
    title("F motor with winding temperature", {"FanMotor", "BlowerMotor", "CoolingFan", "RadiatorFan", "HvacBlower"},
          "Fan motor with the temperature of its winding");
    const double R = sized(0.37, 1.2), J = sized(6.3e-4, 1.2), L = random_.chance(0.8) ? 0.0 : sized(4e-3, 1.2);
    const auto motor = part("ElectricMechanical.BasicElectricMechanical", {"machine", "motor", "drive", "dc_machine"},
                            {{"R", R}, {"L", L}, {"k", sized(0.040, 1.12)}}, -120, 40);
    std::string shaft = motor + ".flange", bearing, inertia;
    if (random_.chance(0.7)) {
        bearing = part("MechanicThermal.BasicMechanicThermal", {"bush", "bearing", "sleeve"},
                       {{"b", sized(1.9e-5, 1.3)}}, -60, 40);
        wire(shaft, bearing + ".flange_a");
        shaft = bearing + ".flange_b";
    }
    const auto rotor = part("Mechanics.Inertia", {"hub", "rotor", "armature"}, {{"J", J}}, 0, 40);
    wire(shaft, rotor + ".flange_a");
    shaft = rotor + ".flange_b", inertia = rotor + ".J";
    if (random_.chance(0.25)) {
        const auto blades = part("Mechanics.Inertia", {"blades", "disk", "ring"}, {{"J", rounded(0.5 * J, 3)}}, 40, 40);
        wire(shaft, blades + ".flange_a");
        shaft = blades + ".flange_b";
    }
    const auto load =
        part("Mechanics.QuadraticLoad", {"wheel", "fan", "air_load"}, {{"k_q", sized(7.5e-6, 1.25)}}, 80, 40);
    wire(shaft, load + ".flange");
    voltage(motor, {"u_sup", "v_mot", "u_fan"}, {"U_M", "u_motor", "U_fan"}, random_.uniform(11.6, 12.8), -160, 40,
            false);
    const auto square = part("Signals.Product", {"i2", "square", "sq"}, {}, -120, -30);
    const auto copper = part("Signals.Gain", {"r_cu", "copper", "loss_gain"}, {{"k", R}}, -80, -30);
    const auto joule = part("Sources.PrescribedHeatFlow", {"joule", "loss", "heat"}, {}, -40, -30);
    const auto winding =
        part("Thermal.HeatCapacitor", {"coil", "winding", "copper_mass"}, {{"C", sized(19.6, 1.3)}}, 10, -30);
    const auto wall = part("Thermal.ThermalConductor", {"stack", "wall", "path"}, {{"G", sized(0.65, 1.25)}}, 60, -30);
    wire(motor + ".i", square + ".u1");
    wire(motor + ".i", square + ".u2");
    wire(square + ".y", copper + ".u");
    wire(copper + ".y", joule + ".Q_flow");
    wire(joule + ".port", winding + ".port");
    if (!bearing.empty()) wire(bearing + ".heatPort", winding + ".port");
    wire(winding + ".port", wall + ".port_a");
    d_.temperatures = {winding + ".T_start"};
    imposed(wall + ".port_b", {"air", "ambient", "surroundings"}, {"T_air", "T_amb", "T_env"},
            {"T_ambient", "T_air_in", "T_env"}, 120);
    currentOut(motor, {"i_sup", "i_mot", "i_fan"}, {"i_motor", "I_M", "I_fan"});
    speedOut(shaft, {"w_hub", "w_fan", "w_rot"}, {"omega", "speed", "n_fan"}, {"rad/s", "rpm", "rpm"}, 100);
    temperatureOut(winding + ".port", {"T_coil", "T_winding", "T_cu"}, {"T_wdg", "T_copper", "T_winding"}, 60, -80);
    fit(motor + ".R", 0.02, 10);
    fit(motor + ".k", 0.002, 0.5);
    fit(inertia, 1e-5, 0.1);
    fit(load + ".k_q", 1e-8, 1e-3);
    fit(winding + ".C", 0.5, 500);
    fit(wall + ".G", 0.01, 50);
    d_.battery = d_.pressure = true;
    d_.dt = 0.05;
    d_.duration = random_.pick(std::vector<double>{130, 150, 170});
    d_.pace = 7.0;
    d_.gasLow = 288, d_.gasHigh = 304, d_.gasPace = random_.uniform(25.0, 80.0);
}

}  // namespace bench
