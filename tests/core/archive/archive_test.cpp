#include "core/archive/archive.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include "core/archive/archive_limits.hpp"
#include "core/archive/zip_directory.hpp"
#include "core/study/run.hpp"
#include "tests/core/archive/archive_place.hpp"
#include "tests/kills.hpp"
#include "tests/tree.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;

class Archive : public ArchivePlace {
protected:
    Study example() const {
        Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        EXPECT_TRUE(study) << format(study.diagnostics());
        return std::move(*study);
    }
};

TEST_F(Archive, ReadsBackWhatItWrote) {
    const Study study = example();
    const fs::path file = root / "lambda.analogon";
    ASSERT_TRUE(saveStudy(study, file));
    const Outcome<OpenedStudy> read = openStudy(file);
    ASSERT_TRUE(read) << format(read.diagnostics());
    EXPECT_EQ(read->study.name, "lambda");
    EXPECT_EQ(studyJson(read->study), studyJson(study));
    EXPECT_EQ(read->study.models, study.models);
    for (const char* name : {"train.csv", "validation.csv"})
        EXPECT_EQ(bytesOf(read->study.directory / name), bytesOf(study.directory / name)) << name;
    EXPECT_EQ(read->study.tables.at("train.csv")->file, (file / "train.csv").string());
}

/// The file is one that the program of November 2026 wrote. It is never made anew.
TEST_F(Archive, ReadsAFileOfTheFirstFormat) {
    const Outcome<OpenedStudy> read = openStudy(ANALOGON_ROOT "/tests/core/archive/version-1.analogon");
    ASSERT_TRUE(read) << format(read.diagnostics());
    const Study& study = read->study;
    EXPECT_EQ(study.className, "HeatedBody");
    EXPECT_EQ(study.models.size(), 2u) << "a class file of its own beside the model";
    ASSERT_EQ(study.experiments.size(), 2u);
    const StudyExperiment &heating = study.experiments[0], &cycle = study.experiments[1];
    EXPECT_EQ(heating.role, Role::Fit);
    EXPECT_EQ(cycle.role, Role::Validate);
    EXPECT_EQ(heating.range, std::pair(10.0, 500.0));
    EXPECT_EQ(heating.inputs.at("power").scale, 0.99);
    EXPECT_EQ(heating.inputs.at("power").offset, 0.1);
    EXPECT_EQ(heating.outputs.at("T").weight, 2);
    EXPECT_EQ(heating.outputs.at("T").clock, 0.5);
    EXPECT_TRUE(std::holds_alternative<FittedStart>(heating.initial.at("body.T_start")));
    EXPECT_EQ(std::get<ColumnStart>(cycle.initial.at("body.T_start")).column, "T_body");
    EXPECT_EQ(cycle.outputs.at("T").unit, "degC");
    const StudyParameter& capacity = study.parameters.at("body.C");
    EXPECT_EQ(capacity.value, 29.5);
    EXPECT_EQ(capacity.max, 500);
    ASSERT_TRUE(capacity.prior);
    EXPECT_EQ(capacity.prior->mean, 30);
    EXPECT_EQ(capacity.prior->deviation, 2);
    EXPECT_FALSE(study.parameters.at("radiation.k_r").fit);
    EXPECT_NE(study.extraJson.find("nobody knows it"), std::string::npos) << "what is not known is kept";

    const Outcome<RunResult> run = runSimulate(study, {});
    ASSERT_TRUE(run) << format(run.diagnostics());
    EXPECT_NEAR(run->finding.final.experiments[0].errorPercent, 0.77779, 1e-4);
    EXPECT_NEAR(run->finding.final.experiments[1].errorPercent, 0.90434, 1e-4);

    ASSERT_TRUE(saveStudy(study, root / "now.analogon"));
    const Outcome<OpenedStudy> again = openStudy(root / "now.analogon");
    ASSERT_TRUE(again) << format(again.diagnostics());
    EXPECT_EQ(studyJson(again->study), studyJson(study));
    EXPECT_EQ(again->study.models, study.models);
}

/// The history of runs lies in a folder of its own: the study beside it is what it is without one, for whoever reads it
/// by the rules of the first version (study.json, the models at the top, the measurements it names).
TEST_F(Archive, KeepsTheHistoryOfItsRunsBesideTheStudy) {
    const Study study = example();
    const Outcome<RunResult> result = runSimulate(study, {});
    ASSERT_TRUE(result);
    const std::vector<PastRun> history{{"fit", "2026-03-01T14:02:11", 1, std::make_shared<const Study>(study),
                                        std::make_shared<const RunResult>(*result)}};
    ASSERT_TRUE(saveStudy(study, root / "with.analogon", history));
    ASSERT_TRUE(saveStudy(study, root / "without.analogon"));
    const Outcome<OpenedStudy> opened = openStudy(root / "with.analogon");
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_TRUE(opened.diagnostics().empty()) << format(opened.diagnostics());
    ASSERT_EQ(opened->history.size(), 1u);
    const ExperimentState &was = result->finding.final.experiments[0],
                          &now = opened->history[0].result->finding.final.experiments[0];
    EXPECT_EQ(now.time, was.time);
    EXPECT_EQ(now.outputs[0].simulated, was.outputs[0].simulated);

    ASSERT_TRUE(unpackArchive(root / "with.analogon", root / "with"));
    ASSERT_TRUE(unpackArchive(root / "without.analogon", root / "without"));
    for (const auto& entry : fs::directory_iterator(root / "without"))
        EXPECT_EQ(bytesOf(root / "with" / entry.path().filename()), bytesOf(entry.path()));
    for (const auto& entry : fs::directory_iterator(root / "with"))
        EXPECT_TRUE(entry.path().filename() == historyFolder || fs::exists(root / "without" / entry.path().filename()))
            << entry.path();
    EXPECT_EQ(bytesOf(root / "with.analogon").substr(30, 8), "mimetype");
    const Outcome<OpenedStudy> directory = openStudy(root / "with");
    ASSERT_TRUE(directory);
    EXPECT_EQ(directory->history.size(), 1u) << "what is unpacked can be packed again";
    EXPECT_TRUE(openStudy(ANALOGON_ROOT "/tests/core/archive/version-1.analogon")->history.empty());
}

TEST_F(Archive, LosesADamagedHistoryAndNotTheStudy) {
    const Study study = example();
    const Outcome<RunResult> result = runSimulate(study, {});
    ASSERT_TRUE(result);
    const PastRun run{"fit", "2026-03-01T14:02:11", 1, std::make_shared<const Study>(study),
                      std::make_shared<const RunResult>(*result)};
    ASSERT_TRUE(saveStudy(study, root / "whole.analogon", {run, run}));
    const std::string whole = bytesOf(root / "whole.analogon");
    const Outcome<std::vector<ZipEntry>> entries = readZipDirectory(root / "whole.analogon");
    ASSERT_TRUE(entries);
    int damaged = 0;
    for (const ZipEntry& entry : *entries) {
        if (!entry.name.starts_with(historyFolder)) continue;
        std::string bytes = whole;
        bytes[entry.offset + 30 + entry.name.size() + entry.packedSize / 2] ^= 0x11;  // in the middle of its data
        std::ofstream(root / "damaged.analogon", std::ios::binary) << bytes;
        const Outcome<OpenedStudy> opened = openStudy(root / "damaged.analogon");
        ASSERT_TRUE(opened) << entry.name << ": " << format(opened.diagnostics());
        EXPECT_EQ(studyJson(opened->study), studyJson(study));
        EXPECT_FALSE(opened.diagnostics().empty()) << entry.name;
        EXPECT_FALSE(hasError(opened.diagnostics()));
        if (entry.name.ends_with(".json")) {
            EXPECT_EQ(opened->history.size(), 1u) << "the other run is whole";
        } else {
            EXPECT_EQ(opened->history.size(), 2u) << "its figures are there";
        }
        ++damaged;
    }
    EXPECT_GE(damaged, 4);
}

TEST_F(Archive, StartsWithItsTypeAtAFixedPlace) {
    ASSERT_TRUE(saveStudy(example(), root / "a.analogon"));
    const std::string bytes = bytesOf(root / "a.analogon");
    EXPECT_EQ(bytes.substr(30, 8), "mimetype");
    EXPECT_EQ(bytes.substr(38, std::string(archiveType).size()), archiveType);
}

TEST_F(Archive, ZipsADirectoryAsItIs) {
    fs::create_directories(root / "from" / "sources");
    std::ofstream(root / "from" / "sources" / "a.c") << "int a;\n";
    std::ofstream(root / "from" / "b.xml") << "<b/>";
    ASSERT_TRUE(zipDirectory(root / "from", root / "a.zip"));
    const Outcome<std::vector<ZipEntry>> entries = readZipDirectory(root / "a.zip");
    ASSERT_TRUE(entries) << format(entries.diagnostics());
    ASSERT_EQ(entries->size(), 2u);
    EXPECT_EQ((*entries)[0].name, "b.xml");
    EXPECT_EQ((*entries)[1].name, "sources/a.c");
    EXPECT_EQ((*entries)[1].size, 7u);
    EXPECT_FALSE(zipDirectory(root / "from", root / "nowhere" / "a.zip"));
}

TEST_F(Archive, UnpacksByteForByteIntoANewDirectoryOnly) {
    ASSERT_TRUE(saveStudy(example(), root / "a.analogon"));
    ASSERT_TRUE(unpackArchive(root / "a.analogon", root / "out"));
    EXPECT_EQ(bytesOf(root / "out/model.mo"), example().models.at("model.mo"));
    EXPECT_FALSE(fs::exists(root / "out/mimetype"));
    const auto again = unpackArchive(root / "a.analogon", root / "out");
    ASSERT_FALSE(again);
    EXPECT_NE(again.diagnostics().front().message.find("not empty"), std::string::npos);
}

TEST_F(Archive, KeepsTheOldFileWhenTheNewOneCannotBeWritten) {
    const fs::path file = root / "a.analogon";
    ASSERT_TRUE(saveStudy(example(), file));
    const std::string before = bytesOf(file);
    Study broken = example();
    broken.experiments.front().file = "nowhere.csv";
    EXPECT_FALSE(saveStudy(broken, file));
    EXPECT_EQ(bytesOf(file), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(root), fs::directory_iterator{}), 1) << "nothing is left behind";
}

TEST_F(Archive, NamesTheEntryAFaultStandsIn) {
    Study study = example();
    study.models["model.mo"] = "model Broken\n  Real x = ;\nend Broken;\n";
    ASSERT_TRUE(saveStudy(study, root / "a.analogon"));
    const auto opened = openStudy(root / "a.analogon");
    ASSERT_TRUE(opened) << "a broken model can still be opened and mended";
    const auto task = estimationTask(opened->study);
    ASSERT_FALSE(task);
    const std::string shown = format(namedAs(task.diagnostics(), *opened));
    EXPECT_TRUE(shown.starts_with((root / "a.analogon/model.mo:2:12").string())) << shown;
}

TEST_F(Archive, RefusesWhatIsNoStudyWithOneSentence) {
    std::ofstream(root / "text.analogon") << "not a zip file";
    const auto opened = openStudy(root / "text.analogon");
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.diagnostics().size(), 1u);
    EXPECT_NE(opened.diagnostics().front().message.find("no zip archive"), std::string::npos);
    EXPECT_FALSE(openStudy(root / "missing.analogon"));
}

TEST_F(Archive, RefusesAFileOfANewerVersionAndNamesTheEntry) {
    fs::create_directories(root / "from");
    std::ofstream(root / "from" / "study.json") << "{\"format\": \"analogon-study-2\", \"model\": {}}";
    std::ofstream(root / "from" / "model.mo") << "model M\nend M;\n";
    ASSERT_TRUE(zipDirectory(root / "from", root / "newer.analogon"));
    const auto opened = openStudy(root / "newer.analogon");
    ASSERT_FALSE(opened);
    const std::string shown = format(opened.diagnostics());
    EXPECT_TRUE(shown.starts_with((root / "newer.analogon/study.json:1").string())) << shown;
    EXPECT_NE(shown.find("newer version of Analogon"), std::string::npos) << shown;
    EXPECT_EQ(opened.diagnostics().size(), 1u) << shown;
}

TEST_F(Archive, SurvivesEveryTruncation) {
    ASSERT_TRUE(saveStudy(example(), root / "whole.analogon"));
    const std::string whole = bytesOf(root / "whole.analogon");
    for (std::size_t i = 0; i < 60; ++i) {
        std::ofstream(root / "cut.analogon", std::ios::binary) << whole.substr(0, whole.size() * i / 60);
        EXPECT_FALSE(openStudy(root / "cut.analogon")) << i;
    }
}

TEST_F(Archive, SurvivesFlippedBytes) {
    Study study = example();
    study.experiments.clear();  // small: the flips hit the structure
    ASSERT_TRUE(saveStudy(study, root / "whole.analogon"));
    const std::string whole = bytesOf(root / "whole.analogon");
    std::mt19937 random(7);
    int refused = 0;
    for (int i = 0; i < 300; ++i) {
        std::string bytes = whole;
        bytes[random() % bytes.size()] ^= static_cast<char>(1 << (random() % 8));
        std::ofstream(root / "flipped.analogon", std::ios::binary) << bytes;
        refused += openStudy(root / "flipped.analogon") ? 0 : 1;
    }
    EXPECT_GT(refused, 150);  // the others hit time stamps and attributes
}

TEST_F(Archive, RefusesHostileArchives) {
    const fs::path hostile = ANALOGON_ROOT "/../shared/verification/hostile";
    if (!fs::exists(hostile / "MANIFEST.csv")) GTEST_SKIP() << "the hostile files are not here";
    std::ifstream manifest(hostile / "MANIFEST.csv");
    int count = 0;
    for (std::string line; std::getline(manifest, line);) {
        std::istringstream cells(line);
        std::string file, bytes, expected;
        std::getline(cells, file, ',');
        std::getline(cells, bytes, ',');
        std::getline(cells, expected, ',');
        if (!file.starts_with("zip/")) continue;
        ++count;
        const auto entries = readZipDirectory(hostile / file);
        const auto unpacked = unpackArchive(hostile / file, root / "out" / fs::path(file).stem());
        EXPECT_FALSE(unpacked) << file << ": none of them is a study";
        EXPECT_EQ(unpacked.diagnostics().size(), 1u) << file;
        const std::string message = unpacked ? "" : unpacked.diagnostics().front().message;
        for (const char c : message) EXPECT_GE(static_cast<unsigned char>(c), 0x20) << file;
        if (expected == "seed") {
            EXPECT_TRUE(entries) << file << format(entries.diagnostics());
        }
        if (file == "zip/rtl_name.zip") {
            EXPECT_NE(format(entries.diagnostics()).find("\\u{202e}"), std::string::npos);
        }
    }
    EXPECT_GT(count, 10);
    EXPECT_FALSE(fs::exists(root / "out")
                     ? fs::recursive_directory_iterator(root / "out") != fs::recursive_directory_iterator{}
                     : false)
        << "nothing was unpacked";
}

/// What is unpacked is bounded before it is: by entry, by all of them, by how far they expand, by their number.
TEST_F(Archive, IsRefusedWhereItHoldsTooMuch) {
    const ZipEntry study{"study.json", 8, 0, 1000, 4000, 0};
    const auto fault = [&](std::vector<ZipEntry> entries) {
        entries.push_back(study);
        const Outcome<Done> checked = checkLimits("a.analogon", entries);
        return checked ? std::string() : checked.diagnostics().front().message.english();
    };
    constexpr std::uint64_t mega = 1u << 20;
    EXPECT_EQ(fault({{"train.csv", 8, 0, 100 * mega, 1500 * mega, 0}}), "");
    EXPECT_EQ(fault({{"zeros.csv", 8, 0, mega / 40, 20 * mega, 0}}), "") << "small enough whatever it expands to";
    EXPECT_EQ(fault({{"train.csv", 8, 0, mega, 1000 * mega, 0}}),
              "the entry \"train.csv\" unpacks to 1000 times its size, more than 250");
    EXPECT_EQ(fault({{"model.mo", 8, 0, 10 * mega, 100 * mega, 0}}),
              "the entry \"model.mo\" unpacks to 100 MB, more than 64 MB");
    EXPECT_EQ(fault({{"train.csv", 8, 0, 1000 * mega, 3000 * mega, 0}}),
              "the entry \"train.csv\" unpacks to 3000 MB, more than 2048 MB");
    std::vector<ZipEntry> many;
    for (int i = 0; i < 60; ++i) many.push_back({fmt::format("{}.csv", i), 8, 0, mega / 60, 16 * mega, 0});
    EXPECT_NE(fault(many).find("the archive unpacks to 9"), std::string::npos) << fault(many);
    many.assign(5, {"x.csv", 8, 0, 100 * mega, 1000 * mega, 0});
    EXPECT_EQ(fault(many), "the archive unpacks to 5000 MB, more than 4096 MB");
    many.assign(20'001, {"x.csv", 8, 0, 10, 10, 0});
    EXPECT_EQ(fault(many), "the archive holds 20002 files, more than 20000");
}

TEST_F(Archive, OfAMegabyteThatHoldsAHundredIsRefusedAtOnce) {
    fs::create_directories(root / "from");
    std::ofstream(root / "from" / "study.json") << "{}";
    std::ofstream(root / "from" / "zeros.csv") << std::string(100u << 20, '0');
    ASSERT_TRUE(zipDirectory(root / "from", root / "bomb.analogon"));
    EXPECT_LT(fs::file_size(root / "bomb.analogon"), 1u << 20);
    const auto opened = openStudy(root / "bomb.analogon");
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.diagnostics().front().message.find("times its size"), std::string::npos);
    EXPECT_FALSE(unpackArchive(root / "bomb.analogon", root / "out"));
    EXPECT_FALSE(fs::exists(root / "out"));
}

TEST_F(Archive, ReadsItselfAlone) {
    std::ofstream(root / "secret.csv") << "t,u\n0,1\n1,2\n";
    for (const std::string& file :
         {(root / "secret.csv").string(), std::string("../secret.csv"), std::string("data/../../secret.csv")}) {
        fs::remove_all(root / "from");
        fs::create_directories(root / "from");
        std::ofstream(root / "from" / "study.json")
            << "{\"format\": \"analogon-study-1\", \"class\": \"M\",\n \"experiments\": [{\"name\": \"x\", \"role\": "
               "\"fit\", \"file\": \""
            << file << "\", \"time\": \"t\", \"inputs\": {}, \"outputs\": {\"y\": \"u\"}}], \"parameters\": {}}";
        std::ofstream(root / "from" / "model.mo") << "model M\nend M;\n";
        ASSERT_TRUE(zipDirectory(root / "from", root / "a.analogon"));
        const auto opened = openStudy(root / "a.analogon");
        ASSERT_FALSE(opened) << file;
        const std::string shown = format(opened.diagnostics());
        EXPECT_NE(shown.find("is not in the archive"), std::string::npos) << shown;
        EXPECT_TRUE(shown.starts_with((root / "a.analogon/study.json:2:").string())) << shown;
    }
}

TEST_F(Archive, IsNeverReadFromAPipeNorWrittenOverOne) {
    ASSERT_EQ(mkfifo((root / "pipe.analogon").c_str(), 0600), 0);
    const auto opened = openStudy(root / "pipe.analogon");
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.diagnostics().front().message, "this is a pipe or a device, not a file");
    EXPECT_FALSE(saveStudy(example(), root / "pipe.analogon"));
    EXPECT_TRUE(fs::is_fifo(root / "pipe.analogon"));
    fs::create_symlink("/dev/full", root / "full.analogon");
    EXPECT_FALSE(saveStudy(example(), root / "full.analogon"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(Archive, LiesAtPathsThatAreNoUtf8) {
    const fs::path place = root /
                           "pr\xfc"
                           "fstand";
    fs::create_directories(place);
    ASSERT_TRUE(saveStudy(example(), place / "st\xfc"
                                             "ck.analogon"));
    const auto opened = openStudy(place /
                                  "st\xfc"
                                  "ck.analogon");
    ASSERT_TRUE(opened) << format(opened.diagnostics());
    EXPECT_EQ(opened->study.models, example().models);
    ASSERT_TRUE(unpackArchive(place / "st\xfc"
                                      "ck.analogon",
                              place / "aus\xff"));
    EXPECT_EQ(bytesOf(place / "aus\xff" / "model.mo"), example().models.at("model.mo"));
    EXPECT_TRUE(openStudy(place / "aus\xff"));
    std::ofstream(place / "aus\xff" / "mehr\xe4.mo") << "model More\nend More;\n";
    const auto more = openStudy(place / "aus\xff");
    ASSERT_TRUE(more);
    EXPECT_TRUE(saveStudy(more->study, root / "more.analogon"));
    EXPECT_EQ(readStudy(place / "aus\xff")->models.size(), 2u);
}

TEST_F(Archive, LeavesNothingWhereUnpackingIsStopped) {
    ASSERT_TRUE(saveStudy(example(), root / "a.analogon"));
    std::stop_source stop;
    stop.request_stop();
    const auto unpacked = unpackArchive(root / "a.analogon", root / "deep" / "out", Progress(stop.get_token(), {}));
    ASSERT_FALSE(unpacked);
    EXPECT_EQ(namesBelow(root), "a.analogon");
}

/// What has the name that our own files beside the target would have had is not touched.
TEST_F(Archive, IsWrittenBesideFilesOfAnyName) {
    for (const char* name : {".a.analogon.writing", ".out.writing", ".analogon-writing-1"}) {
        fs::create_directories(root / name);
        std::ofstream(root / name / "notes.txt") << "mine";
    }
    std::ofstream(root / "kept") << "mine";
    fs::create_symlink(root / "kept", root / ".b.analogon.writing");
    const auto before = treeOf(root).size();
    for (const char* name : {"a.analogon", "b.analogon"}) ASSERT_TRUE(saveStudy(example(), root / name));
    ASSERT_TRUE(unpackArchive(root / "a.analogon", root / "out"));
    EXPECT_EQ(bytesOf(root / "kept"), "mine");
    for (const char* name : {"a.analogon", "b.analogon", "out"}) fs::remove_all(root / name);
    EXPECT_EQ(treeOf(root).size(), before);
}

/// As the window saves: a directory or a file, with the runs that the study has seen.
TEST_F(Archive, AndItsHistoryAreWholeWhenTheProgramIsKilled) {
    Study odd = example(), even = odd;
    even.className = "Other";
    const Outcome<RunResult> result = runSimulate(odd, {});
    ASSERT_TRUE(result);
    const PastRun run{"fit", "2026-03-01T14:02:11", 1, std::make_shared<const Study>(odd),
                      std::make_shared<const RunResult>(*result)};
    for (const char* name : {"killed.analogon", "killed"}) {
        const fs::path place = root / name;
        ASSERT_TRUE(saveStudy(odd, place, {run}));
        const auto save = [&] {
            (void)saveStudy(even, place, {run, run});
            (void)saveStudy(odd, place, {run});
        };
        const Kills kills = killWhileSaving(31, save, [&] {
            const auto opened = openStudy(place);
            EXPECT_TRUE(opened) << format(opened.diagnostics());
            if (!opened) return false;
            EXPECT_TRUE(opened.diagnostics().empty()) << format(opened.diagnostics());
            const bool isEven = opened->study.className == "Other";
            const std::size_t runs = opened->history.size();
            EXPECT_TRUE(runs == 1 || runs == 2) << runs;
            if (isArchive(place)) {
                EXPECT_EQ(runs, isEven ? 2u : 1u) << "they are of one version; of a directory the history follows";
            }
            return isEven;
        });
        EXPECT_GT(kills.firsts, 0) << "some kills came after the other was saved";
        EXPECT_LT(kills.firsts, kills.all);
        ASSERT_TRUE(saveStudy(odd, place, {run}));
    }
    std::set<std::string> names;
    for (const auto& [name, text] : treeOf(root)) names.insert(name.substr(0, name.find('/')));
    EXPECT_EQ(names, (std::set<std::string>{"killed", "killed.analogon"}));
    for (const auto& entry : fs::directory_iterator(root / "killed"))
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
}

/// A child that unpacks is killed at random moments: the directory is not there, or whole.
TEST_F(Archive, IsUnpackedWholeOrNotAtAllWhenTheProgramIsKilled) {
    ASSERT_TRUE(saveStudy(example(), root / "a.analogon"));
    const fs::path out = root / "place" / "out";
    fs::create_directories(out.parent_path());
    const auto unpack = [&] {
        if (unpackArchive(root / "a.analogon", out)) fs::rename(out, out.parent_path() / "unpacked");
        fs::remove_all(out.parent_path() / "unpacked");
    };
    bool isOdd = false;  // there are no two versions to be told apart
    const Kills kills = killWhileSaving(23, unpack, [&] {
        if (fs::exists(out)) {
            EXPECT_TRUE(openStudy(out)) << namesBelow(out);
        }
        fs::remove_all(out);
        fs::remove_all(out.parent_path() / "unpacked");
        EXPECT_TRUE(unpackArchive(root / "a.analogon", out)) << "the next one finds its place";
        EXPECT_EQ(std::distance(fs::directory_iterator(out.parent_path()), fs::directory_iterator{}), 1);
        fs::remove_all(out);
        return isOdd = !isOdd;
    });
    EXPECT_GT(kills.all, 0);
}

/// Saves two versions in turn in a child that is killed at a random moment: the file is always one of the two.
TEST_F(Archive, IsOldOrNewWhenTheProgramIsKilled) {
    const fs::path file = root / "killed.analogon";
    Study odd = example(), even = odd;
    even.className = "Other";
    ASSERT_TRUE(saveStudy(odd, file));
    const auto save = [&] {
        (void)saveStudy(even, file);
        (void)saveStudy(odd, file);
    };
    const auto look = [&](bool& isNew) {
        const auto opened = openStudy(file);
        ASSERT_TRUE(opened) << format(opened.diagnostics());
        isNew = opened->study.className == "Other";
        ASSERT_TRUE(isNew || opened->study.className == odd.className);
    };
    const Kills kills = killWhileSaving(3, save, [&] {
        bool isNew = false;
        look(isNew);
        return isNew;
    });
    EXPECT_GT(kills.firsts, 0) << "some kills came after a save";
    ASSERT_TRUE(saveStudy(odd, file));
    EXPECT_EQ(namesBelow(root), "killed.analogon") << "nothing is left behind";
}

}  // namespace
}  // namespace analogon
