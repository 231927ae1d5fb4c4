#include "core/measure/open/open_recording.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "core/measure/encoding.hpp"
#include "core/measure/mapped_file.hpp"
#include "core/measure/mat/mat.hpp"
#include "core/measure/mdf/mdf.hpp"
#include "core/measure/tdms/tdms.hpp"
#include "core/measure/text/text_recording.hpp"
#include "core/measure/unknown_unit.hpp"
#include "core/measure/xlsx/xlsx.hpp"

namespace analogon {

namespace {

/// Text has no zeros, unless it is UTF-16 or UTF-32, but those of a file that was made larger than what was written.
bool isText(ByteView bytes) {
    const std::string_view head = bytes.part(0, 4096).text();
    if (isWideText(head)) return true;
    const std::size_t zero = head.find('\0');
    if (zero == std::string_view::npos) return true;
    return head.substr(0, zero).find('\n') != std::string_view::npos &&
           head.find_first_not_of('\0', zero) == std::string_view::npos;
}

/// The name of a way to pack files, by its signature; empty: none that is known.
std::string packedBy(ByteView bytes) {
    using namespace std::string_view_literals;
    constexpr std::array<std::pair<std::string_view, std::string_view>, 6> signatures{
        {{"\x1F\x8B"sv, "gzip"sv},
         {"BZh"sv, "bzip2"sv},
         {"\xFD"
          "7zXZ\0"sv,
          "xz"sv},
         {"7z\xBC\xAF\x27\x1C"sv, "7-Zip"sv},
         {"Rar!\x1A\x07"sv, "RAR"sv},
         {"\x28\xB5\x2F\xFD"sv, "Zstandard"sv}}};
    for (const auto& [signature, name] : signatures)
        if (bytes.part(0, signature.size()).text() == signature) return std::string(name);
    return {};
}

Outcome<MeasurementFile> openAny(const std::filesystem::path& file, const ReadOptions& options) {
    const Outcome<std::shared_ptr<const MappedFile>> mapped = MappedFile::open(file);
    if (!mapped) return mapped.diagnostics();
    const ByteView bytes = (*mapped)->bytes();
    if (isMdf(bytes)) return openMdf(*mapped, file.string());
    if (isTdms(bytes)) return openTdms(*mapped, file.string());
    if (isZip(bytes)) return openXlsx(file.string());
    if (isMat(bytes)) return openMat(bytes, file.string());
    if (const std::string packer = packedBy(bytes); !packer.empty())
        return fileError(phrase("the file is packed ({})", packer), file.string(), 0, 0,
                         phrase("Unpack it, and take the file that is in it."));
    if (isText(bytes)) return openText(file, options);
    return fileError(
        phrase("this file is of no kind that can be read"), file.string(), 0, 0,
        phrase("ASAM MDF, MATLAB, TDMS, XLSX and text tables can be read: export the recording as one of them"));
}

}  // namespace

Outcome<bool> isTextRecording(const std::filesystem::path& file) {
    const Outcome<std::shared_ptr<const MappedFile>> mapped = MappedFile::open(file);
    if (!mapped) return mapped.diagnostics();
    const ByteView bytes = (*mapped)->bytes();
    return !isMdf(bytes) && !isTdms(bytes) && !isZip(bytes) && !isMat(bytes) && packedBy(bytes).empty() &&
           isText(bytes);
}

Outcome<MeasurementFile> openRecording(const std::filesystem::path& file, const ReadOptions& options) {
    Outcome<MeasurementFile> opened = openAny(file, options);
    if (!opened) return opened;
    nameUnits(*opened, options);
    for (const RecordedGroup& group : opened->groups)
        for (const UnknownUnit& unknown : unknownUnits(group)) opened->notes.push_back(told(unknown));
    return opened;
}

}  // namespace analogon
