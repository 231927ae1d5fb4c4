#include "core/study/results.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "study_fixture.hpp"
#include "tests/kills.hpp"
#include "tests/tree.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class Results : public analogon::test::StudyTest {
protected:
    void SetUp() override {
        StudyTest::SetUp();
        putHeater();
        one.completed = read();
        other = one;
        other.completed.models["model.mo"] += "// other\n";
        other.finding.warnings = {"other"};
        Remainder law;
        law.proposal.block = "model MissingTorque1\nend MissingTorque1;\n";
        other.finding.unexplained.remainders = {law};
        other.proposed = other.completed;
        out = directory_ / "results" / "out";
        fs::create_directories(out.parent_path());
    }
    /// Whether all files are of the one result or of the other.
    bool isWhole(bool& isOther) const {
        isOther = get(out / "report.json").find("\"other\"") != std::string::npos;
        const bool isModelOther = get(out / "study" / "model.mo").find("// other") != std::string::npos;
        return readStudy(out / "study").hasValue() && isModelOther == isOther &&
               fs::exists(out / "proposed.mo") == isOther && fs::exists(out / "study-proposed") == isOther &&
               fs::exists(out / "report.html");
    }
    std::string faultAt(const fs::path& place, const fs::path& study = {}) const {
        const auto taken = ResultsPlace::take(place, study);
        return taken ? "" : taken.diagnostics().front().message.english();
    }

    RunResult one, other;
    fs::path out;
};

TEST_F(Results, TakeThePlaceOfEarlierOnesAndOfNothingElse) {
    bool isOther = false;
    for (int i = 0; i < 4; ++i) {
        const Outcome<Done> done = writeResults(i % 2 ? other : one, "discover", out);
        ASSERT_TRUE(done) << format(done.diagnostics());
        EXPECT_TRUE(done.diagnostics().empty()) << format(done.diagnostics());
        EXPECT_TRUE(isWhole(isOther));
        EXPECT_EQ(isOther, i % 2 == 1);
        EXPECT_EQ(std::distance(fs::directory_iterator(out.parent_path()), fs::directory_iterator{}), 1);
    }
}

TEST_F(Results, AreRefusedWhereSomethingElseLies) {
    put("taken/notes.txt", "mine");
    put("model/report.json", R"({"format": "of somebody else"})");
    put("file", "mine");
    ASSERT_EQ(mkfifo((directory_ / "pipe").c_str(), 0600), 0);
    const auto tree = treeOf(directory_);
    for (const char* name : {"taken", "model", "."})
        EXPECT_THAT(faultAt(directory_ / name), HasSubstr("holds something else than results")) << name;
    for (const char* name : {"file", "pipe"})
        EXPECT_THAT(faultAt(directory_ / name), HasSubstr("results need a directory")) << name;
    EXPECT_THAT(faultAt(directory_ / "file" / "out"), HasSubstr("cannot be written"));
    EXPECT_EQ(treeOf(directory_), tree);
    EXPECT_EQ(faultAt(directory_ / "new" / "deep"), "");
    EXPECT_FALSE(fs::exists(directory_ / "new")) << "where nothing is written nothing is left";
}

TEST_F(Results, DoNotReplaceTheStudyThatTheyComeFrom) {
    ASSERT_TRUE(writeResults(other, "discover", out));
    for (const char* name : {"study", "study/study.json", "study-proposed"})
        EXPECT_THAT(faultAt(out, out / name), HasSubstr("the study itself lies among the results")) << name;
    EXPECT_EQ(faultAt(out, directory_), "");
    EXPECT_EQ(faultAt(directory_ / "new", directory_), "");
}

TEST_F(Results, LeaveOtherFilesAndKeepWhatSomebodyHasChanged) {
    ASSERT_TRUE(writeResults(other, "discover", out));
    put("results/out/notes.txt", "mine");
    put("results/out/more/notes.txt", "mine too");
    put("results/out/study/model.mo", "model Changed\nend Changed;\n");
    put("results/out/report.html", "changed");
    const Outcome<Done> done = writeResults(one, "discover", out);
    ASSERT_TRUE(done);
    EXPECT_EQ(done.diagnostics().size(), 2u) << format(done.diagnostics());
    EXPECT_THAT(format(done.diagnostics()), HasSubstr("it is kept as \"study.kept-1\""));
    bool isOther = true;
    EXPECT_TRUE(isWhole(isOther));
    EXPECT_FALSE(isOther);
    EXPECT_EQ(get(out / "notes.txt"), "mine");
    EXPECT_EQ(get(out / "more" / "notes.txt"), "mine too");
    EXPECT_EQ(get(out / "study.kept-1" / "model.mo"), "model Changed\nend Changed;\n");
    EXPECT_EQ(get(out / "report.html.kept-1"), "changed");

    put("results/out/study/added.csv", "t\n");
    fs::remove(out / "traces.csv");
    ASSERT_TRUE(writeResults(other, "discover", out));
    EXPECT_EQ(get(out / "study.kept-2" / "added.csv"), "t\n");
    EXPECT_TRUE(isWhole(isOther));
    EXPECT_TRUE(isOther);
}

/// A shell that works in the directory must not find itself in one that is gone.
TEST_F(Results, AreWrittenIntoTheDirectoryThatOneIsIn) {
    fs::create_directories(out);
    const fs::path before = fs::current_path();
    fs::current_path(out);
    struct stat was {
    }, is{};
    EXPECT_EQ(stat(".", &was), 0);
    for (const RunResult* result : {&one, &other}) EXPECT_TRUE(writeResults(*result, "discover", "."));
    EXPECT_EQ(stat(out.c_str(), &is), 0);
    fs::current_path(before);
    EXPECT_EQ(is.st_ino, was.st_ino);
    bool isOther = false;
    EXPECT_TRUE(isWhole(isOther));
    EXPECT_TRUE(isOther);
}

TEST_F(Results, OfTwoRunsIntoOnePlaceAreToldApart) {
    auto first = ResultsPlace::take(out);
    ASSERT_TRUE(first);
    EXPECT_EQ(faultAt(out), "another run writes its results there");
    ASSERT_TRUE(first->write(one, "fit"));
    EXPECT_EQ(faultAt(out), "") << "it is free once they are written";
}

/// Rights do not bind root: there a link that leads nowhere and a file in the way must do.
TEST_F(Results, SayBeforeTheWorkThatTheyCannotBeWritten) {
    fs::create_symlink(directory_ / "nowhere" / "deep", directory_ / "link");
    EXPECT_NE(faultAt(directory_ / "link"), "");
    if (geteuid() == 0) return;
    fs::create_directories(out);
    fs::permissions(out, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THAT(faultAt(out), HasSubstr("cannot be written"));
    fs::permissions(out, fs::perms::owner_all);
}

/// Two programs that write results into one place again and again: each is told when it is not free, and who looks
/// finds the one or the other.
TEST_F(Results, OfTwoProgramsAreNeverMixed) {
    ASSERT_TRUE(writeResults(one, "discover", out));
    std::vector<pid_t> children;
    for (const RunResult* result : {&one, &other}) {
        children.push_back(fork());
        if (children.back() != 0) continue;
        int written = 0;
        for (int i = 0; i < 400 && written < 20; ++i) {
            const Outcome<Done> done = writeResults(*result, "discover", out);
            if (!done && done.diagnostics()[0].message.find("another run writes") == std::string::npos) _exit(1);
            written += done ? 1 : 0;
            if (!done) usleep(5000);
        }
        _exit(written > 0 ? 0 : 2);
    }
    for (const pid_t child : children) {
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
        bool isOther = false;
        EXPECT_TRUE(isWhole(isOther)) << namesBelow(out);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(out.parent_path()), fs::directory_iterator{}), 1);
}

/// A child that replaces results in turn is killed at random moments: they are the one or the other, never mixed, and
/// nothing is left of what it was about once the next run has ended. With a file of somebody else beside them, each is
/// replaced by itself: there the next run is what makes them whole.
TEST_F(Results, AreOldOrNewWhenTheProgramIsKilled) {
    const auto write = [&] {
        (void)writeResults(other, "discover", out);
        (void)writeResults(one, "discover", out);
    };
    for (const bool isShared : {false, true}) {
        ASSERT_TRUE(writeResults(one, "discover", out));
        if (isShared) put("results/out/notes.txt", "mine");
        const Kills kills = killWhileSaving(17, write, [&] {
            bool isOther = false;
            if (isShared) {
                EXPECT_EQ(faultAt(out), "");
            }
            EXPECT_TRUE(isWhole(isOther)) << namesBelow(out.parent_path());
            return isOther;
        });
        EXPECT_GT(kills.firsts, 0) << "some kills came after the other was written";
        EXPECT_LT(kills.firsts, kills.all);
        ASSERT_TRUE(writeResults(other, "discover", out));
        EXPECT_EQ(std::distance(fs::directory_iterator(out.parent_path()), fs::directory_iterator{}), 1);
        EXPECT_EQ(std::distance(fs::directory_iterator(out), fs::directory_iterator{}), isShared ? 8 : 7)
            << namesBelow(out);
    }
    EXPECT_EQ(get(out / "notes.txt"), "mine");
}

}  // namespace
}  // namespace analogon
