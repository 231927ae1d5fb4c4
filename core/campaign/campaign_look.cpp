#include "core/campaign/campaign_look.hpp"

#include <nlohmann/json.hpp>

#include "core/base/file_fault.hpp"
#include "core/base/json_limits.hpp"
#include "core/base/regular_file.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr JsonSize largestState{std::size_t{256} << 20, 10'000'000};

std::optional<UnitState> stateNamed(const std::string& name) {
    for (const UnitState state : {UnitState::Waiting, UnitState::Running, UnitState::Done, UnitState::Failed})
        if (name == analogon::name(state)) return state;
    return std::nullopt;
}

std::string textOf(const nlohmann::json& object, const char* member) {
    const auto found = object.find(member);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// With the record of a unit that has ended, which is that of an earlier look where it was not written anew.
void addRecord(UnitLook& look, const fs::path& out, const std::string& unit, const CampaignLook& before) {
    if (look.state != UnitState::Done && look.state != UnitState::Failed) return;
    std::error_code code;
    look.written = fs::last_write_time(folderOf(out, unit) / "unit.json", code);
    const auto earlier = before.units.find(unit);
    const bool isKnown = !code && earlier != before.units.end() && earlier->second.written == look.written;
    look.record = isKnown ? earlier->second.record : readUnitRecord(out, unit);
}

Diagnostics unreadable(const fs::path& file) {
    return {fileError(phrase("the state of the campaign cannot be read"), file.string(), 0, 0,
                      phrase("Start the campaign again: what is done is found in the folders of the units."))};
}

/// The state that is written in a directory.
Outcome<nlohmann::json> stateIn(const fs::path& out) {
    const fs::path file = out / "campaign.json";
    const Outcome<std::string> text = readRegularFile(file, largestState.bytes);
    if (!text) return text.diagnostics();
    if (!checkJsonLimits(Source(file.string(), *text), largestState)) return unreadable(file);
    nlohmann::json json = nlohmann::json::parse(*text, nullptr, false);
    const auto units = json.is_object() ? json.find("units") : json.end();
    if (!json.is_object() || units == json.end() || !units->is_object()) return unreadable(file);
    return json;
}

}  // namespace

Outcome<fs::path> campaignOf(const fs::path& out) {
    const Outcome<nlohmann::json> state = stateIn(out);
    if (!state) return state.diagnostics();
    return fs::path(textOf(*state, "campaign"));
}

Outcome<CampaignLook> lookAt(const fs::path& out, const CampaignLook& before) {
    CampaignLook look;
    if (campaignFileKind(out / "campaign.json") != CampaignFile::State) return look;
    const Outcome<nlohmann::json> json = stateIn(out);
    if (!json) return json.diagnostics();
    for (const auto& [name, unit] : json->at("units").items()) {
        const std::optional<UnitState> state = unit.is_object() ? stateNamed(textOf(unit, "state")) : std::nullopt;
        if (!state) return unreadable(out / "campaign.json");
        look.counts.add(*state);
        UnitLook& own = look.units[name];
        own.state = *state;
        own.fault = textOf(unit, "fault");
        addRecord(own, out, name, before);
    }
    return look;
}

}  // namespace analogon
