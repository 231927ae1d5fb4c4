#include "core/diagram/diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "core/diagram/annotation.hpp"

namespace analogon {

using syntax::ClassDefinition;
using syntax::Component;
using syntax::Equation;

namespace {

constexpr int deepestInheritance = 32;  // ends a cycle of extends, which the flat stage reports

bool isPredefined(std::string_view name) {
    return name == "Real" || name == "Integer" || name == "Boolean" || name == "String";
}

/// Calls `visit` for the class and its base classes, the bases first.
void visitBases(const Library& library, const LibraryClass* cls, const std::function<void(const LibraryClass&)>& visit,
                int depth = 0) {
    if (!cls || depth > deepestInheritance) return;
    const ClassDefinition& definition = *cls->definition;
    if (definition.isShort && !definition.isEnumeration)
        visitBases(library, library.lookup(definition.shortBase, cls->scope), visit, depth + 1);
    for (const syntax::Extends& base : definition.bases)
        visitBases(library, library.lookup(base.base, cls->qualifiedName), visit, depth + 1);
    visit(*cls);
}

Icon iconOf(const Library& library, const LibraryClass* cls, std::string_view layerName) {
    Icon icon;
    visitBases(library, cls, [&](const LibraryClass& one) {
        const auto layer = annotation::find(one.definition->annotation, layerName);
        if (!layer) return;
        if (const auto system = layer->record("coordinateSystem"))
            if (const auto extent = system->extent("extent")) icon.coordinates = *extent;
        const std::vector<Primitive> own = annotation::primitives(*layer);
        icon.primitives.insert(icon.primitives.end(), own.begin(), own.end());
    });
    return icon;
}

bool isConnectorClass(const Library& library, const LibraryClass* cls) {
    bool is = false;
    visitBases(library, cls, [&](const LibraryClass& one) {
        is = is || one.definition->restriction == ClassDefinition::Restriction::Connector;
    });
    return is;
}

bool hasEffectAnnotation(const LibraryClass& cls) {
    const auto vendor = annotation::find(cls.definition->annotation, "__Analogon");
    return vendor && vendor->record("effect");
}

/// Text of an end of a connect equation, without blanks: "a[1].b".
std::string connectorText(const syntax::Expression& end) {
    std::string text(end.span.text());
    std::erase_if(text, [](unsigned char c) { return std::isspace(c); });
    return text;
}

double rounded(double x) {
    const double r = std::round(x * 1e4) / 1e4;
    return r == 0 ? 0 : r;  // no "-0"
}

std::string text(Point p) { return fmt::format("{{{},{}}}", rounded(p.x), rounded(p.y)); }

Point centre(const Extent& e) { return {(e.p1.x + e.p2.x) / 2, (e.p1.y + e.p2.y) / 2}; }

Point rotated(Point p, double degrees) {
    if (degrees == 0) return p;
    const double a = degrees * std::numbers::pi / 180;
    return {p.x * std::cos(a) - p.y * std::sin(a), p.x * std::sin(a) + p.y * std::cos(a)};
}

Point axis(Point p) {
    if (p.x == 0 && p.y == 0) return p;
    if (std::abs(p.x) >= std::abs(p.y)) return {p.x < 0 ? -1.0 : 1.0, 0};
    return {0, p.y < 0 ? -1.0 : 1.0};
}

/// Which side of an icon a port sits on, as a direction in the icon's coordinates.
Point side(const Port& port, const Extent& coordinates) {
    const Point at = map(port.placement, port.icon.coordinates, centre(port.icon.coordinates));
    const Point middle = centre(coordinates);
    const double width = std::max(1e-9, std::abs(coordinates.p2.x - coordinates.p1.x) / 2);
    const double height = std::max(1e-9, std::abs(coordinates.p2.y - coordinates.p1.y) / 2);
    return axis({(at.x - middle.x) / width, (at.y - middle.y) / height});
}

}  // namespace

Point map(const Placement& placement, const Extent& coordinates, Point p) {
    const auto along = [](double v, double a, double b, double toA, double toB) {
        return b == a ? (toA + toB) / 2 : toA + (v - a) / (b - a) * (toB - toA);
    };
    const Extent& e = placement.extent;
    const Point inExtent{along(p.x, coordinates.p1.x, coordinates.p2.x, e.p1.x, e.p2.x),
                         along(p.y, coordinates.p1.y, coordinates.p2.y, e.p1.y, e.p2.y)};
    const Point turned = rotated(inExtent, placement.rotation);
    return {turned.x + placement.origin.x, turned.y + placement.origin.y};
}

Colour domainColour(Domain domain) {
    switch (domain) {
        case Domain::Rotational:
            return {95, 95, 95};
        case Domain::Translational:
            return {0, 127, 0};
        case Domain::Electrical:
            return {0, 0, 255};
        case Domain::Heat:
            return {191, 0, 0};
        case Domain::RealInput:
        case Domain::RealOutput:
            return {0, 0, 127};
        case Domain::Other:
            break;
    }
    return {0, 0, 0};
}

Domain connectorDomain(const Library& library, std::string_view className) {
    Domain domain = Domain::Other;
    std::set<std::string> potentials, flows;
    visitBases(library, library.find(className), [&](const LibraryClass& one) {
        const ClassDefinition& definition = *one.definition;
        if (definition.isShort && definition.shortCausality == syntax::Causality::Input) domain = Domain::RealInput;
        if (definition.isShort && definition.shortCausality == syntax::Causality::Output) domain = Domain::RealOutput;
        for (const Component& c : definition.components) (c.isFlow ? flows : potentials).insert(c.name);
    });
    if (potentials.contains("phi") && flows.contains("tau")) return Domain::Rotational;
    if (potentials.contains("s") && flows.contains("f")) return Domain::Translational;
    if (potentials.contains("v") && flows.contains("i")) return Domain::Electrical;
    if (potentials.contains("T") && flows.contains("Q_flow")) return Domain::Heat;
    return domain;
}

Icon readIcon(const Library& library, std::string_view className) {
    return iconOf(library, library.find(className), "Icon");
}

std::vector<Port> readPorts(const Library& library, std::string_view className) {
    std::vector<Port> ports;
    visitBases(library, library.find(className), [&](const LibraryClass& one) {
        for (const Component& component : one.definition->components) {
            if (component.isProtected) continue;
            const LibraryClass* type = library.lookup(component.type, one.qualifiedName);
            if (!type || !isConnectorClass(library, type)) continue;
            Port port;
            port.name = component.name;
            port.className = type->qualifiedName;
            port.domain = connectorDomain(library, type->qualifiedName);
            port.placement = annotation::placement(component.annotation, true).value_or(Placement{});
            port.icon = readIcon(library, type->qualifiedName);
            port.description = component.description.empty() ? type->definition->description : component.description;
            ports.push_back(std::move(port));
        }
    });
    return ports;
}

std::vector<Point> route(Point from, Point fromDirection, Point to, Point toDirection) {
    if (from.x == to.x || from.y == to.y) return {from, to};
    const bool fromHorizontal = fromDirection.x != 0 || (fromDirection.y == 0 && toDirection.y != 0);
    const bool toHorizontal = toDirection.x != 0 || (toDirection.y == 0 && fromDirection.y != 0);
    if (fromDirection == Point{} && toDirection == Point{}) return {from, {to.x, from.y}, to};
    if (fromHorizontal && toHorizontal) {
        const double middle = (from.x + to.x) / 2;
        return {from, {middle, from.y}, {middle, to.y}, to};
    }
    if (!fromHorizontal && !toHorizontal) {
        const double middle = (from.y + to.y) / 2;
        return {from, {from.x, middle}, {to.x, middle}, to};
    }
    return {from, fromHorizontal ? Point{to.x, from.y} : Point{from.x, to.y}, to};
}

std::string placementAnnotation(const Placement& placement) {
    std::string result = "Placement(transformation(";
    if (placement.origin != Point{}) result += "origin=" + text(placement.origin) + ", ";
    result += "extent={" + text(placement.extent.p1) + "," + text(placement.extent.p2) + "}";
    if (placement.rotation != 0) result += fmt::format(", rotation={}", rounded(placement.rotation));
    return result + "))";
}

std::string lineAnnotation(const std::vector<Point>& points, const Colour& colour) {
    std::string list;
    for (const Point p : points) list += (list.empty() ? "" : ",") + text(p);
    return fmt::format("Line(points={{{}}}, color={{{},{},{}}})", list, colour.r, colour.g, colour.b);
}

const Block* Diagram::find(std::string_view name) const {
    const auto it = std::find_if(blocks.begin(), blocks.end(), [&](const Block& b) { return b.name == name; });
    return it == blocks.end() ? nullptr : &*it;
}

namespace {

struct End {
    const Block* block{};
    const Port* port{};  // null: the block is a connector itself
};

End endOf(const Diagram& diagram, std::string_view connector) {
    const std::string_view withoutSubscript = connector.substr(0, connector.find('['));
    const auto dot = connector.find('.');
    const Block* block = diagram.find(withoutSubscript.substr(0, dot));
    if (!block) return {};
    if (dot == std::string_view::npos) return {block->isConnector ? block : nullptr, nullptr};
    std::string_view portName = connector.substr(dot + 1);
    portName = portName.substr(0, portName.find('['));
    for (const Port& port : block->ports)
        if (port.name == portName) return {block, &port};
    return {};
}

/// A top-level input hands over at its tip, an output takes in at its base.
Point connectorTip(const Block& block) {
    const Extent& e = block.icon.coordinates;
    const Point middle = centre(e);
    const double right = std::max(e.p1.x, e.p2.x), left = std::min(e.p1.x, e.p2.x);
    if (block.domain == Domain::RealInput) return {right, middle.y};
    if (block.domain == Domain::RealOutput) return {left, middle.y};
    return middle;
}

}  // namespace

std::optional<Point> Diagram::anchor(std::string_view connector) const {
    const End end = endOf(*this, connector);
    if (!end.block) return std::nullopt;
    const Extent& coordinatesOfBlock = end.block->icon.coordinates;
    if (!end.port) return map(end.block->placement, coordinatesOfBlock, connectorTip(*end.block));
    const Port& port = *end.port;
    const Point inIcon = map(port.placement, port.icon.coordinates, centre(port.icon.coordinates));
    return map(end.block->placement, coordinatesOfBlock, inIcon);
}

Point Diagram::direction(std::string_view connector) const {
    const End end = endOf(*this, connector);
    if (!end.block) return {};
    const Extent& coordinatesOfBlock = end.block->icon.coordinates;
    const Point out = end.port                                  ? side(*end.port, coordinatesOfBlock)
                      : end.block->domain == Domain::RealInput  ? Point{1, 0}
                      : end.block->domain == Domain::RealOutput ? Point{-1, 0}
                                                                : Point{};
    const Point middle = centre(coordinatesOfBlock);
    const Point from = map(end.block->placement, coordinatesOfBlock, middle);
    const Point to = map(end.block->placement, coordinatesOfBlock, {middle.x + out.x, middle.y + out.y});
    const Point step{rounded((to.x - from.x) * 1e3), rounded((to.y - from.y) * 1e3)};
    return axis(step);
}

Domain Diagram::domain(std::string_view connector) const {
    const End end = endOf(*this, connector);
    if (!end.block) return Domain::Other;
    return end.port ? end.port->domain : end.block->domain;
}

namespace {

std::vector<std::pair<std::string, std::string>> modifiedParameters(const std::vector<syntax::Modification>& all) {
    std::vector<std::pair<std::string, std::string>> result;
    const std::function<void(const std::vector<syntax::Modification>&, const std::string&)> collect =
        [&](const std::vector<syntax::Modification>& list, const std::string& prefix) {
            for (const syntax::Modification& m : list) {
                if (m.redeclaredComponent || m.redeclaredClass) continue;
                const std::string name = prefix + m.name.text();
                if (m.value) result.emplace_back(name, std::string(m.value->span.text()));
                collect(m.arguments, name + ".");
            }
        };
    collect(all, {});
    return result;
}

/// What blocks take from their classes. A large diagram has many blocks of few classes: each is looked at once.
class ClassDescriptions {
public:
    explicit ClassDescriptions(const Library& library) : library_(library) {}

    const Library& library() const { return library_; }

    void describe(const LibraryClass& type, Block& block) {
        const auto [found, isNew] = known_.try_emplace(&type);
        const Block& known = isNew ? found->second = read(type) : found->second;
        block.className = known.className;
        if (block.description.empty()) block.description = known.description;
        block.icon = known.icon;
        block.isConnector = known.isConnector;
        if (block.isConnector)
            block.domain = known.domain;
        else
            block.ports = known.ports;
        block.isEffect = known.isEffect;
    }

private:
    Block read(const LibraryClass& type) const {
        Block block;
        block.className = type.qualifiedName;
        block.description = type.definition->description;
        block.icon = readIcon(library_, type.qualifiedName);
        block.isConnector = isConnectorClass(library_, &type);
        if (block.isConnector)
            block.domain = connectorDomain(library_, type.qualifiedName);
        else
            block.ports = readPorts(library_, type.qualifiedName);
        block.isEffect = hasEffectAnnotation(type) || type.qualifiedName.starts_with("Analogon.Effects.");
        return block;
    }

    const Library& library_;
    std::map<const LibraryClass*, Block> known_;
};

/// What the extends clauses of a class and of its bases say about inherited components: another class, parameters.
class InheritedChanges {
public:
    InheritedChanges(const Library& library, const LibraryClass* cls) : library_(library) {
        // Bases come first, so that what a derived class says counts.
        visitBases(library, cls, [&](const LibraryClass& one) {
            const ClassDefinition& definition = *one.definition;
            collect(definition.shortModifications, one.scope);
            for (const syntax::Extends& base : definition.bases) collect(base.modifications, one.qualifiedName);
        });
    }

    void apply(Block& block, ClassDescriptions& descriptions) const {
        if (const auto found = classes_.find(block.name); found != classes_.end())
            descriptions.describe(*found->second, block);
        if (const auto found = parameters_.find(block.name); found != parameters_.end())
            for (const auto& [name, value] : found->second) set(block.parameters, name, value);
    }

private:
    using Parameters = std::vector<std::pair<std::string, std::string>>;

    void collect(const std::vector<syntax::Modification>& list, const std::string& scope) {
        for (const syntax::Modification& m : list) {
            const std::string name = m.name.text();
            const auto dot = name.find('.');
            if (m.redeclaredComponent) {
                if (const LibraryClass* type = library_.lookup(m.redeclaredComponent->type, scope))
                    classes_[m.redeclaredComponent->name] = type;
                for (const auto& [inner, value] : modifiedParameters(m.redeclaredComponent->modifications))
                    set(parameters_[m.redeclaredComponent->name], inner, value);
            } else if (dot != std::string::npos) {
                if (m.value)
                    set(parameters_[name.substr(0, dot)], name.substr(dot + 1), std::string(m.value->span.text()));
            } else if (!m.redeclaredClass) {
                for (const auto& [inner, value] : modifiedParameters(m.arguments)) set(parameters_[name], inner, value);
            }
        }
    }

    static void set(Parameters& parameters, const std::string& name, const std::string& value) {
        for (auto& [known, text] : parameters)
            if (known == name) {
                text = value;
                return;
            }
        parameters.emplace_back(name, value);
    }

    const Library& library_;
    std::map<std::string, const LibraryClass*> classes_;
    std::map<std::string, Parameters> parameters_;
};

/// Components without a place are laid out in rows below the diagram's middle, so that none hides another.
Placement defaultPlacement(int index) {
    const double x = -80 + 40.0 * (index % 5);
    const double y = -40.0 * (index / 5);
    return {{{x - 10, y - 10}, {x + 10, y + 10}}, {}, 0};
}

/// A declaration as a block; nothing for plain variables and parameters.
std::optional<Block> blockOf(ClassDescriptions& descriptions, const LibraryClass& owner, const Component& component) {
    const std::string typeName = component.type.text();
    if (isPredefined(typeName)) return std::nullopt;
    Block block;
    block.name = component.name;
    block.description = component.description;
    block.span = component.span;
    block.parameters = modifiedParameters(component.modifications);
    const LibraryClass* type = descriptions.library().lookup(component.type, owner.qualifiedName);
    if (!type) {
        block.className = typeName;
        block.isResolved = false;
        return block;
    }
    const auto restriction = type->definition->restriction;
    if (restriction == ClassDefinition::Restriction::Type || restriction == ClassDefinition::Restriction::Record)
        return std::nullopt;
    descriptions.describe(*type, block);
    return block;
}

void readWires(const std::vector<Equation>& equations, Diagram& diagram) {
    for (const Equation& equation : equations) {
        if (equation.kind == Equation::Kind::If)
            for (const Equation::Branch& branch : equation.branches) readWires(branch.body, diagram);
        if (equation.kind != Equation::Kind::Connect) continue;
        Wire wire;
        wire.from = connectorText(equation.left);
        wire.to = connectorText(equation.right);
        wire.span = equation.span;
        const Domain domain = diagram.domain(wire.from);
        wire.colour = domainColour(domain == Domain::Other ? diagram.domain(wire.to) : domain);
        if (const auto line = annotation::find(equation.annotation, "Line")) {
            wire.points = line->points("points");
            wire.colour = line->colour("color").value_or(wire.colour);
            wire.thickness = line->number("thickness").value_or(wire.thickness);
        }
        if (wire.points.size() < 2) {
            const auto from = diagram.anchor(wire.from);
            const auto to = diagram.anchor(wire.to);
            wire.points.clear();
            if (from && to) wire.points = route(*from, diagram.direction(wire.from), *to, diagram.direction(wire.to));
        }
        diagram.wires.push_back(std::move(wire));
    }
}

}  // namespace

Outcome<Diagram> readDiagram(const Library& library, std::string_view className) {
    const LibraryClass* cls = library.find(className);
    if (!cls) {
        const std::string like = suggestion(className, library.names());
        return error(phrase("there is no class \"{}\"", className), {},
                     like.empty() ? Text() : phrase("did you mean \"{}\"?", like));
    }
    Diagram diagram;
    diagram.className = cls->qualifiedName;
    const Icon layer = iconOf(library, cls, "Diagram");
    diagram.coordinates = layer.coordinates;
    diagram.graphics = layer.primitives;
    int unplaced = 0;
    ClassDescriptions descriptions(library);
    const InheritedChanges changes(library, cls);
    visitBases(library, cls, [&](const LibraryClass& one) {
        for (const Component& component : one.definition->components) {
            auto block = blockOf(descriptions, one, component);
            if (!block) continue;
            const auto place = annotation::placement(component.annotation);
            const auto known = component.isRedeclare
                                   ? std::find_if(diagram.blocks.begin(), diagram.blocks.end(),
                                                  [&](const Block& b) { return b.name == block->name; })
                                   : diagram.blocks.end();
            if (known != diagram.blocks.end()) {  // stands where the inherited one stood
                block->placement = place.value_or(known->placement);
                *known = std::move(*block);
                continue;
            }
            changes.apply(*block, descriptions);
            block->placement = place ? *place : defaultPlacement(unplaced++);
            diagram.blocks.push_back(std::move(*block));
        }
    });
    visitBases(library, cls, [&](const LibraryClass& one) {
        for (const syntax::EquationSection& section : one.definition->equationSections)
            readWires(section.equations, diagram);
    });
    return diagram;
}

}  // namespace analogon
