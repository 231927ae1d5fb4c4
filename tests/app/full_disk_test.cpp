/// What each command says and leaves where the disk it writes to is full.
#include "tests/full_disk.hpp"

#include <gmock/gmock.h>

#include "app/analogon-cli/command_line.hpp"
#include "tests/app/command_process.hpp"

namespace analogon::cli {
namespace {

using testing::HasSubstr;

class FullDisk : public SmallDisk {
protected:
    void SetUp() override {
        SmallDisk::SetUp();
        elsewhere = fs::temp_directory_path() / ("full-disk-commands-" + std::to_string(getpid()));
        fs::create_directories(elsewhere);
    }
    void TearDown() override {
        fs::remove_all(elsewhere);
        SmallDisk::TearDown();
    }
    Result run(const std::vector<std::string>& arguments) const {
        Process process(arguments, elsewhere);
        const int status = process.wait();
        return {status, process.out(), process.err()};
    }
    /// With ever more room the command fails with one sentence and leaves the disk as it was, until it has written.
    void expectOneSentence(const std::vector<std::string>& arguments, std::uint64_t step) {
        SCOPED_TRACE(arguments.front());
        int failed = 0;
        for (std::uint64_t room = 0;; room += stepOf(step)) {
            SCOPED_TRACE("with room for " + std::to_string(room) + " bytes");
            const auto before = contents();
            const Result result = withRoom(room, [&] { return run(arguments); });
            if (result.status == done) break;
            ++failed;
            EXPECT_EQ(result.status, inputAtFault) << result.err;
            EXPECT_THAT(result.err, HasSubstr("error: ")) << result.err;
            EXPECT_THAT(result.err, testing::AnyOf(HasSubstr("the disk may be full"), HasSubstr("No space left")));
            EXPECT_EQ(contents(), before);
            if (HasFailure()) return;
        }
        EXPECT_GT(failed, 0);
    }
    /// Of all files on the small disk.
    std::map<std::string, std::string> contents() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(place))
            all[entry.path().string()] = entry.is_regular_file() ? contentOf(entry.path()) : "";
        return all;
    }

    fs::path elsewhere;
    const std::string lambda = (root / "examples" / "lambda-sensor-heating").string();
};

TEST_F(FullDisk, IsToldByEachCommandThatWrites) {
    const std::string archive = (elsewhere / "packed.analogon").string();
    ASSERT_EQ(run({"pack", lambda, archive}).status, done);
    const auto on = [&](const char* name) { return (place / name).string(); };
    expectOneSentence(
        {"generate", "--domains", "electric-thermal", "--data", lambda + "/train.csv", "--out", on("study")}, 16384);
    expectOneSentence({"pack", lambda, on("a.analogon")}, 65536);
    expectOneSentence({"unpack", archive, on("unpacked")}, 65536);
    expectOneSentence({"simulate", lambda, "--out", on("out")}, 262144);
    for (const char* const what : {"new", "in the place of an earlier one"}) {
        SCOPED_TRACE(what);
        expectOneSentence({"export", lambda, "--modelica", on("m.mo")}, 16384);
        expectOneSentence({"export", lambda, "--fmu", on("m.fmu")}, 32768);
        expectOneSentence({"export", lambda, "--csv", on("m.csv")}, 131072);
    }
}

/// Of a long fit nothing would be left.
TEST_F(FullDisk, IsToldBeforeTheWork) {
    const auto before = contents();
    const Result result = withRoom(65536, [&] {
        return run({"fit", lambda, "--out", (place / "out").string(), "--progress", "json"});
    });
    EXPECT_EQ(result.status, inputAtFault) << result.err;
    EXPECT_THAT(result.err, HasSubstr("the disk may be full"));
    EXPECT_THAT(result.err, testing::Not(HasSubstr("\"stage\"")));
    EXPECT_TRUE(result.out.empty()) << result.out;
    EXPECT_EQ(contents(), before);
}

/// The search was long: its result is told and written where there is room.
TEST_F(FullDisk, CostsATraceAndNoResult) {
    std::ofstream(place / "trace.jsonl") << "{\"number\":0,\"old\":1}\n";
    const auto before = contents();
    const Result result = withRoom(0, [&] {
        return run({"discover", lambda, "--kinds", "thermal.radiation", "--most-work", "0.01", "--out",
                    (elsewhere / "out").string(), "--trace", (place / "trace.jsonl").string()});
    });
    EXPECT_EQ(result.status, inputAtFault) << result.err;
    EXPECT_THAT(result.err, HasSubstr("trace.jsonl"));
    EXPECT_THAT(result.err, HasSubstr("cannot be written"));
    EXPECT_EQ(contents(), before);
    EXPECT_TRUE(fs::exists(elsewhere / "out" / "report.json"));
    EXPECT_THAT(result.out, HasSubstr("report: "));
}

}  // namespace
}  // namespace analogon::cli
