#pragma once

#include <chrono>
#include <vector>

#include "core/base/directory_lock.hpp"
#include "core/campaign/unit_record.hpp"
#include "core/campaign/unit_study.hpp"

namespace analogon {

enum class UnitState { Waiting, Running, Done, Failed };
const char* name(UnitState state);  // "waiting", "running", "done", "failed"

struct CampaignCounts {
    std::size_t units{}, waiting{}, running{}, done{}, failed{};

    /// One unit more.
    void add(UnitState state) {
        ++units;
        waiting += state == UnitState::Waiting;
        running += state == UnitState::Running;
        done += state == UnitState::Done;
        failed += state == UnitState::Failed;
    }
};

enum class CampaignFile { None, Campaign, State };
/// Whether a file is a campaign as it is written down, or the state of one that was worked on; by what is in it.
CampaignFile campaignFileKind(const std::filesystem::path& file);

/// The directory of a campaign and how far its units are. The records in the units' folders are the truth; what
/// campaign.json says is made of them, so whenever the program is ended the next run finds what is done.
class CampaignState {
public:
    /// Takes the directory: new, empty, or that of an earlier run, told by its campaign.json; no other run may work
    /// there. Looks which units are done or failed; those that changed since (study, row or recordings) wait again.
    /// `retry`: failed ones, too.
    static Outcome<CampaignState> take(const Campaign& campaign, const CampaignTemplate& study,
                                       const std::filesystem::path& out, bool retry);

    const std::filesystem::path& out() const { return out_; }
    UnitState of(std::size_t unit) const { return states_[unit]; }
    const UnitRecord& record(std::size_t unit) const { return records_[unit]; }
    CampaignCounts counts() const;
    std::size_t changed() const { return changed_; }  // were done or failed, and wait again
    std::size_t kept() const { return kept_; }        // done by earlier runs
    std::vector<std::size_t> waiting() const;

    void begin(std::size_t unit) { states_[unit] = UnitState::Running; }
    void end(std::size_t unit, UnitRecord record);
    /// Back to those that wait.
    void lose(std::size_t unit) { states_[unit] = UnitState::Waiting; }

    /// campaign.json: the old one or the new one, whole.
    Outcome<Done> write(const Campaign& campaign) const;

private:
    std::filesystem::path out_;
    DirectoryLock lock_;
    std::vector<UnitState> states_;
    std::vector<UnitRecord> records_;
    std::size_t changed_{}, kept_{};
};

}  // namespace analogon
