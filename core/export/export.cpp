#include "core/export/export.hpp"

#include <fstream>

#include "core/export/fmu.hpp"
#include "core/export/modelica.hpp"
#include "core/report/report.hpp"
#include "core/study/run.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

/// Written beside and moved, so that no half file is ever seen.
Outcome<Exported> writeWhole(const fs::path& file, const std::string& text) {
    fs::path beside = file;
    beside += ".writing";
    std::error_code code;
    if (fs::is_directory(file, code)) return fileError(phrase("this is a directory; name a file"), file.string());
    std::ofstream stream(beside, std::ios::binary);
    stream << text;
    stream.close();
    if (stream) fs::rename(beside, file, code);
    if (stream && !code) return Exported{};
    fs::remove(beside, code);
    return fileError(phrase("this cannot be written"), file.string(), 0, 0,
                     phrase("Check that the directory exists, may be written and has room."));
}

}  // namespace

Outcome<Exported> exportStudy(const Study& study, ExportFormat format, const fs::path& file, const Progress& progress) {
    switch (format) {
        case ExportFormat::Modelica: {
            const Outcome<std::string> text = modelicaText(study);
            return text ? writeWhole(file, *text) : text.diagnostics();
        }
        case ExportFormat::Csv: {
            const Outcome<RunResult> result = runSimulate(study, {}, progress);
            return result ? writeWhole(file, tracesCsv(result->finding)) : result.diagnostics();
        }
        case ExportFormat::Fmu:
            break;
    }
    const Outcome<Fmu> fmu = fmuOf(study);
    if (!fmu) return fmu.diagnostics();
    const Outcome<Done> written = writeFmu(*fmu, file);
    if (!written) return written.diagnostics();
    return {Exported{fmu->hasModelExchange}, written.diagnostics()};
}

}  // namespace analogon
