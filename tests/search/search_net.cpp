// Compares what two versions of the search decide, study by study. See README.md beside this file.
//
//   search_net summarise REPORT.json TRACE.jsonl SUMMARY.txt
//   search_net condense DIR OUT
//   search_net compare BEFORE AFTER
//
// A directory holds STUDY-THREADS.txt for each study and number of threads; a study that has one on a single thread
// alone came to the same on four.

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "tests/search/summary.hpp"

namespace analogon::net {
namespace {

namespace fs = std::filesystem;

const std::string onOne = "-1.txt", onFour = "-4.txt";

std::string read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + file.string());
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::set<std::string> studiesIn(const fs::path& directory) {
    std::set<std::string> studies;
    for (const fs::directory_entry& entry : fs::directory_iterator(directory))
        if (const std::string name = entry.path().filename().string(); name.ends_with(onOne))
            studies.insert(name.substr(0, name.size() - onOne.size()));
    return studies;
}

Summary summaryIn(const fs::path& directory, const std::string& study, const std::string& threads) {
    const fs::path own = directory / (study + threads);
    return summaryFrom(read(fs::exists(own) ? own : directory / (study + onOne)));
}

int condense(const fs::path& from, const fs::path& into) {
    fs::create_directories(into);
    for (const std::string& study : studiesIn(from)) {
        const Summary one = condensed(summaryIn(from, study, onOne));
        const Summary four = condensed(summaryIn(from, study, onFour));
        write(into / (study + onOne), textOf(one));
        if (differences(one, four).empty())
            fs::remove(into / (study + onFour));
        else
            write(into / (study + onFour), textOf(four));
    }
    return 0;
}

/// Prints what differs; how many lines.
std::size_t tell(const std::string& title, const std::vector<Difference>& all) {
    if (all.empty()) return 0;
    fmt::print("{}\n", title);
    for (const Difference& d : all) fmt::print("  {}\n    - {}\n    + {}\n", d.name, d.before, d.after);
    return all.size();
}

int compare(const fs::path& before, const fs::path& after) {
    const std::set<std::string> was = studiesIn(before), is = studiesIn(after);
    std::size_t compared = 0, differing = 0, byThreads = 0;
    for (const std::string& study : was) {
        if (!is.contains(study)) continue;
        ++compared;
        const auto one = differences(summaryIn(before, study, onOne), summaryIn(after, study, onOne));
        const auto four = differences(summaryIn(before, study, onFour), summaryIn(after, study, onFour));
        const std::size_t lines = tell(study + " on 1 thread", one) + tell(study + " on 4 threads", four);
        differing += lines > 0 ? 1 : 0;
        const auto threads = differences(summaryIn(after, study, onOne), summaryIn(after, study, onFour));
        byThreads += threads.empty() ? 0 : 1;
        tell(study + ": 4 threads against 1, of the second", threads);
    }
    for (const std::string& study : was)
        if (!is.contains(study)) fmt::print("{}: only in the first\n", study);
    for (const std::string& study : is)
        if (!was.contains(study)) fmt::print("{}: only in the second\n", study);
    fmt::print("{} studies compared: {} differ; {} depend on the number of threads\n", compared, differing, byThreads);
    return differing > 0 || byThreads > 0 || compared == 0 ? 1 : 0;
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() == 4 && arguments[0] == "summarise") {
        write(arguments[3], textOf(summaryOf(read(arguments[1]), read(arguments[2]))));
        return 0;
    }
    if (arguments.size() == 3 && arguments[0] == "condense") return condense(arguments[1], arguments[2]);
    if (arguments.size() == 3 && arguments[0] == "compare") return compare(arguments[1], arguments[2]);
    fmt::print(stderr,
               "search_net summarise REPORT.json TRACE.jsonl SUMMARY.txt | condense DIR OUT | compare BEFORE AFTER\n");
    return 2;
}

}  // namespace
}  // namespace analogon::net

int main(int argc, char** argv) {
    try {
        return analogon::net::run({argv + 1, argv + argc});
    } catch (const std::exception& fault) {
        fmt::print(stderr, "search_net: {}\n", fault.what());
        return 2;
    }
}
