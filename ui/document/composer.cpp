#include "ui/document/composer.hpp"

#include <QObject>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "core/diagram/group.hpp"
#include "core/fit/clock.hpp"
#include "core/syntax/parser.hpp"
#include "ui/document/connector.hpp"
#include "ui/document/document.hpp"
#include "ui/document/insertion.hpp"
#include "ui/route/bend.hpp"
#include "ui/route/route.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr double grid = 10, blockSize = 20;  // [diagram units]

QString tr(const char* text) { return QObject::tr(text); }
QString qString(const std::string& text) { return QString::fromStdString(text); }

double snapped(double value) { return std::round(value / grid) * grid; }

/// With its centre as origin, about which it turns.
Placement centred(const Placement& p) {
    const auto [low, high] = boxOf(p);
    const Point centre{(low.x + high.x) / 2, (low.y + high.y) / 2};
    const double width = (p.extent.p2.x - p.extent.p1.x) / 2, height = (p.extent.p2.y - p.extent.p1.y) / 2;
    Placement result = p;
    result.origin = centre;
    result.extent = {{-width, -height}, {width, height}};
    return result;
}

/// Unturned again: without an origin, as a person would write it.
Placement plain(Placement p) {
    p.rotation = std::fmod(std::fmod(p.rotation, 360) + 360, 360);
    if (p.rotation != 0) return p;
    const Point origin = p.origin;
    p.origin = {};
    return shifted(p, origin.x, origin.y);
}

QString domainName(Domain domain) {
    switch (domain) {
        case Domain::Rotational:
            return tr("a flange");
        case Domain::Translational:
            return tr("a translational flange");
        case Domain::Electrical:
            return tr("an electrical pin");
        case Domain::Heat:
            return tr("a heat port");
        case Domain::RealInput:
            return tr("a signal input");
        case Domain::RealOutput:
            return tr("a signal output");
        case Domain::Other:
            break;
    }
    return tr("a connector of another kind");
}

/// `name = value` pairs of a modification as NewComponent takes them.
void collectModifications(const syntax::Modification& m, const std::string& prefix,
                          std::vector<std::pair<std::string, std::string>>& result) {
    const std::string name = prefix + m.name.text();
    if (m.redeclaredClass || m.redeclaredComponent) {
        // "redeclare model M" and "N": NewComponent joins both with the sign it was cut at.
        const std::string text(m.span.text());
        const auto sign = text.find('=');
        if (sign != std::string::npos) result.emplace_back(text.substr(0, sign), text.substr(sign + 1));
        return;
    }
    for (const syntax::Modification& inner : m.arguments) collectModifications(inner, name + ".", result);
    if (m.value) result.emplace_back(name, std::string(m.value->span.text()));
}

}  // namespace

bool isModelicaName(const std::string& name) {
    static const std::set<std::string> keywords{
        "algorithm",   "and",       "annotation",   "block",     "break",    "class",  "connect",  "connector",
        "constant",    "der",       "discrete",     "each",      "else",     "elseif", "elsewhen", "encapsulated",
        "end",         "equation",  "expandable",   "extends",   "external", "false",  "final",    "flow",
        "for",         "function",  "if",           "import",    "impure",   "in",     "initial",  "inner",
        "input",       "loop",      "model",        "not",       "operator", "or",     "outer",    "output",
        "package",     "parameter", "partial",      "protected", "public",   "pure",   "record",   "redeclare",
        "replaceable", "return",    "stream",       "then",      "true",     "type",   "when",     "while",
        "within",      "time",      "constrainedby"};
    if (name.empty() || keywords.contains(name)) return false;
    if (!std::isalpha(static_cast<unsigned char>(name.front())) && name.front() != '_') return false;
    return std::all_of(name.begin(), name.end(),
                       [](unsigned char c) { return c < 0x80 && (std::isalnum(c) || c == '_'); });
}

std::string baseName(const std::string& className) {
    std::string last = className.substr(className.rfind('.') + 1);
    if (last == "RealInput") return "u";
    if (last == "RealOutput") return "y";
    for (const char* prefix : {"Basic", "Prescribed"})
        if (last.starts_with(prefix) && last.size() > std::string(prefix).size())
            last = last.substr(std::string(prefix).size());
    last[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(last[0])));
    return isModelicaName(last) ? last : "block";
}

bool Composer::isReady() {
    fault_.clear();
    if (document_.definition()) return true;
    fault_ = tr("The model's text has a fault: mend it first, then the diagram can be changed.");
    return false;
}

bool Composer::apply(const Outcome<syntax::TextEdit>& edit) {
    if (!edit) {
        fault_ = inWords(edit.diagnostics().front().message);
        return false;
    }
    document_.applyEdit(*edit);
    return true;
}

/// The shown class is this one, or is used somewhere in it.
bool Composer::wouldHoldItself(const LibraryClass& cls, int depth) const {
    constexpr int deepest = 20;
    if (cls.qualifiedName == document_.shownClass() || depth > deepest) return true;
    return std::any_of(cls.definition->components.begin(), cls.definition->components.end(), [&](const auto& c) {
        const LibraryClass* type = document_.library().lookup(c.type, cls.qualifiedName);
        const bool isOwn = type && type->definition->source == document_.definition()->source;
        return isOwn && wouldHoldItself(*type, depth + 1);
    });
}

/// An edit of the text together with the settings of the study that speak of what it moves: `rename` gives the name
/// that a component's part has afterwards, within the class that is shown; empty: it is gone.
bool Composer::applyWith(const Outcome<syntax::TextEdit>& edit, const std::function<std::string(std::string)>& rename) {
    if (!edit) return apply(edit);
    StudySettings settings = document_.settings();
    bool touchesSettings = false;
    const std::vector<std::string> prefixes = document_.prefixes();
    const auto renamedPart = [&](const std::string& key) {
        for (const std::string& prefix : prefixes) {
            if (!key.starts_with(prefix)) continue;
            const std::string inner = key.substr(prefix.size()), fresh = rename(inner);
            if (fresh != inner) return fresh.empty() ? fresh : prefix + fresh;
        }
        return key;
    };
    const auto renamed = [&](const std::string& key) {
        if (!isClock(key)) return renamedPart(key);
        const std::string output = renamedPart(signalOfClock(key));  // a clock is named after its output
        return output.empty() ? output : clockOf(output);
    };
    const auto rekey = [&](auto& named) {
        std::remove_reference_t<decltype(named)> fresh;
        for (auto& [key, value] : named) {
            const std::string now = renamed(key);
            touchesSettings = touchesSettings || now != key;
            if (!now.empty()) fresh[now] = value;
        }
        named = std::move(fresh);
    };
    rekey(settings.parameters);
    for (StudyExperiment& experiment : settings.experiments) {
        rekey(experiment.inputs);
        rekey(experiment.outputs);
        rekey(experiment.initial);
    }
    if (!touchesSettings) return apply(edit);
    document_.applyBoth(*edit, std::move(settings));
    return true;
}

/// A block of this class as it would be declared around a point; nothing (fault() says why) when it cannot be.
std::optional<Block> Composer::newBlock(const std::string& className, Point centre) {
    if (!isReady()) return std::nullopt;
    const LibraryClass* cls = document_.library().find(className);
    if (!cls) {
        fault_ = tr("There is no class %1.").arg(qString(className));
        return std::nullopt;
    }
    if (cls->definition->isPartial) {
        fault_ = tr("%1 is only a base for other classes and cannot be placed.").arg(qString(className));
        return std::nullopt;
    }
    if (wouldHoldItself(*cls)) {
        fault_ = tr("A model cannot hold itself.");
        return std::nullopt;
    }
    Block block;
    block.name = freeName(*document_.definition(), baseName(className));
    block.className = className;
    const double x = snapped(centre.x), y = snapped(centre.y);
    block.placement.extent = {{x - blockSize / 2, y - blockSize / 2}, {x + blockSize / 2, y + blockSize / 2}};
    block.icon = readIcon(document_.library(), className);
    block.ports = readPorts(document_.library(), className);
    return block;
}

std::string Composer::declare(const std::string& className, Point centre, bool isDropped) {
    const std::optional<Block> block = newBlock(className, centre);
    if (!block) return {};
    NewComponent component;
    component.className = className;
    component.name = block->name;
    component.placement = block->placement;
    if (isDropped) {
        Diagram after = document_.diagram();
        after.blocks.push_back(*block);
        ModelEdit edit(*document_.definition(), &after, &document_.library());
        edit.addComponent(component);
        if (insert(*block, edit, after)) return component.name;
    }
    ModelEdit edit(*document_.definition(), &document_.diagram(), &document_.library());
    edit.addComponent(component);
    return apply(edit.finish(tr("Place %1").arg(qString(component.name)).toStdString())) ? component.name
                                                                                         : std::string();
}

std::string Composer::addBlock(const std::string& className, Point centre) { return declare(className, centre, false); }

std::string Composer::dropBlock(const std::string& className, Point centre) { return declare(className, centre, true); }

/// What becomes of the wires where a block stands; only wires that the shown class connects itself can be parted.
std::optional<Insertion> Composer::insertion(const Block& block) const {
    if (!document_.definition()) return std::nullopt;
    std::optional<Insertion> found = insertionAt(document_.diagram(), block);
    if (!found) return std::nullopt;
    const Span& own = document_.definition()->span;
    for (const Wire& wire : document_.diagram().wires) {
        const bool isOwn = wire.span.source == own.source && wire.span.begin >= own.begin && wire.span.end <= own.end;
        const bool isParted =
            std::find(found->parted.begin(), found->parted.end(), WireEnds{wire.from, wire.to}) != found->parted.end();
        if (isParted && !isOwn) return std::nullopt;
    }
    return found;
}

/// Adds to an edit that places a block how it is led into the connection it lies on, and makes the edit; false:
/// nothing was done, as it lies on none, or does not fit.
bool Composer::insert(const Block& block, ModelEdit& edit, const Diagram& after) {
    const std::optional<Insertion> wires = insertion(block);
    if (!wires) return false;
    for (const WireEnds& wire : wires->parted) edit.removeConnection(wire.from, wire.to);
    for (const WireEnds& wire : wires->laid)
        edit.addConnection(wire.from, wire.to, routeWire(after, wire.from, wire.to),
                           domainColour(after.domain(wire.from)));
    const Outcome<syntax::TextEdit> done =
        edit.finish(tr("Insert %1 between %2 and %3")
                        .arg(qString(block.name), qString(wires->between.from), qString(wires->between.to))
                        .toStdString());
    return done && apply(done);  // a connection of a loop stays as it is
}

std::vector<WireEnds> Composer::partedByDrop(const std::string& className, Point centre) {
    const std::optional<Block> block = newBlock(className, centre);
    const std::optional<Insertion> wires = block ? insertion(*block) : std::nullopt;
    return wires ? wires->parted : std::vector<WireEnds>();
}

std::vector<WireEnds> Composer::partedByMove(const std::vector<std::string>& blocks, double dx, double dy) const {
    const Block* block = blocks.size() == 1 ? document_.diagram().find(blocks.front()) : nullptr;
    if (!block) return {};
    Block there = *block;
    there.placement = shifted(there.placement, dx, dy);
    const std::optional<Insertion> wires = insertion(there);
    return wires ? wires->parted : std::vector<WireEnds>();
}

QString Composer::refusal(const std::string& from, const std::string& to) const {
    const Diagram& diagram = document_.diagram();
    if (from == to) return tr("A connector cannot be connected with itself.");
    const Domain a = diagram.domain(from), b = diagram.domain(to);
    for (const Wire& wire : diagram.wires)
        if ((wire.from == from && wire.to == to) || (wire.from == to && wire.to == from))
            return tr("%1 and %2 are connected already.").arg(qString(from), qString(to));
    if (isSignal(a) != isSignal(b) || (!isSignal(a) && a != b))
        return tr("%1 is %2, %3 is %4: they do not fit.").arg(qString(from), domainName(a), qString(to), domainName(b));
    if (a == Domain::Other && connectorClass(diagram, from) != connectorClass(diagram, to))
        return tr("%1 and %2 are connectors of different classes.").arg(qString(from), qString(to));
    if (!isSignal(a)) return {};
    const bool fromGives = isSource(diagram, from), toGives = isSource(diagram, to);
    if (fromGives && toGives)
        return tr("Both %1 and %2 give a signal: one must take it.").arg(qString(from), qString(to));
    if (!fromGives && !toGives)
        return tr("Neither %1 nor %2 gives a signal: one must be a source.").arg(qString(from), qString(to));
    const std::string& sink = fromGives ? to : from;
    for (const Wire& wire : diagram.wires)
        if (wire.from == sink || wire.to == sink)
            return tr("%1 gets a signal already: an input takes one only.").arg(qString(sink));
    return {};
}

std::string Composer::signalClassFor(const std::string& connector) const {
    const Diagram& diagram = document_.diagram();
    const Domain domain = diagram.domain(connector);
    if (!isSignal(domain) || instanceOf(connector) == connector) return {};
    if (domain == Domain::RealOutput) return "Analogon.Interfaces.RealOutput";
    const bool isTaken = std::any_of(diagram.wires.begin(), diagram.wires.end(),
                                     [&](const Wire& wire) { return wire.from == connector || wire.to == connector; });
    return isTaken ? std::string() : "Analogon.Interfaces.RealInput";
}

bool Composer::addWire(const std::string& from, const std::string& to, const std::vector<Point>& points) {
    if (!isReady()) return false;
    fault_ = refusal(from, to);
    if (!fault_.isEmpty()) return false;
    const Domain domain = document_.diagram().domain(from);
    ModelEdit edit(*document_.definition(), &document_.diagram(), &document_.library());
    edit.addConnection(from, to, points.empty() ? routeWire(document_.diagram(), from, to) : points,
                       domainColour(domain));
    return apply(edit.finish(tr("Connect %1 with %2").arg(qString(from), qString(to)).toStdString()));
}

bool Composer::lead(const WireEnds& wire, const std::vector<Point>& way) {
    if (!isReady() || way.size() < 2) return false;
    ModelEdit edit(*document_.definition(), &document_.diagram(), &document_.library());
    edit.setLine(wire.from, wire.to, way);
    return apply(
        edit.finish(tr("Lead the wire from %1 to %2").arg(qString(wire.from), qString(wire.to)).toStdString()));
}

bool Composer::remove(const DiagramSelection& selection) {
    if (!isReady() || selection.isEmpty()) return false;
    ModelEdit edit(*document_.definition(), &document_.diagram(), &document_.library());
    const auto isGone = [&](const std::string& name) {
        return std::find(selection.blocks.begin(), selection.blocks.end(), instanceOf(name)) != selection.blocks.end();
    };
    for (const std::string& block : selection.blocks) edit.removeComponent(block);
    for (const WireEnds& wire : selection.wires)
        if (!isGone(wire.from) && !isGone(wire.to)) edit.removeConnection(wire.from, wire.to);
    const QString what = selection.blocks.size() == 1 ? tr("Delete %1").arg(qString(selection.blocks.front()))
                         : selection.blocks.empty()   ? tr("Delete wires")
                                                      : tr("Delete %1 blocks").arg(selection.blocks.size());
    return applyWith(edit.finish(what.toStdString()),
                     [&](const std::string& part) { return isGone(part) ? std::string() : part; });
}

Diagram Composer::moved(const Diagram& diagram, const std::vector<std::string>& blocks, double dx, double dy) {
    return MovedBlocks(diagram, {blocks.begin(), blocks.end()}).at(dx, dy);
}

bool Composer::move(const std::vector<std::string>& blocks, double dx, double dy) {
    if (!isReady() || blocks.empty() || (dx == 0 && dy == 0)) return false;
    const Diagram& diagram = document_.diagram();
    const Diagram after = moved(diagram, blocks, dx, dy);
    ModelEdit edit(*document_.definition(), &after, &document_.library());
    for (const std::string& name : blocks)
        if (const Block* block = after.find(name)) edit.setPlacement(name, block->placement);
    for (std::size_t i = 0; i < diagram.wires.size(); ++i) {
        const Wire& wire = after.wires[i];
        if (wire.points != diagram.wires[i].points) edit.setLine(wire.from, wire.to, wire.points);
    }
    const QString what =
        blocks.size() == 1 ? tr("Move %1").arg(qString(blocks.front())) : tr("Move %1 blocks").arg(blocks.size());
    return apply(edit.finish(what.toStdString()));
}

bool Composer::drop(const std::vector<std::string>& blocks, double dx, double dy) {
    if (!isReady() || blocks.empty() || (dx == 0 && dy == 0)) return false;
    if (!partedByMove(blocks, dx, dy).empty()) {
        const Diagram after = moved(document_.diagram(), blocks, dx, dy);
        const Block& block = *after.find(blocks.front());
        ModelEdit edit(*document_.definition(), &after, &document_.library());
        edit.setPlacement(block.name, block.placement);
        if (insert(block, edit, after)) return true;
    }
    return move(blocks, dx, dy);
}

/// New placements, with every wire at these blocks led anew.
bool Composer::place(const std::vector<std::pair<std::string, Placement>>& placements, const QString& what) {
    if (placements.empty()) return false;
    Diagram after = document_.diagram();
    std::set<std::string> names;
    for (const auto& [name, placement] : placements) {
        names.insert(name);
        for (Block& block : after.blocks)
            if (block.name == name) block.placement = placement;
    }
    ModelEdit edit(*document_.definition(), &after, &document_.library());
    for (const auto& [name, placement] : placements) edit.setPlacement(name, placement);
    for (const Wire& wire : after.wires) {
        if (!names.contains(instanceOf(wire.from)) && !names.contains(instanceOf(wire.to))) continue;
        const auto a = after.anchor(wire.from), b = after.anchor(wire.to);
        if (a && b) edit.setLine(wire.from, wire.to, routeWire(after, wire.from, wire.to));
    }
    return apply(edit.finish(what.toStdString()));
}

bool Composer::rotate(const std::vector<std::string>& blocks) {
    if (!isReady()) return false;
    std::vector<std::pair<std::string, Placement>> placements;
    for (const std::string& name : blocks)
        if (const Block* block = document_.diagram().find(name)) {
            Placement p = centred(block->placement);
            p.rotation += 90;
            placements.emplace_back(name, plain(p));
        }
    return place(placements, tr("Rotate"));
}

bool Composer::flip(const std::vector<std::string>& blocks, bool isHorizontal) {
    if (!isReady()) return false;
    std::vector<std::pair<std::string, Placement>> placements;
    for (const std::string& name : blocks)
        if (const Block* block = document_.diagram().find(name)) {
            Placement p = centred(block->placement);
            const bool isUpright = std::abs(std::remainder(p.rotation, 180)) < 45;
            if (isUpright == isHorizontal)
                std::swap(p.extent.p1.x, p.extent.p2.x);
            else
                std::swap(p.extent.p1.y, p.extent.p2.y);
            placements.emplace_back(name, plain(p));
        }
    return place(placements, isHorizontal ? tr("Flip left to right") : tr("Flip upside down"));
}

bool Composer::rename(const std::string& block, const std::string& name) {
    if (!isReady() || block == name) return false;
    if (!isModelicaName(name)) {
        fault_ = tr("\"%1\" is no name: letters, digits and _ only, no digit first, no keyword.").arg(qString(name));
        return false;
    }
    if (freeName(*document_.definition(), name) != name) {
        fault_ = tr("The name \"%1\" is taken.").arg(qString(name));
        return false;
    }
    ModelEdit edit(*document_.definition(), &document_.diagram(), &document_.library());
    edit.renameComponent(block, name);
    return applyWith(
        edit.finish(tr("Rename %1 to %2").arg(qString(block), qString(name)).toStdString()),
        [&](const std::string& part) { return instanceOf(part) == block ? name + part.substr(block.size()) : part; });
}

std::string Composer::freeClassName() const {
    const Library& library = document_.library();
    for (int number = 1;; ++number) {
        const std::string name = "Group" + (number > 1 ? std::to_string(number) : std::string());
        if (!library.lookup(name, document_.shownClass())) return name;
    }
}

std::string Composer::group(const std::vector<std::string>& blocks, const std::string& className) {
    if (!isReady()) return {};
    Group group;
    for (const std::string& name : blocks)
        if (const Block* block = document_.diagram().find(name); block && !block->isConnector)
            group.components.push_back(name);
    if (group.components.empty()) {
        fault_ = tr("Select the blocks that are to become one; inputs and outputs stay outside.");
        return {};
    }
    if (!isModelicaName(className) || document_.library().lookup(className, document_.shownClass())) {
        fault_ = tr("\"%1\" is no free name for a model.").arg(qString(className));
        return {};
    }
    group.className = className;
    group.instance = freeName(*document_.definition(), baseName(className));
    const QString what = tr("Group %1 blocks").arg(group.components.size());
    const bool isDone = applyWith(
        groupComponents(document_.library(), document_.diagram(), *document_.definition(), group, what.toStdString()),
        [&](const std::string& part) {
            const bool isInside =
                std::find(group.components.begin(), group.components.end(), instanceOf(part)) != group.components.end();
            return isInside ? group.instance + "." + part : part;
        });
    return isDone ? group.instance : std::string();
}

bool Composer::setClassName(const std::string& name) {
    if (!isReady() || document_.study().className == name || !document_.levels().empty()) return false;
    const syntax::ClassDefinition& definition = *document_.definition();
    if (!isModelicaName(name) || document_.study().className != definition.name) {
        fault_ = tr("\"%1\" is no name for a model.").arg(qString(name));
        return false;
    }
    if (document_.library().find(name)) {
        fault_ = tr("The name \"%1\" is taken.").arg(qString(name));
        return false;
    }
    syntax::TextEdit edit;
    edit.what = tr("Rename the model to %1").arg(qString(name)).toStdString();
    edit.replacements.push_back({definition.nameSpan.begin, definition.nameSpan.end, name});
    const auto size = static_cast<std::uint32_t>(definition.name.size());
    edit.replacements.push_back({definition.endSpan.end - size, definition.endSpan.end, name});
    StudySettings settings = document_.settings();
    settings.className = name;
    document_.applyBoth(std::move(edit), std::move(settings));
    return true;
}

std::string Composer::copy(const std::vector<std::string>& blocks) const {
    if (!document_.definition()) return {};
    const std::set<std::string> names(blocks.begin(), blocks.end());
    std::string text = "model Clipboard\n";
    for (const syntax::Component& c : document_.definition()->components) {
        if (!names.contains(c.name)) continue;
        const std::string prefix(
            document_.definition()->source->text().substr(c.clauseSpan.begin, c.typeSpan.end - c.clauseSpan.begin));
        text += "  " + prefix + " " + std::string(c.span.text()) + ";\n";
    }
    std::string wires;
    for (const Wire& wire : document_.diagram().wires) {
        if (!names.contains(instanceOf(wire.from)) || !names.contains(instanceOf(wire.to))) continue;
        std::string line(wire.span.text());
        if (!line.ends_with(';')) line += ';';
        wires += "  " + line + "\n";
    }
    if (!wires.empty()) text += "equation\n" + wires;
    return text + "end Clipboard;\n";
}

std::vector<std::string> Composer::paste(const std::string& text, double dx, double dy) {
    if (!isReady()) return {};
    const auto parsed = syntax::parse(std::make_shared<const Source>("clipboard", text));
    if (hasError(parsed.diagnostics) || parsed.definition.classes.size() != 1 ||
        parsed.definition.classes.front()->components.empty()) {
        fault_ = tr("The clipboard holds no blocks.");
        return {};
    }
    const syntax::ClassPtr& copied = parsed.definition.classes.front();
    const Outcome<Library> library = document_.library().withSource(copied->source);
    Diagram diagram;
    if (library)
        if (Outcome<Diagram> read = readDiagram(*library, copied->name)) diagram = std::move(*read);

    ModelEdit edit(*document_.definition(), &document_.diagram(), &document_.library());
    std::map<std::string, std::string> names;
    std::vector<std::string> added;
    std::set<std::string> taken;
    for (const syntax::Component& c : copied->components) {
        NewComponent component;
        component.className = c.type.text();
        std::string base = c.name;
        component.name = freeName(*document_.definition(), base);
        while (!base.empty() && std::isdigit(static_cast<unsigned char>(base.back()))) base.pop_back();
        for (int i = 1;
             taken.contains(component.name) || freeName(*document_.definition(), component.name) != component.name; ++i)
            component.name = (base.empty() ? c.name : base) + std::to_string(i);
        taken.insert(component.name);
        names[c.name] = component.name;
        for (const syntax::Modification& m : c.modifications) collectModifications(m, {}, component.modifications);
        component.description = c.description;
        const Block* block = diagram.find(c.name);
        component.placement = shifted(block ? block->placement : Placement{}, dx, dy);
        added.push_back(component.name);
        edit.addComponent(component);
    }
    const auto renamed = [&](const std::string& connector) {
        const std::string instance = instanceOf(connector);
        return names.contains(instance) ? names[instance] + connector.substr(instance.size()) : std::string();
    };
    for (const Wire& wire : diagram.wires) {
        const std::string from = renamed(wire.from), to = renamed(wire.to);
        if (from.empty() || to.empty()) continue;
        std::vector<Point> points = wire.points;
        for (Point& p : points) p = {p.x + dx, p.y + dy};
        edit.addConnection(from, to, points, wire.colour);
    }
    const QString what =
        added.size() == 1 ? tr("Paste %1").arg(qString(added.front())) : tr("Paste %1 blocks").arg(added.size());
    return apply(edit.finish(what.toStdString())) ? added : std::vector<std::string>();
}

}  // namespace analogon::ui
