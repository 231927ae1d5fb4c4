#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/fit/estimation_task.hpp"
#include "core/measure/channel.hpp"
#include "core/measure/common_raster.hpp"
#include "core/measure/read_options.hpp"

/// A study as it is written down (contract, section 4), and the way from it to an estimation task.
namespace analogon {

struct FittedStart {
    friend bool operator==(const FittedStart&, const FittedStart&) = default;
};
struct ColumnStart {
    std::string column;
    GroupName group{};  // of the file, where the name alone does not tell

    friend bool operator==(const ColumnStart&, const ColumnStart&) = default;
};
/// A number, "fit", or the first value of a column.
using StudyStart = std::variant<double, FittedStart, ColumnStart>;

struct StudyExperiment {
    std::string name;
    Role role{Role::Fit};
    std::string file;  // relative to the study
    std::string timeColumn;
    std::optional<std::pair<double, double>> range;  // [s]
    std::map<std::string, ChannelMapping> inputs;    // model input -> column
    std::map<std::string, ChannelMapping> outputs;
    std::map<std::string, StudyStart> initial;
    GroupName timeGroup{};  // of the time column, where its name alone does not tell
    ReadOptions read{};     // how a text is written
    Raster raster{};
    bool isTimeOfFile{};  // the study does not name its time: it is the one that the file tells
    bool isUsed{true};    // "use": false: it stays in the study, and no work looks at it

    friend bool operator==(const StudyExperiment&, const StudyExperiment&) = default;
};

struct StudyParameter {
    bool fit{true};
    std::optional<double> value;  // overrides the model's own
    std::optional<double> min, max;
    ParameterScale scale{ParameterScale::Automatic};
    std::optional<NormalPrior> prior{};  // what an expert knows of it
};

struct StudyFile {
    std::string name;  // relative, "model.mo", "train.csv"
    std::string content;
};

/// A value: copying gives a snapshot that later edits do not touch.
struct Study {
    std::string name;  // of the directory or archive
    std::string className;
    std::vector<StudyExperiment> experiments;
    std::map<std::string, StudyParameter> parameters;
    std::vector<std::string> libraryPaths;                       // "library": […] of study.json
    std::map<std::string, std::string> models;                   // .mo files: name -> text
    std::string modelFile{"model.mo"};                           // the one that holds the composed model
    std::map<std::string, std::shared_ptr<const Table>> tables;  // measurement files that are used, by tableKey
    std::map<std::string, Diagnostics> unread{};                 // why others have no table, by tableKey
    std::filesystem::path directory;  // where it was read from (measurements are copied from here)
    std::string extraJson;            // members of study.json that we do not know, kept
    SourcePtr json;                   // the study.json it was read from, for messages; may be null
};

/// What a measurement that is missing or cannot be read means: a fault of the study, or one that is kept in
/// Study::unread, and told where the recording is asked for. Of a recording that is not used it is always the latter.
enum class UnreadMeasurement { Refused, Kept };

/// Reads a directory with study.json, the study.json itself, or an .analogon archive. Every fault names file,
/// line and column or row. Tables are read here; units are checked in estimationTask.
Outcome<Study> readStudy(const std::filesystem::path& path, UnreadMeasurement unread = UnreadMeasurement::Refused);

/// A library that lies outside of a study that is written elsewhere is named by its whole path there, or, for an
/// archive, which reads itself alone, included.
enum class OutsideLibraries { Named, Included };

/// Writes study.json, the models and the measurements into a directory (created when missing), and the libraries that
/// lie within the study. All or nothing: written beside first, then moved.
Outcome<Done> writeStudy(const Study& study, const std::filesystem::path& directory,
                         OutsideLibraries outside = OutsideLibraries::Named);

/// Whether the offset of the clock of an output's own logger is to be found by the fit.
bool asksForClock(const std::vector<StudyExperiment>& experiments, const std::string& output);

/// A mapping as study.json has it, on one line.
std::string mappingText(const ChannelMapping& mapping);

/// How a text is written, as study.json has it, on one line.
std::string readText(const ReadOptions& read);

/// study.json text.
std::string studyJson(const Study& study);

/// The study that a study.json describes, without models and tables. Faults name line and column; members that
/// are not known are kept, with a warning.
Outcome<Study> parseStudyJson(const SourcePtr& json);

/// Columns that no signal takes: a search looks at them, nothing else does.
enum class UnusedColumns { Take, Leave };

/// Library, channels in model units, parameters: ready to fit.
Outcome<EstimationTask> estimationTask(const Study& study, UnusedColumns unused = UnusedColumns::Take);

/// The library of the study: the built-in one, its own paths and texts.
Outcome<Library> studyLibrary(const Study& study);

}  // namespace analogon
