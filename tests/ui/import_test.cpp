#include <quazip/quazip.h>
#include <quazip/quazipfile.h>

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QTableWidget>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>

#include "core/study/recorded.hpp"
#include "tests/core/measure/mdf/mdf4_writer.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "tests/working_time.hpp"
#include "ui/measurement/channel_browser.hpp"
#include "ui/measurement/compare_page.hpp"
#include "ui/measurement/course_plot.hpp"
#include "ui/measurement/import_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/measurement/question_card.hpp"
#include "ui/measurement/read_fields.hpp"
#include "ui/style/style.hpp"

/// How a file comes into a study by the window: what it does not tell is asked.
namespace analogon::ui {
namespace {

class Import : public Panels {
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
    void keepPicture(const QString& name) {
        QTest::qWait(50);
        QDir().mkpath(ANALOGON_PICTURES);
        EXPECT_TRUE(window.grab().save(QStringLiteral(ANALOGON_PICTURES "/%1.png").arg(name)));
    }
};

TEST_F(Import, AsksWhatAMarkStandsForAndKeepsTheAnswer) {
    openLambda();
    window.open(write("n.csv", "t [s];n [1/min]\n0;1.234\n1;2.345\n2;2.346\n3;2.347\n"));
    ASSERT_TRUE(asks());
    EXPECT_FALSE(import()->acceptButton()->isEnabled()) << "nothing is guessed";
    ASSERT_EQ(question()->buttons().size(), 2);
    const QTableWidget* rows = question()->table();
    ASSERT_EQ(rows->rowCount(), 4);
    EXPECT_EQ(rows->item(0, 1)->text(), "0;1.234") << "as it stands in the file";
    EXPECT_EQ(rows->item(0, 2)->text(), "1.234 1/min");
    EXPECT_EQ(rows->item(0, 3)->text(), "1234 1/min");
    keepPicture("import-question-mark");
    QTest::mouseClick(question()->buttons()[1], Qt::LeftButton);
    ASSERT_TRUE(isReady());
    EXPECT_FALSE(question()->isVisible());
    EXPECT_EQ(import()->model()->index(0, 1).data().toString(), "1234");
    EXPECT_EQ(import()->fields()->options().thousands, '.') << "the answer stands in the fields";
    QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
    const StudyExperiment& taken = document().study().experiments.back();
    EXPECT_EQ(taken.read.thousands, '.') << "and in the study";
    const auto table = fileTable(document().study().tables, taken);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->find("n")->values.front(), 1234);
}

TEST_F(Import, SaysOnThePageThatTheTimeGoesBack) {
    openLambda();
    window.open(write("back.csv", "t [s],u [V]\n0,1\n1,2\n0.5,3\n2,4\n"));
    ASSERT_TRUE(asks()) << "what it may mean";
    EXPECT_FALSE(import()->acceptButton()->isEnabled() && import()->problems().contains("nothing is wrong"));
}

TEST_F(Import, TakesSeveralFilesThatAreTypedOneAfterTheOther) {
    openLambda();
    const QString one = write("one.csv", "t [s],u_heater [V]\n0,1\n1,2\n2,1\n"),
                  two = write("two.csv", "t [s],u_heater [V]\n0,3\n1,4\n2,3\n");
    const std::size_t before = document().study().experiments.size();
    QTest::keyClick(&window, Qt::Key_I, Qt::ControlModifier);
    auto* dialog = window.findChild<QFileDialog*>("import-dialog");
    ASSERT_TRUE(dialog);
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    ASSERT_TRUE(QTest::qWaitFor([&] { return name->hasFocus(); }, 5000));
    QTest::keyClicks(name, '"' + one + "\" \"" + two + '"');
    QTest::keyClick(name, Qt::Key_Return);
    for (int file = 0; file < 2; ++file) {
        ASSERT_TRUE(isReady() && import()->isVisible()) << "the page of file " << file;
        QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
        QTest::qWait(50);
    }
    ASSERT_EQ(document().study().experiments.size(), before + 2);
    EXPECT_THAT(document().study().experiments[before].file, testing::EndsWith("one.csv"));
    EXPECT_THAT(document().study().experiments[before + 1].file, testing::EndsWith("two.csv"));
    document().undoStack().setClean();
    QTest::qWait(100);
    QSettings().remove("window/folder");  // of this test alone
}

TEST_F(Import, IsWholeInANarrowWindow) {
    window.resize(1024, 700);
    openLambda();
    window.open(write("gaps.txt", "  t[s]   u[V]  i[A]\n 0.0  20.5   1.5\n 0.1  20.5\n 0.2  20.5   2.5\n"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !import()->problems().isEmpty(); }, 20000));
    QTest::qWait(50);
    auto* told = import()->findChild<QLabel*>("problems");
    ASSERT_TRUE(told);
    EXPECT_GT(2 * told->width(), import()->width()) << "a sentence, and not a word a line";
    EXPECT_GE(import()->findChild<QScrollArea*>()->height(), 8 * import()->fontMetrics().height());
    const auto keepBoth = [this](const char* name) {
        keepPicture(name);
        style::apply(*qApp, style::Theme::Dark);
        QTest::qWait(1);
        keepPicture((std::string(name) + "-dark").c_str());
        style::apply(*qApp, style::Theme::Light);
    };
    keepBoth("import-narrow");
    QByteArray text = "t";
    for (int c = 1; c <= 30; ++c) text += ";channel_" + QByteArray::number(c);
    for (int row = 0; row < 9; ++row) {
        text += '\n' + QByteArray::number(row);
        for (int c = 1; c <= 30; ++c) text += ';' + QByteArray::number(row * c);
    }
    window.open(write("many.csv", text));
    ASSERT_TRUE(QTest::qWaitFor([&] { return import()->browser()->isVisible(); }, 20000));
    QTest::qWait(50);
    EXPECT_GT(import()->browser()->searchField()->width(), 150);
    keepBoth("import-narrow-browser");
    for (const QPushButton* button : import()->findChildren<QPushButton*>())
        if (button->isVisible()) {
            EXPECT_GE(button->width(), button->minimumSizeHint().width()) << button->text().toStdString();
        }
}

TEST_F(Import, OneQuestionFollowsAnother) {
    openLambda();
    window.open(
        write("d.csv", "time;u\n03/04/2024 10:00:00;1.234\n04/04/2024 10:00:00;1.235\n05/04/2024 10:00:00;1.236\n"));
    ASSERT_TRUE(asks());
    QTest::mouseClick(question()->buttons()[0], Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            return question()->buttons().size() == 2 && question()->isVisible() &&
                   question()->buttons()[0]->text().contains("2024");
        },
        20000));
    keepPicture("import-question-date");
    QTest::mouseClick(question()->buttons()[1], Qt::LeftButton);
    ASSERT_TRUE(isReady());
    EXPECT_EQ(import()->fields()->options().decimal, '.');
    EXPECT_EQ(import()->fields()->options().timeFormat, "%m/%d/%Y %H:%M:%S");
}

TEST_F(Import, AsksWhichUnitIsMeantAndKeepsTheAnswer) {
    openLambda();
    window.open(write("p.csv", "t [s];p [mpa];T [degC]\n0;1.5;20\n1;2.5;21\n2;2.5;22\n3;2.5;23\n"));
    ASSERT_TRUE(asks());
    EXPECT_TRUE(import()->acceptButton()->isEnabled()) << "it may stay open";
    ASSERT_EQ(question()->buttons().size(), 4) << "two readings, none, and what is typed";
    EXPECT_EQ(question()->buttons()[0]->text(), "MPa");
    EXPECT_EQ(question()->buttons()[1]->text(), "mPa");
    const QTableWidget* rows = question()->table();
    ASSERT_EQ(rows->rowCount(), 4);
    EXPECT_EQ(rows->item(0, 1)->text(), "0;1.5;20") << "as it stands in the file";
    EXPECT_EQ(rows->item(0, 2)->text(), "1.5 MPa");
    EXPECT_EQ(rows->item(0, 3)->text(), "1.5 mPa");
    EXPECT_EQ(rows->item(0, 4)->text(), "1.5");
    keepPicture("import-question-unit");
    QTest::mouseClick(question()->buttons()[0], Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !question()->isVisible(); }, 20000));
    ASSERT_TRUE(isReady());
    QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
    const StudyExperiment& taken = document().study().experiments.back();
    EXPECT_EQ(taken.read.unitNames.at("mpa"), "MPa");
    EXPECT_EQ(fileTable(document().study().tables, taken)->find("p")->unit, "MPa");
}

TEST_F(Import, TakesAnotherUnitThatIsTypedForAFileOfAnyKind) {
    openLambda();
    const QString file = directory.filePath("p.mf4");
    test::Mdf4Writer writer;
    test::Bytes data;
    for (int i = 0; i < 5; ++i) data.put(0.5 * i).put(10.0 + i);
    const std::uint64_t group =
        writer.simple("", {{"time", "s", 2}, {"p", "druck", 0, 4, 64, 8}}, 5, 16, writer.block("DT", {}, data.text));
    writer.finish(group, file.toStdString());
    window.open(file);
    ASSERT_TRUE(asks());
    EXPECT_EQ(question()->table()->item(0, 1)->text(), "10 druck");
    QPushButton* const take = question()->buttons().back();
    question()->typedField()->setText("kpa");
    EXPECT_FALSE(take->isEnabled()) << "that is none either";
    question()->typedField()->setText("kPa");
    ASSERT_TRUE(take->isEnabled());
    QTest::mouseClick(take, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !question()->isVisible(); }, 20000));
    ASSERT_TRUE(isReady());
    QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
    const StudyExperiment& taken = document().study().experiments.back();
    EXPECT_EQ(taken.read.unitNames.at("druck"), "kPa");
    EXPECT_EQ(fileTable(document().study().tables, taken)->find("p")->unit, "kPa");
}

TEST_F(Import, RowsWithoutATimeAreNotTakenBeforeItIsTold) {
    openLambda();
    const QString file = write("rows.csv", "u [V];i [A]\n1,5;2\n1,6;3\n1,7;1\n");
    window.open(file);
    ASSERT_TRUE(asks());
    EXPECT_FALSE(import()->acceptButton()->isEnabled()) << "the first column is no time because it is the first";
    ASSERT_TRUE(question()->typedField()->isVisible());
    keepPicture("import-question-rate");
    question()->typedField()->setText("0,5 ms");
    QTest::mouseClick(question()->buttons()[0], Qt::LeftButton);
    ASSERT_TRUE(isReady());
    EXPECT_EQ(import()->timeBox()->currentText(), "time");
    EXPECT_EQ(import()->model()->index(1, 0).data().toString(), "0.0005");
    // or one of its columns is
    window.open(file);
    ASSERT_TRUE(asks());
    import()->timeBox()->setCurrentIndex(0);
    Q_EMIT import()->timeBox()->activated(0);
    EXPECT_TRUE(import()->acceptButton()->isEnabled());
}

TEST_F(Import, EverythingAStudyCanTellIsAFieldOfThePage) {
    ReadOptions all;
    all.separator = '\t';
    all.decimal = ',';
    all.thousands = '\'';
    all.skip = 3;
    all.header = 2;
    all.hasUnitsRow = true;
    all.timeFormat = "%d.%m.%Y %H:%M:%S";
    all.timeZone = "Europe/Berlin";
    all.times = TimeColumns::Right;
    all.encoding = "windows-1252";
    ReadFields fields;
    EXPECT_EQ(fields.options(), ReadOptions{});
    fields.show(all);
    EXPECT_EQ(fields.options(), all);
    EXPECT_TRUE(fields.moreButton()->isChecked()) << "what is told is in sight";
    fields.show({});
    EXPECT_EQ(fields.options(), ReadOptions{});
}

TEST_F(Import, WhatIsTypedIntoAFieldIsReadAnew) {
    openLambda();
    window.open(write("skip.csv", "t [s],u [V]\n0,1\n1,2\nt [s],u [V]\n0,5\n1,6\n2,7\n"));
    ASSERT_TRUE(asks()) << "which of two recordings is meant";
    import()->fields()->moreButton()->setChecked(true);
    keepPicture("import-fields");
    auto options = import()->fields()->options();
    options.skip = 3;
    import()->fields()->show(options);
    Q_EMIT import()->fields()->changed();
    ASSERT_TRUE(isReady());
    EXPECT_EQ(import()->model()->rowCount(), 3);
    EXPECT_EQ(import()->model()->index(0, 1).data().toString(), "5");
}

TEST_F(Import, ATextOfManyChannelsIsLookedIntoFirst) {
    openLambda();
    QByteArray text = "Zeit";
    for (int c = 1; c <= 30; ++c) text += ";channel_" + QByteArray::number(c);
    text += "\ns";
    for (int c = 1; c <= 30; ++c) text += c % 2 ? ";V" : ";degC";
    text += '\n';
    for (int row = 0; row < 50; ++row) {
        text += QByteArray::number(row);
        for (int c = 1; c <= 30; ++c)
            text += ';' + QByteArray::number(std::sin(0.1 * row * c), 'f', 6).replace('.', ',');
        text += '\n';
    }
    window.open(write("many.csv", text));
    ASSERT_TRUE(QTest::qWaitFor([&] { return import()->browser()->isVisible(); }, 20000));
    EXPECT_FALSE(import()->acceptButton()->isEnabled());
    EXPECT_EQ(import()->browser()->tree()->topLevelItem(0)->childCount(), 30) << "the time is no channel to choose";
    import()->browser()->searchField()->setText("channel_7");
    import()->browser()->tickButton()->click();
    import()->browser()->searchField()->setText("channel_12");
    import()->browser()->tickButton()->click();
    import()->browser()->tree()->setCurrentItem(import()->browser()->tree()->topLevelItem(0)->child(6));
    keepPicture("import-text-browser");
    import()->browser()->readButton()->click();
    ASSERT_TRUE(isReady());
    EXPECT_EQ(import()->model()->columnCount(), 3) << "the time and the two that were chosen";
    EXPECT_EQ(import()->timeBox()->currentText(), "Zeit");
    QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
    const auto table = fileTable(document().study().tables, document().study().experiments.back());
    ASSERT_TRUE(table);
    EXPECT_EQ(table->columns.size(), 31u) << "the others stay in the file";
}

TEST_F(Import, AFileIsTextByWhatIsInIt) {
    openLambda();
    window.open(write("scope.lvm", "t [s]\tu [V]\n0\t1,5\n1\t2,5\n"));
    ASSERT_TRUE(isReady());
    EXPECT_TRUE(import()->fields()->isVisible()) << "though its name says nothing";
    Q_EMIT import()->cancelled();
    window.open(QStringLiteral(ANALOGON_ROOT "/README.md").replace("README.md", "ui/icons/none.bin"));
}

// ---- beside the window ----

/// The longest that this thread has worked between two turns of its event loop, in processor time: what others do on
/// the machine does not count.
class LongestTurn : public QObject {
public:
    LongestTurn() {
        connect(&timer_, &QTimer::timeout, this, [this] {
            const double now = test::workedMilliseconds();
            if (last_ > 0) longest_ = std::max(longest_, now - last_);
            last_ = now;
        });
        timer_.start(0);
    }
    double milliseconds() const { return longest_; }
    void forget() { longest_ = last_ = 0; }

private:
    QTimer timer_;
    double longest_{}, last_{};
};

TEST_F(Import, ALongTextIsReadBesideTheWindow) {
    openLambda();
    QByteArray text = "t [s];u [V];i [A];T [degC];p [bar];n [1/min];M [N.m];x [mm]\n";
    constexpr int rows = 900'000;
    text.reserve(rows * 70);
    for (int i = 0; i < rows; ++i) {
        const QByteArray number = QByteArray::number(i % 9973);
        text += QByteArray::number(i / 1000) + ',' + QByteArray::number(1000 + i % 1000).right(3) + ";12," + number +
                ";1," + number + ";85," + number + ";2," + number + ";1500," + number + ";0," + number + ";-3," +
                number + '\n';
    }
    EXPECT_GT(text.size(), 50'000'000);
    const QString file = write("long.csv", text);
    text.clear();
    LongestTurn turn;
    QTest::qWait(200);
    turn.forget();
    window.open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return import()->acceptButton()->isEnabled(); }, 120000));
    EXPECT_LT(turn.milliseconds(), 50) << "while the file is read and shown";
    turn.forget();
    QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
    QTest::qWait(500);
    EXPECT_LT(turn.milliseconds(), 60) << "while it becomes part of the study";
}

TEST_F(Import, ALongBinaryFileIsReadBesideTheWindow) {
    openLambda();
    constexpr int rows = 3'000'000;
    const QString file = directory.filePath("long.mf4");
    test::Mdf4Writer writer;
    test::Bytes data;
    data.text.reserve(rows * 14);
    for (int i = 0; i < rows; ++i)
        data.put(1e-3 * i).put(static_cast<float>(i % 9973)).put(static_cast<std::int16_t>(i % 300));
    const std::uint64_t group = writer.simple("", {{"t", "s", 2}, {"u", "V", 0, 4, 32, 8}, {"i", "A", 0, 2, 16, 12}},
                                              rows, 14, writer.block("DT", {}, data.text));
    writer.finish(group, file.toStdString());
    LongestTurn turn;
    QTest::qWait(200);
    turn.forget();
    window.open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return import()->acceptButton()->isEnabled(); }, 120000));
    EXPECT_LT(turn.milliseconds(), 50) << "while the file is read and shown";
    RecordProperty("longest_turn_us", static_cast<int>(1e3 * turn.milliseconds()));
    QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
    const StudyExperiment& taken = document().study().experiments.back();
    EXPECT_EQ(fileTable(document().study().tables, taken)->rows(), static_cast<std::size_t>(rows));
}

TEST_F(Import, ALongWorkbookIsReadBesideTheWindow) {
    openLambda();
    constexpr int rows = 60'000;
    QByteArray sheet = "<worksheet><sheetData>";
    const auto word = [](const char* cell, const char* text) {
        return QByteArray("<c r=\"") + cell + "\" t=\"inlineStr\"><is><t>" + text + "</t></is></c>";
    };
    sheet += "<row r=\"1\">" + word("A1", "t [s]") + word("B1", "u [V]") + word("C1", "i [A]") + "</row>";
    for (int i = 2; i < rows + 2; ++i) {
        const QByteArray row = QByteArray::number(i);
        sheet += "<row r=\"" + row + "\">";
        for (const char* const column : {"A", "B", "C"})
            sheet += QByteArray("<c r=\"") + column + row + "\"><v>" + QByteArray::number(0.001 * i) + "</v></c>";
        sheet += "</row>";
    }
    const QString file = directory.filePath("long.xlsx");
    QuaZip archive(file);
    ASSERT_TRUE(archive.open(QuaZip::mdCreate));
    for (const auto& [name, content] : std::initializer_list<std::pair<const char*, QByteArray>>{
             {"xl/workbook.xml",
              "<workbook xmlns:r=\"r\"><sheets><sheet name=\"Run\" sheetId=\"1\" r:id=\"rId1\"/></sheets></workbook>"},
             {"xl/_rels/workbook.xml.rels",
              "<Relationships><Relationship Id=\"rId1\" Target=\"worksheets/sheet1.xml\"/></Relationships>"},
             {"xl/worksheets/sheet1.xml", sheet + "</sheetData></worksheet>"}}) {
        QuaZipFile part(&archive);
        ASSERT_TRUE(part.open(QIODevice::WriteOnly, QuaZipNewInfo(name)));
        part.write(content);
        part.close();
    }
    archive.close();
    LongestTurn turn;
    QTest::qWait(200);
    turn.forget();
    window.open(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return import()->acceptButton()->isEnabled(); }, 120000));
    EXPECT_LT(turn.milliseconds(), 50) << "while the file is read and shown";
    RecordProperty("longest_turn_us", static_cast<int>(1e3 * turn.milliseconds()));
    QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
    const StudyExperiment& taken = document().study().experiments.back();
    EXPECT_EQ(fileTable(document().study().tables, taken)->rows(), static_cast<std::size_t>(rows));
}

// ---- the same quantity in several recordings ----

class Compare : public Import {
protected:
    /// The speed of a shaft as two loggers have it whose clocks differ by `clock`.
    void openWithTwo(double clock) {
        openLambda();
        for (const auto& [name, ahead] : {std::pair{"a.csv", 0.0}, {"b.csv", clock}}) {
            QByteArray text = "t [s],u_heater [V],T_exhaust [degC],i_heater [A]\n";
            for (int i = 0; i < 1000; ++i) {
                const double t = 0.05 * i, true_ = t - ahead;
                const double current =
                    1 / (1 + std::exp(-(true_ - 11) / 0.4)) - 0.6 / (1 + std::exp(-(true_ - 31) / 0.7));
                text += QByteArray::number(t, 'g', 10) + ",12,20," + QByteArray::number(current, 'g', 10) + '\n';
            }
            window.open(write(name, text));
            ASSERT_TRUE(isReady());
            QTest::mouseClick(import()->acceptButton(), Qt::LeftButton);
        }
    }
};

TEST_F(Compare, TheShiftIsShownAndBecomesTheClockOnAClick) {
    openWithTwo(0.137);
    Q_EMIT panel<MeasurementPanel>()->comparisonWanted("i_mod", "a");
    auto* page = panel<ComparePage>();
    ASSERT_TRUE(page->isVisible());
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return page->table()->rowCount() == 4 && page->plot()->lines().size() == 4; }, 20000));
    int row = 0;
    for (int i = 0; i < page->table()->rowCount(); ++i)
        if (page->table()->item(i, 0)->text() == "b") row = i;
    ASSERT_GT(row, 0);
    EXPECT_EQ(page->table()->item(0, 0)->text(), "a") << "the reference stands in front";
    EXPECT_NEAR(page->table()->item(row, 1)->text().toDouble(), 0.137, 1e-3);
    page->table()->selectRow(row);
    keepPicture("compare");
    auto* set = qobject_cast<QPushButton*>(page->table()->cellWidget(row, 4));
    ASSERT_TRUE(set && set->isEnabled());
    set->click();
    EXPECT_NEAR(document().study().experiments.back().outputs.at("i_mod").clock, 0.137, 1e-3);
    document().undoStack().undo();
    EXPECT_EQ(document().study().experiments.back().outputs.at("i_mod").clock, 0);
}

TEST_F(Compare, AShiftCanBeTyped) {
    openWithTwo(0.1);
    Q_EMIT panel<MeasurementPanel>()->comparisonWanted("i_mod", "a");
    auto* page = panel<ComparePage>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return page->table()->rowCount() == 4; }, 20000));
    const int row = 3;
    page->table()->item(row, 1)->setText("0,25");
    EXPECT_NEAR(page->plot()->lines().at(row).shift, 0.25, 1e-12);
    page->setClock(row);
    EXPECT_EQ(document().study().experiments.back().outputs.at("i_mod").clock, 0.25);
}

}  // namespace
}  // namespace analogon::ui
