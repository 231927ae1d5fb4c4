#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/campaign/campaign_state.hpp"

/// What the directory of a campaign tells from outside: it is not taken, so that a run may be at work there.
namespace analogon {

struct UnitLook {
    UnitState state{UnitState::Waiting};
    std::optional<UnitRecord> record;           // of one that is done or failed, while it lies there
    std::filesystem::file_time_type written{};  // when the record was
    std::string fault;                          // of a failed one
};

struct CampaignLook {
    std::map<std::string, UnitLook> units;  // by name
    CampaignCounts counts;
};

/// The campaign.json that the state in `out` was made of. Faults: a state that cannot be read.
Outcome<std::filesystem::path> campaignOf(const std::filesystem::path& out);

/// The state of campaign.json in `out`; records that have not been written anew since `before` are taken from there. A
/// directory that is not there, is empty, or holds something else tells of no unit. Faults: a state that cannot be
/// read.
Outcome<CampaignLook> lookAt(const std::filesystem::path& out, const CampaignLook& before = {});

}  // namespace analogon
