#pragma once

#include <gtest/gtest.h>

#include <QDir>
#include <QDirIterator>
#include <QDropEvent>
#include <QMimeData>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>
#include <QUrl>
#include <QWindow>

#include "core/archive/archive.hpp"
#include "core/base/owned_directory.hpp"
#include "ui/document/document.hpp"
#include "ui/fit/run_controller.hpp"
#include "ui/window/main_window.hpp"

namespace analogon::ui {

/// A window as a user has it before him, and what is done with it over and over.
class Panels : public testing::Test {
protected:
    void SetUp() override {
        qputenv("XDG_DATA_HOME", directory.path().toUtf8());  // copies of other programs are none of our business
        window.resize(1440, 900);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    }
    ~Panels() override { QTest::qWait(1); }

    Document& document() { return window.document(); }
    template <class T>
    T* panel(const QString& name = {}) const {
        return window.findChild<T*>(name);
    }
    static QString example(const QString& file) {
        return QStringLiteral(ANALOGON_ROOT "/examples/lambda-sensor-heating/") + file;
    }
    /// A copy of an example as one file.
    QString lambdaFile(const QString& name = "lambda") {
        const QString file = directory.filePath(name + ".analogon");
        const Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        EXPECT_TRUE(study);
        EXPECT_TRUE(saveStudy(*study, file.toStdString()));
        return file;
    }
    void openLambda() {
        window.open(lambdaFile());
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
    }
    static QDir recoveryPlace() {
        return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery");
    }
    /// Of the work in this window; empty: there is none.
    static QString keptCopy() {
        QDirIterator copies(recoveryPlace().path(), {"copy.analogon"}, QDir::Files, QDirIterator::Subdirectories);
        return copies.hasNext() ? copies.next() : QString();
    }
    /// What a program that ended without saving leaves behind; the study belongs into `file` of the test's directory.
    QString abandonedCopy(const QString& file) {
        recoveryPlace().mkpath(".");
        auto left = OwnedDirectory::make(recoveryPlace().path().toStdString(), "work-", OwnedDirectory::Left::Kept);
        EXPECT_TRUE(left);
        const QString copy = QString::fromStdString((left->path() / "copy.analogon").string());
        left->release();
        const Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        EXPECT_TRUE(study);
        EXPECT_TRUE(saveStudy(*study, copy.toStdString()));
        QFile note(copy + ".origin");
        EXPECT_TRUE(note.open(QIODevice::WriteOnly));
        note.write(directory.filePath(file).toUtf8());
        return copy;
    }
    /// As the desktop delivers files that are dropped over the middle of a widget; false: they are refused there.
    bool drop(QWidget* target, const QStringList& paths) {
        QMimeData files;
        QList<QUrl> urls;
        for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
        files.setUrls(urls);
        files.setText(urls.front().toString());  // as file managers do
        const QPoint at = target->mapTo(&window, target->rect().center());
        QDragEnterEvent enter(at, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.windowHandle(), &enter);
        QDragMoveEvent move(at, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.windowHandle(), &move);
        if (!move.isAccepted()) return false;
        QDropEvent drop(at, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(window.windowHandle(), &drop);
        return drop.isAccepted();
    }
    void run(RunKind kind) {
        window.controller().start(kind);
        ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 120000));
        QTest::qWait(20);
    }

    QTemporaryDir directory;
    MainWindow window;
};

}  // namespace analogon::ui
