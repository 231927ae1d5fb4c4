#include "core/report/decision_lines.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>

namespace analogon {
namespace {

namespace fs = std::filesystem;

const Decision decision{"missed",
                        "Analogon.Effects.Friction.Coulomb@rotor",
                        2,
                        3,
                        {{"evidence", 1234.56789}, {"share", std::nan("")}},
                        "kept",
                        "more than \"chance\""};

class DecisionLines : public testing::Test {
protected:
    void SetUp() override {
        directory = fs::temp_directory_path() / ("analogon-decisions-" + std::to_string(::getpid()));
        fs::create_directories(directory);
    }
    void TearDown() override { fs::remove_all(directory); }
    static std::string get(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    fs::path directory;
};

TEST_F(DecisionLines, HaveSixDigitsAndNothingThatIsNotKnown) {
    EXPECT_EQ(decisionLine(decision, 7),
              R"({"number":7,"step":"missed","key":"Analogon.Effects.Friction.Coulomb@rotor","path":2,"round":3,)"
              R"("figures":{"evidence":1234.57},"verdict":"kept","reason":"more than \"chance\""})");
    EXPECT_EQ(decisionLine({"threshold", "", 0, 0, {}, "", ""}, 0),
              R"({"number":0,"step":"threshold","key":"","path":0,"round":0})");
}

TEST_F(DecisionLines, TakeThePlaceOfThoseOfBeforeAtOnce) {
    const fs::path file = directory / "trace.jsonl";
    std::ofstream(file) << "of before";
    ASSERT_TRUE(writeDecisions({decision, decision}, file));
    EXPECT_EQ(get(file), decisionLine(decision, 0) + "\n" + decisionLine(decision, 1) + "\n");
    EXPECT_EQ(std::distance(fs::directory_iterator(directory), {}), 1) << "nothing beside it";
}

TEST_F(DecisionLines, AreRefusedWhereTheyCannotBeWritten) {
    const Outcome<Done> written = writeDecisions({decision}, directory / "nowhere" / "trace.jsonl");
    ASSERT_FALSE(written);
    EXPECT_NE(written.diagnostics().front().message.find("cannot be written"), std::string::npos);
}

}  // namespace
}  // namespace analogon
