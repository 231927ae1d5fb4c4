#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/measure/encoding.hpp"
#include "study_fixture.hpp"
#include "tests/kills.hpp"
#include "tests/tree.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

using StudyFiles = analogon::test::StudyTest;

TEST_F(StudyFiles, AreReadFromTheDirectoryOrItsStudyJson) {
    putHeater();
    put("extra.mo", "model Extra\nend Extra;\n");
    const Study study = read();
    EXPECT_EQ(study.className, "Heater");
    EXPECT_EQ(study.name, directory_.filename().string());
    EXPECT_EQ(study.modelFile, "model.mo");
    EXPECT_EQ(study.models.size(), 2u);
    EXPECT_EQ(study.tables.at("train.csv")->rows(), 4u);
    EXPECT_TRUE(readStudy(directory_ / "study.json").hasValue());
}

TEST_F(StudyFiles, FindTheFileThatDeclaresTheClass) {
    putHeater();
    fs::rename(directory_ / "model.mo", directory_ / "heater.mo");
    put("another.mo", "model Other\nend Other;\n");
    EXPECT_EQ(read().modelFile, "heater.mo");
}

TEST_F(StudyFiles, NameWhatIsMissing) {
    EXPECT_THAT(readFault().message, HasSubstr("no study.json"));
    EXPECT_THAT(readStudy(directory_ / "nowhere").diagnostics()[0].message, HasSubstr("no such file"));
    put("x.analogon", "PK");
    EXPECT_THAT(readStudy(directory_ / "x.analogon").diagnostics()[0].hint, HasSubstr("Unpack"));
    putHeater();
    change("train.csv", "trian.csv");
    const Diagnostic fault = readFault();
    EXPECT_EQ(fault.message, "experiment 'warm-up': there is no file 'trian.csv'");
    EXPECT_EQ(fault.hint, "Did you mean 'train.csv'?");
    EXPECT_EQ(fault.place.line, 5);
    EXPECT_GT(fault.place.column, 40);
}

TEST_F(StudyFiles, KeepWhyAMeasurementWasNotReadWhereThatIsAskedFor) {
    putHeater();
    change("train.csv", "trian.csv");
    const Outcome<Study> study = readStudy(directory_, UnreadMeasurement::Kept);
    ASSERT_TRUE(study) << format(study.diagnostics());
    ASSERT_EQ(study->unread.count("trian.csv"), 1u);
    EXPECT_EQ(study->unread.at("trian.csv").front().message, "experiment 'warm-up': there is no file 'trian.csv'");
    const Outcome<EstimationTask> task = estimationTask(*study);
    ASSERT_FALSE(task) << "no work is done without it unseen";
    EXPECT_EQ(task.diagnostics().front().message, "experiment 'warm-up': there is no file 'trian.csv'");
    EXPECT_TRUE(writeStudy(*study, directory_ / "copy")) << "what is there can be saved";
    EXPECT_TRUE(readStudy(directory_ / "copy", UnreadMeasurement::Kept));
    change("\"role\": \"fit\"", "\"role\": \"fit\", \"use\": false");
    EXPECT_TRUE(readStudy(directory_)) << "a recording that is not used need not be there";
}

TEST_F(StudyFiles, PassOnTheFaultsOfATable) {
    putHeater();
    put("train.csv", "t,u\n0,1\n1,on\n");
    const Diagnostic fault = readFault();
    EXPECT_EQ(fault.place.file, (directory_ / "train.csv").string());
    EXPECT_EQ(fault.place.line, 3);
}

TEST_F(StudyFiles, AreWrittenAndReadBack) {
    putHeater();
    const Study study = read();
    const fs::path copy = directory_ / "out" / "study";
    const Outcome<Done> done = writeStudy(study, copy);
    ASSERT_TRUE(done.hasValue()) << format(done.diagnostics());
    const Outcome<Study> again = readStudy(copy);
    ASSERT_TRUE(again.hasValue()) << format(again.diagnostics());
    EXPECT_EQ(studyJson(*again), studyJson(study));
    EXPECT_EQ(again->models, study.models);
    EXPECT_EQ(get(copy / "train.csv"), get(directory_ / "train.csv"));
    for (const auto& entry : fs::directory_iterator(directory_ / "out")) EXPECT_EQ(entry.path().filename(), "study");
}

TEST_F(StudyFiles, BringMeasurementsFromElsewhereAlong) {
    putHeater();
    fs::create_directories(directory_ / "inner");
    for (const char* file : {"study.json", "model.mo"}) fs::rename(directory_ / file, directory_ / "inner" / file);
    put("inner/study.json",
        std::string(heaterJson).replace(std::string(heaterJson).find("train.csv"), 9, "../train.csv"));
    const Outcome<Study> study = readStudy(directory_ / "inner");
    ASSERT_TRUE(study.hasValue()) << format(study.diagnostics());
    ASSERT_TRUE(writeStudy(*study, directory_ / "copy").hasValue());
    EXPECT_TRUE(fs::exists(directory_ / "copy" / "train.csv"));
    EXPECT_EQ(readStudy(directory_ / "copy")->experiments[0].file, "train.csv");
}

TEST_F(StudyFiles, AreSavedInPlaceWithoutTouchingOthers) {
    putHeater();
    put("notes.txt", "keep me");
    Study study = read();
    study.models["model.mo"] += "// changed\n";
    ASSERT_TRUE(writeStudy(study, directory_).hasValue());
    EXPECT_THAT(get(directory_ / "model.mo"), HasSubstr("// changed"));
    EXPECT_EQ(get(directory_ / "notes.txt"), "keep me");
    EXPECT_TRUE(fs::exists(directory_ / "train.csv"));
}

TEST_F(StudyFiles, ReplaceAnEarlierStudyWithItsBlocks) {
    putHeater();
    put("old/study.json", "{}");
    put("old/stale.mo", "model Stale\nend Stale;\n");
    ASSERT_TRUE(writeStudy(read(), directory_ / "old").hasValue());
    EXPECT_FALSE(fs::exists(directory_ / "old" / "stale.mo"));
    EXPECT_TRUE(readStudy(directory_ / "old").hasValue());
}

TEST_F(StudyFiles, ComeFromMemoryWhenTheMeasurementIsNotOnDisk) {
    putHeater();
    Study study = read();
    study.directory.clear();
    ASSERT_TRUE(writeStudy(study, directory_ / "copy").hasValue());
    const Outcome<Study> again = readStudy(directory_ / "copy");
    ASSERT_TRUE(again.hasValue());
    EXPECT_EQ(again->tables.at("train.csv")->columns[1].values, study.tables.at("train.csv")->columns[1].values);
}

/// The same study under another name of its class, with other measurements: nothing of it fits the first one.
Study otherStudy(Study study) {
    study.className = "Other";
    std::string& text = study.models.at("model.mo");
    for (std::size_t at = 0; (at = text.find("Heater", at)) != std::string::npos;) text.replace(at, 6, "Other");
    auto table = std::make_shared<Table>(*study.tables.at("train.csv"));
    for (double& value : table->columns[1].values) value += 1;
    study.tables["train.csv"] = table;
    study.directory.clear();  // the table is what is written
    return study;
}

/// The list of a save, as it lies in the folder of one that is not finished.
void putList(const fs::path& folder, const std::vector<std::string>& records) {
    std::string list("analogon-save-1");
    for (const std::string& record : records) (list += '\0') += record;
    list += '\0';
    std::ofstream(folder / ".analogon-list", std::ios::binary) << list << "end" << '\0';
}

/// Wherever a program is ended that saves into a directory: what is opened then is the old study or the new one, whole.
TEST_F(StudyFiles, AreOldOrNewWhereverASaveIsEnded) {
    putHeater();
    put("stale.mo", "model Stale\nend Stale;\n");
    const Study before = read(), after = otherStudy(before);
    ASSERT_TRUE(writeStudy(after, directory_ / "after").hasValue());
    const std::vector<std::string> files{"model.mo", "study.json", "train.csv"};
    const auto isAfter = [&](const Study& study) {
        return study.className == "Other" && study.models.at("model.mo").find("model Other") == 0 &&
               study.tables.at("train.csv")->columns[1].values == after.tables.at("train.csv")->columns[1].values;
    };
    const auto start = [&](const std::string& folder, std::size_t written) {
        const fs::path place = directory_ / "place";
        fs::remove_all(place);
        fs::create_directories(place / folder);
        for (const std::string& file : files) fs::copy_file(directory_ / file, place / file);
        for (std::size_t i = 0; i < written; ++i)
            fs::copy_file(directory_ / "after" / files[i], place / folder / files[i]);
        return place;
    };
    for (std::size_t written = 0; written <= files.size(); ++written) {
        const fs::path place = start(".analogon-writing-1", written);
        const Outcome<Study> study = readStudy(place);
        ASSERT_TRUE(study) << format(study.diagnostics());
        EXPECT_EQ(study->className, before.className) << "ended while it wrote file " << written;
        EXPECT_EQ(study->models.at("model.mo"), before.models.at("model.mo"));
        ASSERT_TRUE(writeStudy(after, place)) << "what is left does not stand in the way of the next save";
        EXPECT_TRUE(isAfter(*readStudy(place)));
    }
    for (std::size_t moved = 0; moved <= files.size(); ++moved) {
        const fs::path place = start(".analogon-saved-1", files.size());
        fs::copy_file(directory_ / "stale.mo", place / "stale.mo");
        putList(place / ".analogon-saved-1", {"+model.mo", "+study.json", "+train.csv", "-stale.mo", "-../kept.mo"});
        put("kept.mo", "model Kept\nend Kept;\n");
        for (std::size_t i = 0; i < moved; ++i) fs::rename(place / ".analogon-saved-1" / files[i], place / files[i]);
        const auto tree = treeOf(place);
        const Outcome<Study> study = readStudy(moved % 2 ? place : place / "study.json");
        ASSERT_TRUE(study) << format(study.diagnostics());
        EXPECT_TRUE(isAfter(*study)) << "ended when " << moved << " files were at their places";
        EXPECT_FALSE(study->models.contains("stale.mo"));
        EXPECT_EQ(treeOf(place), tree) << "who reads writes nothing";
        ASSERT_TRUE(writeStudy(*study, directory_ / "copy" / std::to_string(moved)));
        EXPECT_TRUE(isAfter(*readStudy(directory_ / "copy" / std::to_string(moved)))) << "copied from where it lies";
        ASSERT_TRUE(writeStudy(*study, place));
        EXPECT_TRUE(isAfter(*readStudy(place)));
        EXPECT_EQ(namesBelow(place), "model.mo study.json train.csv") << "who writes finishes the save";
        EXPECT_TRUE(fs::exists(directory_ / "kept.mo")) << "no other directory is touched";
    }
}

/// What looks like a save of ours by its name, and leads to files of somebody else.
TEST_F(StudyFiles, AreReadWithoutTouchingWhatHasOnlyTheNameOfASave) {
    putHeater();
    put("other/model.mo", "model Other\nend Other;\n");
    put("other/study.json", "{}");
    putList(directory_ / "other", {"+model.mo", "+study.json"});
    put("study/.analogon-saved-plain/model.mo", "model Plain\nend Plain;\n");
    put("study/.analogon-saved-linked/study.json", "{}");
    fs::create_symlink(directory_ / "other" / ".analogon-list",
                       directory_ / "study" / ".analogon-saved-linked" / ".analogon-list");
    put("study/.analogon-writing-mine/notes.txt", "keep me");
    put("study/.analogon-saved-file", "keep me");
    for (const char* file : {"study.json", "model.mo", "train.csv"})
        fs::copy_file(directory_ / file, directory_ / "study" / file);
    for (const char* name : {".analogon-saved", ".analogon-saved-1"})
        fs::create_directory_symlink(directory_ / "other", directory_ / "study" / name);
    const auto tree = treeOf(directory_);
    const Outcome<Study> study = readStudy(directory_ / "study");
    ASSERT_TRUE(study) << format(study.diagnostics());
    EXPECT_EQ(study->className, "Heater");
    EXPECT_EQ(study->models.size(), 1u);
    EXPECT_EQ(treeOf(directory_), tree);

    ASSERT_TRUE(writeStudy(*study, directory_ / "study"));
    EXPECT_EQ(namesBelow(directory_ / "study"),
              ".analogon-saved .analogon-saved-1 .analogon-saved-file .analogon-saved-linked "
              ".analogon-saved-linked/.analogon-list .analogon-saved-linked/study.json .analogon-saved-plain "
              ".analogon-saved-plain/model.mo .analogon-writing-mine .analogon-writing-mine/notes.txt model.mo "
              "study.json train.csv");
    EXPECT_EQ(get(directory_ / "other" / "study.json"), "{}");
}

/// A save that is finished follows no link and leaves its directory by no name.
TEST_F(StudyFiles, AreWrittenThroughNoLink) {
    putHeater();
    fs::create_directories(directory_ / "elsewhere");
    put("place/.analogon-saved-1/data/train.csv", "t\n");
    put("place/.analogon-saved-1/study.json", get(directory_ / "study.json"));
    fs::create_symlink("/etc/hostname", directory_ / "place" / ".analogon-saved-1" / "link.csv");
    putList(directory_ / "place" / ".analogon-saved-1", {"+../../x.csv", "+/x.csv", "+link.csv", "+study.json"});
    fs::create_directory_symlink(directory_ / "elsewhere", directory_ / "place" / "data");
    Study study = read();
    ASSERT_TRUE(writeStudy(study, directory_ / "place"));
    EXPECT_FALSE(fs::exists(fs::symlink_status(directory_ / "place" / "link.csv"))) << "links are no files of a save";
    study.directory.clear();
    study.tables["data/train.csv"] = study.tables.at("train.csv");
    study.experiments[0].file = "data/train.csv";
    const Outcome<Done> done = writeStudy(study, directory_ / "place");
    ASSERT_FALSE(done);
    EXPECT_THAT(done.diagnostics()[0].message, HasSubstr("a link on its way leads to another directory"));
    EXPECT_TRUE(fs::is_empty(directory_ / "elsewhere"));
    EXPECT_TRUE(readStudy(directory_ / "place")) << "the study is as it was";
}

TEST_F(StudyFiles, TakeThePlaceOfNoOtherMeasurement) {
    putHeater();
    put("elsewhere/train.csv", "t,u_heater,T_air,current\n0,1,2,3\n1,2,3,4\n");
    Study study = read();
    study.experiments.push_back(study.experiments[0]);
    study.experiments[1].name = "second";
    study.experiments[1].file = (directory_ / "elsewhere" / "train.csv").string();
    study.experiments.erase(study.experiments.begin());
    const std::string before = get(directory_ / "train.csv");
    for (int i = 0; i < 2; ++i) {
        ASSERT_TRUE(writeStudy(study, directory_));
        EXPECT_EQ(get(directory_ / "train.csv"), before) << "a file of the user beside the study";
        EXPECT_EQ(read().experiments[0].file, "train_2.csv");
        EXPECT_FALSE(fs::exists(directory_ / "train_3.csv"));
    }
}

/// Also where its own name is none that a study can hold.
TEST_F(StudyFiles, NameEveryMeasurementSoThatItIsFoundAgain) {
    putHeater();
    const Study sound = read();
    const fs::path elsewhere = directory_ / "elsewhere";
    fs::create_directories(elsewhere);
    const std::string content = get(directory_ / "train.csv");
    for (const auto& [name, kept] :
         std::vector<std::pair<std::string, std::string>>{{"pr\xfc"
                                                           "fung.csv",
                                                           "pr\u00fcfung.csv"},
                                                          {"pr\u00fcfung.csv", "pr\u00fcfung.csv"},
                                                          {"\xff\xfe.txt", "\u00ff\u00fe.txt"}}) {
        SCOPED_TRACE(kept);
        std::ofstream(elsewhere / name, std::ios::binary) << content;
        Study study = sound;
        study.experiments.front().file = (elsewhere / name).string();
        study.tables[study.experiments.front().file] = sound.tables.at("train.csv");
        const Outcome<Done> written = writeStudy(study, directory_ / "out");
        ASSERT_TRUE(written) << format(written.diagnostics());
        const bool isTold = !written.diagnostics().empty();
        EXPECT_EQ(isTold, !isUtf8(name)) << format(written.diagnostics());
        if (isTold) {
            EXPECT_THAT(format(written.diagnostics()), HasSubstr("is called \"" + kept + "\" in the study"));
        }
        const Outcome<Study> again = readStudy(directory_ / "out");
        ASSERT_TRUE(again) << format(again.diagnostics());
        EXPECT_EQ(again->experiments.front().file, kept);
        EXPECT_EQ(get(directory_ / "out" / kept), content);
        EXPECT_EQ(again->models, sound.models);
        fs::remove_all(directory_ / "out");
    }
}

TEST_F(StudyFiles, AreNeverReadFromAPipe) {
    putHeater();
    for (const char* name : {"train.csv", "model.mo", "study.json"}) {
        fs::rename(directory_ / name, directory_ / "kept");
        ASSERT_EQ(mkfifo((directory_ / name).c_str(), 0600), 0);
        const Outcome<Study> study = readStudy(directory_);
        if (name == std::string("model.mo")) {
            EXPECT_TRUE(study) << "what is no file is no model of the study";
        } else {
            ASSERT_FALSE(study) << name;
            EXPECT_EQ(study.diagnostics()[0].message, "this is a pipe or a device, not a file") << name;
        }
        fs::rename(directory_ / "kept", directory_ / name);
    }
}

/// Two programs save into one directory while a third reads it: it finds one of the two studies, whole.
TEST_F(StudyFiles, AreWholeWhileTwoProgramsSaveThem) {
    putHeater();
    const Study even = read(), odd = otherStudy(even);
    const fs::path place = directory_ / "shared";
    ASSERT_TRUE(writeStudy(even, place));
    std::vector<pid_t> children;
    for (const Study* study : {&even, &odd}) {
        children.push_back(fork());
        if (children.back() != 0) continue;
        for (int i = 0; i < 30; ++i)
            if (!writeStudy(*study, place)) _exit(1);
        _exit(0);
    }
    for (int i = 0; i < 100; ++i) {
        const Outcome<Study> study = readStudy(place);
        ASSERT_TRUE(study) << format(study.diagnostics());
        const Study& whole = study->className == "Other" ? odd : even;
        ASSERT_EQ(study->models, whole.models);
        ASSERT_EQ(study->tables.at("train.csv")->columns[1].values, whole.tables.at("train.csv")->columns[1].values);
    }
    for (const pid_t child : children) {
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0) << "each waits for the other";
    }
    EXPECT_EQ(namesBelow(place), "model.mo study.json train.csv");
}

/// The same by force: a child that saves two studies in turn is killed at random moments.
TEST_F(StudyFiles, SurviveKills) {
    putHeater();
    const Study even = read(), odd = otherStudy(even);
    const fs::path place = directory_ / "killed";
    ASSERT_TRUE(writeStudy(even, place));
    const auto save = [&] {
        (void)writeStudy(odd, place);
        (void)writeStudy(even, place);
    };
    const auto look = [&](bool& isOdd) {
        const Outcome<Study> study = readStudy(place);
        ASSERT_TRUE(study) << format(study.diagnostics());
        isOdd = study->className == "Other";
        const Study& whole = isOdd ? odd : even;
        ASSERT_EQ(study->models, whole.models);
        ASSERT_EQ(study->tables.at("train.csv")->columns[1].values, whole.tables.at("train.csv")->columns[1].values);
    };
    const Kills kills = killWhileSaving(5, save, [&] {
        bool isOdd = false;
        look(isOdd);
        return isOdd;
    });
    EXPECT_GT(kills.firsts, 0) << "some kills came after a save";
    EXPECT_LT(kills.firsts, kills.all);
    ASSERT_TRUE(writeStudy(even, place));
    EXPECT_EQ(namesBelow(place), "model.mo study.json train.csv") << "nothing is left behind";
    for (const auto& entry : fs::directory_iterator(directory_))
        EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
}

TEST_F(StudyFiles, LeaveNothingHalfWritten) {
    putHeater();
    Study study = read();
    study.directory.clear();
    study.tables.clear();  // the measurement is nowhere
    EXPECT_FALSE(writeStudy(study, directory_ / "copy").hasValue());
    EXPECT_FALSE(fs::exists(directory_ / "copy"));
    for (const auto& entry : fs::directory_iterator(directory_))
        EXPECT_THAT(entry.path().filename().string(), ::testing::Not(HasSubstr("writing")));
}

}  // namespace
}  // namespace analogon
