#pragma once

#include <QObject>
#include <QPoint>
#include <vector>

#include "core/diagram/diagram.hpp"

class QAction;
class QLabel;
class QMenu;

namespace analogon::ui {

class Chooser;
class Composer;
class DiagramScene;
class DiagramView;
class Document;
class LibraryPanel;

/// The commands of the diagram with their keys, and the way from a gesture to an edit of the model. Every one works
/// with the keyboard alone.
class ComposeActions : public QObject {
    Q_OBJECT

public:
    ComposeActions(Document& document, DiagramScene& scene, DiagramView& view, LibraryPanel& library, QObject* parent);
    ~ComposeActions() override;

    void fill(QMenu& menu) const;
    Chooser* chooser() const { return chooser_; }
    Composer& composer() { return *composer_; }
    /// A block of this class where there is room, selected.
    std::string placeAnywhere(const QString& className);
    /// A component as a text declares it, left of all others, selected.
    void placeDeclared(const QString& declaration);
    /// A picture of a file, which comes to lie in the model.
    void addPicture(const QString& file);

Q_SIGNALS:
    void told(const QString& sentence);  // why something was not done
    void inspectWanted(const QString& block);
    void pictureWanted();

private:
    QAction* make(const QString& text, const QList<QKeySequence>& keys, void (ComposeActions::*slot)());
    void connectGestures();
    void update();
    void report(bool isDone);
    std::vector<std::string> blocks() const;
    void show(const std::string& block);
    void clearGhost();
    void chooseBlock(const QString& typed);

    void insertBlock() { chooseBlock({}); }
    void startWire();
    void chooseEnd(const QString& from);
    void cut();
    void copy();
    void paste();
    void duplicate();
    void remove();
    void rotate();
    void flipHorizontally();
    void flipVertically();
    void rename();
    void renameModel();
    void askForUnit();
    void addText();
    void editText();
    void selectAll();
    void group();
    void enter();
    void leave();
    void pasteText(const std::string& text, double dx, double dy);

    Document& document_;
    DiagramScene& scene_;
    DiagramView& view_;
    LibraryPanel& library_;
    std::unique_ptr<Composer> composer_;
    Chooser* chooser_;
    QAction *insert_{}, *wire_{}, *cut_{}, *copy_{}, *paste_{}, *duplicate_{}, *remove_{}, *rotate_{}, *flipH_{},
        *flipV_{}, *rename_{}, *renameModel_{}, *unit_{}, *text_{}, *picture_{}, *selectAll_{}, *group_{}, *enter_{},
        *leave_{};
    std::vector<QAction*> align_, distribute_;
    std::string pastedText_;
    int pasteCount_{};  // of the same text: each copy lies a step further
};

}  // namespace analogon::ui
