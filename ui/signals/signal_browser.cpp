#include "ui/signals/signal_browser.hpp"

#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/signal/formula.hpp"
#include "core/study/free_run.hpp"
#include "ui/document/document.hpp"
#include "ui/signals/plot_layout.hpp"
#include "ui/style/find_key.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

SignalBrowser::SignalBrowser(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), model_(new SignalModel(this)) {
    search_ = new QLineEdit;
    search_->setObjectName("signal-search");
    search_->setPlaceholderText(tr("Search name, unit, component, recording"));
    search_->setClearButtonEnabled(true);
    search_->installEventFilter(this);
    recording_ = new QComboBox;
    recording_->setObjectName("signal-recording");
    recording_->setFocusPolicy(Qt::StrongFocus);
    recording_->setToolTip(tr("Variables of the model are simulated over this recording"));
    recording_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    tree_ = new QTreeView;
    tree_->setObjectName("signals");
    tree_->setModel(model_);
    tree_->setUniformRowHeights(true);
    tree_->setMinimumHeight(3 * fontMetrics().height());  // small screens have no more
    tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    tree_->setDragEnabled(true);
    tree_->setDragDropMode(QAbstractItemView::DragOnly);
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    tree_->header()->setSectionResizeMode(1, QHeaderView::Fixed);
    tree_->header()->resizeSection(1, fontMetrics().horizontalAdvance("W/(m2.K)") + 2 * style::unit);
    tree_->setIndentation(3 * style::unit);  // the names need the room
    tree_->installEventFilter(this);
    style::showWhenEmpty(tree_, tr("Nothing is called so."));
    show_ = new QToolButton;
    show_->setObjectName("signal-show");
    show_->setText(tr("Plot"));
    show_->setToolTip(tr("Show the selected signals on one axis of the plots (Enter)"));
    count_ = new QLabel;
    style::makeCaption(count_);
    formula_ = new QLineEdit;
    formula_->setObjectName("signal-formula");
    formula_->setPlaceholderText(tr("Formula, such as motor.v*motor.i"));
    formula_->setToolTip(
        tr("A signal worked out from others, with + - * / ^, abs, sqrt, exp, log, sin, cos, min, max, "
           "der and integral; a name with spaces stands in 'single quotes'. Units follow."));
    add_ = new QToolButton;
    add_->setText(tr("Add"));
    fault_ = new QLabel;
    fault_->setWordWrap(true);
    fault_->hide();

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(style::margin, style::unit, style::margin, style::margin);
    column->setSpacing(style::unit);
    column->addWidget(search_);
    column->addWidget(recording_);
    column->addWidget(tree_, 1);
    auto* below = new QHBoxLayout;
    below->addWidget(count_, 1);
    below->addWidget(show_);
    column->addLayout(below);
    auto* formulas = new QHBoxLayout;
    formulas->addWidget(formula_, 1);
    formulas->addWidget(add_);
    column->addLayout(formulas);
    column->addWidget(fault_);

    connect(search_, &QLineEdit::textChanged, this, &SignalBrowser::showSearch);
    style::findBy(*this, [this] { return search_; });
    connect(tree_, &QTreeView::doubleClicked, this, &SignalBrowser::send);
    connect(show_, &QToolButton::clicked, this, &SignalBrowser::send);
    connect(add_, &QToolButton::clicked, this, &SignalBrowser::addFormula);
    connect(formula_, &QLineEdit::returnPressed, this, &SignalBrowser::addFormula);
    connect(formula_, &QLineEdit::textEdited, fault_, &QLabel::hide);
    connect(recording_, &QComboBox::currentTextChanged, this,
            [this](const QString& name) { model_->setRecording(name); });
    refreshing_.setSingleShot(true);
    connect(&refreshing_, &QTimer::timeout, this, [this] {
        if (isVisible() && isBehind_) refresh();
    });
    for (auto changed :
         {&Document::opened, &Document::factsChanged, &Document::experimentsChanged, &Document::plotsChanged})
        connect(&document, changed, this, &SignalBrowser::follow);
    connect(&document, &Document::resultChanged, this, [this] {
        if (document_.isOpen() && document_.isSimulated() != isSimulated_) follow();
    });
}

void SignalBrowser::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (isBehind_) refresh();
}

/// A study may have thousands of signals, and every edit may change them: they are listed once for all that one step
/// changes, and not for nobody.
void SignalBrowser::follow() {
    isBehind_ = true;
    refreshing_.start();
}

void SignalBrowser::refresh() {
    isBehind_ = false;
    isSimulated_ = document_.isOpen() && document_.isSimulated();
    const PlotLayout layout = document_.isOpen() ? plotLayoutOf(document_.study().extraJson) : PlotLayout{};
    QStringList names;
    if (document_.isOpen())
        for (const StudyExperiment& e : document_.study().experiments) names << QString::fromStdString(e.name);
    if (document_.isOpen() && (names.isEmpty() || document_.isSimulated()))
        names << QString::fromStdString(freeRunName(document_.study()));
    QStringList shown;
    for (int i = 0; i < recording_->count(); ++i) shown << recording_->itemText(i);
    if (names != shown) {
        const QString before = recording_->currentText();
        recording_->clear();
        recording_->addItems(names);
        if (names.contains(before)) recording_->setCurrentText(before);
    }
    recording_->setVisible(names.size() > 1);
    model_->setRecording(recording_->currentText());
    std::set<QString> open;  // what one has opened stays so
    for (int row = 0; row < model_->rowCount(); ++row)
        if (const QModelIndex group = model_->index(row, 0); tree_->isExpanded(group))
            open.insert(group.data().toString());
    model_->setSignals(allSignals(document_, layout.formulas));
    showSearch();
    for (int row = 0; row < model_->rowCount(); ++row)
        if (const QModelIndex group = model_->index(row, 0); open.contains(group.data().toString()))
            tree_->expand(group);
}

void SignalBrowser::showSearch() {
    constexpr int seenAtOnce = 300;
    if (model_->query() != search_->text()) model_->search(search_->text());
    if (!search_->text().isEmpty() && model_->matches() <= seenAtOnce)
        tree_->expandAll();
    else if (model_->rowCount() > 0)
        tree_->expand(model_->index(0, 0));
    count_->setText(search_->text().isEmpty()
                        ? tr("%1 signals").arg(style::countText(static_cast<qulonglong>(model_->total())))
                        : tr("%1 of %2")
                              .arg(style::countText(static_cast<qulonglong>(model_->matches())),
                                   style::countText(static_cast<qulonglong>(model_->total()))));
}

void SignalBrowser::send() {
    std::vector<SignalRef> chosen;
    for (const QModelIndex& index : tree_->selectionModel()->selectedRows())
        if (SignalRef reference = model_->referenceAt(index); !reference.name.isEmpty())
            chosen.push_back(std::move(reference));
    if (!chosen.empty()) Q_EMIT wanted(chosen);
}

void SignalBrowser::addFormula() {
    const QString text = formula_->text().trimmed();
    if (text.isEmpty() || !document_.isOpen()) return;
    Outcome<Formula> formula = Formula::parse(text.toStdString());
    if (!formula) {
        fault_->setText(inWords(formula.diagnostics().front().message) + ". " +
                        inWords(formula.diagnostics().front().hint));
        return fault_->show();
    }
    PlotLayout layout = plotLayoutOf(document_.study().extraJson);
    if (std::find(layout.formulas.begin(), layout.formulas.end(), text) == layout.formulas.end()) {
        layout.formulas.push_back(text);
        StudySettings settings = document_.settings();
        settings.plots = withPlotLayout(settings.plots, layout);
        document_.applySettings(std::move(settings), tr("Add formula %1").arg(text));
    }
    formula_->clear();
    Q_EMIT wanted({{SignalKind::Derived, recording_->currentText(), text}});
}

/// Enter and the arrows go from the search to the list.
bool SignalBrowser::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (watched == tree_ && isEnter) {
        send();
        return true;
    }
    if (watched == search_ && (key == Qt::Key_Down || isEnter) && model_->rowCount() > 0) {
        const QModelIndex first = model_->index(0, 0, model_->index(0, 0));
        tree_->setFocus();
        if (first.isValid()) tree_->setCurrentIndex(first);
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace analogon::ui
