#include "core/campaign/slurm/slurm.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>

namespace analogon {

namespace {

constexpr std::size_t usualArray = 1001;  // MaxArraySize of a Slurm that does not say

/// A number at the beginning of a text, which it is taken from.
std::optional<std::size_t> takeNumber(std::string_view& text) {
    std::size_t number = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (code != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// The number behind "NAME = " in a listing of the configuration.
std::optional<std::size_t> settingOf(const std::string& listing, const std::string& name) {
    std::istringstream lines(listing);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string first, equals;
        std::size_t value = 0;
        if (words >> first >> equals >> value && first == name && equals == "=") return value;
    }
    return std::nullopt;
}

/// The value behind "NAME=" in a line of scontrol.
std::string memberOf(const std::string& line, const std::string& name) {
    std::istringstream words(line);
    for (std::string word; words >> word;)
        if (word.starts_with(name + "=")) return word.substr(name.size() + 1);
    return {};
}

std::vector<std::string> onCluster(std::vector<std::string> command, const SlurmJob& job) {
    if (!job.cluster.empty()) command.insert(command.begin() + 1, "--clusters=" + job.cluster);
    return command;
}

}  // namespace

std::vector<std::size_t> tasksNamed(const std::string& text, const std::string& job) {
    std::string_view rest = text;
    if (!rest.starts_with(job + "_")) return {};
    rest.remove_prefix(job.size() + 1);
    if (rest.starts_with('[')) rest.remove_prefix(1);
    std::vector<std::size_t> tasks;
    while (const std::optional<std::size_t> first = takeNumber(rest)) {
        std::size_t last = *first, step = 1;
        if (rest.starts_with('-')) {
            rest.remove_prefix(1);
            last = takeNumber(rest).value_or(*first);
        }
        if (rest.starts_with(':')) {
            rest.remove_prefix(1);
            step = std::max<std::size_t>(1, takeNumber(rest).value_or(1));
        }
        for (std::size_t task = *first; task <= last; task += step) tasks.push_back(task);
        if (!rest.starts_with(',')) break;
        rest.remove_prefix(1);
    }
    return tasks;
}

Outcome<Slurm> Slurm::find(const std::stop_token& stop) {
    const auto sbatch = programOnPath("sbatch"), squeue = programOnPath("squeue");
    if (!sbatch || !squeue)
        return error(phrase("there is no Slurm here: \"{}\" is not among the programs of this machine",
                            sbatch ? "squeue" : "sbatch"),
                     Span(),
                     phrase("Start the campaign where jobs are submitted (a login node of the cluster), or work on it "
                            "here, with --jobs N."));
    Slurm slurm;
    slurm.sbatch_ = *sbatch;
    slurm.squeue_ = *squeue;
    slurm.scontrol_ = programOnPath("scontrol");
    slurm.sacct_ = programOnPath("sacct");
    slurm.scancel_ = programOnPath("scancel");
    slurm.mostTasks_ = usualArray;
    if (!slurm.scontrol_) return slurm;
    const CommandOutput config = runCommand({slurm.scontrol_->string(), "show", "config"}, stop);
    if (!config.isGood())
        return error(phrase("Slurm does not answer: {}", config.words()), Span(),
                     phrase("\"scontrol ping\" tells whether the controller runs."));
    slurm.mostTasks_ = settingOf(config.out, "MaxArraySize").value_or(usualArray);
    if (slurm.mostTasks_ < 2)
        return error(phrase("this Slurm takes no job arrays (MaxArraySize is {})", slurm.mostTasks_), Span(),
                     phrase("Ask who runs the cluster, or work on the campaign here, with --jobs N."));
    if (const auto jobs = settingOf(config.out, "MaxJobCount"); jobs && *jobs > 1)
        slurm.mostTasks_ = std::min(slurm.mostTasks_, *jobs - 1);
    return slurm;
}

Outcome<SlurmJob> Slurm::submit(const std::filesystem::path& script, const std::vector<std::string>& options) const {
    std::vector<std::string> command{sbatch_.string(), "--parsable"};
    command.insert(command.end(), options.begin(), options.end());
    command.push_back(script.string());
    const CommandOutput output = runCommand(command);
    // "12" or "12;cluster", which the last line holds
    std::string line = output.out;
    while (line.ends_with('\n')) line.pop_back();
    line = line.substr(line.rfind('\n') + 1);
    const std::size_t end = line.find(';');
    SlurmJob job{line.substr(0, end), end == std::string::npos ? std::string() : line.substr(end + 1)};
    const bool isNumber = job.isKnown() && job.id.find_first_not_of("0123456789") == std::string::npos;
    if (!output.isGood() || !isNumber)
        return error(
            phrase("Slurm does not take the job: {}", output.words()), Span(),
            phrase("What follows --slurm goes to sbatch, for example --slurm \"--partition=short --time=60\"."));
    return job;
}

std::optional<SlurmJob> Slurm::jobOf(const std::filesystem::path& script, const std::stop_token& stop) const {
    const CommandOutput output = runCommand({squeue_.string(), "--noheader", "--me", "--format=%F %o"}, stop);
    std::istringstream lines(output.out);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t end = line.find(' ');
        if (end != std::string::npos && line.substr(end + 1) == script.string())
            return SlurmJob{line.substr(0, end), {}};
    }
    return std::nullopt;
}

Outcome<std::map<std::size_t, QueuedTask>> Slurm::queued(const SlurmJob& job, const std::stop_token& stop) const {
    const CommandOutput output = runCommand(
        onCluster({squeue_.string(), "--noheader", "--array", "--jobs=" + job.id, "--format=%i|%T|%r"}, job), stop);
    std::map<std::size_t, QueuedTask> tasks;
    if (!output.isGood()) {
        if (output.error.find("Invalid job id") != std::string::npos) return tasks;  // ended, and forgotten
        return error(phrase("Slurm does not answer: {}", output.words()));
    }
    std::istringstream lines(output.out);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t state = line.find('|'), reason = line.find('|', state + 1);
        if (reason == std::string::npos) continue;
        QueuedTask task;
        const std::string word = line.substr(state + 1, reason - state - 1), why = line.substr(reason + 1);
        task.isRunning = word == "RUNNING" || word == "COMPLETING";
        task.isStuck = why.find("launch failed requeued held") != std::string::npos ||
                       why.find("launch_failed_requeued_held") != std::string::npos || why == "JobHoldMaxRequeue";
        if (!task.isRunning) task.reason = why;
        for (const std::size_t number : tasksNamed(line.substr(0, state), job.id)) tasks[number] = task;
    }
    return tasks;
}

std::map<std::size_t, std::string> Slurm::endings(const SlurmJob& job, const std::stop_token& stop) const {
    std::map<std::size_t, std::string> endings;
    const auto keep = [&](const std::string& tasks, std::string state) {
        state = state.substr(0, state.find(' '));  // "CANCELLED by 1000"
        for (const std::size_t task : tasksNamed(tasks, job.id)) endings[task] = state;
    };
    CommandOutput output;
    if (sacct_)
        output = runCommand(onCluster({sacct_->string(), "--noheader", "--parsable2", "--allocations",
                                       "--jobs=" + job.id, "--format=JobID,State"},
                                      job),
                            stop);
    std::istringstream accounted(output.isGood() ? output.out : std::string());
    for (std::string line; std::getline(accounted, line);)
        if (const std::size_t bar = line.find('|'); bar != std::string::npos)
            keep(line.substr(0, bar), line.substr(bar + 1));
    if (!endings.empty() || !scontrol_) return endings;
    output = runCommand(onCluster({scontrol_->string(), "show", "job", "--oneliner", job.id}, job), stop);
    std::istringstream shown(output.isGood() ? output.out : std::string());
    for (std::string line; std::getline(shown, line);)
        keep(memberOf(line, "ArrayJobId") + "_" + memberOf(line, "ArrayTaskId"), memberOf(line, "JobState"));
    return endings;
}

void Slurm::cancel(const SlurmJob& job, std::optional<std::size_t> task) const {
    if (!scancel_) return;
    runCommand(onCluster({scancel_->string(), task ? job.id + "_" + std::to_string(*task) : job.id}, job));
}

}  // namespace analogon
