#include "app/analogon-cli/simulate_class.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string_view>

#include "core/base/file_fault.hpp"
#include "core/base/stop.hpp"
#include "core/measure/table.hpp"
#include "core/study/class_run.hpp"
#include "core/study/results.hpp"

namespace analogon::cli {

namespace {

constexpr std::size_t mostValues = 20'000'000;  // of traces.csv, which then has some 350 MB

int fails(const Diagnostics& faults, std::ostream& err) {
    err << format(faults) << '\n';
    const bool isNumerical =
        std::any_of(faults.begin(), faults.end(), [](const Diagnostic& d) { return d.isNumerical; });
    return isNumerical ? numericsFailed : inputAtFault;
}

/// `*` stands for anything, `?` for one character. What stands behind the last `*` is tried ever later: an earlier one
/// needs no second try.
bool matches(std::string_view name, std::string_view pattern) {
    std::size_t n = 0, p = 0, star = std::string_view::npos, from = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            from = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++from;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

std::vector<std::string> namesOf(const FlatModel& model, const System& system,
                                 const std::vector<std::string>& patterns) {
    std::vector<std::string> names = tracedNames(model, system);
    std::erase_if(names, [&](const std::string& name) {
        return !patterns.empty() &&
               std::none_of(patterns.begin(), patterns.end(), [&](const std::string& p) { return matches(name, p); });
    });
    return names;
}

/// The text of a number, kept for the next row: most of what a model tells stands still most of the time.
class Cell {
public:
    std::string_view of(double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        if (size_ == 0 || bits != bits_) size_ = fmt::format_to_n(text_.data(), text_.size(), "{}", value).size;
        bits_ = bits;
        return {text_.data(), size_};
    }

private:
    std::uint64_t bits_{};
    std::array<char, 32> text_;
    std::size_t size_{};
};

std::string csvOf(const EventTrajectory& run, const std::vector<std::string>& names) {
    std::string text = "time";
    for (const std::string& name : names) text += ',' + csvCell(name);
    const std::size_t heading = text.size();
    Cell time;
    std::vector<Cell> cells(names.size());
    for (std::size_t k = 0; k < run.time.size(); ++k) {
        if (k % 4096 == 0) stopPoint();
        if (k == 256) text.reserve(heading + (text.size() - heading) / k * run.time.size() * 9 / 8);
        text += '\n';
        text += time.of(run.time[k]);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            text += ',';
            text += cells[i].of(run.rows[k][i]);
        }
    }
    return text + '\n';
}

}  // namespace

int simulateClass(const Options& options, std::ostream& out, std::ostream& err) {
    Outcome<Library> library = builtInLibrary();
    for (const std::filesystem::path& path : options.libraries)
        if (library) library = library->withPath(path);
    if (!library) return fails(library.diagnostics(), err);
    Outcome<FlatModel> flat = flatten(*library, options.className);
    if (!flat) return fails(flat.diagnostics(), err);
    if (!flat.diagnostics().empty()) err << format(flat.diagnostics()) << '\n';
    const LibraryClass& cls = *library->find(options.className);
    EventRunOptions run = experimentOf(*library, cls);
    if (options.stop) run.stop = *options.stop;
    if (options.interval) run.interval = *options.interval;
    if (options.tolerance) run.tolerance = *options.tolerance;
    Outcome<ResultsPlace> place = ResultsPlace::take(options.out);
    if (!place) return fails(place.diagnostics(), err);
    if (!(run.stop >= run.start))
        return fails({fileError(phrase("the simulation would end at {}, before it begins at {}", run.stop, run.start),
                                options.className)},
                     err);
    const auto wanted = [&](const System& system) { return namesOf(*flat, system, options.variables); };
    const std::size_t most = options.interval ? std::numeric_limits<std::size_t>::max() : mostValues;
    const Outcome<ClassRun> simulated = runAlone(*flat, wanted, run, Progress(stopInForce(), {}), most);
    stopPoint();
    if (!simulated) return fails(simulated.diagnostics(), err);
    const EventTrajectory& trajectory = simulated->trajectory;
    if (run.interval > 0 && simulated->interval > 1.001 * run.interval)
        err << format(
                   {warning(phrase("the results are told every {:.3g} s, not every {:.3g} s: these would be more than "
                                   "{} values",
                                   simulated->interval, run.interval, mostValues),
                            {}, phrase("choose among the variables with --variables, or insist with --interval"))})
            << '\n';
    if (!trajectory.remarks.empty()) err << format(trajectory.remarks) << '\n';
    const Outcome<Done> written = place->writeTraces(csvOf(trajectory, simulated->names));
    if (!written) return fails(written.diagnostics(), err);
    out << fmt::format("{}: {} to {} s, {} states, {} steps, {} events\n", options.className, run.start, run.stop,
                       simulated->states, trajectory.steps, trajectory.events);
    return done;
}

}  // namespace analogon::cli
