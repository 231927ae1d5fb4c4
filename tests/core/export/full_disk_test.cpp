/// What is left of an earlier export where a disk runs full at any moment of the next one.
#include "tests/full_disk.hpp"

#include "core/archive/zip_directory.hpp"
#include "core/export/export.hpp"
#include "core/export/fmu.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;

class FullDisk : public SmallDisk {
protected:
    void SetUp() override {
        SmallDisk::SetUp();
        if (!isMounted) return;
        Outcome<Study> read = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
        ASSERT_TRUE(read);
        one = *read;
        other = one;
        other.models["model.mo"] += std::string(100, '\n') + "// other\n";
        other.parameters["heater.R"].value = 3.25;
    }
    /// `write(whether the other one)` writes two versions in turn; where it fails, the file is as it was.
    template <class Write, class IsWhole>
    void expectOldOrNew(const fs::path& file, const Write& write, const IsWhole& isWhole, std::uint64_t step) {
        ASSERT_TRUE(write(false));
        std::string before = bytesOf(file);
        bool isNew = false;
        fill([&] { return write(!isNew); },
             [&](bool isWritten) {
                 const std::string now = bytesOf(file);
                 EXPECT_EQ(now != before, isWritten);
                 EXPECT_TRUE(isWhole(now));
                 if (isWritten) isNew = !isNew;
                 before = now;
             },
             step);
    }

    Study one, other;
};

TEST_F(FullDisk, LeavesModelAndTracesAsTheyWere) {
    for (const ExportFormat format : {ExportFormat::Modelica, ExportFormat::Csv}) {
        const bool isModel = format == ExportFormat::Modelica;
        SCOPED_TRACE(isModel);
        const fs::path file = place / (isModel ? "model.mo" : "traces.csv");
        expectOldOrNew(
            file, [&](bool isOther) { return exportStudy(isOther ? other : one, format, file); },
            [&](const std::string& text) { return text.ends_with(isModel ? ";\n" : "\n"); }, 16384);
    }
}

/// The temporary files lie on the same disk, or elsewhere.
TEST_F(FullDisk, LeavesAnFmuAsItWas) {
    if (std::system("command -v cc > /dev/null 2>&1") != 0) GTEST_SKIP() << "there is no C compiler (cc) on PATH";
    const Outcome<Fmu> first = fmuOf(one), second = fmuOf(other);
    ASSERT_TRUE(first && second);
    const char* const told = std::getenv("TMPDIR");
    const std::string elsewhere = told ? told : "/tmp";
    const fs::path file = place / "model.fmu";
    for (const bool isSame : {false, true}) {
        SCOPED_TRACE(isSame);
        setenv("TMPDIR", isSame ? place.c_str() : elsewhere.c_str(), 1);
        expectOldOrNew(
            file, [&](bool isOther) { return writeFmu(isOther ? *second : *first, file); },
            [&](const std::string& bytes) {
                const Outcome<std::vector<ZipEntry>> entries = readZipDirectory(file);
                return bytes.starts_with("PK") && entries && entries->size() == first->files.size() + 1;
            },
            isSame ? 65536 : 8192);
    }
    setenv("TMPDIR", elsewhere.c_str(), 1);
    if (!told) unsetenv("TMPDIR");
}

}  // namespace
}  // namespace analogon
