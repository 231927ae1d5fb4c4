#include "ui/library/library_panel.hpp"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTextBrowser>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/diagram/diagram.hpp"
#include "core/library/library.hpp"
#include "ui/document/document.hpp"
#include "ui/library/library_delegate.hpp"
#include "ui/library/library_model.hpp"
#include "ui/library/search_words.hpp"
#include "ui/style/find_key.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

/// Classes that what was typed means, with the packages they are in.
class LibraryPanel::Filter : public QSortFilterProxyModel {
public:
    explicit Filter(QObject* parent) : QSortFilterProxyModel(parent) {
        setRecursiveFilteringEnabled(true);
        setAutoAcceptChildRows(true);
    }
    void look(const QString& typed) {
        typed_ = typed.simplified();
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        const QModelIndex index = sourceModel()->index(row, 0, parent);
        return typed_.isEmpty() || isFoundIn(index.data(LibraryModel::SearchRole).toString(), typed_);
    }

private:
    QString typed_;
};

LibraryPanel::LibraryPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      model_(new LibraryModel(this)),
      filtered_(new Filter(this)),
      search_(new QLineEdit(this)),
      nothing_(new QLabel(this)),
      tree_(new QTreeView(this)),
      text_(new QTextBrowser(this)) {
    filtered_->setSourceModel(model_);
    search_->setPlaceholderText(tr("Search blocks"));
    search_->setClearButtonEnabled(true);
    tree_->setModel(filtered_);
    tree_->setHeaderHidden(true);
    tree_->setFrameShape(QFrame::NoFrame);
    tree_->setIconSize({24, 24});
    tree_->setIndentation(4 * style::unit);
    tree_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    tree_->setAccessibleName(tr("Library"));
    tree_->setItemDelegate(new LibraryDelegate(tree_));
    tree_->viewport()->installEventFilter(this);
    tree_->installEventFilter(this);
    text_->setFrameShape(QFrame::NoFrame);
    text_->document()->setDefaultStyleSheet("pre { white-space: pre-wrap; }");  // formulas, too, in a narrow panel
    text_->setOpenLinks(false);
    text_->setAccessibleName(tr("Documentation"));
    text_->document()->setDocumentMargin(style::margin);
    text_->setMinimumHeight(4 * fontMetrics().lineSpacing() + 2 * style::margin);  // a name and what it is for

    auto* splitter = new QSplitter(Qt::Vertical, this);
    splitter->setObjectName("library-parts");
    splitter->addWidget(tree_);
    splitter->addWidget(text_);
    splitter->setStretchFactor(0, 3);
    splitter->setStretchFactor(1, 1);
    splitter->setChildrenCollapsible(false);
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(style::margin, 2 * style::unit, style::margin, 2 * style::unit);
    bar->addWidget(search_);
    style::makeCaption(nothing_);
    nothing_->setWordWrap(true);
    nothing_->setContentsMargins(style::margin, 0, style::margin, 2 * style::unit);
    nothing_->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(nothing_);
    layout->addWidget(splitter, 1);

    style::findBy(*this, [this] { return search_; });
    connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
        filtered_->look(text);
        if (!text.isEmpty()) tree_->expandAll();
        sayNothing();
    });
    connect(search_, &QLineEdit::returnPressed, this, [this] {
        // The first block that is left.
        for (QModelIndex i = filtered_->index(0, 0); i.isValid(); i = tree_->indexBelow(i))
            if (!i.data(LibraryModel::IsPackageRole).toBool()) {
                tree_->setCurrentIndex(i);
                return Q_EMIT placeWanted(currentClass());
            }
    });
    connect(tree_, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
        if (!index.data(LibraryModel::IsPackageRole).toBool()) Q_EMIT placeWanted(currentClass());
    });
    connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this, &LibraryPanel::showDocumentation);
    connect(&document, &Document::modelChanged, this, &LibraryPanel::refresh);
    showDocumentation();
}

void LibraryPanel::refresh() {
    if (document_.library().classes().empty()) {  // a text with a fault: the last one still serves
        if (model_->rowCount() > 0 || !document_.isOpen()) return;
        if (const Outcome<Library> shipped = builtInLibrary())
            model_->setLibrary(*shipped, document_.study().className);
        return sayNothing();
    }
    model_->setLibrary(document_.library(), document_.study().className);
    sayNothing();
}

/// An empty list would leave open whether it has been searched.
void LibraryPanel::sayNothing() {
    const QString typed = search_->text().simplified();
    nothing_->setVisible(!typed.isEmpty() && filtered_->rowCount() == 0);
    nothing_->setText(tr("No block is called “%1” or described so. A shorter word may find more.").arg(typed));
}

QString LibraryPanel::currentClass() const {
    const QModelIndex index = tree_->currentIndex();
    return index.data(LibraryModel::IsPackageRole).toBool() ? QString()
                                                            : index.data(LibraryModel::ClassNameRole).toString();
}

QRect LibraryPanel::showClass(const QString& className) {
    const QModelIndex index = filtered_->mapFromSource(model_->find(className));
    if (!index.isValid()) return {};
    for (QModelIndex p = index.parent(); p.isValid(); p = p.parent()) tree_->expand(p);
    tree_->scrollTo(index);
    return tree_->visualRect(index);
}

bool LibraryPanel::read(const QString& className) {
    const QModelIndex known = model_->find(className);
    if (!known.isValid()) return false;
    if (!filtered_->mapFromSource(known).isValid()) search_->clear();  // what was searched for leaves it out
    showClass(className);
    tree_->setCurrentIndex(filtered_->mapFromSource(known));
    return true;
}

QString LibraryPanel::documentation(const QString& className) const {
    const LibraryClass* cls = document_.library().find(className.toStdString());
    if (!cls) return {};
    QString text = QStringLiteral("<p><b>%1</b><br>%2</p>")
                       .arg(QString::fromStdString(cls->definition->name).toHtmlEscaped(),
                            libraryText(cls->definition->description).toHtmlEscaped());
    if (cls->definition->annotation)
        if (const syntax::Modification* doc = cls->definition->annotation->find("Documentation"))
            for (const syntax::Modification& m : doc->arguments)
                if (m.name.text() == "info" && m.value) {
                    QString info = QString::fromStdString(m.value->text);
                    info.remove("<html>").remove("</html>");
                    text += libraryDocumentation(info);
                }
    return text;
}

void LibraryPanel::showDocumentation() {
    const QString name = tree_->currentIndex().data(LibraryModel::ClassNameRole).toString();
    text_->setHtml(name.isEmpty()
                       ? QStringLiteral("<p style='color:%1'>%2</p>")
                             .arg(style::mutedText(palette()).name(),
                                  tr("Drag a block onto the diagram, or choose one and press Enter.").toHtmlEscaped())
                       : documentation(name));
}

void LibraryPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) showDocumentation();
}

/// Dragging is followed here and not left to the system: the block is drawn on the diagram's grid as it goes.
bool LibraryPanel::eventFilter(QObject* watched, QEvent* event) {
    if (watched == tree_ && event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (isDragging_ && key->key() == Qt::Key_Escape) {
            dragged_.clear();
            isDragging_ = false;
            Q_EMIT dragCancelled();
            return true;
        }
        if ((key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) && !currentClass().isEmpty()) {
            Q_EMIT placeWanted(currentClass());
            return true;
        }
        return false;
    }
    const auto* mouse = dynamic_cast<QMouseEvent*>(event);
    if (watched != tree_->viewport() || !mouse) return QWidget::eventFilter(watched, event);
    switch (event->type()) {
        case QEvent::MouseButtonPress:
            if (mouse->button() == Qt::LeftButton) {
                const QModelIndex index = tree_->indexAt(mouse->pos());
                dragged_ = index.data(LibraryModel::IsPackageRole).toBool()
                               ? QString()
                               : index.data(LibraryModel::ClassNameRole).toString();
                pressedAt_ = mouse->pos();
            }
            return false;
        case QEvent::MouseMove:
            if (dragged_.isEmpty() || !(mouse->buttons() & Qt::LeftButton)) return false;
            if (!isDragging_ && (mouse->pos() - pressedAt_).manhattanLength() < QApplication::startDragDistance())
                return true;
            isDragging_ = true;
            Q_EMIT dragged(dragged_, tree_->viewport()->mapToGlobal(mouse->pos()));
            return true;
        case QEvent::MouseButtonRelease:
            if (std::exchange(isDragging_, false) && !dragged_.isEmpty())
                Q_EMIT dropped(std::exchange(dragged_, {}), tree_->viewport()->mapToGlobal(mouse->pos()));
            dragged_.clear();
            return false;
        default:
            return QWidget::eventFilter(watched, event);
    }
}

}  // namespace analogon::ui
