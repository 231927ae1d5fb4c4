#include <gmock/gmock.h>

#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "core/study/recorded.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/question_card.hpp"

/// Files with several times on the page of the import, and the room that a question has there.
namespace analogon::ui {
namespace {

class ImportOfTimes : public Panels {
protected:
    QString write(const QString& name, const QByteArray& text) {
        QFile file(directory.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return file.fileName();
    }
    ImportPanel* import() { return panel<ImportPanel>(); }
    QuestionCard* question() { return import()->question(); }
    bool asks() {
        return QTest::qWaitFor([&] { return question()->isVisible(); }, 20000);
    }
    bool isReady() {
        return QTest::qWaitFor([&] { return import()->acceptButton()->isEnabled(); }, 20000);
    }
};

TEST_F(ImportOfTimes, ShowsBothReadingsOfTwoTimesAndKeepsTheChosenOne) {
    openLambda();
    QByteArray text = "t1 [s];u [V];t2 [s];w [rad/s]\n";
    for (int i = 0; i < 12; ++i)
        text +=
            QByteArray::number(i) + "e-2;1;" + QByteArray::number(5 * i) + "e-2;" + QByteArray::number(300 - i) + "\n";
    window.open(write("two.csv", text));
    ASSERT_TRUE(asks());
    EXPECT_EQ(question()->table()->item(0, 2)->text(), "299 rad/s at 0.05 s");
    EXPECT_EQ(question()->table()->item(0, 3)->text(), "299 rad/s at 0.01 s");
    ASSERT_TRUE(isReady());
    EXPECT_THAT(import()->problems().toStdString(), testing::HasSubstr("There are 2 times"));
    EXPECT_THAT(import()->problems().toStdString(), testing::Not(testing::HasSubstr("nothing is wrong")));
    QTest::mouseClick(question()->buttons().at(1), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !question()->isVisible(); }, 20000));
    ASSERT_TRUE(isReady());
    EXPECT_THAT(import()->problems().toStdString(), testing::Not(testing::HasSubstr("There are 2 times")));
    QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
    const StudyExperiment& taken = document().study().experiments.back();
    EXPECT_EQ(taken.read.times, TimeColumns::One);
    EXPECT_TRUE(fileTable(document().study().tables, taken)->others.empty());
}

TEST_F(ImportOfTimes, SaysThatTheRatesOfAFileAreShownTogether) {
    openLambda();
    QByteArray text = "Zeit 1;U;Zeit 2;n\ns;V;s;U/min\n";
    for (int i = 0; i < 12; ++i)
        text += QByteArray::number(i) + "e-2;1;" +
                (i < 4 ? QByteArray::number(2 * i) + "e-2;" + QByteArray::number(300 - i) : ";") + "\n";
    window.open(write("rates.csv", text));
    ASSERT_TRUE(isReady());
    EXPECT_FALSE(question()->isVisible()) << "rows that end tell it";
    EXPECT_THAT(import()->problems().toStdString(), testing::HasSubstr("a model takes each at its own"));
    EXPECT_THAT(import()->problems().toStdString(), testing::Not(testing::HasSubstr("input")));
    QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
    EXPECT_EQ(fileTable(document().study().tables, document().study().experiments.back())->others.size(), 1u);
}

/// The least height that a page which scrolls may give it, where one line of the question was counted: the rest lay
/// over the rows below.
TEST(QuestionInLittleRoom, KeepsItsAnswersBelowItsRowsHoweverManyLinesItTakes) {
    Question asked;
    asked.text = phrase("does the mark in '{}' stand for decimals or between thousands, as some have it", "60,100");
    QuestionRows rows;
    for (int i = 0; i < 5; ++i)
        rows.rows.push_back({i + 2, "0;60,100;1.110", {phrase("{}", 60.1), phrase("{}", 60100)}});
    for (const double value : {60.1, 60100.0}) asked.readings.push_back({phrase("'{}' is {}", "60,100", value), {}});
    QuestionCard card;
    card.ask(asked, rows, {});
    const auto labels = card.findChildren<QLabel*>();
    ASSERT_FALSE(labels.isEmpty());
    const QLabel* heading = labels.front();
    int mostLines = 0;
    for (int width = 300; width <= 700; width += 40) {
        card.resize(width, 600);
        card.show();
        QTest::qWait(10);
        card.resize(width, card.minimumSizeHint().height());
        QTest::qWait(10);
        for (const QLabel* text : labels)
            EXPECT_GE(text->height(), text->heightForWidth(text->width())) << width << ": " << qPrintable(text->text());
        for (const QPushButton* answer : card.buttons()) {
            EXPECT_FALSE(answer->geometry().intersects(card.table()->geometry())) << width;
            EXPECT_FALSE(answer->geometry().intersects(heading->geometry())) << width;
        }
        EXPECT_FALSE(heading->geometry().intersects(card.table()->geometry())) << width;
        mostLines = std::max(mostLines, heading->height() / heading->fontMetrics().height());
    }
    EXPECT_GE(mostLines, 2) << "else nothing is tried";
}

TEST_F(ImportOfTimes, TheAnswersOfAQuestionLieBelowItsRowsHoweverManyLinesItTakes) {
    openLambda();
    window.open(write("n.csv", "t [s];T [degC];p [mbar]\n0;60,100;1.110\n1;60,107;1.113\n2;60,114;1.116\n"));
    ASSERT_TRUE(asks());
    auto* heading = question()->findChild<QLabel*>();
    ASSERT_TRUE(heading);
    bool hasTwoLines = false;
    for (const QSize& size : {QSize(1440, 900), QSize(1100, 700), QSize(853, 480)}) {
        window.resize(size);
        QTest::qWait(50);
        EXPECT_GE(heading->height(), heading->heightForWidth(heading->width()));
        hasTwoLines = hasTwoLines || heading->height() >= 2 * heading->fontMetrics().height();
        for (const QPushButton* answer : question()->buttons()) {
            EXPECT_FALSE(answer->geometry().intersects(question()->table()->geometry())) << size.width();
            EXPECT_FALSE(answer->geometry().intersects(heading->geometry())) << size.width();
        }
    }
    EXPECT_TRUE(hasTwoLines) << "else nothing is tried";
}

}  // namespace
}  // namespace analogon::ui
