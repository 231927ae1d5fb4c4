#include "core/effect/model/wire_in.hpp"

#include <fmt/format.h>

#include <cctype>

#include "core/diagram/edit.hpp"
#include "core/effect/catalogue/combination.hpp"
#include "core/syntax/parser.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {
namespace {

constexpr double blockSize = 20;

std::string instanceName(const Library& library, const syntax::ClassDefinition& model, const EffectClass& effect) {
    std::string base = effect.className.substr(effect.className.rfind('.') + 1);
    base[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(base[0])));
    return freeName(library, model, base);
}

std::vector<std::pair<std::string, std::string>> modifications(const std::map<std::string, double>& values) {
    std::vector<std::pair<std::string, std::string>> texts;
    for (const auto& [name, value] : values) texts.emplace_back(name, syntax::printNumber(value));
    return texts;
}

Point port(const Library& library, const NewComponent& component, const std::string& name) {
    for (const Port& p : readPorts(library, component.className))
        if (p.name == name) {
            // icon coordinates -100 … 100 scaled into the block's extent
            const Extent& e = component.placement.extent;
            const Point centre{(p.placement.extent.p1.x + p.placement.extent.p2.x) / 2 + p.placement.origin.x,
                               (p.placement.extent.p1.y + p.placement.extent.p2.y) / 2 + p.placement.origin.y};
            return {component.placement.origin.x + e.p1.x + (centre.x + 100) / 200 * (e.p2.x - e.p1.x),
                    component.placement.origin.y + e.p1.y + (centre.y + 100) / 200 * (e.p2.y - e.p1.y)};
        }
    return component.placement.origin;
}

/// Horizontal or vertical pieces from one anchor to the other.
std::vector<Point> route(Point from, Point to) {
    if (from.x == to.x || from.y == to.y) return {from, to};
    return {from, {to.x, from.y}, to};
}

Colour colourAt(const Diagram& diagram, const std::string& connector) {
    for (const Wire& w : diagram.wires)
        if (w.from == connector || w.to == connector) return w.colour;
    const std::size_t dot = connector.find('.');
    if (const Block* b = diagram.find(connector.substr(0, dot))) {
        if (b->isConnector) return domainColour(b->domain);
        for (const Port& p : b->ports)
            if (dot != std::string::npos && p.name == connector.substr(dot + 1)) return domainColour(p.domain);
    }
    return {};
}

/// The component becomes the effect, or what holds it beside the effects that it has. `block`: null where the diagram
/// does not show it.
void setEffectClass(ModelEdit& edit, const Library& library, const EffectClass& effect, const std::string& component,
                    const Block* block) {
    const std::string held = block != nullptr ? classWith(library, *block, effect) : std::string();
    edit.setClass(component, held.empty() ? effect.className : held);
}

class Wiring {
public:
    Wiring(const Library& library, const syntax::ClassDefinition& model, const EffectClass& effect,
           const EffectPlace& place, const std::map<std::string, double>& values, Diagram diagram)
        : library_(library),
          effect_(effect),
          place_(place),
          diagram_(std::move(diagram)),
          edit_(model, nullptr, &library) {
        component_.className = effect.className;
        component_.name = instanceName(library, model, effect);
        component_.modifications = modifications(values);
        const Point near = diagram_.anchor(place.connector).value_or(Point{0, 0});
        component_.placement = freePlacement(diagram_, near, blockSize, blockSize);
        colour_ = colourAt(diagram_, place.connector);
    }

    void bind(const std::map<std::string, std::string>& expressions) {
        for (const auto& [name, text] : expressions) component_.modifications.emplace_back(name, text);
    }

    void attach() {
        edit_.addComponent(component_);
        join(component_.name + "." + effect_.placement.ports[0], port(library_, component_, effect_.placement.ports[0]),
             place_.connector);
        if (!place_.spare.empty()) addSpareInput(component_.name);
    }

    void bridge() {
        edit_.addComponent(component_);
        for (const std::size_t side : {0u, 1u}) {
            const std::string& own = effect_.placement.ports[side];
            join(component_.name + "." + own, port(library_, component_, own), side ? place_.node : place_.connector);
        }
    }

    /// The connector keeps the near side; all that it was joined to moves to the far side.
    void insert() {
        const bool isOutput = effect_.placement.signalSide == "output";
        const std::string near = component_.name + "." + effect_.placement.ports[isOutput ? 1 : 0],
                          far = component_.name + "." + effect_.placement.ports[isOutput ? 0 : 1];
        edit_.addComponent(component_);
        if (effect_.placement.signalSide.empty() || edit_.isConnected(place_.connector))
            edit_.replaceInConnections(place_.connector, far);
        if (!effect_.placement.signalSide.empty()) edit_.replaceReferences(place_.connector, far);
        const Point nearAt = port(library_, component_, effect_.placement.ports[isOutput ? 1 : 0]);
        if (!effect_.placement.signalSide.empty() && !isConnector(place_.connector))
            edit_.addEquation(isOutput ? place_.connector + " = " + near : near + " = " + place_.connector);
        else if (isOutput)
            join(near, nearAt, place_.connector);
        else
            join(place_.connector, near, nearAt);
    }

    void specialise(const std::map<std::string, double>& values) {
        component_.name = place_.connector;
        const Block* component = diagram_.find(place_.connector);
        setEffectClass(edit_, library_, effect_, place_.connector, component);
        // a class that holds several effects has those whose strength is told
        if (!values.contains(effect_.parameters.strength))
            edit_.setModifier(place_.connector, effect_.parameters.strength, "0");
        for (const auto& [name, value] : modifications(values)) edit_.setModifier(place_.connector, name, value);
        if (!place_.spare.empty()) addSpareInput(place_.connector);
        const bool isJoined = component != nullptr && !nodePortOf(library_, *component).empty();
        if (!place_.node.empty() && !isJoined)
            edit_.addConnection(place_.connector + "." + effect_.placement.node, place_.node, {},
                                colourAt(diagram_, place_.node));
    }

    Outcome<WiredEffect> finish() const {
        Outcome<syntax::TextEdit> edit = edit_.finish(fmt::format("Add {} at {}", effect_.kind, place_.at));
        if (!edit) return edit.diagnostics();
        return WiredEffect{std::move(*edit), component_.name, newInput_};
    }

private:
    /// A signal may be a plain `output Real` as well, which no wire can end at.
    bool isConnector(const std::string& signal) const {
        const Block* block = diagram_.find(signal);
        return block != nullptr && block->isConnector;
    }

    void join(const std::string& from, Point fromAt, const std::string& to) {
        edit_.addConnection(from, to, route(fromAt, diagram_.anchor(to).value_or(fromAt)), colour_);
    }
    void join(const std::string& from, const std::string& to, Point toAt) {
        edit_.addConnection(from, to, route(diagram_.anchor(from).value_or(toAt), toAt), colour_);
    }

    /// A top-level input that drives the effect's signal input of this instance: one of the model, or a new one.
    void addSpareInput(const std::string& instance) {
        if (const std::string_view spare = place_.spare; spare.starts_with(inputPrefix)) {
            const std::string own(spare.substr(inputPrefix.size())),
                signal = instance + "." + effect_.placement.channel;
            if (isConnector(own))
                edit_.addConnection(own, signal, {}, domainColour(Domain::RealInput));
            else
                edit_.addEquation(signal + " = " + own);
            return;
        }
        std::string base;
        for (const char c : place_.spare) base += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
        // a column may be called "flow" or "output"
        const bool isNone = base.empty() || std::isdigit(static_cast<unsigned char>(base[0]));
        if (isNone || base == "time" || syntax::isKeyword(base)) base = "channel_" + base;
        NewComponent input;
        input.className = "Analogon.Interfaces.RealInput";
        input.name = base;
        while (diagram_.find(input.name) != nullptr) input.name += "_1";
        const Point near = diagram_.anchor(instance + "." + effect_.placement.channel)
                               .value_or(diagram_.anchor(place_.connector).value_or(Point{0, 0}));
        input.placement = freePlacement(diagram_, {near.x - 40, near.y - 40}, blockSize, blockSize);
        input.description = "Recorded channel " + place_.spare;
        if (!effect_.placement.quantity.empty())
            input.modifications.emplace_back("unit", '"' + effect_.placement.quantity + '"');
        edit_.addComponent(input);
        edit_.addConnection(input.name, instance + "." + effect_.placement.channel, {},
                            domainColour(Domain::RealInput));
        newInput_ = input.name;
    }

    const Library& library_;
    const EffectClass& effect_;
    const EffectPlace& place_;
    Diagram diagram_;
    ModelEdit edit_;
    NewComponent component_;
    Colour colour_;
    std::string newInput_;
};

}  // namespace

Outcome<WiredEffect> wireIn(const Library& library, const syntax::ClassDefinition& model, const EffectClass& effect,
                            const EffectPlace& place, const std::map<std::string, double>& values,
                            const std::map<std::string, std::string>& expressions) {
    Outcome<Diagram> diagram = readDiagram(library, model.name);
    if (!diagram) return diagram.diagnostics();
    Wiring wiring(library, model, effect, place, values, std::move(*diagram));
    wiring.bind(expressions);
    switch (effect.placement.way) {
        case Way::Attach:
            wiring.attach();
            break;
        case Way::Insert:
            wiring.insert();
            break;
        case Way::Specialise:
            wiring.specialise(values);
            break;
        case Way::Bridge:
            wiring.bridge();
            break;
    }
    return wiring.finish();
}

namespace {

/// One of several effects that are wired in beside each other, none of them laid out.
class WiringBeside {
public:
    WiringBeside(const Library& library, const syntax::ClassDefinition& model, const EffectClass& effect)
        : library_(library),
          model_(model),
          effect_(effect),
          base_(instanceName(library, model, effect)),
          edit_(model, nullptr, &library) {}

    /// The component that the effect is, of this number.
    std::string add(const EffectPlace& place, std::size_t number) {
        NewComponent component;
        component.className = effect_.className;
        component.name = freeName(library_, model_, fmt::format("{}_at{}_", base_, number));
        for (const auto& [name, text] : effect_.bound) component.modifications.emplace_back(name, text);
        edit_.addComponent(component);
        const auto own = [&](std::size_t side) { return component.name + "." + effect_.placement.ports[side]; };
        if (effect_.placement.way == Way::Insert) edit_.replaceInConnections(place.connector, own(1));
        edit_.addConnection(own(0), place.connector, {}, {});
        if (effect_.placement.way == Way::Bridge) edit_.addConnection(own(1), place.node, {}, {});
        if (const std::string_view spare = place.spare; spare.starts_with(inputPrefix))
            edit_.addEquation(
                fmt::format("{}.{} = {}", component.name, effect_.placement.channel, spare.substr(inputPrefix.size())));
        return component.name;
    }

    /// The component that becomes the effect.
    std::string specialise(const EffectPlace& place, const Diagram& diagram) {
        setEffectClass(edit_, library_, effect_, place.connector, diagram.find(place.connector));
        edit_.setModifier(place.connector, effect_.parameters.strength, "0");
        return place.connector;
    }

    Outcome<syntax::TextEdit> finish(const std::string& what) const { return edit_.finish(what); }

private:
    const Library& library_;
    const syntax::ClassDefinition& model_;
    const EffectClass& effect_;
    std::string base_;
    ModelEdit edit_;
};

}  // namespace

Outcome<WiredBeside> wireInBeside(const Library& library, const syntax::ClassDefinition& model,
                                  const EffectClass& effect, const std::vector<EffectPlace>& places) {
    Diagram diagram;
    if (effect.placement.way == Way::Specialise) {
        Outcome<Diagram> read = readDiagram(library, model.name);
        if (!read) return read.diagnostics();
        diagram = std::move(*read);
    }
    WiringBeside wiring(library, model, effect);
    WiredBeside wired;
    for (const EffectPlace& place : places)
        wired.instances.push_back(effect.placement.way == Way::Specialise
                                      ? wiring.specialise(place, diagram)
                                      : wiring.add(place, wired.instances.size() + 1));
    Outcome<syntax::TextEdit> finished = wiring.finish(fmt::format("Add {} at {} places", effect.kind, places.size()));
    if (!finished) return finished.diagnostics();
    wired.edit = std::move(*finished);
    return wired;
}

}  // namespace analogon
