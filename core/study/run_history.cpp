#include "core/study/run_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>

#include "core/base/directory_lock.hpp"
#include "core/base/file_fault.hpp"
#include "core/base/file_step.hpp"
#include "core/base/owned_directory.hpp"
#include "core/base/regular_file.hpp"
#include "core/base/whole_file.hpp"
#include "core/study/pending_save.hpp"
#include "core/study/run_json.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "traces are written as they lie in memory");

/// "4f1c…-1200.f64": what an array holds (FNV-1a) and how many values.
std::string nameOf(std::span<const double> values) {
    std::uint64_t hash = 14695981039346656037ull;
    for (const double value : values) {
        hash ^= std::bit_cast<std::uint64_t>(value);
        hash *= 1099511628211ull;
        hash ^= hash >> 29;  // whole words at a time: their high bits must come down
    }
    return fmt::format("{:016x}-{}{}", hash, values.size(), traceEnding);
}

bool isOwnFile(const fs::path& file) {
    const std::string name = file.filename().string();
    return file.extension() == traceEnding || (name.starts_with("run-") && file.extension() == ".json");
}

bool writeFile(const fs::path& file, const char* bytes, std::size_t count) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes, static_cast<std::streamsize>(count));
    stream.close();
    return stream.good();
}

std::string contentOf(const fs::path& file) {
    std::error_code code;
    if (fs::file_size(file, code) > HistoryLimits{}.traceBytes && !code)
        throw std::runtime_error(fmt::format("'{}' is larger than any that is kept", file.filename().string()));
    Outcome<std::string> text = readRegularFile(file);
    if (!text) throw std::runtime_error(fmt::format("'{}' is not there", file.filename().string()));
    return std::move(*text);
}

/// Arrays of a run, each once, as long as there is room for all of them.
class TraceWriter {
public:
    TraceWriter(const fs::path& directory, std::uint64_t room) : directory_(directory), room_(room) {}

    /// Text of a run; its traces are written where all of them have room.
    std::string keep(const PastRun& run) {
        std::map<std::string, std::span<const double>> fresh;
        std::uint64_t bytes = 0;
        const std::string text = runJson(run, [&](std::span<const double> values) {
            const std::string name = nameOf(values);
            if (!kept_.contains(name) && fresh.emplace(name, values).second) bytes += values.size_bytes();
            return name;
        });
        if (bytes > room_) return runJson(run, [](std::span<const double>) { return std::string(); });
        room_ -= bytes;
        for (const auto& [name, values] : fresh) {
            const auto* const first = reinterpret_cast<const char*>(values.data());
            if (!writeFile(directory_ / name, first, values.size_bytes())) failed_ = directory_ / name;
            kept_.insert(name);
        }
        return text;
    }
    const fs::path& failed() const { return failed_; }

private:
    fs::path directory_, failed_;
    std::uint64_t room_;
    std::set<std::string> kept_;
};

/// Told by what it holds: a run by its format, a trace by the name that its values give it.
bool isWrittenByUs(const fs::path& file) {
    if (!isOwnFile(file) || !isPlainFile(file)) return false;
    const Outcome<std::string> bytes = readRegularFile(file);
    if (!bytes) return false;
    if (file.extension() == ".json") return bytes->find("\"analogon-run-") < 100;
    std::vector<double> values(bytes->size() / sizeof(double));
    std::memcpy(values.data(), bytes->data(), values.size() * sizeof(double));
    return nameOf(values) == file.filename();
}

std::vector<fs::path> ownFiles(const fs::path& directory) {
    std::vector<fs::path> files;
    std::error_code code;
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code))
        if (isWrittenByUs(entry->path())) files.push_back(entry->path());
    return files;
}

std::size_t entriesOf(const fs::path& directory) {
    std::error_code code;
    std::size_t count = 0;
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code)) ++count;
    return count;
}

/// The new files first, so that a run which is kept is there all the time; other files stay.
std::error_code replaceFiles(const fs::path& fresh, const fs::path& place, const std::vector<fs::path>& old) {
    std::vector<fs::path> files;
    std::error_code code;
    for (fs::directory_iterator entry(fresh, code), end; !code && entry != end; entry.increment(code))
        files.push_back(entry->path());
    std::set<fs::path> kept;
    for (const fs::path& file : files) {
        const fs::path target = place / file.filename();
        if (fs::exists(fs::symlink_status(target, code)) && std::find(old.begin(), old.end(), target) == old.end())
            return std::make_error_code(std::errc::file_exists);  // of somebody else
        code.clear();
        fs::rename(file, target, code);
        if (code) return code;
        kept.insert(target);
    }
    for (const fs::path& file : old)
        if (!kept.contains(file)) fs::remove(file, code);
    return {};
}

std::vector<double> readTrace(const fs::path& directory, const std::string& name) {
    const std::string bytes = contentOf(directory / fs::path(name).filename());
    std::vector<double> values(bytes.size() / sizeof(double));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
    if (nameOf(values) != name) throw std::runtime_error(fmt::format("the traces in '{}' are damaged", name));
    return values;
}

/// A run whose traces are damaged is still worth its figures.
PastRun readRun(const fs::path& file, const Study& study, Diagnostics& warnings) {
    const std::string text = contentOf(file);
    try {
        return parseRun(text, file.string(), study,
                        [&](const std::string& name) { return readTrace(file.parent_path(), name); });
    } catch (const std::runtime_error& fault) {
        PastRun run = parseRun(text, file.string(), study, [](const std::string&) { return std::vector<double>(); });
        warnings.push_back(
            asWarning(fileError(phrase("the traces of this run cannot be read: {}", fault.what()), file.string())));
        return run;
    }
}

/// The pinned ones and the last of the others, oldest first.
std::vector<const PastRun*> runsToKeep(const std::vector<PastRun>& runs, const HistoryLimits& limits) {
    std::vector<const PastRun*> kept;
    std::size_t pinned = 0, others = 0;
    for (auto run = runs.rbegin(); run != runs.rend(); ++run)
        if (run->isPinned ? pinned++ < limits.pinned : others++ < limits.runs) kept.push_back(&*run);
    std::reverse(kept.begin(), kept.end());
    return kept;
}

/// Places of the runs in the order in which their traces take the room.
std::vector<std::size_t> byClaim(const std::vector<const PastRun*>& runs) {
    std::vector<std::size_t> order(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) order[i] = runs.size() - 1 - i;
    const auto claim = [&](std::size_t i) { return (runs[i]->isShown ? 2 : 0) + (runs[i]->isPinned ? 1 : 0); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return claim(a) > claim(b); });
    return order;
}

}  // namespace

bool hasTraces(const RunResult& result) {
    const auto isThere = [](const ExperimentState& e) { return !e.time.empty(); };
    return std::any_of(result.finding.final.experiments.begin(), result.finding.final.experiments.end(), isThere);
}

Outcome<Done> writeHistory(const std::vector<PastRun>& runs, const fs::path& directory, const HistoryLimits& limits) {
    std::error_code code;
    if (!fs::create_directories(directory, code))
        return cannotWrite(directory, code ? code : std::make_error_code(std::errc::file_exists));
    TraceWriter traces(directory, limits.traceBytes);
    const std::vector<const PastRun*> kept = runsToKeep(runs, limits);
    for (const std::size_t i : byClaim(kept)) {
        const std::string text = traces.keep(*kept[i]);
        const fs::path file = directory / fmt::format("run-{:04}.json", i + 1);
        if (!writeFile(file, text.data(), text.size())) return cannotWrite(file, lastFault());
        if (!traces.failed().empty()) return cannotWrite(traces.failed(), lastFault());
    }
    return Done{};
}

Outcome<std::vector<PastRun>> readHistory(const fs::path& directory, const Study& study) {
    std::vector<fs::path> files;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(directory, code))
        if (isOwnFile(entry.path()) && entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    if (const std::size_t most = HistoryLimits{}.runs + HistoryLimits{}.pinned; files.size() > most)
        files.erase(files.begin(), files.end() - static_cast<std::ptrdiff_t>(most));
    std::vector<PastRun> runs;
    Diagnostics warnings;
    for (const fs::path& file : files) {
        try {
            runs.push_back(readRun(file, study, warnings));
        } catch (const std::exception& fault) {
            warnings.push_back(
                asWarning(fileError(phrase("a run of the history cannot be read: {}", fault.what()), file.string())));
        }
    }
    return {std::move(runs), std::move(warnings)};
}

Outcome<Done> replaceHistory(const std::vector<PastRun>& runs, const fs::path& studyDirectory) {
    const fs::path place = studyDirectory / historyFolder;
    std::error_code code;
    const bool isThere = fs::exists(fs::symlink_status(place, code));
    if (!isThere && runs.empty()) return Done{};
    if (isThere && !isPlainDirectory(place))
        return cannotWrite(place, phrase("a link on its way leads to another directory"));
    const DirectoryLock lock(studyDirectory, DirectoryLock::Kind::Exclusive, longestSave);
    if (lock.isBusy()) return isBeingSaved(studyDirectory);
    const Outcome<OwnedDirectory> own = OwnedDirectory::make(studyDirectory, writingPrefix);
    if (!own) return cannotWrite(place, own.diagnostics().front().message);
    const fs::path fresh = own->path() / historyFolder;
    if (Outcome<Done> done = writeHistory(runs, fresh); !done) return done;
    if (!isThere) {
        code = renameToNew(fresh, place);
    } else if (const std::vector<fs::path> old = ownFiles(place);
               old.size() != entriesOf(place) || exchange(fresh, place)) {
        code = replaceFiles(fresh, place, old);
    } else if (runs.empty()) {
        fs::remove(place, code);
    }
    return code ? Outcome<Done>(cannotWrite(place, code)) : Outcome<Done>(Done{});
}

}  // namespace analogon
