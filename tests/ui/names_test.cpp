#include "tests/ui/panels_fixture.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/wire_item.hpp"

/// Where the names of the blocks stand in the diagram.
namespace analogon::ui {
namespace {

class Names : public Panels {
protected:
    DiagramView& view() const { return *window.findChild<DiagramView*>(); }
    DiagramScene& scene() const { return *window.findChild<DiagramScene*>(); }
    /// Blocks in a row, as near to one another as the grid allows, with names that are wider than they.
    void drawRow() {
        window.startNew();
        ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen(); }, 20000));
        std::string text = "model Model\n";
        for (int i = 0; i < 5; ++i)
            text += "  Analogon.Thermal.HeatCapacitor capacityOfWall" + std::to_string(i) +
                    " annotation (Placement(transformation(extent={{" + std::to_string(30 * i - 70) + ",0},{" +
                    std::to_string(30 * i - 50) + ",20}})));\n";
        document().typeText(QString::fromStdString(text + "end Model;\n"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return scene().block("capacityOfWall4") != nullptr; }, 20000));
        QTest::qWait(50);
    }
    void expectApart(const char* when) const {
        const std::vector<Block>& blocks = scene().diagram().blocks;
        for (std::size_t i = 0; i < blocks.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_FALSE(
                    view().nameRect(blocks[i].name).adjusted(-4, 0, 4, 0).intersects(view().nameRect(blocks[j].name)))
                    << when << ", at " << view().zoom() << ": " << blocks[i].name << " over " << blocks[j].name;
    }
};

TEST_F(Names, AreApartAtEveryZoomAndAfterEveryChange) {
    drawRow();
    const QRect one = view().nameRect("capacityOfWall0");
    ASSERT_GT(one.width() + 8, 30 * view().zoom()) << "else there is nothing to keep apart";
    expectApart("as it is drawn");
    view().setFocus();
    for (const Qt::Key key : {Qt::Key_Minus, Qt::Key_Minus, Qt::Key_Plus, Qt::Key_Plus, Qt::Key_Plus, Qt::Key_Plus}) {
        QTest::keyClick(&view(), key);
        if (view().zoom() < BlockItem::leastZoomWithNames) continue;
        if (one.width() < 2.5 * 30 * view().zoom()) expectApart("zoomed");
    }
    QTest::keyClick(&view(), Qt::Key_Space);
    scene().select("capacityOfWall3");
    QTest::keyClick(&view(), Qt::Key_Right, Qt::ShiftModifier);
    QTest::qWait(50);
    expectApart("a block was moved");
    QFont larger = view().font();
    larger.setPointSizeF(larger.pointSizeF() * 1.3);
    view().setFont(larger);
    expectApart("the font is larger");
}

/// In a small window the output of the example and what stands beside it have names that touch: the name of the one
/// was led past the wire and stood at the triangle of the other.
TEST_F(Names, StayAtTheirBlocksInASmallWindow) {
    openLambda();
    window.resize(853, 480);
    QTest::qWait(100);
    expectApart("a small window");
    const int line = QFontMetrics(view().font()).height();
    for (const Block& block : scene().diagram().blocks) {
        const QRect name = view().nameRect(block.name);
        const QRect body = view().mapFromScene(scene().block(block.name)->body()).boundingRect();
        EXPECT_TRUE(name.intersects(body.adjusted(-line, -line, line, line))) << block.name;
        for (const WireItem* wire : scene().wires())
            for (std::size_t i = 1; i < wire->wire().points.size(); ++i) {
                const Point a = wire->wire().points[i - 1], b = wire->wire().points[i];
                EXPECT_FALSE(
                    name.adjusted(1, 1, -1, -1)
                        .intersects(QRect(view().mapFromScene(a.x, -a.y), view().mapFromScene(b.x, -b.y)).normalized()))
                    << block.name << " over the wire from " << wire->wire().from;
            }
    }
}

TEST_F(Names, GiveWayToTheLabelOfAnEffect) {
    drawRow();
    scene().mark({{"capacityOfWall2", "heat capacity of the wall"}});
    const QRectF label = scene().block("capacityOfWall2")->effectRect(view().viewportTransform());
    ASSERT_FALSE(label.isEmpty());
    for (const char* name : {"capacityOfWall1", "capacityOfWall3"})
        EXPECT_FALSE(label.intersects(view().nameRect(name))) << name;
    scene().mark({});
    expectApart("the effect is gone");
}

/// The label of an effect is below its block, and above it where it would cover another one or a wire.
TEST_F(Names, LabelsOfEffectsCoverNoBlock) {
    window.startNew();
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen(); }, 20000));
    const auto block = [](const char* name, const char* extent) {
        return std::string("  Analogon.Thermal.HeatCapacitor ") + name +
               " annotation (Placement(transformation(extent={" + extent + "})));\n";
    };
    document().typeText(QString::fromStdString("model Model\n" + block("upper", "{-10,40},{10,60}") +
                                               block("lower", "{-10,10},{10,30}") + "end Model;\n"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return scene().block("lower") != nullptr; }, 20000));
    QTest::qWait(50);
    for (const auto& [marked, other] : {std::pair("upper", "lower"), std::pair("lower", "upper")}) {
        scene().mark({{marked, "radiation"}});
        const QTransform toView = view().viewportTransform();
        const QRectF label = scene().block(marked)->effectRect(toView);
        ASSERT_FALSE(label.isEmpty());
        EXPECT_FALSE(label.intersects(toView.mapRect(scene().block(other)->body()))) << marked;
        EXPECT_EQ(label.top() > toView.mapRect(scene().block(marked)->body()).top(), marked == std::string("lower"));
    }
}

/// To look for their places takes a while where there are many; a repaint follows every movement of the mouse.
TEST_F(Names, AreNotSoughtPlacesForInARepaint) {
    drawRow();
    const QRect placed = view().nameRect("capacityOfWall0");
    scene().block("capacityOfWall0")->setLabelPlace({true, 0, 7});
    const QRect put = view().nameRect("capacityOfWall0");
    ASSERT_NE(put, placed);
    view().viewport()->repaint();
    view().grab();
    EXPECT_EQ(view().nameRect("capacityOfWall0"), put);
    QTest::keyClick(&view(), Qt::Key_Plus);
    QTest::keyClick(&view(), Qt::Key_Space);
    EXPECT_EQ(view().nameRect("capacityOfWall0"), placed) << "another zoom: other places";
}

}  // namespace
}  // namespace analogon::ui
