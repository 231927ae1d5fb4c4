#include "ui/effect/result_panel.hpp"

#include <QEvent>
#include <QFrame>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/number_text.hpp"
#include "core/report/words.hpp"
#include "ui/document/document.hpp"
#include "ui/document/mention.hpp"
#include "ui/effect/finding_words.hpp"
#include "ui/effect/result_table.hpp"
#include "ui/style/find_key.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

QString text(const std::string& s) { return QString::fromStdString(s); }

}  // namespace

ResultPanel::ResultPanel(Document& document, QWidget* parent) : QScrollArea(parent), document_(document) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    // A run that is taken over changes all three at once: the page is built only then.
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &ResultPanel::refresh);
    style::findBy(*this, [this] { return filter_; });
    const auto refreshSoon = [this] { soon_.start(0); };
    connect(verticalScrollBar(), &QScrollBar::valueChanged, this, [this] {
        if (!candidates_ || !candidates_->viewport()->underMouse()) return;
        const QPoint at = candidates_->viewport()->mapFromGlobal(QCursor::pos());
        lookAt(candidates_->itemAt(at));  // another row has come under the pointer, which did not move
    });
    connect(&document, &Document::resultChanged, this, refreshSoon);
    connect(&document, &Document::modelChanged, this, refreshSoon);
    connect(&document, &Document::parametersChanged, this, refreshSoon);
    refresh();
}

QString ResultPanel::headline() const { return headline_ ? headline_->text() : QString(); }

QLabel* ResultPanel::addText(const QString& content, bool isCaption) {
    auto* label = new QLabel(content, body_);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    if (isCaption) style::makeCaption(label);
    column_->addWidget(label);
    return label;
}

void ResultPanel::makeLinks(QLabel* label, const QString& html) {
    label->setTextFormat(Qt::RichText);
    label->setText(html);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::LinksAccessibleByMouse |
                                   Qt::LinksAccessibleByKeyboard);
    connect(label, &QLabel::linkActivated, this, [this](const QString& target) {
        if (const auto mention = mentionAt(target)) Q_EMIT mentionChosen(*mention);
    });
}

void ResultPanel::addHeading(const QString& content) {
    column_->addSpacing(2 * style::unit);
    auto* label = new QLabel(content, body_);
    style::makeHeading(label, 1.0);
    column_->addWidget(label);
}

/// The row under the pointer, else the marked one: its place in the diagram, and what it would bring.
void ResultPanel::lookAt(const QTreeWidgetItem* candidate) {
    if (candidate && candidate->data(2, KindRole).isNull()) candidate = nullptr;  // the heading of a round
    Q_EMIT placePointedAt(candidate ? candidate->data(1, KindRole).toString() : QString());
    if (!candidate || document_.isResultStale()) return Q_EMIT effectLeft();
    const EffectChoice choice{candidate->data(2, KindRole).toString().toStdString(),
                              candidate->data(3, KindRole).toString().toStdString()};
    Q_EMIT effectLookedAt(choice, candidate->text(0));
}

bool ResultPanel::eventFilter(QObject* watched, QEvent* event) {
    if (candidates_ && watched == candidates_->viewport() && event->type() == QEvent::Leave)
        lookAt(candidates_->currentItem());
    if (candidates_ && watched == candidates_->viewport() && event->type() == QEvent::Resize) giveNamesRoom();
    return QScrollArea::eventFilter(watched, event);
}

void ResultPanel::refresh() {
    if (candidates_) lookAt(nullptr);  // its rows are about to go
    headline_ = nullptr;
    candidates_ = comparison_ = nullptr;
    try_ = longer_ = nullptr;
    filter_ = nullptr;
    byRound_ = nullptr;
    body_ = new QWidget;
    body_->setBackgroundRole(QPalette::Base);
    body_->setAutoFillBackground(true);
    column_ = new QVBoxLayout(body_);
    column_->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    column_->setSpacing(style::unit);
    const Finding* finding = document_.finding();
    if (!document_.isOpen() || !finding || document_.resultKind() == RunKind::Simulate) {
        body_->setBackgroundRole(QPalette::Window);  // as every panel without content
        addEmptyState();
    } else {
        addHeadline(*finding);
        addAdoption();
        addComparison(*finding);
        addCautions(*finding);
        for (const AddedEffect& effect : finding->effects) addEffect(effect, finding->effects.size() > 1);
        addRemainder(*finding);
        if (!finding->candidates.empty()) addCandidates(*finding);
    }
    column_->addStretch(1);
    setWidget(body_);  // deletes the old page
}

void ResultPanel::addEmptyState() {
    column_->addStretch(1);
    auto* label = addText(document_.isOpen() ? tr("<b>Fit</b> estimates the parameters.<br><b>Discover</b> also asks "
                                                  "what the model lacks, adds it and shows the evidence here.")
                                             : tr("Results appear here once a study is open."),
                          true);
    label->setAlignment(Qt::AlignCenter);
}

void ResultPanel::addHeadline(const Finding& finding) {
    const FindingWords h = findingWords(finding, document_.resultKind());
    headline_ = new QLabel(h.title, body_);
    headline_->setWordWrap(true);
    style::makeHeading(headline_, 1.3);
    style::tint(*headline_, h.isGood ? style::good : style::caution);
    column_->addWidget(headline_);
    addText(h.sentence);
    if (finding.end.isAtLimitOfWork && document_.resultKind() == RunKind::Discover && !document_.isResultStale()) {
        longer_ = new QPushButton(tr("Search ten times as long"), body_);
        longer_->setObjectName("search-longer");
        longer_->setToolTip(tr("Discover again, with ten times the work that it had"));
        connect(longer_, &QPushButton::clicked, this, &ResultPanel::longerSearchWanted);
        addButton(longer_);
    }
    if (document_.isResultStale()) {
        style::tint(*addText(tr("The study has been changed since. Run again to see what holds now."), true),
                    style::caution);
    }
}

void ResultPanel::addAdoption() {
    if (document_.isResultStale() || document_.isResultAdopted()) return;
    const bool isFit = document_.resultKind() == RunKind::Fit;
    if (!isFit && document_.finding()->effects.empty()) return;
    if (isFit && document_.finding()->final.status == FitStatus::Failed) return;  // values on the way to a failure
    auto* button = new QPushButton(isFit ? tr("Write fitted values into the model") : tr("Add to the model"), body_);
    button->setObjectName("adopt");
    button->setDefault(true);
    button->setIcon(style::icon("apply"));
    connect(button, &QPushButton::clicked, this,
            [this, isFit] { document_.adoptCompleted(isFit ? tr("Write fitted values") : tr("Add what was found")); });
    column_->addSpacing(style::unit);
    addButton(button);
}

void ResultPanel::addComparison(const Finding& finding) {
    const bool isDiscover = document_.resultKind() == RunKind::Discover;
    const std::shared_ptr<const ModelState> held = document_.before();
    const ModelState* before = isDiscover ? &finding.baseline : held.get();
    comparison_ = resultTable({tr("Error"), tr("Role"), tr("Before"), tr("After")}, body_);
    for (const ExperimentState& after : finding.final.experiments) {
        double was = std::nan("");
        if (before)
            for (const ExperimentState& b : before->experiments)
                if (b.name == after.name) was = b.errorPercent;
        auto* item =
            new QTreeWidgetItem(comparison_, {text(after.name), after.role == Role::Fit ? tr("fit") : tr("validate"),
                                              style::percentText(was), style::percentText(after.errorPercent)});
        alignRight(item, {2, 3});
        QFont bold = item->font(3);
        bold.setWeight(QFont::DemiBold);
        item->setFont(3, bold);
        style::tint(*item, 1, style::mutedText, palette());
        item->setToolTip(0, tr("Root mean square error in percent of the measured range, over all outputs"));
    }
    for (const int c : {2, 3}) comparison_->headerItem()->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
    comparison_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    comparison_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    column_->addSpacing(2 * style::unit);
    column_->addWidget(comparison_);
    fitTableHeight(comparison_);
}

void ResultPanel::addEffect(const AddedEffect& effect, bool isOneOfSeveral) {
    addHeading(isOneOfSeveral ? effectTitle(effect) : tr("Evidence"));
    addText(text(effect.className), true);
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(3 * style::unit);
    grid->setVerticalSpacing(style::unit / 2);
    grid->setColumnStretch(2, 1);
    int row = 0;
    const auto add = [&](const QString& name, const QString& value, const QString& meaning = {},
                         const QString& tip = {}) {
        auto* key = new QLabel(name, body_);
        auto* label = new QLabel(value, body_);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        style::makeCaption(key);
        for (QLabel* l : {key, label}) l->setToolTip(tip);
        grid->addWidget(key, row, 0);
        grid->addWidget(label, row, 1, 1, meaning.isEmpty() ? 2 : 1);
        if (!meaning.isEmpty()) {
            auto* why = new QLabel(meaning, body_);
            why->setToolTip(tip);
            why->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the numbers come first
            why->setWordWrap(true);
            style::makeCaption(why);
            grid->addWidget(why, row, 2);
        }
        ++row;
    };
    for (const EffectValue& p : effect.parameters) {
        const bool isEstimate = std::isfinite(p.standardError) && p.standardError > 0;
        // what is given is shown as it is given
        const QString value =
            isEstimate ? style::withDecimalSign(valueText(p.value, p.standardError)) : style::numberText(p.value, 5);
        add(text(p.name), value + " " + text(p.unit));
    }
    const Evidence& e = effect.evidence;
    const bool isIndicated = effect.confidence == Confidence::Indicated;
    add(tr("Confidence"), isIndicated ? tr("indicated") : tr("established"),
        isIndicated ? tr("predicts better; structure remains") : QString(), inWords(confidenceWords(effect)));
    if (effect.prediction)
        add(tr("Left out"),
            style::percentText(effect.prediction->errorPercentBefore) + " → " +
                style::percentText(effect.prediction->errorPercentAfter),
            tr("better in %1 of %2 parts").arg(effect.prediction->betterIn).arg(effect.prediction->blocks),
            tr("Error of parts of the measurement that were left out of the fit in turn, without the effect and with "
               "it"));
    add(tr("Error"), style::percentText(e.errorPercentBefore) + " → " + style::percentText(e.errorPercentAfter),
        tr("fitted experiments"), tr("Over the fitted experiments"));
    add(tr("Score"), evidenceText(e.score), tr("signal to noise, squared"),
        tr("Squared signal-to-noise ratio of what the finished model misses when it is refitted without the effect"));
    add(tr("ΔBIC"), evidenceText(e.deltaBic), tr("negative: gains more than it costs"),
        tr("Of the finished model against the same refitted without the effect; negative: it gains more than its "
           "parameters cost"));
    add(tr("Held out"), (e.heldOut > 0 ? "+" : "") + style::numberText(e.heldOut, 2),
        tr("+1: holds on data left out; −1: fails"),
        tr("+1: the gain holds on data left out of the fit; −1: it does not"));
    column_->addLayout(grid);
    column_->addSpacing(style::unit);

    if (const QString others = equivalentWords(effect); !others.isEmpty()) addText(others, true);
    auto* show = new QPushButton(tr("Show in the diagram"), body_);
    connect(show, &QPushButton::clicked, this, [this, instance = text(effect.wired.instance), at = text(effect.at)] {
        // Before it is added there is its place alone.
        Q_EMIT effectChosen(document_.diagram().find(instance.toStdString()) ? instance : placeOf(at));
    });
    addButton(show);
}

void ResultPanel::addRemainder(const Finding& finding) {
    for (const Remainder& r : finding.unexplained.remainders) {
        const RemainderWords words = remainderWords(r, [this](const std::string& name) {
            return linkedWords(document_, Text(placeOf(text(name)).toStdString()));
        });
        addHeading(words.heading);
        makeLinks(addText({}), words.where);
        if (!words.movesWith.isEmpty()) addText(words.movesWith, true);
        if (words.proposal.isEmpty()) continue;
        addText(words.proposal);
        if (words.proposalFacts.isEmpty()) continue;
        QLabel* label = addText(words.proposalFacts, true);
        if (!r.proposal.block.empty())  // written for this model alone: no library has it to look up
            label->setToolTip("<pre>" + text(r.proposal.block).toHtmlEscaped() + "</pre>");
    }
    if (finding.unexplained.disturbance) addText(inWords(disturbanceWords(*finding.unexplained.disturbance)));
    addProposalAdoption(finding);
    if (!finding.nextExperiment.empty()) {
        addHeading(tr("Next experiment"));
        addText(inWords(finding.nextExperiment));
    }
}

/// A button on a line of its own, no wider than its words.
void ResultPanel::addButton(QPushButton* button) {
    auto* line = new QHBoxLayout;
    line->addWidget(button);
    line->addStretch(1);
    column_->addLayout(line);
}

/// Whoever finds the equations plausible takes them over as they were fitted.
void ResultPanel::addProposalAdoption(const Finding& finding) {
    const RunResult* result = document_.result();
    if (!result || !result->proposed || document_.isResultStale()) return;
    const auto equations = std::count_if(finding.unexplained.remainders.begin(), finding.unexplained.remainders.end(),
                                         [](const Remainder& r) { return !r.proposal.className.empty(); });
    auto* button = new QPushButton(
        equations > 1 ? tr("Add the equations to the model") : tr("Add the equation to the model"), body_);
    button->setObjectName("adoptProposed");
    button->setToolTip(tr("Wires in what is proposed, with the values of its fit; one step, which can be undone"));
    connect(button, &QPushButton::clicked, this, [this] { document_.adoptProposed(); });
    addButton(button);
}

/// What to mind before trusting the figures above: runs beyond the fitted range, values that drift between runs.
void ResultPanel::addCautions(const Finding& finding) {
    if (finding.warnings.empty()) return;
    addHeading(tr("Caution"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(2 * style::unit);
    grid->setVerticalSpacing(style::unit);
    grid->setColumnStretch(1, 1);
    int row = 0;
    for (const Text& warning : finding.warnings) {
        auto* sign = new QLabel(body_);
        sign->setPixmap(style::icon("warning").pixmap(16, 16));
        auto* label = new QLabel(body_);
        label->setWordWrap(true);
        makeLinks(label, linkedWords(document_, warning));
        grid->addWidget(sign, row, 0, Qt::AlignTop);
        grid->addWidget(label, row++, 1);
    }
    column_->addLayout(grid);
}

}  // namespace analogon::ui
