#include "core/export/export.hpp"

#include <optional>

#include "core/base/distinct.hpp"
#include "core/base/whole_file.hpp"
#include "core/export/earlier_export.hpp"
#include "core/export/fmu.hpp"
#include "core/export/modelica.hpp"
#include "core/export/parameter_table.hpp"
#include "core/export/traces_mf4.hpp"
#include "core/report/report.hpp"
#include "core/study/run.hpp"
#include "core/study/validate.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

Outcome<Exported> written(const fs::path& file, const std::string& text) {
    const Outcome<Done> done = writeWhole(file, text);
    return done ? Outcome<Exported>(Exported{}) : Outcome<Exported>(done.diagnostics());
}

/// What is exported never takes the place of what it was made from.
Outcome<Done> checkTarget(const Study& study, const fs::path& file) {
    std::vector<std::string> names{"study.json"};
    for (const auto& [name, text] : study.models) names.push_back(name);
    for (const StudyExperiment& e : study.experiments) names.push_back(e.file);
    std::error_code code;
    for (const std::string& name : names)
        if (!study.directory.empty() && fs::equivalent(study.directory / name, file, code))
            return fileError(phrase("this is a file of the study itself"), file.string(), 0, 0,
                             phrase("Give another name."));
    return Done{};
}

Outcome<Exported> exportedTraces(const Study& study, const EstimationTask& task, const fs::path& file,
                                 const Progress& progress) {
    const Outcome<RunResult> result = runSimulate(study, {}, progress);
    if (!result) return result.diagnostics();
    const Outcome<std::vector<Mf4Group>> groups = tracesOf(result->finding.final, task);
    if (!groups) return groups.diagnostics();
    if (progress.stopRequested()) return fileError(phrase("interrupted"), file.string());  // the traces end early
    const std::string comment = "measured and simulated traces of " + study.className;
    const Outcome<Done> done =
        writeWhole(file, [&](const fs::path& beside) { return writeMf4(*groups, comment, beside, progress); });
    return done ? Outcome<Exported>(Exported{}) : Outcome<Exported>(done.diagnostics());
}

/// `task` is that of the study, where its traces are written with what they were made from.
Outcome<Exported> exported(const Study& study, const std::optional<EstimationTask>& task, ExportFormat format,
                           const fs::path& file, const Progress& progress) {
    switch (format) {
        case ExportFormat::Modelica: {
            const Outcome<std::string> text = modelicaText(study);
            return text ? written(file, sealed(*text)) : text.diagnostics();
        }
        case ExportFormat::Csv: {
            const Outcome<RunResult> result = runSimulate(study, {}, progress);
            if (!result) return result.diagnostics();
            const std::string text = tracesCsv(result->finding);
            if (progress.stopRequested()) return fileError(phrase("interrupted"), file.string());  // they end early
            return written(file, text);
        }
        case ExportFormat::Mf4:
            return exportedTraces(study, *task, file, progress);
        case ExportFormat::Parameters: {
            const Outcome<ParameterTable> table = parameterTable(study);
            return table ? written(file, parameterText(*table, *parameterFormatOf(file))) : table.diagnostics();
        }
        case ExportFormat::Fmu:
            break;
    }
    const Outcome<Fmu> fmu = fmuOf(study);
    if (!fmu) return fmu.diagnostics();
    const Outcome<Done> written = writeFmu(*fmu, file, std::chrono::seconds(120), progress);
    if (!written) return written.diagnostics();
    return {Exported{fmu->hasModelExchange}, written.diagnostics()};
}

}  // namespace

Outcome<Exported> exportStudy(const Study& study, ExportFormat format, const fs::path& file, const Progress& progress,
                              Existing existing) {
    if (format == ExportFormat::Parameters && !parameterFormatOf(file))
        return fileError(phrase("the ending of this name says no format of parameters"), file.string(), 0, 0,
                         phrase("It is .csv, .json, .ssv (SSP 1.0), .dcm (DCM 2.0) or .cdfx (ASAM CDF 2.0)."));
    if (Outcome<Done> isFree = checkTarget(study, file); !isFree) return isFree.diagnostics();
    if (existing == Existing::OwnAlone)
        if (Outcome<Done> isOwn = checkExportPlace(format, file); !isOwn) return isOwn.diagnostics();
    Diagnostics said;
    std::optional<EstimationTask> task;
    const bool isModelAlone = study.experiments.empty() && format != ExportFormat::Mf4;  // of which there are no traces
    if (!isModelAlone) {
        Outcome<ValidStudy> valid = validated(study, Purpose::Simulate);
        if (!valid) return valid.diagnostics();
        said = valid.diagnostics();
        if (format == ExportFormat::Mf4) task = std::move(valid->task);
    }
    Outcome<Exported> result = exported(study, task, format, file, progress);
    if (!result) return result.diagnostics();
    said.insert(said.end(), result.diagnostics().begin(), result.diagnostics().end());
    return {std::move(*result), distinct(std::move(said))};
}

}  // namespace analogon
