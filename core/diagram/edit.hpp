#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/diagram/diagram.hpp"
#include "core/syntax/text_edit.hpp"

/// Edits of a composed model's text. Each returns the change that does it; offsets refer to the source of the
/// class definition given. Comments and layout outside the edited place stay byte for byte.
namespace analogon {

/// A component to declare.
struct NewComponent {
    std::string className;
    std::string name;
    std::vector<std::pair<std::string, std::string>> modifications;  // name, value text
    std::string description;
    Placement placement;
};

/// Collects several changes of one class into one TextEdit (so that they undo as one). Every call speaks of the
/// class as it was given, in any order; of several changes of the same thing the last one counts.
class ModelEdit {
public:
    /// With a diagram (and a library, for the ports of new components) a connection without points gets a way
    /// between its ends; without them it gets no Line annotation and a reader lays one. With a library it is known
    /// what the class inherits: inherited components are changed by modifications of the extends clause. Without one,
    /// a name that the class does not declare is taken to come from its only base. All must outlive this.
    explicit ModelEdit(const syntax::ClassDefinition& definition, const Diagram* diagram = nullptr,
                       const Library* library = nullptr);

    ModelEdit& addComponent(const NewComponent& component);  // behind the last component
    ModelEdit& removeComponent(std::string_view name);       // with the connect equations that mention it
    ModelEdit& renameComponent(std::string_view from, const std::string& to);  // everywhere in the class
    ModelEdit& setClass(std::string_view component, const std::string& className);
    /// Sets (or with empty text removes) one modification of a component: setModifier("motor", "R", "0.36").
    /// A dotted name reaches into nested components: setModifier("drive", "rotor.J", "1e-5").
    ModelEdit& setModifier(std::string_view component, const std::string& name, const std::string& value);
    /// Sets (or with empty text removes) the binding of a variable of the class itself: `parameter Real k = 3`.
    ModelEdit& setBinding(std::string_view component, const std::string& value);
    /// By the name a parameter has in the flat model: "k" is a binding, "drive.rotor.J" a modification of "drive".
    /// One element of an array, "mass[2].C", is set by writing the values of all, which `valuesOf` gives.
    ModelEdit& setParameter(std::string_view flatName, const std::string& value);
    /// How the present value of a parameter is found by its flat name; nothing when there is no such parameter.
    ModelEdit& valuesOf(std::function<std::optional<std::string>(const std::string& flatName)> lookup);
    ModelEdit& setPlacement(std::string_view component, const Placement& placement);
    /// points may be empty: a straight or one-corner line is laid between the anchors when the diagram is given.
    ModelEdit& addConnection(const std::string& from, const std::string& to, const std::vector<Point>& points,
                             const Colour& colour);
    ModelEdit& removeConnection(std::string_view from, std::string_view to);
    /// In every connect equation of the given class that mentions `connector` as one end: replaces that end by
    /// `by`. Connections added by addConnection are not touched.
    ModelEdit& replaceInConnections(std::string_view connector, const std::string& by);
    bool isConnected(std::string_view connector) const;  // by a connect equation of the given class
    /// Replaces a variable of the class by another wherever equations (connect equations apart) and components use it;
    /// what its declaration bound it to becomes an equation of the other.
    ModelEdit& replaceReferences(std::string_view variable, const std::string& by);
    ModelEdit& addEquation(const std::string& text);  // behind the last equation, without semicolon
    ModelEdit& setLine(std::string_view from, std::string_view to, const std::vector<Point>& points);

    /// First fault met (unknown component or connection); the edit is then empty.
    Outcome<syntax::TextEdit> finish(std::string what) const;

private:
    struct ComponentChange {
        bool isRemoved{};
        std::optional<std::string> className;
        std::vector<std::pair<std::string, std::string>> modifiers;  // name, value; empty: remove
        std::optional<std::string> binding;                          // empty text: remove
        std::optional<Placement> placement;
    };
    struct ConnectionChange {
        bool isRemoved{};
        std::optional<std::string> left, right;
        std::optional<std::vector<Point>> points;
    };
    struct NewConnection {
        std::string equation;  // as it stands; empty: from and to are joined
        std::string from, to;
        std::vector<Point> points;
        Colour colour;
    };
    /// What a component inherited by the class is, and through which base (0 for that of a short class).
    struct Inherited {
        std::size_t base{};
        const syntax::Component* declaration{};  // null: not known, without a library
        std::string owner;                       // the class that declares it
    };
    struct InheritedChange {
        std::vector<std::pair<std::string, std::string>> values;   // dotted name, value
        std::vector<std::pair<std::string, std::string>> classes;  // component, new class
    };
    using Replacements = std::vector<syntax::Replacement>;

    struct ArrayName;

    void setElement(std::string_view flatName, const std::string& value);
    std::string arrayText(const ArrayName& name, std::vector<int>& index, std::size_t dimension) const;
    std::optional<std::string> elementValue(const ArrayName& name, const std::vector<int>& index) const;
    ComponentChange* change(std::string_view component);
    ComponentChange* ownChange(std::string_view component);  // null, without a fault, when not declared here
    std::optional<Inherited> inherited(std::string_view component) const;
    std::vector<std::string> componentNames() const;
    // Each is false, and does nothing, when nothing of the name is inherited.
    bool changeInherited(std::string_view component, std::string name, const std::string& value);
    bool redeclareInherited(std::string_view component, const std::string& className);
    bool refuseInherited(std::string_view component, const Text& what);
    std::vector<const syntax::Equation*> connectionsBetween(std::string_view from, std::string_view to);
    Diagram diagramWithNewBlocks() const;
    void writeComponents(Replacements& edits) const;
    void writeNewComponents(Replacements& edits) const;
    void writeConnections(Replacements& edits) const;
    void writeNewConnections(Replacements& edits) const;
    void writeInherited(Replacements& edits) const;
    void writeLongClass(Replacements& edits) const;
    std::string newComponentsText(const std::string& indent) const;
    std::string newConnectionsText(const std::string& indent) const;
    void writeRenames(Replacements& edits) const;
    void writeReplaced(Replacements& edits) const;
    std::set<std::uint32_t> placesOf(std::string_view variable, bool alsoInConnections) const;
    Replacements inside(const syntax::Component& component, const ComponentChange& change) const;

    const syntax::ClassDefinition* definition_;
    const Diagram* diagram_;
    const Library* library_;
    std::map<std::string, ComponentChange, std::less<>> components_;
    std::function<std::optional<std::string>(const std::string&)> lookup_;
    std::map<std::string, std::string, std::less<>> elements_;  // array elements that were set, by flat name
    std::map<std::size_t, InheritedChange> inherited_;          // by the number of the base
    std::map<const syntax::Equation*, ConnectionChange> connections_;
    struct Connect {
        const syntax::Equation* equation;
        std::string left, right;  // its ends without blanks
    };
    std::vector<Connect> connects_;  // in the order of the text
    std::vector<NewComponent> newComponents_;
    std::vector<NewConnection> newConnections_;
    std::map<std::string, std::string, std::less<>> renames_, replaced_;
    Diagnostics faults_;
};

/// A name that is not taken: base, base1, base2 …
std::string freeName(const syntax::ClassDefinition& definition, const std::string& base);
/// The same, with inherited names taken too.
std::string freeName(const Library& library, const syntax::ClassDefinition& definition, const std::string& base);

/// A free rectangle of this size near a point, on the 10-unit grid, best to its lower right: blocks of the diagram
/// are not covered, wires as little as possible.
Placement freePlacement(const Diagram& diagram, Point near, double width, double height);

}  // namespace analogon
