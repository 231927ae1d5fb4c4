#include "app/analogon-cli/channels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace analogon::cli {
namespace {

using testing::HasSubstr;

class Channels : public testing::Test {
protected:
    Channels() { std::ofstream(options.input = file) << "time [s],u [V],y\n0,1,\n0.5,3,4\n"; }
    ~Channels() override { std::filesystem::remove(file); }

    std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("analogon-channels-" + std::to_string(getpid()) + ".csv");
    Options options;
    std::ostringstream out, err;
};

TEST_F(Channels, PrintsWhatAFileHoldsAsJson) {
    options.asJson = options.withValues = true;
    ASSERT_EQ(channels(options, out, err), done) << err.str();
    const nlohmann::json json = nlohmann::json::parse(out.str());
    const nlohmann::json& group = json.at("groups").at(0);
    EXPECT_EQ(group.at("master"), "time");
    EXPECT_EQ(group.at("samples"), 2);
    const nlohmann::json& u = group.at("channels").at(1);
    EXPECT_EQ(u.at("name"), "u");
    EXPECT_EQ(u.at("unit"), "V");
    EXPECT_EQ(u.at("kind"), "number");
    EXPECT_EQ(u.at("mean"), 2);
    const nlohmann::json& y = group.at("channels").at(2);
    EXPECT_EQ(y.at("gaps"), 1);
    EXPECT_TRUE(y.at("first").is_null());
    EXPECT_EQ(y.at("min"), 4);
}

TEST_F(Channels, PrintsATableForPeople) {
    ASSERT_EQ(channels(options, out, err), done) << err.str();
    EXPECT_THAT(out.str(), HasSubstr("2 samples over time"));
    EXPECT_THAT(out.str(), HasSubstr("* time"));
}

TEST_F(Channels, AFileThatCannotBeReadIsAFault) {
    options.input = "no such file.mf4";
    EXPECT_EQ(channels(options, out, err), inputAtFault);
    EXPECT_THAT(err.str(), HasSubstr("no such file.mf4"));
}

}  // namespace
}  // namespace analogon::cli
