#include "ui/measurement/channel_browser.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/measurement/channel_sketch.hpp"
#include "ui/style/find_key.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/number.hpp"
#include "ui/style/sought_words.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr int channelRole = Qt::UserRole, searchRole = Qt::UserRole + 1;
enum ChannelColumn { Name, Unit, About, ColumnCount };

QString rasterText(MasterKind master) {
    switch (master) {
        case MasterKind::Time:
            return ChannelBrowser::tr("over time");
        case MasterKind::Angle:
            return ChannelBrowser::tr("over an angle");
        case MasterKind::Distance:
            return ChannelBrowser::tr("over a distance");
        default:
            return ChannelBrowser::tr("counted");
    }
}

QString groupText(const RecordedGroup& group, std::size_t index) {
    return QString::fromStdString(groupLabel(group, index));
}

QString aboutText(const RecordedChannel& channel) {
    QString text = QString::fromStdString(channel.comment);
    if (channel.kind == ChannelKind::Status)
        text = text.isEmpty() ? ChannelBrowser::tr("states") : ChannelBrowser::tr("states") + " · " + text;
    return text;
}

}  // namespace

ChannelBrowser::ChannelBrowser(QWidget* parent)
    : QWidget(parent),
      search_(new QLineEdit(this)),
      tree_(new QTreeWidget(this)),
      sketch_(new ChannelSketch(this)),
      about_(new QLabel(this)),
      tick_(new QPushButton(tr("Tick what is shown"), this)),
      read_(new QPushButton(this)) {
    search_->setPlaceholderText(tr("Search by name, unit or comment"));
    search_->setClearButtonEnabled(true);
    search_->setAccessibleName(search_->placeholderText());
    tree_->setColumnCount(ColumnCount);
    tree_->setHeaderLabels({tr("Channel"), tr("Unit"), tr("Comment")});
    tree_->setUniformRowHeights(true);
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setAlternatingRowColors(true);
    tree_->setAccessibleName(tr("Channels of the file"));
    style::followTheme(*tree_);
    tree_->header()->setStretchLastSection(true);
    about_->setWordWrap(true);
    about_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    read_->setIcon(style::icon("apply"));
    read_->setDefault(true);

    auto* beside = new QVBoxLayout;
    beside->setSpacing(2 * style::unit);
    beside->addWidget(about_);
    beside->addWidget(sketch_, 1);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(3 * style::unit);
    middle->addWidget(tree_, 3);
    middle->addLayout(beside, 2);
    auto* top = new QHBoxLayout;
    top->addWidget(search_, 1);
    top->addWidget(tick_);
    auto* bottom = new QHBoxLayout;
    bottom->addStretch(1);
    bottom->addWidget(read_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2 * style::unit);
    layout->addLayout(top);
    layout->addLayout(middle, 1);
    layout->addLayout(bottom);
    connect(search_, &QLineEdit::textChanged, this, &ChannelBrowser::filter);
    style::findBy(*this, [this] { return search_; });
    connect(tick_, &QPushButton::clicked, this, &ChannelBrowser::tickShown);
    connect(read_, &QPushButton::clicked, this, &ChannelBrowser::readWanted);
    // a tick of a group is one of each of its channels: they are counted once
    connect(tree_, &QTreeWidget::itemChanged, this, [this] {
        if (!std::exchange(isCounting_, true))
            QTimer::singleShot(0, this, [this] {
                isCounting_ = false;
                count();
            });
    });
    connect(tree_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) { draw(item); });
}

void ChannelBrowser::show(std::shared_ptr<const MeasurementFile> file) {
    file_ = std::move(file);
    search_->clear();
    fill();
    count();
    search_->setFocus();
}

void ChannelBrowser::fill() {
    const QSignalBlocker blocker(tree_);
    tree_->clear();
    QList<QTreeWidgetItem*> groups;
    for (std::size_t g = 0; g < file_->groups.size(); ++g) {
        const RecordedGroup& group = file_->groups[g];
        const QString name = groupText(group, g);
        auto* top = new QTreeWidgetItem(
            {name, {}, tr("%1 samples, %2").arg(style::countText(group.samples), rasterText(group.master))});
        top->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsAutoTristate);
        top->setCheckState(Name, Qt::Unchecked);
        style::tint(*top, About, style::mutedText, palette());
        for (std::size_t c = 0; c < group.channels.size(); ++c) {
            const RecordedChannel& channel = group.channels[c];
            if (group.masterChannel == c || channel.kind == ChannelKind::Text) continue;
            auto* item = new QTreeWidgetItem(
                top, {QString::fromStdString(channel.name), QString::fromStdString(channel.unit), aboutText(channel)});
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
            item->setCheckState(Name, Qt::Unchecked);
            item->setData(Name, channelRole, QPoint(static_cast<int>(g), static_cast<int>(c)));
            item->setData(
                Name, searchRole,
                QString(item->text(Name) + ' ' + item->text(Unit) + ' ' + item->text(About) + ' ' + name).toLower());
            style::tint(*item, About, style::mutedText, palette());
        }
        groups << top;
    }
    tree_->addTopLevelItems(groups);
    tree_->expandAll();
    for (int column : {Name, Unit}) tree_->resizeColumnToContents(column);
    sketch_->show({});
    about_->setText(tr("A channel that is marked is drawn here."));
}

void ChannelBrowser::filter(const QString& words) {
    const style::SoughtWords sought(words);
    tree_->setUpdatesEnabled(false);
    for (int g = 0; g < tree_->topLevelItemCount(); ++g) {
        QTreeWidgetItem* const top = tree_->topLevelItem(g);
        bool isAny = sought.isEmpty();
        for (int c = 0; c < top->childCount(); ++c) {
            const bool fits = sought.areIn(top->child(c)->data(Name, searchRole).toString());
            if (top->child(c)->isHidden() == fits) top->child(c)->setHidden(!fits);
            isAny = isAny || fits;
        }
        top->setHidden(!isAny);
    }
    tree_->setUpdatesEnabled(true);
}

void ChannelBrowser::tickShown() {
    {
        const QSignalBlocker blocker(tree_);
        for (int g = 0; g < tree_->topLevelItemCount(); ++g)
            for (int c = 0; c < tree_->topLevelItem(g)->childCount(); ++c)
                if (QTreeWidgetItem* const item = tree_->topLevelItem(g)->child(c); !item->isHidden())
                    item->setCheckState(Name, Qt::Checked);
    }
    tree_->viewport()->update();
    count();
}

std::set<std::string> ChannelBrowser::chosen() const {
    std::set<std::string> names;
    for (int g = 0; g < tree_->topLevelItemCount(); ++g)
        for (int c = 0; c < tree_->topLevelItem(g)->childCount(); ++c)
            if (const QTreeWidgetItem* const item = tree_->topLevelItem(g)->child(c);
                item->checkState(Name) == Qt::Checked)
                names.insert(item->text(Name).toStdString());
    return names;
}

void ChannelBrowser::count() {
    const std::size_t channels = chosen().size();
    read_->setEnabled(channels > 0);
    read_->setText(channels == 1 ? tr("Read 1 channel") : tr("Read %1 channels").arg(style::countText(channels)));
}

void ChannelBrowser::draw(const QTreeWidgetItem* item) {
    if (!item || !item->data(Name, channelRole).isValid()) return;
    const QPoint place = item->data(Name, channelRole).toPoint();
    QString about = item->text(Name);
    if (!item->text(Unit).isEmpty()) about += QStringLiteral(" [%1]").arg(item->text(Unit));
    if (!item->text(About).isEmpty()) about += '\n' + item->text(About);
    about_->setText(about);
    drawer_.start<CourseSketch>(
        tr("Reading"),
        [file = file_, place](const Progress& progress) {
            return sketchOf(*file, static_cast<std::size_t>(place.x()), static_cast<std::size_t>(place.y()), progress);
        },
        [this](CourseSketch course) { sketch_->show(std::move(course)); });
}

}  // namespace analogon::ui
