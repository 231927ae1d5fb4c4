#include "ui/measurement/measurement_panel.hpp"

#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollBar>
#include <QStackedLayout>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <map>
#include <set>

#include "core/base/unit.hpp"
#include "core/measure/all_channels.hpp"
#include "core/measure/channel_place.hpp"
#include "core/measure/common_raster.hpp"
#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/locate.hpp"
#include "ui/measurement/mapping.hpp"
#include "ui/measurement/recording_extent.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr int experimentRole = Qt::UserRole, kindRole = Qt::UserRole + 1, signalRole = Qt::UserRole + 2,
              columnRole = Qt::UserRole + 3;

const Column* columnOf(const Table* file, const ChannelName& name) {
    if (!file) return nullptr;
    const std::vector<ChannelPlace> places = placesOf(*file, name);
    return places.size() == 1 ? places.front().column : nullptr;
}

/// How a channel is called where the file may have several of its name.
QString labelText(const Table* file, const ChannelName& name) {
    const Column* column = columnOf(file, name);
    return QString::fromStdString(column ? labelOf(*file, *column) : name.column);
}

/// The channels of a file that are no stamps.
std::vector<const Column*> channelsOf(const Table& file) {
    std::vector<const Column*> channels;
    const std::vector<const Table*> groups = tablesOf(file);
    for (const Table* const group : groups)
        for (std::size_t i = 0; i < group->columns.size(); ++i)
            if (groups.size() == 1 || group->time != i) channels.push_back(&group->columns[i]);
    return channels;
}

QString withUnit(const std::string& label, const std::string& unit) {
    const QString text = QString::fromStdString(label);
    return unit.empty() ? text : text + QStringLiteral("  [%1]").arg(QString::fromStdString(unit));
}

QString columnText(const Table* table, const ChannelMapping& mapping) {
    const Column* column = columnOf(table, mapping.channel());
    const std::string unit = mapping.unit.empty() && column ? column->unit : mapping.unit;
    QString text = withUnit(column ? labelOf(*table, *column) : mapping.column, unit);
    if (mapping.interpolation == Interpolation::Hold) text += QStringLiteral(" · ") + MeasurementPanel::tr("held");
    return text;
}

QString clockTip(bool isOutput) {
    const QString tip = MeasurementPanel::tr("How far the clock of this channel's logger is ahead of the others");
    return isOutput ? tip + MeasurementPanel::tr(": seconds, or fit to find it. The result is among the parameters.")
                    : tip + MeasurementPanel::tr(", in seconds");
}

QString mappingTip(const ChannelMapping& mapping, const QString& file) {
    QString tip = MeasurementPanel::tr("Column %1 of %2").arg(QString::fromStdString(mapping.column), file);
    if (mapping.scale != 1) tip += MeasurementPanel::tr("\nscaled by %1").arg(style::numberText(mapping.scale, 6));
    if (mapping.offset != 0) tip += MeasurementPanel::tr("\nshifted by %1").arg(style::numberText(mapping.offset, 6));
    if (mapping.interpolation == Interpolation::Hold)
        tip += MeasurementPanel::tr("\nheld: each value lasts until the next sample");
    if (mapping.weight != 1) tip += MeasurementPanel::tr("\nweight %1").arg(style::numberText(mapping.weight, 6));
    return tip;
}

bool hasOwnClock(const ChannelMapping& mapping) { return mapping.fitsClock || mapping.clock != 0; }

QString clockText(const ChannelMapping& mapping) {
    return mapping.fitsClock ? MeasurementPanel::tr("fit") : style::numberText(mapping.clock, 6) + QStringLiteral(" s");
}

/// "0.25", "-0,25 s", "37 ms" in seconds; empty: 0.
std::optional<double> readSeconds(const QString& typed) {
    static const QRegularExpression form(QStringLiteral(R"(^([-+]?[\d.,]+(?:[eE][-+]?\d+)?)\s*([a-z]*)$)"));
    const QString text = typed.trimmed();
    if (text.isEmpty()) return 0.0;
    const QRegularExpressionMatch match = form.match(text);
    const std::optional<double> number = style::readNumber(match.captured(1));
    const QString unit = match.captured(2).isEmpty() ? QStringLiteral("s") : match.captured(2);
    const Outcome<UnitConversion> toSeconds = convertUnit(unit.toStdString(), "s");
    return number && toSeconds ? std::optional((*toSeconds)(*number)) : std::nullopt;
}

/// "0.5 … 2.5 s", "0,5 - 2,5", "0.5 2.5". A comma is a decimal sign and divides nothing: "1,5,3" is no range.
std::optional<std::pair<double, double>> readRange(const QString& typed) {
    static const QString number = QStringLiteral(R"(([-+]?[\d.,]*\d(?:[eE][-+]?\d+)?)\s*s?)"),
                         between = QStringLiteral(R"((?:\s*(?:…|\.{2,3}|;|–|-\s)\s*|(?<=[\ds])-|\s+))");
    static const QRegularExpression form('^' + number + between + number + '$');
    const QRegularExpressionMatch match = form.match(typed.trimmed());
    const std::optional<double> from = style::readNumber(match.captured(1)), to = style::readNumber(match.captured(2));
    return from && to && *from < *to ? std::optional(std::pair(*from, *to)) : std::nullopt;
}

}  // namespace

/// Columns are chosen from a list, roles too; a range is typed, and the clock of a channel.
class MappingDelegate : public QStyledItemDelegate {
public:
    explicit MappingDelegate(MeasurementPanel& panel) : QStyledItemDelegate(&panel), panel_(panel) {}

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        if (index.column() == MeasurementPanel::Clock) return clockEditor(parent, option, index);
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
        if (!box) return QStyledItemDelegate::setEditorData(editor, index);
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
    tree_->setHeaderLabels({tr("Model"), tr("Column"), tr("Clock")});
    tree_->headerItem()->setToolTip(Clock, clockTip(true));
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setRootIsDecorated(true);
    tree_->setUniformRowHeights(true);
    tree_->setIndentation(4 * style::unit);
    tree_->setIconSize({16, 16});
    for (const int section : {Model, Clock})
        tree_->header()->setSectionResizeMode(section, QHeaderView::ResizeToContents);
    tree_->header()->setResizeContentsPrecision(0);  // by the rows in sight
    tree_->header()->setStretchLastSection(false);
    tree_->header()->setSectionResizeMode(Source, QHeaderView::Stretch);
    tree_->setAccessibleName(tr("Measurements"));
    for (const int column : {Source, Clock}) tree_->setItemDelegateForColumn(column, new MappingDelegate(*this));
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

void MeasurementPanel::setClock(const QTreeWidgetItem* item, const QString& typed) {
    const ChannelMapping* mapping = mappingOf(item);
    if (!mapping || typed == clockText(*mapping)) return;
    const bool isInput = static_cast<Kind>(item->data(0, kindRole).toInt()) == Kind::Input;
    const std::string signal = item->data(0, signalRole).toString().toStdString();
    const bool isFitted = !isInput && typed.trimmed() == tr("fit");
    const std::optional<double> seconds = isFitted ? std::optional(0.0) : readSeconds(typed);
    if (!seconds || (mapping->fitsClock == isFitted && mapping->clock == *seconds)) return;
    change(item, tr("Set the clock of %1").arg(QString::fromStdString(signal)), [&](StudyExperiment& e) {
        ChannelMapping& changed = (isInput ? e.inputs : e.outputs)[signal];
        changed.fitsClock = isFitted;
        changed.clock = *seconds;
    });
}

void MeasurementPanel::holdInput(const QTreeWidgetItem* item, bool isHeld) {
    const ChannelMapping* mapping = mappingOf(item);
    const bool isInput = mapping && static_cast<Kind>(item->data(0, kindRole).toInt()) == Kind::Input;
    if (!isInput || (mapping->interpolation == Interpolation::Hold) == isHeld) return;
    const std::string signal = item->data(0, signalRole).toString().toStdString();
    const QString what = isHeld ? tr("Hold %1 between its samples") : tr("Join the samples of %1");
    change(item, what.arg(QString::fromStdString(signal)), [&](StudyExperiment& e) {
        e.inputs[signal].interpolation = isHeld ? Interpolation::Hold : Interpolation::Linear;
    });
}

/// How an input runs between its samples.
void MeasurementPanel::addInterpolation(QMenu& menu, const QTreeWidgetItem* item) {
    const ChannelMapping* mapping = mappingOf(item);
    if (!mapping || static_cast<Kind>(item->data(0, kindRole).toInt()) != Kind::Input) return;
    auto* group = new QActionGroup(&menu);
    for (const bool isHeld : {false, true}) {
        QAction* action = menu.addAction(isHeld ? tr("Held between its samples") : tr("Straight between its samples"),
                                         this, [this, item, isHeld] { holdInput(item, isHeld); });
        action->setCheckable(true);
        action->setChecked((mapping->interpolation == Interpolation::Hold) == isHeld);
        group->addAction(action);
    }
    menu.addSeparator();
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
    const QString name = QString::fromStdString(experiment->name);
    const QString what = isUsed ? tr("Take %1 in") : tr("Leave %1 out");
    // The row that was clicked is built anew: not before its own signal is done.
    QMetaObject::invokeMethod(
        this,
        [this, name, what, isUsed] {
            for (int i = 0; i < tree_->topLevelItemCount(); ++i)
                if (const QTreeWidgetItem* top = tree_->topLevelItem(i);
                    top->data(0, experimentRole).toString() == name)
                    return change(top, what.arg(name), [&](StudyExperiment& e) { e.isUsed = isUsed; });
        },
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
    document_.applySettings(std::move(settings), tr("Propose mapping"));
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
            menu->addAction(tr("Compare with other recordings"), this, [this, item] {
                Q_EMIT comparisonWanted(item->data(0, signalRole).toString(),
                                        item->parent()->data(0, experimentRole).toString());
            });
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

QTreeWidgetItem* MeasurementPanel::addRow(QTreeWidgetItem* top, Kind kind, const QString& text, const QString& value) {
    auto* item = new QTreeWidgetItem(top, {text, value});
    item->setData(0, kindRole, static_cast<int>(kind));
    return item;
}

void MeasurementPanel::addSpares(QTreeWidgetItem* top, const Table& file, const std::set<QString>& used) {
    const QColor muted = style::mutedText(palette());
    const QIcon icon = style::icon("spare");
    const ChannelLabels labels(file);
    QList<QTreeWidgetItem*> items;
    for (const Column* column : channelsOf(file)) {
        const std::string name = labels.of(*column);
        const QString label = QString::fromStdString(name);
        if (used.contains(label)) continue;
        auto* item = new QTreeWidgetItem({tr("not used"), withUnit(name, column->unit)});
        item->setData(0, kindRole, static_cast<int>(Kind::Spare));
        item->setData(1, columnRole, label);
        item->setIcon(0, icon);
        item->setToolTip(0, tr("Kept: the search for effects may use it as a cause"));
        for (int c : {0, 1}) item->setForeground(c, muted);
        items << item;
    }
    top->addChildren(items);
}

void MeasurementPanel::showExtent(QTreeWidgetItem* info, const RecordingExtent& extent) {
    const QString text = QStringLiteral(" · ") + extentText(extent);
    info->setText(0, info->text(0) + text);
    info->setToolTip(0, info->toolTip(0).replace('\n', text + '\n'));
}

/// A range is looked for in every row.
bool MeasurementPanel::isExtentAtHand(const StudyExperiment& experiment) const {
    return !experiment.range && isAtHand(document_.study().tables, experiment);
}

/// Channels of several rasters are joined beside the window: that may take a while.
void MeasurementPanel::measureExtents() {
    using Extents = std::vector<std::pair<QString, RecordingExtent>>;
    std::vector<StudyExperiment> experiments;
    if (document_.isOpen())
        for (const StudyExperiment& e : document_.study().experiments)
            if (!isExtentAtHand(e)) experiments.push_back(e);
    if (experiments.empty()) return measurer_.drop();
    measurer_.start<Extents>(
        tr("Reading"),
        [experiments, tables = document_.study().tables](const Progress& progress) {
            Extents extents;
            for (const StudyExperiment& e : experiments) {
                if (progress.stopRequested()) break;
                if (const auto table = shownTable(tables, e))
                    extents.emplace_back(QString::fromStdString(e.name), extentOf(*table, e));
            }
            return extents;
        },
        [this](const Extents& extents) {
            // no width depends on it: the columns need not be measured with each of them
            const QSignalBlocker blocker(tree_), quiet(tree_->model());
            tree_->viewport()->update();
            for (int i = 0; i < tree_->topLevelItemCount(); ++i)
                for (const auto& [name, extent] : extents)
                    if (QTreeWidgetItem* const top = tree_->topLevelItem(i);
                        top->data(0, experimentRole).toString() == name && top->childCount() > 0)
                        showExtent(top->child(0), extent);
        });
}

void MeasurementPanel::markLeftOut() {
    const QSignalBlocker blocker(tree_);
    for (int i = 0; i < tree_->topLevelItemCount(); ++i)
        if (const StudyExperiment* const experiment = experimentOf(tree_->topLevelItem(i)))
            mark(tree_->topLevelItem(i), *experiment);
}

/// A recording that is not used, or has a fault, is told from the others, and why is said where one points.
void MeasurementPanel::mark(QTreeWidgetItem* top, const StudyExperiment& experiment) const {
    const bool isMissing = isUnread(document_, QString::fromStdString(experiment.name));
    const FaultyRecording* const faulty = experiment.isUsed ? document_.leftOut(experiment.name) : nullptr;
    QStringList why;
    for (const Diagnostic& said : faulty ? faulty->why : Diagnostics())
        if (said.severity == Severity::Error) why << inWords(said.message);
    const QString tip = faulty              ? tr("Left out until this is mended:") + "\n" + why.join('\n')
                        : experiment.isUsed ? tr("Clear the check box to leave the recording out of all work")
                                            : tr("Left out of all work; set the check box to take it in");
    if (top->toolTip(0) == tip) return;  // it says all that the row shows of it
    top->setIcon(0, style::icon(isMissing ? "error" : faulty ? "warning" : "recording"));
    top->setForeground(0, !experiment.isUsed    ? QBrush(style::mutedText(palette()))
                          : faulty || isMissing ? QBrush(style::caution(palette()))
                                                : QBrush());
    top->setToolTip(0, tip);
}

/// Why there is nothing of the file, and what to do.
void MeasurementPanel::addUnread(QTreeWidgetItem* top, const StudyExperiment& experiment) {
    if (!isUnread(document_, QString::fromStdString(experiment.name))) return;
    const Diagnostics& faults = document_.study().unread.at(tableKey(experiment));
    auto* item = addRow(top, Kind::Unread, inWords(faults.front().message), {});
    item->setIcon(0, style::icon("error"));
    item->setForeground(0, style::fault(palette()));
    QStringList tip;
    for (const Diagnostic& d : faults) tip << inWords(d.message);
    tip << tr("Double-click or Enter looks for the file");
    item->setToolTip(0, tip.join('\n'));
}

/// The row of a recording with those below it. They come into the tree together: it lays itself out once.
QTreeWidgetItem* MeasurementPanel::itemOf(const StudyExperiment& experiment) {
    const std::shared_ptr<const Table> whole = fileTable(document_.study().tables, experiment);
    const Table* const table = whole.get();
    const QString file = QString::fromStdString(std::filesystem::path(experiment.file).filename().string());
    const QString name = QString::fromStdString(experiment.name);
    const QColor muted = style::mutedText(palette());
    const bool isFit = experiment.role == Role::Fit;

    auto* top = new QTreeWidgetItem({name, isFit ? tr("fit") : tr("validate")});
    top->setFlags(top->flags() | Qt::ItemIsEditable);
    top->setData(0, experimentRole, name);
    top->setData(0, kindRole, static_cast<int>(Kind::Experiment));
    QFont bold = top->font(0);
    bold.setWeight(QFont::DemiBold);
    top->setFont(0, bold);
    top->setCheckState(0, experiment.isUsed ? Qt::Checked : Qt::Unchecked);
    top->setToolTip(
        1, isFit ? tr("Used to fit and to choose effects") : tr("Only reported; never used to fit or to choose"));
    top->setForeground(1, isFit ? style::accentText(palette()) : muted);
    auto* info = addRow(top, Kind::Info, file, {});
    info->setForeground(0, muted);
    info->setToolTip(0, QString::fromStdString(experiment.file) + "\n" + tr("Double-click or Enter shows the values"));
    addUnread(top, experiment);
    mark(top, experiment);
    if (table && isExtentAtHand(experiment)) showExtent(info, extentOf(*table, experiment));

    std::set<QString> used{labelText(table, {experiment.timeColumn, experiment.timeGroup})};
    const auto add = [&](const std::map<std::string, ChannelMapping>& channels,
                         const std::vector<SignalFact>& signalFacts, Kind kind) {
        const bool isInput = kind == Kind::Input;
        const auto addSignal = [&](const std::string& signal, const ChannelMapping* mapping) {
            auto* item = addRow(top, kind, QString::fromStdString(signal),
                                mapping ? columnText(table, *mapping) : tr("not mapped"));
            item->setFlags(item->flags() | Qt::ItemIsEditable);
            item->setData(0, signalRole, QString::fromStdString(signal));
            item->setIcon(0, style::icon(isInput ? "input" : "output"));
            item->setToolTip(0, isInput ? tr("Input of the model") : tr("Output of the model"));
            if (!mapping) {
                item->setForeground(1, style::caution(palette()));
                item->setToolTip(1, tr("Drag a column here, or double-click and choose one"));
                item->setData(1, columnRole, QString());
                return;
            }
            const QString label = labelText(table, mapping->channel());
            item->setData(1, columnRole, label);
            item->setToolTip(1, mappingTip(*mapping, file));
            item->setText(Clock, clockText(*mapping));
            item->setForeground(Clock, mapping->fitsClock      ? style::accentText(palette())
                                       : hasOwnClock(*mapping) ? palette().color(QPalette::Text)
                                                               : muted);
            item->setToolTip(Clock, clockTip(!isInput));
            used.insert(label);
        };
        for (const auto& [signal, mapping] : channels) addSignal(signal, &mapping);
        for (const SignalFact& fact : signalFacts)
            if (!channels.contains(fact.name)) addSignal(fact.name, nullptr);
    };
    add(experiment.inputs, document_.facts().inputs, Kind::Input);
    add(experiment.outputs, document_.facts().outputs, Kind::Output);
    if (table) addSpares(top, *table, used);
    QString range = tr("all");
    if (experiment.range)
        range = QStringLiteral("%1 … %2 s")
                    .arg(style::numberText(experiment.range->first, 6), style::numberText(experiment.range->second, 6));
    auto* rangeItem = addRow(top, Kind::Range, tr("range"), range);
    rangeItem->setFlags(rangeItem->flags() | Qt::ItemIsEditable);
    rangeItem->setIcon(0, style::icon("time"));
    rangeItem->setForeground(1, muted);
    rangeItem->setToolTip(1, tr("Double-click and type from and to, in seconds"));
    return top;
}

/// All rows anew. A recording stays folded or unfolded; of many, new ones are folded.
void MeasurementPanel::fillTree() {
    constexpr std::size_t mostUnfolded = 12;
    const std::vector<StudyExperiment>& experiments = document_.study().experiments;
    std::map<QString, bool> wasUnfolded;
    for (int i = 0; i < tree_->topLevelItemCount(); ++i)
        wasUnfolded[tree_->topLevelItem(i)->data(0, experimentRole).toString()] = tree_->topLevelItem(i)->isExpanded();
    QList<QTreeWidgetItem*> items;
    for (const StudyExperiment& experiment : experiments) items << itemOf(experiment);
    tree_->clear();
    tree_->addTopLevelItems(items);
    for (QTreeWidgetItem* const top : items) {
        for (int i = 0; i < top->childCount(); ++i)
            if (const auto kind = static_cast<Kind>(top->child(i)->data(0, kindRole).toInt());
                kind == Kind::Info || kind == Kind::Unread)
                top->child(i)->setFirstColumnSpanned(true);
        const auto known = wasUnfolded.find(top->data(0, experimentRole).toString());
        const bool isFew = experiments.size() <= mostUnfolded;
        top->setExpanded(known == wasUnfolded.end() ? isFew : known->second);
    }
}

void MeasurementPanel::refresh() {
    const QSignalBlocker blocker(tree_);
    const auto hasClock = [](const StudyExperiment& experiment) {
        const auto isOwn = [](const auto& channel) { return hasOwnClock(channel.second); };
        return std::any_of(experiment.inputs.begin(), experiment.inputs.end(), isOwn) ||
               std::any_of(experiment.outputs.begin(), experiment.outputs.end(), isOwn);
    };
    const int scrolled = tree_->verticalScrollBar()->value();
    const bool isOpen = document_.isOpen();
    import_->setEnabled(isOpen);
    table_->setEnabled(isOpen && !document_.study().experiments.empty());
    propose_->setEnabled(isOpen && !document_.study().experiments.empty());
    if (isOpen)
        fillTree();
    else
        tree_->clear();
    measureExtents();
    // few loggers have one: the names of columns need the room
    const auto& experiments = document_.study().experiments;
    tree_->setColumnHidden(Clock, !isOpen || std::none_of(experiments.begin(), experiments.end(), hasClock));
    tree_->verticalScrollBar()->setValue(scrolled);
    empty_->setText(isOpen
                        ? tr("Drop a measurement file on the window, or press Import.\nIts columns are then mapped to "
                             "the inputs and outputs of the model.")
                        : tr("The measurements of the open study appear here."));
    pages_->setCurrentWidget(tree_->topLevelItemCount() > 0 ? static_cast<QWidget*>(tree_) : empty_);
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
