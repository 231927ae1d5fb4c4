#include "core/campaign/unit_study.hpp"

#include <gmock/gmock.h>

#include "tests/core/campaign/campaign_folder.hpp"

namespace analogon {
namespace {

using testing::HasSubstr;

class UnitStudy : public CampaignFolder {
protected:
    Campaign readAll() const {
        Outcome<Campaign> read = readCampaign(at("campaign.json"));
        EXPECT_TRUE(read) << format(read.diagnostics());
        return std::move(*read);
    }
};

TEST_F(UnitStudy, HasTheUnitsRecordingAndItsKnownValueInTheUnitOfTheModel) {
    campaign(R"({"unit": "serial", "files": {"step": "file"}, "parameters": {"T": "T_lag [ms]"}})");
    write("units.csv", "serial,file,T_lag [ms]\nA,a.csv,250\nB,b.csv,\n");
    record("a.csv", 2, 0.25);
    record("b.csv", 3, 0.75);
    const Campaign read = readAll();
    const Outcome<CampaignTemplate> made = CampaignTemplate::open(read);
    ASSERT_TRUE(made) << format(made.diagnostics());
    const Outcome<Study> first = made->studyOf(read, read.units[0]), second = made->studyOf(read, read.units[1]);
    ASSERT_TRUE(first && second);
    EXPECT_FALSE(first->parameters.at("T").fit);
    EXPECT_DOUBLE_EQ(*first->parameters.at("T").value, 0.25);
    EXPECT_TRUE(second->parameters.at("T").fit);
    const Outcome<RunResult> result = runFit(*first, {});
    ASSERT_TRUE(result);
    ASSERT_EQ(result->finding.final.parameters.size(), 1u);
    EXPECT_NEAR(result->finding.final.parameters[0].value, 2, 0.01);
}

TEST_F(UnitStudy, RefusesExperimentsParametersAndUnitsThatTheStudyDoesNotHave) {
    campaign(R"({"unit": "serial", "files": {"stop": "file"}, "parameters": {"kk": "k", "T": "T_lag [V]"}})");
    write("units.csv", "serial,file,k,T_lag [V]\nA,a.csv,1,2\n");
    const Campaign read = readAll();
    const Outcome<CampaignTemplate> made = CampaignTemplate::open(read);
    ASSERT_FALSE(made);
    const std::string told = format(made.diagnostics());
    EXPECT_THAT(told, HasSubstr("the study has no experiment \"stop\""));
    EXPECT_THAT(told, HasSubstr("Did you mean \"step\"?"));
    EXPECT_THAT(told, HasSubstr("the model has no parameter \"kk\""));
    EXPECT_THAT(told, HasSubstr("The table gives \"T\" in this unit."));
}

TEST_F(UnitStudy, IsToldFromTheOneAfterAChangeOfRowRecordingOrModel) {
    campaign(R"({"unit": "serial", "files": {"step": "file"}, "parameters": {"T": "T_lag"}})");
    record("a.csv", 2, 0.25);
    const auto print = [&](const std::string& table) {
        write("units.csv", table);
        const Campaign read = readAll();
        const Outcome<CampaignTemplate> made = CampaignTemplate::open(read);
        EXPECT_TRUE(made);
        const Outcome<std::string> text = fingerprintOf(read, *made, read.units[0]);
        return text ? *text : format(text.diagnostics());
    };
    const std::string one = "serial,file,T_lag\nA,a.csv,1\n", first = print(one);
    EXPECT_EQ(print(one + "B,b.csv,1\n"), first);
    EXPECT_NE(print("serial,file,T_lag\nA,a.csv,2\n"), first);
    write("a.csv", read("a.csv") + "\n");
    const std::string second = print(one);
    EXPECT_NE(second, first);
    write("lag/model.mo", read("lag/model.mo") + "// changed\n");
    EXPECT_NE(print(one), second);
    std::filesystem::remove(at("a.csv"));
    EXPECT_THAT(print(one), HasSubstr("there is no recording \"a.csv\""));
}

}  // namespace
}  // namespace analogon
