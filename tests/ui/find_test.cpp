#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QTreeView>
#include <QTreeWidget>

#include "tests/ui/by_mouse.hpp"
#include "tests/ui/panels_fixture.hpp"
#include "tests/ui/sample_finding.hpp"
#include "ui/effect/result_panel.hpp"
#include "ui/inspector/parameter_model.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/library/chooser.hpp"
#include "ui/library/library_model.hpp"
#include "ui/library/library_panel.hpp"
#include "ui/library/search_words.hpp"
#include "ui/signals/signal_browser.hpp"
#include "ui/text/find_bar.hpp"
#include "ui/text/text_view.hpp"

namespace analogon::ui {

namespace {

TEST(SearchWords, FindWhatEngineersCallTheSame) {
    const QString machine = "BasicElectricMechanical Direct-current machine with permanent field";
    for (const char* typed :
         {"motor", "dc", "Machine", "Gleichstrom", "mechanical", "motors", "antrieb", "field motor"})
        EXPECT_TRUE(isFoundIn(machine, typed)) << typed;
    for (const char* typed : {"pump", "heizung", "motor pump", "d", "xyz"})
        EXPECT_FALSE(isFoundIn("Gain Signal times a constant", typed)) << typed;
    EXPECT_TRUE(isFoundIn("Inertia Rigid body on a shaft", "mass"));
    EXPECT_TRUE(isFoundIn("Inertia Rigid body on a shaft", QString::fromUtf8("Trägheit")));
    EXPECT_TRUE(isFoundIn("Inertia Rigid body on a shaft", "traegheit"));
    EXPECT_TRUE(isFoundIn("Inertia", "")) << "nothing was asked";
    EXPECT_FALSE(isFoundIn("Elastomer Body of rubber", "motor")) << "a word begins with what is meant";
}

/// All that a user looks for, in the library and in the palette of the keyboard.
class Find : public Panels {
protected:
    void showText() { test::clickTabOf(window, panel<TextView>()); }
    /// The blocks that are left in the tree.
    QStringList left(const QModelIndex& parent = {}) const {
        const QAbstractItemModel* model = panel<LibraryPanel>()->tree()->model();
        QStringList names;
        for (int row = 0; row < model->rowCount(parent); ++row) {
            const QModelIndex index = model->index(row, 0, parent);
            if (!index.data(LibraryModel::IsPackageRole).toBool()) names << index.data().toString();
            names += left(index);
        }
        return names;
    }
};

}  // namespace

TEST_F(Find, LibraryKnowsOtherWordsAndSaysWhenNothingIsFound) {
    openLambda();
    auto* library = panel<LibraryPanel>();
    const qsizetype all = left().size();
    const std::pair<const char*, const char*> wanted[] = {
        {"motor", "BasicElectricMechanical"}, {"dc", "BasicElectricMechanical"},
        {"heater", "BasicElectricThermal"},   {"pump", "QuadraticLoad"},
        {"resistor", "BasicElectricThermal"}, {"mass", "Inertia"},
        {"Heizung", "BasicElectricThermal"},  {"Feder", "SpringDamper"},
        {"Getriebe", "BasicMechanics"}};
    for (const auto& [typed, block] : wanted) {
        library->search()->clear();
        QTest::keyClicks(library->search(), typed);
        EXPECT_TRUE(left().contains(block)) << typed;
        EXPECT_LT(left().size(), all) << typed;
        EXPECT_TRUE(library->nothingFound()->isHidden()) << typed;
    }
    library->search()->clear();
    QTest::keyClicks(library->search(), "zzz");
    EXPECT_TRUE(left().isEmpty());
    EXPECT_FALSE(library->nothingFound()->isHidden());
    EXPECT_TRUE(library->nothingFound()->text().contains("zzz"));
    library->search()->clear();
    EXPECT_TRUE(library->nothingFound()->isHidden());
    EXPECT_EQ(left().size(), all);
}

TEST_F(Find, PaletteKnowsOtherWordsAndSaysWhenNothingIsFound) {
    Chooser chooser(&window);
    QString taken;
    chooser.choose("Insert", {{"Inertia", "Rigid body on a shaft", "I", {}}, {"Gain", "Signal times", "G", {}}}, {},
                   [&](const QString& key) { taken = key; });
    QTest::keyClicks(chooser.field(), "masse");
    ASSERT_EQ(chooser.list()->count(), 1);
    EXPECT_TRUE(chooser.list()->item(0)->text().startsWith("Inertia"));
    QTest::keyClicks(chooser.field(), "zzz");
    ASSERT_EQ(chooser.list()->count(), 1);
    EXPECT_TRUE(chooser.list()->item(0)->text().contains("massezzz"));
    QTest::keyClick(chooser.field(), Qt::Key_Return);
    EXPECT_TRUE(taken.isEmpty()) << "what is said of a search is nothing to choose";
    chooser.field()->setText("masse");
    QTest::keyClick(chooser.field(), Qt::Key_Return);
    EXPECT_EQ(taken, "I");
}

TEST(FindBarInANarrowText, HasItsCountBesideTheField) {
    QPlainTextEdit text;
    FindBar bar(text);
    text.resize(320, 200);
    text.show();
    text.setPlainText("heater heater");
    bar.open();
    bar.field()->setText("heater");
    QTest::qWait(20);
    EXPECT_LE(bar.geometry().right(), text.width());
    EXPECT_GT(bar.count()->geometry().left(), bar.field()->geometry().right());
    EXPECT_GE(bar.count()->width(), bar.count()->fontMetrics().horizontalAdvance(bar.count()->text()));
}

TEST_F(Find, FindsInTheModelTextAndLeavesItAsItIs) {
    openLambda();
    auto* text = panel<TextView>();
    showText();
    ASSERT_TRUE(text->isVisible());
    QTest::mouseClick(text->viewport(), Qt::LeftButton);
    const QString before = text->toPlainText();
    const int places = static_cast<int>(before.count("heater", Qt::CaseInsensitive));
    ASSERT_GT(places, 2);
    text->moveCursor(QTextCursor::Start);
    QTest::keyClick(text, Qt::Key_F, Qt::ControlModifier);
    FindBar* bar = text->findBar();
    ASSERT_TRUE(bar->isVisible());
    QTest::keyClicks(bar->field(), "heater");
    EXPECT_EQ(bar->places().size(), places);
    EXPECT_EQ(bar->count()->text(), QStringLiteral("1 of %1").arg(places));
    EXPECT_EQ(text->textCursor().selectedText().toLower(), "heater");
    EXPECT_GE(text->extraSelections().size(), places);
    QTest::keyClick(bar->field(), Qt::Key_Return);
    EXPECT_EQ(bar->count()->text(), QStringLiteral("2 of %1").arg(places));
    QTest::keyClick(bar->field(), Qt::Key_F3, Qt::ShiftModifier);
    QTest::keyClick(bar->field(), Qt::Key_F3, Qt::ShiftModifier);
    EXPECT_EQ(bar->count()->text(), QStringLiteral("%1 of %1").arg(places)) << "round the end";
    QTest::keyClicks(bar->field(), "zzz");
    EXPECT_EQ(bar->count()->text(), "not found");
    QTest::keyClick(bar->field(), Qt::Key_Escape);
    EXPECT_FALSE(bar->isVisible());
    EXPECT_TRUE(text->hasFocus());
    EXPECT_TRUE(text->extraSelections().isEmpty());
    EXPECT_EQ(text->toPlainText(), before) << "no letter of it went into the model";
    EXPECT_FALSE(document().isModified());
}

TEST_F(Find, UnderlinesWhatMessagesSpeakOf) {
    openLambda();
    auto* text = panel<TextView>();
    showText();
    const auto underlined = [&] {
        QStringList words;
        for (const QTextEdit::ExtraSelection& s : text->extraSelections())
            if (s.format.underlineStyle() == QTextCharFormat::WaveUnderline) words << s.cursor.selectedText();
        return words;
    };
    EXPECT_TRUE(underlined().isEmpty());
    const QString good = document().modelText();
    QString bad = good;
    bad.replace("equation", "equation\n  nosuchname = 1;");
    document().typeText(bad);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !underlined().isEmpty(); }, 10000));
    EXPECT_TRUE(underlined().join(' ').contains("nosuchname"));
    document().typeText(good);
    EXPECT_TRUE(QTest::qWaitFor([&] { return underlined().isEmpty(); }, 10000));
}

/// Wherever the keys are within the panel, also where its table takes letters as the begin of an edit.
TEST_F(Find, LeadsToTheSearchOfThePanelThatHasTheKeys) {
    openLambda();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().facts().parameters.empty(); }, 20000));
    const auto find = [&](const char* dock, QWidget* keys, QLineEdit* field) {
        window.findChild<QDockWidget*>(dock)->raise();
        QTest::qWait(20);
        keys->setFocus();
        EXPECT_FALSE(field->hasFocus()) << dock;
        QTest::keyClick(keys, Qt::Key_F, Qt::ControlModifier);
        EXPECT_TRUE(field->hasFocus()) << dock;
        QTest::keyClicks(field, "heater");
        EXPECT_EQ(field->text(), "heater") << dock;
        QTest::keyClick(field, Qt::Key_F, Qt::ControlModifier);
        EXPECT_EQ(field->selectedText(), "heater") << dock;
    };
    auto* parameters = panel<ParameterPanel>();
    find("parameters", parameters->table(), parameters->findChild<QLineEdit*>());
    for (int row = 0; row < parameters->model()->rowCount(); ++row)
        EXPECT_TRUE(parameters->model()->index(row, 0).data().toString().contains("heater"));
    auto* browser = panel<SignalBrowser>();
    find("signals", browser->findChild<QTreeView*>(), browser->searchField());
    find("library", panel<LibraryPanel>()->tree(), panel<LibraryPanel>()->search());
    RunResult result = sampleFinding(document(), "thermal.radiation", "Analogon.Effects.Thermal.Radiation", "radiation",
                                     "element.solid", "port", "k_r");
    document().setResult(RunKind::Discover, result, document().study());
    auto* results = panel<ResultPanel>();
    ASSERT_TRUE(QTest::qWaitFor([&] { return results->candidateFilter() != nullptr; }, 5000));
    QTest::qWait(50);
    find("result", results->candidates(), results->candidateFilter());
}

}  // namespace analogon::ui
