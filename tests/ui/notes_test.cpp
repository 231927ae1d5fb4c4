#include <QAction>
#include <QBuffer>
#include <QDateTime>
#include <QFile>
#include <QFileDialog>
#include <QImage>
#include <QLineEdit>
#include <QPainter>
#include <QSettings>

#include "core/diagram/graphics_edit.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "ui/canvas/diagram_scene.hpp"
#include "ui/canvas/diagram_view.hpp"
#include "ui/canvas/icon_painter.hpp"
#include "ui/canvas/note_item.hpp"
#include "ui/document/kept_picture.hpp"
#include "ui/library/chooser.hpp"
#include "ui/style/style.hpp"
#include "ui/window/compose_actions.hpp"

namespace analogon::ui {
namespace {

QByteArray pngOf(const QColor& colour, QSize size = {40, 20}) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(colour);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "png");
    return bytes;
}

/// How many pixels of a picture come close to a colour.
int pixelsOf(const QImage& picture, const QColor& colour) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor at = picture.pixelColor(x, y);
            count += std::abs(at.red() - colour.red()) + std::abs(at.green() - colour.green()) +
                         std::abs(at.blue() - colour.blue()) <
                     40;
        }
    return count;
}

QImage drawn(const Primitive& primitive) {
    QImage picture(200, 200, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    QTransform place;
    place.translate(100, 100);
    place.scale(1, -1);
    paintPrimitives(
        painter, {primitive}, place, [](const QString& name) { return name; }, QPalette());
    return picture;
}

TEST(PictureInADiagram, IsDrawnFromItsBytesAndFromItsFileWithItsProportions) {
    Primitive p;
    p.kind = Primitive::Kind::Bitmap;
    p.extent = {{-50, -50}, {50, 50}};
    p.text = "data:" + pngOf(QColor(200, 20, 20)).toBase64().toStdString();
    EXPECT_NEAR(pixelsOf(drawn(p), QColor(200, 20, 20)), 100 * 50, 200) << "twice as wide as high";
    QTemporaryDir directory;
    QFile file(directory.filePath("photo.png"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(pngOf(QColor(20, 20, 200)));
    file.close();
    p.text = file.fileName().toStdString();
    EXPECT_NEAR(pixelsOf(drawn(p), QColor(20, 20, 200)), 100 * 50, 200);
    p.text = "/nowhere/photo.png";
    EXPECT_NE(drawn(p), drawn({})) << "a frame tells where it would be";
    p.text = "data:this is no picture";
    EXPECT_EQ(pixelsOf(drawn(p), QColor(20, 20, 200)), 0);
}

TEST(PictureInADiagram, ThatCannotBeReadIsTriedAnewOnceItsFileHasChanged) {
    QTemporaryDir directory;
    const QString name = directory.filePath("photo.png");
    const QByteArray blue = pngOf(QColor(20, 20, 200));
    const QDateTime first(QDate(2026, 1, 2), QTime(3, 4, 5));
    const auto write = [&](const QByteArray& bytes, const QDateTime& changed) {
        QFile file(name);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.flush();
        ASSERT_TRUE(file.setFileTime(changed, QFileDevice::FileModificationTime));
    };
    Primitive p;
    p.kind = Primitive::Kind::Bitmap;
    p.extent = {{-50, -50}, {50, 50}};
    p.text = name.toStdString();
    write(QByteArray(blue.size(), 'x'), first);
    EXPECT_EQ(pixelsOf(drawn(p), QColor(20, 20, 200)), 0);
    write(blue, first);  // looks like the same file: it is not read with every repaint
    EXPECT_EQ(pixelsOf(drawn(p), QColor(20, 20, 200)), 0);
    write(blue, first.addSecs(1));
    EXPECT_NEAR(pixelsOf(drawn(p), QColor(20, 20, 200)), 100 * 50, 200);
    write(pngOf(QColor(200, 20, 20)), first.addSecs(2));
    EXPECT_NEAR(pixelsOf(drawn(p), QColor(200, 20, 20)), 100 * 50, 200) << "and so is one that could be read";
}

TEST(KeptPicture, IsMadeSmallEnoughForATextAndRefusedWithAReason) {
    QTemporaryDir directory;
    const QString file = directory.filePath("large.png");
    QImage noise(3000, 2000, QImage::Format_RGB32);
    unsigned state = 1;
    for (int y = 0; y < noise.height(); ++y)
        for (int x = 0; x < noise.width(); ++x) noise.setPixel(x, y, (state = state * 1664525u + 1013904223u) >> 8);
    ASSERT_TRUE(noise.save(file));
    const Outcome<KeptPicture> kept = keptPicture(file);
    ASSERT_TRUE(kept) << format(kept.diagnostics());
    EXPECT_EQ(kept->size, QSizeF(1200, 800));
    EXPECT_LT(kept->bytes.size(), 1'500'000);
    QFile text(directory.filePath("no.png"));
    ASSERT_TRUE(text.open(QIODevice::WriteOnly));
    text.write("words");
    text.close();
    const Outcome<KeptPicture> none = keptPicture(text.fileName());
    ASSERT_FALSE(none);
    EXPECT_EQ(none.diagnostics().front().message.english(),
              "'no.png' cannot be read as a picture: PNG, JPEG and SVG can");
}

class Notes : public Panels {
protected:
    DiagramScene& scene() { return *panel<DiagramScene>(); }
    DiagramView& view() { return *panel<DiagramView>(); }
    Chooser& chooser() { return *view().findChild<Chooser*>(); }
    QPoint centreOf(const NoteItem& note) { return view().mapFromScene(note.sceneBoundingRect().center()); }
    std::string text() { return document().modelText().toStdString(); }
    void type(const QString& words) {
        auto* field = chooser().findChild<QLineEdit*>();
        ASSERT_TRUE(field && field->isVisible());
        field->selectAll();
        QTest::keyClicks(field, words);
        QTest::keyClick(field, Qt::Key_Return);
        QTest::qWait(20);
    }
    void addText(const QString& words) {
        view().setFocus();
        QTest::keyClick(&view(), Qt::Key_T, Qt::ShiftModifier);
        type(words);
    }
};

TEST_F(Notes, ATextIsWrittenByKeysMovedChangedRemovedAndUndone) {
    openLambda();
    const std::string plain = text();
    addText("Bench 7, new brushes");
    ASSERT_EQ(scene().notes().size(), 1u) << text();
    EXPECT_NE(text().find("textString=\"Bench 7, new brushes\""), std::string::npos);
    EXPECT_TRUE(
        view().mapToScene(view().viewport()->rect()).boundingRect().contains(scene().notes()[0]->sceneBoundingRect()))
        << "it is seen";
    for (const Block& block : document().diagram().blocks)
        EXPECT_FALSE(view()
                         .nameRect(block.name)
                         .intersects(view().mapFromScene(scene().notes()[0]->sceneBoundingRect()).boundingRect()))
            << "it covers no name";

    const QRectF before = scene().notes()[0]->sceneBoundingRect();
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, centreOf(*scene().notes()[0]));
    ASSERT_TRUE(scene().selectedNote());
    EXPECT_TRUE(scene().selection().isEmpty());
    QTest::keyClick(&view(), Qt::Key_Right);
    QTest::keyClick(&view(), Qt::Key_Up);
    ASSERT_TRUE(scene().selectedNote()) << "it stays chosen";
    EXPECT_EQ(scene().notes()[0]->sceneBoundingRect().topLeft(), before.topLeft() + QPointF(10, -10));

    const QPoint from = centreOf(*scene().notes()[0]);
    const QPoint to = from + QPoint(qRound(30 * view().zoom()), 0);
    QTest::mousePress(view().viewport(), Qt::LeftButton, {}, from);
    QTest::mouseMove(view().viewport(), (from + to) / 2);
    QTest::mouseMove(view().viewport(), to);
    QTest::mouseRelease(view().viewport(), Qt::LeftButton, {}, to);
    EXPECT_EQ(scene().notes()[0]->sceneBoundingRect().left(), before.left() + 40);

    const double wide = scene().notes()[0]->sceneBoundingRect().width();
    QTest::keyClick(&view(), Qt::Key_F2);
    type("Bench 8");
    ASSERT_EQ(scene().notes().size(), 1u);
    EXPECT_EQ(scene().notes()[0]->primitive().text, "Bench 8");
    EXPECT_LT(scene().notes()[0]->sceneBoundingRect().width(), wide);
    QTest::mouseDClick(view().viewport(), Qt::LeftButton, {}, centreOf(*scene().notes()[0]));
    type("Bench 9");
    EXPECT_EQ(scene().notes()[0]->primitive().text, "Bench 9");

    QTest::keyClick(&view(), Qt::Key_Delete);
    EXPECT_TRUE(scene().notes().empty());
    for (int i = 0; i < 7 && document().undoStack().canUndo(); ++i) document().undoStack().undo();
    EXPECT_EQ(text(), plain) << "each was one step";
}

TEST_F(Notes, ABlockIsChosenInPlaceOfATextAndTheOtherWayRound) {
    openLambda();
    addText("a text");
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, centreOf(*scene().notes()[0]));
    ASSERT_TRUE(scene().selectedNote());
    scene().select("heater");
    EXPECT_FALSE(scene().selectedNote());
    QTest::mouseClick(view().viewport(), Qt::LeftButton, {}, centreOf(*scene().notes()[0]));
    EXPECT_TRUE(scene().selection().isEmpty());
    QTest::keyClick(&view(), Qt::Key_Escape);
    EXPECT_FALSE(scene().selectedNote());
    document().undoStack().setClean();
}

TEST_F(Notes, APictureIsAddedFromAFileAndGoesWithTheModel) {
    openLambda();
    QFile file(directory.filePath("bench.png"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(pngOf(QColor(200, 20, 20)));
    file.close();
    view().setFocus();
    QTest::keyClick(&view(), Qt::Key_P, Qt::ShiftModifier);
    auto* dialog = window.findChild<QFileDialog*>("picture-dialog");
    ASSERT_TRUE(dialog);
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    ASSERT_TRUE(QTest::qWaitFor([&] { return name->hasFocus(); }, 5000));
    QTest::keyClicks(name, file.fileName());
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_TRUE(QTest::qWaitFor([&] { return scene().notes().size() == 1; }, 5000)) << text();
    QTest::qWait(50);
    EXPECT_GT(pixelsOf(view().grab().toImage(), QColor(200, 20, 20)), 500) << "it is seen";
    file.remove();
    const QString kept = directory.filePath("kept.analogon");
    window.saveTo(kept);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().isModified(); }, 10000));
    MainWindow again;
    again.resize(1440, 900);
    again.show();
    again.open(kept);
    ASSERT_TRUE(QTest::qWaitFor([&] { return again.document().isOpen() && again.document().before(); }, 20000));
    EXPECT_GT(pixelsOf(again.findChild<DiagramView*>()->grab().toImage(), QColor(200, 20, 20)), 500)
        << "without its file";
    QSettings().remove("window/folder");  // of this test alone
}

TEST_F(Notes, AFileThatIsNoPictureIsToldAndChangesNothing) {
    openLambda();
    const std::string plain = text();
    QString told;
    QObject::connect(&window.compose(), &ComposeActions::told, &window, [&](const QString& s) { told = s; });
    window.compose().addPicture(example("train.csv"));
    EXPECT_TRUE(told.contains("cannot be read as a picture")) << told.toStdString();
    EXPECT_EQ(text(), plain);
}

TEST_F(Notes, TextsOfOtherToolsAreDrawnAndThoseOfABaseAreLeftAlone) {
    window.startNew();
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isOpen(); }, 20000));
    document().typeText(
        "model Base\n  annotation (Diagram(graphics={Text(extent={{-90,80},{90,90}}, textString=\"inherited\")}));\n"
        "end Base;\nmodel Model\n  extends Base;\n  Analogon.Mechanics.Inertia inertia annotation "
        "(Placement(transformation(extent={{-10,-10},{10,10}})));\n"
        "  annotation (Diagram(graphics={Rectangle(extent={{-95,95},{95,-95}}),\n"
        "    Text(extent={{-90,40},{90,60}}, textColor={200,20,20}, textString=\"IIIIIIII\")}));\nend Model;\n");
    ASSERT_TRUE(QTest::qWaitFor([&] { return scene().notes().size() == 1; }, 20000));
    EXPECT_EQ(scene().notes()[0]->primitive().text, "IIIIIIII");
    EXPECT_EQ(document().diagram().graphics.size(), 3u);
    QTest::qWait(50);
    EXPECT_GT(pixelsOf(view().grab().toImage(), QColor(200, 20, 20)), 50);
    document().undoStack().setClean();
}

}  // namespace
}  // namespace analogon::ui
