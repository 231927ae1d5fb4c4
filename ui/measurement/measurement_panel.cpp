#include "ui/measurement/measurement_panel.hpp"

#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QStackedLayout>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/measure/all_channels.hpp"
#include "core/measure/channel_place.hpp"
#include "core/measure/common_raster.hpp"
#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/locate.hpp"
#include "ui/measurement/mapping.hpp"
#include "ui/measurement/mapping_text.hpp"
#include "ui/measurement/recording_edits.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

/// Columns are chosen from a list, roles too; a range is typed, and the clock of a channel.
class MappingDelegate : public QStyledItemDelegate {
public:
    explicit MappingDelegate(MeasurementPanel& panel) : QStyledItemDelegate(&panel), panel_(panel) {}

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        if (index.column() == MeasurementPanel::Clock) return clockEditor(parent, option, index);
        if (index.column() == MeasurementPanel::Unit) return unitEditor(parent, index);
        if (index.column() != MeasurementPanel::Source) return nullptr;
        const QTreeWidgetItem* item = panel_.tree_->itemFromIndex(index);
        const StudyExperiment* experiment = panel_.experimentOf(item);
        if (!item || !experiment) return nullptr;
        const auto kind = static_cast<MeasurementPanel::Kind>(item->data(0, kindRole).toInt());
        if (kind == MeasurementPanel::Kind::Range) return QStyledItemDelegate::createEditor(parent, option, index);
        auto* box = new QComboBox(parent);
        if (kind == MeasurementPanel::Kind::Experiment) {
            box->addItem(MeasurementPanel::tr("fit"), true);
            box->addItem(MeasurementPanel::tr("validate"), false);
        } else if (kind == MeasurementPanel::Kind::Input || kind == MeasurementPanel::Kind::Output) {
            box->addItem(MeasurementPanel::tr("not mapped"), QString());
            if (const auto file = fileTable(panel_.document_.study().tables, *experiment)) {
                const ChannelLabels labels(*file);
                for (const Column* column : channelsOf(*file)) {
                    const std::string label = labels.of(*column);
                    box->addItem(withUnit(label, column->unit), QString::fromStdString(label));
                }
            }
        } else {
            delete box;
            return nullptr;
        }
        closeOnChoice(box);
        return box;
    }
    void setEditorData(QWidget* editor, const QModelIndex& index) const override {
        auto* box = qobject_cast<QComboBox*>(editor);
        if (!box) {
            if (!style::isTypedInto(editor)) QStyledItemDelegate::setEditorData(editor, index);
            return;
        }
        if (box->isEditable()) return box->setCurrentText(index.data().toString());
        const QVariant column = index.data(columnRole);
        box->setCurrentIndex(
            std::max(0, column.isValid() ? box->findData(column) : box->findText(index.data().toString())));
    }
    void setModelData(QWidget* editor, QAbstractItemModel*, const QModelIndex& index) const override {
        const QTreeWidgetItem* item = panel_.tree_->itemFromIndex(index);
        const auto kind = static_cast<MeasurementPanel::Kind>(item->data(0, kindRole).toInt());
        if (index.column() == MeasurementPanel::Clock) {
            const auto* box = qobject_cast<QComboBox*>(editor);
            return panel_.setClock(item, box ? box->currentText() : static_cast<QLineEdit*>(editor)->text());
        }
        if (index.column() == MeasurementPanel::Unit)
            return panel_.setUnit(item, static_cast<QComboBox*>(editor)->currentText());
        if (auto* field = qobject_cast<QLineEdit*>(editor)) return panel_.setRange(item, field->text());
        const QVariant chosen = static_cast<QComboBox*>(editor)->currentData();
        if (kind == MeasurementPanel::Kind::Experiment)
            panel_.setRole(item, chosen.toBool());
        else
            panel_.map(item, chosen.toString());
    }

private:
    void closeOnChoice(QComboBox* box) const {
        connect(box, &QComboBox::activated, this, [this, box] {
            auto* self = const_cast<MappingDelegate*>(this);
            Q_EMIT self->commitData(box);
            Q_EMIT self->closeEditor(box);
        });
    }
    /// Seconds are typed; of an output the fit can find them.
    QWidget* clockEditor(QWidget* parent, const QStyleOptionViewItem& option, const QModelIndex& index) const {
        const QTreeWidgetItem* item = panel_.tree_->itemFromIndex(index);
        const ChannelMapping* mapping = panel_.mappingOf(item);
        if (!mapping) return nullptr;
        const auto kind = static_cast<MeasurementPanel::Kind>(item->data(0, kindRole).toInt());
        if (kind == MeasurementPanel::Kind::Input) return QStyledItemDelegate::createEditor(parent, option, index);
        auto* box = new QComboBox(parent);
        box->setEditable(true);
        box->setInsertPolicy(QComboBox::NoInsert);
        if (!mapping->fitsClock) box->addItem(clockText(*mapping));
        box->addItem(MeasurementPanel::tr("fit"));
        if (mapping->fitsClock) box->addItem(QStringLiteral("0 s"));
        closeOnChoice(box);
        return box;
    }
    /// That of the file, or one in which the same is measured; others are typed.
    QWidget* unitEditor(QWidget* parent, const QModelIndex& index) const {
        const QTreeWidgetItem* item = panel_.tree_->itemFromIndex(index);
        if (!panel_.mappingOf(item)) return nullptr;
        auto* box = new QComboBox(parent);
        box->setEditable(true);
        box->setInsertPolicy(QComboBox::NoInsert);
        box->addItems(panel_.unitsFor(item));
        closeOnChoice(box);
        return box;
    }

    MeasurementPanel& panel_;
};

MeasurementPanel::MeasurementPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      tree_(new QTreeWidget(this)),
      pages_(new QStackedLayout),
      empty_(new QLabel(this)),
      import_(new QToolButton(this)),
      propose_(new QToolButton(this)),
      table_(new QToolButton(this)) {
    tree_->setColumnCount(ColumnCount);
    tree_->setHeaderLabels({tr("Model"), tr("Column"), tr("Clock"), tr("Unit")});
    tree_->headerItem()->setToolTip(Clock, clockTip(true));
    tree_->headerItem()->setToolTip(Unit, tr("In which the column is written, where it is not as its file says"));
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setRootIsDecorated(true);
    tree_->setUniformRowHeights(true);
    tree_->setIndentation(4 * style::unit);
    tree_->setIconSize({16, 16});
    for (const int section : {Model, Clock, Unit})
        tree_->header()->setSectionResizeMode(section, QHeaderView::ResizeToContents);
    tree_->header()->setResizeContentsPrecision(0);  // by the rows in sight
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setSectionResizeMode(Source, QHeaderView::Stretch);
    tree_->setAccessibleName(tr("Measurements"));
    style::followTheme(*tree_);
    for (const int column : {Source, Clock, Unit}) tree_->setItemDelegateForColumn(column, new MappingDelegate(*this));
    tree_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    tree_->setContextMenuPolicy(Qt::CustomContextMenu);
    tree_->viewport()->installEventFilter(this);
    tree_->installEventFilter(this);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setMargin(style::margin);
    style::makeCaption(empty_);
    import_->setText(tr("Import …"));
    import_->setToolTip(tr("Add a recording to the study"));
    propose_->setText(tr("Propose mapping"));
    propose_->setToolTip(tr("Give signals without a column the one that fits by unit and name"));
    table_->setText(tr("Table"));
    table_->setToolTip(tr("All recordings as a table: sort them, edit role and weight, fit some of them alone"));
    for (QToolButton* b : {import_, propose_, table_}) {
        b->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        b->setAutoRaise(true);
    }
    table_->setIcon(style::icon("table"));
    table_->setToolButtonStyle(Qt::ToolButtonIconOnly);
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(2 * style::unit, style::unit, 2 * style::unit, style::unit);
    bar->setSpacing(0);  // a narrow panel has room for all three, in any language
    bar->addWidget(import_);
    bar->addWidget(propose_);
    bar->addStretch(1);
    bar->addWidget(table_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addLayout(pages_, 1);
    pages_->addWidget(empty_);
    pages_->addWidget(tree_);
    for (auto signal : {&Document::opened, &Document::experimentsChanged, &Document::factsChanged})
        connect(&document, signal, this, &MeasurementPanel::refresh);
    connect(&document, &Document::leftOutChanged, this, &MeasurementPanel::markLeftOut);
    connect(tree_, &QTreeWidget::itemChanged, this, [this](const QTreeWidgetItem* item, int column) {
        if (column == Model && !item->parent()) setUsed(item, item->checkState(Model) == Qt::Checked);
    });
    connect(import_, &QToolButton::clicked, this, &MeasurementPanel::browseWanted);
    connect(propose_, &QToolButton::clicked, this, &MeasurementPanel::propose);
    connect(table_, &QToolButton::clicked, this, &MeasurementPanel::tableWanted);
    connect(tree_, &QWidget::customContextMenuRequested, this, &MeasurementPanel::showMenu);
    connect(tree_, &QTreeWidget::itemDoubleClicked, this, &MeasurementPanel::showValuesOf);
    connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        while (item && item->parent()) item = item->parent();
        if (item) Q_EMIT experimentChosen(item->data(0, experimentRole).toString());
    });
    refresh();
}

const StudyExperiment* MeasurementPanel::experimentOf(const QTreeWidgetItem* item) const {
    while (item && item->parent()) item = item->parent();
    if (!item || !document_.isOpen()) return nullptr;
    const std::string name = item->data(0, experimentRole).toString().toStdString();
    for (const StudyExperiment& e : document_.study().experiments)
        if (e.name == name) return &e;
    return nullptr;
}

const ChannelMapping* MeasurementPanel::mappingOf(const QTreeWidgetItem* item) const {
    const StudyExperiment* experiment = experimentOf(item);
    if (!experiment) return nullptr;
    const bool isInput = static_cast<Kind>(item->data(0, kindRole).toInt()) == Kind::Input;
    const auto& channels = isInput ? experiment->inputs : experiment->outputs;
    const auto found = channels.find(item->data(0, signalRole).toString().toStdString());
    return found == channels.end() ? nullptr : &found->second;
}

void MeasurementPanel::change(const QTreeWidgetItem* item, const QString& what,
                              const std::function<void(StudyExperiment&)>& edit) {
    const StudyExperiment* experiment = experimentOf(item);
    if (!experiment) return;
    StudySettings settings = document_.settings();
    for (StudyExperiment& e : settings.experiments)
        if (e.name == experiment->name) edit(e);
    dropUnaskedClocks(settings.parameters, settings.experiments);
    document_.applySettings(std::move(settings), what);
}

void MeasurementPanel::map(const QTreeWidgetItem* item, const QString& column) {
    const std::string signal = item->data(0, signalRole).toString().toStdString();
    const bool isInput = static_cast<Kind>(item->data(0, kindRole).toInt()) == Kind::Input;
    if (item->data(1, columnRole).toString() == column) return;
    change(item, tr("Map %1").arg(QString::fromStdString(signal)), [&](StudyExperiment& e) {
        auto& channels = isInput ? e.inputs : e.outputs;
        if (column.isEmpty()) {
            channels.erase(signal);
        } else {
            const std::shared_ptr<const Table> file = fileTable(document_.study().tables, e);
            const ChannelName name = file ? channelOf(*file, column.toStdString()) : ChannelName{column.toStdString()};
            channels[signal] = {};
            channels[signal].column = name.column;
            channels[signal].group = name.group;
        }
    });
}

void MeasurementPanel::setRole(const QTreeWidgetItem* item, bool isFit) {
    const StudyExperiment* experiment = experimentOf(item);
    if (!experiment || (experiment->role == Role::Fit) == isFit) return;
    change(item, isFit ? tr("Use to fit") : tr("Use to validate"),
           [&](StudyExperiment& e) { e.role = isFit ? Role::Fit : Role::Validate; });
}

void MeasurementPanel::setUsed(const QTreeWidgetItem* item, bool isUsed) {
    const StudyExperiment* experiment = experimentOf(item);
    if (!experiment || experiment->isUsed == isUsed) return;
    // The row that was clicked is built anew: not before its own signal is done.
    QMetaObject::invokeMethod(
        this, [this, name = experiment->name, isUsed] { useRecordings(document_, {name}, isUsed); },
        Qt::QueuedConnection);
}

void MeasurementPanel::setRange(const QTreeWidgetItem* item, const QString& text) {
    const std::optional<std::pair<double, double>> range = readRange(text);
    if (!range && !text.trimmed().isEmpty() && text != tr("all")) return;
    change(item, tr("Set the range"), [&](StudyExperiment& e) { e.range = range; });
}

void MeasurementPanel::removeExperiment() {
    const StudyExperiment* experiment = experimentOf(tree_->currentItem());
    if (!experiment) return;
    const std::string name = experiment->name;
    StudySettings settings = document_.settings();
    std::erase_if(settings.experiments, [&](const StudyExperiment& e) { return e.name == name; });
    dropUnaskedClocks(settings.parameters, settings.experiments);
    document_.applySettings(std::move(settings), tr("Remove %1").arg(QString::fromStdString(name)));
}

void MeasurementPanel::propose() {
    if (!document_.isOpen()) return;
    StudySettings settings = document_.settings();
    for (StudyExperiment& e : settings.experiments)
        if (const auto file = fileTable(settings.tables, e))
            proposeMapping(e, isOnOneRaster(*file) ? *file : namesOfAll(*file), document_.facts(),
                           document_.study().experiments);
    if (const QString why = whyNoneIsProposed(settings.experiments); !why.isEmpty()) return Q_EMIT told(why);
    document_.applySettings(std::move(settings), tr("Propose mapping"));
}

/// Why the proposal leaves everything as it is; empty: it does not.
QString MeasurementPanel::whyNoneIsProposed(const std::vector<StudyExperiment>& proposed) const {
    const auto isSame = [](const StudyExperiment& a, const StudyExperiment& b) {
        return a.inputs.size() == b.inputs.size() && a.outputs.size() == b.outputs.size();  // it only adds
    };
    const std::vector<StudyExperiment>& now = document_.study().experiments;
    if (!std::equal(now.begin(), now.end(), proposed.begin(), proposed.end(), isSame)) return {};
    const ModelFacts& facts = document_.facts();
    if (facts.inputs.empty() && facts.outputs.empty())
        return tr(
            "The model has no input and no output yet: insert a RealInput for what drives it, a RealOutput for what "
            "it is compared with.");
    const auto isWhole = [&](const StudyExperiment& e) {
        const auto has = [](const auto& channels) {
            return [&channels](const SignalFact& signal) { return channels.contains(signal.name); };
        };
        return std::all_of(facts.inputs.begin(), facts.inputs.end(), has(e.inputs)) &&
               std::all_of(facts.outputs.begin(), facts.outputs.end(), has(e.outputs));
    };
    return std::all_of(now.begin(), now.end(), isWhole)
               ? tr("Every input and output has its column already.")
               : tr("No further column fits by unit and name: choose it in the list, by a double click.");
}

void MeasurementPanel::showMenu(QPoint at) {
    const StudyExperiment* experiment = experimentOf(tree_->itemAt(at));
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Import …"), this, &MeasurementPanel::browseWanted);
    menu->addAction(tr("Propose mapping"), this, &MeasurementPanel::propose);
    if (experiment) {
        QTreeWidgetItem* item = tree_->itemAt(at);
        if (mappingOf(item))
            menu->addAction(tr("Set the clock …"), this, [this, item] {
                tree_->showColumn(Clock);
                tree_->editItem(item, Clock);
            });
        if (mappingOf(item))
            menu->addAction(tr("Set the unit …"), this, [this, item] {
                tree_->showColumn(Unit);
                tree_->editItem(item, Unit);
            });
        if (mappingOf(item))
            menu->addAction(tr("Compare with other recordings"), this, [this, item] {
                Q_EMIT comparisonWanted(item->data(0, signalRole).toString(),
                                        item->parent()->data(0, experimentRole).toString());
            });
        addSource(*menu, item);
        addInterpolation(*menu, item);
        while (item->parent()) item = item->parent();
        const bool isFit = experiment->role == Role::Fit;
        menu->addSeparator();
        const QString name = item->data(0, experimentRole).toString();
        menu->addAction(tr("Locate the file …"), this, [this, name] { Q_EMIT locateWanted(name); });
        menu->addAction(tr("Show the values"), this,
                        [this, item] { Q_EMIT valuesWanted(item->data(0, experimentRole).toString()); });
        menu->addAction(isFit ? tr("Use to validate") : tr("Use to fit"), this,
                        [this, item, isFit] { setRole(item, !isFit); });
        menu->addAction(tr("Remove %1").arg(QString::fromStdString(experiment->name)), this,
                        &MeasurementPanel::removeExperiment);
    }
    menu->popup(tree_->viewport()->mapToGlobal(at));
}

/// Where it is the row of a recording's file; of one that was not read, another is looked for.
void MeasurementPanel::showValuesOf(const QTreeWidgetItem* item) {
    const Kind kind = static_cast<Kind>(item->data(0, kindRole).toInt());
    if (kind != Kind::Info && kind != Kind::Unread) return;
    const QString experiment = item->parent()->data(0, experimentRole).toString();
    if (isUnread(document_, experiment)) return Q_EMIT locateWanted(experiment);
    if (kind == Kind::Info) Q_EMIT valuesWanted(experiment);
}

QTreeWidgetItem* MeasurementPanel::signalItem(const QString& experiment, const QString& signal) const {
    for (int i = 0; i < tree_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* top = tree_->topLevelItem(i);
        if (top->data(0, experimentRole).toString() != experiment) continue;
        for (int k = 0; k < top->childCount(); ++k)
            if (top->child(k)->data(0, signalRole).toString() == signal ||
                (top->child(k)->data(0, signalRole).isNull() &&
                 top->child(k)->data(1, columnRole).toString() == signal))
                return top->child(k);
    }
    return nullptr;
}

/// A column is dragged onto a signal within the tree.
bool MeasurementPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == tree_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Delete) {
            removeExperiment();
            return true;
        }
        const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
        if (isEnter && tree_->currentItem() && tree_->hasFocus()) {  // and not the end of typing in a field
            QTreeWidgetItem* const item = tree_->currentItem();
            showValuesOf(item);
            tree_->editItem(item, 1);
            return true;
        }
        return false;
    }
    const auto* mouse = dynamic_cast<QMouseEvent*>(event);
    if (watched != tree_->viewport() || !mouse) return QWidget::eventFilter(watched, event);
    const auto target = [&]() -> QTreeWidgetItem* {
        QTreeWidgetItem* item = tree_->itemAt(mouse->pos());
        if (!item || item->data(0, signalRole).isNull()) return nullptr;
        return item;
    };
    switch (event->type()) {
        case QEvent::MouseButtonPress: {
            const QTreeWidgetItem* item = tree_->itemAt(mouse->pos());
            draggedColumn_ =
                item && mouse->button() == Qt::LeftButton ? item->data(1, columnRole).toString() : QString();
            pressedAt_ = mouse->pos();
            return false;
        }
        case QEvent::MouseMove:
            if (draggedColumn_.isEmpty() || !(mouse->buttons() & Qt::LeftButton)) return false;
            if ((mouse->pos() - pressedAt_).manhattanLength() < QApplication::startDragDistance()) return true;
            isDragging_ = true;
            tree_->viewport()->setCursor(target() ? Qt::DragLinkCursor : Qt::ForbiddenCursor);
            return true;
        case QEvent::MouseButtonRelease: {
            tree_->viewport()->unsetCursor();
            const QString column = std::exchange(draggedColumn_, {});
            if (!std::exchange(isDragging_, false) || column.isEmpty()) return false;
            if (QTreeWidgetItem* item = target()) map(item, column);
            return true;
        }
        default:
            return QWidget::eventFilter(watched, event);
    }
}

}  // namespace analogon::ui
