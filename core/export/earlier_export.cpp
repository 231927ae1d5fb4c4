#include "core/export/earlier_export.hpp"

#include <fmt/format.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fstream>
#include <string_view>

#include "core/archive/zip_look.hpp"
#include "core/base/regular_file.hpp"
#include "core/export/mf4_file.hpp"
#include "core/export/parameter_table.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view sealBegin = "// Exported by Analogon (";
constexpr std::uint64_t largestText = 256u << 20;  // [byte]

std::string sealOf(std::string_view text) {
    const boost::uuids::uuid sum = boost::uuids::name_generator_sha1(boost::uuids::ns::oid())(text.data(), text.size());
    return fmt::format("{}{}), and again to this place as long as nobody changes it.\n", sealBegin, to_string(sum));
}

std::string beginOf(const fs::path& file, std::size_t bytes) {
    std::string begin(bytes, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(stream.gcount()));
    return begin;
}

bool beginsWith(const fs::path& file, std::string_view words) { return beginOf(file, words.size()) == words; }

/// What stands at the place of an export.
struct Known {
    bool isOwn;
    Text fault;  // where it is not
};

Known lookAt(ExportFormat format, const fs::path& file) {
    switch (format) {
        case ExportFormat::Fmu:
            return {beginningOfEntry(file, "modelDescription.xml", 4096).find(" generationTool=\"Analogon\"") !=
                        std::string::npos,
                    phrase("this exists already and is no FMU that was exported before")};
        case ExportFormat::Csv:
            return {beginsWith(file, "experiment,time [s]"),
                    phrase("this exists already and holds no traces that were exported before")};
        case ExportFormat::Mf4:
            return {beginsWith(file, mf4Begin()),
                    phrase("this exists already and is no MDF file of traces that was exported before")};
        case ExportFormat::Parameters:
            return {isParameterText(beginOf(file, 1024), parameterFormatOf(file).value_or(ParameterFormat::Csv)),
                    phrase("this exists already and holds no parameters that were exported before")};
        case ExportFormat::Modelica:
            break;
    }
    const Outcome<std::string> text = readRegularFile(file, largestText);
    return {text && isSealed(*text),
            phrase("this exists already and is no model text that was exported before, or it was changed since")};
}

}  // namespace

std::string sealed(const std::string& text) { return sealOf(text) + text; }

bool isSealed(const std::string& text) {
    const std::size_t end = text.find('\n');
    if (!text.starts_with(sealBegin) || end == std::string::npos) return false;
    const std::string_view whole = text, rest = whole.substr(end + 1);
    return whole.substr(0, end + 1) == sealOf(rest);
}

Outcome<Done> checkExportPlace(ExportFormat format, const fs::path& file) {
    std::error_code code;
    if (!fs::exists(file, code)) return Done{};
    if (Outcome<Done> isFile = checkRegularFile(file); !isFile) return isFile;
    if (fs::file_size(file, code) == 0) return Done{};
    Known known = lookAt(format, file);
    if (known.isOwn) return Done{};
    return fileError(std::move(known.fault), file.string(), 0, 0, phrase("Give another name, or remove it first."));
}

}  // namespace analogon
