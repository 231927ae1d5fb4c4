#pragma once

#include <algorithm>
#include <cstdio>
#include <map>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// The composed model of a study: parts, wires, top-level signals. Only the flat form that the generator itself writes
/// (one component or one connect a line) is read back.
namespace bench {

using Values = std::map<std::string, double>;

struct Part {
    std::string type;  // without the leading "Analogon."
    std::string name;
    std::vector<std::pair<std::string, double>> values;
    double x{}, y{};  // of its centre in the diagram

    double value(const std::string& key, double otherwise) const {
        for (const auto& [name_, v] : values)
            if (name_ == key) return v;
        return otherwise;
    }
};

struct Signal {
    std::string name, unit;
    bool input{};
    double x{}, y{};
};

struct Wire {
    std::string from, to;  // INSTANCE.CONNECTOR, or a top-level signal's name
};

struct Model {
    std::string name, comment;
    std::vector<Signal> signals;
    std::vector<Part> parts;
    std::vector<Wire> wires;

    const Part* part(const std::string& instance) const {
        for (const auto& p : parts)
            if (p.name == instance) return &p;
        return nullptr;
    }
    const Part* ofType(const std::string& type) const {
        for (const auto& p : parts)
            if (p.type == type) return &p;
        return nullptr;
    }
    std::vector<std::string> names(bool input) const {
        std::vector<std::string> out;
        for (const auto& s : signals)
            if (s.input == input) out.push_back(s.name);
        return out;
    }
    /// Sets "instance.parameter".
    void set(const std::string& path, double v) {
        const auto dot = path.find('.');
        for (auto& p : parts) {
            if (p.name != path.substr(0, dot)) continue;
            for (auto& [key, old] : p.values)
                if (key == path.substr(dot + 1)) {
                    old = v;
                    return;
                }
            p.values.emplace_back(path.substr(dot + 1), v);
            return;
        }
        throw std::runtime_error("no component for " + path);
    }
};

inline std::string instanceOf(const std::string& connector) { return connector.substr(0, connector.find('.')); }
inline std::string connectorOf(const std::string& connector) {
    const auto dot = connector.find('.');
    return dot == std::string::npos ? std::string{} : connector.substr(dot + 1);
}

/// Groups of connectors: joined by wires and, if asked, through parts that are one rigid shaft.
class Groups {
public:
    Groups(const Model& model, bool throughRigidParts) {
        for (const auto& w : model.wires) join(w.from, w.to);
        if (!throughRigidParts) return;
        for (const auto& p : model.parts)
            if (p.type == "Mechanics.Inertia" || p.type == "MechanicThermal.BasicMechanicThermal")
                join(p.name + ".flange_a", p.name + ".flange_b");
    }
    bool same(const std::string& a, const std::string& b) { return root(a) == root(b); }
    /// All physical connectors of a group, sorted.
    std::vector<std::string> members(const std::string& of) {
        std::vector<std::string> out;
        const int r = root(of);
        for (const auto& [name, index] : index_)
            if (find(index) == r && name.find('.') != std::string::npos) out.push_back(name);
        return out;
    }

private:
    int root(const std::string& name) {
        const auto [it, isNew] = index_.try_emplace(name, static_cast<int>(parent_.size()));
        if (isNew) parent_.push_back(it->second);
        return find(it->second);
    }
    int find(int k) {
        while (parent_[static_cast<std::size_t>(k)] != k) k = parent_[static_cast<std::size_t>(k)];
        return k;
    }
    void join(const std::string& a, const std::string& b) { parent_[static_cast<std::size_t>(root(a))] = root(b); }

    std::map<std::string, int> index_;
    std::vector<int> parent_;
};

inline std::string shortNumber(double v, int digits = 6) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, v);
    return buffer;
}

// ---------------------------------------------------------------- reading

inline Model readModel(const std::string& text) {
    Model m;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        const auto start = line.find_first_not_of(" \t");
        if (start == std::string::npos) continue;
        line.erase(0, start);
        if (line.starts_with("model ")) {
            m.name = line.substr(6, line.find_first_of(" \"", 6) - 6);
        } else if (line.starts_with("connect(")) {
            const auto comma = line.find(','), end = line.find(')');
            m.wires.push_back({line.substr(8, comma - 8), line.substr(comma + 2, end - comma - 2)});
        } else if (line.starts_with("Analogon.")) {
            line = line.substr(9, line.find(" annotation") - 9);
            const auto space = line.find(' ');
            auto open = line.find('(', space);
            const std::string type = line.substr(0, space);
            const std::string name = line.substr(space + 1, std::min(open, line.size()) - space - 1);
            const std::string body = open == std::string::npos ? "" : line.substr(open + 1, line.rfind(')') - open - 1);
            if (type.starts_with("Interfaces.")) {
                const auto quote = body.find('"');
                m.signals.push_back(
                    {name, body.substr(quote + 1, body.rfind('"') - quote - 1), type.ends_with("Input")});
                continue;
            }
            Part p{type, name, {}};
            std::istringstream items(body);
            for (std::string item; std::getline(items, item, ',');) {
                const auto equal = item.find('=');
                const auto first = item.find_first_not_of(' ');
                p.values.emplace_back(item.substr(first, equal - first), std::stod(item.substr(equal + 1)));
            }
            m.parts.push_back(p);
        }
    }
    return m;
}

// ---------------------------------------------------------------- writing

inline std::string box(double x, double y) {
    return "annotation (Placement(transformation(extent={{" + shortNumber(x - 10) + "," + shortNumber(y - 10) + "},{" +
           shortNumber(x + 10) + "," + shortNumber(y + 10) + "}})))";
}

/// Where a connector sits on its part's square, and the colour of what it carries.
struct Pin {
    double x, y;
    const char* colour;
};

inline Pin pinOf(const Model& m, const std::string& end) {
    constexpr const char *signal = "0,0,127", *shaft = "95,95,95", *heat = "191,0,0";
    for (const auto& s : m.signals)
        if (s.name == end) return {s.x + (s.input ? 10 : -10), s.y, signal};
    const Part* p = m.part(instanceOf(end));
    if (!p) throw std::runtime_error("no component for " + end);
    const std::string c = connectorOf(end);
    const bool thermal = p->type.starts_with("Thermal.") || p->type.starts_with("ThermalFluid.");
    if (c == "flange_a") return {p->x - 10, p->y, shaft};
    if (c == "flange_b") return {p->x + 10, p->y, shaft};
    if (c == "flange") return {p->type.starts_with("ElectricMechanical.") ? p->x + 10 : p->x - 10, p->y, shaft};
    if (c == "port_a" || c == "solid") return {p->x - 10, p->y, heat};
    if (c == "port_b" || c == "fluid") return {p->x + 10, p->y, heat};
    if (c == "heatPort") return {p->x + (p->type.starts_with("Electric") ? 10 : 0), p->y, heat};
    if (c == "port")
        return {p->type == "Sources.PrescribedHeatFlow" ? p->x + 10 : p->x - 10, thermal ? p->y - 10 : p->y, heat};
    if (c == "i") return {p->x, p->y + 10, signal};
    if (c == "u1" || c == "u2") return {p->x - 10, p->y + (c == "u1" ? 6 : -6), signal};
    const bool in = c == "u" || c == "v" || (c == "T" && p->type.starts_with("Sources.")) || c == "Q_flow";
    return {p->x + (in ? -10 : 10), p->y, signal};
}

inline std::string writeModel(const Model& m) {
    std::ostringstream out;
    out << "model " << m.name << " \"" << m.comment << "\"\n";
    for (const auto& s : m.signals)
        out << "  Analogon.Interfaces." << (s.input ? "RealInput " : "RealOutput ") << s.name << "(unit=\"" << s.unit
            << "\") " << box(s.x, s.y) << ";\n";
    for (const auto& p : m.parts) {
        out << "  Analogon." << p.type << ' ' << p.name;
        for (std::size_t k = 0; k < p.values.size(); ++k)
            out << (k == 0 ? "(" : ", ") << p.values[k].first << '=' << shortNumber(p.values[k].second);
        out << (p.values.empty() ? " " : ") ") << box(p.x, p.y) << ";\n";
    }
    out << "equation\n";
    for (const auto& w : m.wires) {
        const Pin a = pinOf(m, w.from), b = pinOf(m, w.to);
        out << "  connect(" << w.from << ", " << w.to << ") annotation (Line(points={{" << shortNumber(a.x) << ','
            << shortNumber(a.y) << '}';
        if (a.y != b.y) {
            const double bend = 0.5 * (a.x + b.x);
            out << ",{" << shortNumber(bend) << ',' << shortNumber(a.y) << "},{" << shortNumber(bend) << ','
                << shortNumber(b.y) << '}';
        }
        out << ",{" << shortNumber(b.x) << ',' << shortNumber(b.y) << "}}, color={" << a.colour << "}));\n";
    }
    out << "  annotation (Diagram(coordinateSystem(extent={{-240,-140},{240,140}})));\nend " << m.name << ";\n";
    return out.str();
}

}  // namespace bench
