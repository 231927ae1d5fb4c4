#include "core/campaign/campaign.hpp"

#include <gmock/gmock.h>

#include "tests/core/campaign/campaign_folder.hpp"

namespace analogon {
namespace {

using testing::HasSubstr;

class CampaignFile : public CampaignFolder {
protected:
    std::string faults() const {
        const Outcome<Campaign> read = readCampaign(at("campaign.json"));
        return read ? std::string() : format(read.diagnostics());
    }
    const std::string plain = R"({"unit": "serial", "files": {"step": "file"}})";
};

TEST_F(CampaignFile, HasAUnitForEachRowWithItsRecordingsValuesAndAttributes) {
    campaign(R"({"unit": "serial", "files": {"step": "file"}, "parameters": {"T": "T_lag [ms]"},
                 "attributes": ["supplier"]})");
    write("units.csv",
          "\xEF\xBB\xBFserial;file;T_lag [ms];supplier\r\nA1;a.csv;512,5;\"Meier; Sohn\"\r\n\r\nA2;b.csv;;X\r\n");
    const Outcome<Campaign> read = readCampaign(at("campaign.json"));
    ASSERT_TRUE(read) << format(read.diagnostics());
    ASSERT_EQ(read->units.size(), 2u);
    EXPECT_EQ(read->command, CampaignCommand::Fit);
    EXPECT_EQ(read->valueUnits.at("T"), "ms");
    EXPECT_EQ(read->units[0].name, "A1");
    EXPECT_EQ(read->units[0].files.at("step"), "a.csv");
    EXPECT_DOUBLE_EQ(read->units[0].values.at("T"), 512.5);
    EXPECT_EQ(read->units[0].labels.at("supplier"), "Meier; Sohn");
    EXPECT_EQ(read->units[1].line, 4);
    EXPECT_FALSE(read->units[1].values.contains("T"));
    EXPECT_TRUE(read->units[1].faults.empty());
}

TEST_F(CampaignFile, RefusesMembersThatNobodyKnowsAndTellsWhere) {
    write("units.csv", "serial,file\nA,a.csv\n");
    campaign(R"({"unit": "serial", "files": {"step": "file"}, "atributes": []})");
    EXPECT_THAT(faults(), HasSubstr("\"atributes\" is no member of a campaign"));
    EXPECT_THAT(faults(), HasSubstr("Did you mean \"attributes\"?"));
    EXPECT_THAT(faults(), HasSubstr("campaign.json:1:"));
    campaign(plain, R"("comand": "fit")");
    EXPECT_THAT(faults(), HasSubstr("the member \"command\" is missing"));
    campaign(plain, R"("command": "simulate")");
    EXPECT_THAT(faults(), HasSubstr("\"fit\" or \"discover\""));
}

TEST_F(CampaignFile, RefusesColumnsThatTheTableLacksAndUnitsOfOneName) {
    write("units.csv", "serial,path\nA,a.csv\n");
    campaign(plain);
    EXPECT_THAT(faults(), HasSubstr("the table of units has no column \"file\""));
    write("units.csv", "serial,file\nA,a.csv\nB,b.csv\nA,c.csv\n");
    EXPECT_THAT(faults(), HasSubstr("units.csv:4:1"));
    EXPECT_THAT(faults(), HasSubstr("stands in line 2 already"));
    write("units.csv", "serial,file\nA,a.csv,x\n");
    EXPECT_THAT(faults(), HasSubstr("the row has 3 cells and the header 2"));
    write("units.csv", "serial,file\n");
    EXPECT_THAT(faults(), HasSubstr("the table has no unit"));
}

TEST_F(CampaignFile, LeavesWhatIsFaultyInOneRowToItsUnit) {
    campaign(R"({"unit": "serial", "files": {"step": "file"}, "parameters": {"T": "T_lag"}})");
    write("units.csv", "serial,file,T_lag\n../evil,a.csv,1\nB,,1\nC,c.csv,about 1\n.D,d.csv,2\nE,e.csv,3\n");
    const Outcome<Campaign> read = readCampaign(at("campaign.json"));
    ASSERT_TRUE(read) << format(read.diagnostics());
    for (const int faulty : {0, 1, 2, 3}) EXPECT_EQ(read->units[static_cast<std::size_t>(faulty)].faults.size(), 1u);
    EXPECT_FALSE(read->units[0].hasFolderName);
    EXPECT_FALSE(read->units[3].hasFolderName);
    EXPECT_THAT(format(read->units[2].faults), HasSubstr("units.csv:4:9"));
    EXPECT_TRUE(read->units[4].faults.empty());
}

}  // namespace
}  // namespace analogon
