/// The window is killed while it saves: what is on the disk is the old study or the new one, and the next window leaves
/// nothing of the dead one behind.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "core/archive/archive.hpp"
#include "tests/tree.hpp"
#include "ui/document/document.hpp"
#include "ui/document/recovery.hpp"
#include "ui/window/main_window.hpp"

namespace analogon::ui {
namespace {

namespace fs = std::filesystem;

const char* const studyVariable = "ANALOGON_SAVED_STUDY";
const char* const onceVariable = "ANALOGON_SAVED_ONCE";

std::string modelOf(int version) {
    return "model Lag\n  parameter Real T(unit=\"s\") = 1;\n  parameter Real k = 1;\n  Analogon.Interfaces.RealInput "
           "u;\n"
           "  Analogon.Interfaces.RealOutput y(start=0, fixed=true);\nequation\n  T*der(y) = k*u - y;\nend Lag;\n// "
           "version " +
           std::to_string(version) + "\n";
}

/// As a user does it: an edit of the text, one of the parameters, and the action of the menu.
bool saveVersion(MainWindow& window, int version) {
    Document& document = window.document();
    document.typeText(QString::fromStdString(modelOf(version)));
    StudyParameter parameter = document.study().parameters.at("T");
    parameter.max = 100 + version;
    document.setStudyParameter("T", parameter, "bound");
    bool isOver = false, isDone = false;
    const auto connection = QObject::connect(&document, &Document::saved, [&](bool done) {
        isOver = true;
        isDone = done;
    });
    window.findChild<QAction*>("save")->trigger();
    const bool hasCome = QTest::qWaitFor([&] { return isOver; }, 60000);
    QObject::disconnect(connection);
    return hasCome && isDone && !document.isModified();
}

/// The other half of WindowSaves, in a process of its own: saves two versions in turn until it is killed.
TEST(WindowThatIsKilled, SavesInTurn) {
    const QString path = qEnvironmentVariable(studyVariable);
    if (path.isEmpty()) GTEST_SKIP() << "run by WindowSaves";
    const bool isOnce = qEnvironmentVariableIsSet(onceVariable);
    MainWindow window;
    window.show();
    window.open(path);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window.document().isOpen() && !window.document().isReading(); }, 60000));
    for (int version = 1;; version = 3 - version) {
        ASSERT_TRUE(saveVersion(window, version)) << path.toStdString();
        if (version == 1) std::printf("ready\n"), std::fflush(stdout);
        if (isOnce) break;
    }
    for (const Recovered& copy : Recovery::abandoned()) Recovery::discard(copy);  // as who does not want them
}

class WindowSaves : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(own.isValid());
        root = own.path().toStdString();
        for (const char* name : {"home", "tmp", "place/killed"}) fs::create_directories(root / name);
        fs::permissions(root / "home", fs::perms::owner_all);  // else Qt makes another directory for the run time
        const fs::path directory = root / "place" / "killed";
        std::ofstream(directory / "model.mo") << modelOf(1);
        std::ofstream(directory / "study.json") << R"({"format": "analogon-study-1", "class": "Lag",
  "experiments": [{"name": "step", "role": "fit", "file": "step.csv", "time": "t",
                   "inputs": {"u": "u"}, "outputs": {"y": "y"}}],
  "parameters": {"T": {"fit": true, "min": 0.1, "max": 101}}})";
        std::ofstream csv(directory / "step.csv");
        csv << "t [s],u,y\n";
        for (int i = 0; i < 2000; ++i) csv << 0.01 * i << ",1," << 2 * (1 - std::exp(-0.01 * i / 1.5)) << '\n';
        csv.close();
        const Outcome<Study> study = readStudy(directory);
        ASSERT_TRUE(study) << format(study.diagnostics());
        ASSERT_TRUE(saveStudy(*study, root / "place" / "killed.analogon"));
    }
    void start(QProcess& process, const fs::path& study, bool isOnce) const {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(studyVariable, QString::fromStdString(study.string()));
        environment.insert("ANALOGON_TEST_HOME", QString::fromStdString((root / "home").string()));
        environment.insert("XDG_RUNTIME_DIR", QString::fromStdString((root / "home").string()));
        environment.insert("TMPDIR", QString::fromStdString((root / "tmp").string()));
        if (isOnce) environment.insert(onceVariable, "1");
        process.setProcessEnvironment(environment);
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(QApplication::applicationFilePath(), {"--gtest_filter=WindowThatIsKilled.SavesInTurn"});
    }
    /// The version that is there, which must be one in all of its files.
    static int versionOf(const fs::path& place) {
        const auto opened = openStudy(place);
        EXPECT_TRUE(opened) << format(opened.diagnostics());
        if (!opened) return 0;
        EXPECT_TRUE(opened.diagnostics().empty()) << format(opened.diagnostics());
        const int version = static_cast<int>(opened->study.parameters.at("T").max.value_or(0)) - 100;
        EXPECT_EQ(opened->study.models.at("model.mo"), modelOf(version)) << "mixed";
        if (version == 1 || version == 2) return version;
        ADD_FAILURE() << "version " << version;
        return 0;
    }

    const QTemporaryDir own;
    fs::path root;
};

/// As often as ANALOGON_KILLS says.
TEST_F(WindowSaves, OldOrNewWhereverItIsKilled) {
    const char* const wanted = std::getenv("ANALOGON_KILLS");
    const int count = wanted ? std::atoi(wanted) : 6;
    std::mt19937 random(5);
    int versions[3] = {};
    const fs::path places[] = {root / "place" / "killed", root / "place" / "killed.analogon"};
    for (int i = 0; i < count && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "kill " << i);
        QProcess process;
        start(process, places[i % 2], false);
        QByteArray said;
        while (!said.contains("ready") && process.waitForReadyRead(120000)) said += process.readAllStandardOutput();
        ASSERT_TRUE(said.contains("ready")) << said.toStdString();
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 400000));
        ASSERT_EQ(process.state(), QProcess::Running) << process.readAllStandardOutput().toStdString();
        process.kill();
        process.waitForFinished();
        ++versions[versionOf(places[i % 2])];
    }
    std::printf("%d kills: %d times the one version, %d times the other\n", count, versions[1], versions[2]);
    EXPECT_EQ(versions[0], 0);
    for (const fs::path& place : places) {
        QProcess process;
        start(process, place, true);
        ASSERT_TRUE(process.waitForFinished(120000));
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardOutput().toStdString();
        EXPECT_EQ(versionOf(place), 1);
    }
    EXPECT_EQ(namesBelow(root / "place"), "killed killed.analogon killed/model.mo killed/step.csv killed/study.json");
    EXPECT_EQ(namesBelow(root / "tmp"), "");
    for (const auto& entry : fs::recursive_directory_iterator(root / "home"))
        EXPECT_NE(entry.path().parent_path().filename(), "recovery") << entry.path();
}

}  // namespace
}  // namespace analogon::ui
