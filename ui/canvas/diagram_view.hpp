#pragma once

#include <QGraphicsView>
#include <functional>
#include <memory>

#include "core/diagram/diagram.hpp"
#include "ui/route/selection.hpp"

namespace analogon::ui {

class BlockItem;
class DiagramScene;
class Gesture;
class NoteItem;

/// A block that would be placed at a point, drawn while it is dragged in from the library.
struct GhostBlock {
    Icon icon;
    QString name;
    QPointF at;  // scene
};

/// The window onto the diagram: wheel zooms about the pointer, the middle button pans, Space shows all; dragging moves
/// blocks, draws wires from connectors, and selects on empty ground. It asks for changes and makes none.
class DiagramView : public QGraphicsView {
    Q_OBJECT

public:
    explicit DiagramView(DiagramScene& scene, QWidget* parent = nullptr);
    ~DiagramView() override;

    DiagramScene* scene() const { return &scene_; }
    void fitView();
    /// The same, unless the user has zoomed or panned since.
    void refit() {
        if (isFitted_) fitView();
    }
    /// Shows all again when something new lies outside.
    void refitIfHidden();
    void zoomIn() { zoomBy(1.25, viewport()->rect().center()); }
    void zoomOut() { zoomBy(0.8, viewport()->rect().center()); }
    /// Device pixels per diagram unit.
    double zoom() const { return transform().m11(); }
    void panBy(QPoint pixels);
    /// The small picture of the whole diagram, when it is shown.
    std::optional<QRectF> overview() const;
    /// Looks at the place that a point of the overview stands for.
    void lookAtOverview(QPoint at);

    BlockItem* blockAt(QPoint at) const;
    NoteItem* noteAt(QPoint at) const;
    /// Where the name of a block stands in this view; empty: it has none.
    QRect nameRect(const std::string& block) const;
    /// Why two connectors cannot be connected; empty: they can. Set by the owner.
    std::function<QString(const std::string&, const std::string&)> refusal{
        [](const auto&, const auto&) { return QString(); }};
    /// The wires that the selection, moved by (dx, dy) and dropped there, would part. Set by the owner.
    std::function<std::vector<WireEnds>(double dx, double dy)> partedByMove{
        [](double, double) { return std::vector<WireEnds>(); }};
    /// The diagram is of an earlier text: `note` says so, and nothing can be changed in it. Empty: it is the present
    /// one.
    void setStale(const QString& note);
    bool isStale() const { return !staleNote_.isEmpty(); }
    void setGhost(std::optional<GhostBlock> ghost);
    /// Wires to be shown as those that a drop would part.
    void setParted(std::vector<WireEnds> wires);
    const std::vector<WireEnds>& parted() const { return parted_; }
    /// A sentence at a place of the scene.
    void paintNote(QPainter& painter, QPointF at, const QString& text, const QColor& colour) const;
    /// Diagram coordinates of a point of the viewport.
    Point diagramPoint(QPoint at) const;

Q_SIGNALS:
    void moveWanted(double dx, double dy);  // of the selection, in diagram units
    void dropWanted(double dx, double dy);  // the same by the mouse, which may mean a wire
    void wireWanted(const QString& from, const QString& to);
    void wireBent(const QString& from, const QString& to, const std::vector<analogon::Point>& way);
    void noteMoved(double dx, double dy);  // the text or picture that is selected
    void noteActivated();
    void refused(const QString& reason);
    void staleClicked();
    void blockActivated(const QString& name);
    void renameWanted(const QString& name);
    void typed(const QString& text);  // a name begun on the empty diagram
    void menuWanted(QPoint globalPos);

protected:
    bool event(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    void drawForeground(QPainter* painter, const QRectF& rect) override;
    void changeEvent(QEvent* event) override;

private:
    void zoomBy(double factor, QPoint about);
    void selectNext(bool isForward);
    std::string nameAt(QPoint at) const;
    struct Overview {
        QRectF frame, world;  // [px], scene
        double scale{};       // [px per diagram unit]
    };
    std::optional<Overview> overviewShown() const;
    void paintOverview(QPainter& painter) const;

    DiagramScene& scene_;
    std::unique_ptr<Gesture> gesture_;
    std::optional<GhostBlock> ghost_;
    std::vector<WireEnds> parted_;
    QString staleNote_;
    bool isFitted_{true};  // until the user zooms or pans, the view follows the window's size
};

}  // namespace analogon::ui
