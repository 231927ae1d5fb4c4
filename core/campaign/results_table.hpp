#pragma once

#include "core/campaign/campaign_state.hpp"

namespace analogon {

/// A parameter that some unit of a campaign has.
struct CampaignParameter {
    std::string name, unit;
};

/// All parameters of the units that are done: those that most units have first, then by name.
std::vector<CampaignParameter> parametersOf(const CampaignState& state, std::size_t units);

/// results.csv: a row for each unit in the order of the table. The column `seconds` counts the simulated steps of a
/// unit in seconds of stepsPerSecond each, so that it, as all else, is the same wherever the unit was worked on; what
/// it took by the clock is in campaign.json. It is written row by row.
Outcome<Done> writeResultsTable(const Campaign& campaign, const CampaignState& state);

}  // namespace analogon
