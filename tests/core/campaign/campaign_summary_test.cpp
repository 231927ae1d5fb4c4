#include "core/campaign/campaign_summary.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>

#include "tests/core/campaign/campaign_folder.hpp"

namespace analogon {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Made-up records of many units: one is far off, one supplier's resistance is higher, one has a name of markup.
class MadeUpCampaign : public CampaignFolder {
protected:
    void make(int count) {
        campaign(R"({"unit": "serial", "files": {"step": "file"}, "attributes": ["supplier", "week", "line"]})",
                 R"("command": "discover")");
        std::string table = "serial,file,supplier,week,line\n<b>&x,a.csv,A,0,L2\n";
        for (int i = 1; i < count; ++i)
            table += "U" + std::to_string(i) + ",a.csv," + (i % 2 ? "A" : "B") + "," + std::to_string(i % 9) + "," +
                     (i % 3 ? "L1" : "L2") + "\n";
        open(table);
        ASSERT_TRUE(state_);
        std::mt19937 random(8);
        std::normal_distribution<double> normal;
        for (std::size_t i = 0; i < read_.units.size(); ++i) {
            UnitRecord record;
            record.unit = read_.units[i].name;
            record.finding = i % 10 == 0 ? "effect" : "adequate";
            if (i % 10 == 0) record.effects = {{"friction.coulomb", "rotor"}};
            const double high = read_.units[i].labels.at("supplier") == "B" ? 0.1 : 0;
            record.parameters = {{"R", "Ohm", 1 + high + 0.05 * normal(random) + (i == 0 ? 1 : 0), 0.01},
                                 {"k", "1", 5 + 0.02 * normal(random), 0.02}};
            state_->end(i, record);
        }
        const CampaignSummary summary = summaryOf(read_, *state_);
        check(summary, count);
        ASSERT_TRUE(writeCampaignPage(read_, *state_, summary));
        ASSERT_TRUE(writeResultsTable(read_, *state_));
    }
    void open(const std::string& table) {
        write("units.csv", table);
        record("a.csv", 1, 0.5);
        Outcome<Campaign> campaignRead = readCampaign(at("campaign.json"));
        ASSERT_TRUE(campaignRead) << format(campaignRead.diagnostics());
        read_ = std::move(*campaignRead);
        Outcome<CampaignTemplate> study = CampaignTemplate::open(read_);
        ASSERT_TRUE(study);
        Outcome<CampaignState> state = CampaignState::take(read_, *study, at("out"), false);
        ASSERT_TRUE(state) << format(state.diagnostics());
        state_.emplace(std::move(*state));
    }
    void check(const CampaignSummary& summary, int count) const {
        ASSERT_EQ(summary.parameters.size(), 2u);
        ASSERT_EQ(summary.parameters[0].odd.size(), 1u);
        EXPECT_EQ(summary.parameters[0].odd[0].unit, 0u);
        EXPECT_TRUE(summary.parameters[1].odd.empty());
        EXPECT_FALSE(summary.parameters[0].isCommon());
        EXPECT_TRUE(summary.parameters[1].isCommon());
        EXPECT_EQ(summary.effects.at("friction.coulomb at rotor"), static_cast<std::size_t>(count / 10));
        EXPECT_EQ(summary.attributes[0].parameter, "R");
        EXPECT_EQ(summary.attributes[0].attribute, "supplier");
        EXPECT_LT(summary.attributes[0].corrected, 0.001);
        for (std::size_t i = 1; i < summary.attributes.size(); ++i)
            EXPECT_GT(summary.attributes[i].corrected, 0.05) << summary.attributes[i].attribute;
    }

    Campaign read_;
    std::optional<CampaignState> state_;
};

TEST_F(MadeUpCampaign, NamesTheOddUnitTheEffectsAndTheSupplierAndNothingElse) {
    make(200);
    const std::string page = read("out/campaign.html");
    EXPECT_THAT(page, HasSubstr("&lt;b&gt;&amp;x"));
    EXPECT_THAT(page, HasSubstr("units/%3Cb%3E%26x/report.html"));
    EXPECT_THAT(page, Not(HasSubstr("<b>&x")));
    EXPECT_THAT(page, Not(HasSubstr("http")));
    EXPECT_THAT(page, HasSubstr("significant"));
}

TEST_F(MadeUpCampaign, HasALightPageOfTenThousandUnits) {
    make(10000);
    const std::string page = read("out/campaign.html");
    EXPECT_LT(page.size(), 1'000'000u);
    std::size_t drawn = 0;
    for (const char* mark : {"<rect", "<circle"})
        for (std::size_t at = 0; (at = page.find(mark, at)) != std::string::npos; ++at) ++drawn;
    EXPECT_LT(drawn, 300u);
    const std::string table = read("out/results.csv");
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 10001);
}

/// The rate of a campaign, not of a comparison: four parameters, of which two vary together as resistance and friction
/// of a batch do, against a supplier, a week and a temperature on which none of them depends. As many campaigns as
/// ANALOGON_CAMPAIGNS says.
TEST_F(MadeUpCampaign, WithoutADependenceSeldomNamesAnAttributeAnywhere) {
    constexpr std::size_t count = 60;
    std::mt19937 random(53);
    std::normal_distribution<double> normal;
    campaign(R"({"unit": "serial", "files": {"step": "file"}, "attributes": ["supplier", "week", "T"]})");
    std::string table = "serial,file,supplier,week,T\n";
    for (std::size_t i = 0; i < count; ++i)
        table += "U" + std::to_string(i) + ",a.csv," + "ABC"[random() % 3] + "," + std::to_string(i % 12) + "," +
                 std::to_string(23 + 2 * normal(random)) + "\n";
    open(table);
    ASSERT_TRUE(state_);
    const char* wanted = std::getenv("ANALOGON_CAMPAIGNS");
    const int campaigns = wanted ? std::atoi(wanted) : 400;
    int named = 0;
    for (int n = 0; n < campaigns; ++n) {
        for (std::size_t i = 0; i < count; ++i) {
            UnitRecord record;
            record.unit = read_.units[i].name;
            const double shared = normal(random);
            record.parameters = {{"R", "Ohm", 1 + 0.05 * shared, 0.01},
                                 {"b", "1", 2 + 0.1 * (0.8 * shared + 0.6 * normal(random)), 0.01},
                                 {"k", "1", 5 + 0.02 * normal(random), 0.02},
                                 {"J", "1", std::exp(0.3 * normal(random)), 0.01}};
            state_->end(i, record);
        }
        const CampaignSummary summary = summaryOf(read_, *state_);
        ASSERT_EQ(summary.attributes.size(), 12u);
        named += summary.attributes.front().corrected < summaryLevel;
    }
    const double expected = summaryLevel * campaigns, spread = std::sqrt(expected * (1 - summaryLevel));
    EXPECT_LE(named, expected + 3 * spread);
    EXPECT_GE(named, 0.2 * expected) << "it would hardly ever name one";
    RecordProperty("named", named);
}

}  // namespace
}  // namespace analogon
