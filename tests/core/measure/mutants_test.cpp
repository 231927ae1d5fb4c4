#include "tests/mutants.hpp"

#include <matio.h>
#include <quazip/quazip.h>
#include <quazip/quazipfile.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>

#include "core/measure/open/open_recording.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/measure/text/text_recording.hpp"
#include "tests/core/measure/mdf/mdf4_writer.hpp"

/// Measurement files that are nearly sound, of every format. Each must end in values or in messages.
namespace analogon {
namespace {

using test::Bytes;
using test::Mdf4Writer;

/// Bytes changed as transmission, a full disk or a wrong writer changes them: single ones, whole numbers at their
/// ends, pieces that are missing, there twice or overwritten, and an early end.
std::string mutatedBytes(std::string bytes, unsigned number) {
    std::mt19937 random(number);
    const auto pick = [&](std::size_t below) {
        return static_cast<std::size_t>(random()) % std::max<std::size_t>(1, below);
    };
    for (std::size_t changes = 1 + pick(4); changes > 0 && !bytes.empty(); --changes) {
        const std::size_t at = pick(bytes.size());
        switch (pick(7)) {
            case 0:
                bytes[at] = static_cast<char>(random());
                break;
            case 1:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << pick(8)));
                break;
            case 2: {  // a number of 1, 2, 4 or 8 bytes
                const std::size_t size = std::min<std::size_t>(std::size_t{1} << pick(4), bytes.size() - at);
                const std::uint64_t ends[] = {
                    0, 1, 255, 0x7FFFFFFF, 0xFFFFFFFF, UINT64_MAX, UINT64_MAX / 2, bytes.size(), bytes.size() + 1, at};
                std::memcpy(bytes.data() + at, &ends[pick(std::size(ends))], size);
                break;
            }
            case 3:
                bytes.erase(at, 1 + pick(16));
                break;
            case 4:
                bytes.insert(at, std::string(bytes, pick(bytes.size()), 1 + pick(64)));
                break;
            case 5:
                for (std::size_t from = pick(bytes.size()), i = 0; i < 24; ++i)
                    if (at + i < bytes.size() && from + i < bytes.size()) bytes[at + i] = bytes[from + i];
                break;
            default:
                if (pick(4) == 0) bytes.resize(at);
        }
    }
    return bytes;
}

class MutantFile {
public:
    explicit MutantFile(const std::string& ending)
        : path_(std::filesystem::temp_directory_path() / ("analogon-mutant-" + std::to_string(getpid()) + ending)) {}
    ~MutantFile() { std::filesystem::remove(path_); }
    MutantFile(const MutantFile&) = delete;
    MutantFile& operator=(const MutantFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::string bytes() const {
        std::ifstream stream(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    void put(const std::string& bytes) const { std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes; }

    /// Whether it opened and all its values were read.
    bool isReadWhole() const {
        const Outcome<MeasurementFile> opened = openRecording(path_);
        if (!opened) {
            EXPECT_FALSE(format(opened.diagnostics()).empty());
            return false;
        }
        bool isWhole = true;
        for (std::size_t g = 0; g < opened->groups.size(); ++g)
            for (std::size_t c = 0; c < opened->groups[g].channels.size(); ++c) {
                const Outcome<ChannelValues> values = readValues(*opened, g, c);
                isWhole = isWhole && values.hasValue();
                if (values) static_cast<void>(summaryOf(*values));
            }
        return isWhole;
    }

private:
    std::filesystem::path path_;
};

/// `whole` is sound; what becomes of its mutants.
void expectAllEndOf(const std::string& whole, const std::string& ending) {
    const MutantFile file(ending);
    file.put(whole);
    ASSERT_TRUE(file.isReadWhole());
    expectAllEnd([&](unsigned number) {
        file.put(mutatedBytes(whole, number));
        return file.isReadWhole();
    });
}

std::string packed(const std::string& data) {
    uLongf size = compressBound(data.size());
    std::string out(size, '\0');
    compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(data.data()), data.size());
    out.resize(size);
    Bytes head;
    head.put(std::string("DT")).put(std::uint8_t{0}).put(std::uint8_t{0}).put(std::uint32_t{0});
    head.put(std::uint64_t{data.size()}).put(std::uint64_t{out.size()});
    return head.text + out;
}

/// Two groups whose records lie mixed, texts of variable length, and a packed group with conversions.
std::string soundMdf4() {
    Mdf4Writer writer;
    Bytes plain, mixed;
    for (int i = 0; i < 12; ++i) plain.put(0.1 * i).put(static_cast<std::uint16_t>(i % 3)).put(std::int32_t{-i});
    for (int i = 0; i < 6; ++i) {
        mixed.put(std::uint8_t{1}).put(0.5 * i).put(static_cast<float>(i));
        mixed.put(std::uint8_t{3}).put(std::uint32_t{3}).put(std::string("ab\0", 3));
        mixed.put(std::uint8_t{2}).put(0.25 * i).put(std::uint64_t{7} * static_cast<unsigned>(i));
    }
    Bytes list;
    list.put(std::uint32_t{1}).put(std::uint32_t{1}).put(std::uint64_t{plain.text.size()});
    const std::uint64_t dl = writer.block("DL", {0, writer.block("DZ", {}, packed(plain.text))}, list.text);
    const std::uint64_t status =
        writer.conversion(7, {0, 1}, {writer.text("off"), writer.text("on"), writer.conversion(1, {1, 2})});
    const std::uint64_t formula = writer.conversion(3, {}, {writer.text("2*X^2 + sin(X)")});
    const Mdf4Writer::Channel time{"time", "s", 2};
    const std::uint64_t first = writer.simple(
        "packed", {time, {"state", "", 0, 0, 16, 8, 0, status}, {"y", "V", 0, 2, 32, 10, 0, formula}}, 12, 14, dl);
    const auto group = [&](const char* name, const Mdf4Writer::Channel& value, unsigned bytes, std::uint64_t id,
                           std::uint64_t next) {
        return writer.channelGroup(name, writer.channel(time, writer.channel(value, 0)), 6, bytes, 0, id, next);
    };
    const std::uint64_t texts = writer.channelGroup("", 0, 6, 0, 0, 3, 0, 1);
    const std::uint64_t second = group("b", {"log", "", 1, 7, 64, 8, 0, 0, texts}, 16, 2, texts);
    const std::uint64_t data = writer.block("DT", {}, mixed.text);
    const std::uint64_t mixedGroup = writer.dataGroup(group("a", {"x", "N", 0, 4, 32, 8}, 12, 1, second), data, 1);
    const std::uint64_t link = mixedGroup;
    std::memcpy(writer.bytes().data() + first + 24, &link, 8);  // the next data group
    writer.finish(first, MutantFile(".mf4").path());
    return writer.bytes();
}

/// A time and two channels, one with a linear conversion and one with texts.
std::string soundMdf3() {
    Bytes out;
    const auto padded = [](std::string text, std::size_t size) {
        text.resize(size, '\0');
        return text;
    };
    const auto id = [&](const char* name, std::size_t size) {
        out.put(std::string(name)).put(static_cast<std::uint16_t>(size));
    };
    constexpr std::uint32_t hd = 64, dg = hd + 164, cg = dg + 28, cn = cg + 26, cnSize = 228, cc = cn + 3 * cnSize,
                            linear = cc, table = cc + 62, data = table + 46 + 2 * 40;
    out.put(padded("MDF     3.30    test", 24)).put(std::uint16_t{0}).put(std::uint16_t{0});
    out.put(std::uint16_t{330}).put(std::uint16_t{0}).put(std::string(32, '\0'));
    id("HD", 164);
    out.put(dg).put(std::uint32_t{0}).put(std::uint32_t{0}).put(std::uint16_t{1});
    out.put(std::string("15:06:2024")).put(std::string("10:30:00")).put(std::string(128, '\0'));
    id("DG", 28);
    out.put(std::uint32_t{0}).put(cg).put(std::uint32_t{0}).put(data).put(std::uint16_t{1}).put(std::uint16_t{0});
    out.put(std::uint32_t{0});
    id("CG", 26);
    out.put(std::uint32_t{0}).put(cn).put(std::uint32_t{0}).put(std::uint16_t{0}).put(std::uint16_t{3});
    out.put(std::uint16_t{12}).put(std::uint32_t{8});
    const auto channel = [&](std::uint32_t next, std::uint32_t conversion, bool isTime, const char* name, unsigned bit,
                             unsigned bits, unsigned type) {
        id("CN", cnSize);
        out.put(next).put(conversion).put(std::uint32_t{0}).put(std::uint32_t{0}).put(std::uint32_t{0});
        out.put(static_cast<std::uint16_t>(isTime)).put(padded(name, 32)).put(padded("a comment", 128));
        out.put(static_cast<std::uint16_t>(bit)).put(static_cast<std::uint16_t>(bits));
        out.put(static_cast<std::uint16_t>(type)).put(std::uint16_t{0}).put(0.0).put(0.0).put(0.01);
        out.put(std::uint32_t{0}).put(std::uint32_t{0}).put(std::uint16_t{0});
    };
    channel(cn + cnSize, 0, true, "t", 0, 64, 3);
    channel(cn + 2 * cnSize, linear, false, "U", 64, 16, 1);
    channel(0, table, false, "state", 80, 16, 0);
    const auto conversion = [&](std::size_t size, const char* unit, unsigned type, unsigned count) {
        id("CC", size);
        out.put(std::uint16_t{0}).put(0.0).put(0.0).put(padded(unit, 20));
        out.put(static_cast<std::uint16_t>(type)).put(static_cast<std::uint16_t>(count));
    };
    conversion(62, "V", 0, 2);
    out.put(1.0).put(0.5);
    conversion(46 + 2 * 40, "", 11, 2);
    out.put(0.0).put(padded("off", 32)).put(1.0).put(padded("on", 32));
    for (int i = 0; i < 8; ++i) out.put(0.01 * i).put(static_cast<std::int16_t>(-i)).put(std::uint16_t(i % 2));
    return out.text;
}

std::string soundTdms() {
    const auto text = [](Bytes& bytes, const std::string& words) {
        bytes.put(static_cast<std::uint32_t>(words.size())).put(words);
    };
    Bytes meta;
    meta.put(std::uint32_t{4});
    const auto object = [&](const std::string& path, std::uint32_t type, std::uint64_t count) {
        text(meta, path);
        if (type == 0)
            meta.put(std::uint32_t{0xFFFFFFFF}).put(std::uint32_t{0});
        else
            meta.put(std::uint32_t{20}).put(type).put(std::uint32_t{1}).put(count).put(std::uint32_t{2});
        if (type == 0) return;
        text(meta, "wf_increment");
        meta.put(std::uint32_t{10}).put(0.5);
        text(meta, "unit_string");
        meta.put(std::uint32_t{0x20});
        text(meta, "V");
    };
    object("/", 0, 0);
    object("/'G'", 0, 0);
    object("/'G'/'a'", 10, 2);
    object("/'G'/'b'", 3, 2);
    Bytes raw, file;
    for (int i = 0; i < 3; ++i) raw.put(1.5).put(2.5 * i).put(std::int32_t{-7}).put(std::int32_t{i});
    file.put(std::string("TDSm")).put(std::uint32_t{2 + 4 + 8}).put(std::uint32_t{4713});
    file.put(std::uint64_t{meta.text.size() + raw.text.size()}).put(std::uint64_t{meta.text.size()});
    file.put(meta.text + raw.text).put(std::string("TDSm")).put(std::uint32_t{8}).put(std::uint32_t{4713});
    file.put(std::uint64_t{raw.text.size()}).put(std::uint64_t{0}).put(raw.text);
    return file.text;
}

std::string soundMat(mat_ft level, matio_compression packing) {
    const MutantFile file(".mat");
    mat_t* const mat = Mat_CreateVer(file.path().c_str(), nullptr, level);
    const auto add = [&](const char* name, std::vector<double> values, std::size_t columns) {
        std::size_t size[2] = {values.size() / columns, columns};
        matvar_t* const variable = Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size, values.data(), 0);
        Mat_VarWrite(mat, variable, packing);
        Mat_VarFree(variable);
    };
    add("t", {0, 1, 2, 3}, 1);
    add("m", {1, 2, 3, 4, 10, 20, 30, 40}, 2);
    if (level != MAT_FT_MAT4) {
        std::size_t one[2] = {1, 1}, four[2] = {4, 1};
        const char* fields[] = {"time", "data"};
        std::vector<double> time{0, 1, 2, 3};
        std::vector<std::int16_t> data{1, -2, 3, -4};
        matvar_t* const record = Mat_VarCreateStruct("record", 2, one, fields, 2);
        Mat_VarSetStructFieldByName(record, "time", 0,
                                    Mat_VarCreate(nullptr, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, four, time.data(), 0));
        Mat_VarSetStructFieldByName(record, "data", 0,
                                    Mat_VarCreate(nullptr, MAT_C_INT16, MAT_T_INT16, 2, four, data.data(), 0));
        Mat_VarWrite(mat, record, packing);
        Mat_VarFree(record);
    }
    Mat_Close(mat);
    return file.bytes();
}

const std::string soundSheet =
    R"(<worksheet><sheetData><row r="1"><c r="A1" t="inlineStr"><is><t>Zeit</t></is></c><c r="B1" t="s"><v>0</v></c>)"
    R"(</row><row r="2"><c r="A2" t="inlineStr"><is><t>s</t></is></c><c r="B2" t="inlineStr"><is><t>bar</t></is></c>)"
    R"(</row><row r="3"><c r="A3"><v>0</v></c><c r="B3"><f>A3+1</f><v>1</v></c></row><row r="4"><c r="A4"><v>0.5</v>)"
    R"(</c><c r="B4" t="e"><v>#N/A</v></c></row><row r="5"><c r="A5" s="1"><v>1</v></c><c r="B5" s="2"><v>0.25</v>)"
    R"(</c></row></sheetData><mergeCells><mergeCell ref="A7:B7"/></mergeCells></worksheet>)";

void putWorkbook(const std::filesystem::path& path, const std::vector<std::pair<const char*, std::string>>& parts) {
    QuaZip archive(QString::fromStdString(path.string()));
    archive.open(QuaZip::mdCreate);
    for (const auto& [name, content] : parts) {
        QuaZipFile part(&archive);
        part.open(QIODevice::WriteOnly, QuaZipNewInfo(name));
        part.write(content.data(), static_cast<qint64>(content.size()));
        part.close();
    }
    archive.close();
}

std::vector<std::pair<const char*, std::string>> soundWorkbook() {
    return {{"xl/workbook.xml",
             R"(<workbook xmlns:r="r"><sheets><sheet name="Run" sheetId="1" r:id="rId1"/></sheets></workbook>)"},
            {"xl/_rels/workbook.xml.rels",
             R"(<Relationships><Relationship Id="rId1" Target="worksheets/sheet1.xml"/></Relationships>)"},
            {"xl/styles.xml",
             R"(<styleSheet><cellXfs><xf numFmtId="0"/><xf numFmtId="22"/><xf numFmtId="10"/></cellXfs></styleSheet>)"},
            {"xl/sharedStrings.xml", "<sst><si><t>Druck</t></si></sst>"},
            {"xl/worksheets/sheet1.xml", soundSheet}};
}

TEST(RecordingMutants, OfMdf4EndInValuesOrInMessages) { expectAllEndOf(soundMdf4(), ".mf4"); }
TEST(RecordingMutants, OfMdf3EndInValuesOrInMessages) { expectAllEndOf(soundMdf3(), ".mdf"); }
TEST(RecordingMutants, OfTdmsEndInValuesOrInMessages) { expectAllEndOf(soundTdms(), ".tdms"); }
TEST(RecordingMutants, OfMatlab4EndInValuesOrInMessages) {
    expectAllEndOf(soundMat(MAT_FT_MAT4, MAT_COMPRESSION_NONE), ".mat");
}
TEST(RecordingMutants, OfMatlab5EndInValuesOrInMessages) {
    expectAllEndOf(soundMat(MAT_FT_MAT5, MAT_COMPRESSION_NONE), ".mat");
}
TEST(RecordingMutants, OfMatlab7EndInValuesOrInMessages) {
    expectAllEndOf(soundMat(MAT_FT_MAT5, MAT_COMPRESSION_ZLIB), ".mat");
}
TEST(RecordingMutants, OfMatlab73EndInValuesOrInMessages) {
    expectAllEndOf(soundMat(MAT_FT_MAT73, MAT_COMPRESSION_NONE), ".mat");
}

TEST(RecordingMutants, OfArchivesOfSheetsEndInValuesOrInMessages) {
    const MutantFile file(".xlsx");
    putWorkbook(file.path(), soundWorkbook());
    expectAllEndOf(file.bytes(), "-archive.xlsx");
}

TEST(RecordingMutants, OfSheetsEndInValuesOrInMessages) {
    const MutantFile file(".xlsx");
    expectAllEnd([&](unsigned number) {
        auto parts = soundWorkbook();
        std::string& part = parts[number % 3 == 0 ? number / 3 % parts.size() : parts.size() - 1].second;
        part = mutated(part, number);
        putWorkbook(file.path(), parts);
        return file.isReadWhole();
    });
}

TEST(RecordingMutants, OfTextEndInValuesOrInMessages) {
    using namespace std::string_literals;
    const std::vector<std::string> sound{
        "Model,X1\nVertical Units,V,A\nSample Interval,0.5\n,,\nLabel,supply,inrush\nTIME,CH1,CH2\n-0.5,0,1\n0,12,2\n"
        "+5.0e-01,12,3\n",
        "X,CH1,CH2,Start,Increment,\nSequence,Volt,Volt,-4.0e-03,5.0e-04\n0,1,2,\n1,3,4,\n2,5,6,\n",
        "Datum;Uhrzeit;T [\xB0"
        "C];Unit\n01.02.2024;23:59:59,5;1.234,5;mV\n02.02.2024;00:00:00,0;12,25;V\n",
        "\"#\",\"Date Time, GMT-05:00\",\"Temp, \xC2\xB0"
        "C (LBL: heater)\"\n1,03/12/22 12:59:50 PM,21.4\n2,03/12/22 01:00:00 PM,OL\n",
        "Time [ms]\tu\tTime [ms]\tT\n0.0\t12.0\t3.0\t25.0\n5.0\t12.1\t23.0\t25.4\n10.0\t12.2\t\t\nEOF\n",
        "Samples\t3\t3\t\nY_Unit_Label\tV\tA\t\nX0\t0.0\t0.0\t\nDelta_X\t0.5\t0.5\t\n***End_of_Header***\t\t\t\n"
        "X_Value\tU\tI\tComment\n0.0\t1\t2\n0.5\t1\t2\n1.0\t1\t2\n\nMin\t1\t2\n",
        "#1\ndouble Values(3,2)  # time, u\n 0 1\n 0.5 2\n 1 3",
        "T1:20.5 U=1.25\nT1:20.6 U=1.5\nT1:20.7 U=1.75\nT1:20.8 U=2\n",
        "\xFF\xFEt\0;\0u\0\n\0"
        "0\0;\0"
        "1\0\n\0"
        "1\0;\0"
        "2\0\n\0"s,
        "time [s];p [mpa];R\n3;1.5V;1k\n2;2.5V;2k\n1;3mV;3k\n"};
    const MutantFile file(".csv");
    expectAllEnd([&](unsigned number) {
        file.put(mutated(sound[number % sound.size()], number));
        static_cast<void>(lookAtTextFile(file.path()));
        return openText(file.path()).hasValue();
    });
}

}  // namespace
}  // namespace analogon
