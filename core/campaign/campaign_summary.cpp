#include "core/campaign/campaign_summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/median.hpp"
#include "core/measure/csv_dialect.hpp"

namespace analogon {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

ParameterSummary summaryOf(const CampaignParameter& parameter, const Campaign& campaign, const CampaignState& state) {
    ParameterSummary summary;
    summary.parameter = parameter;
    summary.values.assign(campaign.units.size(), unknown);
    summary.errors.assign(campaign.units.size(), unknown);
    std::vector<double> known;
    for (std::size_t i = 0; i < campaign.units.size(); ++i)
        for (const UnitParameter& p : state.record(i).parameters)
            if (state.of(i) == UnitState::Done && p.name == parameter.name) {
                summary.values[i] = p.value;
                summary.errors[i] = p.standardError;
                if (std::isfinite(p.value)) known.push_back(p.value);
            }
    summary.middle = median(known);
    summary.population = populationOf(summary.values, summary.errors);
    return summary;
}

/// The cells of an attribute as numbers; empty: some are none, or hardly any differ.
std::vector<double> numbersOf(const Campaign& campaign, const std::string& attribute) {
    std::vector<double> numbers;
    std::set<double> different;
    for (const CampaignUnit& unit : campaign.units) {
        const std::string& cell = unit.labels.at(attribute);
        const CellValue value = readCell(cell, '.');
        if (value.kind != CellValue::Kind::Number && !cell.empty()) return {};
        numbers.push_back(value.kind == CellValue::Kind::Number ? value.value : unknown);
        if (value.kind == CellValue::Kind::Number) different.insert(value.value);
    }
    return different.size() < 3 ? std::vector<double>() : numbers;
}

AttributeSummary held(const ParameterSummary& parameter, const Campaign& campaign, const std::string& attribute) {
    AttributeSummary summary;
    summary.parameter = parameter.parameter.name;
    summary.attribute = attribute;
    const std::vector<double> numbers = numbersOf(campaign, attribute);
    summary.isNumber = !numbers.empty();
    std::vector<double> x, y;
    std::vector<std::size_t> groups;
    std::map<std::string, std::size_t> names;
    for (std::size_t i = 0; i < campaign.units.size(); ++i) {
        const std::string& cell = campaign.units[i].labels.at(attribute);
        if (!std::isfinite(parameter.values[i]) || cell.empty()) continue;
        y.push_back(parameter.values[i]);
        if (summary.isNumber)
            x.push_back(numbers[i]);
        else
            groups.push_back(names.emplace(cell, names.size()).first->second);
    }
    summary.units = y.size();
    if (summary.isNumber) {
        summary.ranks = rankCorrelation(x, y);
        summary.p = summary.ranks.p;
    } else if (2 * names.size() <= y.size()) {
        summary.p = kruskalWallis(groups, y);
    }
    return summary;
}

}  // namespace

CampaignSummary summaryOf(const Campaign& campaign, const CampaignState& state) {
    CampaignSummary summary;
    summary.counts = state.counts();
    std::size_t comparisons = 0;
    std::vector<double> common, related;
    for (const CampaignParameter& p : parametersOf(state, campaign.units.size())) {
        summary.parameters.push_back(summaryOf(p, campaign, state));
        comparisons += summary.parameters.back().population.units;
        common.push_back(summary.parameters.back().population.pCommon);
    }
    common = holm(common);
    const double level = levelOfOne(summaryLevel, comparisons);
    for (std::size_t i = 0; i < summary.parameters.size(); ++i) {
        ParameterSummary& p = summary.parameters[i];
        p.pCommon = common[i];
        p.odd = oddUnits(p.values, p.errors, level);
        for (const std::string& attribute : campaign.attributes) {
            summary.attributes.push_back(held(p, campaign, attribute));
            related.push_back(summary.attributes.back().p);
        }
    }
    related = holm(related);
    for (std::size_t i = 0; i < related.size(); ++i) summary.attributes[i].corrected = related[i];
    std::stable_sort(summary.attributes.begin(), summary.attributes.end(),
                     [](const AttributeSummary& a, const AttributeSummary& b) { return a.p < b.p; });
    for (std::size_t i = 0; i < campaign.units.size(); ++i) {
        if (state.of(i) != UnitState::Done) continue;
        if (!state.record(i).finding.empty()) ++summary.findings[state.record(i).finding];
        for (const UnitEffect& e : state.record(i).effects) ++summary.effects[e.kind + " at " + e.at];
    }
    return summary;
}

}  // namespace analogon
