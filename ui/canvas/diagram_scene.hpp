#pragma once

#include <QGraphicsScene>
#include <map>

#include "core/diagram/diagram.hpp"

namespace analogon::ui {

class BlockItem;
class WireItem;

/// A block to be shown as found.
struct EffectMark {
    std::string instance;
    QString label;
};

/// The picture of a diagram. It shows and selects; whatever changes the model goes through the document.
class DiagramScene : public QGraphicsScene {
    Q_OBJECT

public:
    explicit DiagramScene(QObject* parent = nullptr);

    void show(const Diagram& diagram);
    void mark(const std::vector<EffectMark>& effects);
    bool isEmpty() const { return blocks_.empty(); }
    BlockItem* block(const std::string& name) const;
    QString selectedBlock() const;
    void select(const std::string& block);
    /// What "fit view" shows.
    QRectF contents() const;

Q_SIGNALS:
    void blockSelected(const QString& name);  // empty: nothing is selected

private:
    bool hasRoomBelow(const BlockItem& item) const;

    std::map<std::string, BlockItem*> blocks_;
    std::vector<WireItem*> wires_;
    QGraphicsItem* graphics_{};
    bool isRebuilding_{};
};

}  // namespace analogon::ui
