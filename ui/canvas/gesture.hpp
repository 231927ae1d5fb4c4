#pragma once

#include <QMouseEvent>
#include <QPainter>
#include <memory>

#include "core/diagram/diagram.hpp"

namespace analogon::ui {

class DiagramView;
class NoteItem;

/// What the mouse is doing on the diagram, from press to release. Changes nothing before the end.
class Gesture {
public:
    explicit Gesture(DiagramView& view) : view_(view) {}
    virtual ~Gesture() = default;
    virtual void move(QMouseEvent* event) = 0;
    virtual void release(QMouseEvent* event) = 0;
    virtual void cancel() {}
    /// Drawn over the diagram, in scene coordinates.
    virtual void paint(QPainter&) const {}

protected:
    DiagramView& view_;
};

/// Moves what is selected on the grid; a press without a move is a click.
std::unique_ptr<Gesture> makeMoveGesture(DiagramView& view, QMouseEvent* press);
/// Draws a wire from a connector: connectors that fit light up, one that does not says why.
std::unique_ptr<Gesture> makeWireGesture(DiagramView& view, QMouseEvent* press, const std::string& from);
/// Moves the piece of a wire under the pointer at right angles; a press without a move is a click.
std::unique_ptr<Gesture> makeBendGesture(DiagramView& view, QMouseEvent* press, const Wire& wire);
/// Moves a text or picture on the grid; a press without a move chooses it.
std::unique_ptr<Gesture> makeNoteGesture(DiagramView& view, QMouseEvent* press, NoteItem& note);
/// Selects what lies in a rectangle.
std::unique_ptr<Gesture> makeBandGesture(DiagramView& view, QMouseEvent* press);
std::unique_ptr<Gesture> makePanGesture(DiagramView& view, QMouseEvent* press);
/// Takes the view along on the overview.
std::unique_ptr<Gesture> makeOverviewGesture(DiagramView& view, QMouseEvent* press);

}  // namespace analogon::ui
