#include <QCheckBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyleOptionHeader>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "core/report/words.hpp"
#include "ui/document/document.hpp"
#include "ui/document/mention.hpp"
#include "ui/effect/finding_words.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/effect/result_table.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/row_button.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

/// What was tried: the table of candidates, filtered, grouped by round, with a trial beside each.
namespace analogon::ui {

namespace {

enum CandidateColumn { What, Where, Screening, DeltaBic, Judgement, Trial };

/// An equation without a name is only proposed: there is no block to try.
bool canBeTried(const QTreeWidgetItem* item) {
    const QString kind = item ? item->data(0, ResultPanel::KindRole).toString() : QString();
    return !kind.isEmpty() && !kind.startsWith("proposal.");
}

/// Rows without a figure come last, whichever way.
bool isLess(const QTreeWidgetItem* a, const QTreeWidgetItem* b, int column, Qt::SortOrder order) {
    const bool isRising = order == Qt::AscendingOrder;
    if (column == What || column == Where) {
        const int compared = a->text(column).localeAwareCompare(b->text(column));
        return isRising ? compared < 0 : compared > 0;
    }
    const QVariant left = a->data(column, ResultPanel::FigureRole), right = b->data(column, ResultPanel::FigureRole);
    if (!left.isValid() || !right.isValid()) return left.isValid() && !right.isValid();
    return isRising ? left.toDouble() < right.toDouble() : left.toDouble() > right.toDouble();
}

/// Room for the title of a column. The hint of the header itself is 0 for a hidden one.
int headWidth(const QTreeWidget& table, int column) {
    QStyleOptionHeader head;
    head.initFrom(table.header());
    head.section = column;
    head.orientation = Qt::Horizontal;
    head.text = table.headerItem()->text(column);
    const QHeaderView* const header = table.header();
    return header->style()->sizeFromContents(QStyle::CT_HeaderSection, &head, QSize(), header).width();
}

/// What a column of names needs so that a line holds a few words and no word is cut; very long ones are cut all the
/// same.
int leastOfNames(QTreeWidget& table) {
    const int letter = table.fontMetrics().averageCharWidth();
    const int margins = 2 * (table.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &table) + 1);
    int longest = 0;
    for (QTreeWidgetItemIterator row(&table); *row; ++row) {
        if ((*row)->isFirstColumnSpanned()) continue;
        int depth = table.rootIsDecorated() ? 1 : 0;
        for (const QTreeWidgetItem* above = (*row)->parent(); above; above = above->parent()) ++depth;
        for (const int c : {What, Where}) {
            const QVariant own = (*row)->data(c, Qt::FontRole);
            const QFontMetrics letters(own.isValid() ? own.value<QFont>() : table.font());
            const int before = c == What ? depth * table.indentation() : 0;
            for (const QString& word : (*row)->text(c).split(u' '))
                longest = std::max(longest, before + margins + letters.horizontalAdvance(word));
        }
    }
    return std::clamp(longest, 13 * letter, 20 * letter);
}

}  // namespace

QTreeWidgetItem* ResultPanel::addCandidate(const CandidateResult& c) {
    const auto text = [](const std::string& s) { return QString::fromStdString(s); };
    const LibraryClass* cls = document_.library().find(c.className);
    const QString what = cls ? shortDescription(text(cls->definition->description)) : QString();
    auto* item = new QTreeWidgetItem(QStringList{
        what.isEmpty() ? text(c.kind) : what, placeText(text(c.at), text(c.channel)), evidenceText(c.screening.score),
        c.deltaBic ? evidenceText(*c.deltaBic) : QString(), verdictText(c.verdict)});
    item->setData(0, KindRole, text(c.kind));
    item->setData(1, KindRole, placeOf(text(c.at)));
    item->setData(2, KindRole, text(c.className));
    item->setData(3, KindRole, text(c.at));
    item->setData(0, RoundRole, c.round);
    if (std::isfinite(c.screening.score)) item->setData(Screening, FigureRole, c.screening.score);
    if (c.deltaBic && std::isfinite(*c.deltaBic)) item->setData(DeltaBic, FigureRole, *c.deltaBic);
    item->setData(Judgement, FigureRole, static_cast<int>(c.verdict));
    item->setToolTip(0, QStringList{item->text(0), text(c.kind), text(c.className)}.join('\n'));
    item->setToolTip(1, item->text(1));
    alignRight(item, {Screening, DeltaBic});
    item->setToolTip(Judgement, inWords(verdictWords(c)));
    if (c.verdict == Verdict::Chosen) {
        for (int i = 0; i < Trial; ++i) {
            QFont bold = font();
            bold.setWeight(QFont::DemiBold);
            item->setFont(i, bold);
        }
        style::tint(*item, Judgement, style::good, palette());
    } else if (c.verdict != Verdict::Equivalent) {
        for (int i = 0; i < Trial; ++i) style::tint(*item, i, style::mutedText, palette());
    }
    return item;
}

void ResultPanel::addCandidateTools() {
    filter_ = new QLineEdit(sought_, body_);
    filter_->setPlaceholderText(tr("Filter"));
    filter_->setAccessibleName(tr("Filter what was tried"));
    filter_->setClearButtonEnabled(true);
    byRound_ = new QCheckBox(tr("By round"), body_);
    byRound_->setToolTip(tr("What was tried in each round stands together"));
    byRound_->setChecked(isByRound_);
    auto* row = new QHBoxLayout;
    row->addWidget(filter_, 1);
    row->addWidget(byRound_);
    column_->addLayout(row);
    connect(filter_, &QLineEdit::textChanged, this, [this](const QString& words) {
        sought_ = words;
        filterCandidates();
    });
    connect(byRound_, &QCheckBox::toggled, this, [this](bool isByRound) {
        isByRound_ = isByRound;
        groupCandidates();
    });
}

/// The way a column is read first: figures from the largest, names from the first. Once more turns it round, and a
/// third time brings back the order in which they were tried.
void ResultPanel::sortBy(int column) {
    if (column >= Trial) return;
    const Qt::SortOrder first = column == Screening ? Qt::DescendingOrder : Qt::AscendingOrder;
    if (column != sortedBy_) {
        sortedBy_ = column;
        order_ = first;
    } else if (order_ == first) {
        order_ = first == Qt::AscendingOrder ? Qt::DescendingOrder : Qt::AscendingOrder;
    } else {
        sortedBy_ = -1;
    }
    groupCandidates();
}

/// Puts the rows under a heading for each round, or all on one level; each gets its button anew, as the table takes it
/// away with a row that moves.
void ResultPanel::groupCandidates() {
    candidates_->header()->setSortIndicatorShown(sortedBy_ >= 0);
    if (sortedBy_ >= 0) candidates_->header()->setSortIndicator(sortedBy_, order_);
    const QSignalBlocker blocker(candidates_);  // the marked row stays what it is
    QTreeWidgetItem* const marked = candidates_->currentItem();
    std::vector<QTreeWidgetItem*> rows;
    while (candidates_->topLevelItemCount() > 0) {
        QTreeWidgetItem* top = candidates_->takeTopLevelItem(0);
        if (top->data(0, RankRole).isValid()) {
            rows.push_back(top);
        } else {
            for (QTreeWidgetItem* row : top->takeChildren()) rows.push_back(row);
            delete top;
        }
    }
    const auto comes = [this](const QTreeWidgetItem* a, const QTreeWidgetItem* b) {
        if (sortedBy_ < 0 || isLess(a, b, sortedBy_, order_) == isLess(b, a, sortedBy_, order_))
            return a->data(0, RankRole).toInt() < b->data(0, RankRole).toInt();
        return isLess(a, b, sortedBy_, order_);
    };
    std::sort(rows.begin(), rows.end(), comes);
    std::set<int> rounds;
    for (const QTreeWidgetItem* row : rows) rounds.insert(row->data(0, RoundRole).toInt());
    std::map<int, QTreeWidgetItem*> headings;
    if (isByRound_)
        for (const int round : rounds) {
            auto* heading = new QTreeWidgetItem(candidates_, {tr("Round %1").arg(round)});
            heading->setFirstColumnSpanned(true);
            heading->setFlags(Qt::ItemIsEnabled);
            heading->setExpanded(true);
            headings[round] = heading;
        }
    for (QTreeWidgetItem* row : rows) {
        if (isByRound_)
            headings[row->data(0, RoundRole).toInt()]->addChild(row);
        else
            candidates_->addTopLevelItem(row);
        if (!canBeTried(row)) continue;
        auto* button = new style::RowButton(*candidates_);
        button->setIcon(style::icon("simulate"));
        button->setFocusPolicy(Qt::NoFocus);  // Enter on the row does the same
        button->setToolTip(tr("Try this effect"));
        button->setAccessibleName(tr("Try this effect"));
        button->setEnabled(!document_.isResultStale());
        connect(button, &QToolButton::clicked, this, [this, row] { tryCandidate(row); });
        candidates_->setItemWidget(row, Trial, button);
    }
    candidates_->setCurrentItem(marked);
    giveNamesRoom();
    filterCandidates();
}

/// Where the panel is narrow the names of effects and places come before the figures of their trials, of which the
/// better one stays longest. It depends on the present width alone: what is hidden counts as much as what is shown.
void ResultPanel::giveNamesRoom() {
    const int least = leastOfNames(*candidates_);
    const auto widthOf = [this](int column) {
        const auto* view = static_cast<const QAbstractItemView*>(candidates_);
        return std::max(view->sizeHintForColumn(column), headWidth(*candidates_, column));
    };
    int figures = 0;
    for (const int c : {Screening, DeltaBic, Judgement, Trial}) figures += widthOf(c);
    for (const int c : {Screening, DeltaBic}) {
        const bool isTooNarrow = (candidates_->viewport()->width() - figures) / 2 < least;
        if (isTooNarrow) figures -= widthOf(c);
        candidates_->setColumnHidden(c, isTooNarrow);
    }
}

/// Rows in which each word is found; headings of rounds that have none left go as well.
void ResultPanel::filterCandidates() {
    const QStringList words = sought_.split(u' ', Qt::SkipEmptyParts);
    std::set<QTreeWidgetItem*> filled;
    for (QTreeWidgetItemIterator row(candidates_); *row; ++row) {
        if (!(*row)->data(0, RankRole).isValid()) continue;
        QString all;
        for (int c = 0; c < Trial; ++c) all += (*row)->text(c) + u' ';
        all += (*row)->toolTip(0);
        const bool fits = std::all_of(words.begin(), words.end(),
                                      [&](const QString& w) { return all.contains(w, Qt::CaseInsensitive); });
        (*row)->setHidden(!fits);
        if (fits && (*row)->parent()) filled.insert((*row)->parent());
    }
    for (int i = 0; isByRound_ && i < candidates_->topLevelItemCount(); ++i)
        candidates_->topLevelItem(i)->setHidden(!filled.contains(candidates_->topLevelItem(i)));
    fitTableHeight(candidates_);
}

void ResultPanel::tryCandidate(const QTreeWidgetItem* item) {
    if (!canBeTried(item) || document_.isResultStale()) return;
    Q_EMIT trialWanted(
        {item->data(2, KindRole).toString().toStdString(), item->data(3, KindRole).toString().toStdString()});
}

void ResultPanel::addCandidates(const Finding& finding) {
    addHeading(tr("What was tried"));
    if (!finding.effects.empty())
        addText(tr("Each with its figures in the round in which it was tried; those above are of the finished model."),
                true);
    addCandidateTools();
    candidates_ = resultTable({tr("Effect"), tr("At"), tr("Screening"), tr("ΔBIC"), tr("Verdict"), QString()}, body_);
    QTreeWidgetItem* head = candidates_->headerItem();
    head->setToolTip(Screening, tr("How much of the residual the effect would explain, estimated before any refit: "
                                   "signal to noise, squared"));
    head->setToolTip(DeltaBic, tr("Of the refit with the effect, beside what the model held in that round; empty: it "
                                  "was not refitted"));
    int rank = 0;
    for (const CandidateResult& c : finding.candidates) {
        QTreeWidgetItem* item = addCandidate(c);
        item->setData(0, RankRole, rank++);
        candidates_->addTopLevelItem(item);
    }
    for (const int c : {Screening, DeltaBic}) head->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
    QHeaderView* header = candidates_->header();
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    for (const int c : {What, Where}) {  // they share what the figures leave: none is pushed out of sight
        header->setSectionResizeMode(c, QHeaderView::Stretch);
        style::wrapColumn(candidates_, c);  // the ends of two names may be all that tells them apart
    }
    candidates_->setIndentation(3 * style::unit);
    header->setSectionsClickable(true);
    header->setToolTip(tr("Click to sort; a third click brings back the order in which they were tried"));
    connect(header, &QHeaderView::sectionClicked, this, &ResultPanel::sortBy);
    connect(header, &QHeaderView::sectionResized, candidates_,
            [list = candidates_] { QTimer::singleShot(0, list, [list] { fitTableHeight(list); }); });
    candidates_->setMouseTracking(true);
    candidates_->viewport()->installEventFilter(this);
    connect(candidates_, &QTreeWidget::itemEntered, this, &ResultPanel::lookAt);
    candidates_->setSelectionMode(QAbstractItemView::SingleSelection);
    candidates_->setFocusPolicy(Qt::StrongFocus);
    candidates_->setAccessibleName(tr("What was tried"));
    column_->addWidget(candidates_);
    groupCandidates();
    try_ = new QPushButton(tr("Try the marked effect"), body_);
    try_->setToolTip(tr("Fits the model with this effect and shows its traces; the result is kept among the runs"));
    try_->setEnabled(false);
    addButton(try_);
    connect(candidates_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        try_->setEnabled(canBeTried(item) && !document_.isResultStale());
        lookAt(item);
    });
    connect(try_, &QPushButton::clicked, this, [this] { tryCandidate(candidates_->currentItem()); });
    connect(candidates_, &QTreeWidget::itemActivated, this, &ResultPanel::tryCandidate);
}

}  // namespace analogon::ui
