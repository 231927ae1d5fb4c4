#include "ui/text/name_completion.hpp"

#include <QAbstractItemView>
#include <QCompleter>
#include <QTabBar>
#include <QTabWidget>

#include "tests/ui/panels_fixture.hpp"
#include "tests/working_time.hpp"
#include "ui/text/name_popup.hpp"
#include "ui/text/text_view.hpp"

namespace analogon::ui {
namespace {

class NameCompletion : public Panels {
protected:
    QStringList offered(const QString& typed, const QString& behind = "equation\n") {
        const QString whole = document().modelText();
        const qsizetype at = whole.indexOf(behind) + behind.size();
        QStringList names;
        for (const NameOffer& offer :
             nameOffers(document().library(), document().definition()->name, whole.left(at) + typed).offers)
            names << offer.name;
        return names;
    }
    TextView* showText() {
        auto* text = panel<TextView>();
        for (QTabWidget* tabs : window.findChildren<QTabWidget*>())
            if (const int tab = tabs->indexOf(text); tab >= 0) tabs->setCurrentIndex(tab);
        text->setFocus();
        QTest::qWait(20);
        return text;
    }
    QAbstractItemView* list() const { return panel<TextView>()->names()->completer()->popup(); }
    /// As with a keyboard: the list hands to the text what it does not take itself.
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(list()->isVisible() ? static_cast<QWidget*>(list()) : panel<TextView>(), key, modifiers);
    }
    void type(const QString& letters) {
        for (const QChar letter : letters)
            QTest::keyClick(list()->isVisible() ? static_cast<QWidget*>(list()) : panel<TextView>(), letter.toLatin1());
    }
    void toBegin(TextView* text, const QString& of) {
        QTextCursor cursor = text->textCursor();
        cursor.setPosition(static_cast<int>(text->toPlainText().indexOf(of) + of.size()));
        text->setTextCursor(cursor);
    }
};

TEST_F(NameCompletion, OffersWhatMayStandThere) {
    openLambda();
    EXPECT_TRUE(offered("heat").contains("heater"));
    EXPECT_TRUE(offered("heater.").contains("alpha")) << "a parameter";
    EXPECT_TRUE(offered("heater.").contains("heatPort")) << "an inherited connector";
    EXPECT_FALSE(offered("heater.").contains("heater"));
    EXPECT_EQ(offered("heater.al"), QStringList{"alpha"});
    EXPECT_TRUE(offered("Analogon.").contains("Mechanics"));
    EXPECT_EQ(offered("Analogon.Mechanics.Iner"), QStringList{"Inertia"});
    EXPECT_TRUE(offered("Iner").contains("Analogon.Mechanics.Inertia")) << "by the short name";
    EXPECT_TRUE(offered("para").contains("parameter"));
    const QStringList modifiers = offered("Analogon.Mechanics.Inertia rotor(");
    ASSERT_FALSE(modifiers.isEmpty());
    EXPECT_EQ(modifiers[0], "J") << "the text need not be finished";
}

TEST_F(NameCompletion, IsSilentInCommentsTextsAndNumbers) {
    openLambda();
    for (const char* typed : {"// heat", "/* heater.", "\"heat", "x = 1.", "\"a \\\" heater."})
        EXPECT_TRUE(offered(typed).isEmpty()) << typed;
    EXPECT_FALSE(offered("/* note */ heat").isEmpty());
    EXPECT_FALSE(offered("\"text\" + heat").isEmpty());
    EXPECT_TRUE(offered("nosuchname.").isEmpty());
}

TEST_F(NameCompletion, IsTakenByTheKeysAndIsOneTextForTheModel) {
    openLambda();
    TextView* text = showText();
    toBegin(text, "equation\n");
    type("he");
    EXPECT_FALSE(list()->isVisible()) << "too little to be asked about";
    type("a");
    ASSERT_TRUE(list()->isVisible());
    EXPECT_FALSE(list()->currentIndex().isValid());
    press(Qt::Key_Tab);
    EXPECT_FALSE(list()->isVisible());
    EXPECT_TRUE(text->toPlainText().contains("equation\nheater")) << "the first of them";
    EXPECT_TRUE(text->hasFocus());
    type(".");
    ASSERT_TRUE(list()->isVisible()) << "behind a point at once";
    type("al");
    press(Qt::Key_Down);
    press(Qt::Key_Return);
    EXPECT_TRUE(text->toPlainText().contains("equation\nheater.alpha"));
    type(".R");
    press(Qt::Key_Escape);
    EXPECT_FALSE(list()->isVisible());
    EXPECT_TRUE(text->toPlainText().contains("equation\nheater.alpha.R"));
}

TEST_F(NameCompletion, LeavesEnterToWhoMarkedNothingAndComesWhenAskedFor) {
    openLambda();
    TextView* text = showText();
    toBegin(text, "equation\n");
    type("hea");
    ASSERT_TRUE(list()->isVisible());
    press(Qt::Key_Return);
    EXPECT_FALSE(list()->isVisible());
    EXPECT_TRUE(text->toPlainText().contains("equation\nhea\n")) << "a new line, as without the list";
    press(Qt::Key_Backspace);
    press(Qt::Key_Space, Qt::ControlModifier);
    ASSERT_TRUE(list()->isVisible());
    EXPECT_TRUE(list()->currentIndex().isValid());
    press(Qt::Key_Return);
    EXPECT_TRUE(text->toPlainText().contains("equation\nheater"));
    EXPECT_TRUE(QTest::qWaitFor([&] { return document().modelText().contains("equation\nheater"); }, 5000));
    type(".");  // the text is none that parses now
    ASSERT_TRUE(list()->isVisible());
    EXPECT_EQ(list()->model()->index(0, 0).data(Qt::UserRole).toString(), "v");
    if (const QByteArray to = qgetenv("ANALOGON_COMPLETION_PICTURE"); !to.isEmpty())
        list()->grab().save(QString::fromLocal8Bit(to));
}

/// Packages beside the study, of which a file is read when a class in it is named.
class LazyNameCompletion : public testing::Test {
protected:
    static void write(const QString& path, const char* text) {
        QDir().mkpath(QFileInfo(path).path());
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    void SetUp() override {
        write(place("Bench/package.mo"),
              "package Bench \"Of a test bench\"\nprotected\n  model Hidden\n  end Hidden;\nend Bench;");
        write(place("Bench/Drives/package.mo"), "within Bench;\npackage Drives\nend Drives;");
        write(place("Bench/Drives/Base.mo"),
              "within Bench.Drives;\npartial model Base\n  parameter Real ratio = 2 \"of the gear\";\nend Base;");
        write(place("Bench/Drives/Drive.mo"),
              "within Bench.Drives;\nmodel Drive \"A drive\"\n  extends Base;\n  parameter Real k = 1;\n  Real "
              "speed;\nend Drive;");
        write(place("Bench/Drives/Wrong.mo"), "within Bench.Drives;\nmodel Wrong\n  this is none");
    }
    QString place(const char* file) const { return directory.filePath(file); }
    static Library libraryOf(const std::filesystem::path& packages) {
        const auto own = std::make_shared<const Source>("model.mo", "model Own\n  Real x;\nend Own;");
        Outcome<Library> library = Library().withDirectories({packages}).withSource(own);
        EXPECT_TRUE(library);
        return std::move(*library);
    }
    static QStringList offered(const Library& library, const QString& typed) {
        QStringList names;
        for (const NameOffer& offer : nameOffers(library, "Own", "model Own\n  " + typed).offers) names << offer.name;
        return names;
    }

    QTemporaryDir directory;
};

TEST_F(LazyNameCompletion, OffersWhatPackagesHoldWithoutReadingIt) {
    const Library library = libraryOf(directory.path().toStdString());
    const QByteArray searched = qgetenv("MODELICAPATH");
    qputenv("MODELICAPATH", directory.path().toUtf8());
    EXPECT_EQ(offered(library, "Ben"), QStringList{"Bench"});
    qputenv("MODELICAPATH", searched);
    EXPECT_EQ(offered(library, "Bench."), QStringList{"Drives"}) << "not what is protected";
    EXPECT_EQ(offered(library, "Bench.Drives."), (QStringList{"Base", "Drive", "Wrong"}));
    EXPECT_TRUE(library.lazyFaults().empty()) << "no file was read for its name";
    EXPECT_EQ(offered(library, "Bench.Drives.D"), QStringList{"Drive"});
}

TEST_F(LazyNameCompletion, OffersThePartsOfTheirClassesWithThoseInherited) {
    const Library library = libraryOf(directory.path().toStdString());
    EXPECT_EQ(offered(library, "Bench.Drives.Drive d;\nequation\n  d."), (QStringList{"ratio", "k", "speed"}));
    const QStringList modifiers = offered(library, "Bench.Drives.Drive d(");
    ASSERT_GE(modifiers.size(), 2);
    EXPECT_EQ(modifiers.mid(0, 2), (QStringList{"ratio", "k"})) << "the parameters";
}

TEST_F(LazyNameCompletion, KnowsTheStandardLibrary) {
    const QString packages = qEnvironmentVariable("MODELICAPATH").section(':', 0, 0);
    if (!QFileInfo::exists(packages + "/Modelica/package.mo"))
        GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    const Library library = libraryOf(packages.toStdString());
    const double begin = test::workedMilliseconds();
    EXPECT_TRUE(offered(library, "Modelica.").contains("Mechanics"));
    EXPECT_TRUE(offered(library, "Modelica.Mechanics.Rotational.Components.").contains("Inertia"));
    EXPECT_TRUE(offered(library, "Modelica.Electrical.Analog.Basic.Res").contains("Resistor"));
    const QStringList parts = offered(library, "Modelica.Mechanics.Rotational.Components.Inertia r;\nequation\n  r.");
    for (const char* part : {"J", "flange_a", "w"}) EXPECT_TRUE(parts.contains(part)) << part;
    EXPECT_LT(test::workedMilliseconds() - begin, 2000);
}

}  // namespace
}  // namespace analogon::ui
