#include "ui/text/annotation_folds.hpp"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QTabBar>
#include <QTabWidget>

#include "tests/ui/panels_fixture.hpp"
#include "tests/working_time.hpp"
#include "ui/style/style.hpp"
#include "ui/text/find_bar.hpp"
#include "ui/text/text_view.hpp"

namespace analogon::ui {

namespace {

QStringList insidesOf(const QString& text) {
    QStringList parts;
    for (const AnnotationRange& range : annotationsIn(text)) parts << text.mid(range.begin, range.end - range.begin);
    return parts;
}

TEST(AnnotationsInText, AreFoundWithTheirBracketsAndNotInTextsAndComments) {
    EXPECT_EQ(insidesOf("Real x annotation(A(b = 1)); Real y annotation (\n C());"),
              (QStringList{"A(b = 1)", "\n C()"}));
    EXPECT_EQ(insidesOf("\"annotation(1)\" // annotation(2)\n/* annotation(3) */ 'annotation(4)' annotation(\")\")"),
              QStringList{"\")\""});
    EXPECT_EQ(insidesOf("annotation(a(annotation(b)))"), QStringList{"a(annotation(b))"}) << "the outer one";
    EXPECT_TRUE(insidesOf("myannotation(1); annotation2(1); annotation; annotation(not closed").isEmpty());
    EXPECT_TRUE(insidesOf("").isEmpty());
}

class Folds : public Panels {
protected:
    void SetUp() override {
        Panels::SetUp();
        openLambda();
        for (QTabWidget* tabs : window.findChildren<QTabWidget*>())
            if (const int tab = tabs->indexOf(panel<TextView>()); tab >= 0)
                QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(tab).center());
        QTest::qWait(20);
        text = panel<TextView>();
        text->moveCursor(QTextCursor::Start);
    }
    /// The first line that holds it, from 1.
    int lineOf(const QString& part) const { return text->document()->find(part).block().blockNumber() + 1; }
    QTextBlock blockOf(const QString& part) const { return text->document()->findBlockByNumber(lineOf(part) - 1); }
    /// How wide a line is drawn.
    double widthOf(const QTextBlock& block) const {
        QTextCursor first(block), last(block);
        last.movePosition(QTextCursor::EndOfBlock);
        return text->cursorRect(last).left() - text->cursorRect(first).left();
    }
    AnnotationFolds::Line at(const QString& part) const { return text->folds().lineAt(blockOf(part)); }
    using Line = AnnotationFolds::Line;

    TextView* text{};
};

TEST_F(Folds, LongAnnotationsTakeNoRoomUntilTheyAreOpenedInTheMargin) {
    const QString line = "{{-70,-10},{-50,10}}";  // of the heater
    EXPECT_EQ(at(line), Line::Folded);
    const double folded = widthOf(blockOf(line));
    const double whole = text->fontMetrics().horizontalAdvance(blockOf(line).text());
    EXPECT_LT(folded, whole / 2);
    QTest::mouseClick(text->margin(), Qt::LeftButton, {}, text->foldMark(lineOf(line)).center());
    EXPECT_EQ(at(line), Line::Open);
    EXPECT_NEAR(widthOf(blockOf(line)), whole, 0.1 * whole);
    QTest::mouseClick(text->margin(), Qt::LeftButton, {}, text->foldMark(lineOf(line)).center());
    EXPECT_EQ(at(line), Line::Folded);
    EXPECT_NEAR(widthOf(blockOf(line)), folded, 1);
    EXPECT_EQ(document().undoStack().count(), 0) << "the study is as it was";
}

TEST_F(Folds, KeysFoldALineAndAllOfThem) {
    const int all = text->folds().folded();
    EXPECT_GT(all, 8);
    QTextCursor caret(blockOf("{{-70,-10},{-50,10}}"));
    text->setTextCursor(caret);
    QTest::keyClick(text, Qt::Key_Period, Qt::ControlModifier);
    EXPECT_EQ(text->folds().folded(), all - 1);
    QTest::keyClick(text, Qt::Key_Period, Qt::ControlModifier);
    EXPECT_EQ(text->folds().folded(), all);
    QTest::keyClick(text, Qt::Key_Period, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_EQ(text->folds().folded(), 0);
    QTest::keyClick(text, Qt::Key_Period, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_GE(text->folds().folded(), all);
}

TEST_F(Folds, CopyTakesTheWholeAndNothingOfTheTextIsLost) {
    const QString model = document().modelText();
    EXPECT_EQ(text->toPlainText(), model);
    text->selectAll();
    text->copy();
    EXPECT_EQ(QApplication::clipboard()->text(), model);
}

TEST_F(Folds, FindingOpensWhatItFindsIn) {
    const QString part = "{-150,-90}";
    ASSERT_EQ(at(part), Line::Folded);
    QTest::keyClick(text, Qt::Key_F, Qt::ControlModifier);
    QTest::keyClicks(text->findBar()->field(), part);
    EXPECT_EQ(text->findBar()->count()->text(), "1 of 1");
    EXPECT_EQ(at(part), Line::Open);
    EXPECT_EQ(text->textCursor().selectedText(), part);
}

TEST_F(Folds, PlaceOfAMessageInsideIsOpened) {
    const QString part = "{-150,-90}";
    const QTextCursor place = text->document()->find(part);
    text->showPlace(lineOf(part), place.selectionStart() - place.block().position() + 1, 5);
    EXPECT_EQ(at(part), Line::Open);
}

TEST_F(Folds, OpenedOnesStayOpenWhileTheTextAboveChanges) {
    const QString line = "{{-70,-10},{-50,10}}";
    text->folds().toggle(blockOf(line));
    ASSERT_EQ(at(line), Line::Open);
    text->moveCursor(QTextCursor::Start);
    QTest::keyClicks(text, "// a");
    QTest::keyClick(text, Qt::Key_Return);
    EXPECT_EQ(at(line), Line::Open);
    EXPECT_EQ(at("{85,-10}"), Line::Folded);
    QTest::qWait(400);  // what was typed has reached the study
    EXPECT_TRUE(document().modelText().startsWith("// a\n"));
    EXPECT_EQ(at(line), Line::Open);
    EXPECT_EQ(at("{85,-10}"), Line::Folded);
}

TEST_F(Folds, AnnotationsOfSeveralLinesHideTheirLines) {
    QString model = document().modelText();
    model.replace("annotation (Diagram(coordinateSystem(extent={{-160,-110},{160,70}})));",
                  "annotation (\n    Diagram(\n      coordinateSystem(extent={{-160,-110},{160,70}}))\n  );");
    document().typeText(model);
    QTest::qWait(50);
    EXPECT_FALSE(blockOf("coordinateSystem(extent={{-160").isVisible());
    EXPECT_TRUE(blockOf("end LambdaSensorHeating").isVisible());
    const QTextBlock first = text->document()->findBlockByNumber(lineOf("coordinateSystem(extent={{-160") - 3);
    ASSERT_EQ(text->folds().lineAt(first), Line::Folded) << first.text().toStdString();
    text->folds().toggle(first);
    EXPECT_TRUE(blockOf("coordinateSystem(extent={{-160").isVisible());
    EXPECT_EQ(text->toPlainText(), model);
}

TEST_F(Folds, LargeModelsAreFoldedAtOnce) {
    QString model = "model Large\n";
    for (int i = 0; i < 2000; ++i)
        model += QStringLiteral(
                     "  Analogon.Thermal.HeatCapacitor body%1(C=1)\n    annotation "
                     "(Placement(transformation(extent={{0,0},{20,20}})));\n")
                     .arg(i);
    model += "end Large;\n";
    EXPECT_EQ(annotationsIn(model).size(), 2000u);
    EXPECT_LT(test::leastMilliseconds(3, [&] { annotationsIn(model); }), 50) << "[ms]";
}

TEST_F(Folds, LookAsTheyShould) {
    for (const style::Theme theme : {style::Theme::Light, style::Theme::Dark}) {
        style::apply(*qApp, theme);
        QTest::qWait(50);
        text->folds().toggle(blockOf("{{-70,-10},{-50,10}}"));
        text->grab().save(QStringLiteral(ANALOGON_PICTURES) + "/folds" + (theme == style::Theme::Dark ? "-dark" : "") +
                          ".png");
    }
    style::apply(*qApp, style::Theme::Light);
}

}  // namespace

}  // namespace analogon::ui
