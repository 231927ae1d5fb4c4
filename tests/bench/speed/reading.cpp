// How fast measurement files are read, and in how much memory:
//   reading [ROWS] [DIRECTORY]     10 000 000 rows, files of 1.7 GB in the directory for temporary files
// A text against a count of its lines in the same run, each form of a text against the memory of its values, the list
// of a file of 2 000 channels and three of them. Processor time counts: the machine may be busy. Fails where one misses
// its limit.
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>

#include "core/measure/open/open_recording.hpp"
#include "core/measure/open/read_table.hpp"
#include "tests/bench/speed/measuring.hpp"
#include "tests/core/measure/mdf/mdf4_writer.hpp"

namespace analogon::speed {
namespace {

namespace fs = std::filesystem;

constexpr double leastRate = 150;                         // [MB/s] of text
constexpr double mostMemory = 3;                          // times the values that are kept
constexpr double mostListTime = 1, mostListMemory = 200;  // [s], [MB]
constexpr double mostChannelTime = 1;                     // [s] for ten million samples

class Report {
public:
    void tell(bool isGood, const std::string& line) {
        fmt::print("{} {}\n", isGood ? "  " : "! ", line);
        std::fflush(stdout);
        isAllGood_ = isAllGood_ && isGood;
    }
    bool isAllGood() const { return isAllGood_; }

private:
    bool isAllGood_{true};
};

/// Digits that look like those of a measurement, the same in each run.
std::string number(std::size_t row, unsigned column, char mark = '.') {
    const std::size_t value = (row * 7919 + column * 104729) % 199'999;
    return fmt::format("{}{}{}{:04}", value % 3 == 0 ? "-" : "", value % 19, mark, value % 10'000);
}

/// How the rows of one form of a text are written.
struct Form {
    std::string name, head;
    std::function<std::string(std::size_t row)> row;
    bool isWide{};
};

std::string clockOf(std::size_t row, char mark) {
    const std::size_t ms = row * 5, s = ms / 1000;
    return fmt::format("{:02}:{:02}:{:02}{}{:03}", 10 + s / 3600 % 13, s / 60 % 60, s % 60, mark, ms % 1000);
}

std::string isoDay(std::size_t row) { return fmt::format("2024-03-{:02}", 5 + row * 5 / 1000 / 46'800); }
std::string germanDay(std::size_t row) { return fmt::format("{:02}.03.2024", 5 + row * 5 / 1000 / 46'800); }

std::string usStamp(std::size_t row) {
    const std::size_t ms = row * 5, s = ms / 1000, hour = s / 3600 % 12;
    return fmt::format("03/{:02}/2024 {:02}:{:02}:{:02}.{:03} {}", 5 + s / 86'400, hour == 0 ? 12 : hour, s / 60 % 60,
                       s % 60, ms % 1000, s / 43'200 % 2 == 0 ? "AM" : "PM");
}

std::vector<Form> forms(std::size_t rows) {
    const auto v = [](std::size_t row, unsigned column) { return number(row, column); };
    const auto time = [](std::size_t row) { return fmt::format("{:.3f}", static_cast<double>(row) * 5e-3); };
    return {
        {"time and a value", "t [s],u [V]\n", [=](auto i) { return time(i) + ',' + v(i, 1) + '\n'; }},
        {"German stamps, one value", "Zeit;U [V]\n",
         [](auto i) { return germanDay(i) + ' ' + clockOf(i, ',') + ';' + number(i, 1, ',') + '\n'; }},
        {"German stamps, three values", "Zeit;U [V];I [A];T [degC]\n",
         [](auto i) {
             return germanDay(i) + ' ' + clockOf(i, ',') + ';' + number(i, 1, ',') + ';' + number(i, 2, ',') + ';' +
                    number(i, 3, ',') + '\n';
         }},
        {"US stamps, one value", "Time,U [V]\n", [=](auto i) { return usStamp(i) + ',' + v(i, 1) + '\n'; }},
        {"ISO stamps with a zone, one value", "Time,U [V]\n",
         [=](auto i) { return isoDay(i) + 'T' + clockOf(i, '.') + "Z," + v(i, 1) + '\n'; }},
        {"date and clock in two columns", "Datum;Uhrzeit;U [V]\n",
         [](auto i) { return germanDay(i) + ';' + clockOf(i, ',') + ';' + number(i, 1, ',') + '\n'; }},
        {"a clock alone", "Uhrzeit;U [V]\n", [](auto i) { return clockOf(i, ',') + ';' + number(i, 1, ',') + '\n'; }},
        {"words between the values", "t [s],state,u [V],i [A]\n",
         [=](auto i) {
             static constexpr std::array words{"idle", "running", "stopped", "alarm"};
             return time(i) + ',' + words[i / 1000 % 4] + ',' + v(i, 1) + ',' + v(i, 2) + '\n';
         }},
        {"names in front of the numbers", "",
         [=](auto i) { return "t=" + time(i) + " T1:" + v(i, 1) + " U:" + v(i, 2) + '\n'; }},
        {"two rasters", "t1 [s],a [V],t2 [s],b [V]\n",
         [=](auto i) {
             return time(i) + ',' + v(i, 1) + ',' + fmt::format("{:.3f}", static_cast<double>(i) * 6e-3) + ',' +
                    v(i, 2) + '\n';
         }},
        {"a Modelica table", fmt::format("#1\ndouble tab({},3)\n", rows),
         [=](auto i) { return time(i) + ' ' + v(i, 1) + ' ' + v(i, 2) + '\n'; }},
        {"nineteen digits each", "# t a b c\n",
         [=](auto i) {
             const auto x = static_cast<double>(i);
             return fmt::format("{:.18e} {:.18e} {:.18e} {:.18e}\n", x * 5e-3, 1 / (x + 3), x / 7, x / 11);
         }},
        {"UTF-16", "t [s],u [V],i [A],T [degC]\n",
         [=](auto i) { return time(i) + ',' + v(i, 1) + ',' + v(i, 2) + ',' + v(i, 3) + '\n'; }, true}};
}

void writeText(const fs::path& file, const Form& form, std::size_t rows) {
    std::ofstream out(file, std::ios::binary);
    const auto put = [&](const std::string& text) {
        if (!form.isWide) {
            out << text;
            return;
        }
        std::string wide;
        for (const char c : text) (wide += c) += '\0';
        out << wide;
    };
    if (form.isWide) out << "\xFF\xFE";
    std::string part = form.head;
    for (std::size_t row = 0; row < rows; ++row) {
        part += form.row(row);
        if (part.size() < (1u << 20)) continue;
        put(part);
        part.clear();
    }
    put(part);
}

std::size_t valuesOf(const Table& table) {
    std::size_t count = 0;
    for (const Column& column : table.columns) count += column.values.size();
    for (const auto& other : table.others) count += valuesOf(*other);
    return count;
}

struct Reading {
    double seconds{}, memory{};  // [s] of a processor, [MB]
    std::size_t values{};
};

Reading readText(const fs::path& file) {
    Reading reading;
    reading.memory = peakMemory([&] {
        const double begin = now();
        const auto looked = lookAtTextFile(file);
        reading.seconds = now() - begin;
        if (looked && looked->table) reading.values = valuesOf(**looked->table);
    });
    return reading;
}

double countLines(const fs::path& file) {
    const double begin = now();
    std::ifstream in(file, std::ios::binary);
    std::vector<char> part(1 << 18);
    std::size_t lines = 0;
    while (in.read(part.data(), static_cast<std::streamsize>(part.size())), in.gcount() > 0) {
        const char* const end = part.data() + in.gcount();
        for (const char* at = part.data(); (at = static_cast<const char*>(std::memchr(at, '\n', end - at))); ++at)
            ++lines;
    }
    return lines > 0 ? now() - begin : 0;
}

void measureText(const fs::path& folder, std::size_t rows, Report& report) {
    const fs::path file = folder / "reading.csv";
    const Form wide{"", "t [s],a [V],b [A],c [degC],d [N.m],e [rpm],f [bar],g [K]\n", [](std::size_t i) {
                        std::string line = fmt::format("{:.4f}", static_cast<double>(i) * 1e-4);
                        for (unsigned column = 1; column < 8; ++column) line += ',' + number(i, column);
                        return line + '\n';
                    }};
    writeText(file, wide, rows);
    const double size = static_cast<double>(fs::file_size(file)) / 1e6, lines = countLines(file);
    const Reading reading = readText(file);
    const double rate = size / reading.seconds, kept = static_cast<double>(reading.values) * 8e-6;
    report.tell(
        rate >= leastRate && reading.values == 8 * rows,
        fmt::format("text of {} rows and 8 columns, {:.0f} MB: {:.2f} s of a processor, {:.0f} MB/s ({:.1f} times "
                    "the {:.2f} s of counting its lines)",
                    rows, size, reading.seconds, rate, reading.seconds / lines, lines));
    report.tell(reading.memory <= mostMemory * kept,
                fmt::format("  {:.0f} MB at most, {:.2f} times its values", reading.memory, reading.memory / kept));
    fs::remove(file);
}

void measureForms(const fs::path& folder, std::size_t rows, Report& report) {
    for (const Form& form : forms(rows)) {
        const fs::path file = folder / "form.csv";
        writeText(file, form, rows);
        const Reading reading = readText(file);
        const double kept = static_cast<double>(reading.values) * 8e-6;
        report.tell(kept > 0 && reading.memory <= mostMemory * kept,
                    fmt::format("{}: {:.0f} MB at most, {:.2f} times the {:.0f} MB of its values; {:.0f} MB/s",
                                form.name, reading.memory, reading.memory / std::max(kept, 1e-9), kept,
                                static_cast<double>(fs::file_size(file)) / 1e6 / reading.seconds));
        fs::remove(file);
    }
}

constexpr unsigned groups = 40, perGroup = 50, wide = 8 + 2 * (perGroup - 1);

/// 40 groups of 50 channels, the first of which has nearly all of the samples.
void writeMdf4(const fs::path& file, std::size_t samples) {
    test::Mdf4Writer writer;
    const std::uint64_t linear = writer.conversion(1, {0.5, 0.01});
    std::uint64_t next = 0;
    test::Bytes few;
    for (int i = 0; i < 10; ++i) few.put(0.1 * i).put(std::string(wide - 8, '\1'));
    for (unsigned g = groups; g-- > 0;) {
        const bool isLong = g == 0;
        std::uint64_t channel = 0;
        for (unsigned c = perGroup; c-- > 0;)
            channel = c == 0 ? writer.channel({"time", "s", 2}, channel)
                             : writer.channel({fmt::format("signal_{}_{}", g, c), "V", 0, 2, 16, 8 + 2 * (c - 1), 0,
                                               c % 2 == 0 ? linear : 0},
                                              channel);
        const std::uint64_t group =
            writer.channelGroup(fmt::format("group {}", g), channel, isLong ? samples : 10, wide);
        const std::uint64_t data = isLong ? 0 : writer.block("DT", {}, few.text);
        next = writer.dataGroup(group, data, 0, next);
    }
    const std::uint64_t data = writer.block("DT", {}, "", 24 + std::uint64_t{wide} * samples);
    std::memcpy(writer.bytes().data() + next + 24 + 16, &data, 8);
    writer.finish(next, file);
    std::ofstream out(file, std::ios::binary | std::ios::app);
    std::string part;
    for (std::size_t i = 0; i < samples; ++i) {
        test::Bytes record;
        record.put(static_cast<double>(i) * 1e-4);
        for (unsigned c = 1; c < perGroup; ++c) record.put(static_cast<std::int16_t>((i * c) % 20'000));
        part += record.text;
        if (part.size() < (1u << 20) && i + 1 < samples) continue;
        out << part;
        part.clear();
    }
}

void measureMdf4(const fs::path& folder, std::size_t samples, Report& report) {
    const fs::path file = folder / "reading.mf4";
    writeMdf4(file, samples);
    double seconds = 0;
    std::optional<Outcome<MeasurementFile>> opened;
    const double memory = peakMemory([&] {
        const double begin = now();
        opened = openRecording(file);
        seconds = now() - begin;
    });
    std::size_t channels = 0;
    if (*opened)
        for (const RecordedGroup& group : (*opened)->groups) channels += group.channels.size();
    report.tell(channels == groups * perGroup && seconds < mostListTime && memory < mostListMemory,
                fmt::format("MDF 4 of {} MB: its {} channels are listed in {:.3f} s and {:.1f} MB",
                            fs::file_size(file) / 1'000'000, channels, seconds, memory));
    constexpr std::array<std::size_t, 3> wanted{0, 10, 49};
    const double limit = mostChannelTime * wanted.size() * std::max(1.0, static_cast<double>(samples) / 1e7);
    bool isRight = false;
    const double reading = peakMemory([&] {
        const double begin = now();
        const auto values = (*opened)->reader->read(0, wanted, {});
        seconds = now() - begin;
        isRight = values && (*values)[2].numbers.size() == samples && (*values)[1].numbers[7] == 0.5 + 0.01 * 70;
    });
    report.tell(isRight && seconds < limit,
                fmt::format("  three of them, {} samples each: {:.2f} s a channel, {:.0f} MB at most ({:.2f} times the "
                            "values)",
                            samples, seconds / 3, reading, reading / (static_cast<double>(3 * samples) * 8e-6)));
    fs::remove(file);
}

}  // namespace
}  // namespace analogon::speed

int main(int argc, char** argv) {
    using namespace analogon::speed;
    const std::size_t rows = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10'000'000;
    const std::filesystem::path folder = argc > 2 ? argv[2] : std::filesystem::temp_directory_path();
    Report report;
    measureMdf4(folder, rows, report);
    measureForms(folder, std::max<std::size_t>(1000, rows / 10), report);
    measureText(folder, rows, report);
    return report.isAllGood() ? EXIT_SUCCESS : EXIT_FAILURE;
}
