#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "model.hpp"

/// The physics of a model, as numbers: what the simulator integrates. Effects are numbers here too; at 0 they are off.
/// Signs: a load's torque acts against the shaft.
namespace bench {

/// A rigid piece of shaft. Neighbouring pieces are joined by a Joint.
struct Piece {
    double inertia{};                        // [kg.m2]
    double viscous{}, quadratic{}, cubic{};  // [N.m.s/rad], [N.m.s2/rad2], [N.m.s3/rad3]
    double spring{}, springRest{};           // [N.m/rad], [rad]
    double constant{};                       // [N.m]
    double gravity{}, gravityPhase{};        // tau*sin(phi - phase)
    double cogging{}, coggingPhase{};        // tau*sin(n*(phi - phase))
    int coggingCount{1};
    double sawtooth{};  // once a turn, -tau .. tau, linear in the angle
    double coulomb{}, stribeck{}, stribeckSpeed{1.0};
    double hysteresis{}, hysteresisTravel{1.0};  // Dahl: dF/dphi = F_max/travel*(1 - F/F_max*sign(w))
    double stop{};                               // upper end stop [rad]; 0: none
    double hardening{};                          // [N.m/rad3], cubed travel from the spring's rest
    double rub{}, rubFrom{}, rubTo{};            // dry friction [N.m] between two angles alone
    double periodic{}, period{1.0};              // tau*sin(2*pi*t/period)
    double disturbance{};                        // factor on the experiment's disturbance series
    std::string connector;                       // one connector that belongs to it
};

/// Between piece k and piece k + 1. Rigid, or spring and damper behind a gear, perhaps with play.
struct Joint {
    bool rigid{true};
    double ratio{1.0}, stiffness{}, damping{};  // [-], [N.m/rad], [N.m.s/rad], on the side of piece k + 1
    double play{};                              // whole width [rad]
    std::string left, right;                    // the two connectors wired here; empty inside a part
};

struct Node {
    double capacity{}, start{293.15};  // [J/K], [K]
    double lossG{}, lossT{293.15};
    double radiation{}, radiationT{293.15};  // k_r*(T^4 - T_amb^4)
    double secondCapacity{}, secondG{};
    double latentHeat{}, latentT{}, latentWidth{1.0};
    double periodic{}, period{1.0};
    double event{}, eventFrom{}, eventTo{};  // heat [W] for a while
    double valveG{}, valveT{};               // a conductance that opens above a temperature: G*max(0, T - T_open)
    double disturbance{};
    std::vector<std::string> connectors;
};

/// Heat flow from a node to another one or to an imposed temperature.
struct Link {
    int from{};
    int to{-1};  // a node; -1: the input `input`, and if that is -1 too the temperature `imposed`
    int input{-1};
    double imposed{293.15};
    bool convective{};                    // conductance G = c_o*A*(T_to/3.6)^0.78, else G
    double conductance{};                 // G or c_o*A
    double exponent{}, exponentRef{1.0};  // times (|dT|/ref)^n
    double flowExponent{}, flowRef{1.0};  // times (flow/ref)^n
    double resistance{};                  // [K/W] in series
    std::string component;
    std::string left, right;  // the connectors wired at its far end
};

enum class Drive { None, Motor, Heater };

struct Machine {
    Drive drive{Drive::None};
    std::string name;
    double R{}, L{}, k{};
    double voltageGain{1.0};
    int voltageInput{};
    double drop{};  // brushes [V]
    double inverseSatCurrent{};
    double currentLimit{};  // the driver lets no more through [A]; 0: none
    double seriesR{};
    double alpha{}, alphaRef{293.15};
    double portResistance{};  // [K/W] between heater and node
    int node{-1};             // takes the heater's heat, or warms the motor's winding
    double jouleGain{};       // heat = jouleGain*i^2 into jouleNode
    int jouleNode{-1};
    double windingAlpha{};          // of the motor's resistance
    double windingC{}, windingG{};  // hidden winding; C = 0: the node's temperature is the winding's
    double fluxSlope{};             // k*(1 - slope*rise)
};

struct Bearing {
    int piece{-1}, node{-1};
    double b{};
};

struct Actuator {
    double lag{}, delay{}, offset{}, gain{1.0}, deadZone{}, limit{};  // limit 0: none
};

enum class Quantity { Current, Speed, Angle, Temperature };

struct Sensor {
    Quantity quantity{};
    int index{};
    double lag{}, delay{}, offset{}, gain{1.0}, drift{}, limit{};  // limit: reading stops there; 0: none
};

/// A parameter that changes once, during the run (not known to any library).
struct Jump {
    double time{-1.0}, factor{1.0};
    std::string what;  // R, k, load, G
};

struct Plant {
    std::vector<Piece> pieces;
    std::vector<Joint> joints;
    std::vector<Node> nodes;
    std::vector<Link> links;
    Machine machine;
    Bearing bearing;
    std::vector<Actuator> actuators;  // one an input
    std::vector<Sensor> sensors;      // one an output
    Jump jump;
};

// ---------------------------------------------------------------- from a model

class Assembler {
public:
    explicit Assembler(const Model& model) : model_(model), heat_(model, false) {}

    Plant plant() {
        plant_.actuators.resize(model_.names(true).size());
        thermal();
        electric();
        if (plant_.machine.drive == Drive::Motor) {
            plant_.pieces.push_back({});
            plant_.pieces[0].connector = plant_.machine.name + ".flange";
            walk(plant_.pieces[0].connector, 0);
        }
        sensors();
        return plant_;
    }

private:
    std::vector<std::string> wiredTo(const std::string& end) const {
        std::vector<std::string> out;
        for (const auto& w : model_.wires) {
            if (w.from == end) out.push_back(w.to);
            if (w.to == end) out.push_back(w.from);
        }
        return out;
    }
    int inputIndex(const std::string& name) const {
        const auto inputs = model_.names(true);
        const auto at = std::find(inputs.begin(), inputs.end(), name);
        return at == inputs.end() ? -1 : static_cast<int>(at - inputs.begin());
    }

    void thermal() {
        for (const auto& p : model_.parts) {
            const bool capacitor = p.type == "Thermal.HeatCapacitor",
                       convection = p.type == "ThermalFluid.BasicThermalFluid";
            if (!capacitor && !convection) continue;
            Node& n = plant_.nodes[static_cast<std::size_t>(nodeOf(p.name + (capacitor ? ".port" : ".solid"), true))];
            n.capacity += p.value("C", 0.0);
            n.start = p.value("T_start", 293.15);
        }
        for (const auto& p : model_.parts) {
            if (p.type == "Thermal.ThermalConductor") addLink(p, ".port_a", ".port_b", p.value("G", 0.0), false);
            if (p.type == "ThermalFluid.BasicThermalFluid")
                addLink(p, ".solid", ".fluid", p.value("c_o", 0.0) * p.value("A", 0.0), true);
            if (p.type == "Sources.PrescribedHeatFlow") {
                plant_.machine.jouleNode = nodeOf(p.name + ".port", false);
                for (const auto& end : wiredTo(p.name + ".Q_flow"))
                    plant_.machine.jouleGain = model_.part(instanceOf(end))->value("k", 1.0);
            }
        }
    }
    int nodeOf(const std::string& connector, bool create) {
        for (std::size_t k = 0; k < plant_.nodes.size(); ++k)
            if (heat_.same(plant_.nodes[k].connectors.front(), connector)) return static_cast<int>(k);
        if (!create) return -1;
        plant_.nodes.push_back({});
        plant_.nodes.back().connectors = heat_.members(connector);
        return static_cast<int>(plant_.nodes.size()) - 1;
    }
    void addLink(const Part& p, const char* from, const char* to, double conductance, bool convective) {
        Link l;
        l.component = p.name;
        l.conductance = conductance;
        l.convective = convective;
        l.from = nodeOf(p.name + from, false);
        l.to = nodeOf(p.name + to, false);
        if (l.from < 0) throw std::runtime_error(p.name + " starts at no heat capacity");
        const auto far = wiredTo(p.name + to);
        if (far.size() == 1) l.left = p.name + to, l.right = far.front();
        if (l.to < 0)
            for (const auto& end : far) {
                const Part* source = model_.part(instanceOf(end));
                if (source && source->type == "Sources.FixedTemperature") l.imposed = source->value("T", 293.15);
                if (source && source->type == "Sources.PrescribedTemperature")
                    for (const auto& in : wiredTo(source->name + ".T")) l.input = inputIndex(in);
            }
        plant_.links.push_back(l);
    }

    void electric() {
        for (const auto& p : model_.parts) {
            const bool motor = p.type == "ElectricMechanical.BasicElectricMechanical";
            if (!motor && p.type != "ElectricThermal.BasicElectricThermal") continue;
            Machine& m = plant_.machine;
            m.drive = motor ? Drive::Motor : Drive::Heater;
            m.name = p.name;
            m.R = p.value("R", 1.0);
            m.L = p.value("L", 0.0);
            m.k = p.value("k", 0.0);
            m.alpha = p.value("alpha", 0.0);
            m.alphaRef = p.value("T_ref", 293.15);
            m.node = motor ? m.jouleNode : nodeOf(p.name + ".heatPort", false);
            for (const auto& end : wiredTo(p.name + ".v")) {
                m.voltageInput = inputIndex(end);
                if (m.voltageInput >= 0) continue;
                const Part* gain = model_.part(instanceOf(end));
                m.voltageGain = gain->value("k", 1.0);
                for (const auto& in : wiredTo(gain->name + ".u")) m.voltageInput = inputIndex(in);
            }
        }
    }

    /// Follows the shaft from `connector` of piece `piece`, away from the motor.
    void walk(const std::string& connector, int piece) {
        for (const auto& end : wiredTo(connector)) {
            const Part& p = *model_.part(instanceOf(end));
            Piece& here = plant_.pieces[static_cast<std::size_t>(piece)];
            if (p.type == "Mechanics.Inertia") {
                walk(p.name + ".flange_b", addPiece(p.value("J", 0.0), end, wired(connector, end)));
            } else if (p.type == "Mechanics.BasicMechanics") {
                addPiece(p.value("J1", 0.0), end, wired(connector, end));
                Joint gear;
                gear.rigid = false;
                gear.ratio = p.value("r", 1.0), gear.stiffness = p.value("c", 0.0), gear.damping = p.value("d", 0.0);
                walk(p.name + ".flange_b", addPiece(p.value("J2", 0.0), p.name + ".flange_b", gear));
            } else if (p.type == "MechanicThermal.BasicMechanicThermal") {
                here.viscous += p.value("b", 0.0);
                plant_.bearing = {piece, nodeOf(p.name + ".heatPort", false), p.value("b", 0.0)};
                walk(p.name + ".flange_b", piece);
            } else if (p.type == "Mechanics.QuadraticLoad") {
                here.quadratic += p.value("k_q", 0.0);
            } else if (p.type == "Mechanics.ViscousLoad") {
                here.viscous += p.value("b", 0.0);
            } else if (p.type == "Mechanics.ReturnSpring") {
                here.spring += p.value("c_r", 0.0);
                here.springRest = p.value("phi_r", 0.0);
            } else {
                sensorPiece_[p.name] = piece;
            }
        }
    }
    static Joint wired(const std::string& left, const std::string& right) {
        Joint j;
        j.left = left, j.right = right;
        return j;
    }
    int addPiece(double inertia, const std::string& connector, const Joint& joint) {
        Piece p;
        p.inertia = inertia;
        p.connector = connector;
        plant_.pieces.push_back(p);
        plant_.joints.push_back(joint);
        return static_cast<int>(plant_.pieces.size()) - 1;
    }

    void sensors() {
        for (const auto& name : model_.names(false)) {
            const std::string from = wiredTo(name).front();
            const Part& p = *model_.part(instanceOf(from));
            Sensor s;
            if (p.type == "Sensors.SpeedSensor" || p.type == "Sensors.AngleSensor") {
                s.quantity = p.type == "Sensors.SpeedSensor" ? Quantity::Speed : Quantity::Angle;
                s.index = sensorPiece_.at(p.name);
            } else if (p.type == "Sensors.TemperatureSensor") {
                s.quantity = Quantity::Temperature;
                s.index = nodeOf(p.name + ".port", false);
            }
            plant_.sensors.push_back(s);
        }
    }

    const Model& model_;
    Groups heat_;
    Plant plant_;
    std::map<std::string, int> sensorPiece_;
};

inline Plant assemble(const Model& model) { return Assembler(model).plant(); }

}  // namespace bench
