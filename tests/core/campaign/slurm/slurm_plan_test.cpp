#include "core/campaign/slurm/slurm_plan.hpp"

#include <gmock/gmock.h>

#include "core/campaign/slurm/slurm_run.hpp"
#include "tests/core/campaign/campaign_folder.hpp"

namespace analogon {
namespace {

std::vector<PlannedUnit> planned(std::size_t count) {
    std::vector<PlannedUnit> units;
    for (std::size_t i = 0; i < count; ++i) units.push_back({i, "unit " + std::to_string(i), static_cast<int>(i % 3)});
    return units;
}

TEST(BlocksOf, HoldEveryUnitOnceInItsOrderAndAreOfOneSize) {
    for (const std::size_t most : {1u, 3u, 7u, 10u, 1000u}) {
        const auto tasks = blocksOf(planned(10), most);
        EXPECT_EQ(tasks.size(), std::min<std::size_t>(10, most));
        std::size_t next = 0, least = 10, largest = 0;
        for (const auto& task : tasks) {
            for (const PlannedUnit& one : task) EXPECT_EQ(one.unit, next++);
            least = std::min(least, task.size());
            largest = std::max(largest, task.size());
        }
        EXPECT_EQ(next, 10u);
        EXPECT_LE(largest, least + 1);
    }
}

class SlurmPlanFolder : public CampaignFolder {};

TEST_F(SlurmPlanFolder, IsReadAsItWasWrittenWhileItsJobLives) {
    EXPECT_FALSE(readPlan(folder_).has_value());
    SlurmPlan plan;
    plan.tasks = blocksOf(planned(5), 2);
    ASSERT_TRUE(writePlan(plan, {"/bin/analogon-cli", "campaign-task"}, folder_));
    std::optional<SlurmPlan> read = readPlan(folder_);
    ASSERT_TRUE(read.has_value());
    EXPECT_FALSE(read->job.isKnown());
    ASSERT_TRUE(writeJob({"12", "east"}, folder_));
    read = readPlan(folder_);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->job.id, "12");
    EXPECT_EQ(read->job.cluster, "east");
    ASSERT_EQ(read->tasks.size(), 2u);
    ASSERT_EQ(read->tasks[1].size(), 3u);
    EXPECT_EQ(read->tasks[1][2].unit, 4u);
    EXPECT_EQ(read->tasks[1][2].name, "unit 4");
    EXPECT_EQ(read->tasks[1][2].lost, 1);
    forgetJob(folder_);
    EXPECT_FALSE(readPlan(folder_).has_value());
}

TEST_F(SlurmPlanFolder, IsOfTheCampaignAsLongAsItsUnitsAre) {
    Campaign campaign;
    for (const PlannedUnit& one : planned(5)) campaign.units.emplace_back().name = one.name;
    SlurmPlan plan;
    plan.tasks = blocksOf(planned(5), 2);
    EXPECT_TRUE(isOf(plan, campaign));
    campaign.units[3].name = "another";
    EXPECT_FALSE(isOf(plan, campaign));
    campaign.units.resize(2);
    EXPECT_FALSE(isOf(plan, campaign));
}

TEST(ReservedOption, IsOneThatACampaignSetsItselfHoweverItIsWritten) {
    EXPECT_EQ(reservedOption({"--time=60", "--array=0-3"}), "--array");
    EXPECT_EQ(reservedOption({"--arr=3"}), "--array");
    EXPECT_EQ(reservedOption({"-a3"}), "-a");
    EXPECT_EQ(reservedOption({"--wrap", "true"}), "--wrap");
    EXPECT_EQ(reservedOption({"--account=a", "--wait-all-nodes=1", "-p", "short", "--mem=1G", "-A", "x"}), "");
}

}  // namespace
}  // namespace analogon
