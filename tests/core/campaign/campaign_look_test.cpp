#include "core/campaign/campaign_look.hpp"

#include <cmath>

#include "core/campaign/unit_run.hpp"
#include "tests/core/campaign/campaign_folder.hpp"

namespace analogon {
namespace {

class CampaignLooked : public CampaignFolder {
protected:
    void SetUp() override {
        CampaignFolder::SetUp();
        campaign(R"({"unit": "serial", "files": {"step": "file"}})");
        record("a.csv", 2, 0.4);
        record("b.csv", 3, 0.4);
        write("units.csv", "serial,file\nA,a.csv\nB,b.csv\nC,missing.csv\n");
        read_.emplace(*readCampaign(at("campaign.json")));
        study_.emplace(*CampaignTemplate::open(*read_));
    }
    CampaignState taken() { return std::move(*CampaignState::take(*read_, *study_, at("out"), false)); }
    void run(CampaignState& state, std::size_t unit) {
        state.end(unit, runUnit(*read_, *study_, read_->units[unit], at("out"), {}));
        ASSERT_TRUE(state.write(*read_));
    }

    std::optional<Campaign> read_;
    std::optional<CampaignTemplate> study_;
};

TEST_F(CampaignLooked, TellsHowFarEachUnitIsWhileARunIsAtWorkThere) {
    CampaignState state = taken();  // and keeps the directory
    run(state, 0);
    state.begin(1);
    ASSERT_TRUE(state.write(*read_));
    const Outcome<CampaignLook> look = lookAt(at("out"));
    ASSERT_TRUE(look) << format(look.diagnostics());
    EXPECT_EQ(*campaignOf(at("out")), at("campaign.json"));
    EXPECT_EQ(look->counts.units, 3u);
    EXPECT_EQ(look->counts.done, 1u);
    EXPECT_EQ(look->counts.running, 1u);
    EXPECT_EQ(look->counts.failed, 1u);
    const UnitLook& done = look->units.at("A");
    ASSERT_TRUE(done.record);
    EXPECT_EQ(done.record->parameters.size(), 2u);
    EXPECT_EQ(look->units.at("B").state, UnitState::Running);
    EXPECT_FALSE(look->units.at("B").record);
    EXPECT_NE(look->units.at("C").fault.find("missing.csv"), std::string::npos);
}

TEST_F(CampaignLooked, TakesARecordThatWasNotWrittenAnewFromTheLookBefore) {
    CampaignState state = taken();
    run(state, 0);
    CampaignLook before = *lookAt(at("out"));
    before.units.at("A").record->finding = "kept";
    EXPECT_EQ(lookAt(at("out"), before)->units.at("A").record->finding, "kept");
    run(state, 0);  // once more
    const CampaignLook anew = *lookAt(at("out"), before);
    ASSERT_TRUE(anew.units.at("A").record);
    EXPECT_EQ(anew.units.at("A").record->finding, "");
}

TEST_F(CampaignLooked, TellsOfNoUnitWhereNothingWasWorkedOn) {
    for (const char* place : {"nowhere", "lag"}) {
        const Outcome<CampaignLook> look = lookAt(at(place));
        ASSERT_TRUE(look);
        EXPECT_TRUE(look->units.empty());
    }
    const Outcome<CampaignLook> campaign = lookAt(folder_);  // its campaign.json is no state
    ASSERT_TRUE(campaign);
    EXPECT_TRUE(campaign->units.empty());
}

TEST_F(CampaignLooked, RefusesAStateThatIsDamaged) {
    CampaignState state = taken();
    const std::string whole = read("out/campaign.json");
    std::string unknown = whole;
    const std::string waits = R"("state":"waiting")";
    unknown.replace(unknown.find(waits), waits.size(), R"("state":"asleep")");
    for (const std::string& damaged : {whole.substr(0, whole.size() / 2), unknown}) {
        write("out/campaign.json", damaged);
        const Outcome<CampaignLook> look = lookAt(at("out"));
        ASSERT_FALSE(look);
        EXPECT_FALSE(look.diagnostics().front().hint.empty());
    }
}

TEST_F(CampaignLooked, IsToldFromACampaignAsItIsWritten) {
    const CampaignState state = taken();
    EXPECT_EQ(campaignFileKind(at("campaign.json")), CampaignFile::Campaign);
    EXPECT_EQ(campaignFileKind(at("out/campaign.json")), CampaignFile::State);
    EXPECT_EQ(campaignFileKind(at("lag/study.json")), CampaignFile::None);
    EXPECT_EQ(campaignFileKind(at("nothing.json")), CampaignFile::None);
    EXPECT_EQ(campaignFileKind(folder_), CampaignFile::None);
}

}  // namespace
}  // namespace analogon
