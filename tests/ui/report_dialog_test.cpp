#include "ui/window/report_dialog.hpp"

#include <QAction>
#include <QCheckBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QTextBrowser>
#include <QTextDocument>

#include "core/study/report_settings.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "tests/ui/sample_finding.hpp"
#include "ui/effect/report_diagrams.hpp"
#include "ui/effect/report_pdf.hpp"
#include "ui/effect/report_top.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"
#include "ui/window/report_folder.hpp"

namespace analogon::ui {

namespace {

class Report : public Panels {
protected:
    ReportDialog* openDialog(const char* action = "report-head-action") {
        window.findChild<QAction*>(action)->trigger();
        auto* dialog = window.findChild<ReportDialog*>();
        EXPECT_TRUE(dialog && dialog->isVisible());
        return dialog;
    }
    QString putLogo(const QString& name) const {
        const QString path = directory.filePath(name);
        QImage picture(120, 60, QImage::Format_RGB32);
        picture.fill(QColor("#1763c6"));
        EXPECT_TRUE(picture.save(path));
        return path;
    }
    QString textOf(const QString& file) const {
        QFile stream(directory.filePath(file));
        EXPECT_TRUE(stream.open(QIODevice::ReadOnly)) << file.toStdString();
        return QString::fromUtf8(stream.readAll());
    }
    ReportHead head() { return reportHeadOf(document().study().extraJson); }
};

TEST_F(Report, HeadIsKeptInTheStudyAsOneStepAndShownAsItWillBe) {
    openLambda();
    ReportDialog* dialog = openDialog();
    EXPECT_FALSE(dialog->writeButton()->isEnabled()) << "there is no result yet";
    EXPECT_TRUE(dialog->preview()->toPlainText().contains("lambda")) << "the study's name";
    QTest::keyClicks(dialog->titleField(), "Probe 7");
    QTest::keyClicks(dialog->testObjectField(), "LSU <4>");
    QTest::keyClicks(dialog->authorField(), "E. Noether");
    QTest::keyClicks(dialog->dateField(), "12 March");
    dialog->sectionBox(ReportSection::Tried)->setChecked(false);
    const QString shown = dialog->preview()->toPlainText();
    for (const char* part : {"Probe 7", "LSU <4>", "E. Noether", "12 March"})
        EXPECT_TRUE(shown.contains(part)) << part << "\n" << shown.toStdString();
    const int steps = document().undoStack().count();
    QTest::mouseClick(dialog->keepButton(), Qt::LeftButton);
    EXPECT_EQ(document().undoStack().count(), steps + 1);
    EXPECT_EQ(head(), (ReportHead{"Probe 7", "LSU <4>", "E. Noether", "12 March", {}, {ReportSection::Tried}}));
    document().undoStack().undo();
    EXPECT_EQ(head(), ReportHead{});
    document().undoStack().redo();
    QTest::qWait(1);
    ReportDialog* again = openDialog();
    EXPECT_EQ(again->authorField()->text(), "E. Noether");
    EXPECT_FALSE(again->sectionBox(ReportSection::Tried)->isChecked());
    QTest::mouseClick(again->keepButton(), Qt::LeftButton);
    EXPECT_EQ(document().undoStack().count(), steps + 1) << "nothing was changed";
}

TEST_F(Report, IsWrittenWithItsHeadLogoAndTheSectionsThatWereChosen) {
    openLambda();
    run(RunKind::Fit);
    ReportDialog* dialog = openDialog("report");
    ASSERT_TRUE(dialog->writeButton()->isEnabled());
    dialog->titleField()->setText("Probe 7");
    dialog->logoField()->setText(putLogo("mark.png"));
    dialog->sectionBox(ReportSection::Parameters)->setChecked(false);
    EXPECT_FALSE(dialog->faultLabel()->isVisible());
    QTest::mouseClick(dialog->writeButton(), Qt::LeftButton);
    auto* place = window.findChild<QFileDialog*>("report-dialog");
    ASSERT_TRUE(place) << "where it goes is asked next";
    place->reject();
    window.writeReport(directory.filePath("report"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.statusBar()->currentMessage().contains("report.html"); }, 30000));
    const QString page = textOf("report/report.html");
    EXPECT_TRUE(page.contains("<h1>Probe 7</h1>"));
    EXPECT_TRUE(page.contains("src=\"data:image/png;base64,"));
    EXPECT_FALSE(page.contains("<h2>Parameters"));
    EXPECT_TRUE(QFileInfo::exists(directory.filePath("report/study/mark.png")));
    EXPECT_FALSE(textOf("report/study/study.json").contains(directory.path())) << "no path of this machine";
    EXPECT_GT(QFileInfo(directory.filePath("report/report.pdf")).size(), 5000);
}

TEST_F(Report, IsProposedInADirectoryThatIsCalledByTheTitleOfItsHead) {
    openLambda();
    run(RunKind::Fit);
    ReportDialog* dialog = openDialog("report");
    QTest::keyClicks(dialog->titleField(), "Probe 7/2");
    QTest::mouseClick(dialog->writeButton(), Qt::LeftButton);
    auto* place = window.findChild<ReportFolderDialog*>();
    ASSERT_TRUE(place);
    EXPECT_EQ(place->findChild<QLineEdit*>("fileNameEdit")->text(), "Probe 7-2 report");
    document().undoStack().setClean();
}

TEST_F(Report, OfAnotherStudyIsNotReplacedByWhoOnlyConfirms) {
    QSettings().setValue("window/folder", directory.path());
    MainWindow again;
    again.resize(1440, 900);
    again.show();
    QStringList proposed;
    for (const char* study : {"one", "two"}) {
        again.document().open(lambdaFile(study));
        ASSERT_TRUE(
            QTest::qWaitFor([&] { return !again.document().isReading() && again.document().title() == study; }, 20000));
        ASSERT_TRUE(QTest::qWaitFor([&] { return again.document().before() != nullptr; }, 20000));
        for (int write = 0; write < 2; ++write) {
            again.controller().start(RunKind::Fit);
            ASSERT_TRUE(QTest::qWaitFor([&] { return !again.controller().isRunning(); }, 60000));
            QTest::qWait(50);
            again.findChild<QAction*>("report")->trigger();
            auto* head = again.findChild<ReportDialog*>();
            ASSERT_TRUE(head);
            head->titleField()->setText("the same");
            QTest::mouseClick(head->writeButton(), Qt::LeftButton);
            QPointer<ReportFolderDialog> place = again.findChild<ReportFolderDialog*>();
            ASSERT_TRUE(place);
            auto* name = place->findChild<QLineEdit*>("fileNameEdit");
            proposed << name->text();
            again.statusBar()->clearMessage();
            QTest::keyClick(name, Qt::Key_Return);
            ASSERT_TRUE(
                QTest::qWaitFor([&] { return again.statusBar()->currentMessage().contains("report.html"); }, 30000));
            ASSERT_TRUE(QTest::qWaitFor([&] { return place.isNull() && !again.findChild<ReportDialog*>(); }, 5000));
        }
        again.document().undoStack().setClean();
    }
    EXPECT_EQ(proposed, (QStringList{"the same report", "the same report", "the same report 2", "the same report 2"}))
        << "the one before of the same study is replaced, that of another is not";
    QSettings().remove("window/folder");
}

TEST_F(Report, GoesIntoADirectoryThatIsNamedAndNeedNotBeThere) {
    openLambda();
    run(RunKind::Fit);
    const auto askWhere = [&] {
        QTest::mouseClick(openDialog("report")->writeButton(), Qt::LeftButton);
        auto* place = window.findChild<ReportFolderDialog*>();
        EXPECT_TRUE(place);
        place->setDirectory(directory.path());
        return place;
    };
    const auto nameOf = [](QFileDialog* place) { return place->findChild<QLineEdit*>("fileNameEdit"); };
    const auto type = [&](QFileDialog* place, const QString& name) {
        nameOf(place)->selectAll();
        QTest::keyClicks(nameOf(place), name);
        QTest::keyClick(nameOf(place), Qt::Key_Return);
    };
    const auto isWritten = [&](const QString& name) {
        const QString report = directory.filePath(name + "/report.html");
        return QTest::qWaitFor([&] { return window.statusBar()->currentMessage().contains(name); }, 30000) &&
               QFileInfo::exists(report);
    };
    QPointer<ReportFolderDialog> place = askWhere();
    EXPECT_EQ(nameOf(place)->text(), "lambda report");
    type(place, "findings");
    EXPECT_TRUE(isWritten("findings"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return place.isNull(); }, 5000));

    window.statusBar()->clearMessage();
    type(askWhere(), "findings");
    EXPECT_TRUE(isWritten("findings")) << "anew, over the one before";

    ASSERT_TRUE(QDir(directory.path()).mkpath("full/of"));
    window.statusBar()->clearMessage();
    place = askWhere();
    type(place, "full");
    ASSERT_TRUE(place) << "it holds something else";
    EXPECT_EQ(place->directory().dirName(), "full");
    EXPECT_EQ(nameOf(place)->text(), "lambda report");
    QTest::keyClick(nameOf(place), Qt::Key_Return);
    EXPECT_TRUE(isWritten("full/lambda report"));
}

TEST_F(Report, LogoThatCannotBeReadIsToldInTheDialogAndTheReportIsWritten) {
    openLambda();
    run(RunKind::Fit);
    ReportDialog* dialog = openDialog("report");
    dialog->logoField()->setText("none.png");
    EXPECT_TRUE(dialog->faultLabel()->isVisible());
    EXPECT_TRUE(dialog->faultLabel()->text().contains("cannot be opened"))
        << dialog->faultLabel()->text().toStdString();
    QTest::mouseClick(dialog->keepButton(), Qt::LeftButton);
    window.writeReport(directory.filePath("report"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.statusBar()->currentMessage().contains("report.html"); }, 30000));
    EXPECT_FALSE(textOf("report/report.html").contains("<img"));
    const auto& said = document().messages();
    EXPECT_TRUE(std::any_of(said.begin(), said.end(),
                            [](const Message& m) { return m.diagnostic.place.file.ends_with("none.png"); }));
}

TEST_F(Report, LogoComesAlongWhenTheStudyIsSaved) {
    openLambda();
    ReportDialog* dialog = openDialog();
    dialog->logoField()->setText(putLogo("mark.png"));
    QTest::mouseClick(dialog->keepButton(), Qt::LeftButton);
    window.saveTo(directory.filePath("saved.analogon"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isModified(); }, 20000));
    ASSERT_TRUE(QFile::remove(directory.filePath("mark.png")));
    const Outcome<OpenedStudy> opened = openStudy(directory.filePath("saved.analogon").toStdString());
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_TRUE(opened.diagnostics().empty()) << format(opened.diagnostics());
    EXPECT_EQ(reportHeadOf(opened->study.extraJson).logo, "mark.png");
}

TEST_F(Report, OnPaperHasTheHeadAndTheSectionsThatWereChosen) {
    openLambda();
    run(RunKind::Fit);
    Finding finding = document().result()->finding;
    CandidateResult tried;
    tried.kind = "friction.coulomb";
    finding.candidates = {tried};
    const QImage picture(4, 4, QImage::Format_RGB32);
    ReportHead head;
    head.title = "Probe <7>";
    head.author = "E. Noether";
    const QString all = reportBody("study", RunKind::Discover, finding, {{picture}, picture}, head);
    EXPECT_TRUE(all.contains("<h1>Probe &lt;7&gt;</h1>"));
    EXPECT_TRUE(all.contains("E.&nbsp;Noether"));
    EXPECT_TRUE(all.contains(logoResource));
    EXPECT_TRUE(all.contains("picture:0"));
    head.leftOut = {ReportSection::Plots, ReportSection::Tried, ReportSection::Parameters};
    const QString less = reportBody("study", RunKind::Discover, finding, {{picture}}, head);
    EXPECT_FALSE(less.contains("picture:0"));
    EXPECT_FALSE(less.contains("What was tried"));
    EXPECT_FALSE(less.contains("<h2>Parameters"));
    EXPECT_LT(less.size(), all.size());
}

TEST_F(Report, OnPaperShowsTheModelBeforeAndAfterWithTheEffectOutlined) {
    openLambda();
    RunResult found = sampleFinding(document(), "thermal.loss", "Analogon.Effects.Thermal.Loss",
                                    "Heat loss to ambient, by convection", "element.solid", "port", "G");
    found.finding.baseline.modelText = document().modelText().toStdString();
    const std::optional<DiagramPair> diagrams = diagramsOf(found);
    ASSERT_TRUE(diagrams);
    ASSERT_EQ(diagrams->marks.size(), 1u);
    const QString block = QString::fromStdString(diagrams->marks.front().block);
    const QString body = reportBody("study", RunKind::Discover, found.finding, {{}, {}, diagrams});
    for (const QString& part : {QString("The model before and after"), block, QString("Heat loss to ambient")})
        EXPECT_TRUE(body.contains(part)) << part.toStdString();
    QTextDocument paper;
    addDiagrams(paper, *diagrams);
    const auto marked = [&](const char* name) {
        EXPECT_TRUE(body.contains(name)) << name;
        const auto picture = paper.resource(QTextDocument::ImageResource, QUrl(name)).value<QImage>();
        EXPECT_GT(picture.width(), 600) << name;
        picture.save(QStringLiteral(ANALOGON_PICTURES) + "/paper-" + QString(name).section(':', 1) + ".png");
        int pixels = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) pixels += picture.pixelColor(x, y) == QColor("#c2185b");
        return pixels;
    };
    EXPECT_EQ(marked("diagram:before"), 0);
    EXPECT_GT(marked("diagram:after"), 400) << "outline and name";
    ReportHead head;
    head.leftOut = {ReportSection::Diagram};
    EXPECT_FALSE(reportBody("study", RunKind::Discover, found.finding, {{}, {}, diagrams}, head).contains("diagram:"));
    const auto sizeOf = [&](const QString& name, const ReportPictures& pictures) {
        const QString file = QStringLiteral(ANALOGON_PICTURES) + "/report-" + name + ".pdf";
        EXPECT_EQ(writeReportPdf(file, "study", RunKind::Discover, found.finding, pictures), "");
        return QFileInfo(file).size();
    };
    EXPECT_GT(sizeOf("with-diagrams", {{}, {}, diagrams}), sizeOf("without-diagrams", {}) + 10000);
}

/// As a German user sees it, light and dark.
TEST(ReportPictures, HaveRoomForEveryWord) {
    for (const style::Theme theme : {style::Theme::Light, style::Theme::Dark}) {
        Translator german;
        if (german.loadLanguage("de")) QCoreApplication::installTranslator(&german);
        style::apply(*qApp, theme);
        MainWindow window;
        window.resize(1024, 700);
        window.show();
        window.startNew();
        ASSERT_TRUE(QTest::qWaitFor([&] { return window.document().isOpen(); }, 20000));
        window.findChild<QAction*>("report-head-action")->trigger();
        auto* dialog = window.findChild<ReportDialog*>();
        ASSERT_TRUE(dialog);
        dialog->titleField()->setText("Wasserpumpe im Kaltlauf");
        dialog->testObjectField()->setText("Muster B, Nr. 0815");
        dialog->authorField()->setText("E. Noether");
        dialog->dateField()->setText("29. November 2026");
        QTest::qWait(50);
        EXPECT_LE(dialog->height(), 700);
        for (QCheckBox* box : dialog->findChildren<QCheckBox*>())
            EXPECT_GE(box->width(), box->sizeHint().width()) << box->text().toStdString();
        dialog->grab().save(QStringLiteral(ANALOGON_PICTURES) + "/report-dialog-de" +
                            (theme == style::Theme::Dark ? "-dark" : "") + ".png");
        QCoreApplication::removeTranslator(&german);
    }
    style::apply(*qApp, style::Theme::Light);
}

}  // namespace

}  // namespace analogon::ui
