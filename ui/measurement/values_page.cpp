#include "ui/measurement/values_page.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/values_model.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

ValuesPage::ValuesPage(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new ValuesModel(this)),
      title_(new QLabel(this)),
      caption_(new QLabel(this)),
      raw_(new QCheckBox(tr("As in the file"), this)),
      converted_(new QCheckBox(tr("As the model gets them"), this)),
      view_(new QTableView(this)),
      close_(new QPushButton(tr("Close"), this)) {
    style::makeHeading(title_, 1.2);
    style::makeCaption(caption_);
    caption_->setWordWrap(true);
    for (QCheckBox* box : {raw_, converted_}) {
        box->setChecked(true);
        connect(box, &QCheckBox::toggled, this, &ValuesPage::choose);
    }
    raw_->setToolTip(tr("Every column of the file in its own unit"));
    converted_->setToolTip(tr("Mapped columns in the unit of the model, scaled and shifted as the study says"));
    view_->setModel(model_);
    view_->setTabKeyNavigation(false);  // else Tab never leaves a long table
    view_->setFrameShape(QFrame::NoFrame);
    view_->setAlternatingRowColors(true);
    view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + style::unit);
    view_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);  // a million rows of one height
    view_->horizontalHeader()->setResizeContentsPrecision(30);
    view_->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    view_->setAccessibleName(tr("Values of the recording"));
    auto* heading = new QHBoxLayout;
    heading->setSpacing(3 * style::unit);
    heading->addWidget(title_, 1);
    heading->addWidget(raw_);
    heading->addWidget(converted_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(caption_, 1);
    buttons->addWidget(close_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addLayout(heading);
    layout->addWidget(view_, 1);
    layout->addLayout(buttons);
    connect(close_, &QPushButton::clicked, this, &ValuesPage::left);
    for (auto signal : {&Document::experimentsChanged, &Document::factsChanged})
        connect(&document, signal, this, &ValuesPage::refresh);
    connect(&document, &Document::opened, this, &ValuesPage::left);
}

void ValuesPage::show(const QString& experiment) {
    experiment_ = experiment;
    refresh();
}

/// One of both at least is shown.
void ValuesPage::choose() {
    if (!raw_->isChecked() && !converted_->isChecked()) (sender() == raw_ ? converted_ : raw_)->setChecked(true);
    model_->setShown(raw_->isChecked(), converted_->isChecked());
    view_->resizeColumnsToContents();
}

void ValuesPage::refresh() {
    joiner_.drop();
    if (experiment_.isEmpty() || !document_.isOpen()) return;
    for (const StudyExperiment& e : document_.study().experiments) {
        if (QString::fromStdString(e.name) != experiment_) continue;
        title_->setText(experiment_);
        if (isAtHand(document_.study().tables, e)) return showTable(e, shownTable(document_.study().tables, e));
        caption_->setText(tr("Reading …"));
        joiner_.start<std::shared_ptr<const Table>>(
            tr("Reading"), [e, tables = document_.study().tables](const Progress&) { return shownTable(tables, e); },
            [this, e](const std::shared_ptr<const Table>& table) { showTable(e, table); });
        return;
    }
    leave();
}

void ValuesPage::showTable(const StudyExperiment& experiment, const std::shared_ptr<const Table>& table) {
    if (!table) return leave();
    const QString file = QString::fromStdString(std::filesystem::path(experiment.file).filename().string());
    caption_->setText(
        tr("%1 · %2 samples, numbered by the lines of the file").arg(file, style::countText(table->rows())));
    model_->show(table, experiment, document_.facts());
    view_->resizeColumnsToContents();
}

/// It was taken out of the study, or there is nothing to show of it.
void ValuesPage::leave() {
    experiment_.clear();
    model_->show(nullptr, {}, {});
    Q_EMIT left();
}

}  // namespace analogon::ui
