/// `discover` is killed while it writes its results: what lies there is the earlier result or the new one, whole, and
/// the next run leaves nothing of the dead one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "core/study/study.hpp"
#include "tests/app/command_process.hpp"
#include "tests/tree.hpp"

namespace analogon::cli {
namespace {

class DiscoverThatIsKilled : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        for (const std::string name : {"one", "other"}) {
            fs::rename(study("// " + name + "\n" + lag), scratch / name);
        }
        fs::create_directories(out.parent_path());
    }
    std::vector<std::string> discover(const std::string& name) const {
        return {"discover", (scratch / name).string(), "--out", out.string()};
    }
    /// Whether the files of new results are being written beside the earlier ones.
    bool isWriting() const {
        std::error_code code;
        for (const auto& entry : fs::directory_iterator(out.parent_path(), code)) {
            if (entry.path().filename() == out.filename()) continue;
            for (fs::recursive_directory_iterator file(entry.path(), code), end; !code && file != end;
                 file.increment(code))
                if (file->path().filename() == "report.json") return true;
        }
        return false;
    }
    /// The study whose results lie there, which must be one in all of them.
    std::string version() const {
        const std::string report = contentOf(out / "report.json");
        const std::string name = report.find(R"("title": "other")") != std::string::npos ? "other" : "one";
        EXPECT_NE(report.find(fmt::format(R"("title": "{}")", name)), std::string::npos) << namesBelow(out);
        EXPECT_NE(contentOf(out / "report.html").find(name), std::string::npos);
        EXPECT_EQ(contentOf(out / "study" / "model.mo").find("// " + name), 0U) << "mixed";
        EXPECT_TRUE(readStudy(out / "study")) << namesBelow(out);
        return name;
    }

    const fs::path out = fs::temp_directory_path() / "analogon-cli-test" / "IsOldOrNew" / "results" / "out";
};

/// As often as ANALOGON_KILLS says.
TEST_F(DiscoverThatIsKilled, IsOldOrNew) {
    const char* const wanted = std::getenv("ANALOGON_KILLS");
    const int count = wanted ? std::atoi(wanted) : 16;
    std::mt19937 random(23);
    unsigned reach = 40000;  // [us], of the moments; it follows how long writing takes on this machine
    int news = 0, olds = 0, atWork = 0;
    ASSERT_EQ(run(discover("one")).status, 0);
    std::string before = version();
    for (int i = 0; i < count && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(testing::Message() << "kill " << i);
        const std::string next = before == "one" ? "other" : "one";
        Process process(discover(next), scratch);
        while (!isWriting() && !process.poll()) std::this_thread::yield();
        std::this_thread::sleep_for(std::chrono::microseconds(random() % reach));
        process.end();
        atWork += process.wait() == -1 ? 1 : 0;
        const std::string after = version();
        const bool isNew = after == next;
        ++(isNew ? news : olds);
        reach = std::clamp(isNew ? reach * 3 / 4 : reach * 4 / 3, 200U, 1'000'000U);
        before = after;
    }
    std::printf("%d kills: %d times the earlier results, %d times the new ones; %d at work\n", count, olds, news,
                atWork);
    EXPECT_GT(olds, 0);
    EXPECT_GT(news, 0);
    const Result last = run(discover("other"));
    ASSERT_EQ(last.status, 0) << last.err;
    EXPECT_EQ(version(), "other");
    EXPECT_EQ(std::distance(fs::directory_iterator(out.parent_path()), fs::directory_iterator{}), 1)
        << namesBelow(out.parent_path());
    EXPECT_EQ(namesBelow(out).find(".analogon-results-"), std::string::npos) << namesBelow(out);
}

}  // namespace
}  // namespace analogon::cli
