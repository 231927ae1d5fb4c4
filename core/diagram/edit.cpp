#include "core/diagram/edit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "core/diagram/annotation.hpp"
#include "core/diagram/edit_text.hpp"
#include "core/diagram/references.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {

using syntax::ClassDefinition;
using syntax::Component;
using syntax::Equation;
using syntax::Expression;
using syntax::Modification;
using syntax::Replacement;

namespace {

std::string endText(const Expression& end) {
    std::string text(end.span.text());
    std::erase_if(text, [](unsigned char c) { return std::isspace(c); });
    return text;
}

std::string_view firstPart(std::string_view connector) { return connector.substr(0, connector.find_first_of(".[")); }

void collectConnections(const std::vector<Equation>& equations, std::vector<const Equation*>& result) {
    for (const Equation& equation : equations) {
        if (equation.kind == Equation::Kind::Connect) result.push_back(&equation);
        for (const Equation::Branch& branch : equation.branches) collectConnections(branch.body, result);
        collectConnections(equation.body, result);
    }
}

const Component* findComponent(const ClassDefinition& definition, std::string_view name) {
    for (const Component& c : definition.components)
        if (c.name == name) return &c;
    return nullptr;
}

/// `transformation(…)` without the Placement around it.
std::string transformationText(const Placement& placement) {
    constexpr std::string_view head = "Placement(";
    const std::string whole = placementAnnotation(placement);
    return whole.substr(head.size(), whole.size() - head.size() - 1);
}

}  // namespace

ModelEdit::ModelEdit(const ClassDefinition& definition, const Diagram* diagram, const Library* library)
    : definition_(&definition), diagram_(diagram), library_(library) {
    std::vector<const Equation*> equations;
    for (const syntax::EquationSection& section : definition.equationSections)
        collectConnections(section.equations, equations);
    for (const Equation* e : equations) connects_.push_back({e, endText(e->left), endText(e->right)});
}

ModelEdit::ComponentChange* ModelEdit::ownChange(std::string_view component) {
    return findComponent(*definition_, component) ? &components_[std::string(component)] : nullptr;
}

ModelEdit::ComponentChange* ModelEdit::change(std::string_view component) {
    if (ComponentChange* own = ownChange(component)) return own;
    const std::string like = suggestion(component, componentNames());
    faults_.push_back(error(phrase("model {} has no component \"{}\"", definition_->name, component),
                            definition_->nameSpan, like.empty() ? Text() : phrase("did you mean \"{}\"?", like)));
    return nullptr;
}

ModelEdit& ModelEdit::addComponent(const NewComponent& component) {
    newComponents_.push_back(component);
    return *this;
}

ModelEdit& ModelEdit::removeComponent(std::string_view name) {
    if (!ownChange(name) && refuseInherited(name, phrase("removed"))) return *this;
    if (ComponentChange* c = change(name)) {
        c->isRemoved = true;
        for (const Connect& connect : connects_)
            if (firstPart(connect.left) == name || firstPart(connect.right) == name)
                connections_[connect.equation].isRemoved = true;
    }
    return *this;
}

ModelEdit& ModelEdit::renameComponent(std::string_view from, const std::string& to) {
    if (!ownChange(from) && refuseInherited(from, phrase("renamed"))) return *this;
    if (change(from)) renames_[std::string(from)] = to;
    return *this;
}

ModelEdit& ModelEdit::setClass(std::string_view component, const std::string& className) {
    if (!ownChange(component) && redeclareInherited(component, className)) return *this;
    if (ComponentChange* c = change(component)) c->className = className;
    return *this;
}

ModelEdit& ModelEdit::setModifier(std::string_view component, const std::string& name, const std::string& value) {
    const auto added = std::find_if(newComponents_.begin(), newComponents_.end(),
                                    [&](const NewComponent& n) { return n.name == component; });
    if (added != newComponents_.end()) {
        std::erase_if(added->modifications, [&](const auto& m) { return m.first == name; });
        if (!value.empty()) added->modifications.emplace_back(name, value);
    } else if (!ownChange(component) && changeInherited(component, fmt::format("{}.{}", component, name), value)) {
        return *this;
    } else if (ComponentChange* c = change(component)) {
        c->modifiers.emplace_back(name, value);
    }
    return *this;
}

ModelEdit& ModelEdit::setBinding(std::string_view component, const std::string& value) {
    if (!ownChange(component) && changeInherited(component, std::string(component), value)) return *this;
    if (ComponentChange* c = change(component)) c->binding = value;
    return *this;
}

ModelEdit& ModelEdit::setParameter(std::string_view flatName, const std::string& value) {
    if (flatName.find('[') != std::string_view::npos) {
        setElement(flatName, value);
        return *this;
    }
    const auto dot = flatName.find('.');
    if (dot == std::string_view::npos) return setBinding(flatName, value);
    return setModifier(flatName.substr(0, dot), std::string(flatName.substr(dot + 1)), value);
}

ModelEdit& ModelEdit::setPlacement(std::string_view component, const Placement& placement) {
    const auto added = std::find_if(newComponents_.begin(), newComponents_.end(),
                                    [&](const NewComponent& n) { return n.name == component; });
    if (added != newComponents_.end())
        added->placement = placement;
    else if (!ownChange(component) && refuseInherited(component, phrase("moved")))
        return *this;
    else if (ComponentChange* c = change(component))
        c->placement = placement;
    return *this;
}

ModelEdit& ModelEdit::addConnection(const std::string& from, const std::string& to, const std::vector<Point>& points,
                                    const Colour& colour) {
    newConnections_.push_back({{}, from, to, points, colour});
    return *this;
}

std::vector<const Equation*> ModelEdit::connectionsBetween(std::string_view from, std::string_view to) {
    std::vector<const Equation*> result;
    for (const auto& [equation, left, right] : connects_)
        if ((left == from && right == to) || (left == to && right == from)) result.push_back(equation);
    if (result.empty())
        faults_.push_back(error(phrase("model {} has no connection of \"{}\" with \"{}\"", definition_->name, from, to),
                                definition_->nameSpan));
    return result;
}

ModelEdit& ModelEdit::removeConnection(std::string_view from, std::string_view to) {
    for (const Equation* equation : connectionsBetween(from, to)) connections_[equation].isRemoved = true;
    return *this;
}

ModelEdit& ModelEdit::replaceInConnections(std::string_view connector, const std::string& by) {
    bool found = false;
    for (const auto& [equation, left, right] : connects_) {
        if (left == connector) connections_[equation].left = by, found = true;
        if (right == connector) connections_[equation].right = by, found = true;
    }
    if (!found)
        faults_.push_back(error(phrase("no connection of model {} ends at \"{}\"", definition_->name, connector),
                                definition_->nameSpan,
                                definition_->bases.empty() && !definition_->isShort
                                    ? Text()
                                    : phrase("an inherited connection can only be changed in the class that holds "
                                             "it")));
    return *this;
}

bool ModelEdit::isConnected(std::string_view connector) const {
    return std::any_of(connects_.begin(), connects_.end(),
                       [&](const Connect& c) { return c.left == connector || c.right == connector; });
}

ModelEdit& ModelEdit::replaceReferences(std::string_view variable, const std::string& by) {
    replaced_[std::string(variable)] = by;
    for (const Component& c : definition_->components)
        if (c.name == variable && c.binding) {
            addEquation(by + " = " + std::string(c.binding->span.text()));
            setBinding(variable, "");
        }
    return *this;
}

ModelEdit& ModelEdit::addEquation(const std::string& text) {
    newConnections_.push_back({text, {}, {}, {}, {}});
    return *this;
}

ModelEdit& ModelEdit::setLine(std::string_view from, std::string_view to, const std::vector<Point>& points) {
    for (const Equation* equation : connectionsBetween(from, to)) connections_[equation].points = points;
    return *this;
}

// ---- the text of the changes ---------------------------------------------------------------------------------

/// The changes within one declared component, from its name to its annotation.
ModelEdit::Replacements ModelEdit::inside(const Component& component, const ComponentChange& change) const {
    Replacements edits =
        edit_text::setModifications(component.modifications, component.modificationsSpan, change.modifiers);
    if (change.binding) {
        const std::uint32_t behindName = component.modificationsSpan.end;
        if (component.binding) {
            const Span& old = component.binding->span;
            if (change.binding->empty())
                edits.push_back({behindName, old.end, {}});
            else
                edits.push_back({old.begin, old.end, *change.binding});
        } else if (!change.binding->empty()) {
            edits.push_back({behindName, behindName, " = " + *change.binding});
        }
    }
    if (change.placement)
        edits.push_back(edit_text::setAnnotation(component.annotation, component.span.end, "Placement",
                                                 "transformation", transformationText(*change.placement),
                                                 placementAnnotation(*change.placement)));
    return edits;
}

void ModelEdit::writeComponents(Replacements& edits) const {
    const std::string& text = definition_->source->text();
    const auto& all = definition_->components;
    for (std::size_t first = 0; first < all.size();) {
        // One clause, `Type a, b;`, declares components [first, next).
        std::size_t next = first + 1;
        while (next < all.size() && all[next].clauseSpan.begin == all[first].clauseSpan.begin) ++next;
        const Span& clause = all[first].clauseSpan;

        std::vector<bool> leaves(next - first);
        std::string split;  // declarations that leave a shared clause because their class changes
        for (std::size_t i = first; i < next; ++i) {
            const auto found = components_.find(all[i].name);
            if (found == components_.end()) continue;
            const ComponentChange& change = found->second;
            Replacements own = inside(all[i], change);
            leaves[i - first] = change.isRemoved;
            if (!change.isRemoved && change.className && next - first > 1) {
                leaves[i - first] = true;
                const std::string prefix(text.substr(clause.begin, all[i].typeSpan.begin - clause.begin));
                split += edit_text::lineEnd(text) + edit_text::indentation(text, clause.begin) + prefix +
                         *change.className + " " +
                         edit_text::applied(text, all[i].span.begin, all[i].span.end, std::move(own)) + ";";
            } else if (!change.isRemoved) {
                if (change.className) edits.push_back({all[i].typeSpan.begin, all[i].typeSpan.end, *change.className});
                edits.insert(edits.end(), own.begin(), own.end());
            }
        }

        const bool noneStays = std::find(leaves.begin(), leaves.end(), false) == leaves.end();
        if (noneStays && split.empty()) {
            edits.push_back(edit_text::removal(text, clause.begin, clause.end));
        } else if (noneStays) {
            const std::size_t lead = split.find_first_not_of(" \t\r\n");
            edits.push_back({clause.begin, clause.end, split.substr(lead)});
        } else {
            std::size_t staying = first;
            while (leaves[staying - first]) ++staying;
            if (staying > first) edits.push_back({all[first].span.begin, all[staying].span.begin, {}});
            for (std::size_t i = staying + 1; i < next; ++i)
                if (leaves[i - first]) edits.push_back({all[i - 1].span.end, all[i].span.end, {}});
            if (!split.empty()) edits.push_back({clause.end, clause.end, split});
        }
        first = next;
    }
}

void ModelEdit::writeNewComponents(Replacements& edits) const {
    if (newComponents_.empty()) return;
    const std::string& text = definition_->source->text();

    // Behind the last public component; else behind what may stand before the components.
    std::uint32_t last = definition_->nameSpan.end;
    std::string indent = edit_text::indentation(text, definition_->span.begin) + "  ";
    bool any = false;
    for (const Component& c : definition_->components) {
        const auto change = components_.find(c.name);
        const bool stays = change == components_.end() || !change->second.isRemoved;
        if (stays && !c.isProtected && c.clauseSpan.end > last) {
            last = c.clauseSpan.end;
            indent = edit_text::indentation(text, c.clauseSpan.begin);
            any = true;
        }
    }
    if (!any) {
        for (const syntax::Import& i : definition_->imports) last = std::max(last, i.span.end);
        for (const syntax::Extends& e : definition_->bases) last = std::max(last, e.span.end);
        if (last == definition_->nameSpan.end) {
            // The description string has no span of its own: it ends where the text after the name does.
            std::uint32_t at = last;
            while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at]))) ++at;
            if (!definition_->description.empty() && text[at] == '"') {
                for (++at; text[at] != '"'; ++at)
                    if (text[at] == '\\') ++at;
                last = at + 1;
            }
        }
    }
    const std::uint32_t at = edit_text::behindTrailingComment(text, last);
    edits.push_back({at, at, newComponentsText(indent)});
}

std::string ModelEdit::newComponentsText(const std::string& indent) const {
    const std::string newline = edit_text::lineEnd(definition_->source->text());
    std::string declarations;
    for (const NewComponent& component : newComponents_) {
        std::string list;
        for (const auto& [name, value] : component.modifications)
            list += (list.empty() ? "" : ", ") + name + "=" + value;
        declarations += newline + indent + component.className + " " + component.name;
        if (!list.empty()) declarations += "(" + list + ")";
        if (!component.description.empty()) declarations += " \"" + component.description + "\"";
        declarations += " annotation (" + placementAnnotation(component.placement) + ");";
    }
    return declarations;
}

void ModelEdit::writeConnections(Replacements& edits) const {
    const std::string& text = definition_->source->text();
    for (const Connect& connect : connects_) {
        const Equation* equation = connect.equation;
        const auto found = connections_.find(equation);
        if (found == connections_.end()) continue;
        const ConnectionChange& change = found->second;
        if (change.isRemoved) {
            edits.push_back(edit_text::removal(text, equation->span.begin, equation->span.end));
            continue;
        }
        const Span& left = equation->left.span;
        const Span& right = equation->right.span;
        if (change.left) edits.push_back({left.begin, left.end, *change.left});
        if (change.right) edits.push_back({right.begin, right.end, *change.right});
        if (change.points) {
            const Domain domain = diagram_ ? diagram_->domain(endText(equation->left)) : Domain::Other;
            const std::string line = lineAnnotation(*change.points, domainColour(domain));
            const auto begin = line.find("points=");
            const std::string points = line.substr(begin, line.find("}}", begin) + 2 - begin);
            const std::uint32_t beforeSemicolon = equation->span.end - (text[equation->span.end - 1] == ';' ? 1 : 0);
            edits.push_back(
                edit_text::setAnnotation(equation->annotation, beforeSemicolon, "Line", "points", points, line));
        }
    }
}

Diagram ModelEdit::diagramWithNewBlocks() const {
    Diagram diagram = *diagram_;
    if (!library_) return diagram;
    for (const NewComponent& component : newComponents_) {
        Block block;
        block.name = component.name;
        const LibraryClass* cls = library_->lookup(component.className, diagram.className);
        if (!cls) continue;
        block.className = cls->qualifiedName;
        block.placement = component.placement;
        block.icon = readIcon(*library_, cls->qualifiedName);
        block.ports = readPorts(*library_, cls->qualifiedName);
        diagram.blocks.push_back(std::move(block));
    }
    return diagram;
}

void ModelEdit::writeNewConnections(Replacements& edits) const {
    if (newConnections_.empty()) return;
    const std::string& text = definition_->source->text();
    const std::string newline = edit_text::lineEnd(text);
    const std::string classIndent = edit_text::indentation(text, definition_->span.begin);

    const syntax::EquationSection* section = nullptr;
    for (const syntax::EquationSection& s : definition_->equationSections)
        if (!s.isInitial) section = &s;
    std::string indent = classIndent + "  ";
    if (section && !section->equations.empty())
        indent = edit_text::indentation(text, section->equations.back().span.begin);
    const std::string lines = newConnectionsText(indent);

    if (section) {
        std::uint32_t end = section->keyword.end;  // behind what stays: a change cannot begin within one that removes
        for (const Equation& equation : section->equations) {
            const auto change = connections_.find(&equation);
            if (change == connections_.end() || !change->second.isRemoved) end = equation.span.end;
        }
        const std::uint32_t at = edit_text::behindTrailingComment(text, end);
        edits.push_back({at, at, lines});
        return;
    }
    const auto& annotation = definition_->annotation;
    std::uint32_t before = definition_->endSpan.begin;
    if (annotation && annotation->span.begin < before) {
        const bool isLast = std::all_of(definition_->components.begin(), definition_->components.end(),
                                        [&](const Component& c) { return c.span.end <= annotation->span.begin; });
        if (isLast) before = annotation->span.begin;
    }
    const std::uint32_t at = edit_text::beforeIndentation(text, before);
    const bool startsLine = at == 0 || text[at - 1] == '\n';
    edits.push_back({at, at, (startsLine ? "" : newline) + classIndent + "equation" + lines + newline});
}

std::string ModelEdit::newConnectionsText(const std::string& indent) const {
    const std::string newline = edit_text::lineEnd(definition_->source->text());
    std::optional<Diagram> diagram;
    if (diagram_) diagram = diagramWithNewBlocks();
    std::string lines;
    for (const NewConnection& connection : newConnections_) {
        if (!connection.equation.empty()) {
            lines += newline + indent + connection.equation + ";";
            continue;
        }
        std::vector<Point> points = connection.points;
        if (points.size() < 2 && diagram) {
            const auto from = diagram->anchor(connection.from), to = diagram->anchor(connection.to);
            if (from && to)
                points = route(*from, diagram->direction(connection.from), *to, diagram->direction(connection.to));
        }
        lines += newline + indent + "connect(" + connection.from + ", " + connection.to + ")";
        if (points.size() >= 2) lines += " annotation (" + lineAnnotation(points, connection.colour) + ")";
        lines += ";";
    }
    return lines;
}

/// Where the text of the class uses a variable as the first part of a reference (one text may be part of two trees).
std::set<std::uint32_t> ModelEdit::placesOf(std::string_view variable, bool alsoInConnections) const {
    FirstNames names;
    for (const Component& c : definition_->components) names.visit(c);
    for (const syntax::Extends& base : definition_->bases)
        for (const Modification& m : base.modifications) names.visit(m);
    for (const auto* sections : {&definition_->equationSections, &definition_->algorithmSections})
        for (const syntax::EquationSection& section : *sections)
            for (const Equation& equation : section.equations)
                if (alsoInConnections || equation.kind != Equation::Kind::Connect) names.visit(equation);
    std::set<std::uint32_t> places;
    for (const syntax::Name* name : names.found)
        if (name->parts.front().identifier == variable) places.insert(name->parts.front().span.begin);
    return places;
}

namespace {

/// Adds replacements of one name, but where another change rewrites the text as a whole: it is taken from there.
template <class Replacements>
void replaceAt(const std::set<std::uint32_t>& places, std::string_view name, const std::string& by, std::size_t written,
               Replacements& edits) {
    for (const std::uint32_t begin : places) {
        const Replacement r{begin, begin + static_cast<std::uint32_t>(name.size()), by};
        const bool isRewritten =
            std::any_of(edits.begin(), edits.begin() + static_cast<std::ptrdiff_t>(written),
                        [&](const Replacement& other) { return other.begin < r.end && r.begin < other.end; });
        if (!isRewritten) edits.push_back(r);
    }
}

}  // namespace

void ModelEdit::writeRenames(Replacements& edits) const {
    const std::size_t written = edits.size();
    for (const auto& [from, to] : renames_) {
        std::set<std::uint32_t> places = placesOf(from, true);
        for (const Component& c : definition_->components)
            if (c.name == from) places.insert(c.nameSpan.begin);
        replaceAt(places, from, to, written, edits);
    }
}

void ModelEdit::writeReplaced(Replacements& edits) const {
    const std::size_t written = edits.size();
    for (const auto& [variable, by] : replaced_) replaceAt(placesOf(variable, false), variable, by, written, edits);
}

Outcome<syntax::TextEdit> ModelEdit::finish(std::string what) const {
    if (!faults_.empty()) return faults_.front();
    syntax::TextEdit edit;
    edit.what = std::move(what);
    if (definition_->isShort && !(newComponents_.empty() && newConnections_.empty())) {
        writeLongClass(edit.replacements);
        edit.normalise();
        return edit;
    }
    writeComponents(edit.replacements);
    writeInherited(edit.replacements);
    writeNewComponents(edit.replacements);
    writeConnections(edit.replacements);
    writeNewConnections(edit.replacements);
    writeReplaced(edit.replacements);
    writeRenames(edit.replacements);
    edit.normalise();
    return edit;
}

std::string freeName(const ClassDefinition& definition, const std::string& base) {
    std::set<std::string> taken{definition.name};
    for (const Component& c : definition.components) taken.insert(c.name);
    for (const syntax::ClassPtr& c : definition.classes) taken.insert(c->name);
    for (const syntax::Import& i : definition.imports) taken.insert(i.alias);
    if (!taken.contains(base) && !syntax::isKeyword(base)) return base;
    for (int number = 1;; ++number) {
        const std::string name = fmt::format("{}{}", base, number);
        if (!taken.contains(name)) return name;
    }
}

namespace {

struct Box {
    double left, bottom, right, top;

    bool overlaps(const Box& o) const { return left < o.right && o.left < right && bottom < o.top && o.bottom < top; }
    Box grown(double by) const { return {left - by, bottom - by, right + by, top + by}; }
};

Box boxOf(const Placement& placement) {
    const Extent unit{{-1, -1}, {1, 1}};
    Box box{1e300, 1e300, -1e300, -1e300};
    for (const Point corner : {Point{-1, -1}, Point{1, -1}, Point{1, 1}, Point{-1, 1}}) {
        const Point p = map(placement, unit, corner);
        box = {std::min(box.left, p.x), std::min(box.bottom, p.y), std::max(box.right, p.x), std::max(box.top, p.y)};
    }
    return box;
}

}  // namespace

Placement freePlacement(const Diagram& diagram, Point near, double width, double height) {
    constexpr double grid = 10, gap = 9;  // a little under the grid: blocks may stand one step apart
    std::vector<Box> taken;
    for (const Block& block : diagram.blocks) taken.push_back(boxOf(block.placement).grown(gap));
    std::vector<Box> wires;
    for (const Wire& wire : diagram.wires)
        for (std::size_t i = 1; i < wire.points.size(); ++i) {
            const Point a = wire.points[i - 1], b = wire.points[i];
            wires.push_back(
                {std::min(a.x, b.x) - 1, std::min(a.y, b.y) - 1, std::max(a.x, b.x) + 1, std::max(a.y, b.y) + 1});
        }
    const auto count = [](const std::vector<Box>& boxes, const Box& box) {
        return std::count_if(boxes.begin(), boxes.end(), [&](const Box& b) { return b.overlaps(box); });
    };
    // Best to the lower right: a wire from the point goes down and then into a port on the block's left side.
    const Point start{std::round((near.x + width) / grid) * grid, std::round((near.y - 1.5 * height) / grid) * grid};
    const auto wayTo = [&](Point c) {
        return Box{near.x - 1, std::min(near.y, c.y), near.x + 1, std::max(near.y, c.y)};
    };
    const auto blocksOnWay = [&](Point c) {
        const Box way = wayTo(c);
        return std::count_if(diagram.blocks.begin(), diagram.blocks.end(), [&](const Block& b) {
            const Box box = boxOf(b.placement);
            const bool startsThere = box.grown(1).overlaps({near.x - 0.1, near.y - 0.1, near.x + 0.1, near.y + 0.1});
            return !startsThere && box.overlaps(way);
        });
    };
    Placement best{{{start.x - width / 2, start.y - height / 2}, {start.x + width / 2, start.y + height / 2}}, {}, 0};
    double bestCost = 1e300;
    constexpr int reach = 30;  // grid steps
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
            const Point c{start.x + grid * i, start.y + grid * j};
            const Box box{c.x - width / 2, c.y - height / 2, c.x + width / 2, c.y + height / 2};
            if (count(taken, box) > 0) continue;
            // Covering a wire, or leading the new one through a block, is worth some steps more.
            double cost = std::hypot(i, j) + 6.0 * static_cast<double>(count(wires, box));
            if (cost >= bestCost) continue;
            cost += 6.0 * static_cast<double>(blocksOnWay(c));
            if (cost < bestCost) {
                bestCost = cost;
                best.extent = {{box.left, box.bottom}, {box.right, box.top}};
            }
        }
    return best;
}

}  // namespace analogon
