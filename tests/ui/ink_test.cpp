#include "ui/style/ink.hpp"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QMenuBar>
#include <QTreeWidget>
#include <map>

#include "tests/ui/panels_fixture.hpp"
#include "tests/ui/sample_finding.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/style/style.hpp"
#include "ui/window/start_page.hpp"

namespace analogon::ui {
namespace {

using style::Theme;

/// Whatever a test does, the next one begins in the light.
class Light {
public:
    ~Light() { style::apply(*qApp, Theme::Light); }
};

TEST(Ink, OfALabelAndOfItemsIsThatOfTheTheme) {
    const Light again;
    style::apply(*qApp, Theme::Light);
    QWidget panel;
    auto* label = new QLabel("told", &panel);
    auto* list = new QListWidget(&panel);
    auto* tree = new QTreeWidget(&panel);
    tree->setColumnCount(2);
    panel.show();
    auto* item = new QListWidgetItem("one", list);
    auto* row = new QTreeWidgetItem(new QTreeWidgetItem(tree, {"above"}), {"two", "three"});
    style::followTheme(*list);
    style::followTheme(*tree);
    style::tint(*label, style::fault);
    style::tint(*item, style::caution, list->palette());
    style::tint(*row, 1, style::mutedText, tree->palette());
    int edits = 0;
    QObject::connect(tree, &QTreeWidget::itemChanged, tree, [&] { ++edits; });
    const auto told = [&] { return label->palette().color(label->foregroundRole()); };
    const QColor inLight = told();
    EXPECT_EQ(inLight, style::fault(panel.palette()));
    style::apply(*qApp, Theme::Dark);
    QTest::qWait(20);
    EXPECT_EQ(told(), style::fault(panel.palette()));
    EXPECT_NE(told(), inLight);
    EXPECT_EQ(item->foreground().color(), style::caution(panel.palette()));
    EXPECT_EQ(row->foreground(1).color().rgb(), style::mutedText(tree->palette()).rgb());
    EXPECT_EQ(row->foreground(0).style(), Qt::NoBrush) << "the list's own";
    EXPECT_EQ(edits, 0) << "nothing was changed by anybody";
    style::tint(*label, nullptr);
    style::tint(*item, nullptr, list->palette());
    EXPECT_EQ(told(), panel.palette().color(label->foregroundRole()));
    EXPECT_EQ(item->foreground().style(), Qt::NoBrush);
}

/// The pictures of all that is seen of a study with a result.
std::map<std::string, QImage> picturesOf(MainWindow& window) {
    std::map<std::string, QImage> pictures;
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        if (dock->isHidden() || dock->objectName() == "runs") continue;  // which tell the time of day
        dock->raise();
        QTest::qWait(30);
        pictures[dock->objectName().toStdString()] = dock->grab().toImage();
    }
    pictures["centre"] = window.centralWidget()->grab().toImage();
    pictures["bar"] = window.menuBar()->grab().toImage();
    return pictures;
}

class Themes : public Panels {
protected:
    /// A study with a recording that is not mapped and not used.
    QString studyFile() {
        Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        EXPECT_TRUE(study);
        study->experiments.back().outputs.clear();
        study->experiments.back().isUsed = false;
        const QString file = directory.filePath("looked-at.analogon");
        EXPECT_TRUE(saveStudy(*study, file.toStdString()));
        return file;
    }
    /// The study with a result and messages.
    void fillWith(MainWindow& shown, const QString& file) {
        shown.resize(1440, 900);
        shown.show();
        shown.open(file);
        ASSERT_TRUE(QTest::qWaitFor([&] { return shown.document().isOpen() && shown.document().before(); }, 20000));
        Document& study = shown.document();
        study.setResult(RunKind::Discover,
                        sampleFinding(study, "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                      "Heat radiation", "element.solid", "port", "epsilon"),
                        study.study());
        study.setRunMessages({error(Text("what stands in the way")), warning(Text("what is doubtful"))});
        QTest::qWait(300);
    }
};

TEST_F(Themes, ASwitchLeavesNothingOfTheLookBefore) {
    const Light again;
    style::apply(*qApp, Theme::Light);
    MainWindow switched;
    const QString file = studyFile();
    fillWith(switched, file);
    style::apply(*qApp, Theme::Dark);
    QTest::qWait(300);
    const std::map<std::string, QImage> after = picturesOf(switched);
    MainWindow born;
    fillWith(born, file);
    const std::map<std::string, QImage> wanted = picturesOf(born);
    ASSERT_EQ(after.size(), wanted.size());
    const QDir place(QStringLiteral(ANALOGON_PICTURES));
    place.mkpath(".");
    for (const auto& [name, picture] : wanted) {
        EXPECT_EQ(after.at(name), picture) << name << ": the same study in a window that never was light";
        if (after.at(name) == picture) continue;
        after.at(name).save(place.filePath("theme-switched-" + QString::fromStdString(name) + ".png"));
        picture.save(place.filePath("theme-born-" + QString::fromStdString(name) + ".png"));
    }
    for (MainWindow* one : {&switched, &born}) one->document().undoStack().setClean();
}

TEST_F(Themes, TheFirstPageFollowsToo) {
    const Light again;
    style::apply(*qApp, Theme::Light);
    StartPage page(findExamples());
    page.resize(800, 700);
    page.show();
    page.showWork({lambdaFile("recent")}, {});
    page.showFault("what could not be opened");
    style::apply(*qApp, Theme::Dark);
    QTest::qWait(50);
    StartPage born(findExamples());
    born.resize(800, 700);
    born.show();
    born.showWork({lambdaFile("recent")}, {});
    born.showFault("what could not be opened");
    QTest::qWait(50);
    EXPECT_EQ(page.grab().toImage(), born.grab().toImage());
}

}  // namespace
}  // namespace analogon::ui
