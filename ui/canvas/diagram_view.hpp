#pragma once

#include <QGraphicsView>

namespace analogon::ui {

class DiagramScene;

/// The window onto the diagram: wheel zooms about the pointer, dragging empty ground pans, Space shows all.
class DiagramView : public QGraphicsView {
    Q_OBJECT

public:
    explicit DiagramView(DiagramScene& scene, QWidget* parent = nullptr);

    void fitView();
    /// The same, unless the user has zoomed or panned since.
    void refit() {
        if (isFitted_) fitView();
    }
    /// Device pixels per diagram unit.
    double zoom() const { return transform().m11(); }

protected:
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void drawBackground(QPainter* painter, const QRectF& rect) override;
    void changeEvent(QEvent* event) override;

private:
    void zoomBy(double factor, QPoint about);

    DiagramScene& scene_;
    QPoint panFrom_;
    bool isPanning_{}, hasPanned_{};
    bool isFitted_{true};  // until the user zooms or pans, the view follows the window's size
};

}  // namespace analogon::ui
