#pragma once

#include "core/campaign/unit_record.hpp"
#include "core/campaign/unit_study.hpp"

namespace analogon {

/// Fits a unit or searches what its model lacks, and writes its results with its record into its folder below `out`,
/// in one step. What fails is recorded, too, and where not even that can be written, said in the record alone.
UnitRecord runUnit(const Campaign& campaign, const CampaignTemplate& study, const CampaignUnit& unit,
                   const std::filesystem::path& out, const RunOptions& options);

/// The record of a unit that failed before or outside of its run, in its folder.
UnitRecord recordFailure(const CampaignUnit& unit, const std::string& fingerprint, const std::string& fault,
                         const std::filesystem::path& out);

}  // namespace analogon
