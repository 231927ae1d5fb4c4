#pragma once

#include <QLayout>

namespace analogon::ui {

/// Sets its widgets side by side and goes on in another row where there is no room. One that is wider than a row has it
/// to itself, and is as high as it asks for at that width.
class FlowLayout : public QLayout {
public:
    using QLayout::QLayout;
    ~FlowLayout() override;

    void addItem(QLayoutItem* item) override { items_.push_back(item); }
    int count() const override { return static_cast<int>(items_.size()); }
    QLayoutItem* itemAt(int index) const override { return index >= 0 && index < count() ? items_[index] : nullptr; }
    QLayoutItem* takeAt(int index) override { return index >= 0 && index < count() ? items_.takeAt(index) : nullptr; }
    Qt::Orientations expandingDirections() const override { return {}; }
    int heightOfRows(int width) const { return arrange(QRect(0, 0, width, 0), false); }
    QSize sizeHint() const override { return minimumSize(); }
    QSize minimumSize() const override;
    void setGeometry(const QRect& rect) override;
    /// Where the first row ends, as it was laid out.
    int firstRowEnd() const { return firstRowEnd_; }

private:
    /// Height of all rows; with `moves` the widgets go to their places.
    int arrange(const QRect& rect, bool moves) const;

    QList<QLayoutItem*> items_;
    int firstRowEnd_{};
};

}  // namespace analogon::ui
