#pragma once

#include <QToolButton>

class QAbstractItemView;

namespace analogon::ui::style {

/// A button of icons in a row of a list: on the row that is selected its icon has the ink of the words beside it.
class RowButton : public QToolButton {
public:
    explicit RowButton(const QAbstractItemView& view) : view_(view) { setAutoRaise(true); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const QAbstractItemView& view_;
};

}  // namespace analogon::ui::style
