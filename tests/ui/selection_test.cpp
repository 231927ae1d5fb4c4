#include <gtest/gtest.h>

#include <QtTest/QTest>

#include "tests/ui/panels_fixture.hpp"
#include "ui/canvas/block_item.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"

namespace analogon::ui {
namespace {

/// A value that is still being typed is taken over when another block is chosen, and the diagram is drawn anew: the
/// items that the click was on are gone by then.
TEST(Selection, MayHaveTheDiagramDrawnAnewByWhoHearsOfIt) {
    MainWindow window;
    window.resize(1280, 800);
    window.show();
    window.open(QStringLiteral(ANALOGON_ROOT "/examples/water-pump"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.document().isOpen() && window.document().before(); }, 20000));
    auto* view = window.findChild<DiagramView*>();
    DiagramScene* scene = view->scene();
    const Diagram diagram = scene->diagram();
    std::vector<std::string> filled;  // takes the memory of the items that are gone, so that none is used unseen
    int redrawn = 0;
    QObject::connect(scene, &DiagramScene::blockSelected, &window, [&] {
        scene->show(Diagram());
        for (std::size_t size = 16; size < 1200; size += 16)
            filled.insert(filled.end(), 30, std::string(size - 1, 'x'));
        scene->show(diagram);
        ++redrawn;
    });
    std::vector<std::string> names;
    for (const Block& b : scene->diagram().blocks)
        if (!b.isConnector) names.push_back(b.name);
    ASSERT_GE(names.size(), 2u);
    const auto click = [&](const std::string& name, Qt::KeyboardModifiers keys = {}) {
        QTest::mouseClick(view->viewport(), Qt::LeftButton, keys,
                          view->mapFromScene(scene->block(name)->body().center()));
    };
    for (int round = 0; round < 5; ++round)
        for (const Qt::KeyboardModifiers keys : {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ControlModifier)})
            for (const std::string& name : {names[0], names[1]}) click(name, keys);
    EXPECT_GE(redrawn, 10);
}

}  // namespace
}  // namespace analogon::ui
