#include "core/campaign/results_table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>

#include "core/base/file_fault.hpp"
#include "core/base/visible.hpp"
#include "core/base/whole_file.hpp"
#include "core/measure/table.hpp"

namespace analogon {

namespace {

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : std::string(); }
std::string percent(double value) { return value < 0 ? std::string() : cell(value); }

std::string effectsOf(const UnitRecord& record) {
    std::string text;
    for (const UnitEffect& e : record.effects) text += (text.empty() ? "" : "; ") + e.kind + " at " + e.at;
    return text;
}

const char* stateWord(UnitState state) {
    return state == UnitState::Done ? "done" : state == UnitState::Failed ? "failed" : "waiting";
}

void writeRow(std::ostream& stream, const Campaign& campaign, const CampaignState& state, std::size_t i,
              const std::vector<CampaignParameter>& parameters) {
    const CampaignUnit& unit = campaign.units[i];
    const UnitRecord& record = state.record(i);
    stream << csvCell(unit.name) << ',' << stateWord(state.of(i)) << ',' << record.finding << ','
           << csvCell(effectsOf(record)) << ',' << percent(record.errorBefore) << ',' << percent(record.errorAfter)
           << ',' << percent(record.validationBefore) << ',' << percent(record.validationAfter);
    for (const CampaignParameter& p : parameters) {
        const auto found = std::find_if(record.parameters.begin(), record.parameters.end(),
                                        [&](const UnitParameter& own) { return own.name == p.name; });
        if (found == record.parameters.end())
            stream << ",,";
        else
            stream << ',' << cell(found->value) << ',' << cell(found->standardError);
    }
    for (const std::string& label : campaign.attributes) stream << ',' << csvCell(unit.labels.at(label));
    stream << ',' << (record.work > 0 ? fmt::format("{:.3g}", record.work / stepsPerSecond) : std::string()) << ','
           << csvCell(visibleName(record.fault, 2000)) << '\n';
}

}  // namespace

std::vector<CampaignParameter> parametersOf(const CampaignState& state, std::size_t units) {
    std::map<std::string, std::pair<std::size_t, std::string>> counted;
    for (std::size_t i = 0; i < units; ++i)
        if (state.of(i) == UnitState::Done)
            for (const UnitParameter& p : state.record(i).parameters) {
                auto& [count, unit] = counted[p.name];
                ++count;
                unit = p.unit;
            }
    std::vector<std::pair<std::size_t, CampaignParameter>> ordered;
    for (const auto& [name, of] : counted) ordered.push_back({of.first, {name, of.second}});
    std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<CampaignParameter> parameters;
    for (auto& [count, parameter] : ordered) parameters.push_back(std::move(parameter));
    return parameters;
}

Outcome<Done> writeResultsTable(const Campaign& campaign, const CampaignState& state) {
    const std::vector<CampaignParameter> parameters = parametersOf(state, campaign.units.size());
    const auto write = [&](const std::filesystem::path& file) -> Outcome<Done> {
        std::ofstream stream(file, std::ios::binary);
        stream << "unit,state,finding,effects,error_before [%],error_after [%],validation_error_before [%],"
                  "validation_error_after [%]";
        for (const CampaignParameter& p : parameters) {
            const std::string unit = p.unit.empty() ? std::string() : " [" + p.unit + "]";
            stream << ',' << csvCell(p.name + unit) << ',' << csvCell(p.name + ".std" + unit);
        }
        for (const std::string& label : campaign.attributes) stream << ',' << csvCell(label);
        stream << ",seconds,fault\n";
        for (std::size_t i = 0; i < campaign.units.size(); ++i) writeRow(stream, campaign, state, i, parameters);
        stream.close();
        if (!stream) return cannotWrite(state.out() / "results.csv", phrase("the disk may be full"));
        return Done{};
    };
    return writeWhole(state.out() / "results.csv", write);
}

}  // namespace analogon
