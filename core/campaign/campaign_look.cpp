#include "core/campaign/campaign_look.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/file_fault.hpp"
#include "core/base/file_step.hpp"
#include "core/base/regular_file.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largestState = 256u << 20;  // [byte]

std::optional<UnitState> stateNamed(const std::string& name) {
    for (const UnitState state : {UnitState::Waiting, UnitState::Running, UnitState::Done, UnitState::Failed})
        if (name == analogon::name(state)) return state;
    return std::nullopt;
}

std::string textOf(const nlohmann::json& object, const char* member) {
    const auto found = object.find(member);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void count(CampaignCounts& counts, UnitState state) {
    ++counts.units;
    counts.waiting += state == UnitState::Waiting;
    counts.running += state == UnitState::Running;
    counts.done += state == UnitState::Done;
    counts.failed += state == UnitState::Failed;
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

}  // namespace

Outcome<CampaignLook> lookAt(const fs::path& out, const CampaignLook& before) {
    CampaignLook look;
    const fs::path file = out / "campaign.json";
    if (campaignFileKind(file) != CampaignFile::State) return look;
    const Outcome<std::string> text = readRegularFile(file, largestState);
    if (!text) return text.diagnostics();
    const nlohmann::json json = nlohmann::json::parse(*text, nullptr, false);
    const auto units = json.is_object() ? json.find("units") : json.end();
    if (!json.is_object() || units == json.end() || !units->is_object()) return unreadable(file);
    look.campaign = textOf(json, "campaign");
    for (const auto& [name, unit] : units->items()) {
        const std::optional<UnitState> state = unit.is_object() ? stateNamed(textOf(unit, "state")) : std::nullopt;
        if (!state) return unreadable(file);
        count(look.counts, *state);
        UnitLook& own = look.units[name];
        own.state = *state;
        own.fault = textOf(unit, "fault");
        addRecord(own, out, name, before);
    }
    return look;
}

CampaignFile campaignFileKind(const fs::path& file) {
    std::error_code code;
    if (!fs::is_regular_file(file, code)) return CampaignFile::None;
    std::ifstream stream(file, std::ios::binary);
    std::string begin(4096, '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(stream.gcount()));
    if (begin.find("\"analogon-campaign-state-1\"") != std::string::npos) return CampaignFile::State;
    return begin.find("\"analogon-campaign-1\"") != std::string::npos ? CampaignFile::Campaign : CampaignFile::None;
}

}  // namespace analogon
