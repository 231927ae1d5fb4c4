#include <QBuffer>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPixmap>
#include <QTabWidget>
#include <QTreeView>

#include "ui/canvas/diagram_view.hpp"
#include "ui/document/composer.hpp"
#include "ui/document/document.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/style/style.hpp"
#include "ui/text/find_bar.hpp"
#include "ui/text/text_view.hpp"
#include "ui/window/album.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/window/main_window.hpp"

/// Scenes of a model that is put together.
namespace analogon::ui {

bool takeGroup(Album& album, const QString& example) {
    MainWindow window;
    if (!openIn(album, window, {1440, 900}, example)) return false;
    Document& document = window.document();
    document.enter(window.compose().composer().group({"heater", "element"}, "Probe"));
    goOnFor(1000);
    album.take(window, "15-inside-a-group");
    return !document.levels().empty();
}

bool takeSmall(Album& album, const QString& example) {
    MainWindow window;
    if (!openIn(album, window, {853, 480}, example)) return false;
    goOnFor(300);
    album.take(window, "16-small-screen");
    return true;
}

/// A text and a picture that the model has in its diagram.
void takeNotes(Album& album, MainWindow& window) {
    Composer& composer = window.compose().composer();
    composer.addText("LSU 4.9, 13 V, 400 °C");
    const QPixmap photo = style::icon("example-lambda-sensor-heating").pixmap(256, 256);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    photo.save(&buffer, "png");
    composer.addPicture(bytes, photo.size());
    window.findChild<DiagramView*>()->fitView();
    goOnFor();
    album.take(window, "22-text-and-picture");
}

/// A block of the library with what it is for, and a wire on its way to a connector that does not fit.
bool takeComposing(Album& album, const QString& example) {
    MainWindow window;
    if (!openIn(album, window, {1440, 900}, example)) return false;
    Document& document = window.document();
    auto* library = window.findChild<LibraryPanel*>();
    const QRect row = library->showClass("Analogon.ThermalFluid.BasicThermalFluid");
    library->tree()->setCurrentIndex(library->tree()->indexAt(row.center()));
    window.compose().composer().addBlock("Analogon.Mechanics.Inertia", {40, -40});
    goOnFor(300);
    auto* view = window.findChild<DiagramView*>();
    view->fitView();
    const auto from = document.diagram().anchor("element.fluid"), to = document.diagram().anchor("inertia.flange_a");
    if (!from || !to) return false;
    const auto send = [&](QEvent::Type type, Point at, Qt::MouseButtons buttons) {
        const QPointF pixel = view->mapFromScene(QPointF(at.x, -at.y));
        QMouseEvent event(type, pixel, view->viewport()->mapToGlobal(pixel), Qt::LeftButton, buttons, {});
        QCoreApplication::sendEvent(view->viewport(), &event);
    };
    send(QEvent::MouseButtonPress, *from, Qt::LeftButton);
    send(QEvent::MouseMove, {(from->x + to->x) / 2, (from->y + to->y) / 2}, Qt::LeftButton);
    send(QEvent::MouseMove, *to, Qt::LeftButton);
    goOnFor();
    album.take(window, "17-a-wire-is-refused");
    send(QEvent::MouseButtonRelease, {-140, -100}, Qt::NoButton);
    takeNotes(album, window);
    document.undoStack().setClean();
    return true;
}

/// A block by another word for it, a search without result, and a word of the text.
bool takeFinding(Album& album, const QString& example) {
    MainWindow window;
    if (!openIn(album, window, {1024, 700}, example)) return false;
    auto* library = window.findChild<LibraryPanel*>();
    window.findChild<QDockWidget*>("library")->raise();
    library->search()->setText("Heizung");
    window.findChild<QTabWidget*>("centre")->setCurrentWidget(window.findChild<TextView*>());
    FindBar* find = window.findChild<TextView*>()->findBar();
    find->open();
    find->field()->setText("heater");
    goOnFor();
    album.take(window, "21-find");
    library->search()->setText("xyz");
    find->field()->setText("xyz");
    goOnFor();
    album.take(window, "21-nothing-found");
    return true;
}

}  // namespace analogon::ui
