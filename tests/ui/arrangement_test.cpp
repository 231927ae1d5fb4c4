#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <QTabBar>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

#include "tests/ui/panels_fixture.hpp"
#include "tests/ui/sample_finding.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

class Arrangements : public Panels {
protected:
    ~Arrangements() override { QSettings().remove("window"); }  // what one test arranged is nothing to the next
    static QStringList shown(const MainWindow& of) {
        QStringList names;
        for (const QDockWidget* dock : of.findChildren<QDockWidget*>())
            if (!dock->isHidden()) names << dock->objectName();
        names.sort();
        return names;
    }
    /// The result of a search that added radiation, in these words, with what was tried.
    void showRadiation(const std::string& words) {
        openLambda();
        document().setResult(RunKind::Discover,
                             sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation", words,
                                           "element.solid", "port", "epsilon"),
                             document().study());
        ASSERT_TRUE(QTest::qWaitFor([&] { return panel<ResultPanel>()->candidates() != nullptr; }, 5000));
    }
};

}  // namespace

TEST_F(Arrangements, AreOneKeyApartAndLeadBack) {
    openLambda();
    const QStringList all = shown(window);
    QTest::keyClick(&window, Qt::Key_F7);
    EXPECT_EQ(shown(window), (QStringList{"library", "messages", "parameters"}));
    QTest::keyClick(&window, Qt::Key_F8);
    EXPECT_EQ(shown(window), (QStringList{"measurements", "plots", "signals", "traces"}));
    QTest::keyClick(&window, Qt::Key_F9);
    EXPECT_EQ(shown(window), (QStringList{"plots", "result", "runs", "traces"}));
    window.findChild<QDockWidget*>("runs")->close();
    QTest::keyClick(&window, Qt::Key_F7);
    QTest::keyClick(&window, Qt::Key_F9);
    EXPECT_FALSE(shown(window).contains("runs")) << "as the user left it";
    QTest::keyClick(&window, Qt::Key_F9);
    EXPECT_EQ(shown(window), all) << "the same key again";
}

/// In a stack the tab says the name; where the others of it are closed there is no tab.
TEST_F(Arrangements, APanelThatIsAloneInItsPlaceHasItsTitle) {
    openLambda();
    const auto hasTitle = [&](const char* dock) {
        return QTest::qWaitFor([&] { return panel<QDockWidget>(dock)->titleBarWidget()->height() > 10; }, 1000);
    };
    const auto hasNone = [&](const char* dock) {
        return QTest::qWaitFor([&] { return panel<QDockWidget>(dock)->titleBarWidget()->height() < 10; }, 1000);
    };
    EXPECT_TRUE(hasNone("signals")) << "beside the library";
    QTest::keyClick(&window, Qt::Key_F8);
    EXPECT_TRUE(hasTitle("signals"));
    EXPECT_TRUE(hasTitle("measurements"));
    QTest::keyClick(&window, Qt::Key_F7);
    EXPECT_TRUE(hasTitle("library"));
    EXPECT_TRUE(hasTitle("messages"));
    QTest::keyClick(&window, Qt::Key_F7);
    EXPECT_TRUE(hasNone("library")) << "all are there again";
}

TEST_F(Arrangements, PanelsThatShareAPlaceHaveTheirNameOnceInANewStudy) {
    window.startNew();
    ASSERT_TRUE(document().isOpen());
    for (const char* dock : {"library", "signals", "result", "runs", "traces", "plots", "messages"}) {
        const QWidget* title = panel<QDockWidget>(dock)->titleBarWidget();
        EXPECT_TRUE(QTest::qWaitFor([&] { return !title->isVisible() || title->height() < 10; }, 500)) << dock;
    }
}

/// A screen of 1024 x 700, and one of 1280 x 720 at 150 %.
TEST_F(Arrangements, LeaveRoomForTheDiagramInSmallWindows) {
    openLambda();
    for (const QSize& size : {QSize(1024, 700), QSize(853, 480)}) {
        window.resize(size);
        QTest::qWait(20);
        for (const Qt::Key key : {Qt::Key_F7, Qt::Key_F8, Qt::Key_F9}) {
            QTest::keyClick(&window, key);
            QTest::qWait(50);
            EXPECT_EQ(window.size(), size) << "no panel asks for more than there is";
            EXPECT_GE(window.centralWidget()->width(), 320);
            EXPECT_GE(window.centralWidget()->height(), 160);
        }
    }
}

TEST_F(Arrangements, AreSavedWithTheWindow) {
    {
        MainWindow first;
        first.show();
        first.open(lambdaFile("one"));
        ASSERT_TRUE(QTest::qWaitFor([&] { return first.document().isOpen() && first.document().before(); }, 20000));
        QTest::keyClick(&first, Qt::Key_F9);
        first.close();
    }
    MainWindow second;
    second.show();
    second.open(lambdaFile("two"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return second.document().isOpen() && second.document().before(); }, 20000));
    EXPECT_EQ(shown(second), (QStringList{"plots", "result", "runs", "traces"}));
    const auto* group = second.findChild<QActionGroup*>("arrangements");
    ASSERT_TRUE(group && group->checkedAction());
    EXPECT_EQ(group->checkedAction()->shortcut(), QKeySequence(Qt::Key_F9));
    QTest::keyClick(&second, Qt::Key_F9);
    second.close();
}

TEST_F(Arrangements, WhatWasTriedIsFilteredAndGrouped) {
    openLambda();
    run(RunKind::Discover);
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return results->candidates() != nullptr; }, 5000));
    QTest::qWait(500);  // until what follows the run has come
    QTreeWidget* list = results->candidates();
    const int all = list->topLevelItemCount();
    ASSERT_GT(all, 3);
    const auto visible = [&] {
        int rows = 0;
        for (int i = 0; i < list->topLevelItemCount(); ++i) rows += !list->topLevelItem(i)->isHidden();
        return rows;
    };
    const int height = list->height();
    QTest::keyClicks(results->candidateFilter(), "thermal.resistance");
    EXPECT_GT(visible(), 0);
    EXPECT_LT(visible(), all);
    EXPECT_LT(list->height(), height);
    results->candidateFilter()->clear();
    EXPECT_EQ(visible(), all);
    QTest::mouseClick(results->roundBox(), Qt::LeftButton, {}, QPoint(8, results->roundBox()->height() / 2));
    ASSERT_TRUE(results->roundBox()->isChecked());
    int grouped = 0;
    for (int i = 0; i < list->topLevelItemCount(); ++i) {
        EXPECT_EQ(
            list->topLevelItem(i)->text(0),
            QStringLiteral("Round %1").arg(list->topLevelItem(i)->child(0)->data(0, ResultPanel::RoundRole).toInt()));
        grouped += list->topLevelItem(i)->childCount();
    }
    EXPECT_EQ(grouped, all);
    QTest::mouseClick(results->roundBox(), Qt::LeftButton, {}, QPoint(8, results->roundBox()->height() / 2));
    EXPECT_EQ(list->topLevelItemCount(), all);
}

/// Words of the first two columns that are wider than these.
QStringList wordsThatAreCut(QTreeWidget& list) {
    QStringList cut;
    for (QTreeWidgetItemIterator row(&list); *row; ++row) {
        if (!(*row)->data(0, ResultPanel::RankRole).isValid()) continue;
        for (const int column : {0, 1}) {
            const QVariant own = (*row)->data(column, Qt::FontRole);
            const QFontMetrics letters(own.isValid() ? own.value<QFont>() : list.font());
            for (const QString& word : (*row)->text(column).split(u' '))
                if (letters.horizontalAdvance(word) >
                    list.visualItemRect(*row)
                        .intersected(QRect(list.header()->sectionViewportPosition(column),
                                           list.visualItemRect(*row).y(), list.columnWidth(column), 1))
                        .width())
                    cut << word;
        }
    }
    return cut;
}

TEST_F(Arrangements, NamesOfWhatWasTriedHaveRoomInASmallWindow) {
    showRadiation("Heat radiation to constant surroundings");
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(results->candidates());
    const auto shownFigures = [&] {
        return !results->candidates()->isColumnHidden(2) + !results->candidates()->isColumnHidden(3);
    };
    window.resize(1900, 900);
    QTest::qWait(50);
    EXPECT_EQ(shownFigures(), 2);
    window.resize(1024, 700);
    QTest::keyClick(&window, Qt::Key_F9);
    QTreeWidget* list = results->candidates();
    const auto hasRoom = [&] { return list->columnWidth(0) >= 12 * list->fontMetrics().averageCharWidth(); };
    EXPECT_TRUE(QTest::qWaitFor(hasRoom, 2000)) << "and not a syllable a line";
    EXPECT_GE(list->columnWidth(0), 12 * list->fontMetrics().averageCharWidth()) << "and not a syllable a line";
    EXPECT_GE(list->columnWidth(1), 12 * list->fontMetrics().averageCharWidth());
    EXPECT_FALSE(list->isColumnHidden(4)) << "the verdict stays";
    for (const bool isByRound : {false, true}) {  // indented below the heading of its round
        results->roundBox()->setChecked(isByRound);
        QTest::qWait(50);
        EXPECT_TRUE(shownFigures() == 0 || wordsThatAreCut(*list).isEmpty())
            << wordsThatAreCut(*list).join(' ').toStdString();
    }
    for (const QLabel* label : results->findChildren<QLabel*>())
        if (label->isVisible() && !label->text().isEmpty()) {
            EXPECT_GE(label->height(), label->heightForWidth(label->width())) << label->text().toStdString();
        }
    QTest::keyClick(&window, Qt::Key_F9);
    document().undoStack().setClean();
}

TEST_F(Arrangements, NamesOfWhatWasTriedHaveAsManyLinesAsTheyNeedBelowTheHeadingOfTheirRound) {
    openLambda();
    RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation",
                                     "Heat radiation to constant surroundings", "element.solid", "port", "epsilon");
    ASSERT_FALSE(result.finding.candidates.empty());
    for (const char* name : {"radiation to surroundings whose temperature was recorded beside the model",
                             "convection that depends on the temperature of what flows past it"}) {
        result.finding.candidates.push_back(result.finding.candidates.back());
        result.finding.candidates.back().kind = name;  // shown where there is no class of it
        result.finding.candidates.back().className.clear();
    }
    document().setResult(RunKind::Discover, result, document().study());
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return results->candidates() != nullptr; }, 5000));
    panel<QDockWidget>("result")->raise();
    QTreeWidget* list = results->candidates();
    int lines = 0;
    for (const bool isByRound : {false, true}) {
        if (results->roundBox()->isChecked() != isByRound)
            QTest::mouseClick(results->roundBox(), Qt::LeftButton, {}, QPoint(8, results->roundBox()->height() / 2));
        list = results->candidates();
        for (int width = 260; width <= 420; width += 20) {
            list->setFixedWidth(width);
            QTest::qWait(20);
            const int before = isByRound ? list->indentation() : 0;
            for (QTreeWidgetItemIterator row(list); *row; ++row) {
                if (!(*row)->data(0, ResultPanel::RankRole).isValid()) continue;
                const QVariant own = (*row)->data(0, Qt::FontRole);
                const QFontMetrics letters(own.isValid() ? own.value<QFont>() : list->font());
                const int room = list->columnWidth(0) - before -
                                 2 * list->style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, list);
                const int needed =
                    letters.boundingRect(QRect(0, 0, room, 1000), Qt::TextWordWrap, (*row)->text(0)).height();
                lines = std::max(lines, needed / letters.height());
                EXPECT_GE(list->visualItemRect(*row).height(), needed)
                    << width << " " << isByRound << ": " << (*row)->text(0).toStdString();
            }
        }
    }
    EXPECT_GE(lines, 3) << "else nothing is tried";
    document().undoStack().setClean();
}

TEST_F(Arrangements, WhichFiguresAreHiddenDependsOnThePresentWidthAlone) {
    showRadiation("Heat radiation to constant surroundings");
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(results->candidates());
    QTreeWidget* list = results->candidates();
    QTest::qWait(50);
    const auto hiddenAt = [&](int width) {
        list->setFixedWidth(width);
        QCoreApplication::sendPostedEvents();
        EXPECT_LE(std::abs(list->viewport()->width() - width), 20);
        return std::pair{list->isColumnHidden(2), list->isColumnHidden(3)};
    };
    constexpr int least = 200, most = 900;
    EXPECT_EQ(hiddenAt(most), (std::pair{false, false}));
    EXPECT_EQ(hiddenAt(least), (std::pair{true, true}));
    for (int width = least; width <= most; width += 12) {
        hiddenAt(least);
        const std::pair<bool, bool> fromNarrow = hiddenAt(width);
        hiddenAt(most);
        EXPECT_EQ(fromNarrow, hiddenAt(width)) << width << ": whether it was wider or narrower before does not matter";
    }
    document().undoStack().setClean();
}

TEST_F(Arrangements, WhatWasTriedIsSortedByItsColumns) {
    showRadiation("Heat radiation");
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(results->candidates());
    QTest::qWait(50);
    const auto column = [&](int c) {
        QStringList texts;
        for (int i = 0; i < results->candidates()->topLevelItemCount(); ++i)
            texts << results->candidates()->topLevelItem(i)->text(c);
        return texts;
    };
    const auto click = [&](int c) {
        QHeaderView* header = results->candidates()->header();
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {},
                          {header->sectionViewportPosition(c) + header->sectionSize(c) / 2, header->height() / 2});
    };
    constexpr int name = 0, screening = 2, deltaBic = 3;
    const QStringList asTried = column(name);
    ASSERT_EQ(asTried.size(), 6);
    results->candidates()->setCurrentItem(results->candidates()->topLevelItem(4));
    const QString marked = results->candidates()->currentItem()->text(name);
    click(screening);
    EXPECT_EQ(column(screening), (QStringList{"812", "801", "640", "210", "3.2", "0.0"}));
    EXPECT_TRUE(results->candidates()->header()->isSortIndicatorShown());
    click(screening);
    EXPECT_EQ(column(screening), (QStringList{"0.0", "3.2", "210", "640", "801", "812"}));
    click(screening);
    EXPECT_EQ(column(name), asTried) << "as they were tried";
    EXPECT_FALSE(results->candidates()->header()->isSortIndicatorShown());
    click(deltaBic);
    click(deltaBic);
    EXPECT_EQ(column(deltaBic).first(), "-120") << "by its value, not its letters";
    EXPECT_EQ(column(deltaBic).mid(4), (QStringList{"", ""})) << "what was not refitted comes last";
    EXPECT_EQ(results->candidates()->currentItem()->text(name), marked);
    for (int i = 0; i < 6; ++i) {
        QTreeWidgetItem* row = results->candidates()->topLevelItem(i);
        EXPECT_TRUE(results->candidates()->itemWidget(row, 5)) << "each can be tried still";
    }
    click(name);
    QStringList names = column(name);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end(),
                               [](const QString& a, const QString& b) { return a.localeAwareCompare(b) < 0; }));
    document().undoStack().setClean();
}

TEST_F(Arrangements, TheButtonBesideARowIsSeenWhereTheRowIsSelected) {
    showRadiation("radiation");
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(results->candidates());
    QTreeWidget* list = results->candidates();
    QTreeWidgetItem* row = nullptr;
    for (QTreeWidgetItemIterator each(list); *each && !row; ++each)
        if (list->itemWidget(*each, 5)) row = *each;
    ASSERT_TRUE(row);
    QWidget* button = list->itemWidget(row, 5);
    for (const style::Theme theme : {style::Theme::Light, style::Theme::Dark}) {
        style::apply(*qApp, theme);
        list->setCurrentItem(row);
        results->ensureWidgetVisible(button);
        QTest::qWait(50);
        const QImage drawn = list->viewport()->grab(button->geometry()).toImage();
        const QColor ink = list->palette().color(QPalette::HighlightedText);
        int ofWords = 0;
        for (int y = 0; y < drawn.height(); ++y)
            for (int x = 0; x < drawn.width(); ++x)
                ofWords += std::abs(drawn.pixelColor(x, y).lightness() - ink.lightness()) < 30;
        EXPECT_GT(ofWords, 10) << "in the ink of the words beside it";
    }
    style::apply(*qApp, style::Theme::Light);
    document().undoStack().setClean();
}

TEST_F(Arrangements, TheTabsOfPanelsHaveTheRoomThatTheWindowLeavesThem) {
    openLambda();
    const auto widths = [&] {
        QTest::qWait(50);
        std::vector<int> all;
        for (const QTabBar* bar : window.findChildren<QTabBar*>())
            for (int i = 0; bar->isVisible() && i < bar->count(); ++i) all.push_back(bar->tabRect(i).width());
        return all;
    };
    window.resize(1000, 700);
    const std::vector<int> narrow = widths();
    window.resize(1500, 900);
    const std::vector<int> wide = widths();
    ASSERT_EQ(narrow.size(), wide.size());
    ASSERT_GT(wide.size(), 4u);
    for (std::size_t i = 0; i < wide.size(); ++i) EXPECT_GT(wide[i], narrow[i]) << i;
    window.resize(1000, 700);
    EXPECT_EQ(widths(), narrow);
    window.resize(1500, 900);
    EXPECT_EQ(widths(), wide);
}

TEST_F(Arrangements, AnEffectIsTriedByTheButtonBesideItsRow) {
    openLambda();
    run(RunKind::Discover);
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return results->candidates() != nullptr; }, 5000));
    QTreeWidget* list = results->candidates();
    QTreeWidgetItem* row = nullptr;
    for (int i = 0; i < list->topLevelItemCount() && !row; ++i)
        if (list->topLevelItem(i)->toolTip(0).contains("thermal.resistance")) row = list->topLevelItem(i);
    ASSERT_TRUE(row);
    auto* button = qobject_cast<QToolButton*>(list->itemWidget(row, 5));
    ASSERT_TRUE(button);
    results->ensureWidgetVisible(button);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_TRUE(window.controller().isRunning());
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window.controller().isRunning(); }, 60000));
    EXPECT_EQ(document().history().size(), 2u);
}

}  // namespace analogon::ui
