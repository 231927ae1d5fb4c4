#include "ui/measurement/measurement_panel.hpp"

#include <QHeaderView>
#include <QLabel>
#include <QStackedLayout>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <set>

#include "ui/document/document.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr int experimentRole = Qt::UserRole;

QString columnText(const Table* table, const ChannelMapping& mapping) {
    const Column* column = table ? table->find(mapping.column) : nullptr;
    const std::string unit = mapping.unit.empty() && column ? column->unit : mapping.unit;
    QString text = QString::fromStdString(mapping.column);
    if (!unit.empty()) text += QStringLiteral("  [%1]").arg(QString::fromStdString(unit));
    return text;
}

QString mappingTip(const ChannelMapping& mapping, const QString& file) {
    QString tip = MeasurementPanel::tr("Column %1 of %2").arg(QString::fromStdString(mapping.column), file);
    if (mapping.scale != 1) tip += MeasurementPanel::tr("\nscaled by %1").arg(mapping.scale);
    if (mapping.offset != 0) tip += MeasurementPanel::tr("\nshifted by %1").arg(mapping.offset);
    if (mapping.weight != 1) tip += MeasurementPanel::tr("\nweight %1").arg(mapping.weight);
    return tip;
}

/// Length of a recording as people say it.
QString extentText(const Table& table, const StudyExperiment& experiment) {
    const Column* time = table.find(experiment.timeColumn);
    QString text = MeasurementPanel::tr("%L1 samples").arg(table.rows());
    if (time && !time->values.empty()) {
        const double first = experiment.range ? experiment.range->first : time->values.front();
        const double last = experiment.range ? experiment.range->second : time->values.back();
        const QString unit = time->unit.empty() ? QStringLiteral("s") : QString::fromStdString(time->unit);
        text += QStringLiteral(" · %1 %2").arg(last - first, 0, 'g', 5).arg(unit);
    }
    return text;
}

}  // namespace

MeasurementPanel::MeasurementPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      tree_(new QTreeWidget(this)),
      pages_(new QStackedLayout(this)),
      empty_(new QLabel(this)) {
    tree_->setColumnCount(2);
    tree_->setHeaderLabels({tr("Model"), tr("Column")});
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setRootIsDecorated(true);
    tree_->setUniformRowHeights(false);
    tree_->setIndentation(4 * style::unit);
    tree_->setIconSize({16, 16});
    tree_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    tree_->header()->setStretchLastSection(true);
    tree_->setAccessibleName(tr("Measurements"));
    empty_->setText(tr("The measurements of the open study appear here."));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setMargin(style::margin);
    style::makeCaption(empty_);
    pages_->addWidget(empty_);
    pages_->addWidget(tree_);
    connect(&document, &Document::opened, this, &MeasurementPanel::refresh);
    connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
        while (item && item->parent()) item = item->parent();
        if (item) Q_EMIT experimentChosen(item->data(0, experimentRole).toString());
    });
}

void MeasurementPanel::refresh() {
    const QSignalBlocker blocker(tree_);
    tree_->clear();
    for (const StudyExperiment& experiment : document_.study().experiments) {
        const auto found = document_.study().tables.find(experiment.file);
        const Table* table = found == document_.study().tables.end() ? nullptr : found->second.get();
        const QString file = QString::fromStdString(experiment.file);
        const QString name = QString::fromStdString(experiment.name);

        auto* top = new QTreeWidgetItem(tree_, {name, experiment.role == Role::Fit ? tr("fit") : tr("validate")});
        top->setIcon(0, style::icon("recording"));
        top->setData(0, experimentRole, name);
        QFont bold = top->font(0);
        bold.setWeight(QFont::DemiBold);
        top->setFont(0, bold);
        top->setToolTip(1, experiment.role == Role::Fit ? tr("Used to fit and to choose effects")
                                                        : tr("Only reported; never used to fit or to choose"));
        top->setForeground(1, experiment.role == Role::Fit ? style::accent(palette()) : style::mutedText(palette()));
        const QString extent = table ? QStringLiteral(" · ") + extentText(*table, experiment) : QString();
        auto* info = new QTreeWidgetItem(top, {file + extent});
        info->setFirstColumnSpanned(true);
        info->setForeground(0, style::mutedText(palette()));
        info->setToolTip(0, info->text(0));

        std::set<std::string> used{experiment.timeColumn};
        const auto add = [&](const std::map<std::string, ChannelMapping>& channels, const QString& icon,
                             const QString& kind) {
            for (const auto& [signal, mapping] : channels) {
                auto* item = new QTreeWidgetItem(top, {QString::fromStdString(signal), columnText(table, mapping)});
                item->setIcon(0, style::icon(icon));
                item->setToolTip(0, kind);
                item->setToolTip(1, mappingTip(mapping, file));
                used.insert(mapping.column);
            }
        };
        add(experiment.inputs, "input", tr("Input of the model"));
        add(experiment.outputs, "output", tr("Output of the model"));
        if (table)
            for (const Column& column : table->columns) {
                if (used.contains(column.name)) continue;
                ChannelMapping mapping;
                mapping.column = column.name;
                auto* item = new QTreeWidgetItem(top, {tr("not used"), columnText(table, mapping)});
                item->setIcon(0, style::icon("spare"));
                item->setToolTip(0, tr("Kept: the search for effects may use it as a cause"));
                for (int c : {0, 1}) item->setForeground(c, style::mutedText(palette()));
            }
        top->setExpanded(true);
    }
    pages_->setCurrentWidget(tree_->topLevelItemCount() > 0 ? static_cast<QWidget*>(tree_) : empty_);
}

}  // namespace analogon::ui
