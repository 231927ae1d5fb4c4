#include "app/analogon-cli/convert.hpp"

#include <fmt/format.h>

#include <fstream>
#include <ostream>

#include "core/archive/archive.hpp"
#include "core/export/fmu.hpp"
#include "core/export/modelica.hpp"
#include "core/report/report.hpp"
#include "core/study/run.hpp"

namespace analogon::cli {

namespace {

namespace fs = std::filesystem;

int fails(const Diagnostics& faults, std::ostream& err) {
    err << format(faults) << std::endl;
    for (const Diagnostic& d : faults)
        if (d.isNumerical) return numericsFailed;
    return inputAtFault;
}

void tell(const Diagnostics& warnings, std::ostream& err) {
    if (!warnings.empty()) err << format(warnings) << std::endl;
}

/// Written beside and moved, so that no half file is ever seen.
Outcome<Done> writeWhole(const fs::path& file, const std::string& text) {
    fs::path beside = file;
    beside += ".writing";
    std::error_code code;
    if (fs::is_directory(file, code)) return fileError("this is a directory; name a file", file.string());
    std::ofstream stream(beside, std::ios::binary);
    stream << text;
    stream.close();
    if (stream) fs::rename(beside, file, code);
    if (stream && !code) return Done{};
    fs::remove(beside, code);
    return fileError("this cannot be written", file.string(), 0, 0,
                     "Check that the directory exists, may be written and has room.");
}

}  // namespace

int pack(const Options& options, std::ostream& out, std::ostream& err) {
    const Outcome<OpenedStudy> opened = openStudy(options.input);
    if (!opened) return fails(opened.diagnostics(), err);
    tell(opened.diagnostics(), err);
    fs::path target = options.out.empty() ? fs::path(opened->study.name + archiveEnding) : options.out;
    std::error_code code;
    if (fs::is_directory(target, code)) target /= opened->study.name + archiveEnding;
    if (target.extension() != archiveEnding) target += archiveEnding;
    if (const Outcome<Done> saved = saveStudy(opened->study, target); !saved) return fails(saved.diagnostics(), err);
    out << "packed: " << target.string() << std::endl;
    return done;
}

int unpack(const Options& options, std::ostream& out, std::ostream& err) {
    if (std::error_code code; !fs::exists(options.input, code))
        return fails({fileError("there is no such file", options.input.string())}, err);
    const fs::path target = options.out.empty() ? options.input.stem() : options.out;
    const Outcome<Done> unpacked = unpackArchive(options.input, target);
    if (!unpacked) return fails(unpacked.diagnostics(), err);
    tell(unpacked.diagnostics(), err);
    out << "unpacked: " << target.string() << std::endl;
    return done;
}

int exportStudy(const Options& options, std::ostream& out, std::ostream& err) {
    if (options.fmuFile.empty() && options.modelicaFile.empty() && options.csvFile.empty())
        return fails({fileError("export what? Give --fmu FILE, --modelica FILE or --csv FILE", "")}, err);
    Outcome<OpenedStudy> opened = openStudy(options.input);
    if (!opened) return fails(opened.diagnostics(), err);
    tell(opened.diagnostics(), err);
    for (const fs::path& p : options.libraries) opened->study.libraryPaths.push_back(fs::absolute(p).string());
    if (!options.modelicaFile.empty()) {
        const Outcome<std::string> text = modelicaText(opened->study);
        if (!text) return fails(namedAs(text.diagnostics(), *opened), err);
        if (const auto written = writeWhole(options.modelicaFile, *text); !written)
            return fails(written.diagnostics(), err);
        out << "model: " << options.modelicaFile.string() << std::endl;
    }
    if (!options.fmuFile.empty()) {
        const Outcome<Fmu> fmu = fmuOf(opened->study);
        if (!fmu) return fails(namedAs(fmu.diagnostics(), *opened), err);
        const Outcome<Done> written = writeFmu(*fmu, options.fmuFile);
        if (!written) return fails(written.diagnostics(), err);
        tell(written.diagnostics(), err);
        out << "FMU: " << options.fmuFile.string() << " ("
            << (fmu->hasModelExchange ? "Co-Simulation and Model Exchange" : "Co-Simulation") << ")" << std::endl;
    }
    if (!options.csvFile.empty()) {
        const Outcome<RunResult> result = runSimulate(opened->study, {});
        if (!result) return fails(namedAs(result.diagnostics(), *opened), err);
        if (const auto written = writeWhole(options.csvFile, tracesCsv(result->finding)); !written)
            return fails(written.diagnostics(), err);
        out << "traces: " << options.csvFile.string() << std::endl;
    }
    return done;
}

}  // namespace analogon::cli
