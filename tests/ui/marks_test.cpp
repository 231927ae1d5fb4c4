#include <QGraphicsSceneHoverEvent>

#include "tests/ui/panels_fixture.hpp"
#include "tests/ui/sample_finding.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/mark_item.hpp"

namespace analogon::ui {
namespace {

class Marks : public Panels {
protected:
    BlockItem* block(const std::string& name) const { return window.findChild<DiagramScene*>()->block(name); }
    std::vector<MarkItem*> marksOf(const std::string& name) const {
        std::vector<MarkItem*> found;
        for (QGraphicsItem* child : block(name)->childItems())
            if (auto* mark = qgraphicsitem_cast<MarkItem*>(child)) found.push_back(mark);
        return found;
    }
    void openAndKnow() {
        openLambda();
        ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().parameters.empty(); }, 20000));
    }
    void setFit(const std::string& name, bool isFitted) {
        StudyParameter setting = document().study().parameters.at(name);
        setting.fit = isFitted;
        document().setStudyParameter(name, setting, "fit");
    }
};

TEST_F(Marks, SayWhichParametersOfABlockAreToBeFittedAndFollowTheStudy) {
    openAndKnow();
    ASSERT_EQ(marksOf("heater").size(), 1u);
    EXPECT_EQ(marksOf("heater")[0]->kind(), MarkKind::Fitted);
    EXPECT_TRUE(marksOf("heater")[0]->toolTip().startsWith("To be fitted:"));
    EXPECT_TRUE(marksOf("heater")[0]->toolTip().contains("R = ")) << marksOf("heater")[0]->toolTip().toStdString();
    EXPECT_TRUE(marksOf("heater")[0]->toolTip().contains("Ohm"));
    for (const char* name : {"heater.R", "heater.alpha"}) setFit(name, false);
    EXPECT_TRUE(marksOf("heater").empty());
    document().undoStack().undo();
    EXPECT_EQ(marksOf("heater").size(), 1u);
}

TEST_F(Marks, TellWhatTheFitCameToAndWhatEndedAtABoundAndWhatAnEffectBrought) {
    openAndKnow();
    const RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                           "radiation", "element.solid", "port", "k_r");
    const std::string atBound = result.finding.final.parameters.back().name;  // as the sample has it
    const std::string bounded = atBound.substr(0, atBound.find('.'));
    document().setResult(RunKind::Discover, result, document().study());
    ASSERT_FALSE(marksOf(bounded).empty());
    EXPECT_EQ(marksOf(bounded)[0]->kind(), MarkKind::AtBound);
    EXPECT_TRUE(marksOf(bounded)[0]->toolTip().startsWith("At a bound after the fit:"));
    document().adoptCompleted("add");
    ASSERT_TRUE(QTest::qWaitFor([&] { return block(result.finding.effects[0].wired.instance) != nullptr; }, 5000));
    BlockItem* const effect = block(result.finding.effects[0].wired.instance);
    EXPECT_TRUE(effect->isMarked());
    EXPECT_TRUE(marksOf(result.finding.effects[0].wired.instance).empty()) << "its label says so already";
    QGraphicsSceneHoverEvent hover(QEvent::GraphicsSceneHoverMove);
    hover.setPos(effect->body().center());
    window.findChild<DiagramScene*>()->sendEvent(effect, &hover);
    EXPECT_TRUE(effect->toolTip().contains("Brought by the effect thermal.radiation")) << qPrintable(effect->toolTip());
}

/// At every zoom: the marks against names, labels, connectors and wires of the whole diagram.
TEST_F(Marks, CoverNoNameNoLabelAndNoConnectorAtAnyZoom) {
    openAndKnow();
    auto* scene = window.findChild<DiagramScene*>();
    auto* view = window.findChild<DiagramView*>();
    int seen = 0;
    for (const double zoom : {0.75, 1.0, 1.5, 2.0, 4.0}) {
        view->setTransform(QTransform::fromScale(zoom, zoom));
        for (const Block& from : scene->diagram().blocks)
            for (const MarkItem* mark : marksOf(from.name)) {
                const QRectF rect = MarkItem::rectAt(zoom).translated(mark->pos());
                ++seen;
                for (const Block& other : scene->diagram().blocks) {
                    BlockItem* item = block(other.name);
                    for (const QRectF& port : item->ports()) EXPECT_FALSE(rect.intersects(port)) << other.name;
                    const QRectF name = view->viewportTransform().inverted().mapRect(
                        item->nameRect(view->viewportTransform(), view->font()));
                    EXPECT_FALSE(rect.adjusted(0.2, 0.2, -0.2, -0.2).intersects(name)) << other.name << " at " << zoom;
                }
            }
    }
    EXPECT_GE(seen, 10);
}

TEST_F(Marks, AreSeenOnTheScreenAndSayWhatTheyMeanWhereOnePoints) {
    openAndKnow();
    auto* view = window.findChild<DiagramView*>();
    const MarkItem* mark = marksOf("heater")[0];
    const QPoint at = view->mapFromScene(mark->scenePos());
    QGraphicsItem* const top = view->itemAt(at);
    ASSERT_EQ(top, static_cast<const QGraphicsItem*>(mark));
    EXPECT_EQ(view->blockAt(at), block("heater")) << "a press on it means the block";
    const QImage with = view->viewport()->grab().toImage();
    setFit("heater.R", false);
    setFit("heater.alpha", false);
    QTest::qWait(50);
    EXPECT_NE(with.copy(QRect(at - QPoint(4, 4), QSize(9, 9))),
              view->viewport()->grab().toImage().copy(QRect(at - QPoint(4, 4), QSize(9, 9))));
}

}  // namespace
}  // namespace analogon::ui
