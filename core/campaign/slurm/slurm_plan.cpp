#include "core/campaign/slurm/slurm_plan.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/file_fault.hpp"
#include "core/base/regular_file.hpp"
#include "core/base/whole_file.hpp"

namespace analogon {

namespace {

constexpr const char* jobFormat = "analogon-slurm-1";
constexpr std::uint64_t largestJob = 1u << 16;  // [byte]

std::vector<std::vector<PlannedUnit>> readUnits(const std::filesystem::path& file) {
    std::vector<std::vector<PlannedUnit>> tasks;
    if (!checkRegularFile(file)) return tasks;
    std::ifstream stream(file, std::ios::binary);
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        std::size_t task = 0;
        PlannedUnit unit;
        if (!(words >> task >> unit.lost >> unit.unit) || task > tasks.size()) return {};
        words.get();
        std::getline(words, unit.name);
        if (task == tasks.size()) tasks.emplace_back();
        tasks[task].push_back(std::move(unit));
    }
    return tasks;
}

}  // namespace

std::vector<std::vector<PlannedUnit>> blocksOf(const std::vector<PlannedUnit>& units, std::size_t mostTasks) {
    const std::size_t count = std::min(std::max<std::size_t>(1, mostTasks), units.size());
    std::vector<std::vector<PlannedUnit>> tasks(count);
    for (std::size_t i = 0; i < count; ++i)
        tasks[i].assign(units.begin() + static_cast<std::ptrdiff_t>(i * units.size() / count),
                        units.begin() + static_cast<std::ptrdiff_t>((i + 1) * units.size() / count));
    return tasks;
}

std::filesystem::path slurmFolder(const std::filesystem::path& out) { return out / "slurm"; }

std::string arrayScript(std::size_t tasks, const std::vector<std::string>& task, const std::filesystem::path& out) {
    std::string command = "exec";
    for (const std::string& word : task) command += " " + shellWord(word);
    // the output by the shell: Slurm reads marks into the name of a file
    return fmt::format(
        "#!/bin/sh\n"
        "# The units of a campaign: which task works on which is in units.txt. Written by analogon-cli campaign.\n"
        "#SBATCH --job-name=analogon\n"
        "#SBATCH --array=0-{}\n"
        "#SBATCH --requeue\n"
        "#SBATCH --output=/dev/null\n"
        "exec >>{} 2>&1\n"
        "{} --task \"$SLURM_ARRAY_TASK_ID\"\n",
        tasks - 1, shellWord((slurmFolder(out) / "output.txt").string()), command);
}

Outcome<Done> writePlan(const SlurmPlan& plan, const std::vector<std::string>& task, const std::filesystem::path& out) {
    const std::filesystem::path folder = slurmFolder(out);
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (code) return cannotWrite(folder, code);
    std::string units;
    for (std::size_t i = 0; i < plan.tasks.size(); ++i)
        for (const PlannedUnit& one : plan.tasks[i])
            units += fmt::format("{} {} {} {}\n", i, one.lost, one.unit, one.name);
    if (Outcome<Done> written = writeWhole(folder / "units.txt", units); !written) return written;
    const std::string script = arrayScript(plan.tasks.size(), task, out);
    if (Outcome<Done> written = writeWhole(folder / "array.sh", script); !written) return written;
    if (Outcome<Done> written = writeWhole(folder / "output.txt", std::string()); !written) return written;
    return writeJob(plan.job, out);
}

Outcome<Done> writeJob(const SlurmJob& job, const std::filesystem::path& out) {
    const nlohmann::ordered_json json{{"format", jobFormat}, {"job", job.id}, {"cluster", job.cluster}};
    return writeWhole(slurmFolder(out) / "job.json", json.dump() + "\n");
}

std::optional<SlurmPlan> readPlan(const std::filesystem::path& out) {
    const Outcome<std::string> text = readRegularFile(slurmFolder(out) / "job.json", largestJob);
    if (!text) return std::nullopt;
    SlurmPlan plan;
    try {
        const nlohmann::json json = nlohmann::json::parse(*text);
        if (json.at("format") != jobFormat) return std::nullopt;
        plan.job = {json.at("job"), json.at("cluster")};
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
    plan.tasks = readUnits(slurmFolder(out) / "units.txt");
    return plan;
}

void forgetJob(const std::filesystem::path& out) {
    std::error_code code;
    std::filesystem::remove(slurmFolder(out) / "job.json", code);
}

bool isOf(const SlurmPlan& plan, const Campaign& campaign) {
    for (const std::vector<PlannedUnit>& task : plan.tasks)
        for (const PlannedUnit& one : task)
            if (one.unit >= campaign.units.size() || campaign.units[one.unit].name != one.name) return false;
    return !plan.tasks.empty();
}

}  // namespace analogon
