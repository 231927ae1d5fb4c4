#include "core/measure/open/open_recording.hpp"

#include "core/measure/encoding.hpp"
#include "core/measure/mapped_file.hpp"
#include "core/measure/mat/mat.hpp"
#include "core/measure/mdf/mdf.hpp"
#include "core/measure/tdms/tdms.hpp"
#include "core/measure/text/text_recording.hpp"
#include "core/measure/xlsx/xlsx.hpp"

namespace analogon {

namespace {

/// Text has no zeros, unless it is UTF-16.
bool isText(ByteView bytes) {
    const std::string_view head = bytes.part(0, 4096).text();
    return isWideText(head) || head.find('\0') == std::string_view::npos;
}

}  // namespace

Outcome<bool> isTextRecording(const std::filesystem::path& file) {
    const Outcome<std::shared_ptr<const MappedFile>> mapped = MappedFile::open(file);
    if (!mapped) return mapped.diagnostics();
    const ByteView bytes = (*mapped)->bytes();
    return !isMdf(bytes) && !isTdms(bytes) && !isZip(bytes) && !isMat(bytes) && isText(bytes);
}

Outcome<MeasurementFile> openRecording(const std::filesystem::path& file, const ReadOptions& options) {
    const Outcome<std::shared_ptr<const MappedFile>> mapped = MappedFile::open(file);
    if (!mapped) return mapped.diagnostics();
    const ByteView bytes = (*mapped)->bytes();
    if (isMdf(bytes)) return openMdf(*mapped, file.string());
    if (isTdms(bytes)) return openTdms(*mapped, file.string());
    if (isZip(bytes)) return openXlsx(file.string());
    if (isMat(bytes)) return openMat(bytes, file.string());
    if (isText(bytes)) return openText(file, options);
    return fileError(
        phrase("this file is of no kind that can be read"), file.string(), 0, 0,
        phrase("ASAM MDF, MATLAB, TDMS, XLSX and text tables can be read: export the recording as one of them"));
}

}  // namespace analogon
