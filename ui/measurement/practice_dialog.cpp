#include "ui/measurement/practice_dialog.hpp"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/whole_file.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/study/free_run.hpp"
#include "core/study/recorded.hpp"
#include "core/study/study_with.hpp"
#include "ui/document/document.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr int outputColumn = 0, noiseColumn = 1;

/// 1, 2 or 5 times a power of ten, not above.
double rounded(double value) {
    if (!(value > 0) || !std::isfinite(value)) return 0;
    const double power = std::pow(10.0, std::floor(std::log10(value) + 1e-9));
    const double lead = value / power + 1e-9;
    return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

QString numberOf(double value) { return style::numberText(value, 6); }

/// What is left of a file name that two recordings would share.
QString freeFile(const QString& folder) {
    QString path;
    for (int i = 1; path.isEmpty() || QFileInfo::exists(path); ++i)
        path =
            QDir(folder).filePath(i == 1 ? QStringLiteral("practice.csv") : QStringLiteral("practice-%1.csv").arg(i));
    return path;
}

/// The file as the study will read it.
Outcome<std::shared_ptr<const Table>> written(const ExperimentState& run, const PracticeOptions& options,
                                              const std::filesystem::path& file) {
    const Outcome<Table> made = practiceRecording(run, options);
    if (!made) return made.diagnostics();
    if (const Outcome<Done> done = writeWhole(file, writeCsv(*made)); !done) return done.diagnostics();
    Outcome<Table> table = readTable(file);
    if (!table) return table.diagnostics();
    return std::make_shared<const Table>(std::move(*table));
}

}  // namespace

PracticeDialog::PracticeDialog(Document& document, const QString& folder, QWidget* parent)
    : QDialog(parent),
      document_(document),
      run_(document.after() ? document.after() : document.before()),
      sampleTime_(new QLineEdit(this)),
      file_(new QLineEdit(this)),
      seed_(new QSpinBox(this)),
      noise_(new QTableWidget(this)),
      fault_(new QLabel(this)),
      record_(new QPushButton(tr("Record"), this)) {
    setObjectName("practice-dialog");
    setWindowTitle(tr("Record as measurement"));
    setAttribute(Qt::WA_DeleteOnClose);
    fault_->setWordWrap(true);
    style::makeCaption(fault_);
    auto* cancel = new QPushButton(tr("Cancel"), this);
    record_->setDefault(true);
    record_->setIcon(style::icon("recording"));
    cancel->setAutoDefault(false);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(record_);
    buttons->addWidget(cancel);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addLayout(fields());
    layout->addWidget(noise_, 1);
    layout->addWidget(fault_);
    layout->addLayout(buttons);
    fill(folder);
    resize(110 * style::unit, sizeHint().height());
    for (QLineEdit* field : {sampleTime_, file_}) connect(field, &QLineEdit::textChanged, this, &PracticeDialog::check);
    connect(noise_, &QTableWidget::cellChanged, this, &PracticeDialog::check);
    connect(record_, &QPushButton::clicked, this, &PracticeDialog::record);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(&document, &Document::opened, this, &QDialog::reject);
    check();
}

QLayout* PracticeDialog::fields() {
    seed_->setRange(1, 999999);
    seed_->setToolTip(tr("The same number gives the same noise"));
    seed_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    sampleTime_->setAccessibleName(tr("Sample time"));
    file_->setAccessibleName(tr("File"));
    auto* browse = new QToolButton(this);
    browse->setText(QStringLiteral("…"));
    browse->setToolTip(tr("Choose where the file goes"));
    connect(browse, &QToolButton::clicked, this, &PracticeDialog::askForFile);
    auto* place = new QHBoxLayout;
    place->addWidget(file_, 1);
    place->addWidget(browse);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(3 * style::unit);
    form->setVerticalSpacing(2 * style::unit);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    form->addRow(tr("File"), place);
    form->addRow(tr("Sample time [s]"), sampleTime_);
    form->addRow(tr("Seed of the noise"), seed_);
    return form;
}

/// A thousand samples, and noise of half a percent of what each output does, until the user says otherwise.
void PracticeDialog::fill(const QString& folder) {
    noise_->setColumnCount(2);
    noise_->setHorizontalHeaderLabels({tr("Output"), tr("Noise (standard deviation)")});
    noise_->setAccessibleName(tr("Noise of each output"));
    noise_->verticalHeader()->hide();
    noise_->setTabKeyNavigation(false);
    noise_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    noise_->setSelectionMode(QAbstractItemView::SingleSelection);
    const QString beside = document_.path().isEmpty() ? QString() : QFileInfo(document_.path()).absolutePath();
    const bool isThere = !folder.isEmpty() && QFileInfo(folder).isDir();
    file_->setText(freeFile(isThere ? folder : !beside.isEmpty() ? beside : QDir::homePath()));
    const std::string name = freeRunName(document_.study());
    if (run_)
        for (const ExperimentState& e : run_->experiments)
            if (e.name == name) experiment_ = &e;
    if (!experiment_ || experiment_->time.empty()) return;
    sampleTime_->setText(numberOf(rounded((experiment_->time.back() - experiment_->time.front()) / 1000)));
    noise_->setRowCount(static_cast<int>(experiment_->outputs.size()));
    for (int row = 0; row < noise_->rowCount(); ++row) {
        const OutputState& output = experiment_->outputs[static_cast<std::size_t>(row)];
        const QString unit = QString::fromStdString(output.unit);
        auto* called = new QTableWidgetItem(QString::fromStdString(output.name) +
                                            (unit.isEmpty() ? QString() : QStringLiteral(" [%1]").arg(unit)));
        called->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        noise_->setItem(row, outputColumn, called);
        auto* deviation = new QTableWidgetItem(
            numberOf(rounded(0.005 * (output.simulated.maxCoeff() - output.simulated.minCoeff()))));
        deviation->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        noise_->setItem(row, noiseColumn, deviation);
    }
}

void PracticeDialog::askForFile() {
    auto* dialog = new QFileDialog(this, tr("Where the recording goes"), file_->text());
    dialog->setObjectName("practice-file-dialog");
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("CSV (*.csv)"));
    dialog->setDefaultSuffix("csv");
    connect(dialog, &QFileDialog::fileSelected, file_, &QLineEdit::setText);
    dialog->open();
}

std::optional<PracticeOptions> PracticeDialog::options(QString& why) const {
    PracticeOptions options;
    options.seed = static_cast<std::uint64_t>(seed_->value());
    const std::optional<double> sampleTime = style::readNumber(sampleTime_->text());
    if (!sampleTime || !(*sampleTime > 0)) {
        why = tr("The sample time is a number of seconds above 0.");
        return std::nullopt;
    }
    options.sampleTime = *sampleTime;
    for (int row = 0; row < noise_->rowCount(); ++row) {
        const QString typed = noise_->item(row, noiseColumn)->text();
        const std::optional<double> deviation =
            typed.trimmed().isEmpty() ? std::optional(0.0) : style::readNumber(typed);
        if (!deviation || *deviation < 0) {
            why = tr("The noise of %1 is a number, 0 or above.").arg(noise_->item(row, outputColumn)->text());
            return std::nullopt;
        }
        options.noise[experiment_->outputs[static_cast<std::size_t>(row)].name] = *deviation;
    }
    return options;
}

/// What keeps the recording from being made is said before it is asked for; nothing of the user's is overwritten.
void PracticeDialog::check() {
    QString why;
    const QFileInfo file(file_->text().trimmed());
    if (!experiment_)
        why = tr("Simulate the model first (F4).");
    else if (file_->text().trimmed().isEmpty() || file.isDir())
        why = tr("Give the file a name.");
    else if (!file.absoluteDir().exists())
        why = tr("There is no folder %1.").arg(file.absolutePath());
    else if (file.exists())
        why = tr("There is a file of that name already: choose another one.");
    else
        options(why);
    fault_->setText(why.isEmpty() ? tr("The file becomes a recording of the study, to fit from.") : why);
    style::tint(*fault_, why.isEmpty() ? nullptr : style::fault);
    record_->setEnabled(why.isEmpty() && !writer_.isBusy());
}

void PracticeDialog::record() {
    QString why;
    const std::optional<PracticeOptions> wanted = options(why);
    if (!wanted || !experiment_) return;
    QString path = QFileInfo(file_->text().trimmed()).absoluteFilePath();
    if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".csv");
    if (QFileInfo::exists(path)) return file_->setText(path);  // which says so
    writer_.start<Outcome<std::shared_ptr<const Table>>>(
        tr("Recording"),
        [run = run_, experiment = experiment_, wanted = *wanted, path](const Progress&) {
            return written(*experiment, wanted, path.toStdString());
        },
        [this, path](const Outcome<std::shared_ptr<const Table>>& table) {
            if (table) return add(*table, path);
            check();
            const Diagnostic& fault = table.diagnostics().front();
            fault_->setText(inWords(fault.message) +
                            (fault.hint.empty() ? QString() : QStringLiteral("\n") + inWords(fault.hint)));
        });
    record_->setEnabled(false);
}

void PracticeDialog::add(const std::shared_ptr<const Table>& table, const QString& path) {
    StudyExperiment experiment;
    experiment.name = freeExperimentName(document_.study(), QFileInfo(path).completeBaseName().toStdString());
    experiment.file = path.toStdString();
    experiment.timeColumn = "time";
    for (const SignalFact& output : document_.facts().outputs)
        if (table->find(output.name)) experiment.outputs[output.name].column = output.name;
    StudySettings settings = document_.settings();
    settings.tables[tableKey(experiment)] = table;
    settings.experiments.push_back(experiment);
    document_.applySettings(std::move(settings), tr("Record %1").arg(QFileInfo(path).fileName()));
    Q_EMIT recorded(QString::fromStdString(experiment.name), path);
    accept();
}

}  // namespace analogon::ui
