#include "ui/measurement/recordings_page.hpp"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "ui/document/document.hpp"
#include "ui/measurement/locate.hpp"
#include "ui/measurement/recordings_model.hpp"
#include "ui/style/find_key.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

/// A role is chosen from a list; what is typed as a weight and is none is coloured at once.
class RecordingDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&, const QModelIndex& index) const override {
        if (index.column() == RecordingsModel::Role) {
            auto* box = new QComboBox(parent);
            box->addItem(RecordingsModel::tr("fit"), true);
            box->addItem(RecordingsModel::tr("validate"), false);
            auto* self = const_cast<RecordingDelegate*>(this);
            connect(box, &QComboBox::activated, self, [self, box] {
                Q_EMIT self->commitData(box);
                Q_EMIT self->closeEditor(box);
            });
            return box;
        }
        auto* field = new QLineEdit(parent);
        field->setFrame(false);
        field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        connect(field, &QLineEdit::textEdited, field, [field](const QString& text) {
            QPalette palette = field->parentWidget()->palette();
            if (!RecordingsModel::readWeight(text)) palette.setColor(QPalette::Text, style::fault(palette));
            field->setPalette(palette);
        });
        return field;
    }
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor))
            box->setCurrentIndex(box->findData(index.data(Qt::EditRole)));
        else if (!style::isTypedInto(editor))
            QStyledItemDelegate::setEditorData(editor, index);
    }
    void setModelData(QWidget* editor, QAbstractItemModel* model, const QModelIndex& index) const override {
        if (auto* box = qobject_cast<QComboBox*>(editor))
            model->setData(index, box->currentData(), Qt::EditRole);
        else
            QStyledItemDelegate::setModelData(editor, model, index);
    }
};

/// Rows are marked, cells are edited; names take their width once, all else as much as it needs.
void setUpRecordings(QTableView* view) {
    view->setSortingEnabled(true);
    view->horizontalHeader()->setSortIndicatorClearable(true);
    view->sortByColumn(-1, Qt::AscendingOrder);  // as they are in the study
    view->setTabKeyNavigation(false);            // Tab leads on; the arrows lead from cell to cell
    view->setFrameShape(QFrame::NoFrame);
    view->setShowGrid(false);
    view->setAlternatingRowColors(true);
    view->setWordWrap(false);
    view->setSelectionBehavior(QAbstractItemView::SelectRows);
    view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    view->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
    view->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    view->setContextMenuPolicy(Qt::CustomContextMenu);
    view->setAccessibleName(RecordingsPage::tr("Recordings"));
    view->verticalHeader()->hide();
    view->verticalHeader()->setDefaultSectionSize(view->fontMetrics().height() + 2 * style::unit);
    view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view->horizontalHeader()->setHighlightSections(false);
    view->horizontalHeader()->setMinimumSectionSize(9 * style::unit);
    view->horizontalHeader()->setStretchLastSection(true);
    view->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    view->horizontalHeader()->setResizeContentsPrecision(0);
    for (const int column : {RecordingsModel::Name, RecordingsModel::File})
        view->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Interactive);
}

}  // namespace

RecordingsPage::RecordingsPage(Document& document, QWidget* parent)
    : QWidget(parent),
      model_(new RecordingsModel(document, this)),
      sorted_(new QSortFilterProxyModel(this)),
      view_(new QTableView(this)),
      filter_(new QLineEdit(this)),
      caption_(new QLabel(this)),
      fit_(new QPushButton(this)),
      search_(new QPushButton(this)),
      close_(new QPushButton(tr("Close"), this)) {
    style::makeCaption(caption_);
    caption_->setWordWrap(true);
    caption_->setText(tr("Space takes the marked rows in or out. Role and weight are edited in their cells."));
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(RecordingsModel::SortRole);
    sorted_->setSortCaseSensitivity(Qt::CaseInsensitive);
    sorted_->setFilterKeyColumn(-1);  // whatever a row shows
    sorted_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    connect(filter_, &QLineEdit::textChanged, sorted_, &QSortFilterProxyModel::setFilterFixedString);
    style::findBy(*this, [this] { return filter_; });
    view_->setModel(sorted_);
    view_->setItemDelegate(new RecordingDelegate(view_));
    setUpRecordings(view_);
    view_->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    filter_->setPlaceholderText(tr("Filter"));
    filter_->setAccessibleName(tr("Filter the recordings"));
    filter_->setClearButtonEnabled(true);
    filter_->setMaximumWidth(60 * style::unit);
    auto* top = new QHBoxLayout;
    top->addWidget(caption_, 2);
    top->addWidget(filter_, 1);
    setTabOrder(filter_, view_);
    layout->addLayout(top);
    layout->addWidget(view_, 1);
    layout->addLayout(buttons());
    connect(view_, &QWidget::customContextMenuRequested, this, &RecordingsPage::showMenu);
    connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &RecordingsPage::updateState);
    connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& now) {
        if (now.isValid()) Q_EMIT experimentChosen(now.data(RecordingsModel::NameRole).toString());
    });
    connect(model_, &QAbstractItemModel::dataChanged, this, &RecordingsPage::updateState);
    connect(model_, &QAbstractItemModel::modelReset, this, [this] {
        fitNames();
        updateState();
    });
    connect(&document, &Document::opened, this, &RecordingsPage::left);
    updateState();
}

void RecordingsPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    model_->setShown(true);
}

void RecordingsPage::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    model_->setShown(false);
}

/// The first columns are as wide as their names, as long as these leave room for the others.
void RecordingsPage::fitNames() {
    view_->horizontalHeader()->setResizeContentsPrecision(-1);
    for (const int column : {RecordingsModel::Name, RecordingsModel::File}) {
        view_->resizeColumnToContents(column);
        const int most = std::max(30 * style::unit, view_->viewport()->width() * 3 / 10);
        view_->setColumnWidth(column, std::min(view_->columnWidth(column) + 2 * style::unit, most));
    }
    view_->horizontalHeader()->setResizeContentsPrecision(0);  // the others by the rows in sight
}

QLayout* RecordingsPage::buttons() {
    auto* row = new QHBoxLayout;
    row->setSpacing(2 * style::unit);
    fit_->setIcon(style::icon("fit"));
    search_->setIcon(style::icon("discover"));
    row->addWidget(fit_);
    row->addWidget(search_);
    row->addStretch(1);
    row->addWidget(close_);
    for (QPushButton* button : {fit_, search_}) button->setMinimumWidth(22 * style::unit);  // before the window grows
    connect(fit_, &QPushButton::clicked, this, [this] { Q_EMIT fitWanted(marked()); });
    connect(search_, &QPushButton::clicked, this, [this] { Q_EMIT searchWanted(marked()); });
    connect(close_, &QPushButton::clicked, this, &RecordingsPage::left);
    return row;
}

std::set<std::string> RecordingsPage::marked() const {
    std::set<std::string> names;
    const QModelIndexList rows = view_->selectionModel()->selectedRows();
    for (const QModelIndex& row : rows) names.insert(row.data(RecordingsModel::NameRole).toString().toStdString());
    return names;
}

QString RecordingsPage::current() const { return view_->currentIndex().data(RecordingsModel::NameRole).toString(); }

void RecordingsPage::setRunning(bool isRunning) {
    isRunning_ = isRunning;
    updateState();
}

void RecordingsPage::focusTable() {
    fitNames();
    view_->setFocus(Qt::OtherFocusReason);
    // whatever keys are held down at the moment, as those that led here
    if (!view_->selectionModel()->hasSelection() && sorted_->rowCount() > 0)
        view_->selectionModel()->setCurrentIndex(sorted_->index(std::max(0, view_->currentIndex().row()), 0),
                                                 QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

/// How many recordings a run would look at is said on its button, and what is missing where it cannot begin.
void RecordingsPage::updateState() {
    const std::set<std::string> rows = marked();
    const auto count = model_->usable(rows).size();
    const bool hasFitted = model_->hasFitted(rows);
    fit_->setText(count > 0 ? tr("Fit the marked (%1)").arg(count) : tr("Fit the marked"));
    search_->setText(count > 0 ? tr("Search in the marked (%1)").arg(count) : tr("Search in the marked"));
    const QString missing = rows.empty()
                                ? tr("Mark rows first: Ctrl and Shift with a click or an arrow, Ctrl+A for all")
                            : !hasFitted ? tr("None of the marked recordings is used and there to fit")
                            : isRunning_ ? tr("A run is under way")
                                         : QString();
    for (QPushButton* button : {fit_, search_}) button->setEnabled(missing.isEmpty());
    fit_->setToolTip(missing.isEmpty() ? tr("Estimate the checked parameters from these recordings alone") : missing);
    search_->setToolTip(missing.isEmpty() ? tr("Find the effect that the model lacks in these recordings alone")
                                          : missing);
}

/// All of the marked rows follow the one that has the focus.
void RecordingsPage::toggleUsed() {
    std::set<std::string> rows = marked();
    if (rows.empty() || !rows.contains(current().toStdString())) rows = {current().toStdString()};
    model_->setUsed(rows, !model_->isUsed(current().toStdString()));
}

void RecordingsPage::addEdits(QMenu& menu) {
    const std::set<std::string> rows = marked();
    const auto add = [&](const QString& text, std::function<void()> edit) {
        menu.addAction(text, this, std::move(edit))->setEnabled(!rows.empty());
    };
    add(tr("Take the marked in"), [this, rows] { model_->setUsed(rows, true); });
    add(tr("Leave the marked out"), [this, rows] { model_->setUsed(rows, false); });
    menu.addSeparator();
    add(tr("Use the marked to fit"), [this, rows] { model_->setRole(rows, Role::Fit); });
    add(tr("Use the marked to validate"), [this, rows] { model_->setRole(rows, Role::Validate); });
    menu.addSeparator();
}

void RecordingsPage::showMenu(QPoint at) {
    const QModelIndex index = view_->indexAt(at).isValid() ? view_->indexAt(at) : view_->currentIndex();
    const QString name = index.data(RecordingsModel::NameRole).toString();
    if (name.isEmpty()) return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    addEdits(*menu);
    menu->addAction(tr("Show the values"), this, [this, name] { Q_EMIT valuesWanted(name); });
    menu->addAction(tr("Locate the file …"), this, [this, name] { Q_EMIT locateWanted(name); });
    menu->addSeparator();
    const QString heading = sorted_->headerData(index.column(), Qt::Horizontal).toString();
    menu->addAction(tr("Sort by %1").arg(heading), this, [this, column = index.column()] {
        const QHeaderView* const header = view_->horizontalHeader();
        const bool isAgain =
            header->sortIndicatorSection() == column && header->sortIndicatorOrder() == Qt::AscendingOrder;
        view_->sortByColumn(column, isAgain ? Qt::DescendingOrder : Qt::AscendingOrder);
    });
    menu->popup(view_->viewport()->mapToGlobal(at));
}

bool RecordingsPage::eventFilter(QObject* watched, QEvent* event) {
    if (watched == view_ && event->type() == QEvent::ContextMenu &&
        static_cast<QContextMenuEvent*>(event)->reason() == QContextMenuEvent::Keyboard) {
        showMenu(view_->visualRect(view_->currentIndex()).center());
        return true;
    }
    if (watched != view_ || event->type() != QEvent::KeyPress || !view_->hasFocus())  // not the end of typing in a cell
        return QWidget::eventFilter(watched, event);
    const auto* press = static_cast<QKeyEvent*>(event);
    const QModelIndex now = view_->currentIndex();
    if (press->key() == Qt::Key_Space && press->modifiers() == Qt::NoModifier && now.isValid()) {
        toggleUsed();
        return true;
    }
    if ((press->key() == Qt::Key_Return || press->key() == Qt::Key_Enter) && now.isValid()) {
        if (now.flags() & Qt::ItemIsEditable)
            view_->edit(now);
        else
            Q_EMIT valuesWanted(current());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace analogon::ui
