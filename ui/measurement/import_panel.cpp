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
#include <QScrollArea>
#include <QStackedLayout>
#include <QTableView>
#include <QTimer>
#include <utility>

#include "core/measure/all_channels.hpp"
#include "core/measure/open/open_recording.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/study/recorded.hpp"
#include "core/study/study_with.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/channel_browser.hpp"
#include "ui/measurement/mapping.hpp"
#include "ui/measurement/question_card.hpp"
#include "ui/measurement/read_fields.hpp"
#include "ui/measurement/table_model.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

std::size_t channelsIn(const MeasurementFile& file) {
    std::size_t count = 0;
    for (const RecordedGroup& group : file.groups)
        for (std::size_t i = 0; i < group.channels.size(); ++i)
            count += group.masterChannel != i && group.channels[i].kind != ChannelKind::Text ? 1 : 0;
    return count;
}

/// So many that one looks into the file before any is taken.
bool hasMany(const MeasurementFile& file) {
    constexpr std::size_t few = 12;
    return channelsIn(file) > few;
}

}  // namespace

ImportPanel::ImportPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new TableModel(this)),
      title_(new QLabel(this)),
      problems_(new QLabel(this)),
      name_(new QLineEdit(this)),
      time_(new QComboBox(this)),
      role_(new QComboBox(this)),
      fields_(new ReadFields(this)),
      question_(new QuestionCard(this)),
      converted_(new QCheckBox(tr("In SI units"), this)),
      view_(new QTableView(this)),
      browser_(new ChannelBrowser(this)),
      progress_(new QProgressBar(this)),
      choose_(new QPushButton(tr("Choose channels …"), this)),
      accept_(new QPushButton(tr("Add to the study"), this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      scroll_(new QScrollArea(this)) {
    style::makeHeading(title_, 1.2);
    problems_->setWordWrap(true);
    problems_->setObjectName("problems");
    problems_->setTextInteractionFlags(Qt::TextBrowserInteraction);
    converted_->setToolTip(tr("The values as a model in SI units gets them; the file stays as it is"));
    role_->addItem(tr("fit"), static_cast<int>(Role::Fit));
    role_->addItem(tr("validate"), static_cast<int>(Role::Validate));
    time_->setPlaceholderText(tr("choose it"));
    view_->horizontalHeader()->setResizeContentsPrecision(30);  // the first rows say how wide: all would be felt
    view_->setModel(model_);
    view_->setTabKeyNavigation(false);  // else Tab never leaves a long table
    view_->setFrameShape(QFrame::NoFrame);
    view_->setAlternatingRowColors(true);
    view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + style::unit);
    view_->horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    view_->setSelectionMode(QAbstractItemView::NoSelection);
    view_->setSelectionBehavior(QAbstractItemView::SelectRows);
    view_->setAccessibleName(tr("Preview"));
    view_->setObjectName("preview");
    accept_->setIcon(style::icon("apply"));
    accept_->setDefault(true);
    layOut();
    connectFields();
    connectReading();
}

void ImportPanel::layOut() {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(3 * style::unit);
    grid->setVerticalSpacing(style::unit / 2);
    int column = 0;
    for (const auto& [text, field] : std::initializer_list<std::pair<QString, QWidget*>>{
             {tr("Experiment"), name_}, {tr("Used to"), role_}, {tr("Time column"), time_}}) {
        auto* label = new QLabel(text, this);
        label->setBuddy(field);
        field->setMinimumWidth(110);
        grid->addWidget(label, 0, column, Qt::AlignLeft | Qt::AlignBottom);
        grid->addWidget(field, 1, column);
        grid->setColumnStretch(column++, 1);
    }
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(progress_);
    buttons->addStretch(1);
    buttons->addWidget(cancel_);
    buttons->addWidget(browser_->readButton());  // at hand however far the channels are scrolled
    buttons->addWidget(accept_);
    auto* telling = new QHBoxLayout;
    telling->addWidget(problems_, 1);
    telling->addWidget(choose_);
    auto* heading = new QHBoxLayout;
    heading->addWidget(title_, 1);
    heading->addWidget(converted_);
    shown_ = new QWidget(this);
    pages_ = new QStackedLayout(shown_);
    pages_->addWidget(view_);
    pages_->addWidget(browser_);
    view_->setMinimumHeight(6 * (fontMetrics().height() + style::unit));
    auto* page = new QWidget(this);  // longer than the panel where much is asked
    auto* inner = new QVBoxLayout(page);
    inner->setContentsMargins(0, 0, 0, 0);
    inner->setSpacing(2 * style::unit);
    inner->addLayout(grid);
    inner->addWidget(fields_);
    inner->addWidget(question_);
    inner->addWidget(shown_, 1);
    inner->addStretch(0);
    scroll_->setWidget(page);
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addLayout(heading);
    layout->addWidget(scroll_, 1);
    layout->addLayout(telling);  // above the buttons: beside them a narrow window leaves it a word a line
    layout->addLayout(buttons);
    question_->hide();
    showPage(view_);
}

void ImportPanel::showPage(QWidget* page) {
    const bool isBrowsing = page == browser_;
    pages_->setCurrentWidget(page);
    browser_->readButton()->setVisible(isBrowsing);
    accept_->setVisible(!isBrowsing);
    if (isBrowsing) choose_->hide();  // there one chooses
}

void ImportPanel::connectFields() {
    connect(problems_, &QLabel::linkActivated, this, [this](const QString& line) { pointAt(line.toInt()); });
    connect(converted_, &QCheckBox::toggled, this, [this](bool isConverted) {
        model_->setConverted(isConverted);
        view_->resizeColumnsToContents();
    });
    connect(fields_, &ReadFields::changed, this, [this] {
        chosen_.clear();
        readText();
    });
    connect(question_, &QuestionCard::answered, this, &ImportPanel::takeAnswer);
    connect(time_, &QComboBox::activated, this, [this] {
        if (!recording_ && isText_) question_->hide();
        allowAccept();
    });
    connect(accept_, &QPushButton::clicked, this, &ImportPanel::accept);
    connect(cancel_, &QPushButton::clicked, this, [this] {
        reader_.drop();
        progress_->hide();
        Q_EMIT cancelled();
    });
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
        showPage(view_);
        if (isText_)
            takeChosen();
        else
            readValues();
    });
    connect(choose_, &QPushButton::clicked, this, &ImportPanel::browse);
}

/// A unit changes nothing about which channels there are.
void ImportPanel::takeAnswer(const ReadOptions& options) {
    const bool isUnit = question_->kind() == Question::Kind::Unit;
    options_ = options;
    fields_->show(options);
    if (!isUnit) chosen_.clear();
    if (isText_)
        readText();
    else
        readValues();
}

void ImportPanel::browse() {
    shown_->show();
    showPage(browser_);
    accept_->setEnabled(false);
    style::tint(*problems_, nullptr);
    problems_->setText(told_ = tr("The file holds %1 channels. Tick those that are to be read; the others stay in it.")
                                   .arg(style::countText(channelsIn(*recording_))));
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
    return QString::fromStdString(
        freeExperimentName(document_.study(), QFileInfo(path_).completeBaseName().toStdString()));
}

void ImportPanel::show(const QString& path) {
    path_ = QFileInfo(path).absoluteFilePath();
    title_->setText(tr("Import %1").arg(QFileInfo(path).fileName()));
    fields_->show({});
    name_->setText(freeName());
    bool hasFit = false;
    for (const StudyExperiment& e : document_.study().experiments) hasFit = hasFit || e.role == Role::Fit;
    role_->setCurrentIndex(hasFit ? 1 : 0);
    read();
}

/// A file of many channels is looked into before any of them is read.
void ImportPanel::read() {
    chosen_.clear();
    options_ = {};
    choose_->hide();
    question_->hide();
    shown_->show();
    showPage(view_);
    accept_->setEnabled(false);
    problems_->setText(tr("Reading …"));
    reader_.start<Look>(
        tr("Reading"),
        [path = path_.toStdString()](const Progress& progress) {
            const Outcome<bool> isText = isTextRecording(path);
            if (!isText) return Look{false, nullptr, {isText.diagnostics()}};
            if (*isText) return Look{true, nullptr, previewOfText(path, {}, {}, progress)};
            if (Outcome<MeasurementFile> file = openRecording(path); file && hasMany(*file))
                return Look{false, std::make_shared<const MeasurementFile>(std::move(*file)), {Diagnostic{}}};
            return Look{false, nullptr, previewOf(path, {}, {}, progress)};
        },
        [this](Look look) { showLook(std::move(look)); });
}

void ImportPanel::showLook(Look look) {
    isText_ = look.isText;
    fields_->setVisible(isText_);
    recording_ = look.recording;
    if (!recording_) return showPreview(std::move(look.preview));
    browser_->show(recording_);
    browse();
}

/// Of a file that is no text: the channels that were chosen.
void ImportPanel::readValues() {
    accept_->setEnabled(false);
    problems_->setText(tr("Reading …"));
    reader_.start<Preview>(
        tr("Reading"),
        [path = path_.toStdString(), options = options_, chosen = chosen_](const Progress& progress) {
            return previewOf(path, options, chosen, progress);
        },
        [this](Preview preview) { showPreview(std::move(preview)); });
}

void ImportPanel::readText() {
    accept_->setEnabled(false);
    problems_->setText(tr("Reading …"));
    reader_.start<Preview>(
        tr("Reading"),
        [path = path_.toStdString(), options = fields_->options(), chosen = chosen_](const Progress& progress) {
            return previewOfText(path, options, chosen, progress);
        },
        [this](Preview preview) { showPreview(std::move(preview)); });
}

void ImportPanel::takeChosen() {
    accept_->setEnabled(false);
    reader_.start<Preview>(
        tr("Reading"),
        [file = file_, chosen = chosen_, told = whole_, options = options_, recording = recording_](const Progress&) {
            return complete({onOneRaster(file, chosen, told), {}, file, options, recording, told});
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
        const bool isSentence = text.endsWith('.') || text.endsWith('?') || text.endsWith(':');
        if (!d.hint.empty()) text += (isSentence ? " " : ". ") + inWords(d.hint);
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

/// What is shown between two samples of a slow channel was not measured.
void ImportPanel::tellRates() {
    const QString rates = tr("There are %1 times, each with channels of its own. Here they stand on the stamps of all, "
                             "on straight lines between their own; a model takes each at its own.")
                              .arg(file_->others.size() + 1);
    told_ += ' ' + rates;
    problems_->setText(problems_->text() + ' ' + rates.toHtmlEscaped());
}

void ImportPanel::showPreview(Preview preview) {
    const Diagnostics problems = preview.table.diagnostics();
    table_ = preview.table ? *preview.table : nullptr;
    file_ = preview.file;
    options_ = preview.options;
    if (isText_) {
        recording_ = preview.recording;
        whole_ = preview.told;
    }
    ask(preview);
    style::tint(*problems_, problems.empty() ? nullptr : table_ ? style::caution : style::fault);
    // a question tells what is wrong, and the rows of the file
    const bool isAsked = !preview.asked.empty() && !table_;
    tellProblems(isAsked ? Diagnostics{} : problems);
    shown_->setVisible(!isAsked);
    if (problems.empty() && table_)
        problems_->setText(told_ = (preview.asked.empty() ? tr("%1 rows, %2 columns; nothing is wrong with it.")
                                                          : tr("%1 rows, %2 columns; a question is open."))
                                       .arg(style::countText(table_->rows()))
                                       .arg(table_->columns.size()));
    if (table_ && !file_->others.empty()) tellRates();
    TableModel::Problems byLine;
    for (const Diagnostic& d : problems)
        if (d.place.line > 0) byLine.emplace(d.place.line, inWords(d.message));
    converted_->setEnabled(table_ != nullptr);
    if (table_)
        model_->show(table_, std::move(byLine));
    else
        model_->show(std::move(preview.lines), std::move(byLine));
    view_->resizeColumnsToContents();
    showTimes(preview.time);
    const bool isToBeChosen = isText_ && recording_ && hasMany(*recording_);
    choose_->setVisible(recording_ && hasMany(*recording_));
    if (isToBeChosen && chosen_.empty()) {
        browser_->show(recording_);
        browse();
    }
    if (wantedLine_ > 0) QTimer::singleShot(0, this, [this] { pointAt(wantedLine_); });
}

/// The first of what the file does not tell: another question may follow from its answer.
void ImportPanel::ask(const Preview& preview) {
    question_->setVisible(!preview.asked.empty());
    if (preview.asked.empty()) return;
    question_->ask(preview.asked.front(), preview.rows, preview.options);
    QTimer::singleShot(0, this, [this] { scroll_->ensureWidgetVisible(question_); });
}

void ImportPanel::showTimes(const std::string& proposed) {
    time_->clear();
    if (table_) {
        for (const Column& c : table_->columns) time_->addItem(QString::fromStdString(c.name));
        time_->setCurrentIndex(time_->findText(QString::fromStdString(proposed)));
    }
    allowAccept();
}

/// Nothing is taken for the time that nobody calls it.
void ImportPanel::allowAccept() {
    accept_->setEnabled(table_ && table_->columns.size() > 1 && time_->currentIndex() >= 0);
    if (table_ && time_->currentIndex() < 0 && (question_->isHidden() || question_->kind() == Question::Kind::Unit))
        problems_->setText(told_ = tr("No column is a time by its name or unit: choose the one that is."));
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
