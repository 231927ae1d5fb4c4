#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/campaign/campaign.hpp"
#include "core/study/run.hpp"

namespace analogon {

struct UnitParameter {
    std::string name, unit;
    double value{}, standardError{};  // NaN: not determined
};

struct UnitEffect {
    std::string kind, at;
};

/// What a campaign keeps of a unit that was worked on.
struct UnitRecord {
    std::string unit, fingerprint;
    std::string fault;    // one line; empty: the unit is done
    std::string finding;  // of a discovery
    std::vector<UnitEffect> effects;
    std::vector<UnitParameter> parameters;             // of the final model, strengths of effects among them
    double errorBefore{-1}, errorAfter{-1};            // [%] of what was fitted; negative: not known
    double validationBefore{-1}, validationAfter{-1};  // [%] of what only validates
    double work{};                                     // simulated steps (core/base/work.hpp)
    double seconds{};                                  // that it took

    bool isDone() const { return fault.empty(); }
};

/// Steps of WorkCount that count as a second in results.csv: about what one core of 2020 does. A measured time would
/// not be the same wherever the campaign runs.
inline constexpr double stepsPerSecond = 2e6;

UnitRecord recordOf(const RunResult& result, CampaignCommand command);

/// A fault as one line: file, line, column, message.
std::string faultLine(const Diagnostics& faults);

/// unit.json and back; empty: the text is none.
std::string unitJson(const UnitRecord& record);
std::optional<UnitRecord> parseUnitJson(const std::string& text);

/// Where the results of a unit lie.
std::filesystem::path folderOf(const std::filesystem::path& out, const std::string& unit);
/// The record that lies there; empty: the unit was not worked on to its end.
std::optional<UnitRecord> readUnitRecord(const std::filesystem::path& out, const std::string& unit);

}  // namespace analogon
