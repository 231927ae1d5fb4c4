#include "app/analogon-cli/convert.hpp"

#include <ostream>

#include "core/archive/archive.hpp"
#include "core/base/distinct.hpp"
#include "core/base/stop.hpp"
#include "core/base/visible.hpp"
#include "core/export/export.hpp"
#include "core/study/named_path.hpp"
#include "core/study/pending_save.hpp"
#include "core/study/study_places.hpp"
#include "core/study/study_with.hpp"
#include "core/study/validate.hpp"

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

int endsInterrupted(const char* what, std::ostream& err) {
    err << "interrupted: nothing was " << what << std::endl;
    return interrupted;
}

/// Libraries elsewhere that are to come along and are not there.
Diagnostics missingLibraries(const Study& study) {
    Diagnostics faults;
    std::error_code code;
    for (const NamedPath& named : namedPaths(study))
        if (named.key == NamedPath::Key::Library && leavesDirectory(named.path) &&
            !fs::exists(study.directory / named.path, code))
            faults.push_back(StudyPlaces(study).fault(named.pointer, phrase("there is no library '{}'", named.path),
                                                      phrase("An archive reads itself alone, so the library must come "
                                                             "along: put it there, or take it out of study.json.")));
    return faults;
}

/// One file of an export. Whoever is stopped leaves what was there.
Outcome<Exported> exportTo(const Study& study, ExportFormat format, const fs::path& file) {
    try {
        return analogon::exportStudy(study, format, file, Progress(stopInForce(), {}), Existing::OwnAlone);
    } catch (const Stopped&) {
        return fileError(phrase("interrupted"), file.string());
    }
}

}  // namespace

int pack(const Options& options, std::ostream& out, std::ostream& err) {
    const Outcome<OpenedStudy> opened = openStudy(options.input);
    if (!opened) return fails(opened.diagnostics(), err);
    // An archive keeps a study as it is; what would hinder work on it is told all the same.
    Diagnostics said = opened.diagnostics();
    const Outcome<ValidStudy> valid = validated(opened->study, Purpose::Simulate);
    said.insert(said.end(), valid.diagnostics().begin(), valid.diagnostics().end());
    tell(distinct(namedAs(std::move(said), *opened)), err);
    fs::path target = options.out.empty() ? fs::path(opened->study.name + archiveEnding) : options.out;
    std::error_code code;
    if (fs::is_directory(target, code)) target /= opened->study.name + archiveEnding;
    if (target.extension() != archiveEnding) target += archiveEnding;
    if (const Diagnostics faults = missingLibraries(opened->study); !faults.empty()) return fails(faults, err);
    const Outcome<Done> packed = packStudy(*opened, target, Progress(stopInForce(), {}));
    if (!packed && isStopped()) return endsInterrupted("packed", err);
    if (!packed) return fails(packed.diagnostics(), err);
    tell(packed.diagnostics(), err);
    out << "packed: " << target.string() << std::endl;
    return done;
}

int unpack(const Options& options, std::ostream& out, std::ostream& err) {
    if (std::error_code code; !fs::exists(options.input, code))
        return fails({fileError("there is no such file", options.input.string())}, err);
    const fs::path target = options.out.empty() ? options.input.stem() : options.out;
    const Outcome<Done> unpacked = unpackArchive(options.input, target, Progress(stopInForce(), {}));
    if (!unpacked && isStopped()) return endsInterrupted("unpacked", err);
    if (!unpacked) return fails(unpacked.diagnostics(), err);
    tell(unpacked.diagnostics(), err);
    out << "unpacked: " << target.string() << std::endl;
    return done;
}

int exportStudy(const Options& options, std::ostream& out, std::ostream& err) {
    if (options.fmuFile.empty() && options.modelicaFile.empty() && options.csvFile.empty() && options.mf4File.empty() &&
        options.parameterFile.empty())
        return fails({fileError("export what? Give --fmu FILE, --modelica FILE, --csv FILE, --mf4 FILE or --parameters "
                                "FILE",
                                "")},
                     err);
    Outcome<OpenedStudy> opened = openStudy(options.input);
    if (!opened) return fails(opened.diagnostics(), err);
    Diagnostics told = opened.diagnostics();
    tell(told, err);
    opened->study = withLibraries(std::move(opened->study), options.libraries);
    struct Wanted {
        ExportFormat format;
        const fs::path& file;
        const char* what;
    };
    for (const Wanted& wanted : {Wanted{ExportFormat::Modelica, options.modelicaFile, "model"},
                                 {ExportFormat::Fmu, options.fmuFile, "FMU"},
                                 {ExportFormat::Csv, options.csvFile, "traces"},
                                 {ExportFormat::Mf4, options.mf4File, "traces"},
                                 {ExportFormat::Parameters, options.parameterFile, "parameters"}}) {
        if (wanted.file.empty()) continue;
        const Outcome<Exported> exported = exportTo(opened->study, wanted.format, wanted.file);
        if (isStopped() && !exported) {
            err << "interrupted: " << visibleName(wanted.file.string()) << " was not written" << std::endl;
            return interrupted;
        }
        const Diagnostics more = notYetTold(namedAs(exported.diagnostics(), *opened), told);
        if (!exported) return fails(more, err);
        tell(more, err);
        told.insert(told.end(), more.begin(), more.end());
        out << wanted.what << ": " << wanted.file.string();
        if (wanted.format == ExportFormat::Fmu)
            out << (exported->hasModelExchange ? " (Co-Simulation and Model Exchange)" : " (Co-Simulation)");
        out << std::endl;
    }
    return done;
}

}  // namespace analogon::cli
