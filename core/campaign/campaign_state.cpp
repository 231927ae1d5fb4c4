#include "core/campaign/campaign_state.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/file_fault.hpp"
#include "core/base/file_step.hpp"
#include "core/base/owned_directory.hpp"
#include "core/base/whole_file.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view stateFormat = "analogon-campaign-state-1";

Outcome<DirectoryLock> lockOf(const fs::path& out) {
    std::error_code code;
    const Text hint = phrase("Give a new or an empty directory, or that of an earlier campaign.");
    if (out.empty()) return fileError(phrase("a campaign needs a directory, and this is none"), "\"\"", 0, 0, hint);
    fs::create_directories(out, code);
    if (!fs::is_directory(out, code))
        return fileError(phrase("a campaign needs a directory, and this is none"), out.string(), 0, 0, hint);
    DirectoryLock lock(out, DirectoryLock::Kind::Exclusive, std::chrono::milliseconds(0));
    if (lock.isBusy())
        return fileError(phrase("another run works on this campaign"), out.string(), 0, 0,
                         phrase("Wait until it has ended, or give another directory."));
    removeAbandoned(out, writingPrefix);  // of a run that was killed before it had written its state
    if (!fs::is_empty(out, code) && campaignFileKind(out / "campaign.json") != CampaignFile::State)
        return fileError(phrase("this directory holds something else than a campaign's results"), out.string(), 0, 0,
                         hint);
    return lock;
}

}  // namespace

CampaignFile campaignFileKind(const fs::path& file) {
    std::error_code code;
    if (!fs::is_regular_file(file, code)) return CampaignFile::None;
    std::ifstream stream(file, std::ios::binary);
    std::string begin(4096, '\0');
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(stream.gcount()));
    const auto holds = [&](std::string_view format) {
        return begin.find('"' + std::string(format) + '"') != std::string::npos;
    };
    if (holds(stateFormat)) return CampaignFile::State;
    return holds(campaignFormat) ? CampaignFile::Campaign : CampaignFile::None;
}

const char* name(UnitState state) {
    switch (state) {
        case UnitState::Waiting:
            return "waiting";
        case UnitState::Running:
            return "running";
        case UnitState::Done:
            return "done";
        case UnitState::Failed:
            break;
    }
    return "failed";
}

Outcome<CampaignState> CampaignState::take(const Campaign& campaign, const CampaignTemplate& study, const fs::path& out,
                                           bool retry) {
    Outcome<DirectoryLock> lock = lockOf(out);
    if (!lock) return lock.diagnostics();
    CampaignState state;
    std::error_code code;
    state.out_ = fs::canonical(out, code);
    state.lock_ = std::move(*lock);
    state.states_.assign(campaign.units.size(), UnitState::Waiting);
    state.records_.resize(campaign.units.size());
    for (std::size_t i = 0; i < campaign.units.size(); ++i) {
        const CampaignUnit& unit = campaign.units[i];
        const Outcome<std::string> fingerprint = fingerprintOf(campaign, study, unit);
        UnitRecord& record = state.records_[i];
        record.unit = unit.name;
        if (!fingerprint) {
            record.fault = faultLine(fingerprint.diagnostics());
            state.states_[i] = UnitState::Failed;
            continue;
        }
        std::optional<UnitRecord> earlier = readUnitRecord(state.out_, unit.name);
        if (!earlier) continue;
        if (earlier->fingerprint != *fingerprint) {
            ++state.changed_;
        } else if (earlier->isDone() || !retry) {
            state.kept_ += earlier->isDone() ? 1 : 0;
            state.end(i, std::move(*earlier));
        }
    }
    if (Outcome<Done> written = state.write(campaign); !written) return written.diagnostics();
    return state;
}

void CampaignState::end(std::size_t unit, UnitRecord record) {
    states_[unit] = record.isDone() ? UnitState::Done : UnitState::Failed;
    records_[unit] = std::move(record);
}

CampaignCounts CampaignState::counts() const {
    CampaignCounts counts;
    for (const UnitState state : states_) counts.add(state);
    return counts;
}

std::vector<std::size_t> CampaignState::waiting() const {
    std::vector<std::size_t> units;
    for (std::size_t i = 0; i < states_.size(); ++i)
        if (states_[i] == UnitState::Waiting) units.push_back(i);
    return units;
}

Outcome<Done> CampaignState::write(const Campaign& campaign) const {
    const CampaignCounts all = counts();
    const Json head{{"format", stateFormat},
                    {"campaign", campaign.file.string()},
                    {"command", analogon::name(campaign.command)},
                    {"counts",
                     {{"units", all.units},
                      {"waiting", all.waiting},
                      {"running", all.running},
                      {"done", all.done},
                      {"failed", all.failed}}}};
    constexpr auto replace = Json::error_handler_t::replace;
    std::string text = head.dump(-1, ' ', false, replace);
    text.pop_back();
    text += ",\n\"units\": {";
    for (std::size_t i = 0; i < states_.size(); ++i) {
        Json unit{{"state", name(states_[i])}};
        if (states_[i] == UnitState::Done || states_[i] == UnitState::Failed) unit["seconds"] = records_[i].seconds;
        if (states_[i] == UnitState::Failed) unit["fault"] = records_[i].fault;
        text += (i ? ",\n" : "\n") + Json(campaign.units[i].name).dump(-1, ' ', false, replace) + ": " +
                unit.dump(-1, ' ', false, replace);
    }
    return writeWhole(out_ / "campaign.json", text + "\n}}\n");
}

}  // namespace analogon
