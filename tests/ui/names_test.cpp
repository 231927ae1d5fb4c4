#include "tests/ui/panels_fixture.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"

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

/// To look for their places takes a while where there are many; a repaint follows every movement of the mouse.
TEST_F(Names, AreNotSoughtPlacesForInARepaint) {
    drawRow();
    const QRect placed = view().nameRect("capacityOfWall0");
    scene().block("capacityOfWall0")->setLinesAway(7);
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
