/// What the window says and leaves where the disk is full: the copy of unsaved work, and the report.
#include "tests/full_disk.hpp"

#include <QDirIterator>
#include <QFileInfo>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

#include "core/archive/archive.hpp"
#include "ui/document/document.hpp"
#include "ui/effect/report_pdf.hpp"
#include "ui/window/main_window.hpp"

namespace analogon::ui {
namespace {

class FullDisk : public SmallDisk {
protected:
    void SetUp() override {
        SmallDisk::SetUp();
        if (!isMounted) return;
        qputenv("XDG_DATA_HOME", place.c_str());
        window = std::make_unique<MainWindow>();
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        const Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        ASSERT_TRUE(study);
        const QString file = directory.filePath("lambda.analogon");
        ASSERT_TRUE(saveStudy(*study, file.toStdString()));
        window->open(file);
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen() && document().before(); }, 20000));
    }
    void TearDown() override {
        window.reset();
        qputenv("XDG_DATA_HOME", directory.path().toUtf8());
        SmallDisk::TearDown();
    }

    Document& document() { return window->document(); }
    bool tells(const QString& words) {
        return QTest::qWaitFor([&] { return window->statusBar()->currentMessage().contains(words); }, 15000);
    }
    /// The copy of the work in this window; empty: there is none.
    static QString keptCopy() {
        const QString below = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery";
        QDirIterator copies(below, {"copy.analogon"}, QDir::Files, QDirIterator::Subdirectories);
        return copies.hasNext() ? copies.next() : QString();
    }
    bool hasCopyOf(const char* text) {
        const QString file = keptCopy();
        if (file.isEmpty()) return false;
        const Outcome<OpenedStudy> opened = openStudy(file.toStdString());
        return opened && opened->study.models.at("model.mo").ends_with(text);
    }
    void type(const std::string& text) { document().typeText(document().modelText() + QString::fromStdString(text)); }

    QTemporaryDir directory;
    std::unique_ptr<MainWindow> window;
};

TEST_F(FullDisk, IsToldWhereTheUnsavedWorkHasNoCopy) {
    const auto isTold = [&] { return tells("No copy of the unsaved work can be kept: "); };
    EXPECT_TRUE(withRoom(0, [&] {
        type("// one\n");
        return isTold();
    }));
    EXPECT_TRUE(keptCopy().isEmpty()) << "nothing is half-written";
    type("// two\n");
    ASSERT_TRUE(QTest::qWaitFor([&] { return hasCopyOf("// two\n"); }, 15000)) << "there is room again";
    window->statusBar()->clearMessage();
    EXPECT_TRUE(withRoom(0, [&] {
        type("// three\n");
        return isTold();
    })) << "it is told again";
    EXPECT_TRUE(hasCopyOf("// two\n")) << "what was kept is whole";
}

TEST_F(FullDisk, LeavesAReportOnPaperAsItWas) {
    const QString file = QFile::decodeName((place / "report.pdf").c_str());
    const auto content = [&] { return bytesOf(place / "report.pdf"); };
    const Finding finding;
    ASSERT_EQ(writeReportPdf(file, "before", RunKind::Fit, finding, {}), "");
    std::string before = content();
    int number = 0;
    fill(
        [&]() -> Outcome<Done> {
            const QString fault = writeReportPdf(file, QString("report %1").arg(++number), RunKind::Fit, finding, {});
            return fault.isEmpty() ? Outcome<Done>(Done{}) : Outcome<Done>(error(fault.toStdString()));
        },
        [&](bool isWritten) {
            const std::string now = content();
            EXPECT_EQ(now != before, isWritten);
            EXPECT_NE(now.find("%%EOF"), std::string::npos);
            before = now;
        });
}

/// Every report is told of as written whole, or as not written.
TEST_F(FullDisk, IsToldWhereTheReportHasNoRoom) {
    RunResult result;
    result.finding.baseline = result.finding.final = *document().before();
    result.completed = document().study();
    document().setResult(RunKind::Fit, std::move(result), Study(document().study()));
    const std::filesystem::path out = place / "out";
    const QString path = QFile::decodeName(out.c_str());
    for (const std::uint64_t room : {0u, 300'000u}) {
        SCOPED_TRACE(room);
        EXPECT_TRUE(withRoom(room, [&] {
            window->writeReport(path);
            return tells("No report written: see the messages.");
        }));
        EXPECT_FALSE(std::filesystem::exists(out)) << namesBelow(place);
        window->statusBar()->clearMessage();
    }
    window->writeReport(path);
    ASSERT_TRUE(tells("report.html."));
    ASSERT_TRUE(std::filesystem::exists(out / "report.pdf"));

    std::uint64_t withoutPaper = 0;  // [byte]
    for (const auto& entry : std::filesystem::recursive_directory_iterator(out))
        if (entry.is_regular_file() && entry.path().filename() != "report.pdf")
            withoutPaper += (entry.file_size() + 4095) / 4096 * 4096;
    std::filesystem::remove_all(out);
    EXPECT_TRUE(withRoom(withoutPaper + 8192, [&] {
        window->writeReport(path);
        return tells("but no report.pdf: see the messages.");
    })) << window->statusBar()->currentMessage().toStdString();
    EXPECT_TRUE(std::filesystem::exists(out / "report.html"));
    EXPECT_FALSE(std::filesystem::exists(out / "report.pdf"));
}

}  // namespace
}  // namespace analogon::ui
