#include "ui/window/breadcrumb.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/canvas/diagram_view.hpp"
#include "ui/document/document.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

Breadcrumb::Breadcrumb(Document& document, DiagramView& view)
    : QWidget(&view), document_(document), row_(new QHBoxLayout(this)) {
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setAccessibleName(tr("Where the diagram lies in the model"));
    row_->setContentsMargins(style::unit, 0, 2 * style::unit, 0);
    row_->setSpacing(0);
    move(2 * style::unit, 2 * style::unit);
    connect(&document, &Document::levelsChanged, this, &Breadcrumb::refresh);
    connect(&document, &Document::modelChanged, this, &Breadcrumb::refresh);
    refresh();
}

void Breadcrumb::refresh() {
    while (QLayoutItem* item = row_->takeAt(0)) {
        item->widget()->deleteLater();  // it may be the button that asked for this
        item->widget()->hide();
        delete item;
    }
    const auto& levels = document_.levels();
    if (levels.empty()) return hide();
    for (std::size_t depth = 0; depth < levels.size(); ++depth) {
        auto* step = new QToolButton(this);
        step->setAutoRaise(true);
        step->setText(QString::fromStdString(depth == 0 ? document_.study().className : levels[depth - 1]));
        step->setToolTip(tr("Back to this diagram"));
        connect(step, &QToolButton::clicked, this, [this, depth] { document_.leaveTo(depth); });
        row_->addWidget(step);
        row_->addWidget(new QLabel(QStringLiteral("›"), this));
    }
    auto* here = new QLabel(" " + QString::fromStdString(levels.back()), this);
    QFont bold = here->font();
    bold.setWeight(QFont::DemiBold);
    here->setFont(bold);
    row_->addWidget(here);
    show();
    for (QWidget* part : findChildren<QWidget*>())
        if (row_->indexOf(part) >= 0) part->show();  // the size asks for what is shown
    adjustSize();
}

}  // namespace analogon::ui
