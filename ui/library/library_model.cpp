#include "ui/library/library_model.hpp"

#include <QApplication>
#include <QCoreApplication>
#include <QPainter>
#include <QPalette>
#include <functional>

#include "core/diagram/diagram.hpp"
#include "ui/canvas/icon_painter.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

struct LibraryModel::Node {
    std::string name, className, description;
    bool isPackage{};
    Node* parent{};
    int row{};
    std::vector<std::unique_ptr<Node>> children;
};

bool isPlaceable(const LibraryClass& cls) {
    using Restriction = syntax::ClassDefinition::Restriction;
    const syntax::ClassDefinition& d = *cls.definition;
    const bool isKind = d.restriction == Restriction::Model || d.restriction == Restriction::Block ||
                        d.restriction == Restriction::Connector || d.restriction == Restriction::Class;
    return isKind && !d.isPartial && !d.isProtected;
}

QPixmap classPixmap(const Library& library, const std::string& className, int size, double ratio) {
    QPixmap pixmap(QSize(size, size) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    Icon icon = readIcon(library, className);
    std::erase_if(icon.primitives, [](const Primitive& p) { return p.kind == Primitive::Kind::Text; });
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const double half = size / 2.0, unit = size / 22.0;  // a connector stands out by half of itself
    painter.translate(half, half);
    painter.scale(unit, unit);
    Placement placement;
    const QPalette palette = QGuiApplication::palette();
    const auto macros = [](const QString&) { return QString(); };
    paintPrimitives(painter, icon.primitives, toScene(placement, icon.coordinates), macros, palette);
    for (const Port& port : readPorts(library, className)) {
        const Point at = map(placement, icon.coordinates, map(port.placement, Extent{}, {0, 0}));
        painter.setPen(Qt::NoPen);
        painter.setBrush(style::onCanvas(toColour(domainColour(port.domain)), palette));
        painter.drawRect(QRectF(at.x - 1, -at.y - 1, 2, 2));
    }
    return pixmap;
}

QIcon classIcon(const Library& library, const std::string& className, int size, double ratio) {
    const QPixmap pixmap = classPixmap(library, className, size, ratio);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

LibraryModel::LibraryModel(QObject* parent) : QAbstractItemModel(parent), root_(std::make_unique<Node>()) {}

LibraryModel::~LibraryModel() = default;

void LibraryModel::setLibrary(const Library& library, const std::string& hidden) {
    std::vector<std::string> shown;
    for (const LibraryClass* cls : library.classes())
        if (cls->qualifiedName != hidden) shown.push_back(cls->qualifiedName + cls->definition->description);
    library_ = library;
    if (shown == shown_) return;
    beginResetModel();
    shown_ = std::move(shown);
    icons_.clear();
    root_ = std::make_unique<Node>();
    std::map<std::string, Node*> packages{{"", root_.get()}};
    for (const LibraryClass* cls : library_.classes()) {
        const auto scope = packages.find(cls->scope);
        if (cls->qualifiedName == hidden || scope == packages.end()) continue;
        const bool isPackage = cls->definition->restriction == syntax::ClassDefinition::Restriction::Package;
        if (!isPackage && !isPlaceable(*cls)) continue;
        auto node = std::make_unique<Node>();
        node->name = cls->definition->name;
        node->className = cls->qualifiedName;
        node->description = cls->definition->description;
        node->isPackage = isPackage;
        node->parent = scope->second;
        if (isPackage) packages[cls->qualifiedName] = node.get();
        scope->second->children.push_back(std::move(node));
    }
    // The one package that ships with the program needs no level of its own; empty packages no line.
    const std::function<void(Node&)> tidy = [&](Node& node) {
        for (auto& child : node.children) tidy(*child);
        std::erase_if(node.children, [](const auto& c) { return c->isPackage && c->children.empty(); });
        for (std::size_t i = 0; i < node.children.size(); ++i) node.children[i]->row = static_cast<int>(i);
    };
    tidy(*root_);
    auto& top = root_->children;
    const auto shipped =
        std::find_if(top.begin(), top.end(), [](const auto& n) { return n->isPackage && n->className == "Analogon"; });
    if (shipped != top.end()) {  // the study's own classes stand before it
        const auto package = std::move(*shipped);
        top.erase(shipped);
        for (auto& child : package->children) {
            child->parent = root_.get();
            top.push_back(std::move(child));
        }
        for (std::size_t i = 0; i < top.size(); ++i) top[i]->row = static_cast<int>(i);
    }
    endResetModel();
}

const LibraryModel::Node& LibraryModel::nodeOf(const QModelIndex& index) const {
    return index.isValid() ? *static_cast<const Node*>(index.constInternalPointer()) : *root_;
}

QModelIndex LibraryModel::index(int row, int column, const QModelIndex& parent) const {
    const Node& node = nodeOf(parent);
    if (column != 0 || row < 0 || row >= static_cast<int>(node.children.size())) return {};
    return createIndex(row, 0, node.children[static_cast<std::size_t>(row)].get());
}

QModelIndex LibraryModel::parent(const QModelIndex& child) const {
    if (!child.isValid()) return {};
    const Node* parent = nodeOf(child).parent;
    return !parent || parent == root_.get() ? QModelIndex() : createIndex(parent->row, 0, parent);
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
    return parent.column() > 0 ? 0 : static_cast<int>(nodeOf(parent).children.size());
}

int LibraryModel::columnCount(const QModelIndex&) const { return 1; }

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Node& node = nodeOf(index);
    switch (role) {
        case Qt::DisplayRole:  // a block goes by its name in the model's text, a package only by what is in it
            return node.isPackage ? QCoreApplication::translate("LibraryPackage", node.name.c_str())
                                  : QString::fromStdString(node.name);
        case AboutRole:
            return node.isPackage ? QString() : libraryText(node.description);
        case Qt::ToolTipRole:
            return node.description.empty() ? QString::fromStdString(node.className) : libraryText(node.description);
        case Qt::DecorationRole: {
            if (node.isPackage) return {};
            QIcon& icon = icons_[node.className];
            if (icon.isNull()) icon = classIcon(library_, node.className, 24, qApp->devicePixelRatio());
            return icon;
        }
        case ClassNameRole:
            return QString::fromStdString(node.className);
        case IsPackageRole:
            return node.isPackage;
        case SearchRole: {
            const QString english = QString::fromStdString(node.description), own = libraryText(node.description);
            return QStringList{QString::fromStdString(node.name), english, own}.join(u' ');
        }
        default:
            return {};
    }
}

Qt::ItemFlags LibraryModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    return Qt::ItemIsEnabled | Qt::ItemIsSelectable;
}

QModelIndex LibraryModel::find(const QString& className) const {
    const QModelIndexList found =
        rowCount() > 0 ? match(index(0, 0), ClassNameRole, className, 1, Qt::MatchExactly | Qt::MatchRecursive)
                       : QModelIndexList();
    return found.isEmpty() ? QModelIndex() : found.front();
}

}  // namespace analogon::ui
