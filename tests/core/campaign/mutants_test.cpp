#include "tests/mutants.hpp"

#include <sys/stat.h>

#include <cmath>

#include "core/campaign/campaign_look.hpp"
#include "core/campaign/campaign_summary.hpp"
#include "core/campaign/results_table.hpp"
#include "core/campaign/slurm/slurm_plan.hpp"
#include "core/campaign/unit_run.hpp"
#include "tests/core/campaign/campaign_folder.hpp"

/// Campaigns that are nearly one: what is written down, the state, the record of a unit and the plan of a job, changed
/// at random. Each ends in a table and a page, or in messages.
namespace analogon {
namespace {

class CampaignMutants : public CampaignFolder {
protected:
    void SetUp() override {
        CampaignFolder::SetUp();
        campaign(R"({"unit": "serial", "files": {"step": "file"}, "parameters": {"T": "T [s]"},
                     "attributes": ["week", "supplier"]})");
        std::string table = "serial,file,T [s],week,supplier\n";
        for (const char name : std::string("ABCD")) {
            const std::string unit(1, name);
            record(unit + ".csv", 1 + 0.1 * (name - 'A'), 0.4);
            table += unit + "," + unit + ".csv," + (name == 'B' ? "0.4" : "") + "," + std::to_string(name - 'A') +
                     (name < 'C' ? ",East\n" : ",West\n");
        }
        write("units.csv", table);
        const Outcome<Campaign> read = readCampaign(at("campaign.json"));
        ASSERT_TRUE(read) << format(read.diagnostics());
        const Outcome<CampaignTemplate> study = CampaignTemplate::open(*read);
        ASSERT_TRUE(study) << format(study.diagnostics());
        Outcome<CampaignState> state = CampaignState::take(*read, *study, at("out"), false);
        ASSERT_TRUE(state) << format(state.diagnostics());
        SlurmPlan plan;
        for (std::size_t i = 0; i < read->units.size(); ++i) {
            state->end(i, runUnit(*read, *study, read->units[i], at("out"), {}));
            plan.tasks.push_back({{i, read->units[i].name, 0}});
        }
        ASSERT_TRUE(state->write(*read));
        ASSERT_TRUE(writePlan(plan, {"/bin/true"}, at("out")));
        for (const char* const file : {"campaign.json", "units.csv", "out/campaign.json", "out/units/B/unit.json",
                                       "out/slurm/job.json", "out/slurm/units.txt"})
            sound_.emplace_back(file, this->read(file));
    }

    static bool isWell(const Diagnostics& messages, bool isDone) {
        const std::string said = format(messages);
        EXPECT_TRUE(isDone || !said.empty());
        EXPECT_LT(said.size(), 20000u);
        EXPECT_EQ(said.find('\x1b'), std::string::npos);
        return isDone;
    }
    /// Looked at, taken up again and told: whether all of it went well.
    bool goesThrough() const {
        const Outcome<CampaignLook> look = lookAt(at("out"));
        const Outcome<std::filesystem::path> origin = campaignOf(at("out"));
        bool isSound = isWell(look.diagnostics(), look.hasValue());
        isSound &= isWell(origin.diagnostics(), origin.hasValue());
        const std::optional<SlurmPlan> plan = readPlan(at("out"));
        const Outcome<Campaign> campaign = readCampaign(at("campaign.json"));
        if (!isWell(campaign.diagnostics(), campaign.hasValue())) return false;
        isSound &= plan && isOf(*plan, *campaign);
        const Outcome<CampaignTemplate> study = CampaignTemplate::open(*campaign);
        if (!isWell(study.diagnostics(), study.hasValue())) return false;
        for (const CampaignUnit& unit : campaign->units) {
            const Outcome<Study> own = study->studyOf(*campaign, unit);
            isSound &= isWell(own.diagnostics(), own.hasValue());
        }
        const Outcome<CampaignState> state = CampaignState::take(*campaign, *study, at("out"), false);
        if (!isWell(state.diagnostics(), state.hasValue())) return false;
        EXPECT_TRUE(writeResultsTable(*campaign, *state));
        EXPECT_TRUE(writeCampaignPage(*campaign, *state, summaryOf(*campaign, *state)));
        return isSound && state->counts().done == campaign->units.size();
    }

    std::vector<std::pair<std::string, std::string>> sound_;  // file, what is in it
};

TEST_F(CampaignMutants, EndInATableOrInMessages) {
    ASSERT_TRUE(goesThrough());
    expectAllEnd([&](unsigned number) {
        for (const auto& [file, text] : sound_) write(file, text);
        const auto& [file, text] = sound_[number % sound_.size()];
        write(file, mutated(text, number));
        return goesThrough();
    });
}

/// Memory would grow as the depth, many bytes for each bracket.
TEST_F(CampaignMutants, ThatNestDeeplyAreNone) {
    const std::string deep = "\"deep\":" + std::string(200, '[') + std::string(200, ']') + ",";
    std::string state = read("out/campaign.json"), unit = read("out/units/B/unit.json");
    write("out/campaign.json", state.insert(1, deep));
    const Outcome<CampaignLook> look = lookAt(at("out"));
    ASSERT_FALSE(look);
    EXPECT_NE(format(look.diagnostics()).find("the state of the campaign cannot be read"), std::string::npos);
    EXPECT_TRUE(readUnitRecord(at("out"), "B"));
    write("out/units/B/unit.json", unit.insert(1, deep));
    EXPECT_FALSE(readUnitRecord(at("out"), "B"));
}

/// A pipe has no end: who reads one waits for ever.
TEST_F(CampaignMutants, ThatHavePipesInThePlaceOfTheirFilesAreNotWaitedFor) {
    for (const char* const file : {"out/slurm/units.txt", "out/slurm/job.json", "out/units/B/unit.json", "units.csv"}) {
        std::filesystem::remove(at(file));
        ASSERT_EQ(mkfifo(at(file).c_str(), 0600), 0);
        MutantWatch watch;
        watch.begin(0);
        EXPECT_FALSE(goesThrough()) << file;
        std::filesystem::remove(at(file));
        for (const auto& [name, text] : sound_) write(name, text);
    }
}

}  // namespace
}  // namespace analogon
