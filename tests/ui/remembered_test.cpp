#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QSettings>
#include <QSplitter>
#include <QStatusBar>
#include <QTableView>
#include <QTextBrowser>
#include <algorithm>
#include <numeric>

#include "tests/ui/panels_fixture.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/window/guide_page.hpp"

namespace analogon::ui {
namespace {

class Remembered : public Panels {
protected:
    /// A drag of the border below the first part of a panel.
    static void dragBorder(QSplitter* splitter, int down) {
        QWidget* const border = splitter->handle(1);
        const QPoint at = border->rect().center();
        QTest::mousePress(border, Qt::LeftButton, {}, at);
        QTest::mouseMove(border, at + QPoint(0, down));
        QTest::mouseRelease(border, Qt::LeftButton, {}, at + QPoint(0, down));
    }
    /// Anew: an earlier test of this process may have left something there. It is written beside the window; a program
    /// that ends waits for it.
    static bool isWritten(const QString& key, const QVariant& before) {
        return QTest::qWaitFor(
            [&] {
                const QSettings file;
                return file.contains(key) && file.value(key) != before;
            },
            10000);
    }
    template <class Window>
    static QSplitter* shownParts(Window& of, const QString& dock, const QString& name) {
        of.template findChild<QDockWidget*>(dock)->raise();
        QTest::qWait(50);
        return of.template findChild<QSplitter*>(name);
    }
};

TEST_F(Remembered, BordersWithinPanelsStayOverTheNextStart) {
    openLambda();
    const QString file = document().path();
    for (const auto& [dock, name] : {std::pair("library", "library-parts"), std::pair("runs", "runs-parts")}) {
        QSplitter* const parts = shownParts(window, dock, name);
        ASSERT_TRUE(parts);
        const QList<int> before = parts->sizes();
        const QString key = "window/splitter/" + QString(name);
        const QVariant written = QSettings().value(key);
        dragBorder(parts, -30);
        if (parts->sizes() == before) dragBorder(parts, 30);
        const QList<int> made = parts->sizes();
        ASSERT_NE(made, before) << name;
        ASSERT_TRUE(isWritten(key, written));
        MainWindow next;
        next.resize(window.size());
        next.show();
        next.open(file);
        ASSERT_TRUE(QTest::qWaitFor([&] { return next.document().isOpen(); }, 20000));
        const QList<int> restored = shownParts(next, dock, name)->sizes();
        const auto share = [](const QList<int>& sizes) {
            return static_cast<double>(sizes[0]) / std::max(1, std::accumulate(sizes.begin(), sizes.end(), 0));
        };
        EXPECT_NEAR(share(restored), share(made), 0.03) << name;
        EXPECT_GT(std::abs(share(made) - share(before)), 0.03) << name;
    }
}

TEST_F(Remembered, DialogsBeginWhereTheLastOneEnded) {
    openLambda();
    QDir(directory.path()).mkpath("measured");
    const QString folder = directory.filePath("measured");
    window.findChild<QAction*>("import")->trigger();
    auto* dialog = panel<QFileDialog>("import-dialog");
    ASSERT_TRUE(dialog);
    EXPECT_NE(dialog->directory().absolutePath(), folder);
    const QVariant written = QSettings().value("window/folder");
    Q_EMIT dialog->fileSelected(folder + "/run.csv");
    dialog->close();
    ASSERT_TRUE(isWritten("window/folder", written));
    MainWindow next;
    next.show();
    next.findChild<QAction*>("open")->trigger();
    auto* later = next.findChild<QFileDialog*>("open-dialog");
    ASSERT_TRUE(later);
    EXPECT_EQ(later->directory().absolutePath(), folder);
    later->close();
}

TEST_F(Remembered, ASaveThatFailsSaysWhy) {
    openLambda();
    QFile file(directory.filePath("file"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    window.saveTo(file.fileName() + "/below.analogon");
    const auto said = [&] { return window.statusBar()->currentMessage(); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return said().startsWith("Not saved: "); }, 20000));
    EXPECT_FALSE(said().contains("see the messages")) << said().toStdString();
    EXPECT_GT(said().size(), 20);
}

TEST_F(Remembered, TheGuideGivesTheKeysBack) {
    openLambda();
    auto* table = panel<ParameterPanel>()->table();
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    table->setFocus();
    ASSERT_TRUE(table->hasFocus());
    QTest::keyClick(&window, Qt::Key_F1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return panel<GuidePage>() && panel<GuidePage>()->isVisible(); }, 5000));
    EXPECT_TRUE(panel<GuidePage>()->browser()->hasFocus()) << "it turns by keys";
    QTest::keyClick(&window, Qt::Key_F1);
    EXPECT_FALSE(panel<GuidePage>()->isVisible());
    EXPECT_TRUE(table->hasFocus());
}

}  // namespace
}  // namespace analogon::ui
