/// An archive reads itself alone, and holds what it needs for that.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "core/archive/archive.hpp"
#include "core/archive/zip_directory.hpp"
#include "core/study/run.hpp"
#include "tests/core/archive/archive_place.hpp"
#include "tests/tree.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

void put(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}

class ArchiveReach : public ArchivePlace {
protected:
    /// A study of a gain whose block comes from libraries: a package within it, a package beside it, a file elsewhere.
    fs::path study(const std::string& libraries) const {
        const fs::path at = root / "study";
        put(at / "model.mo",
            "model M\n  Analogon.Interfaces.RealInput u;\n  Analogon.Interfaces.RealOutput y;\n"
            "  Workshop.Inner.Twice first;\n  Half second;\n  Own.Thrice third;\nequation\n  connect(u, first.u);\n"
            "  connect(first.y, second.u);\n  connect(second.y, third.u);\n  connect(third.y, y);\nend M;\n");
        put(at / "run.csv", "t [s],u,y\n0,1,3\n1,2,6.5\n2,3,9\n");
        put(at / "study.json",
            "{\"format\": \"analogon-study-1\", \"class\": \"M\", \"library\": [" + libraries +
                "],\n \"experiments\": [{\"name\": \"x\", \"role\": \"fit\", \"file\": \"run.csv\", \"time\": \"t\", "
                "\"inputs\": {\"u\": \"u\"}, \"outputs\": {\"y\": \"y\"}}], \"parameters\": {}}");
        put(root / "blocks/Workshop 1.2/package.mo", "package Workshop\nend Workshop;\n");
        put(root / "blocks/Workshop 1.2/notes.txt", "of nobody's concern");
        put(root / "blocks/Workshop 1.2/Inner/package.mo", "within Workshop;\npackage Inner\nend Inner;\n");
        put(root / "blocks/Workshop 1.2/Inner/package.order", "Twice\n");
        put(root / "blocks/Workshop 1.2/Inner/Twice.mo", "within Workshop.Inner;\n" + gain("Twice", "2"));
        put(root / "elsewhere/Half.mo", gain("Half", "0.5"));
        put(at / "own/Own/package.mo", "package Own\nend Own;\n");
        put(at / "own/Own/Thrice.mo", "within Own;\n" + gain("Thrice", "3"));
        return at;
    }
    static std::string gain(const std::string& name, const std::string& factor) {
        return "model " + name +
               "\n  Analogon.Interfaces.RealInput u;\n  Analogon.Interfaces.RealOutput y;\nequation\n  y = " + factor +
               "*u;\nend " + name + ";\n";
    }
    std::string allLibraries() const {
        return "\"../blocks/Workshop 1.2\", \"" + (root / "elsewhere/Half.mo").string() + "\", \"own/Own\"";
    }
    static std::vector<double> simulated(const Study& study) {
        const Outcome<RunResult> run = runSimulate(study, {});
        EXPECT_TRUE(run) << format(run.diagnostics());
        if (!run) return {};
        const Eigen::VectorXd& y = run->finding.final.experiments.at(0).outputs.at(0).simulated;
        return {y.begin(), y.end()};
    }
};

/// Of each member of study.json that is a path; what lies elsewhere is a file of whoever opens the archive.
TEST_F(ArchiveReach, EndsWithTheArchiveForEveryPathOfTheStudy) {
    put(root / "secret.csv", "t,u\n0,1\n1,2\n");
    put(root / "secret.mo", "root:x:0:0:secret words\n");
    put(root / "secret/package.mo", "root:x:0:0:secret words\n");
    const std::string member[] = {
        "\"experiments\": [{\"name\": \"x\", \"role\": \"fit\", \"file\": \"%\", \"time\": \"t\", \"inputs\": {}, "
        "\"outputs\": {\"y\": \"u\"}}]",
        "\"experiments\": [], \"library\": [\"inside.mo\", \"%\"]",
        "\"experiments\": [], \"report\": {\"logo\": \"%\"}"};
    for (const std::string& each : member)
        for (const std::string& path :
             {(root / "secret.csv").string(), std::string("../secret.csv"), std::string("data/../../secret.csv"),
              (root / "secret.mo").string(), std::string("../secret.mo"), std::string("../secret"),
              std::string("/etc/passwd"), std::string("..")}) {
            fs::remove_all(root / "from");
            std::string text = each;
            text.replace(text.find('%'), 1, path);
            put(root / "from/study.json",
                "{\"format\": \"analogon-study-1\", \"class\": \"M\",\n " + text + ", \"parameters\": {}}");
            put(root / "from/model.mo", "model M\nend M;\n");
            put(root / "from/inside.mo", "model Inside\nend Inside;\n");
            ASSERT_TRUE(zipDirectory(root / "from", root / "a.analogon"));
            const auto opened = openStudy(root / "a.analogon");
            ASSERT_FALSE(opened) << text;
            const std::string shown = format(opened.diagnostics());
            EXPECT_EQ(opened.diagnostics().size(), 1u) << shown;
            EXPECT_THAT(shown, HasSubstr("is not in the archive"));
            EXPECT_THAT(shown, StartsWith((root / "a.analogon/study.json:2:").string()));
            EXPECT_THAT(shown, Not(HasSubstr("secret words")));
        }
}

TEST_F(ArchiveReach, HoldsTheLibrariesOfItsStudy) {
    const Outcome<Study> study = readStudy(this->study(allLibraries()));
    ASSERT_TRUE(study) << format(study.diagnostics());
    const std::vector<double> before = simulated(*study);
    EXPECT_EQ(before, (std::vector<double>{3, 6, 9}));
    ASSERT_TRUE(saveStudy(*study, root / "packed.analogon"));
    for (const char* gone : {"study", "blocks", "elsewhere"}) fs::remove_all(root / gone);
    const auto opened = openStudy(root / "packed.analogon");
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(simulated(opened->study), before);
    EXPECT_THAT(opened->study.libraryPaths, testing::ElementsAre("library/Workshop 1.2", "library/Half.mo", "own/Own"));
    EXPECT_FALSE(fs::exists(opened->study.directory / "library/Workshop 1.2/notes.txt"));

    ASSERT_TRUE(saveStudy(opened->study, root / "again.analogon")) << "as the window saves what it has opened";
    ASSERT_TRUE(unpackArchive(root / "again.analogon", root / "out"));
    const Outcome<Study> unpacked = readStudy(root / "out");
    ASSERT_TRUE(unpacked) << format(unpacked.diagnostics());
    EXPECT_EQ(simulated(*unpacked), before);
}

TEST_F(ArchiveReach, GivesLibrariesOfOneNameTwoPlaces) {
    put(root / "more/Half.mo", gain("OtherHalf", "0.5"));
    const Outcome<Study> study = readStudy(this->study(allLibraries() + ", \"../more/Half.mo\""));
    ASSERT_TRUE(study);
    ASSERT_TRUE(saveStudy(*study, root / "packed.analogon"));
    const auto opened = openStudy(root / "packed.analogon");
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->study.libraryPaths.back(), "library_2/Half.mo");
    const Outcome<Library> library = studyLibrary(opened->study);
    ASSERT_TRUE(library) << format(library.diagnostics());
    EXPECT_TRUE(library->find("Half"));
    EXPECT_TRUE(library->find("OtherHalf"));
}

/// As results are: what was relative to one directory is not to another.
TEST_F(ArchiveReach, OfAStudyWrittenElsewhereLeadsToTheSameLibraries) {
    const Outcome<Study> study = readStudy(this->study(allLibraries()));
    ASSERT_TRUE(study);
    ASSERT_TRUE(writeStudy(*study, root / "deep/er/study"));
    const Outcome<Study> written = readStudy(root / "deep/er/study");
    ASSERT_TRUE(written) << format(written.diagnostics());
    EXPECT_EQ(written->libraryPaths.front(), (fs::canonical(root) / "blocks/Workshop 1.2").string());
    EXPECT_EQ(simulated(*written), simulated(*study));
    ASSERT_TRUE(writeStudy(*study, study->directory));
    EXPECT_EQ(readStudy(study->directory)->libraryPaths, study->libraryPaths) << "at its own place nothing changes";
}

/// What a run ran on was read elsewhere, too.
TEST_F(ArchiveReach, OfItsHistoryIsThatOfTheStudy) {
    const Outcome<Study> study = readStudy(this->study(allLibraries()));
    ASSERT_TRUE(study);
    const Outcome<RunResult> result = runSimulate(*study, {});
    ASSERT_TRUE(result);
    const PastRun run{"fit", "2026-03-01T14:02:11", 1, std::make_shared<const Study>(*study),
                      std::make_shared<const RunResult>(*result)};
    ASSERT_TRUE(saveStudy(*study, root / "packed.analogon", {run}));
    const auto opened = openStudy(root / "packed.analogon");
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    ASSERT_EQ(opened->history.size(), 1u);
    EXPECT_EQ(opened->history[0].ranOn->libraryPaths, opened->study.libraryPaths);
    EXPECT_EQ(opened->history[0].result->completed.libraryPaths, opened->study.libraryPaths);
}

TEST_F(ArchiveReach, IsToldByItsEntries) {
    put(root / "from/study.json", "{}");
    put(root / "from/a", "a file");
    put(root / "from/b/c", "below what will be a file");
    ASSERT_TRUE(zipDirectory(root / "from", root / "a.analogon"));
    std::string bytes = bytesOf(root / "a.analogon");
    for (std::size_t at = 0; (at = bytes.find("b/c", at)) != std::string::npos;) bytes[at] = 'a';
    put(root / "a.analogon", bytes);
    for (const Diagnostics& faults : {openStudy(root / "a.analogon").diagnostics(),
                                      unpackArchive(root / "a.analogon", root / "out").diagnostics()}) {
        ASSERT_EQ(faults.size(), 1u);
        EXPECT_EQ(faults.front().message, "the entry \"a/c\" lies below the entry \"a\", which is a file");
        EXPECT_EQ(faults.front().place.file, (root / "a.analogon").string());
    }
}

/// A disk that is full is played by a limit of the size of files.
TEST_F(ArchiveReach, IsToldWithoutTheDirectoryItIsUnpackedInto) {
    put(root / "from/study.json", "{}");
    put(root / "from/data/run.csv", std::string(300'000, '7'));
    ASSERT_TRUE(zipDirectory(root / "from", root / "a.analogon"));
    struct rlimit whole {};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &whole), 0);
    const struct rlimit small { 100'000, whole.rlim_max };
    const auto handler = signal(SIGXFSZ, SIG_IGN);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const Diagnostics all[] = {openStudy(root / "a.analogon").diagnostics(),
                               unpackArchive(root / "a.analogon", root / "out").diagnostics()};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &whole), 0);
    signal(SIGXFSZ, handler);
    for (const Diagnostics& faults : all) {
        std::string shown = format(faults);
        ASSERT_EQ(faults.size(), 1u) << shown;
        EXPECT_THAT(shown, StartsWith((root / "a.analogon").string() +
                                      ": error: the entry \"data/run.csv\" cannot be unpacked: the disk may be full"));
        EXPECT_THAT(shown, Not(HasSubstr("analogon-writing-")));
        for (std::size_t at = 0; (at = shown.find(root.string())) != std::string::npos;)
            shown.erase(at, root.string().size());
        EXPECT_THAT(shown, Not(HasSubstr("/files/"))) << "that of the test itself apart";
    }
}

/// Packing takes the place of what was packed from the same study alone.
TEST_F(ArchiveReach, IsPackedOverItsOwnEarlierPackAlone) {
    const fs::path first = study(allLibraries()), file = root / "a.analogon";
    const auto opened = openStudy(first);
    ASSERT_TRUE(opened);
    put(file, "");
    for (int time = 0; time < 3; ++time) ASSERT_TRUE(packStudy(*opened, file)) << "also over an empty file";
    const auto byFile = openStudy(first / "study.json");
    ASSERT_TRUE(byFile);
    ASSERT_TRUE(packStudy(*byFile, file)) << "the same study, named otherwise";
    fs::copy(first, root / "copy", fs::copy_options::recursive);
    const auto other = openStudy(root / "copy");
    ASSERT_TRUE(other);
    const auto before = treeOf(root);
    const Outcome<Done> refused = packStudy(*other, file);
    ASSERT_FALSE(refused);
    EXPECT_THAT(format(refused.diagnostics()), HasSubstr("this exists already and is another study"));
    EXPECT_EQ(treeOf(root), before);
    const auto packed = openStudy(file);
    ASSERT_TRUE(packed);
    ASSERT_TRUE(saveStudy(packed->study, file)) << "as the window does";
    EXPECT_FALSE(packStudy(*opened, file)) << "what was saved since is kept";
    put(root / "notes.analogon", "mine");
    EXPECT_THAT(format(packStudy(*opened, root / "notes.analogon").diagnostics()),
                HasSubstr("this exists already and is no study"));
}

TEST_F(ArchiveReach, LeavesTheEarlierPackWherePackingIsStopped) {
    const auto opened = openStudy(study(allLibraries()));
    ASSERT_TRUE(opened);
    ASSERT_TRUE(packStudy(*opened, root / "a.analogon"));
    const auto before = treeOf(root);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(packStudy(*opened, root / "a.analogon", Progress(stop.get_token(), {})));
    EXPECT_FALSE(packStudy(*opened, root / "b.analogon", Progress(stop.get_token(), {})));
    EXPECT_EQ(treeOf(root), before);
}

}  // namespace
}  // namespace analogon
