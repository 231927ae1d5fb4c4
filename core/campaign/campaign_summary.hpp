#pragma once

#include <map>

#include "core/campaign/campaign_state.hpp"
#include "core/campaign/population.hpp"
#include "core/campaign/results_table.hpp"

/// What all units of a campaign together tell.
namespace analogon {

inline constexpr double summaryLevel = 0.05;  // of being wrong anywhere in a family of comparisons

struct ParameterSummary {
    CampaignParameter parameter;
    std::vector<double> values, errors;  // of each unit in the order of the table; NaN: not known
    double middle{};                     // median
    Population population;
    double pCommon{1};         // corrected for the number of parameters (Holm)
    std::vector<OddUnit> odd;  // corrected for the number of units and parameters (Sidak)

    bool isCommon() const { return pCommon >= summaryLevel; }
};

struct AttributeSummary {
    std::string parameter, attribute;
    bool isNumber{};            // ranks; else groups
    RankCorrelation ranks;      // of a number
    double p{1}, corrected{1};  // of one comparison; over all (Holm)
    std::size_t units{};
};

struct CampaignSummary {
    CampaignCounts counts;
    std::vector<ParameterSummary> parameters;
    std::map<std::string, std::size_t> findings, effects;  // how many units; effects as "kind at place"
    std::vector<AttributeSummary> attributes;              // the smallest p first
};

/// An attribute whose cells are numbers throughout, with at least three different ones, is held against ranks, any
/// other against groups (of at most half as many as there are units).
CampaignSummary summaryOf(const Campaign& campaign, const CampaignState& state);

/// campaign.html: one page without anything from outside, whose size hardly grows with the number of units: densities,
/// the odd units by name, and one link for each unit's report.
Outcome<Done> writeCampaignPage(const Campaign& campaign, const CampaignState& state, const CampaignSummary& summary);

}  // namespace analogon
