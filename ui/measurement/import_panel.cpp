#include "ui/measurement/import_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedLayout>
#include <QTableView>
#include <QTimer>
#include <set>
#include <utility>

#include "core/measure/all_channels.hpp"
#include "core/measure/open/open_recording.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/channel_browser.hpp"
#include "ui/measurement/mapping.hpp"
#include "ui/measurement/table_model.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

/// The first lines of a file, and those around what is wrong.
std::vector<FileLine> linesOf(const QString& path, const Diagnostics& problems) {
    constexpr int first = 200, around = 3, longest = 500;  // characters
    std::set<int> faulty;
    for (const Diagnostic& d : problems)
        if (d.place.line > 0) faulty.insert(d.place.line);
    QFile file(path);
    std::vector<FileLine> lines;
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) return lines;  // a pipe may never end
    const int last = std::max(first, faulty.empty() ? 0 : *faulty.rbegin() + around);
    for (int number = 1; number <= last && !file.atEnd(); ++number) {
        const QString text = QString::fromUtf8(file.readLine().trimmed().left(longest));
        const auto near = faulty.lower_bound(number - around);
        if (number <= first || (near != faulty.end() && *near <= number + around)) lines.push_back({number, text});
    }
    return lines;
}

}  // namespace

ImportPanel::ImportPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new TableModel(this)),
      title_(new QLabel(this)),
      problems_(new QLabel(this)),
      name_(new QLineEdit(this)),
      separator_(new QComboBox(this)),
      decimal_(new QComboBox(this)),
      units_(new QComboBox(this)),
      time_(new QComboBox(this)),
      role_(new QComboBox(this)),
      converted_(new QCheckBox(tr("In SI units"), this)),
      view_(new QTableView(this)),
      browser_(new ChannelBrowser(this)),
      progress_(new QProgressBar(this)),
      choose_(new QPushButton(tr("Choose channels …"), this)),
      accept_(new QPushButton(tr("Add to the study"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
    style::makeHeading(title_, 1.2);
    problems_->setWordWrap(true);
    view_->horizontalHeader()->setResizeContentsPrecision(30);  // the first rows say how wide: all would be felt
    problems_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(problems_, &QLabel::linkActivated, this, [this](const QString& line) { pointAt(line.toInt()); });
    converted_->setToolTip(tr("The values as a model in SI units gets them; the file stays as it is"));
    connect(converted_, &QCheckBox::toggled, this, [this](bool isConverted) {
        model_->setConverted(isConverted);
        view_->resizeColumnsToContents();
    });
    separator_->addItem(tr("automatic"), QString());
    for (const auto& [text, sign] :
         {std::pair{tr("comma"), ","}, {tr("semicolon"), ";"}, {tr("tab"), "\t"}, {tr("space"), " "}, {tr("bar"), "|"}})
        separator_->addItem(text, QString(sign));
    decimal_->addItem(tr("automatic"), QString());
    decimal_->addItem(tr("point"), QStringLiteral("."));
    decimal_->addItem(tr("comma"), QStringLiteral(","));
    units_->addItem(tr("automatic"), QString());
    units_->addItem(tr("yes"), QStringLiteral("1"));
    units_->addItem(tr("no"), QStringLiteral("0"));
    role_->addItem(tr("fit"), static_cast<int>(Role::Fit));
    role_->addItem(tr("validate"), static_cast<int>(Role::Validate));
    view_->setModel(model_);
    view_->setTabKeyNavigation(false);  // else Tab never leaves a long table
    view_->setFrameShape(QFrame::NoFrame);
    view_->setAlternatingRowColors(true);
    view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + style::unit);
    view_->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    view_->setSelectionMode(QAbstractItemView::NoSelection);
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setAccessibleName(tr("Preview"));
    accept_->setIcon(style::icon("apply"));
    accept_->setDefault(true);

    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(3 * style::unit);
    grid->setVerticalSpacing(style::unit / 2);
    int cell = 0;
    const auto add = [&](const QString& text, QWidget* field) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        if (cell >= 3)
            label->setContentsMargins(0, 2 * style::unit, 0, 0);  // nearer to its own field than to the upper
        field->setMinimumWidth(110);
        // the label above its field: three columns fit into a narrow panel in any language
        grid->addWidget(label, cell / 3 * 2, cell % 3, Qt::AlignLeft | Qt::AlignBottom);
        grid->addWidget(field, cell / 3 * 2 + 1, cell % 3);
        grid->setColumnStretch(cell % 3, 1);
        ++cell;
    };
    add(tr("Experiment"), name_);
    add(tr("Used to"), role_);
    add(tr("Time column"), time_);
    add(tr("Separator"), separator_);
    add(tr("Decimal sign"), decimal_);
    add(tr("Row of units"), units_);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(problems_, 1);
    buttons->addWidget(progress_);
    buttons->addWidget(choose_);
    buttons->addWidget(cancel_);
    buttons->addWidget(accept_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    auto* heading = new QHBoxLayout;
    heading->addWidget(title_, 1);
    heading->addWidget(converted_);
    layout->addLayout(heading);
    layout->addLayout(grid);
    pages_ = new QStackedLayout;
    pages_->addWidget(view_);
    pages_->addWidget(browser_);
    layout->addLayout(pages_, 1);
    layout->addLayout(buttons);
    for (QComboBox* box : {separator_, decimal_, units_})
        connect(box, &QComboBox::activated, this, &ImportPanel::readValues);
    connect(accept_, &QPushButton::clicked, this, &ImportPanel::accept);
    connect(cancel_, &QPushButton::clicked, this, [this] {
        reader_.drop();
        progress_->hide();
        Q_EMIT cancelled();
    });
    connectReading();
}

/// How far a long read is, and what of a large file is read.
void ImportPanel::connectReading() {
    constexpr int fine = 1000;
    progress_->hide();
    progress_->setTextVisible(false);
    progress_->setMaximumWidth(160);
    choose_->hide();
    connect(&reader_, &JobRunner::started, this, [this] {
        progress_->setRange(0, 0);
        progress_->show();
    });
    connect(&reader_, &JobRunner::progressed, this, [this](const Progress::Report& report) {
        if (report.fraction < 0) return;
        progress_->setRange(0, fine);
        progress_->setValue(static_cast<int>(report.fraction * fine));
    });
    connect(&reader_, &JobRunner::finished, progress_, &QProgressBar::hide);
    connect(browser_, &ChannelBrowser::readWanted, this, [this] {
        chosen_ = browser_->chosen();
        pages_->setCurrentWidget(view_);
        readValues();
    });
    connect(choose_, &QPushButton::clicked, this, &ImportPanel::browse);
}

void ImportPanel::browse() {
    pages_->setCurrentWidget(browser_);
    accept_->setEnabled(false);
    problems_->setPalette(palette());
    problems_->setText(told_ = tr("The file holds %1 channels. Tick those that are to be read; the others stay in it.")
                                   .arg(style::countText(channels_)));
}

void ImportPanel::pointAt(int line) {
    wantedLine_ = line;
    if (reader_.isBusy()) return;
    const int row = model_->showLine(std::exchange(wantedLine_, 0));
    if (row < 0) return;
    view_->setSelectionMode(QAbstractItemView::SingleSelection);
    view_->selectRow(row);
    view_->scrollTo(model_->index(row, 0), QAbstractItemView::PositionAtCenter);
}

QString ImportPanel::problems() const { return told_; }

QString ImportPanel::freeName() const {
    const QString base = QFileInfo(path_).completeBaseName();
    QString name = base;
    const auto isTaken = [&] {
        for (const StudyExperiment& e : document_.study().experiments)
            if (e.name == name.toStdString()) return true;
        return false;
    };
    for (int i = 2; isTaken(); ++i) name = QStringLiteral("%1 %2").arg(base).arg(i);
    return name;
}

void ImportPanel::show(const QString& path) {
    path_ = QFileInfo(path).absoluteFilePath();
    title_->setText(tr("Import %1").arg(QFileInfo(path).fileName()));
    for (QComboBox* box : {separator_, decimal_, units_}) box->setCurrentIndex(0);
    name_->setText(freeName());
    bool hasFit = false;
    for (const StudyExperiment& e : document_.study().experiments) hasFit = hasFit || e.role == Role::Fit;
    role_->setCurrentIndex(hasFit ? 1 : 0);
    const bool isText = QStringList{"csv", "txt", "tsv", "dat"}.contains(QFileInfo(path).suffix().toLower());
    for (QComboBox* box : {separator_, decimal_, units_}) box->setEnabled(isText);
    read();
}

/// A file of many channels is looked into before any of them is read.
void ImportPanel::read() {
    chosen_.clear();
    choose_->hide();
    pages_->setCurrentWidget(view_);
    if (separator_->isEnabled()) return readValues();
    accept_->setEnabled(false);
    problems_->setText(tr("Reading …"));
    reader_.start<Listing>(
        tr("Reading"),
        [path = path_](const Progress&) {
            const Outcome<bool> isText = isTextRecording(path.toStdString());
            if (!isText || *isText) return Listing{};
            Outcome<MeasurementFile> file = openRecording(path.toStdString());
            return Listing{file ? std::make_shared<const MeasurementFile>(std::move(*file)) : nullptr};
        },
        [this](const Listing& listing) {
            constexpr std::size_t few = 12;
            channels_ = 0;
            if (listing.file)
                for (const RecordedGroup& group : listing.file->groups)
                    channels_ += group.channels.size() - (group.masterChannel ? 1 : 0);
            if (channels_ <= few) return readValues();
            choose_->show();
            browser_->show(listing.file);
            browse();
        });
}

void ImportPanel::readValues() {
    ReadOptions options;
    const QString separator = separator_->currentData().toString(), decimal = decimal_->currentData().toString();
    if (!separator.isEmpty()) options.separator = separator.front().toLatin1();
    if (!decimal.isEmpty()) options.decimal = decimal.front().toLatin1();
    if (const QString units = units_->currentData().toString(); !units.isEmpty()) options.hasUnitsRow = units == "1";
    accept_->setEnabled(false);
    problems_->setText(tr("Reading …"));
    reader_.start<Preview>(
        tr("Reading"),
        [path = path_, isText = separator_->isEnabled(), options, chosen = chosen_](const Progress& progress) {
            Outcome<Table> read =
                readTable(path.toStdString(), options, chosen, progress, chosen.empty() ? valuesKept : 0);
            if (!read)
                return Preview{read.diagnostics(),
                               isText ? linesOf(path, read.diagnostics()) : std::vector<FileLine>()};
            const auto file = std::make_shared<const Table>(std::move(*read));
            Outcome<std::shared_ptr<const Table>> table = allOnOneRaster(file);
            if (table) {
                Diagnostics told = read.diagnostics();
                told.insert(told.end(), table.diagnostics().begin(), table.diagnostics().end());
                table = {*table, std::move(told)};
            }
            return Preview{std::move(table), {}, file, options};
        },
        [this](Preview preview) { showPreview(std::move(preview)); });
}

/// In words, each with a link to its line.
void ImportPanel::tellProblems(const Diagnostics& problems) {
    constexpr std::size_t most = 4;
    QStringList plain, linked;
    for (std::size_t i = 0; i < std::min(problems.size(), most); ++i) {
        const Diagnostic& d = problems[i];
        QString text = inWords(d.message);
        if (!d.hint.empty()) text += " " + inWords(d.hint);
        const QString line = d.place.line > 0 ? tr("line %1: ").arg(d.place.line) : QString();
        plain << line + text;
        linked << (line.isEmpty() ? QString() : QStringLiteral("<a href='%1'>%2</a>").arg(d.place.line).arg(line)) +
                      text.toHtmlEscaped();
    }
    if (problems.size() > most) {
        plain << tr("and %1 more").arg(problems.size() - most);
        linked << plain.back();
    }
    told_ = plain.join('\n');
    problems_->setText(linked.join("<br>"));
}

void ImportPanel::showPreview(Preview preview) {
    const Diagnostics problems = preview.table.diagnostics();
    table_ = preview.table ? *preview.table : nullptr;
    file_ = preview.file;
    options_ = preview.options;
    QPalette p = palette();
    p.setColor(QPalette::WindowText, table_ ? style::caution(p) : style::fault(p));
    problems_->setPalette(problems.empty() ? palette() : p);
    tellProblems(problems);
    if (problems.empty() && table_)
        problems_->setText(told_ = tr("%1 rows, %2 columns; nothing is wrong with it.")
                                       .arg(style::countText(table_->rows()))
                                       .arg(table_->columns.size()));
    TableModel::Problems byLine;
    for (const Diagnostic& d : problems)
        if (d.place.line > 0) byLine.emplace(d.place.line, inWords(d.message));
    converted_->setEnabled(table_ != nullptr);
    if (table_)
        model_->show(table_, std::move(byLine));
    else
        model_->show(std::move(preview.lines), std::move(byLine));
    view_->resizeColumnsToContents();
    time_->clear();
    if (table_) {
        for (const Column& c : table_->columns) time_->addItem(QString::fromStdString(c.name));
        time_->setCurrentText(QString::fromStdString(proposeTime(*table_)));
    }
    accept_->setEnabled(table_ && table_->columns.size() > 1);
    if (wantedLine_ > 0) QTimer::singleShot(0, this, [this] { pointAt(wantedLine_); });
}

void ImportPanel::accept() {
    if (!table_) return;
    StudyExperiment experiment;
    experiment.name = name_->text().trimmed().toStdString();
    if (experiment.name.empty()) experiment.name = freeName().toStdString();
    experiment.role = static_cast<Role>(role_->currentData().toInt());
    experiment.file = path_.toStdString();
    experiment.timeColumn = time_->currentText().toStdString();
    experiment.read = options_;
    proposeMapping(experiment, *table_, document_.facts(), document_.study().experiments);
    StudySettings settings = document_.settings();
    settings.tables[tableKey(experiment)] = file_;
    settings.experiments.push_back(experiment);
    document_.applySettings(std::move(settings), tr("Import %1").arg(QFileInfo(path_).fileName()));
    Q_EMIT accepted(QString::fromStdString(experiment.name));
}

}  // namespace analogon::ui
