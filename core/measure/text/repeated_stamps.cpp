#include <algorithm>
#include <cmath>

#include "core/base/median.hpp"
#include "core/measure/text/remark.hpp"
#include "core/measure/text/time_column.hpp"

namespace analogon {

namespace {

/// Rows [begin, end) with one stamp.
struct Run {
    std::size_t begin{}, end{};
    std::size_t size() const { return end - begin; }
};

std::vector<Run> runsOf(const std::vector<double>& stamps) {
    std::vector<Run> runs;
    for (std::size_t i = 0; i < stamps.size();) {
        Run run{i, i + 1};
        while (run.end < stamps.size() && stamps[run.end] == stamps[i]) ++run.end;
        runs.push_back(run);
        i = run.end;
    }
    return runs;
}

/// All runs but the first and the last are as long as each other, and their stamps follow by one step: the stamps are
/// those of an even raster, rounded to that step.
bool areRounded(const std::vector<double>& stamps, const std::vector<Run>& runs) {
    constexpr std::size_t fewest = 4;
    if (runs.size() < fewest) return false;
    std::size_t shortest = runs[1].size(), longest = shortest;
    double least = INFINITY, most = 0;
    for (std::size_t k = 1; k + 1 < runs.size(); ++k) {
        shortest = std::min(shortest, runs[k].size());
        longest = std::max(longest, runs[k].size());
        const double step = stamps[runs[k + 1].begin] - stamps[runs[k].begin];
        least = std::min(least, step);
        most = std::max(most, step);
    }
    // one stamp in many that repeats is another fault
    const bool areMany = 10 * (stamps.size() - runs.size()) >= 3 * stamps.size();
    return areMany && longest >= 2 && longest - shortest <= std::max<std::size_t>(1, longest / 10) &&
           runs.front().size() <= longest && runs.back().size() <= longest && most - least <= 1e-3 * most;
}

/// The even raster of which the stamps are rounded: a straight line through the middles of the runs. Of the steps that
/// the runs allow, the one with the fewest digits.
struct Raster {
    double start{}, step{};
};

Raster rasterOf(const std::vector<double>& stamps, const std::vector<Run>& runs) {
    double count = 0, meanIndex = 0, meanStamp = 0;
    const auto middle = [&](std::size_t k) {
        return static_cast<double>(runs[k].begin) + 0.5 * static_cast<double>(runs[k].size() - 1);
    };
    for (std::size_t k = 1; k + 1 < runs.size(); ++k) {
        count += 1;
        meanIndex += middle(k);
        meanStamp += stamps[runs[k].begin] - stamps.front();
    }
    meanIndex /= count;
    meanStamp /= count;
    double product = 0, square = 0;
    for (std::size_t k = 1; k + 1 < runs.size(); ++k) {
        product += (middle(k) - meanIndex) * (stamps[runs[k].begin] - stamps.front() - meanStamp);
        square += (middle(k) - meanIndex) * (middle(k) - meanIndex);
    }
    double step = product / square;
    const double tolerance = step / static_cast<double>(runs.back().begin - runs[1].begin);
    for (int digits = 1; digits <= 6; ++digits) {
        const double unit = std::pow(10.0, std::floor(std::log10(step)) - (digits - 1));
        const double round = std::round(step / unit) * unit;
        if (std::abs(round - step) > tolerance) continue;
        step = round;
        break;
    }
    return {stamps.front() + meanStamp - step * meanIndex, step};
}

Diagnostics layEvenly(Table& table, std::size_t time, const std::vector<Run>& runs) {
    Column& column = table.columns[time];
    std::vector<double>& stamps = column.values;
    const auto [start, step] = rasterOf(stamps, runs);
    const std::size_t shared = runs[1].size();
    const double digit = stamps[runs[2].begin] - stamps[runs[1].begin];
    for (std::size_t i = 0; i < stamps.size(); ++i)
        if (std::abs(start + static_cast<double>(i) * step - stamps[i]) > digit) return {};
    for (std::size_t i = 0; i < stamps.size(); ++i) stamps[i] = start + static_cast<double>(i) * step;
    return {doubt(
        phrase("the stamps in column '{}' have too few digits: about {} rows share each; they are laid on an even "
               "raster of {:.6g} {}",
               cited(column.name), shared, step, column.unit.empty() ? std::string("s") : column.unit),
        table.file, table.lines.front(),
        phrase("Export the time with more digits, or tell the time between two rows: \"read\": {{\"time_format\": "
               "\"0.001 s\"}}."))};
}

/// Whether the stamps around each repeated one leave room for it at the usual step.
bool leaveRoom(const std::vector<double>& stamps, const std::vector<Run>& runs, double step) {
    constexpr double tolerance = 0.25;  // of a step
    std::size_t repeated = 0;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        if (runs[k].size() == 1) continue;
        repeated += runs[k].size() - 1;
        if (k + 1 == runs.size()) return false;
        const double gap = stamps[runs[k + 1].begin] - stamps[runs[k].begin];
        if (std::abs(gap - static_cast<double>(runs[k].size()) * step) > tolerance * step) return false;
    }
    return 5 * repeated < stamps.size();
}

Diagnostics spread(Table& table, std::size_t time, const std::vector<Run>& runs) {
    constexpr std::size_t shown = 10;
    Column& column = table.columns[time];
    std::vector<std::string> lines;
    std::size_t count = 0;
    for (std::size_t k = 0; k + 1 < runs.size(); ++k) {
        const double from = column.values[runs[k].begin], to = column.values[runs[k].end];
        for (std::size_t i = runs[k].begin + 1; i < runs[k].end; ++i) {
            column.values[i] =
                from + (to - from) * static_cast<double>(i - runs[k].begin) / static_cast<double>(runs[k].size());
            if (++count <= shown) lines.push_back(std::to_string(table.lines[i]));
        }
    }
    return {doubt(
        phrase("the time in column '{}' repeats in {} rows and goes on evenly around them: these rows are spread over "
               "their gap (lines {})",
               cited(column.name), count, listed(lines)),
        table.file, table.lines[runs.front().begin])};
}

}  // namespace

Diagnostics mendRepeatedStamps(Table& table, std::size_t time) {
    const std::vector<double>& stamps = table.columns[time].values;
    bool isRepeated = false;
    for (std::size_t i = 1; i < stamps.size(); ++i) {
        if (!(stamps[i] >= stamps[i - 1])) return {};  // it falls, or a stamp is missing
        isRepeated = isRepeated || stamps[i] == stamps[i - 1];
    }
    if (!isRepeated) return {};
    const std::vector<Run> runs = runsOf(stamps);
    if (areRounded(stamps, runs)) return layEvenly(table, time, runs);
    std::vector<double> steps;
    for (std::size_t k = 1; k < runs.size(); ++k)
        if (runs[k - 1].size() == 1) steps.push_back(stamps[runs[k].begin] - stamps[runs[k - 1].begin]);
    if (steps.empty() || !leaveRoom(stamps, runs, median(std::move(steps)))) return {};
    return spread(table, time, runs);
}

}  // namespace analogon
