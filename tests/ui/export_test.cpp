#include "core/export/export.hpp"

#include <gtest/gtest.h>

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTextCursor>

#include "core/archive/archive.hpp"
#include "ui/document/document.hpp"
#include "ui/messages/message_panel.hpp"
#include "ui/text/text_view.hpp"
#include "ui/window/main_window.hpp"

namespace analogon::ui {
namespace {

class Export : public testing::Test {
protected:
    void SetUp() override {
        window.resize(1440, 900);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        EXPECT_FALSE(action("export-fmu")->isEnabled()) << "there is nothing to export yet";
        const Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        ASSERT_TRUE(study);
        ASSERT_TRUE(saveStudy(*study, file("lambda.analogon").toStdString()));
        window.open(file("lambda.analogon"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
    }
    ~Export() override { QTest::qWait(1); }

    Document& document() { return window.document(); }
    QAction* action(const char* name) { return window.findChild<QAction*>(name); }
    QString file(const QString& name) { return directory.filePath(name); }
    /// What the status bar says when the work is done.
    QString exported(ExportFormat format, const QString& path) {
        window.exportTo(format, path);
        const QString begun = window.statusBar()->currentMessage();
        EXPECT_TRUE(QTest::qWaitFor([&] { return window.statusBar()->currentMessage() != begun; }, 60000));
        return window.statusBar()->currentMessage();
    }

    QTemporaryDir directory;
    MainWindow window;
};

TEST_F(Export, WritesWhatTheCommandLineWrites) {
    const struct {
        ExportFormat format;
        const char *name, *begin;
    } cases[] = {{ExportFormat::Fmu, "model.fmu", "PK"},
                 {ExportFormat::Modelica, "whole.mo", "package"},
                 {ExportFormat::Csv, "traces.csv", "experiment"}};
    for (const auto& c : cases) {
        EXPECT_TRUE(exported(c.format, file(c.name)).contains(file(c.name)));
        const std::filesystem::path beside = file(QString("cli-") + c.name).toStdString();
        ASSERT_TRUE(exportStudy(document().study(), c.format, beside));
        EXPECT_NEAR(static_cast<double>(QFileInfo(file(c.name)).size()),
                    static_cast<double>(std::filesystem::file_size(beside)), c.format == ExportFormat::Fmu ? 100 : 0)
            << c.name;
        QFile written(file(c.name));
        ASSERT_TRUE(written.open(QIODevice::ReadOnly));
        EXPECT_TRUE(written.read(400).contains(c.begin)) << c.name;
    }
}

TEST_F(Export, AsksWhereTo) {
    ASSERT_TRUE(action("export-modelica")->isEnabled());
    action("export-modelica")->trigger();
    auto* dialog = window.findChild<QFileDialog*>("export-dialog");
    ASSERT_TRUE(dialog);
    EXPECT_EQ(dialog->defaultSuffix(), "mo");
    EXPECT_TRUE(dialog->selectedFiles().value(0).endsWith("lambda.mo"));
    dialog->setDirectory(directory.path());
    dialog->selectFile("chosen");
    QMetaObject::invokeMethod(dialog, "accept");
    EXPECT_TRUE(QTest::qWaitFor([&] { return QFileInfo::exists(file("chosen.mo")); }, 20000));
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.statusBar()->currentMessage().contains("chosen.mo"); }, 20000));
}

TEST_F(Export, LeadsToThePlaceOfAFault) {
    const QString broken = document().modelText().replace("connect(heater.i", "connect(heater.current");
    document().typeText(broken);
    const QString path = file("broken.fmu");
    EXPECT_TRUE(exported(ExportFormat::Fmu, path).contains("see the messages"));
    EXPECT_FALSE(QFileInfo::exists(path));
    const auto& messages = document().messages();
    const auto fault = std::find_if(messages.begin(), messages.end(),
                                    [](const Message& m) { return m.origin == Message::Origin::Run; });
    ASSERT_NE(fault, messages.end());
    const int line = static_cast<int>(broken.left(broken.indexOf("heater.current")).count('\n')) + 1;
    EXPECT_EQ(fault->diagnostic.place.line, line);
    Q_EMIT window.findChild<MessagePanel*>()->placeChosen(fault->diagnostic.place);
    EXPECT_EQ(window.findChild<TextView*>()->textCursor().blockNumber() + 1, line);
}

TEST_F(Export, SaysWhyAFileCannotBeWritten) {
    const QString path = file("nowhere/model.mo");
    EXPECT_TRUE(exported(ExportFormat::Modelica, path).contains("see the messages"));
    ASSERT_FALSE(document().messages().empty());
    EXPECT_EQ(document().messages().back().diagnostic.place.file, path.toStdString());
    EXPECT_FALSE(document().messages().back().diagnostic.hint.empty());
}

}  // namespace
}  // namespace analogon::ui
