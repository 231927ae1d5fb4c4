#include "ui/words/words.hpp"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTextBrowser>

#include "core/base/unit.hpp"
#include "core/flat/flat_model.hpp"
#include "core/measure/table.hpp"
#include "core/measure/text/text_recording.hpp"
#include "core/structure/structure.hpp"
#include "core/study/generate.hpp"
#include "core/study/study.hpp"
#include "core/syntax/parser.hpp"
#include "ui/style/translator.hpp"

namespace analogon::ui {
namespace {

class GermanWords : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(german.loadLanguage("de"));
        QCoreApplication::installTranslator(&german);
    }
    void TearDown() override { QCoreApplication::removeTranslator(&german); }
    Translator german;
};

TEST(Words, AreEnglishWithoutATranslation) {
    EXPECT_EQ(inWords(phrase("no {} in {:.2f}", "word", 1.5)), "no word in 1.50");
    EXPECT_EQ(inWords("heater.R"), "heater.R");
}

TEST_F(GermanWords, SayPatternArgumentsAndWhatFollows) {
    EXPECT_EQ(inWords(phrase("{} rests at its lower bound {:.6g}", "R", 0.25)), "R liegt an der unteren Grenze 0,25");
    EXPECT_EQ(inWords(phrase("{} cannot be told apart from these data: fix one", listed({"R", "k"}))),
              "R und k lassen sich mit diesen Daten nicht unterscheiden: einen festhalten");
    EXPECT_EQ(inWords(phrase("A prior is {{\"mean\": …, \"std\": …}}.")),
              QString::fromUtf8("Vorwissen ist {\"mean\": …, \"std\": …}."));
    EXPECT_EQ(inWords(phrase("{} rests at its lower bound {:.6g}", "stage.2.5", 0.25)),
              "stage.2.5 liegt an der unteren Grenze 0,25")
        << "a name is no number";
    EXPECT_EQ(inWords(phrase("{} with {}", "y = 0.5*u", phrase("{} = {:.4g}{}", "k", 1.5, " V"))),
              "y = 0.5*u mit k = 1,5 V")
        << "a formula is text of a model";
    EXPECT_EQ(linkedWords(phrase("{} rests at its lower bound {:.6g}", "R", 0.25),
                          [](const QString& name) { return name == "R" ? QString("there") : QString(); }),
              "<a href=\"there\">R</a> liegt an der unteren Grenze 0,25");
    Text two = phrase("The model is singular.");
    two += phrase(" No equation determines {}.", "x");
    EXPECT_EQ(inWords(two), "Das Modell ist singulär. Keine Gleichung bestimmt x.");
}

/// What a widget and all in it show, mnemonics left out.
QStringList textsOf(const QWidget& widget) {
    QStringList texts;
    const auto add = [&](QString text) {
        text.remove('&');
        if (text.contains(QRegularExpression("[a-z]{2}"))) texts << text;
    };
    for (const auto* label : widget.findChildren<QLabel*>()) add(label->text());
    for (const auto* button : widget.findChildren<QAbstractButton*>()) add(button->text()), add(button->toolTip());
    for (const auto* action : widget.findChildren<QAction*>()) add(action->text());
    for (const auto* view : widget.findChildren<QHeaderView*>())
        for (int i = 0; view->model() && i < view->model()->columnCount(); ++i)
            add(view->model()->headerData(i, Qt::Horizontal).toString());
    return texts;
}

TEST_F(GermanWords, SpeakInTheDialogsOfTheToolkitToo) {
    const auto dialogs = [] {
        QStringList texts;
        QFileDialog file(nullptr, QString(), "/nowhere/at/all");
        file.setOption(QFileDialog::DontUseNativeDialog);
        texts += textsOf(file);
        file.setAcceptMode(QFileDialog::AcceptSave);
        texts += textsOf(file);
        file.setFileMode(QFileDialog::Directory);
        texts += textsOf(file);
        QMessageBox question;
        question.setStandardButtons(QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel | QMessageBox::Yes |
                                    QMessageBox::No | QMessageBox::Close);
        texts += textsOf(question);
        QLineEdit line;
        QPlainTextEdit text;
        QTextBrowser browser;
        for (QMenu* menu : {line.createStandardContextMenu(), text.createStandardContextMenu(),
                            browser.createStandardContextMenu()}) {
            for (const QAction* action : menu->actions()) texts << action->text().section('\t', 0, 0).remove('&');
            delete menu;
        }
        texts.removeAll(QString());
        return texts;
    };
    const QStringList inGerman = dialogs();
    QCoreApplication::removeTranslator(&german);
    const QStringList inEnglish = dialogs();
    QCoreApplication::installTranslator(&german);
    ASSERT_GT(inEnglish.size(), 30);
    for (const QString& text : inGerman) {
        if (text == "Name" || text == "Computer") continue;  // the same word in both
        EXPECT_FALSE(inEnglish.contains(text)) << text.toStdString();
    }
}

/// One English word may be an order and a name; German has two for them.
TEST_F(GermanWords, TellTheButtonFromTheRunItStarts) {
    const auto said = [](const char* context) { return QCoreApplication::translate(context, "Fit"); };
    EXPECT_EQ(said("analogon::ui::MainWindow"), "Anpassen");
    EXPECT_EQ(said("analogon::ui::FitPanel"), "Anpassung");
    EXPECT_EQ(said("analogon::ui::RunController"), "Anpassung");
    EXPECT_EQ(QCoreApplication::translate("analogon::ui::Another", "Cancel"), "Abbrechen") << "said once for all";
}

TEST_F(GermanWords, DocumentBlocksAndLeaveTheirFormulas) {
    EXPECT_EQ(
        libraryDocumentation("\n<p>Reads the speed of a flange\nand takes no torque.</p>\n<pre>w = der(phi)</pre>"),
        QString::fromUtf8("\n<p>Liest die Drehzahl eines Flansches und nimmt kein Drehmoment auf.</p>\n"
                          "<pre>w = der(phi)</pre>"));
    EXPECT_EQ(libraryText("Resistance at T_ref"), "Widerstand bei T_ref");
}

TEST_F(GermanWords, NameFaultsOfARecordingAndOfAStudy) {
    const Outcome<Table> table = textTables("t;u\n0;1\n1;abc\n", "run.csv");
    ASSERT_FALSE(table);
    EXPECT_EQ(inWords(table.diagnostics().front().message), QString::fromUtf8("„abc“ in Spalte „u“ ist keine Zahl"));
    const Outcome<Study> study =
        parseStudyJson(std::make_shared<Source>("study.json", R"({"format": "analogon-study-1", "class": 3})"));
    ASSERT_FALSE(study);
    const Diagnostics& faults = study.diagnostics();
    EXPECT_EQ(inWords(faults.front().message),
              QString::fromUtf8("class: erwartet: ein Text, der nicht leer ist, gefunden: die Zahl 3"));
    for (const Diagnostic& fault : faults) EXPECT_NE(inWords(fault.message).toStdString(), fault.message.english());
}

/// The equations of the model M in a text.
Outcome<FlatModel> flatM(const char* text) {
    Study study;
    study.className = "M";
    study.models[study.modelFile] = text;
    const Outcome<Library> library = studyLibrary(study);
    EXPECT_TRUE(library);
    return flatten(*library, "M");
}

TEST_F(GermanWords, NameFaultsOfAModel) {
    const auto said = [](const char* text) {
        const Outcome<FlatModel> model = flatM(text);
        EXPECT_FALSE(model);
        const Diagnostic& fault = model.diagnostics().front();
        return inWords(fault.message) + " | " + inWords(fault.hint);
    };
    EXPECT_EQ(said("model M\n  Real x;\n  Real y;\nequation\n  x = 1;\nend M;\n"),
              QString::fromUtf8("Modell „M“ hat 1 Gleichung für 2 Unbekannte: 1 zu wenig | "
                                "in keiner Gleichung steht y"));
    EXPECT_EQ(said("model M\n  parameter Real gain = 2;\n  Real x;\nequation\n  x = gian;\nend M;\n"),
              QString::fromUtf8("„gian“ ist in Modell „M“ nicht deklariert | ist „gain“ gemeint?"));
}

/// What was assumed for a first model: every sentence, and no number with a point.
TEST_F(GermanWords, SayWhatAGeneratedStudyAssumes) {
    const Outcome<Library> library = builtInLibrary();
    ASSERT_TRUE(library);
    const auto table = [](const char* text) {
        Outcome<Table> read = textTables(text, "run.csv");
        EXPECT_TRUE(read);
        return std::make_shared<const Table>(std::move(*read));
    };
    const GenerateRequest heater{{"electric-thermal", "thermal-fluid"},
                                 {table("t_s,u [V],i [A],T_air [degC]\n0,0,0,20\n0.15,12,1.5,20\n0.3,12,1.4,20\n"
                                        "0.45,12,1.35,20\n0.6,12,1.3,20\n")}},
        motor{{"electric-mechanical", "mechanics"},
              {table("t [s],duty [%],i [A],n [rpm]\n0,0,0,0\n0.1,50,1,900\n0.2,50,1.1,950\n0.3,50,1.2,1000\n")}};
    for (const GenerateRequest& request : {heater, motor}) {
        const Outcome<GeneratedStudy> made = generateStudy(*library, request);
        ASSERT_TRUE(made) << format(made.diagnostics());
        EXPECT_GT(made->assumptions.size(), 8u);
        for (const Text& assumption : made->assumptions) {
            const QString said = inWords(assumption);
            EXPECT_NE(said.toStdString(), assumption.english());
            EXPECT_FALSE(said.contains(QRegularExpression(R"(\d\.\d)"))) << said.toStdString();
        }
    }
}

/// Faults of the text itself, as they come up while a model is typed.
TEST_F(GermanWords, NameFaultsOfSyntax) {
    const auto said = [](const char* text) {
        const auto parsed = syntax::parse(std::make_shared<const Source>("model.mo", text));
        QStringList faults;
        for (const Diagnostic& fault : parsed.diagnostics)
            faults << inWords(fault.message) + (fault.hint.empty() ? QString() : " | " + inWords(fault.hint));
        return faults.join("\n");
    };
    EXPECT_EQ(said("model M\n  Real x\nequation\n  x = 1;\nend M;\n"),
              QString::fromUtf8("erwartet: „;“ nach der Deklaration"));
    EXPECT_EQ(said("model M\n  Real x(start=1;\nequation\n  x = 1;\nend M;\n"),
              QString::fromUtf8("erwartet: „)“ zum Schließen der Modifikationen, gefunden: „;“"));
    EXPECT_EQ(said("model M\n  Real x;\nequation\n  x := 1;\nend M;\n"),
              QString::fromUtf8("„:=“ ist eine Zuweisung eines Algorithmus | eine Gleichung wird mit „=“ geschrieben"));
    EXPECT_EQ(said("model M\n  Real x;\nalgorithm\n  x = 2;\nend N;\n"),
              QString::fromUtf8("„=“ ist eine Gleichung | eine Anweisung schreibt man mit „:=“\n"
                                "„M“ ist mit dem Namen „N“ abgeschlossen | „end M;“ schreiben"));
    EXPECT_EQ(said("model M\n  Real x;\nequation\n  if x > 0 then\n    x = 1;\nend M;\n"),
              QString::fromUtf8("erwartet: „if“ hinter „end“, gefunden: „M“ | der innerste offene Block ist „if“"));
    EXPECT_EQ(
        said("model M\n  Real \"x\";\nend M;\n"),
        QString::fromUtf8("erwartet: der Name einer Komponente vom Typ „Real“, gefunden: die Zeichenkette \"x\""));
}

/// The sources of the core, and of what the program that works on a campaign tells the window.
QStringList sourcesWithSentences() {
    QStringList sources{ANALOGON_ROOT "/app/analogon-cli/campaign.cpp"};
    for (QDirIterator files(ANALOGON_ROOT "/core", {"*.cpp", "*.hpp"}, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext();)
        sources += files.next();
    return sources;
}

/// Every sentence that is made by phrase(), or by what the parser expects, has a German one, with a place for each of
/// its arguments.
TEST_F(GermanWords, AreThereForEverySentenceOfTheCore) {
    static const QRegularExpression call(
        R"re((?:\bphrase\(|\bexpect(?:Identifier|Semicolon)\(|\bexpect\((?:[^,()"]+|"[^"]*"),))re"
        R"re(\s*((?:"(?:\\.|[^"\\])*"\s*)+))re");
    static const QRegularExpression literal(R"re("((?:\\.|[^"\\])*)")re"), field(R"re(\{[^{}]*\})re");
    const auto fields = [](QString text) { return text.replace("{{", "").replace("}}", "").count(field); };
    int count = 0;
    for (const QString& name : sourcesWithSentences()) {
        QFile file(name);
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        const QString source = QString::fromUtf8(file.readAll());
        for (auto calls = call.globalMatch(source); calls.hasNext(); ++count) {
            QString pattern;
            for (auto parts = literal.globalMatch(calls.next().captured(1)); parts.hasNext();)
                pattern += parts.next().captured(1);
            pattern.replace("\\n", "\n").replace("\\\"", "\"").replace("\\\\", "\\");
            EXPECT_TRUE(german.knows(pattern)) << file.fileName().toStdString() << ": " << pattern.toStdString();
            const QString translated = QCoreApplication::translate("core", pattern.toUtf8().constData());
            EXPECT_EQ(fields(translated), fields(pattern)) << pattern.toStdString();
        }
    }
    EXPECT_GT(count, 400);
}

/// Words that were put together before a diagnostic is made of them have no pattern, and stay English.
TEST_F(GermanWords, AreWhatEveryDiagnosticIsMadeOf) {
    static const QRegularExpression english(
        R"re(\b(?:error|warning|fileError|numericalError|refuse|complain|warn)\(\s*(?:fmt::format\(|"[A-Za-z{'])[^;]*)re");
    for (QDirIterator files(ANALOGON_ROOT "/core", {"*.cpp", "*.hpp"}, QDir::Files, QDirIterator::Subdirectories);
         files.hasNext();) {
        QFile file(files.next());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        for (auto found = english.globalMatch(QString::fromUtf8(file.readAll())); found.hasNext();)
            ADD_FAILURE() << file.fileName().toStdString() << ": " << found.next().captured().toStdString();
    }
}

/// Faults of the later stages: structure, fit, units, diagrams.
TEST_F(GermanWords, NameWhatTheAnalysisFinds) {
    const auto said = [](const char* text) {
        Outcome<FlatModel> model = flatM(text);
        if (!model) return inWords(model.diagnostics().front().message);
        const Outcome<Structure> structure = analyse(std::make_shared<const FlatModel>(std::move(*model)));
        EXPECT_FALSE(structure);
        return structure ? QString() : inWords(structure.diagnostics().front().message);
    };
    EXPECT_EQ(said("model M\n  Real x;\nequation\n  x = max(1, 2, 3);\nend M;\n"),
              QString::fromUtf8("„max“ braucht 2 Argumente, nicht 3"));
    EXPECT_EQ(said("model M\n  Real x = {1, 2} + 3;\nend M;\n").section("(", 0, 0),
              QString::fromUtf8("„+“ lässt sich nicht auf Integer[2] und Integer anwenden"));
    EXPECT_EQ(
        said("model M\n  Real x(start = 0.5, fixed = true);\n  Real y(start = 1.5, fixed = true);\nequation\n"
             "  x = y;\n  der(x) = 1;\nend M;\n"),
        QString::fromUtf8("„x“ und „y“ sind dieselbe Größe, aber ihre Startwerte sind auf 0,5 und 1,5 festgelegt."));
    const Outcome<UnitConversion> conversion = convertUnit("K", "V");
    ASSERT_FALSE(conversion);
    EXPECT_EQ(inWords(conversion.diagnostics().front().message),
              QString::fromUtf8("„K“ lässt sich nicht in „V“ umrechnen: Sie messen verschiedene Größen"));
}

/// "Unit" is one of a series for a campaign, and of measurement everywhere else.
TEST(Translation, OfAWordWithTwoMeaningsIsThatOfItsPlace) {
    Translator german;
    ASSERT_TRUE(german.loadLanguage("de"));
    for (const char* place : {"ParameterModel", "ResultPanel", "MeasurementPanel", "SignalModel", "ChannelBrowser"})
        EXPECT_EQ(german.translate((std::string("analogon::ui::") + place).c_str(), "Unit", nullptr, -1), "Einheit")
            << place;
    EXPECT_EQ(german.translate("analogon::ui::UnitsModel", "Unit", nullptr, -1), "Exemplar");
}

}  // namespace
}  // namespace analogon::ui
