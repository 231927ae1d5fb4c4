#include "core/study/composition.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/syntax/parser.hpp"

namespace analogon {

namespace {

/// The text after an edit that knows the diagram of the text.
template <class Change>
Outcome<std::string> edited(const Library& library, const std::string& className, const std::string& text,
                            const Change& change) {
    const auto source = std::make_shared<const Source>("model.mo", text);
    const syntax::ParseResult parsed = syntax::parse(source);
    if (hasError(parsed.diagnostics) || parsed.definition.classes.empty())
        return fileError(phrase("'{}' cannot be the name of a model", className), "", 0, 0,
                         phrase("A name is a letter followed by letters, digits and underscores."));
    const Outcome<Library> extended = library.withSource(source);
    if (!extended) return extended.diagnostics();
    const Outcome<Diagram> diagram = readDiagram(*extended, className);
    if (!diagram) return diagram.diagnostics();
    ModelEdit edit(*parsed.definition.classes.front(), &*diagram, &*extended);
    change(edit);
    const Outcome<syntax::TextEdit> result = edit.finish("compose");
    if (!result) return result.diagnostics();
    return syntax::apply(text, *result).text;
}

}  // namespace

std::string Composition::freeName(const std::string& base) {
    std::string name = base;
    for (int i = 2; names_.contains(name); ++i) name = fmt::format("{}{}", base, i);
    names_.insert(name);
    return name;
}

std::string Composition::add(const std::string& className, const std::string& base, Point centre,
                             const std::string& description,
                             std::vector<std::pair<std::string, std::string>> modifications) {
    const std::string name = freeName(base);
    addNamed("Analogon." + className, name, centre, description, std::move(modifications));
    return name;
}

void Composition::addNamed(const std::string& className, const std::string& name, Point centre,
                           const std::string& description,
                           std::vector<std::pair<std::string, std::string>> modifications) {
    NewComponent component;
    component.className = className;
    component.name = name;
    component.description = description;
    component.modifications = std::move(modifications);
    component.placement.extent = {{centre.x - 10, centre.y - 10}, {centre.x + 10, centre.y + 10}};
    components_.push_back(std::move(component));
}

void Composition::setModification(const std::string& component, const std::string& name, const std::string& value) {
    for (NewComponent& candidate : components_)
        if (candidate.name == component) candidate.modifications.emplace_back(name, value);
}

void Composition::connect(const std::string& from, const std::string& to, Domain domain) {
    connected_.insert(from);
    connected_.insert(to);
    connections_.push_back({from, to, domain});
}

Outcome<std::string> Composition::text(const Library& library, const std::string& className,
                                       const std::string& description, const Extent& diagram) const {
    const std::string empty = fmt::format(
        "model {0} \"{1}\"\n  annotation (Diagram(coordinateSystem(extent={{{{{2},{3}}},{{{4},{5}}}}})));\nend {0};\n",
        className, description, diagram.p1.x, diagram.p1.y, diagram.p2.x, diagram.p2.y);
    // From left to right, in the order of the signal flow, a model reads best.
    std::vector<NewComponent> ordered = components_;
    std::stable_sort(ordered.begin(), ordered.end(), [](const NewComponent& a, const NewComponent& b) {
        return a.placement.extent.p1.x < b.placement.extent.p1.x;
    });
    const Outcome<std::string> placed = edited(library, className, empty, [&](ModelEdit& edit) {
        for (const NewComponent& component : ordered) edit.addComponent(component);
    });
    if (!placed) return placed;
    return edited(library, className, *placed, [&](ModelEdit& edit) {
        for (const Connection& connection : connections_)
            edit.addConnection(connection.from, connection.to, {}, domainColour(connection.domain));
    });
}

}  // namespace analogon
