#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/syntax/parser.hpp"
#include "core/syntax/printer.hpp"

namespace analogon::syntax {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// The files of the packages of the Modelica Standard Library that lie in the directories of MODELICAPATH.
std::vector<fs::path> standardLibraryFiles() {
    std::vector<fs::path> files;
    const char* const path = std::getenv("MODELICAPATH");
    std::istringstream directories(path ? path : "");
    for (std::string directory; std::getline(directories, directory, ':');)
        for (const char* package : {"Modelica", "ModelicaTest", "ModelicaServices", "Complex.mo"}) {
            const fs::path root = fs::path(directory) / package;
            std::error_code problem;
            if (fs::is_regular_file(root, problem)) files.push_back(root);
            if (!fs::is_directory(root, problem)) continue;
            for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root))
                if (entry.path().extension() == ".mo") files.push_back(entry.path());
        }
    return files;
}

TEST(StandardLibrary, EveryFileIsReadAndTheTextOfItsTreeIsReadAsTheSameTree) {
    const std::vector<fs::path> files = standardLibraryFiles();
    if (files.empty()) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    std::size_t faulty = 0;
    for (const fs::path& file : files) {
        const std::string text = contentOf(file);
        const ParseResult first = parse(std::make_shared<const Source>(file.string(), text));
        if (!first.diagnostics.empty()) {
            if (++faulty <= 20) ADD_FAILURE() << format(first.diagnostics.front());
            continue;
        }
        EXPECT_EQ(first.definition.source->text(), text);
        const std::string printed = print(first.definition);
        const ParseResult second = parse(std::make_shared<const Source>("printed", printed));
        if (!second.diagnostics.empty()) {
            if (++faulty <= 20) ADD_FAILURE() << file << "\n" << format(second.diagnostics.front());
            continue;
        }
        if (print(second.definition) != printed && ++faulty <= 20) ADD_FAILURE() << file << " changes when printed";
    }
    EXPECT_EQ(faulty, 0u) << "of " << files.size();
    std::cout << files.size() << " files, " << faulty << " faulty\n";
}

}  // namespace
}  // namespace analogon::syntax
