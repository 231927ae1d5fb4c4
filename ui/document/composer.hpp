#pragma once

#include <QByteArray>
#include <QPointF>
#include <QSizeF>
#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/diagram/diagram.hpp"
#include "core/diagram/edit.hpp"
#include "core/diagram/graphics_edit.hpp"
#include "ui/route/moved.hpp"
#include "ui/route/selection.hpp"

namespace analogon::ui {

class Document;
struct Insertion;

enum class Edge { Left, Right, Top, Bottom, Middle, Centre };  // Middle: one height; Centre: one column

/// The gestures of the diagram as edits of the document, each one step of the undo list. Coordinates are the diagram's:
/// y upward. What cannot be done is said in a sentence (fault()) and changes nothing.
class Composer {
public:
    explicit Composer(Document& document) : document_(document) {}

    /// A component of a class around a point on the grid; its name, or empty.
    std::string addBlock(const std::string& className, Point centre);
    /// The same; where it lies on a connection that it fits into (insertionAt), it is led into that.
    std::string dropBlock(const std::string& className, Point centre);
    bool addWire(const std::string& from, const std::string& to, const std::vector<Point>& points = {});
    /// Leads a wire another way, from end to end.
    bool lead(const WireEnds& wire, const std::vector<Point>& way);
    bool remove(const DiagramSelection& selection);
    bool move(const std::vector<std::string>& blocks, double dx, double dy);
    /// The same; one block that nothing is connected to is led into the connection it comes to lie on, if it fits.
    bool drop(const std::vector<std::string>& blocks, double dx, double dy);
    /// The wires that a drop there would part; none: it would only be placed.
    std::vector<WireEnds> partedByDrop(const std::string& className, Point centre);
    std::vector<WireEnds> partedByMove(const std::vector<std::string>& blocks, double dx, double dy) const;
    /// A quarter turn counter-clockwise, each block about its own centre.
    bool rotate(const std::vector<std::string>& blocks);
    bool flip(const std::vector<std::string>& blocks, bool isHorizontal);
    bool align(const std::vector<std::string>& blocks, Edge edge);
    /// Three or more at equal gaps, from left to right (`isAcross`) or from bottom to top.
    bool distribute(const std::vector<std::string>& blocks, bool isAcross);
    bool rename(const std::string& block, const std::string& name);
    /// The unit that an input or output of the model is told in, in its declaration; empty: none of its own.
    bool setUnit(const std::string& block, const std::string& unit);
    /// Modelica text: declarations and the connections between them.
    std::string copy(const std::vector<std::string>& blocks) const;
    /// Declares what a copied text holds, moved by (dx, dy), under free names; their names.
    std::vector<std::string> paste(const std::string& text, double dx, double dy);
    bool setClassName(const std::string& name);
    /// A line of text, or a picture (the bytes of its file, with its proportions), above all that the diagram shows.
    bool addText(const QString& text);
    bool addPicture(const QByteArray& bytes, QSizeF size);
    bool moveNote(const OwnGraphic& note, double dx, double dy);
    bool setText(const OwnGraphic& note, const QString& text);
    bool removeNote(const OwnGraphic& note);
    /// Puts blocks into a new class of this name, with connectors for the wires that cross its border, and one block of
    /// it in their place; that block's name, or empty.
    std::string group(const std::vector<std::string>& blocks, const std::string& className);
    /// A name for it that is not taken.
    std::string freeClassName() const;

    /// Why two connectors cannot be connected; empty: they can.
    QString refusal(const std::string& from, const std::string& to) const;
    /// The class of a signal of the model that a connector of a block could be connected with: a RealInput for an input
    /// that gets no signal yet, a RealOutput for an output; empty: for no other.
    std::string signalClassFor(const std::string& connector) const;
    const QString& fault() const { return fault_; }

    /// The diagram with blocks at other places and the wires led after them.
    static Diagram moved(const Diagram& diagram, const std::vector<std::string>& blocks, double dx, double dy);

private:
    bool isReady();
    bool apply(const Outcome<syntax::TextEdit>& edit);
    bool applyWith(const Outcome<syntax::TextEdit>& edit, const std::function<std::string(std::string)>& rename);
    bool wouldHoldItself(const LibraryClass& cls, int depth = 0) const;
    std::optional<Block> newBlock(const std::string& className, Point centre);
    std::string declare(const std::string& className, Point centre, bool isDropped);
    std::optional<Insertion> insertion(const Block& block) const;
    bool insert(const Block& block, ModelEdit& edit, const Diagram& after);
    bool place(const std::vector<std::pair<std::string, Placement>>& placements, const QString& what);

    Document& document_;
    QString fault_;
};

/// The unit in the declaration of an input or output; empty: it has none of its own.
std::string declaredUnit(const Block& block);
/// Whether it is an input or output of the model, a number with a unit.
bool hasUnit(const Block& block);

/// A name for a new component: "electricThermal" for BasicElectricThermal, "u" for an input.
std::string baseName(const std::string& className);

bool isModelicaName(const std::string& name);

}  // namespace analogon::ui
