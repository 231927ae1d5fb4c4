/// What an installed program brings: its manual page says what it takes, and the list of what it is linked of is whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/app/command_process.hpp"

namespace analogon::cli {
namespace {

using testing::IsSupersetOf;

std::set<std::string> foundIn(const std::string& text, const std::regex& what) {
    std::set<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), what), end; at != end; ++at) found.insert((*at)[1]);
    return found;
}

const std::regex option("(--[a-z][a-z0-9-]*)");

class ManualPage : public CommandLine {
protected:
    std::set<std::string> commands() const {
        const std::string help = run({"--help"}).out;
        return foundIn(help.substr(help.find("Subcommands:")), std::regex("\n  ([a-z]+) "));
    }
    static std::string page() {
        return std::regex_replace(contentOf(root / "packaging/linux/analogon-cli.1"), std::regex(R"(\\-)"), "-");
    }
};

TEST_F(ManualPage, NamesEveryCommandAndEveryOptionAndNoOther) {
    std::set<std::string> taken{"--version"};
    ASSERT_GE(commands().size(), 9u);
    for (const std::string& command : commands()) taken.merge(foundIn(run({command, "--help"}).out, option));
    EXPECT_EQ(foundIn(page(), option), taken);
    EXPECT_THAT(foundIn(page(), std::regex("\n\\.BI? ([a-z]+)")), IsSupersetOf(commands()));
}

TEST_F(ManualPage, IsWhatTheCompletionAsksTheProgramFor) {
    if (std::system("command -v bash >/dev/null") != 0) GTEST_SKIP() << "no bash here";
    const std::string script = (root / "packaging/linux/completions/analogon-cli.bash").string();
    const std::string program = fs::path(ANALOGON_CLI).parent_path().string();
    const auto completed = [&](const std::string& words, int at) {
        const fs::path out = scratch / "completed";
        const std::string line = "PATH=" + program + ":$PATH bash -c 'source " + script + "; COMP_WORDS=(" + words +
                                 "); COMP_CWORD=" + std::to_string(at) +
                                 "; _analogon_cli; printf \"%s\\n\" \"${COMPREPLY[@]}\"' >" + out.string() +
                                 " 2>/dev/null";
        EXPECT_EQ(std::system(line.c_str()), 0);
        return contentOf(out);
    };
    EXPECT_EQ(completed("analogon-cli disc", 1), "discover\n");
    EXPECT_EQ(completed("analogon-cli discover --pat", 2), "--patience\n");
}

TEST_F(ManualPage, ComesWithAListOfWhatIsLinked) {
    if (std::system("command -v dpkg-query ldd >/dev/null") != 0) GTEST_SKIP() << "no dpkg here";
    const fs::path out = scratch / "sbom.json";
    // what the window is linked of, too: a licence in a copyright file there stands behind tabs
    const fs::path gui = "/usr/lib/x86_64-linux-gnu/libQt6Gui.so.6";
    const std::string programs = std::string(ANALOGON_CLI) + (fs::exists(gui) ? " " + gui.string() : "");
    const std::string line =
        (root / "packaging/sbom.sh").string() + " 1.2.3 " + programs + " >" + out.string() + " 2>/dev/null";
    ASSERT_EQ(std::system(line.c_str()), 0);
    const nlohmann::json list = nlohmann::json::parse(contentOf(out));
    EXPECT_EQ(list["spdxVersion"], "SPDX-2.3");
    std::set<std::string> names, identities;
    for (const auto& package : list["packages"]) {
        names.insert(package["name"]);
        EXPECT_FALSE(package["versionInfo"].get<std::string>().empty()) << package;
        EXPECT_TRUE(identities.insert(package["SPDXID"]).second) << package;
    }
    EXPECT_THAT(names, IsSupersetOf({"analogon", "libc6", "libfmt9", "libeigen3-dev"}));
    for (const auto& relation : list["relationships"])
        EXPECT_TRUE(identities.contains(relation["relatedSpdxElement"])) << relation;
}

}  // namespace
}  // namespace analogon::cli
