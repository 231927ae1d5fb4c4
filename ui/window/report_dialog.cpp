#include "ui/window/report_dialog.hpp"

#include <QCheckBox>
#include <QDate>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include "core/report/logo.hpp"
#include "core/study/report_settings.hpp"
#include "ui/document/document.hpp"
#include "ui/effect/report_top.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

QString sectionTitle(ReportSection section) {
    switch (section) {
        case ReportSection::Errors:
            return ReportDialog::tr("Errors of each recording");
        case ReportSection::Effects:
            return ReportDialog::tr("Effects with their evidence");
        case ReportSection::Diagram:
            return ReportDialog::tr("Diagram before and after");
        case ReportSection::Unexplained:
            return ReportDialog::tr("What is unexplained");
        case ReportSection::Plots:
            return ReportDialog::tr("Measured and simulated");
        case ReportSection::Parameters:
            return ReportDialog::tr("Parameters");
        case ReportSection::Residuals:
            return ReportDialog::tr("What is left");
        case ReportSection::Tried:
            return ReportDialog::tr("What was tried");
        case ReportSection::Remarks:
            break;
    }
    return ReportDialog::tr("Warnings and remarks");
}

}  // namespace

ReportDialog::ReportDialog(Document& document, bool canWrite, QWidget* parent)
    : QDialog(parent),
      document_(document),
      title_(new QLineEdit(this)),
      testObject_(new QLineEdit(this)),
      author_(new QLineEdit(this)),
      date_(new QLineEdit(this)),
      logo_(new QLineEdit(this)),
      preview_(new QTextBrowser(this)),
      fault_(new QLabel(this)),
      keep_(new QPushButton(tr("Keep"), this)),
      write_(new QPushButton(tr("Write report …"), this)) {
    setObjectName("report-head");
    setWindowTitle(tr("Report"));
    setAttribute(Qt::WA_DeleteOnClose);
    preview_->setAccessibleName(tr("Preview of the head"));
    preview_->setFixedHeight(34 * style::unit);
    preview_->setFocusPolicy(Qt::NoFocus);
    preview_->document()->setDocumentMargin(3 * style::unit);
    preview_->setStyleSheet("QTextBrowser { background: white; color: black; }");  // it is paper
    fault_->setWordWrap(true);
    style::makeCaption(fault_);
    auto* cancel = new QPushButton(tr("Cancel"), this);
    cancel->setAutoDefault(false);
    keep_->setToolTip(tr("Keep the head in the study without writing a report"));
    write_->setIcon(style::icon("report"));
    write_->setEnabled(canWrite);
    if (!canWrite) write_->setToolTip(tr("There is no result yet."));
    (canWrite ? write_ : keep_)->setDefault(true);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    for (QPushButton* button : {write_, keep_, cancel}) buttons->addWidget(button);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addLayout(fields());
    layout->addWidget(sectionBoxes());
    layout->addWidget(preview_);
    layout->addWidget(fault_);
    layout->addLayout(buttons);
    fill();
    resize(140 * style::unit, sizeHint().height());
    for (QLineEdit* field : {title_, testObject_, author_, date_, logo_})
        connect(field, &QLineEdit::textChanged, this, &ReportDialog::showHead);
    connect(keep_, &QPushButton::clicked, this, [this] {
        keep();
        accept();
    });
    connect(write_, &QPushButton::clicked, this, [this] {
        keep();
        accept();
        Q_EMIT writeWanted();
    });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(&document, &Document::opened, this, &QDialog::reject);
    showHead();
}

QLayout* ReportDialog::fields() {
    auto* today = new QToolButton(this);
    today->setText(tr("Today"));
    today->setAccessibleName(tr("Today's date"));
    connect(today, &QToolButton::clicked, this,
            [this] { date_->setText(style::windowLocale().toString(QDate::currentDate(), QLocale::LongFormat)); });
    auto* browse = new QToolButton(this);
    browse->setText(QStringLiteral("…"));
    browse->setToolTip(tr("Choose a picture: PNG, JPEG or SVG"));
    connect(browse, &QToolButton::clicked, this, &ReportDialog::askForLogo);
    const auto with = [](QLineEdit* field, QToolButton* button) {
        auto* row = new QHBoxLayout;
        row->setSpacing(2 * style::unit);
        row->addWidget(field, 1);
        row->addWidget(button);
        return row;
    };
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(3 * style::unit);
    form->setVerticalSpacing(2 * style::unit);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    form->addRow(tr("Title"), title_);
    form->addRow(tr("Test object"), testObject_);
    form->addRow(tr("Author"), author_);
    form->addRow(tr("Date"), with(date_, today));
    form->addRow(tr("Logo"), with(logo_, browse));
    title_->setPlaceholderText(document_.title());
    logo_->setPlaceholderText(tr("PNG, JPEG or SVG; it is kept with the study"));
    date_->setAccessibleName(tr("Date"));
    logo_->setAccessibleName(tr("Logo"));
    return form;
}

QWidget* ReportDialog::sectionBoxes() {
    auto* group = new QGroupBox(tr("Sections"), this);
    auto* grid = new QGridLayout(group);
    int index = 0;
    constexpr int columns = 3;
    for (const ReportSection section : reportSections) {
        auto* box = new QCheckBox(sectionTitle(section), group);
        grid->addWidget(box, index / columns, index % columns);
        sections_[section] = box;
        ++index;
    }
    return group;
}

void ReportDialog::fill() {
    const ReportHead head = reportHeadOf(document_.study().extraJson);
    title_->setText(QString::fromStdString(head.title));
    testObject_->setText(QString::fromStdString(head.testObject));
    author_->setText(QString::fromStdString(head.author));
    date_->setText(QString::fromStdString(head.date));
    logo_->setText(QString::fromStdString(head.logo));
    for (const auto& [section, box] : sections_) box->setChecked(head.shows(section));
}

void ReportDialog::askForLogo() {
    auto* dialog = new QFileDialog(this, tr("Choose a logo"));
    dialog->setObjectName("logo-dialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setNameFilter(tr("Pictures (*.png *.jpg *.jpeg *.svg)"));
    connect(dialog, &QFileDialog::fileSelected, this, &ReportDialog::setLogo);
    dialog->show();
}

/// Within the study by its name there, else by its whole path until the study is saved, which brings it along.
void ReportDialog::setLogo(const QString& path) {
    const std::filesystem::path& directory = document_.study().directory;
    const QString inside =
        directory.empty() ? path : QDir(QString::fromStdString(directory.string())).relativeFilePath(path);
    logo_->setText(inside.startsWith("..") ? path : inside);
}

ReportHead ReportDialog::head() const {
    const auto text = [](const QLineEdit* field) { return field->text().trimmed().toStdString(); };
    ReportHead head{text(title_), text(testObject_), text(author_), text(date_), text(logo_), {}};
    for (const auto& [section, box] : sections_)
        if (!box->isChecked()) head.leftOut.insert(section);
    return head;
}

void ReportDialog::showHead() {
    const ReportHead now = head();
    QImage picture;
    QString fault;
    if (!now.logo.empty()) {
        const std::filesystem::path file = document_.study().directory / now.logo;
        if (const Outcome<std::string> uri = logoUri(file, now.logo); uri)
            picture = logoPicture(QString::fromStdString(file.string()));
        else
            fault = tr("Logo: %1").arg(inWords(uri.diagnostics().front().message));
    }
    fault_->setText(fault);
    fault_->setVisible(!fault.isEmpty());
    preview_->document()->addResource(QTextDocument::ImageResource, QUrl(logoResource), picture);
    preview_->setHtml(reportTop(document_.title(), now, !picture.isNull()));
}

void ReportDialog::keep() {
    StudySettings settings = document_.settings();
    const std::string next = withReportHead(settings.plots, head());
    if (next == settings.plots || reportHeadOf(settings.plots) == head()) return;
    settings.plots = next;
    document_.applySettings(std::move(settings), tr("Head of the report"));
}

}  // namespace analogon::ui
