#include "ui/words/window_words.hpp"

#include <QDirIterator>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <QStatusBar>
#include <QToolButton>
#include <QTreeWidget>
#include <set>

#include "tests/ui/panels_fixture.hpp"
#include "ui/inspector/parameter_panel.hpp"
#include "ui/measurement/measurement_panel.hpp"
#include "ui/messages/message_panel.hpp"
#include "ui/style/style.hpp"
#include "ui/style/translator.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {
namespace {

/// Whether a sentence tells how something is written down in a study.json: an object, a member, one of its words.
bool speaksOfFile(const QString& sentence) {
    static const QRegularExpression file(
        R"re(\{\{|"[a-z_]+"\s*:|study\.json|"(?:range|use|read|clock|initial|raster|value|fit|validate|)re"
        R"re(weight|inputs|outputs|parameters|decimal|thousands|time|time_zone|time_format|interpolation|)re"
        R"re(hold|linear|scale|lin|role|column|group|unit|skip|separator)")re");
    return sentence.contains(file);
}

/// Of the stages that look at studies and recordings. What reads a study.json speaks of that text, at its place; the
/// braces of models are Modelica.
bool isAboutStudies(const QString& path) {
    static const QRegularExpression stages(
        "/core/(?:archive|base|effect|export|fit|measure|report|residual|simulate|study)/");
    static const QRegularExpression others("/core/(?:effect/catalogue/|study/(?:study_json|json_fault)\\.cpp)");
    return path.contains(stages) && !path.contains(others);
}

std::set<std::string> sentencesAboutStudies() {
    static const QRegularExpression call(R"re(\bphrase\(\s*((?:"(?:\\.|[^"\\])*"\s*)+))re"),
        literal(R"re("((?:\\.|[^"\\])*)")re");
    std::set<std::string> sentences;
    for (QDirIterator files(ANALOGON_ROOT "/core", {"*.cpp", "*.hpp"}, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext();) {
        QFile file(files.next());
        if (!isAboutStudies(file.fileName()) || !file.open(QIODevice::ReadOnly)) continue;
        const QString source = QString::fromUtf8(file.readAll());
        for (auto calls = call.globalMatch(source); calls.hasNext();) {
            QString pattern;
            for (auto parts = literal.globalMatch(calls.next().captured(1)); parts.hasNext();)
                pattern += parts.next().captured(1);
            sentences.insert(pattern.replace("\\n", "\n").replace("\\\"", "\"").replace("\\\\", "\\").toStdString());
        }
    }
    return sentences;
}

TEST(WindowWords, AreThereForEverySentenceThatTellsHowAStudyIsWrittenDown) {
    Translator german;
    ASSERT_TRUE(german.loadLanguage("de"));
    int count = 0;
    for (const std::string& sentence : sentencesAboutStudies()) {
        if (!speaksOfFile(QString::fromStdString(sentence))) continue;
        ++count;
        const char* const words = windowPattern(sentence);
        EXPECT_TRUE(words) << sentence;
        if (!words) continue;
        const QString translated = german.translate("WindowWords", words, nullptr, -1);
        for (const QString& said : {QString::fromUtf8(words), translated})
            EXPECT_FALSE(speaksOfFile(said)) << said.toStdString();
        EXPECT_FALSE(translated.isEmpty()) << words;
    }
    EXPECT_GT(count, 40);
}

TEST(WindowWords, FillTheSameArguments) {
    EXPECT_EQ(inWords(phrase("Say which it is in the study: {{\"column\": \"{}\", \"unit\": \"{}\"}} or {{\"column\": "
                             "\"{}\", \"unit\": \"{}\"}}.",
                             "t", "s", "t", "ms")),
              "Say which it is in the header of the file: t [s] or t [ms].");
}

class WindowMessages : public Panels {
protected:
    /// All that the window says at the moment.
    QStringList said() {
        QStringList texts{window.statusBar()->currentMessage()};
        const QListWidget* const list = panel<MessagePanel>()->list();
        for (int i = 0; i < list->count(); ++i) texts << list->item(i)->text();
        const QTreeWidget* const tree = panel<MeasurementPanel>()->tree();
        for (int i = 0; i < tree->topLevelItemCount(); ++i) texts << tree->topLevelItem(i)->toolTip(0);
        return texts;
    }
    void expectWords(const char* fault) {
        for (const QString& text : said()) {
            EXPECT_FALSE(speaksOfFile(text)) << fault << ": " << text.toStdString();
            EXPECT_FALSE(text.contains('{')) << fault << ": " << text.toStdString();
        }
    }
    QListWidgetItem* message(const QString& part) {
        QListWidget* const list = panel<MessagePanel>()->list();
        for (int i = 0; i < list->count(); ++i)
            if (list->item(i)->text().contains(part)) return list->item(i);
        return nullptr;
    }
    void spoil(const char* fault, const std::function<void(StudySettings&)>& edit) {
        StudySettings settings = document().settings();
        edit(settings);
        document().applySettings(std::move(settings), fault);
    }
};

TEST_F(WindowMessages, OfFaultyStudiesSayWhatToDoInTheWindow) {
    const auto all = [](StudySettings& s, const std::function<void(StudyExperiment&)>& edit) {
        for (StudyExperiment& e : s.experiments) edit(e);
    };
    using Edit = std::function<void(StudySettings&)>;
    const std::pair<const char*, Edit> faults[] = {
        {"input without a column", [&](auto& s) { all(s, [](auto& e) { e.inputs.erase(e.inputs.begin()); }); }},
        {"none is used", [&](auto& s) { all(s, [](auto& e) { e.isUsed = false; }); }},
        {"none to fit", [&](auto& s) { all(s, [](auto& e) { e.role = Role::Validate; }); }},
        {"weights of 0",
         [&](auto& s) {
             all(s, [](auto& e) {
                 for (auto& [name, mapping] : e.outputs) mapping.weight = 0;
             });
         }},
        {"no time", [&](auto& s) { all(s, [](auto& e) { e.timeColumn.clear(); }); }},
        {"output as an input", [&](auto& s) { all(s, [](auto& e) { e.inputs["i_mod"] = e.inputs.begin()->second; }); }},
        {"nothing to fit",
         [&](auto& s) {
             for (auto& [name, parameter] : s.parameters) parameter.fit = false;
         }},
        {"start beyond its bounds",
         [&](auto& s) {
             for (auto& [name, parameter] : s.parameters) parameter.min = 1e9, parameter.max = 2e9;
         }},
        {"clock of an output to fit without a mapping", [&](auto& s) { s.parameters["clock.i_mod"].value = 0.5; }},
    };
    openLambda();
    for (const auto& [fault, edit] : faults) {
        spoil(fault, edit);
        QTest::qWait(400);
        expectWords(fault);
        run(RunKind::Fit);
        expectWords(fault);
        run(RunKind::Simulate);
        expectWords(fault);
        EXPECT_FALSE(panel<MessagePanel>()->list()->count() == 0 && window.statusBar()->currentMessage().isEmpty())
            << fault;
        document().undoStack().undo();
        QTest::qWait(50);
    }
}

TEST_F(WindowMessages, WhatHasNoColumnYetIsAGreyHintUntilARunIsAskedFor) {
    openLambda();
    spoil("take the columns away", [](StudySettings& s) {
        for (StudyExperiment& e : s.experiments) e.inputs.erase(e.inputs.begin());
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return message("has no column") != nullptr; }, 20000));
    const QColor hint = message("has no column")->foreground().color();
    EXPECT_FALSE(window.findChild<QToolButton*>("why-no-run")->isVisible());
    run(RunKind::Fit);
    ASSERT_TRUE(message("has no column"));
    EXPECT_NE(message("has no column")->foreground().color(), hint) << "a run was asked for, and this stops it";
    document().undoStack().undo();
    EXPECT_TRUE(QTest::qWaitFor([&] { return message("has no column") == nullptr; }, 20000));
}

TEST_F(WindowMessages, WhatIsNotConnectedYetIsAGreyHintUntilARunIsAskedFor) {
    openLambda();
    const QString text = document().modelText();
    const auto at = text.indexOf("equation");
    ASSERT_GT(at, 0);
    document().typeText(text.left(at) + "  Analogon.Signals.Gain loose;\n" + text.mid(at));
    ASSERT_TRUE(QTest::qWaitFor([&] { return message("is not connected") != nullptr; }, 20000));
    const QColor hint = message("is not connected")->foreground().color();
    auto* why = window.findChild<QToolButton*>("why-no-run");
    EXPECT_TRUE(why->isVisible());
    EXPECT_EQ(why->text(), "Not connected yet: no run");
    window.findChild<QDockWidget*>("messages")->raise();
    QTest::qWait(50);
    window.grab().save(QStringLiteral(ANALOGON_PICTURES) + "/not-connected.png");
    window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
    QTest::keyClick(&window, Qt::Key_F5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return message("is not connected")->foreground().color() != hint; }, 5000));
    EXPECT_TRUE(panel<MessagePanel>()->isVisible());
}

/// As while a model is wired with the mouse.
TEST_F(WindowMessages, AnOutputThatNothingLeadsToYetIsAGreyHint) {
    openLambda();
    const QString text = document().modelText();
    QString open = text;
    window.findChild<QDockWidget*>("traces")->raise();
    QTest::qWait(50);
    const auto isSeen = [&] { return !panel<MessagePanel>()->visibleRegion().isEmpty(); };
    ASSERT_FALSE(isSeen()) << "behind another tab";
    document().typeText(open.remove(QRegularExpression("\\n\\s*connect\\(heater\\.i, i_mod\\)[^;]*;")));
    ASSERT_NE(open, text);
    ASSERT_TRUE(QTest::qWaitFor([&] { return message("too few") != nullptr; }, 20000));
    EXPECT_TRUE(message("too few")->text().contains("Nothing leads to i_mod yet"))
        << message("too few")->text().toStdString();
    EXPECT_EQ(message("too few")->foreground().color(), style::mutedText(window.palette()));
    EXPECT_EQ(window.findChild<QToolButton*>("why-no-run")->text(), "Not connected yet: no run");
    QStringList said;
    auto* list = panel<MessagePanel>()->findChild<QListWidget*>();
    for (int i = 0; i < list->count(); ++i) said << list->item(i)->text();
    EXPECT_FALSE(isSeen()) << "it comes by itself for errors alone: " << said.join(" | ").toStdString();
    bool isSaid = false;
    for (const QLabel* label : panel<ParameterPanel>()->findChildren<QLabel*>())
        isSaid = isSaid || (label->isVisible() && label->text().startsWith("Not connected yet"));
    EXPECT_TRUE(isSaid);
}

}  // namespace
}  // namespace analogon::ui
