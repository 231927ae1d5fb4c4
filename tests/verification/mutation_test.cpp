#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "core/eval/system.hpp"
#include "core/syntax/parser.hpp"
#include "tests/mutants.hpp"

/// Texts that are nearly Modelica: the library and the example models with bytes and words changed at random. Each must
/// end in a system or in messages, soon and within bounds of memory. ANALOGON_MUTATIONS sets their number and
/// ANALOGON_MUTATION_FIRST the first; the run with sanitizers takes 10 000.
namespace analogon {
namespace {

namespace fs = std::filesystem;

struct Seed {
    fs::path path;
    std::string text;
};

std::vector<Seed> seeds() {
    std::vector<Seed> found;
    for (const char* folder : {"/resources/Analogon", "/examples", "/tests/models"})
        for (const auto& entry : fs::recursive_directory_iterator(std::string(ANALOGON_ROOT) + folder)) {
            if (entry.path().extension() != ".mo") continue;
            std::ifstream file(entry.path(), std::ios::binary);
            const Seed seed{entry.path(), std::string(std::istreambuf_iterator<char>(file), {})};
            // Whole models reach the later stages; a class of the library often ends as unbalanced.
            found.insert(found.end(), entry.path().string().find("/resources/") == std::string::npos ? 8 : 1, seed);
        }
    std::sort(found.begin(), found.end(), [](const Seed& a, const Seed& b) { return a.path < b.path; });
    return found;
}

/// The words of a text as they stand: names, numbers, single signs.
std::vector<std::pair<std::size_t, std::size_t>> wordsOf(const std::string& text) {
    std::vector<std::pair<std::size_t, std::size_t>> words;
    const auto isWord = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.'; };
    for (std::size_t i = 0; i < text.size();) {
        if (std::isspace(static_cast<unsigned char>(text[i]))) {
            ++i;
            continue;
        }
        std::size_t end = i + 1;
        if (isWord(text[i]))
            while (end < text.size() && isWord(text[end])) ++end;
        words.emplace_back(i, end - i);
        i = end;
    }
    return words;
}

class Mutator {
public:
    explicit Mutator(unsigned index) : random_(index * 7919u + 17u) {}

    std::string operator()(std::string text) {
        constexpr int counts[] = {1, 1, 1, 2, 3, 8};
        for (int n = counts[pick(6)]; n > 0; --n) {
            if (text.empty()) text = std::string(1, '\0');
            switch (pick(6)) {
                case 0:
                    changeBytes(text);
                    break;
                case 1:
                case 2:
                    changeWords(text);
                    break;
                default:
                    exchangeAlike(text);
            }
        }
        return text;
    }

private:
    std::size_t pick(std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random_); }

    void changeBytes(std::string& text) {
        const std::size_t at = pick(text.size());
        switch (pick(6)) {
            case 0:
                text[at] = static_cast<char>(text[at] ^ (1 << pick(8)));
                break;
            case 1:
                text[at] = static_cast<char>(pick(256));
                break;
            case 2:
                text.erase(at, 1 + pick(64));
                break;
            case 3:
                text.insert(at, text.substr(at, 1 + pick(64)));
                break;
            case 4:
                text.resize(at);
                break;
            default:
                text.insert(at, std::string(1 + pick(8), static_cast<char>(pick(2) * 255)));
        }
    }

    /// A name for another name, a number for a number, a sign for a sign: often still Modelica.
    void exchangeAlike(std::string& text) {
        const auto words = wordsOf(text);
        if (words.empty()) return;
        const auto kind = [&text](std::size_t at) {
            const auto c = static_cast<unsigned char>(text[at]);
            return std::isdigit(c) ? 0 : std::isalpha(c) ? 1 : 2;
        };
        const auto [at, length] = words[pick(words.size())];
        for (int tries = 0; tries < 50; ++tries) {
            const auto [from, count] = words[pick(words.size())];
            if (kind(from) != kind(at)) continue;
            text.replace(at, length, text.substr(from, count));
            return;
        }
    }

    void changeWords(std::string& text) {
        const auto words = wordsOf(text);
        if (words.empty()) return;
        const auto [at, length] = words[pick(words.size())];
        const auto [from, count] = words[pick(words.size())];
        const std::string other = text.substr(from, count);
        static const char* const spices[] = {"0",      "-1",        "1e308",      "1e-320", "der(",       ")",
                                             "each ",  "[1]",       "[3]",        "=",      "flow ",      "final ",
                                             "time",   "if x then", "9999999999", "inner ", "parameter ", "delay(u, 1)",
                                             "{1, 2}", "equation ", "extends A;"};
        switch (pick(5)) {
            case 0:
                text.replace(at, length, other);
                break;
            case 1:
                text.insert(at, other + " ");
                break;
            case 2:
                text.erase(at, length);
                break;
            case 3:
                text.insert(at, spices[pick(std::size(spices))]);
                break;
            default:
                text.replace(at, length, spices[pick(std::size(spices))]);
        }
    }

    std::mt19937 random_;
};

/// All that `check` does, and the start of a simulation. Returns whether some class came through.
bool goesThrough(const Library& builtIn, const Seed& seed, std::string text) {
    const auto source = std::make_shared<const Source>(seed.path.filename().string(), std::move(text));
    const syntax::ParseResult parsed = syntax::parse(source);
    const Outcome<Library> library = builtIn.withSource(source);
    EXPECT_EQ(hasError(parsed.diagnostics), !library || hasError(library.diagnostics()));
    if (!library) {
        EXPECT_FALSE(format(library.diagnostics()).empty());
        return false;
    }
    bool any = false;
    const std::string prefix = parsed.definition.within && !parsed.definition.within->parts.empty()
                                   ? parsed.definition.within->text() + "."
                                   : "";
    for (const syntax::ClassPtr& definition : parsed.definition.classes) {
        const Outcome<SystemPtr> system = compile(*library, prefix + definition->name);
        if (!system) {
            EXPECT_FALSE(format(system.diagnostics()).empty());
            continue;
        }
        any = true;
        const System& s = **system;
        Workspace w = s.workspace(0);
        std::vector<double> p, u(static_cast<std::size_t>(s.slotCount())), x(static_cast<std::size_t>(s.stateCount())),
            slopes(x.size()), y(static_cast<std::size_t>(s.outputCount()));
        for (const SignalInfo& info : s.parameters()) p.push_back(info.value);
        if (s.setParameters(w, p) && s.initialise(w, 0, u, x) && s.derivatives(w, 0, x, u, slopes))
            static_cast<void>(s.outputs(w, 0, x, u, y));
    }
    return any;
}

unsigned numberFrom(const char* variable, unsigned otherwise) {
    const char* text = std::getenv(variable);
    return text ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
}

/// Runs every text and keeps the figures.
class Campaign {
public:
    void run(const Library& builtIn, const Seed& seed, std::string text) {
        const double begin = processorTime();
        through_ += goesThrough(builtIn, seed, std::move(text));
        if (const double spent = processorTime() - begin; spent > slowest_) {
            slowest_ = spent;
            slowestCount_ = count_;
        }
        ++count_;
    }
    void finish() const {
        EXPECT_LT(slowest_, 10.0) << "text " << slowestCount_;
        EXPECT_GT(through_, 0u);
        EXPECT_LT(through_, count_);
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        const double memory = static_cast<double>(usage.ru_maxrss) / 1024;  // [MiB]
        EXPECT_LT(memory, 1024);
        std::printf("%u mutations, %u models; slowest %.2f s (number %u); %.0f MiB\n", count_, through_, slowest_,
                    slowestCount_, memory);
    }

private:
    double slowest_{};  // [s] of a processor
    unsigned slowestCount_{}, through_{}, count_{};
};

TEST(Mutations, EndInASystemOrInMessages) {
    const Outcome<Library> builtIn = builtInLibrary();
    ASSERT_TRUE(builtIn) << format(builtIn.diagnostics());
    const std::vector<Seed> all = seeds();
    ASSERT_FALSE(all.empty());
    const unsigned first = numberFrom("ANALOGON_MUTATION_FIRST", 0), count = numberFrom("ANALOGON_MUTATIONS", 400);
    Campaign campaign;
    for (unsigned i = first; i < first + count; ++i) {
        SCOPED_TRACE(i);
        const Seed& seed = all[i % all.size()];
        campaign.run(*builtIn, seed, Mutator(i)(seed.text));
        if (HasFatalFailure() || HasNonfatalFailure()) break;
    }
    campaign.finish();
}

/// The files of the Modelica Standard Library in a directory of MODELICAPATH that are not very long.
std::vector<Seed> standardSeeds() {
    constexpr std::uintmax_t longest = 60'000;
    const char* const path = std::getenv("MODELICAPATH");
    std::vector<Seed> found;
    if (!path || !fs::exists(fs::path(path) / "Modelica" / "package.mo")) return found;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(path) / "Modelica")) {
        if (entry.path().extension() != ".mo" || entry.file_size() > longest) continue;
        std::ifstream file(entry.path(), std::ios::binary);
        found.push_back({entry.path(), std::string(std::istreambuf_iterator<char>(file), {})});
    }
    std::sort(found.begin(), found.end(), [](const Seed& a, const Seed& b) { return a.path < b.path; });
    return found;
}

TEST(Mutations, OfTheStandardLibraryEndInASystemOrInMessages) {
    const std::vector<Seed> all = standardSeeds();
    if (all.empty()) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    const Outcome<Library> builtIn = builtInLibrary();
    ASSERT_TRUE(builtIn) << format(builtIn.diagnostics());
    const Library library = builtIn->withDirectories({std::getenv("MODELICAPATH")});
    const unsigned first = numberFrom("ANALOGON_MUTATION_FIRST", 0), count = numberFrom("ANALOGON_MUTATIONS", 400);
    Campaign campaign;
    for (unsigned i = first; i < first + count; ++i) {
        SCOPED_TRACE(i);
        const Seed& seed = all[i * 7919ull % all.size()];
        campaign.run(library, seed, Mutator(i)(seed.text));
        if (HasFatalFailure() || HasNonfatalFailure()) break;
    }
    campaign.finish();
}

/// The same for texts that another program has changed: all .mo files of the folder ANALOGON_MUTATION_FOLDER.
TEST(Mutations, MadeElsewhereEndInASystemOrInMessages) {
    const char* folder = std::getenv("ANALOGON_MUTATION_FOLDER");
    if (!folder) GTEST_SKIP() << "ANALOGON_MUTATION_FOLDER names no folder of changed texts";
    const Outcome<Library> builtIn = builtInLibrary();
    ASSERT_TRUE(builtIn) << format(builtIn.diagnostics());
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".mo") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    ASSERT_FALSE(files.empty());
    const char* trace = std::getenv("ANALOGON_MUTATION_TRACE");  // a file that names the text at work
    Campaign campaign;
    for (const fs::path& path : files) {
        SCOPED_TRACE(path);
        if (trace) std::ofstream(trace) << path.string() << '\n';
        std::ifstream file(path, std::ios::binary);
        campaign.run(*builtIn, {path, {}}, std::string(std::istreambuf_iterator<char>(file), {}));
        if (HasFatalFailure() || HasNonfatalFailure()) break;
    }
    campaign.finish();
}

}  // namespace
}  // namespace analogon
