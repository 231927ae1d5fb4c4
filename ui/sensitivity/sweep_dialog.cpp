#include "ui/sensitivity/sweep_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QShortcut>
#include <QSpinBox>
#include <QUndoStack>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/document/document.hpp"
#include "ui/inspector/knob.hpp"
#include "ui/sensitivity/sweep_chart.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

SweepDialog::SweepDialog(Document& document, QWidget* parent)
    : QDialog(parent),
      document_(document),
      outcome_(new QLabel(this)),
      chart_(new SweepChart(this)),
      progress_(new QProgressBar(this)),
      run_(new QPushButton(this)) {
    setWindowTitle(tr("Sweep of parameters"));
    setAttribute(Qt::WA_DeleteOnClose);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(2 * style::unit);
    int column = 0;
    for (const QString& head : {QString(), tr("from"), tr("to"), tr("Values")})
        grid->addWidget(new QLabel(head, this), 0, column++);
    for (const int i : {0, 1}) addAxis(*grid, i);
    grid->setColumnStretch(0, 2);
    for (const int stretched : {1, 2}) grid->setColumnStretch(stretched, 1);
    outcome_->setWordWrap(true);
    style::makeCaption(outcome_);
    outcome_->setText(tr("The error of the fitted recordings at each value; nothing is fitted, and the study stays."));
    style::makeQuiet(progress_);
    run_->setDefault(true);
    auto* bottom = new QHBoxLayout;
    bottom->addWidget(progress_, 1);
    bottom->addWidget(run_);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(grid);
    layout->addWidget(outcome_);
    layout->addWidget(chart_, 1);
    layout->addLayout(bottom);
    resize(160 * style::unit, 150 * style::unit);
    fillParameters();
    connect(run_, &QPushButton::clicked, this, [this] { worker_.isBusy() ? worker_.cancel() : start(); });
    connect(&worker_, &JobRunner::started, this, &SweepDialog::follow);
    connect(&worker_, &JobRunner::finished, this, &SweepDialog::follow);
    connect(&worker_, &JobRunner::progressed, this, [this](const Progress::Report& report) {
        if (report.stage == "sweep") progress_->setValue(static_cast<int>(1000 * report.fraction));
    });
    connect(&document, &Document::factsChanged, this, &SweepDialog::fillParameters);
    connect(chart_, &SweepChart::chosen, this, &SweepDialog::take);
    connect(chart_, &SweepChart::pointedAt, this, [this](const SweepPoint& point) {
        outcome_->setText(tr("%1. %2. Enter sets this.")
                              .arg(chart_->wordsOf(point).join(QStringLiteral(", ")), chart_->errorWordsOf(point)));
    });
    for (const auto changed : {&Document::factsChanged, &Document::parametersChanged, &Document::modelChanged})
        connect(&document, changed, this, &SweepDialog::showPresent);
    connect(new QShortcut(QKeySequence::Undo, this), &QShortcut::activated, &document.undoStack(), &QUndoStack::undo);
    connect(new QShortcut(QKeySequence::Redo, this), &QShortcut::activated, &document.undoStack(), &QUndoStack::redo);
    connect(&document, &Document::opened, this, &QDialog::close);
    follow();
}

void SweepDialog::addAxis(QGridLayout& grid, int i) {
    Axis& axis = axes_[static_cast<std::size_t>(i)];
    axis = {new QComboBox(this), new QLineEdit(this), new QLineEdit(this), new QSpinBox(this),
            new QCheckBox(tr("by equal factors"), this)};
    axis.parameter->setAccessibleName(i == 0 ? tr("Parameter") : tr("Second parameter"));
    axis.parameter->setMinimumContentsLength(14);
    axis.from->setAccessibleName(tr("from"));
    axis.to->setAccessibleName(tr("to"));
    axis.count->setAccessibleName(tr("Values"));
    axis.count->setRange(2, 200);
    axis.count->setValue(21);
    int column = 0;
    for (QWidget* widget :
         std::initializer_list<QWidget*>{axis.parameter, axis.from, axis.to, axis.count, axis.byFactors})
        grid.addWidget(widget, i + 1, column++);
    connect(axis.parameter, &QComboBox::currentIndexChanged, this, [this, i] { proposeRange(i); });
    for (QLineEdit* field : {axis.from, axis.to}) connect(field, &QLineEdit::textChanged, this, &SweepDialog::follow);
}

/// What is fitted comes first; the choice stays.
void SweepDialog::fillParameters() {
    QStringList fitted, others;
    const auto& settings = document_.study().parameters;
    for (const ParameterFact& fact : document_.facts().parameters) {
        const auto setting = settings.find(fact.name);
        (setting != settings.end() && setting->second.fit ? fitted : others) << QString::fromStdString(fact.name);
    }
    for (const int i : {0, 1}) {
        QComboBox& box = *axes_[static_cast<std::size_t>(i)].parameter;
        const QString chosen = box.currentText();
        const QSignalBlocker quiet(&box);
        box.clear();
        if (i == 1) box.addItem(tr("(none)"));
        box.addItems(fitted + others);
        box.setCurrentIndex(std::max(0, box.findText(chosen)));
        if (box.currentText() != chosen) proposeRange(i);
    }
    follow();
}

void SweepDialog::proposeRange(int i) {
    const Axis& own = axis(i);
    const std::string name = own.parameter->currentText().toStdString();
    const auto& facts = document_.facts().parameters;
    const auto fact = std::find_if(facts.begin(), facts.end(), [&](const ParameterFact& f) { return f.name == name; });
    const bool isChosen = fact != facts.end();
    for (QWidget* widget : std::initializer_list<QWidget*>{own.from, own.to, own.count, own.byFactors})
        widget->setEnabled(isChosen);
    if (isChosen) {
        // About the value: bounds are far wider than what is worth a look.
        const KnobRange range = knobRange(document_.parameterValue(name).value_or(fact->value.value_or(0)), fact->min,
                                          {}, ParameterScale::Automatic);
        own.from->setText(style::numberText(range.low, 4));
        own.to->setText(style::numberText(range.high, 4));
        own.byFactors->setChecked(range.isLogarithmic);
    }
    follow();
}

std::optional<SweepAxis> SweepDialog::wanted(int i) {
    const Axis& own = axis(i);
    const auto from = style::readNumber(own.from->text()), to = style::readNumber(own.to->text());
    if (!own.from->isEnabled() || !from || !to || *from == *to) return {};
    const bool isByFactors = own.byFactors->isChecked() && *from * *to > 0;
    return SweepAxis{own.parameter->currentText().toStdString(),
                     sweepValues(*from, *to, own.count->value(), isByFactors)};
}

void SweepDialog::start() {
    std::vector<SweepAxis> axes;
    for (const int i : {0, 1})
        if (std::optional<SweepAxis> own = wanted(i)) axes.push_back(std::move(*own));
    progress_->setRange(0, 1000);
    progress_->setValue(0);
    outcome_->setText(tr("Simulating …"));
    worker_.start<Outcome<ParameterSweep>>(
        windowTitle(),
        [study = document_.study(), axes](const Progress& progress) { return analogon::sweep(study, axes, progress); },
        [this](Outcome<ParameterSweep> found) { showOutcome(std::move(found)); });
}

void SweepDialog::showOutcome(Outcome<ParameterSweep> found) {
    sweep_ = found ? std::optional(std::move(*found)) : std::nullopt;
    chart_->setSweep(sweep_);
    if (!found) {
        QStringList why;
        for (const Diagnostic& said : found.diagnostics())
            if (said.severity == Severity::Error) why << inWords(said.message);
        outcome_->setText(why.join('\n'));
    } else {
        const auto [row, column] = sweep_->least();
        QStringList said;
        if (sweep_->done < sweep_->errorPercent.size())
            said << tr("Stopped after %1 of %2 simulations.").arg(sweep_->done).arg(sweep_->errorPercent.size());
        if (row < 0) {
            said << tr("The model cannot be simulated at any of these values.");
        } else {
            said << tr("Least error %1 at %2.")
                        .arg(style::percentText(sweep_->errorPercent(row, column)),
                             chart_->wordsOf({row, column}).join(QStringLiteral(", ")));
            if (sweep_->axes.size() > 1) said << tr("The stronger the colour, the smaller the error.");
            said << tr("A click sets what is there.");
        }
        outcome_->setText(said.join(' '));
    }
    showPresent();
}

void SweepDialog::take(const SweepPoint& point) {
    const std::vector<double> values = chart_->valuesAt(point);
    std::vector<std::pair<std::string, double>> wanted;
    QStringList names;
    for (std::size_t i = 0; i < values.size(); ++i) {
        wanted.emplace_back(sweep_->axes[i].parameter, values[i]);
        names << QString::fromStdString(sweep_->axes[i].parameter);
    }
    if (!document_.setParameterValues(wanted, tr("Set %1").arg(names.join(QStringLiteral(", "))))) {
        outcome_->setText(tr("This could not be set: the messages say why."));
        return;
    }
    outcome_->setText(tr("Set: %1. %2. Undo takes it back.")
                          .arg(chart_->wordsOf(point).join(QStringLiteral(", ")), chart_->errorWordsOf(point)));
}

void SweepDialog::showPresent() {
    std::vector<double> present;
    if (sweep_)
        for (const SweepAxis& axis : sweep_->axes)
            present.push_back(document_.parameterValue(axis.parameter).value_or(NAN));
    chart_->setPresent(std::move(present));
}

void SweepDialog::follow() {
    run_->setText(worker_.isBusy() ? tr("Stop") : tr("Simulate"));
    progress_->setVisible(worker_.isBusy());
    const bool hasSecond = axes_[1].from->isEnabled();
    const bool isSame = hasSecond && axes_[0].parameter->currentText() == axes_[1].parameter->currentText();
    run_->setEnabled(worker_.isBusy() ? !worker_.isCancelling() : wanted(0) && (!hasSecond || wanted(1)) && !isSame);
}

}  // namespace analogon::ui
