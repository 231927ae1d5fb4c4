#include "ui/window/album.hpp"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QStatusBar>
#include <iostream>

#include "ui/document/document.hpp"
#include "ui/window/main_window.hpp"

namespace analogon::ui {

void Album::beginAnew() {
    const QString place = QStringLiteral("window%1%2").arg(suffix_).arg(++windows_);
    expect(data_.mkpath(place));
    qputenv("XDG_DATA_HOME", data_.filePath(place).toUtf8());
}

void Album::take(MainWindow& window, const QString& name) {
    window.statusBar()->clearMessage();  // it tells how fast this machine is: no part of the picture
    takeDialog(window, name);
}

void Album::takeDialog(QWidget& dialog, const QString& name) {
    const QString file = directory_.filePath(name + suffix_ + ".png");
    expect(dialog.grab().save(file));
    std::cout << file.toStdString() << std::endl;
}

bool waitUntil(const std::function<bool()>& holds, int milliseconds) {
    QElapsedTimer clock;
    clock.start();
    while (!holds() && clock.elapsed() < milliseconds)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    return holds();
}

void goOnFor(int milliseconds) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < milliseconds) QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
}

bool openIn(Album& album, MainWindow& window, QSize size, const QString& example) {
    album.beginAnew();
    window.resize(size);
    window.show();
    window.open(example);
    return waitUntil([&] { return window.document().isOpen() && window.document().before(); });
}

}  // namespace analogon::ui
