
#include "tests/ui/panels_fixture.hpp"
#include "tests/working_time.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/wire_item.hpp"
#include "ui/document/composer.hpp"
#include "ui/route/bend.hpp"
#include "ui/route/route.hpp"
#include "ui/window/compose_actions.hpp"

namespace analogon {

void PrintTo(const Point& p, std::ostream* out) { *out << '(' << p.x << ' ' << p.y << ')'; }

}  // namespace analogon

namespace analogon::ui {
namespace {

using Way = std::vector<Point>;

TEST(Bend, MovesAPieceAtRightAnglesAndLeavesTheEnds) {
    const Way step{{0, 0}, {50, 0}, {50, 40}, {100, 40}};
    EXPECT_EQ(bent(step, 1, 20), (Way{{0, 0}, {70, 0}, {70, 40}, {100, 40}}));
    EXPECT_EQ(bent(step, 0, -20), (Way{{0, 0}, {10, 0}, {10, -20}, {50, -20}, {50, 40}, {100, 40}}));
    EXPECT_EQ(bent(step, 2, 10), (Way{{0, 0}, {50, 0}, {50, 50}, {90, 50}, {90, 40}, {100, 40}}));
    const Way straight{{0, 0}, {100, 0}};
    EXPECT_EQ(bent(straight, 0, 30), (Way{{0, 0}, {10, 0}, {10, 30}, {90, 30}, {90, 0}, {100, 0}}));
    EXPECT_EQ(bent(step, 1, 0), step);
    const Way aslant{{0, 0}, {30, 40}};
    EXPECT_EQ(bent(aslant, 0, 10), aslant) << "has no right angle";
}

TEST(Bend, FindsTheNearestPiece) {
    const Way step{{0, 0}, {50, 0}, {50, 40}};
    EXPECT_EQ(pieceAt(step, {20, 3}, 5), 0u);
    EXPECT_EQ(pieceAt(step, {48, 20}, 5), 1u);
    EXPECT_FALSE(pieceAt(step, {20, 20}, 5));
}

TEST(Bend, FollowsItsEndsWhileItDoesNotTurnBack) {
    const Way step{{0, 0}, {50, 0}, {50, 40}, {100, 40}};
    EXPECT_EQ(stretched(step, {0, 10}, {100, 40}), (Way{{0, 10}, {50, 10}, {50, 40}, {100, 40}}));
    EXPECT_EQ(stretched(step, {0, 0}, {120, 70}), (Way{{0, 0}, {50, 0}, {50, 70}, {120, 70}}));
    EXPECT_TRUE(stretched(step, {60, 0}, {100, 40}).empty()) << "it would leave backwards";
    EXPECT_TRUE(stretched({{0, 0}, {100, 0}}, {0, 10}, {100, 0}).empty()) << "it has no corner";
}

Diagram twoBlocks(Point second) {
    Diagram diagram;
    for (const Point at : {Point{0, 0}, second}) {
        Block block;
        block.name = at == second ? "b" : "a";
        block.placement.extent = {{at.x - 10, at.y - 10}, {at.x + 10, at.y + 10}};
        for (const double side : {-100.0, 100.0}) {
            Port port;
            port.name = side < 0 ? "p" : "n";
            port.placement.extent = {{side - 10, -10}, {side + 10, 10}};
            block.ports.push_back(port);
        }
        diagram.blocks.push_back(block);
    }
    return diagram;
}

TEST(Bend, KeepsAWayThatWasLedByHandAndNoOther) {
    const Diagram before = twoBlocks({100, 0}), after = twoBlocks({110, -20});
    Wire wire;
    wire.from = "a.n";
    wire.to = "b.p";
    wire.points = routeWire(before, "a.n", "b.p");
    ASSERT_EQ(wire.points, (Way{{10, 0}, {90, 0}}));
    EXPECT_FALSE(isLedByHand(before, wire));
    EXPECT_TRUE(keptWay(wire, before, after).empty());
    wire.points = {{10, 0}, {30, 0}, {30, 50}, {70, 50}, {70, 0}, {90, 0}};
    EXPECT_TRUE(isLedByHand(before, wire));
    EXPECT_EQ(keptWay(wire, before, after), (Way{{10, 0}, {30, 0}, {30, 50}, {70, 50}, {70, -20}, {100, -20}}));
    Diagram crowded = after;
    crowded.blocks.push_back(crowded.blocks.front());
    crowded.blocks.back().name = "c";
    crowded.blocks.back().placement.extent = {{60, -15}, {80, 5}};
    EXPECT_TRUE(keptWay(wire, before, crowded).empty()) << "it would cross a block";
}

/// The shown way of the only wire of a scene, in the diagram's coordinates.
Way shownWay(const DiagramScene& scene) {
    Way way;
    for (const QLineF& line : scene.wires().front()->lines()) {
        if (way.empty()) way.push_back({line.x1(), -line.y1()});
        way.push_back({line.x2(), -line.y2()});
    }
    return way;
}

TEST(DraggedWire, AvoidsBlocksAsItWillWhenTheBlockIsDropped) {
    Diagram diagram = twoBlocks({100, 60});
    diagram.blocks.push_back(diagram.blocks.front());
    diagram.blocks.back().name = "c";
    diagram.blocks.back().placement.extent = {{40, -10}, {60, 10}};
    Wire wire;
    wire.from = "a.n";
    wire.to = "b.p";
    wire.points = routeWire(diagram, "a.n", "b.p");
    diagram.wires = {wire};
    DiagramScene scene;
    scene.show(diagram);
    const Way before = shownWay(scene);
    scene.select("b");
    for (const double dy : {-20.0, -40.0, -60.0}) {
        scene.showMoved(0, dy);
        const Way way = shownWay(scene);
        EXPECT_EQ(way, Composer::moved(diagram, {"b"}, 0, dy).wires.front().points) << dy;
        for (std::size_t i = 1; i < way.size(); ++i)
            EXPECT_FALSE(std::min(way[i - 1].x, way[i].x) < 59 && std::max(way[i - 1].x, way[i].x) > 41 &&
                         std::min(way[i - 1].y, way[i].y) < 9 && std::max(way[i - 1].y, way[i].y) > -9)
                << "through the block between them, " << dy;
    }
    scene.showMoved(0, 0);
    EXPECT_EQ(shownWay(scene), before);
}

TEST(DraggedWire, OfALargeDiagramFollowsThePointer) {
    Diagram diagram = twoBlocks({0, -100});
    const Block block = diagram.blocks.front();
    for (int i = 0; i < 200; ++i) {
        diagram.blocks.push_back(block);
        diagram.blocks.back().name = "x" + std::to_string(i);
        const double x = 40.0 * (i % 20), y = 40.0 * (1 + i / 20);
        diagram.blocks.back().placement.extent = {{x - 10, y - 10}, {x + 10, y + 10}};
        Wire wire;
        wire.from = i == 0 ? "a.n" : "x" + std::to_string(i - 1) + ".n";
        wire.to = "x" + std::to_string(i) + ".p";
        wire.points = {{x - 30, y}, {x - 10, y}};
        if (i < 190) diagram.wires.push_back(wire);
    }
    DiagramScene scene;
    scene.show(diagram);
    scene.setSelection({{"x5", "x25", "x45", "x65", "x85"}, {}});
    scene.showMoved(10, 0);
    int step = 1;
    const double move = test::leastMilliseconds(20, [&] { scene.showMoved(10.0 * ++step, 10); });
    EXPECT_LT(move, 50) << "[ms]; ten wires among 200 blocks, without optimisation in the build of a test";
}

/// A wire of a study that is open, dragged with the mouse.
class Wires : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        openLambda();
        view().fitView();
        QTest::qWait(50);
    }
    void TearDown() override { document().undoStack().setClean(); }
    DiagramView& view() const { return *window.findChild<DiagramView*>(); }
    Way wayOf(const std::string& from, const std::string& to) {
        for (const Wire& wire : document().diagram().wires)
            if (wire.from == from && wire.to == to) return simplified(wire.points);
        return {};
    }
    QPoint pixelOf(Point p) const { return view().mapFromScene(QPointF(p.x, -p.y)); }
    void drag(Point from, Point to) {
        QWidget* ground = view().viewport();
        QTest::mousePress(ground, Qt::LeftButton, {}, pixelOf(from));
        for (int i = 1; i <= 4; ++i)
            QTest::mouseMove(ground, pixelOf({from.x + (to.x - from.x) * i / 4, from.y + (to.y - from.y) * i / 4}));
        QTest::mouseRelease(ground, Qt::LeftButton, {}, pixelOf(to));
        QTest::qWait(20);
    }
};

TEST_F(Wires, APieceIsDraggedAsOneStepAndIsKeptWhenABlockMoves) {
    const Way before = wayOf("heater.i", "i_mod");
    ASSERT_TRUE(isOrthogonal(before));
    const QString text = document().modelText();
    // the longest piece, taken at its middle
    std::size_t piece = 0;
    const auto length = [&](std::size_t i) {
        return std::abs(before[i + 1].x - before[i].x) + std::abs(before[i + 1].y - before[i].y);
    };
    for (std::size_t i = 0; i + 1 < before.size(); ++i)
        if (length(i) > length(piece)) piece = i;
    const Point middle{(before[piece].x + before[piece + 1].x) / 2, (before[piece].y + before[piece + 1].y) / 2};
    const bool isLevel = before[piece].y == before[piece + 1].y;
    const Point to = isLevel ? Point{middle.x + 7, middle.y + 40} : Point{middle.x + 40, middle.y + 7};
    const int steps = document().undoStack().index();
    drag(middle, to);
    const Way led = wayOf("heater.i", "i_mod");
    EXPECT_EQ(document().undoStack().index(), steps + 1);
    EXPECT_EQ(led, bent(before, piece, 40));
    EXPECT_NE(document().modelText(), text) << "it stands in the text";

    ASSERT_TRUE(window.compose().composer().move({"i_mod"}, 10, -20));
    const Way moved = wayOf("heater.i", "i_mod");
    EXPECT_EQ(moved, stretched(led, led.front(), {led.back().x + 10, led.back().y - 20}));
    ASSERT_FALSE(moved.empty());
    document().undoStack().undo();
    EXPECT_EQ(wayOf("heater.i", "i_mod"), led);
    document().undoStack().undo();
    EXPECT_EQ(document().modelText(), text);
}

TEST_F(Wires, AClickSelectsAndChangesNothing) {
    const Way way = wayOf("heater.i", "i_mod");
    ASSERT_GE(way.size(), 2u);
    const int steps = document().undoStack().index();
    const Point middle{(way[0].x + way[1].x) / 2, (way[0].y + way[1].y) / 2};
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, pixelOf(middle));
    EXPECT_EQ(document().undoStack().index(), steps);
    ASSERT_EQ(view().scene()->selection().wires.size(), 1u);
    EXPECT_EQ(view().scene()->selection().wires.front().to, "i_mod");
}

}  // namespace
}  // namespace analogon::ui
