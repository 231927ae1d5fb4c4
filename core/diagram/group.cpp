#include "core/diagram/group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/diagram/edit.hpp"
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

bool holdsConnection(const Equation& e) {
    if (e.kind == Equation::Kind::Connect) return true;
    const auto any = [](const std::vector<Equation>& body) {
        return std::any_of(body.begin(), body.end(), holdsConnection);
    };
    return any(e.body) ||
           std::any_of(e.branches.begin(), e.branches.end(), [&](const auto& branch) { return any(branch.body); });
}

std::string withoutBlanks(std::string_view text) {
    std::string result(text);
    std::erase_if(result, [](unsigned char c) { return std::isspace(c); });
    return result;
}

std::string firstPart(const std::string& connector) { return connector.substr(0, connector.find_first_of(".[")); }

double onGrid(double value) { return 10 * std::round(value / 10); }

struct Box {
    Point low{1e300, 1e300}, high{-1e300, -1e300};

    void include(Point p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    Point centre() const { return {onGrid((low.x + high.x) / 2), onGrid((low.y + high.y) / 2)}; }
};

/// A connector at the border of the new class.
struct Border {
    std::string inside;  // "body.port"
    std::string name, className, modifications;
    bool isLeft{};
    double height{};      // of what it leads to
    Placement placement;  // in the diagram of the new class
    double iconHeight{};  // -100 … 100
};

class Grouping {
public:
    Grouping(const Library& library, const Diagram& diagram, const ClassDefinition& definition, const Group& group)
        : library_(library),
          diagram_(diagram),
          definition_(definition),
          group_(group),
          text_(definition.source->text()),
          newline_(edit_text::lineEnd(text_)),
          indent_(edit_text::indentation(text_, definition.span.begin)),
          inside_(group.components.begin(), group.components.end()) {}

    Outcome<syntax::TextEdit> make(std::string what) {
        if (Diagnostics faults = check(); !faults.empty()) return faults;
        if (Diagnostics faults = findBorders(); !faults.empty()) return faults;
        placeBorders();
        const Outcome<std::string> inner = innerClass();
        if (!inner) return inner.diagnostics();
        const Outcome<std::string> whole = outerClass(*inner);
        if (!whole) return whole.diagnostics();
        return difference(*whole, std::move(what));
    }

private:
    Diagnostic fault(const Text& text, const Text& hint = {}) const { return error(text, definition_.nameSpan, hint); }

    bool isInside(const std::string& component) const { return inside_.contains(component); }

    /// What the components are made of may move.
    Diagnostics check() const {
        if (definition_.isShort || inside_.empty()) return {fault(phrase("there is nothing to be grouped"))};
        for (const std::string& name : group_.components) {
            const Block* block = diagram_.find(name);
            const auto declared = std::find_if(definition_.components.begin(), definition_.components.end(),
                                               [&](const Component& c) { return c.name == name; });
            if (!block || declared == definition_.components.end())
                return {fault(phrase("{} is not declared in {} itself", name, definition_.name))};
            if (block->isConnector) return {fault(phrase("{} is a connector of the model and stays outside", name))};
            FirstNames names;
            names.visit(*declared);
            for (const syntax::Name* used : names.found) {
                const std::string first = used->parts.front().identifier;
                if (isInside(first) || first == "time" || library_.lookup(used->text(), diagram_.className) ||
                    library_.lookup(first, diagram_.className))
                    continue;
                return {fault(phrase("{} refers to {}, which would stay outside", name, used->text()),
                              phrase("write the value itself, or move both"))};
            }
        }
        for (const syntax::EquationSection& section : definition_.equationSections)
            for (const Equation& e : section.equations) {
                if (e.kind == Equation::Kind::Connect || !holdsConnection(e)) continue;
                FirstNames names;
                names.visit(e);
                for (const syntax::Name* used : names.found)
                    if (isInside(used->parts.front().identifier))
                        return {fault(phrase("{} is connected within an if or a for", used->parts.front().identifier))};
            }
        return {};
    }

    template <class Visit>
    void eachConnection(const Visit& visit) const {
        for (const syntax::EquationSection& section : definition_.equationSections)
            for (const Equation& e : section.equations)
                if (e.kind == Equation::Kind::Connect)
                    visit(e, withoutBlanks(e.left.span.text()), withoutBlanks(e.right.span.text()));
    }

    Diagnostics findBorders() {
        Diagnostics faults;
        for (const std::string& name : group_.components) {
            const Block* block = diagram_.find(name);
            for (const Point corner : {Point{-1, -1}, Point{1, -1}, Point{1, 1}, Point{-1, 1}})
                box_.include(map(block->placement, {{-1, -1}, {1, 1}}, corner));
        }
        std::set<std::string> taken = inside_;
        taken.insert(group_.className);
        eachConnection([&](const Equation&, const std::string& left, const std::string& right) {
            const bool leftIn = isInside(firstPart(left)), rightIn = isInside(firstPart(right));
            if (leftIn == rightIn) return;
            const std::string& own = leftIn ? left : right;
            const std::string& other = leftIn ? right : left;
            if (std::any_of(borders_.begin(), borders_.end(), [&](const Border& b) { return b.inside == own; })) return;
            const Block* block = diagram_.find(firstPart(own));
            const auto port = std::find_if(block->ports.begin(), block->ports.end(),
                                           [&](const Port& p) { return block->name + "." + p.name == own; });
            if (port == block->ports.end()) {
                faults.push_back(fault(phrase("{} is no plain connector", own), phrase("leave its block outside")));
                return;
            }
            Border border{own, port->name, port->className, units(*block, port->name), true, 0, {}, 0};
            for (int i = 1; !taken.insert(border.name).second; ++i) border.name = fmt::format("{}{}", port->name, i);
            const Point at = diagram_.anchor(own).value_or(box_.centre());
            border.isLeft = diagram_.anchor(other).value_or(at).x < box_.centre().x;
            border.height = at.y;
            borders_.push_back(std::move(border));
        });
        return faults;
    }

    /// The units a connector is declared with, which may be those of one block alone.
    std::string units(const Block& block, const std::string& port) const {
        std::vector<const LibraryClass*> classes{library_.find(block.className)};
        for (std::size_t i = 0; i < classes.size() && classes[i]; ++i) {
            for (const Component& c : classes[i]->definition->components) {
                if (c.name != port) continue;
                std::string list;
                for (const Modification& m : c.modifications)
                    if (m.value && m.value->kind == Expression::Kind::String)
                        list += (list.empty() ? "" : ", ") + std::string(m.span.text());
                return list.empty() ? list : "(" + list + ")";
            }
            for (const LibraryClass* base : library_.bases(*classes[i])) classes.push_back(base);
        }
        return {};
    }

    /// On the side of what they lead to, each as high as what it belongs to; where that is too close, the upper one is
    /// moved up: signals leave blocks at the top.
    void placeBorders() {
        constexpr double least = 30;
        std::stable_sort(borders_.begin(), borders_.end(),
                         [](const Border& a, const Border& b) { return a.height < b.height; });
        for (const bool isLeft : {true, false}) {
            const auto count =
                std::count_if(borders_.begin(), borders_.end(), [&](const Border& b) { return b.isLeft == isLeft; });
            double highest = -1e300;
            int index = 0;
            for (Border& b : borders_) {
                if (b.isLeft != isLeft) continue;
                b.iconHeight = 200 * (index++ + 0.5) / static_cast<double>(count) - 100;
                const double x = isLeft ? onGrid(box_.low.x) - 50 : onGrid(box_.high.x) + 50;
                const double y = std::max(onGrid(b.height), highest + least);
                highest = y;
                b.placement.extent = {{x - 10, y - 10}, {x + 10, y + 10}};
            }
        }
    }

    std::string frame() const {
        Box all;
        for (const Border& b : borders_) {
            all.include(b.placement.extent.p1);
            all.include(b.placement.extent.p2);
        }
        all.include({onGrid(box_.low.x) - 60, onGrid(box_.low.y) - 20});
        all.include({onGrid(box_.high.x) + 60, onGrid(box_.high.y) + 20});
        return fmt::format("{{{{{:g},{:g}}},{{{:g},{:g}}}}}", all.low.x, all.low.y, all.high.x, all.high.y);
    }

    static std::string extentText(double x, double y, double half) {
        return fmt::format("{{{{{:g},{:g}}},{{{:g},{:g}}}}}", x - half, y - half, x + half, y + half);
    }

    /// The components word for word, and the connections among them.
    std::string innerText() const {
        std::string text = indent_ + "model " + group_.className + newline_;
        for (const syntax::Import& i : definition_.imports) {
            text += indent_ + "  " + std::string(i.span.text());
            text += (text.ends_with(';') ? "" : ";") + newline_;
        }
        for (const Border& b : borders_)
            text += fmt::format(
                "{}  {} {}{} annotation (Placement(transformation(extent={}), iconTransformation(extent={})));{}",
                indent_, b.className, b.name, b.modifications,
                extentText((b.placement.extent.p1.x + b.placement.extent.p2.x) / 2,
                           (b.placement.extent.p1.y + b.placement.extent.p2.y) / 2, 10),
                extentText(b.isLeft ? -100 : 100, b.iconHeight, 10), newline_);
        for (const Component& c : definition_.components) {
            if (!isInside(c.name)) continue;
            const std::string prefix(text_.substr(c.clauseSpan.begin, c.typeSpan.end - c.clauseSpan.begin));
            text += indent_ + "  " + prefix + " " + std::string(c.span.text()) + ";" + newline_;
        }
        text += indent_ + "equation" + newline_;
        eachConnection([&](const Equation& e, const std::string& left, const std::string& right) {
            if (!isInside(firstPart(left)) || !isInside(firstPart(right))) return;
            std::string line(e.span.text());
            text += indent_ + "  " + line + (line.ends_with(';') ? "" : ";") + newline_;
        });
        const std::string head = indent_ + "  annotation (";
        const std::string next = newline_ + std::string(head.size(), ' ');
        text += head + "Icon(graphics={Rectangle(extent={{-100,100},{100,-100}}, lineColor={95,95,95}, " +
                "fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10)," + next +
                "Text(extent={{-150,150},{150,110}}, textColor={0,0,255}, textString=\"%name\")})," + next +
                "Diagram(coordinateSystem(extent=" + frame() + ")));" + newline_;
        return text + indent_ + "end " + group_.className + ";" + newline_;
    }

    std::string scope() const {
        const LibraryClass* cls = library_.find(diagram_.className);
        return cls ? cls->scope : std::string();
    }

    /// The whole text of the new class, read once without the wires to the border so that these find their ends.
    Outcome<std::string> innerClass() {
        const std::string within = scope().empty() ? std::string() : "within " + scope() + ";\n";
        const auto source = std::make_shared<const Source>("group.mo", within + innerText());
        Outcome<Library> library = library_.withSource(source);
        if (!library) return library.diagnostics();
        grouped_ = std::move(*library);
        const std::string name = scope().empty() ? group_.className : scope() + "." + group_.className;
        const LibraryClass* cls = grouped_.find(name);
        const Outcome<Diagram> diagram = readDiagram(grouped_, name);
        if (!cls || !diagram) return fault(phrase("the components cannot be put into {}", group_.className));
        for (const Block& block : diagram->blocks)
            if (!block.isResolved)
                return fault(phrase("the class of {} is only known within {}", block.name, definition_.name));
        ModelEdit edit(*cls->definition, &*diagram, &grouped_);
        for (const Border& b : borders_)
            edit.addConnection(b.inside, b.name, {}, domainColour(diagram->domain(b.inside)));
        const Outcome<syntax::TextEdit> change = edit.finish("wires to the border");
        if (!change) return change.diagnostics();
        return syntax::apply(source->text(), *change).text.substr(within.size());
    }

    /// The file with the new class in it and the components taken out.
    Outcome<std::string> outerClass(const std::string& inner) const {
        NewComponent component;
        component.className = group_.className;
        component.name = group_.instance;
        const Point c = box_.centre();
        constexpr double half = 20;
        component.placement.extent = {{c.x - half, c.y - half}, {c.x + half, c.y + half}};
        ModelEdit edit(definition_, &diagram_, &grouped_);
        edit.addComponent(component);
        const auto outer = [&](const std::string& end) {
            for (const Border& b : borders_)
                if (b.inside == end) return group_.instance + "." + b.name;
            return end;
        };
        eachConnection([&](const Equation&, const std::string& left, const std::string& right) {
            const bool leftIn = isInside(firstPart(left)), rightIn = isInside(firstPart(right));
            if (leftIn == rightIn) return;
            edit.addConnection(outer(left), outer(right), {}, domainColour(diagram_.domain(leftIn ? left : right)));
        });
        Outcome<syntax::TextEdit> added = edit.finish("add");
        if (!added) return added.diagnostics();
        followReferences(added->replacements);
        std::uint32_t end = definition_.span.end;
        if (const std::size_t sign = text_.find(';', end); sign != std::string::npos)
            end = static_cast<std::uint32_t>(sign) + 1;
        added->replacements.push_back(
            {end, end, newline_ + newline_ + inner.substr(0, inner.find_last_not_of("\r\n") + 1)});
        added->normalise();
        const std::string text = syntax::apply(text_, *added).text;

        const auto parsed = syntax::parse(std::make_shared<const Source>(definition_.source->name(), text));
        const ClassDefinition* again = hasError(parsed.diagnostics) ? nullptr : same(parsed.definition.classes);
        if (!again) return fault(phrase("the components cannot be put into {}", group_.className));
        ModelEdit removal(*again);
        for (const std::string& name : group_.components) removal.removeComponent(name);
        const Outcome<syntax::TextEdit> removed = removal.finish("remove");
        if (!removed) return removed.diagnostics();
        return syntax::apply(text, *removed).text;
    }

    /// The class that stands where this one stood.
    const ClassDefinition* same(const std::vector<syntax::ClassPtr>& classes) const {
        for (const syntax::ClassPtr& c : classes) {
            if (c->span.begin == definition_.span.begin) return c.get();
            if (const ClassDefinition* inner = same(c->classes)) return inner;
        }
        return nullptr;
    }

    /// "body.T" of an equation that stays outside becomes "group.body.T".
    void followReferences(std::vector<Replacement>& edits) const {
        FirstNames names;
        for (const Component& c : definition_.components)
            if (!isInside(c.name)) names.visit(c);
        for (const syntax::Extends& base : definition_.bases)
            for (const Modification& m : base.modifications) names.visit(m);
        for (const auto* sections : {&definition_.equationSections, &definition_.algorithmSections})
            for (const syntax::EquationSection& section : *sections)
                for (const Equation& e : section.equations)
                    if (e.kind != Equation::Kind::Connect) names.visit(e);
        for (const syntax::Name* used : names.found)
            if (isInside(used->parts.front().identifier)) {
                const std::uint32_t at = used->parts.front().span.begin;
                edits.push_back({at, at, group_.instance + "."});
            }
    }

    /// The one replacement that tells both texts apart.
    syntax::TextEdit difference(const std::string& text, std::string what) const {
        const std::size_t shorter = std::min(text_.size(), text.size());
        std::size_t front = 0, back = 0;
        while (front < shorter && text_[front] == text[front]) ++front;
        while (back < shorter - front && text_[text_.size() - 1 - back] == text[text.size() - 1 - back]) ++back;
        syntax::TextEdit edit;
        edit.what = std::move(what);
        edit.replacements.push_back({static_cast<std::uint32_t>(front), static_cast<std::uint32_t>(text_.size() - back),
                                     text.substr(front, text.size() - back - front)});
        return edit;
    }

    const Library& library_;
    const Diagram& diagram_;
    const ClassDefinition& definition_;
    const Group& group_;
    const std::string& text_;
    std::string newline_, indent_;
    std::set<std::string> inside_;
    Box box_;
    std::vector<Border> borders_;
    Library grouped_;  // with the new class in it
};

}  // namespace

Outcome<syntax::TextEdit> groupComponents(const Library& library, const Diagram& diagram,
                                          const ClassDefinition& definition, const Group& group, std::string what) {
    return Grouping(library, diagram, definition, group).make(std::move(what));
}

}  // namespace analogon
