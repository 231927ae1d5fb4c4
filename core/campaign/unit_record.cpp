#include "core/campaign/unit_record.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/file_step.hpp"
#include "core/base/json_limits.hpp"
#include "core/base/regular_file.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* recordFormat = "analogon-unit-1";
constexpr std::uint64_t largestRecord = 16u << 20;  // [byte]

/// Root mean square over the experiments of a role; -1: there is none.
double errorOf(const ModelState& state, Role role) {
    double sum = 0;
    int count = 0;
    for (const ExperimentState& e : state.experiments)
        if (e.role == role && std::isfinite(e.errorPercent)) {
            sum += e.errorPercent * e.errorPercent;
            ++count;
        }
    return count == 0 ? -1 : std::sqrt(sum / count);
}

double numberOf(const Json& value) {
    return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

UnitRecord recordOf(const RunResult& result, CampaignCommand command) {
    const Finding& finding = result.finding;
    UnitRecord record;
    if (command == CampaignCommand::Discover) record.finding = name(finding.kind);
    for (const AddedEffect& effect : finding.effects) record.effects.push_back({effect.kind, effect.at});
    for (const FitEstimate& e : finding.final.parameters)
        if (e.experiment < 0) record.parameters.push_back({e.name, e.unit, e.value, e.standardError});
    record.errorBefore = errorOf(finding.baseline, Role::Fit);
    record.errorAfter = errorOf(finding.final, Role::Fit);
    record.validationBefore = errorOf(finding.baseline, Role::Validate);
    record.validationAfter = errorOf(finding.final, Role::Validate);
    if (finding.final.status == FitStatus::Failed) record.fault = finding.final.message;
    return record;
}

std::string faultLine(const Diagnostics& faults) {
    for (const Diagnostic& fault : faults) {
        if (fault.severity != Severity::Error) continue;
        const std::string whole = format(fault);
        std::string line = whole.substr(0, whole.find('\n'));
        if (!fault.hint.empty()) line += " (" + fault.hint.english() + ")";
        return line;
    }
    return "failed without a reason";
}

std::string unitJson(const UnitRecord& record) {
    Json effects = Json::array(), parameters = Json::object();
    for (const UnitEffect& e : record.effects) effects.push_back({{"kind", e.kind}, {"at", e.at}});
    for (const UnitParameter& p : record.parameters)
        parameters[p.name] = {{"value", p.value}, {"std", p.standardError}, {"unit", p.unit}};
    const Json json{{"format", recordFormat},
                    {"unit", record.unit},
                    {"fingerprint", record.fingerprint},
                    {"fault", record.fault},
                    {"finding", record.finding},
                    {"effects", effects},
                    {"parameters", parameters},
                    {"error_percent", {record.errorBefore, record.errorAfter}},
                    {"validation_error_percent", {record.validationBefore, record.validationAfter}},
                    {"work", record.work},
                    {"seconds", record.seconds}};
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<UnitRecord> parseUnitJson(const std::string& text) {
    if (!checkJsonLimits(Source("unit.json", text))) return std::nullopt;
    try {
        const Json json = Json::parse(text);
        if (json.at("format") != recordFormat) return std::nullopt;
        UnitRecord record;
        record.unit = json.at("unit");
        record.fingerprint = json.at("fingerprint");
        record.fault = json.at("fault");
        record.finding = json.at("finding");
        for (const Json& e : json.at("effects")) record.effects.push_back({e.at("kind"), e.at("at")});
        for (const auto& [name, p] : json.at("parameters").items())
            record.parameters.push_back({name, p.at("unit"), numberOf(p.at("value")), numberOf(p.at("std"))});
        record.errorBefore = numberOf(json.at("error_percent").at(0));
        record.errorAfter = numberOf(json.at("error_percent").at(1));
        record.validationBefore = numberOf(json.at("validation_error_percent").at(0));
        record.validationAfter = numberOf(json.at("validation_error_percent").at(1));
        record.work = numberOf(json.at("work"));
        record.seconds = numberOf(json.at("seconds"));
        return record;
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

fs::path folderOf(const fs::path& out, const std::string& unit) { return out / "units" / unit; }

std::optional<UnitRecord> readUnitRecord(const fs::path& out, const std::string& unit) {
    const fs::path file = folderOf(out, unit) / "unit.json";
    if (!isPlainFile(file)) return std::nullopt;
    const Outcome<std::string> text = readRegularFile(file, largestRecord);
    std::optional<UnitRecord> record = text ? parseUnitJson(*text) : std::nullopt;
    if (record && record->unit != unit) record.reset();  // a folder that was copied
    return record;
}

}  // namespace analogon
