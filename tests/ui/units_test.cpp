#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QTreeWidget>

#include "tests/ui/panels_fixture.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/library/chooser.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/window/compose_actions.hpp"
#include "ui/words/common_units.hpp"

namespace analogon::ui {
namespace {

TEST(CommonUnits, AreThoseThatMeasureTheSameWithTheOwnFirst) {
    const QStringList speeds = unitsLike("rad/s");
    EXPECT_EQ(speeds.front(), "rad/s");
    EXPECT_TRUE(speeds.contains("rpm"));
    EXPECT_FALSE(speeds.contains("V"));
    EXPECT_TRUE(unitsLike("").contains("V"));
    EXPECT_TRUE(whyNoUnit("N.m").isEmpty());
    EXPECT_TRUE(whyNoUnit("kpa").contains("kPa")) << whyNoUnit("kpa").toStdString();
}

class Units : public Panels {
protected:
    static constexpr int unitColumn = 3;
    QTreeWidget* tree() const { return window.findChild<MeasurementPanel*>()->tree(); }
    QTreeWidgetItem* row(const QString& experiment, const QString& signal) const {
        return window.findChild<MeasurementPanel*>()->signalItem(experiment, signal);
    }
    const ChannelMapping& output() { return document().study().experiments[0].outputs.at("i_mod"); }
    const ChannelMapping& input() { return document().study().experiments[0].inputs.at("T_amb"); }
    /// By the menu of the row, typed into its cell.
    void typeUnit(QTreeWidgetItem* item, const QString& unit) {
        tree()->scrollToItem(item);
        const QPoint at = tree()->visualItemRect(item).center();
        Q_EMIT tree()->customContextMenuRequested(at);
        QAction* wanted{};
        for (QMenu* menu : window.findChildren<QMenu*>())
            for (QAction* action : menu->actions())
                if (menu->isVisible() && action->text() == "Set the unit …") wanted = action;
        ASSERT_TRUE(wanted);
        if (tree()->isColumnHidden(unitColumn)) wanted->trigger();
        static_cast<QMenu*>(wanted->parent())->close();
        QTest::qWait(20);  // what the trigger opened has lost the focus to the closing menu
        ASSERT_FALSE(tree()->isColumnHidden(unitColumn));
        const QModelIndex cell = tree()->indexAt(at).siblingAtColumn(unitColumn);
        tree()->setCurrentIndex(cell);
        tree()->edit(cell);
        auto* const box = qobject_cast<QComboBox*>(tree()->indexWidget(cell) ? tree()->indexWidget(cell)
                                                                             : tree()->findChild<QComboBox*>());
        ASSERT_TRUE(box);
        box->lineEdit()->selectAll();
        QTest::keyClicks(box, unit);  // its field hands the focus to it
        QTest::keyClick(box, Qt::Key_Return);
        QTest::qWait(20);
    }
};

TEST_F(Units, OfAColumnAreToldInItsRowUndoneAndKeptInTheStudy) {
    openLambda();
    const QString experiment = QString::fromStdString(document().study().experiments[0].name);
    EXPECT_TRUE(tree()->isColumnHidden(unitColumn)) << "no unit is told yet";
    const double before = document().before()->experiments[0].errorPercent;
    const double measured = document().before()->experiments[0].outputs[0].measured[5];
    typeUnit(row(experiment, "i_mod"), "A");  // its file says mA
    EXPECT_EQ(output().unit, "A");
    EXPECT_FALSE(tree()->isColumnHidden(unitColumn));
    EXPECT_EQ(row(experiment, "i_mod")->text(unitColumn), "A");
    EXPECT_NE(studyJson(document().study()).find("\"unit\": \"A\""), std::string::npos);
    EXPECT_TRUE(QTest::qWaitFor(
        [&] {
            return document().before() && document().before()->experiments[0].errorPercent != before &&
                   std::abs(document().before()->experiments[0].outputs[0].measured[5] - 1000 * measured) < 1e-6;
        },
        20000))
        << "the column is converted from it";
    document().undoStack().undo();
    EXPECT_TRUE(output().unit.empty());
    EXPECT_TRUE(tree()->isColumnHidden(unitColumn));
}

TEST_F(Units, ThatAreNotKnownOrMeasureSomethingElseChangeNothing) {
    openLambda();
    const QString experiment = QString::fromStdString(document().study().experiments[0].name);
    const int steps = document().undoStack().count();
    typeUnit(row(experiment, "i_mod"), "V");
    typeUnit(row(experiment, "i_mod"), "blorp");
    typeUnit(row(experiment, "i_mod"), "mA");  // as the file says
    EXPECT_EQ(document().undoStack().count(), steps);
    EXPECT_TRUE(output().unit.empty());
}

TEST_F(Units, OfAnInputAreSetInTheDiagramByAKey) {
    openLambda();
    auto* view = window.findChild<DiagramView*>();
    auto* scene = window.findChild<DiagramScene*>();
    const auto press = [&](const char* typed) {
        view->setFocus();
        QTest::keyClick(view, Qt::Key_U);
        QLineEdit* const field = window.compose().chooser()->field();
        if (!field->isVisible()) return false;
        field->selectAll();
        QTest::keyClicks(field, typed);
        QTest::keyClick(field, Qt::Key_Return);
        return true;
    };
    scene->select("T_amb");
    ASSERT_TRUE(press("degC"));
    EXPECT_TRUE(document().modelText().contains("T_amb(unit=\"degC\")")) << qPrintable(document().modelText());
    const auto unitOfInput = [&] { return unitOf(document().facts().inputs, "T_amb"); };
    EXPECT_TRUE(QTest::qWaitFor([&] { return unitOfInput() == "degC"; }, 5000));
    document().undoStack().undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return unitOfInput() == "K"; }, 5000));
    ASSERT_TRUE(press("blorp"));
    EXPECT_TRUE(document().modelText().contains("T_amb(unit=\"K\")"));
    scene->select("heater");
    view->setFocus();
    QTest::keyClick(view, Qt::Key_U);
    Chooser* const chooser = window.compose().chooser();
    EXPECT_TRUE(!chooser->isVisible() || chooser->list()->isVisible()) << "a block has no unit: none is asked for";
}

}  // namespace
}  // namespace analogon::ui
