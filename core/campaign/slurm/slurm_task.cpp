#include "core/campaign/slurm/slurm_task.hpp"

#include <fcntl.h>

#include <thread>

#include "core/campaign/campaign_run.hpp"
#include "core/campaign/slurm/slurm_plan.hpp"
#include "core/campaign/worker_pool.hpp"

namespace analogon {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds glance{20}, betweenTries{200};
// what ends a whole task ends its processes one after the other; after this time it was the unit's alone
constexpr milliseconds endOfTask{2000};

/// A lock for each unit in one file: that of the byte whose number is the unit's (fcntl, which network file systems
/// know). It ends with the process that holds it. Where the file system knows no locks there is nobody to wait for.
class UnitLocks {
public:
    explicit UnitLocks(const std::filesystem::path& out)
        : file_(open((slurmFolder(out) / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {}

    /// False: another process holds it.
    bool take(std::size_t unit) const {
        return set(unit, F_WRLCK) == 0 || (errno != EACCES && errno != EAGAIN && errno != EINTR);
    }
    void leave(std::size_t unit) const { set(unit, F_UNLCK); }

private:
    int set(std::size_t unit, short kind) const {
        struct flock lock {};
        lock.l_type = kind;
        lock.l_whence = SEEK_SET;
        lock.l_start = static_cast<off_t>(unit);
        lock.l_len = 1;
        return fcntl(file_.number(), F_SETLK, &lock);
    }

    FileHandle file_;
};

void pauseFor(milliseconds time, const std::stop_token& stop) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (!stop.stop_requested() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(glance);
}

/// One unit in the worker, to its end; what ends the task as a whole leaves no record.
Outcome<Done> workOn(std::size_t unit, const Campaign& campaign, const CampaignTemplate& study,
                     const std::filesystem::path& out, WorkerPool& pool, const std::stop_token& stop) {
    if (Outcome<Done> given = pool.give(unit, campaign.units[unit].name); !given) return given;
    while (!stop.stop_requested()) {
        Outcome<std::vector<WorkerEvent>> events = pool.wait(glance);
        if (!events) return events.diagnostics();
        if (events->empty()) continue;
        const std::string& death = events->front().death;
        if (!death.empty()) pauseFor(endOfTask, stop);
        if (!stop.stop_requested()) recordAfter(campaign, study, unit, death, out);
        return Done{};
    }
    return Done{};
}

}  // namespace

Outcome<Done> runSlurmTask(const Campaign& campaign, const CampaignTemplate& study, const std::filesystem::path& out,
                           std::size_t task, const std::vector<std::string>& worker, const std::stop_token& stop) {
    const std::optional<SlurmPlan> plan = readPlan(out);
    if (!plan || task >= plan->tasks.size())
        return fileError(phrase("no unit is planned for this task of the array"),
                         (slurmFolder(out) / "units.txt").string(), 0, 0,
                         phrase("\"analogon-cli campaign\" with --slurm submits it."));
    if (!isOf(*plan, campaign)) return tableHasChanged(campaign);
    const UnitLocks locks(out);
    WorkerPool pool(worker, 1);
    for (const PlannedUnit& one : plan->tasks[task]) {
        while (!locks.take(one.unit) && !stop.stop_requested()) pauseFor(betweenTries, stop);
        if (stop.stop_requested()) break;
        if (!recordThatHolds(campaign, study, one.unit, out))
            if (Outcome<Done> worked = workOn(one.unit, campaign, study, out, pool, stop); !worked) return worked;
        locks.leave(one.unit);
    }
    return Done{};
}

}  // namespace analogon
