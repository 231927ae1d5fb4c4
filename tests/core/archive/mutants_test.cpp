#include "tests/mutants.hpp"

#include <fstream>

#include "core/archive/archive.hpp"
#include "tests/core/archive/archive_place.hpp"
#include "tests/tree.hpp"

/// Archives that are nearly one: their bytes, the fields of their lists and the texts inside changed at random. Each
/// ends in a study or in messages, and leaves nothing behind.
namespace analogon {
namespace {

namespace fs = std::filesystem;

/// Fields of a zip file that a reader relies on: numbers of 2 and 4 bytes behind the signatures of its three records
/// (PKWARE APPNOTE 4.3.7, 4.3.12, 4.3.16).
std::string withOtherFields(std::string bytes, unsigned number) {
    static const std::uint32_t extremes[] = {0,       1,          0x7f,       0xff,       0x7fff,     0xffff,
                                             0x10000, 0x7fffffff, 0x80000000, 0xfffffffe, 0xffffffff, 0x40000000};
    std::mt19937 random(number);
    std::vector<std::size_t> records;
    for (std::size_t at = bytes.find("PK"); at != std::string::npos; at = bytes.find("PK", at + 2))
        records.push_back(at);
    for (unsigned changes = 1 + random() % 3; changes > 0; --changes) {
        const std::size_t record = records[random() % records.size()], width = random() % 2 ? 2 : 4;
        const std::size_t at = record + 4 + random() % 42;
        std::uint32_t value = extremes[random() % std::size(extremes)];
        if (random() % 3 == 0) value = static_cast<std::uint32_t>(random());
        if (random() % 3 == 0) value = static_cast<std::uint32_t>(bytes.size() - random() % 64);
        for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i)
            bytes[at + i] = static_cast<char>(value >> (8 * i) & 0xff);
    }
    return bytes;
}

class Mutants : public ArchivePlace {
protected:
    void SetUp() override {
        ArchivePlace::SetUp();
        if (HasFatalFailure()) return;
        fs::create_directories(root / "study");
        std::ofstream(root / "study" / "study.json")
            << R"({"format": "analogon-study-1", "class": "M", "experiments": [{"name": "x", "role": "fit", "file": "a.csv",
 "time": "t", "inputs": {"u": "u"}, "outputs": {"y": "y"}}], "parameters": {"k": {"fit": true, "min": 0, "max": 9}}})";
        std::ofstream(root / "study" / "model.mo")
            << "model M\n  input Real u; output Real y; parameter Real k = 1;\nequation\n  y = k*u;\nend M;\n";
        std::ofstream csv(root / "study" / "a.csv");
        csv << "t [s],u,y\n";
        for (int k = 0; k < 40; ++k) csv << 0.1 * k << ',' << k % 7 << ',' << 2 * (k % 7) << '\n';
        csv.close();
        const Outcome<Study> study = readStudy(root / "study");
        ASSERT_TRUE(study) << format(study.diagnostics());
        ASSERT_TRUE(saveStudy(*study, root / "sound.analogon"));
        sound = bytesOf(root / "sound.analogon");
        ASSERT_TRUE(goesThrough(sound));
    }
    /// Opened and unpacked: whether both went well. Nothing else may be there afterwards.
    bool goesThrough(const std::string& bytes) const {
        const fs::path file = root / "mutant.analogon", out = root / "out";
        std::ofstream(file, std::ios::binary) << bytes;
        const Outcome<OpenedStudy> opened = openStudy(file);
        if (!opened) {
            const std::string said = format(opened.diagnostics());
            EXPECT_FALSE(said.empty());
            EXPECT_LT(said.size(), 20000u);
            EXPECT_EQ(said.find('\x1b'), std::string::npos);
        } else {
            EXPECT_EQ(format(estimationTask(opened->study).diagnostics()).find('\x1b'), std::string::npos);
        }
        const Outcome<Done> unpacked = unpackArchive(file, out);
        EXPECT_EQ(fs::exists(out), unpacked.hasValue());
        fs::remove_all(out);
        fs::remove(file);
        EXPECT_EQ(std::distance(fs::directory_iterator(root), fs::directory_iterator{}), 2) << namesBelow(root);
        return opened.hasValue() && unpacked.hasValue();
    }

    std::string sound;
};

TEST_F(Mutants, OfArchivesEndInAStudyOrInMessages) {
    expectAllEnd([&](unsigned number) {
        return goesThrough(number % 2 ? withOtherFields(sound, number) : mutated(sound, number));
    });
}

/// Sound archives of studies that are none: what is read from them is no better than what lies in a directory.
TEST_F(Mutants, InArchivesEndInAStudyOrInMessages) {
    expectAllEnd(
        [&](unsigned number) {
            static const char* const files[] = {"study.json", "model.mo", "a.csv"};
            const fs::path from = root / "study", name = files[number % 3];
            const std::string before = bytesOf(from / name);
            std::ofstream(from / name, std::ios::binary) << mutated(before, number);
            const bool isZipped = zipDirectory(from, root / "mutant.analogon").hasValue();
            std::ofstream(from / name, std::ios::binary) << before;
            EXPECT_TRUE(isZipped);
            return goesThrough(bytesOf(root / "mutant.analogon"));
        },
        40);
}

}  // namespace
}  // namespace analogon
