/// What the commands may write, and where: nothing of a user's is ever destroyed.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/analogon-cli/command_line.hpp"
#include "core/base/visible.hpp"
#include "tests/app/command_process.hpp"
#include "tests/tree.hpp"

namespace analogon::cli {
namespace {

using testing::HasSubstr;

class FileRule : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        if (const char* given = std::getenv("TMPDIR")) tmpBefore = given;
    }
    void TearDown() override { tmpBefore.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", tmpBefore.c_str(), 1); }
    void put(const fs::path& file, const std::string& text) const {
        fs::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
    }
    /// What must stay as it is, made to look like our own.
    void putDecoys() const {
        const fs::path user = scratch / "user", tmp = scratch / "tmp", outs = scratch / "outs";
        fs::create_directories(user);
        fs::rename(study(lag), user / "study");
        put(user / "precious" / "model.mo", "model Precious\nend Precious;\n");
        put(user / "precious" / "study.json", "{}");
        put(user / "precious" / ".analogon-list", std::string("analogon-save-1\0+model.mo\0+study.json\0end\0", 40));
        fs::create_directory_symlink(user / "precious", user / "study" / ".analogon-saved");
        fs::create_directory_symlink(user / "precious", user / "study" / ".analogon-saved-1");
        put(user / "study" / ".analogon-writing" / "notes.txt", "mine");
        put(user / "study" / ".analogon-writing-1" / "notes.txt", "mine");
        put(user / "study" / "run-history" / "run-0001.json", "mine");
        put(user / "data" / "step.csv", contentOf(user / "study" / "step.csv"));
        fs::remove(user / "study" / "step.csv");
        fs::create_symlink(user / "data" / "step.csv", user / "study" / "step.csv");
        for (const char* name : {"analogon-study-2026-11-bench", "analogon-study-999999999-abcdef", "analogon-study-1"})
            put(tmp / name / "work.csv", "mine");
        fs::create_directory_symlink(user / "precious", tmp / "analogon-study-2");
        put(outs / ".out.analogon-results-1" / "new" / "notes.txt", "mine");
        put(outs / ".writing-1" / "notes.txt", "mine");
        put(outs / ".analogon-writing-1" / "notes.txt", "mine");
        put(outs / "study" / "study.json", "{}");
        fs::create_directory_symlink(user / "precious", outs / ".out.analogon-results-2");
        setenv("TMPDIR", tmp.c_str(), 1);
    }
    /// All trees but what the command was told to write.
    std::map<std::string, std::string> trees(const std::string& out) const {
        std::map<std::string, std::string> all;
        for (const char* root : {"user", "tmp", "outs"})
            for (const auto& [name, text] : treeOf(scratch / root))
                if (const std::string path = root + ("/" + name); path != out && !path.starts_with(out + "/"))
                    all[path] = text;
        return all;
    }
    std::string tmpBefore;
};

/// Byte for byte, with kinds, rights and times: each command on a study in a directory and in an archive, twice.
TEST_F(FileRule, EveryCommandWritesNowhereButWhereItIsTold) {
    putDecoys();
    const std::string directory = (scratch / "user" / "study").string();
    ASSERT_EQ(run({"pack", directory, (scratch / "user" / "packed.analogon").string()}).status, done);
    const std::string packed = (scratch / "user" / "packed.analogon").string(),
                      data = (scratch / "user" / "data" / "step.csv").string();
    const std::vector<std::vector<std::string>> commands{
        {"check", directory},
        {"check", packed},
        {"check", directory + "/model.mo"},
        {"simulate", directory, "--out"},
        {"simulate", packed, "--out"},
        {"fit", directory, "--out"},
        {"discover", directory, "--out"},
        {"discover", packed, "--out"},
        {"export", directory, "--fmu"},
        {"export", packed, "--modelica"},
        {"export", directory, "--csv"},
        {"export", directory, "--mf4"},
        {"pack", directory, "--out"},
        {"unpack", packed, "--out"},
        {"generate", "--domains", "electric-thermal", "--data", data, "--out"}};
    for (std::vector<std::string> command : commands) {
        const std::string out = command[0] == "pack" ? "outs/out.analogon" : "outs/out";
        const bool isNew = command[0] == "unpack" || command[0] == "generate";
        if (command.back().starts_with("--")) command.push_back((scratch / out).string());
        const auto before = trees(out);
        for (int i = 0; i < (isNew ? 1 : 2); ++i) {
            const Result result = run(command);
            EXPECT_EQ(result.status, command[0] == "generate" ? result.status : done) << command[0] << result.err;
            EXPECT_EQ(trees(out), before) << command[0] << " " << command[1] << ", time " << i;
        }
        fs::remove_all(scratch / out);
    }
}

TEST_F(FileRule, ResultsAreRefusedBeforeTheWorkWhereTheyCannotBeWritten) {
    putDecoys();
    const std::string directory = (scratch / "user" / "study").string();
    put(scratch / "user" / "file", "mine");
    ASSERT_EQ(mkfifo((scratch / "user" / "pipe").c_str(), 0600), 0);
    const auto before = trees("outs/out");
    for (const std::string& out : {directory, (scratch / "user").string(), (scratch / "user" / "precious").string(),
                                   (scratch / "user" / "file").string(), (scratch / "user" / "pipe").string(),
                                   (scratch / "user" / "file" / "deep").string(), std::string("/dev/full"),
                                   std::string("/proc/out"), (scratch / "outs" / "study").string(), std::string()}) {
        const Result result = run({"discover", directory, "--out", out, "--progress", "json"});
        EXPECT_EQ(result.status, inputAtFault) << out << result.err;
        EXPECT_THAT(result.err, testing::Not(HasSubstr("\"stage\""))) << "no work was done for " << out;
        EXPECT_TRUE(result.out.empty()) << out;
    }
    EXPECT_EQ(trees("outs/out"), before);
}

TEST_F(FileRule, WhatTheProgramPrintsMayLieAmongItsResults) {
    const std::string directory = study(lag).string();
    const fs::path out = scratch / "results";
    fs::create_directories(out);
    for (int time = 0; time < 2; ++time) {
        Process process({"simulate", directory, "--out", out.string()}, out);
        EXPECT_EQ(process.wait(), done) << process.err();
        EXPECT_THAT(process.out(), HasSubstr("report:"));
        EXPECT_TRUE(fs::exists(out / "report.json"));
    }
    fs::create_directories(scratch / "other");
    put(scratch / "other" / "log.txt", "");
    EXPECT_EQ(run({"simulate", directory, "--out", (scratch / "other").string()}).status, inputAtFault);
}

TEST_F(FileRule, DecisionsTakeThePlaceOfEarlierOnesAlone) {
    const std::string directory = study(lag).string(), out = (scratch / "results").string();
    const auto trace = [&](const fs::path& file) {
        return run({"discover", directory, "--out", out, "--trace", file.string()}).status;
    };
    put(scratch / "notes.txt", "mine");
    ASSERT_EQ(mkfifo((scratch / "pipe").c_str(), 0600), 0);
    fs::create_symlink(scratch / "notes.txt", scratch / "link");
    for (const char* name : {"notes.txt", "pipe", "link", "user-directory"}) {
        if (std::string(name) == "user-directory") fs::create_directory(scratch / name);
        EXPECT_EQ(trace(scratch / name), inputAtFault) << name;
    }
    EXPECT_EQ(contentOf(scratch / "notes.txt"), "mine");
    EXPECT_TRUE(fs::is_fifo(scratch / "pipe"));
    EXPECT_TRUE(fs::is_symlink(scratch / "link"));
    for (int time = 0; time < 2; ++time) EXPECT_EQ(trace(scratch / "trace.jsonl"), done);
    EXPECT_THAT(contentOf(scratch / "trace.jsonl"), testing::StartsWith("{\"number\":0,"));
}

/// A disk that is full is played by a limit of the size of files: it lets the trial of the beginning pass.
TEST_F(FileRule, TheTableIsPrintedWhateverBecomesOfTheFiles) {
    std::string data = "t [s],u,y\n";
    for (int i = 0; i < 12000; ++i)
        data += fmt::format("{},1,{:.6f}\n", 0.001 * i, 2 * (1 - std::exp(-0.001 * i / 1.5)));
    const std::string directory = study(lag, data).string();
    struct rlimit whole {};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &whole), 0);
    const struct rlimit small { 1u << 18, whole.rlim_max };
    const auto handler = signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const Result result = run({"simulate", directory, "--out", (scratch / "out").string()});
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &whole), 0);
    signal(SIGXFSZ, handler);
    EXPECT_EQ(result.status, inputAtFault) << result.err;
    EXPECT_THAT(result.err, HasSubstr("this cannot be written"));
    EXPECT_THAT(result.out, HasSubstr("step"));
    EXPECT_THAT(result.out, testing::Not(HasSubstr("report:")));
    EXPECT_FALSE(fs::exists(scratch / "out")) << "nothing is left";
}

TEST_F(FileRule, TheSecondRunIntoOnePlaceIsToldAtOnce) {
    const fs::path out = scratch / "out", other = scratch / "other";
    fs::create_directories(other);
    const std::string pump = (root / "examples" / "water-pump").string();
    Process first({"discover", pump, "--out", out.string(), "--progress", "json"}, scratch);
    for (int i = 0; i < 4000 && first.err().empty(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    Process second({"discover", pump, "--out", out.string(), "--progress", "json"}, other);
    EXPECT_EQ(second.wait(), inputAtFault);
    EXPECT_THAT(second.err(), HasSubstr("another run writes its results there"));
    EXPECT_THAT(second.err(), testing::Not(HasSubstr("\"stage\"")));
    first.end();
    first.wait();
    EXPECT_EQ(run({"simulate", study(lag).string(), "--out", out.string()}).status, done)
        << "what a dead run has locked is free";
}

TEST_F(FileRule, PipesAreNeitherReadNorReplaced) {
    const std::string directory = study(lag).string();
    const fs::path pipe = scratch / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const char* option : {"--fmu", "--modelica", "--csv", "--mf4"}) {
        const Result result = run({"export", directory, option, pipe.string()});
        EXPECT_EQ(result.status, inputAtFault) << option;
        EXPECT_THAT(result.err, HasSubstr("this is a pipe or a device, not a file")) << option;
    }
    EXPECT_TRUE(fs::is_fifo(pipe));
    for (const char* name : {"pipe.mo", "pipe.analogon", "pipe.json"}) {
        ASSERT_EQ(mkfifo((scratch / name).c_str(), 0600), 0);
        const Result result = run({"check", (scratch / name).string()});
        EXPECT_EQ(result.status, inputAtFault) << name;
        EXPECT_THAT(result.err, HasSubstr("this is a pipe or a device, not a file")) << name;
    }
    ASSERT_EQ(mkfifo((scratch / "pipe.csv").c_str(), 0600), 0);
    const Result generated = run({"generate", "--domains", "electric-thermal", "--data",
                                  (scratch / "pipe.csv").string(), "--out", (scratch / "new").string()});
    EXPECT_EQ(generated.status, inputAtFault);
    EXPECT_THAT(generated.err, HasSubstr("this is a pipe or a device, not a file"));
}

TEST_F(FileRule, WhatIsWrittenTakesThePlaceOfNothingElse) {
    const fs::path directory = study(lag);
    put(scratch / "notes.analogon", "mine");
    const auto before = treeOf(directory);
    const Result packed = run({"pack", directory.string(), (scratch / "notes.analogon").string()});
    EXPECT_EQ(packed.status, inputAtFault);
    EXPECT_THAT(packed.err, HasSubstr("this exists already and is no study"));
    EXPECT_EQ(contentOf(scratch / "notes.analogon"), "mine");
    for (const auto& [option, file] :
         {std::pair("--csv", "step.csv"), std::pair("--modelica", "model.mo"), std::pair("--fmu", "study.json"),
          std::pair("--mf4", "step.csv"), std::pair("--parameters", "study.json")}) {
        const Result exported = run({"export", directory.string(), option, (directory / file).string()});
        EXPECT_EQ(exported.status, inputAtFault) << option;
        EXPECT_THAT(exported.err, HasSubstr("this is a file of the study itself")) << option;
    }
    EXPECT_EQ(treeOf(directory), before);
}

/// A new file of each kind takes the place of an earlier one of its own kind, or of an empty file.
TEST_F(FileRule, ExportsTakeThePlaceOfEarlierOnesAlone) {
    const std::string directory = study(lag).string();
    const std::vector<std::pair<std::string, std::string>> kinds{
        {"--fmu", "a.fmu"}, {"--modelica", "a.mo"}, {"--csv", "a.csv"}, {"--mf4", "a.mf4"}};
    put(scratch / "notes", "mine");
    put(scratch / "data", "time,experiment\n");
    fs::create_directories(scratch / "directory");
    for (const auto& [option, name] : kinds) {
        const std::string file = (scratch / name).string();
        put(file, "");
        for (int time = 0; time < 3; ++time) {
            const Result again = run({"export", directory, option, file});
            EXPECT_EQ(again.status, done) << option << again.err;
        }
    }
    const auto before = treeOf(scratch);
    for (const auto& [option, name] : kinds)
        for (const std::string other : {"notes", "data", "a.fmu", "a.mo", "a.csv", "a.mf4", "directory"}) {
            if (other == name) continue;
            const Result refused = run({"export", directory, option, (scratch / other).string()});
            EXPECT_EQ(refused.status, inputAtFault) << option << " " << other;
            EXPECT_THAT(refused.err, HasSubstr(other == "directory" ? "this is a directory" : "this exists already"));
            EXPECT_TRUE(refused.out.empty());
        }
    auto after = treeOf(scratch);
    for (const char* stream : {"stdout.txt", "stderr.txt"}) after[stream] = before.at(stream);
    EXPECT_EQ(after, before);
    std::ofstream(scratch / "a.mo", std::ios::app) << "// and mine\n";
    const Result changed = run({"export", directory, "--modelica", (scratch / "a.mo").string()});
    EXPECT_EQ(changed.status, inputAtFault);
    EXPECT_THAT(changed.err, HasSubstr("or it was changed since"));
    const Result twice =
        run({"export", directory, "--fmu", (scratch / "b").string(), "--csv", (scratch / "b").string()});
    EXPECT_EQ(twice.status, inputAtFault) << "one is not written over the other";
}

TEST_F(FileRule, PacksTakeThePlaceOfTheirOwnStudyAlone) {
    const fs::path first = study(lag), second = scratch / "second", file = scratch / "a.analogon";
    fs::copy(first, second, fs::copy_options::recursive);
    for (const fs::path& from : {first, first, first / "study.json"})
        EXPECT_EQ(run({"pack", from.string(), file.string()}).status, done);
    const std::string before = contentOf(file);
    const Result other = run({"pack", second.string(), file.string()});
    EXPECT_EQ(other.status, inputAtFault);
    EXPECT_THAT(other.err, HasSubstr("this exists already and is another study"));
    EXPECT_EQ(contentOf(file), before);
    put(second / "study.json", [&] {
        std::string text = contentOf(second / "study.json");
        return text.replace(text.rfind('}'), 1, ", \"library\": [\"../nowhere\"]}");
    }());
    const Result missing = run({"pack", second.string(), (scratch / "b.analogon").string()});
    EXPECT_EQ(missing.status, inputAtFault);
    EXPECT_THAT(missing.err, HasSubstr("there is no library '../nowhere'"));
    EXPECT_FALSE(fs::exists(scratch / "b.analogon"));
}

/// What is generated can be opened, whatever the recording is called.
TEST_F(FileRule, AStudyIsGeneratedFromAFileOfAnyName) {
    std::string data = "t [s],U [V],I [A],T [degC]\n";
    for (int i = 0; i < 300; ++i)
        data +=
            fmt::format("{},{},{:.4f},{:.3f}\n", 0.1 * i, 6 + i / 100 % 2, 1.2 + 0.1 * (i / 100 % 2), 20 + 0.05 * i);
    int count = 0;
    for (const std::string& name : {std::string("pr\xfc"
                                                "f.csv"),
                                    std::string("\xff\xfe.csv"), std::string("a\nb.csv")}) {
        put(scratch / "data" / name, data);
        const std::string out = (scratch / fmt::format("out-{}", count++)).string();
        for (const std::string& target : {out, out + ".analogon"}) {
            const Result made = run({"generate", "--domains", "electric-thermal,thermal-fluid", "--data",
                                     (scratch / "data" / name).string(), "--out", target});
            EXPECT_EQ(made.status, done) << visible(name) << made.err;
            const Result checked = run({"check", target});
            EXPECT_EQ(checked.status, done) << visible(name) << checked.err;
        }
    }
}

TEST_F(FileRule, PathsNeedNotBeUtf8) {
    const fs::path place = scratch /
                           "pr\xfc"
                           "f";
    fs::create_directories(place);
    fs::rename(study(lag), place / "st\xe4nde");
    const std::string directory = (place / "st\xe4nde").string();
    put(place / "st\xe4nde" / "mehr\xff.mo", "model More\nend More;\n");
    const std::vector<std::vector<std::string>> commands{
        {"check", directory},
        {"fit", directory, "--out", (place / "erg\xe4nzt").string(), "--progress", "json"},
        {"fit", directory, "--out", (place / "erg\xe4nzt").string()},
        {"export", directory, "--fmu", (place / "\xff.fmu").string()},
        {"export", directory, "--csv", (place / "\xff.csv").string()},
        {"pack", directory, (place / "\xff.analogon").string()},
        {"check", (place / "\xff.analogon").string()},
        {"simulate", (place / "\xff.analogon").string(), "--out", (place / "\xfe").string()},
        {"unpack", (place / "\xff.analogon").string(), (place / "neu\xff").string()},
        {"check", (place / "neu\xff").string()}};
    for (const std::vector<std::string>& command : commands) {
        const Result result = run(command);
        EXPECT_EQ(result.status, done) << command[0] << ": " << result.err;
    }
    EXPECT_TRUE(nlohmann::json::accept(contentOf(place / "erg\xe4nzt" / "report.json")));
}

TEST_F(FileRule, NothingIsGeneratedWhereSomethingIsAlready) {
    const fs::path user = scratch / "user", existing = user / "study";
    fs::create_directories(user);
    fs::rename(study(lag), existing);
    put(user / "notes" / "notes.txt", "keep me");
    put(user / "packed.analogon", "keep me");
    fs::create_symlink(user / "nowhere", user / "link");
    const auto before = treeOf(user);
    for (const fs::path& out : {existing, user / "notes", user / "packed.analogon", user / "link"}) {
        const Result result = run({"generate", "--domains", "electric-thermal", "--data",
                                   (existing / "step.csv").string(), "--out", out.string()});
        EXPECT_EQ(result.status, inputAtFault) << out;
        EXPECT_THAT(result.err, HasSubstr("this exists already")) << out;
    }
    EXPECT_EQ(treeOf(user), before);
}

}  // namespace
}  // namespace analogon::cli
