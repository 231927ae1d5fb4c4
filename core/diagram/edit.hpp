#pragma once

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

/// Collects several changes of one class into one TextEdit (so that they undo as one).
class ModelEdit {
public:
    explicit ModelEdit(const syntax::ClassDefinition& definition);

    ModelEdit& addComponent(const NewComponent& component);  // behind the last component
    ModelEdit& removeComponent(std::string_view name);       // with the connect equations that mention it
    ModelEdit& renameComponent(std::string_view from, const std::string& to);  // everywhere in the class
    ModelEdit& setClass(std::string_view component, const std::string& className);
    /// Sets (or with empty text removes) one modification of a component: setModifier("motor", "R", "0.36").
    ModelEdit& setModifier(std::string_view component, const std::string& name, const std::string& value);
    ModelEdit& setPlacement(std::string_view component, const Placement& placement);
    /// points may be empty: a straight or one-corner line is laid between the anchors when the diagram is given.
    ModelEdit& addConnection(const std::string& from, const std::string& to, const std::vector<Point>& points,
                             const Colour& colour);
    ModelEdit& removeConnection(std::string_view from, std::string_view to);
    /// In every connect equation that mentions `connector` as one end: replaces that end by `by`.
    ModelEdit& replaceInConnections(std::string_view connector, const std::string& by);
    ModelEdit& setLine(std::string_view from, std::string_view to, const std::vector<Point>& points);

    /// First fault met (unknown component or connection); the edit is then empty.
    Outcome<syntax::TextEdit> finish(std::string what) const;

private:
    const syntax::ClassDefinition* definition_;
    syntax::TextEdit edit_;
    Diagnostics faults_;
};

/// A name that is not taken: base, base1, base2 …
std::string freeName(const syntax::ClassDefinition& definition, const std::string& base);

/// A free rectangle of this size near a point, on the 10-unit grid: blocks of the diagram are not covered.
Placement freePlacement(const Diagram& diagram, Point near, double width, double height);

}  // namespace analogon
