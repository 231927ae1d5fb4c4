/// What the commands may write, and where: nothing of a user's is ever destroyed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/analogon-cli/command_line.hpp"
#include "tests/app/command_process.hpp"
#include "tests/tree.hpp"

namespace analogon::cli {
namespace {

using testing::HasSubstr;

class FileRule : public CommandLine {
protected:
    void put(const fs::path& file, const std::string& text) const {
        fs::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << text;
    }
};

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
