#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/library/library.hpp"
#include "core/syntax/text_edit.hpp"

/// The picture of a model, read from its annotations (Modelica 3.6, chapter 18), and edits of the text that
/// change it. The text is the one truth: every gesture is a TextEdit.
namespace analogon {

struct Point {
    double x{}, y{};
    friend bool operator==(const Point&, const Point&) = default;
};

struct Colour {
    int r{}, g{}, b{};
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// Extent in the diagram's coordinates; p1.x > p2.x means flipped horizontally.
struct Extent {
    Point p1{-100, -100}, p2{100, 100};
};

/// FillPattern of a three-dimensional look.
enum class Gradient { None, HorizontalCylinder, VerticalCylinder, Sphere };

/// One graphic primitive of an Icon or Diagram annotation.
struct Primitive {
    enum class Kind { Line, Rectangle, Polygon, Ellipse, Text, Bitmap };
    Kind kind{Kind::Line};
    std::vector<Point> points;  // Line, Polygon
    Extent extent;              // the others
    std::string text;           // Text (with %name, %class, %par macros unexpanded); Bitmap: see pictureBytes
    Colour line{0, 0, 0};
    Colour fill{255, 255, 255};
    bool filled{};
    double thickness{0.25};  // [mm] as in Modelica
    double fontSize{};       // [pt]; 0: fits the extent
    double rotation{};       // [deg]
    double radius{};         // corners of a rectangle
    double startAngle{0}, endAngle{360};
    bool smooth{};  // Bezier
    bool dashed{};
    bool bold{};
    bool outlined{true};                // false: LinePattern.None
    Gradient gradient{Gradient::None};  // how the fill runs from `line` to `fill`
    int alignment{};                    // Text: -1 left, 0 centre, 1 right
    bool arrowAtStart{}, arrowAtEnd{};
    Point origin;
};

struct Icon {
    Extent coordinates;
    std::vector<Primitive> primitives;  // base classes first
};

/// Where a component stands: maps its icon's coordinates into the diagram.
struct Placement {
    Extent extent{{-10, -10}, {10, 10}};
    Point origin;
    double rotation{};
};

/// A point of an icon's coordinates in those of the diagram it stands in.
Point map(const Placement& placement, const Extent& coordinates, Point point);

enum class Domain { Rotational, Translational, Electrical, Heat, RealInput, RealOutput, Other };

/// A connector on a block, in the coordinates of the block's icon.
struct Port {
    std::string name;
    std::string className;
    Domain domain{Domain::Other};
    Placement placement;
    Icon icon;
    std::string description;
};

struct Block {
    std::string name;
    std::string className;  // qualified
    std::string description;
    Placement placement;
    Icon icon;
    std::vector<Port> ports;
    bool isConnector{};  // a top-level input, output or other connector: its own port
    Domain domain{Domain::Other};
    bool isEffect{};        // class lies in Analogon.Effects or carries the effect annotation
    bool isResolved{true};  // false: class unknown; drawn as an empty box
    std::vector<std::pair<std::string, std::string>> parameters;  // modified parameters and their text
    Span span;
};

struct Wire {
    std::string from, to;  // "motor.flange", or a top-level connector's name
    std::vector<Point> points;
    Colour colour;
    double thickness{0.25};
    Span span;  // of the connect equation
};

struct Diagram {
    std::string className;
    Extent coordinates{{-100, -100}, {100, 100}};
    std::vector<Block> blocks;
    std::vector<Wire> wires;
    std::vector<Primitive> graphics;  // of the Diagram annotation itself

    const Block* find(std::string_view block) const;
    /// Place of a connector "motor.flange" (or of a top-level connector) in diagram coordinates.
    std::optional<Point> anchor(std::string_view connector) const;
    /// Unit vector along an axis that leads away from the block at that connector; zero when unknown.
    Point direction(std::string_view connector) const;
    /// Domain of a connector; Other when unknown.
    Domain domain(std::string_view connector) const;
};

/// Reads the diagram of a class. Never fails on a bad annotation: what cannot be read gets a default place.
Outcome<Diagram> readDiagram(const Library& library, std::string_view className);

/// Icon of a class with its base classes.
Icon readIcon(const Library& library, std::string_view className);

/// Connectors of a class, inherited ones first, placed in the coordinates of its icon.
std::vector<Port> readPorts(const Library& library, std::string_view className);

/// What a connector class carries: known by its variables (phi and flow tau; s and flow f; v and flow i; T and flow
/// Q_flow; input Real …),
/// so a user's own connector of the same shape is drawn like ours.
Domain connectorDomain(const Library& library, std::string_view className);

/// Orthogonal way between two anchors; a direction is the unit vector that leads away from the block (zero: any).
std::vector<Point> route(Point from, Point fromDirection, Point to, Point toDirection);

/// Text of an annotation, for edits: `Placement(…)` and `Line(…)`, without the word `annotation`.
std::string placementAnnotation(const Placement& placement);
std::string lineAnnotation(const std::vector<Point>& points, const Colour& colour);

/// Modelica's colour of a connection of this domain.
Colour domainColour(Domain domain);

}  // namespace analogon
