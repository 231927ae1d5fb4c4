#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/base/source.hpp"

/// A campaign as it is written down (contract, section 7): one study, and a table with a row for each unit.
namespace analogon {

inline constexpr const char* campaignFormat = "analogon-campaign-1";

enum class CampaignCommand { Fit, Discover };
const char* name(CampaignCommand command);  // "fit", "discover"

/// One row of the table of units.
struct CampaignUnit {
    std::string name;
    int line{};                                 // in the table, from 1
    std::map<std::string, std::string> files;   // experiment -> path as written, relative to the table
    std::map<std::string, double> values;       // parameter -> what is known, in the unit of its column
    std::map<std::string, std::string> labels;  // attribute -> text
    Diagnostics faults;                         // what hinders this unit alone
    bool hasFolderName{true};                   // its name may be that of a folder
};

struct Campaign {
    std::filesystem::path file, study, table;  // whole paths
    CampaignCommand command{CampaignCommand::Fit};
    std::vector<std::string> experiments;           // whose recordings each unit brings
    std::map<std::string, std::string> valueUnits;  // parameter -> unit of its column; empty: the model's
    std::vector<std::string> attributes;
    std::vector<CampaignUnit> units;  // in the order of the table
    SourcePtr json;                   // campaign.json, for messages
};

/// Reads campaign.json and its table (text with a header; separated by commas, semicolons or tabs). Paths of
/// campaign.json are relative to its folder, those of the table to the table's. Faults of the campaign: no JSON, a
/// member that is missing, unknown or of the wrong type, a column that the table lacks, a name that two units have, a
/// table without units. A name that is no name of a folder, a cell without a path or that is no number cost their unit
/// alone; an empty cell of a value means that it is not known. No other file is looked at.
Outcome<Campaign> readCampaign(const std::filesystem::path& file);

}  // namespace analogon
