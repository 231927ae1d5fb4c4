#pragma once

#include <functional>
#include <iosfwd>
#include <stop_token>

#include "core/campaign/campaign_state.hpp"

namespace analogon {

/// How far a campaign is.
struct CampaignProgress {
    CampaignCounts counts;
    double secondsLeft{-1};  // negative: not known yet
};

struct CampaignRunOptions {
    std::vector<std::string> worker;  // the program that serves as worker (serveUnits), with its arguments
    int jobs{1};
    std::stop_token stop{};
    std::function<void(const CampaignProgress&)> report{};
};

/// Works on the units that wait, each in a process that takes one after the other; a process that dies costs the unit
/// that it had. Ends early where that is asked for: what is done is done. campaign.json follows.
Outcome<Done> runCampaign(const Campaign& campaign, const CampaignTemplate& study, CampaignState& state,
                          const CampaignRunOptions& options);

/// The worker's side: takes units from one stream, answers on the other (core/campaign/worker_pool.hpp), until the
/// first ends. Faults: the units of the campaign are not those that are asked for (its table was changed meanwhile).
Outcome<Done> serveUnits(const Campaign& campaign, const CampaignTemplate& study, const std::filesystem::path& out,
                         const RunOptions& options, std::istream& in, std::ostream& answers);

/// The record of a unit as it is now; empty: it was not worked on, or has changed since.
std::optional<UnitRecord> recordThatHolds(const Campaign& campaign, const CampaignTemplate& study, std::size_t unit,
                                          const std::filesystem::path& out);
/// The same when its process has ended; where there is none, a record of why is written (`death`).
UnitRecord recordAfter(const Campaign& campaign, const CampaignTemplate& study, std::size_t unit,
                       const std::string& death, const std::filesystem::path& out);

Diagnostic tableHasChanged(const Campaign& campaign);

/// The time that is left: what the units that ended took, for those that remain, over the processes.
class TimeLeft {
public:
    explicit TimeLeft(int jobs) : jobs_(jobs) {}
    void add(double seconds) {
        sum_ += seconds;
        ++count_;
    }
    double of(std::size_t remaining) const {
        return count_ == 0 ? -1 : sum_ / static_cast<double>(count_) * static_cast<double>(remaining) / jobs_;
    }

private:
    int jobs_;
    double sum_{};
    std::size_t count_{};
};

}  // namespace analogon
