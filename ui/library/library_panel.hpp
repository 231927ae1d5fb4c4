#pragma once

#include <QPoint>
#include <QWidget>

class QLabel;
class QLineEdit;
class QTextBrowser;
class QTreeView;

namespace analogon::ui {

class Document;
class LibraryModel;

/// The blocks that can be placed: a tree with search, and what the chosen one is for. A block is dragged from here
/// onto the diagram; Enter or a double click places it as well.
class LibraryPanel : public QWidget {
    Q_OBJECT

public:
    explicit LibraryPanel(Document& document, QWidget* parent = nullptr);

    QTreeView* tree() const { return tree_; }
    QLineEdit* search() const { return search_; }
    QLabel* nothingFound() const { return nothing_; }  // shown where a search finds nothing
    LibraryModel* model() const { return model_; }
    /// Opens the packages above a class; its place in the tree's viewport.
    QRect showClass(const QString& className);
    QString documentation(const QString& className) const;
    /// Marks a class and tells what it is for; false: the library does not have it.
    bool read(const QString& className);

Q_SIGNALS:
    void placeWanted(const QString& className);  // anywhere
    void dragged(const QString& className, QPoint globalPos);
    void dropped(const QString& className, QPoint globalPos);
    void dragCancelled();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    class Filter;
    void refresh();
    void sayNothing();
    void showDocumentation();
    QString currentClass() const;

    Document& document_;
    LibraryModel* model_;
    Filter* filtered_;
    QLineEdit* search_;
    QLabel* nothing_;
    QTreeView* tree_;
    QTextBrowser* text_;
    QPoint pressedAt_;
    QString dragged_;  // class under way; empty: none
    bool isDragging_{};
};

}  // namespace analogon::ui
