#pragma once

#include <QFont>
#include <QGraphicsScene>
#include <map>
#include <optional>

#include "core/diagram/graphics_edit.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/mark_item.hpp"
#include "ui/route/moved.hpp"
#include "ui/route/selection.hpp"

namespace analogon::ui {

class NoteItem;
class WireItem;

/// A block to be shown as found.
struct EffectMark {
    std::string instance;
    QString label;
};

/// What the study or its last fit says of a block, for a small mark at it.
struct BlockMark {
    std::string block;
    MarkKind kind{MarkKind::Fitted};
    QString tip;  // HTML
};

/// The picture of a diagram. It shows and selects; whatever changes the model goes through the document.
class DiagramScene : public QGraphicsScene {
    Q_OBJECT

public:
    explicit DiagramScene(QObject* parent = nullptr);
    ~DiagramScene() override;

    /// `own`: what the class itself draws beside its blocks; its texts and pictures can be chosen.
    void show(const Diagram& diagram, const std::vector<OwnGraphic>& own = {});
    const Diagram& diagram() const { return diagram_; }
    /// How the names are read, for which they are kept apart: pixels of the screen per diagram unit, font of the view.
    void setReading(double zoom, const QFont& font);
    /// Blocks that a result found; of the others those that something is to be said of.
    void mark(const std::vector<EffectMark>& effects, const std::vector<BlockMark>& marks = {});
    bool isEmpty() const { return blocks_.empty(); }
    BlockItem* block(const std::string& name) const;
    /// The one block that is selected; empty: none or several.
    QString selectedBlock() const;
    DiagramSelection selection() const;
    void select(const std::string& block);
    /// Tells of the change once no item is at it any more: who hears of it may have the diagram drawn anew.
    void setSelection(const DiagramSelection& selection);
    /// What is selected of `part` no longer is, and the rest of it is.
    void toggle(const DiagramSelection& part);
    /// The text or picture of the model that is selected, instead of blocks and wires; null: none.
    NoteItem* selectedNote() const;
    void selectNote(NoteItem& note);
    const std::vector<NoteItem*>& notes() const { return notes_; }
    /// All blocks that lie in a rectangle, and wires that do.
    void selectIn(const QRectF& rect, const DiagramSelection& also);
    const std::vector<WireItem*>& wires() const { return wires_; }
    /// Selected blocks and their wires as they would be moved by (dx, dy) diagram units; (0, 0) puts them back.
    void showMoved(double dx, double dy);
    /// Every connector with its place in the scene.
    std::vector<std::pair<std::string, QPointF>> connectors() const;
    /// The connector within `reach` of a point; empty: none.
    std::string connectorAt(QPointF at, double reach) const;
    /// A place to look at while something points there: the blocks or connector of that name; empty: none.
    void pointOut(const std::string& place);
    const std::string& pointedOut() const { return pointedOut_; }
    /// What "fit view" shows.
    QRectF contents() const;

Q_SIGNALS:
    void blockSelected(const QString& name);  // empty: none or several
    void selectionEdited();

private:
    bool hasRoomBelow(const BlockItem& item) const;
    void showGraphics(const std::vector<OwnGraphic>& own, std::optional<std::uint32_t> chosen);
    void placeLabels();
    void keepNamesApart();
    std::vector<QRectF> drawnAround(const QTransform& toView) const;
    void placeMarks(const std::vector<BlockMark>& marks);

    void noteOrder();

    Diagram diagram_;
    std::string pointedOut_;
    std::vector<std::string> order_;  // selected blocks, first selected first
    std::map<std::string, BlockItem*> blocks_;
    std::map<std::string, BlockItem::LabelPlace> places_;  // of the names, whatever the zoom
    std::vector<WireItem*> wires_;
    std::vector<NoteItem*> notes_;
    double zoom_{};  // of the reading; 0: nobody looks
    QFont font_;
    std::optional<MovedBlocks> moved_;  // while they are dragged
    bool isRebuilding_{};
};

}  // namespace analogon::ui
