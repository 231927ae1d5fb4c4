#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "core/flat/flat_model.hpp"
#include "core/structure/structure.hpp"

/// Wrong models with one fault each (tests/models/faults/*.mo) and the whole of what is said about them (beside them,
/// *.expected): place, line, caret, hint. ANALOGON_WRITE_EXPECTED=1 writes the files anew; read them before keeping
/// them.
namespace analogon {
namespace {

namespace fs = std::filesystem;

const fs::path folder = std::string(ANALOGON_ROOT) + "/tests/models/faults";

std::string contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string((std::istreambuf_iterator<char>(file)), {});
}

/// What `check` says of the model M in a text.
std::string messagesOf(const fs::path& path) {
    const Outcome<Library> builtIn = builtInLibrary();
    const Outcome<Library> library =
        builtIn->withSource(std::make_shared<const Source>(path.filename().string(), contentOf(path)));
    if (!library) return format(library.diagnostics());
    const Outcome<FlatModel> flat = flatten(*library, "M");
    if (!flat) return format(flat.diagnostics());
    const Outcome<Structure> structure = analyse(std::make_shared<const FlatModel>(*flat));
    Diagnostics all = flat.diagnostics();
    const Diagnostics& more = structure ? structure->warnings : structure.diagnostics();
    all.insert(all.end(), more.begin(), more.end());
    return format(all);
}

TEST(Diagnostics, SayOfEachFaultWhatIsExpected) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".mo") continue;
        ++count;
        const std::string messages = messagesOf(entry.path());
        fs::path expected = entry.path();
        expected.replace_extension(".expected");
        if (std::getenv("ANALOGON_WRITE_EXPECTED")) std::ofstream(expected, std::ios::binary) << messages;
        EXPECT_FALSE(messages.empty()) << entry.path();
        EXPECT_EQ(messages, contentOf(expected)) << entry.path();
    }
    EXPECT_GE(count, 30);
}

}  // namespace
}  // namespace analogon
