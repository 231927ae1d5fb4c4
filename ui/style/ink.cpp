#include "ui/style/ink.hpp"

#include <QAbstractItemView>
#include <QApplication>
#include <QEvent>
#include <QListWidgetItem>
#include <QPalette>
#include <QSignalBlocker>
#include <QTimer>
#include <QTreeWidgetItem>
#include <QWidget>
#include <utility>

namespace analogon::ui::style {

namespace {

/// Hears of the palettes of one widget.
class PaletteWatch : public QObject {
public:
    PaletteWatch(QWidget& widget, std::function<void()> changed) : QObject(&widget), changed_(std::move(changed)) {
        widget.installEventFilter(this);
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::PaletteChange && watched == parent()) changed_();
        return false;
    }

private:
    std::function<void()> changed_;
};

class Tint : public QObject {
public:
    explicit Tint(QWidget& label) : QObject(&label), label_(label) {
        new PaletteWatch(label, [this] { apply(); });
    }

    void set(Ink ink) {
        ink_ = ink;
        apply();
    }

private:
    void apply() {
        if (std::exchange(isApplying_, true)) return;  // its own change
        const QPalette around = label_.parentWidget() ? label_.parentWidget()->palette() : QApplication::palette();
        QPalette own;
        own.setResolveMask(0);
        if (ink_) own.setColor(label_.foregroundRole(), ink_(around));
        label_.setPalette(own);
        isApplying_ = false;
    }

    QWidget& label_;
    Ink ink_{};
    bool isApplying_{};
};

constexpr int inkRole = Qt::UserRole + 0x1000;  // far from those of the lists

QVariant brushOf(Ink ink, const QPalette& palette) { return ink ? QVariant(QBrush(ink(palette))) : QVariant(); }

void recolourItems(QAbstractItemModel& model, const QModelIndex& parent, const QPalette& palette) {
    for (int row = 0; row < model.rowCount(parent); ++row) {
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QModelIndex index = model.index(row, column, parent);
            if (const QVariant ink = index.data(inkRole); ink.isValid())
                model.setData(index, brushOf(ink.value<Ink>(), palette), Qt::ForegroundRole);
        }
        if (const QModelIndex first = model.index(row, 0, parent); model.hasChildren(first))
            recolourItems(model, first, palette);
    }
}

}  // namespace

void tint(QWidget& label, Ink ink) {
    Tint* known = nullptr;
    for (QObject* child : label.children())
        if (auto* one = dynamic_cast<Tint*>(child)) known = one;
    if (!known) known = new Tint(label);
    known->set(ink);
}

void tint(QTreeWidgetItem& item, int column, Ink ink, const QPalette& palette) {
    item.setData(column, inkRole, QVariant::fromValue(ink));
    item.setData(column, Qt::ForegroundRole, brushOf(ink, palette));
}

void tint(QListWidgetItem& item, Ink ink, const QPalette& palette) {
    item.setData(inkRole, QVariant::fromValue(ink));
    item.setData(Qt::ForegroundRole, brushOf(ink, palette));
}

void followTheme(QAbstractItemView& view) {
    onThemeChange(view, [&view] {
        const QSignalBlocker quiet(&view), alsoQuiet(view.model());  // nothing was edited
        recolourItems(*view.model(), {}, view.palette());
        view.viewport()->update();
    });
}

void onThemeChange(QWidget& widget, std::function<void()> redraw) {
    auto* soon = new QTimer(&widget);  // a theme changes the palette, the font and the style
    soon->setSingleShot(true);
    QObject::connect(soon, &QTimer::timeout, &widget, std::move(redraw));
    new PaletteWatch(widget, [soon] { soon->start(0); });
}

}  // namespace analogon::ui::style
