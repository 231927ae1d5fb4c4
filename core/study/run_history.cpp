#include "core/study/run_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

#include "core/base/file_fault.hpp"
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

std::error_code lastFault() { return {errno, std::generic_category()}; }

bool writeFile(const fs::path& file, const char* bytes, std::size_t count) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(bytes, static_cast<std::streamsize>(count));
    stream.close();
    return stream.good();
}

std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error(fmt::format("'{}' is not there", file.filename().string()));
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
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
    const std::size_t count = std::min(limits.runs, runs.size());
    for (std::size_t i = 0; i < count; ++i) {  // the latest first: they have the first claim on the room
        const std::string text = traces.keep(runs[runs.size() - 1 - i]);
        const fs::path file = directory / fmt::format("run-{:04}.json", count - i);
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
    if (const std::size_t most = HistoryLimits{}.runs; files.size() > most)
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
    const fs::path place = studyDirectory / historyFolder, beside = studyDirectory / ".run-history.writing";
    std::error_code code;
    fs::remove_all(beside, code);
    if (!runs.empty())
        if (Outcome<Done> done = writeHistory(runs, beside); !done) {
            fs::remove_all(beside, code);
            return done;
        }
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(place, code))
        if (isOwnFile(entry.path())) old.push_back(entry.path());
    for (const fs::path& file : old) fs::remove(file, code);
    if (fs::is_empty(place, code)) fs::remove(place, code);
    code.clear();
    if (runs.empty()) return Done{};
    fs::create_directories(place, code);
    std::vector<fs::path> fresh;
    for (const auto& entry : fs::directory_iterator(beside, code)) fresh.push_back(entry.path());
    for (const fs::path& file : fresh) {
        fs::rename(file, place / file.filename(), code);
        if (code) return cannotWrite(place / file.filename(), code);
    }
    fs::remove(beside, code);  // fails where something could not be listed and moved
    return code ? Outcome<Done>(cannotWrite(place, code)) : Outcome<Done>(Done{});
}

}  // namespace analogon
