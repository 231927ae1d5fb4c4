#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/distinct.hpp"
#include "core/base/unit.hpp"
#include "core/fit/clock.hpp"
#include "core/fit/held_input.hpp"
#include "core/flat/free_ordinates.hpp"
#include "core/flat/parameter_change.hpp"
#include "core/measure/channel_place.hpp"
#include "core/measure/join.hpp"
#include "core/measure/plausibility.hpp"
#include "core/study/left_out.hpp"
#include "core/study/mapped_signals.hpp"
#include "core/study/measured.hpp"
#include "core/study/parameter_reader.hpp"
#include "core/study/recorded.hpp"
#include "core/study/study_places.hpp"

namespace analogon {

namespace {

Text noColumn() { return phrase("There is no column."); }

/// Top-level signals of the model with their units.
struct ModelSignals {
    std::map<std::string, std::string> inputs, outputs;  // name -> unit
    std::vector<std::string> inputNames, outputNames;    // in the order of the model
};

ModelSignals signalsOf(const FlatModel& model) {
    ModelSignals signals;
    for (std::uint32_t i = 0; i < model.variables.size(); ++i) {
        const FlatVariable& variable = model.variables[i];
        if (model.isInput({i})) {
            signals.inputs[variable.name] = model.unitOf(variable);
            signals.inputNames.push_back(variable.name);
        } else if (variable.causality == FlatCausality::Output) {
            signals.outputs[variable.name] = model.unitOf(variable);
            signals.outputNames.push_back(variable.name);
        }
    }
    return signals;
}

/// Builds the task experiment by experiment; collects every fault on the way.
class TaskBuilder {
public:
    TaskBuilder(const Study& study, Library library, const FlatModel& model, UnusedColumns unused)
        : study_(study),
          places_(study),
          model_(model),
          unused_(unused),
          signals_(signalsOf(model)),
          parameters_(study, places_, model, said_) {
        task_.library = std::move(library);
        task_.className = study.className;
        task_.model = task_.library.find(study.className)->definition->source;
    }

    Outcome<EstimationTask> build(Diagnostics warnings) {
        said_ = std::move(warnings);
        if (study_.experiments.empty())
            fault("/experiments", phrase("the study has no experiment"), phrase("Add a measurement to it."));
        parameters_.read(task_.parameters, fixed_);
        const auto isUsed = [](const StudyExperiment& e) { return e.isUsed; };
        if (!study_.experiments.empty() && std::none_of(study_.experiments.begin(), study_.experiments.end(), isUsed))
            fault("/experiments", phrase("no experiment of the study is used"),
                  phrase("Take one back in: leave out its \"use\": false."));
        for (std::size_t i = 0; i < study_.experiments.size(); ++i) {
            if (!study_.experiments[i].isUsed) continue;
            const std::size_t before = said_.size();
            readExperiment(study_.experiments[i], fmt::format("/experiments/{}", i));
            Diagnostics why(said_.begin() + static_cast<std::ptrdiff_t>(before), said_.end());
            if (hasError(why)) faulty_.push_back({i, study_.experiments[i].name, distinct(std::move(why))});
        }
        addFittedClocks();
        if (hasError(said_)) return distinct(std::move(said_));
        return {std::move(task_), distinct(std::move(said_))};
    }

    /// The recordings that could not be read, once built.
    const std::vector<FaultyRecording>& faulty() const { return faulty_; }

private:
    void fault(const std::string& pointer, Text message, Text hint = {}) {
        said_.push_back(places_.fault(pointer, std::move(message), std::move(hint)));
        ++faults_;
    }

    /// The setting of a fitted clock: its start, bounds and prior may stand among the parameters.
    StudyParameter clockSetting(const std::string& output) const {
        const auto setting = study_.parameters.find(clockOf(output));
        return setting == study_.parameters.end() ? StudyParameter{} : setting->second;
    }

    /// One offset for all experiments that ask for it under the name of one output: it is the same logger.
    void addFittedClocks() {
        for (const std::string& output : signals_.outputNames) {
            const StudyParameter setting = clockSetting(output);
            if (!asksForClock(study_.experiments, output) || !setting.fit) continue;
            const double reach = clockReach(output);
            FitParameter clock;
            clock.name = clockOf(output);
            clock.unit = "s";
            clock.start = setting.value.value_or(0.0);
            clock.min = setting.min.value_or(std::min(-reach, clock.start - reach));
            clock.max = setting.max.value_or(std::max(reach, clock.start + reach));
            clock.scale = ParameterScale::Linear;
            clock.prior = setting.prior;
            if (clock.start < clock.min || clock.start > clock.max || !(clock.min < clock.max))
                fault("/parameters/" + JsonPlaces::escape(clock.name),
                      phrase("the start value {} of '{}' lies outside its bounds {} … {}", clock.start, clock.name,
                             clock.min, clock.max),
                      phrase("Widen the bounds, or give another start as \"value\"."));
            const bool isFitted =
                std::any_of(task_.recordings.begin(), task_.recordings.end(), [&](const Recording& r) {
                    return r.role == Role::Fit && std::any_of(r.clocks.begin(), r.clocks.end(), [&](const auto& c) {
                               return c.output == output && isFittedIn(r.name, output);
                           });
                });
            if (isFitted) task_.parameters.push_back(std::move(clock));
        }
    }

    /// How far a clock is looked for: a hundred samples, but no more than a twentieth of the shortest recording.
    double clockReach(const std::string& output) const {
        double reach = std::numeric_limits<double>::infinity();
        for (const Recording& r : task_.recordings) {
            if (r.time.size() < 2 || !isFittedIn(r.name, output)) continue;
            const double span = r.time.back() - r.time.front();
            reach = std::min({reach, 0.05 * span, 100.0 * span / static_cast<double>(r.time.size() - 1)});
        }
        return std::isfinite(reach) ? reach : 1.0;
    }

    bool isFittedIn(const std::string& experiment, const std::string& output) const {
        for (const StudyExperiment& e : study_.experiments) {
            const auto mapping = e.outputs.find(output);
            if (e.name == experiment && mapping != e.outputs.end()) return mapping->second.fitsClock;
        }
        return false;
    }

    void readClocks(const StudyExperiment& experiment, const std::string& pointer, Recording& recording) {
        for (const std::string& output : recording.outputNames) {
            const ChannelMapping& mapping = experiment.outputs.at(output);
            if (mapping.fitsClock)
                recording.clocks.push_back({output, clockSetting(output).value.value_or(0.0)});
            else if (mapping.clock != 0.0)
                recording.clocks.push_back({output, mapping.clock});
        }
        for (std::size_t i = 0; i < recording.inputNames.size(); ++i) {
            const ChannelMapping& mapping = experiment.inputs.at(recording.inputNames[i]);
            if (mapping.fitsClock)
                fault(fmt::format("{}/inputs/{}/clock", pointer, JsonPlaces::escape(recording.inputNames[i])),
                      phrase("experiment '{}': the clock of an input cannot be fitted", experiment.name),
                      phrase("Give its offset in seconds, or fit the clocks of the outputs."));
            if (mapping.clock == 0.0 || recording.inputs.cols() == 0 || recording.isHeld(recording.inputNames[i]))
                continue;
            auto row = recording.inputs.row(static_cast<Eigen::Index>(i));
            row = onLinesAt(recording.time, row, mapping.clock);
        }
    }

    /// The clocks of held inputs: each jumps at moments of its own, and they become samples of the recording.
    static void shiftHeldInputs(const StudyExperiment& experiment, Recording& recording) {
        for (std::size_t i = 0; i < recording.inputNames.size(); ++i) {
            const double clock = experiment.inputs.at(recording.inputNames[i]).clock;
            if (clock != 0.0 && recording.isHeld(recording.inputNames[i])) shiftHeld(recording, i, clock);
        }
    }

    void readExperiment(const StudyExperiment& experiment, const std::string& pointer) {
        file_ = fileTable(study_.tables, experiment);
        if (const auto unread = study_.unread.find(tableKey(experiment)); !file_ && unread != study_.unread.end()) {
            keep(Outcome<Done>(unread->second));
            return;
        }
        if (!file_)
            return fault(pointer + "/file",
                         phrase("experiment '{}': the file '{}' has not been read", experiment.name, experiment.file));
        if (experiment.raster.kind == Raster::Kind::Channel)
            if (const auto places = placesOf(*file_, experiment.raster.channel); places.size() != 1) {
                tellMissing(places, experiment.raster.channel, experiment, pointer + "/raster");
                return;
            }
        const Outcome<std::shared_ptr<const Table>> joined = recordedTable(study_.tables, experiment);
        if (!keep(joined)) return;
        const std::optional<Cut> cut = cutToRange(*joined, experiment, pointer);
        if (!cut) return;
        const Table& table = *cut->used;
        const Outcome<std::vector<double>> time = readTime(table, experiment.timeColumn);
        if (!keep(time)) return;

        Recording recording;
        recording.name = experiment.name;
        recording.role = experiment.role;
        recording.time = *time;
        const bool complete = checkSignals(experiment, pointer);
        recording.inputNames = mapped(experiment.inputs, signals_.inputNames);
        for (const std::string& input : recording.inputNames) {
            ChannelMapping mapping = experiment.inputs.at(input);
            const Column* const column = table.find(mapping.column, mapping.group);
            if (column ? isHeld(*column, mapping.interpolation) : mapping.interpolation == Interpolation::Hold)
                recording.held.push_back(input);
            mapping.interpolation = Interpolation::Hold;
            recording.asHeld[input] = mappingText(mapping);
        }
        recording.outputNames = mapped(experiment.outputs, signals_.outputNames);
        const bool read =
            readRows(table, experiment, recording.inputNames, experiment.inputs, signals_.inputs, pointer + "/inputs",
                     EmptyCells::Fault, *time, recording.inputs, recording.units) &
            readRows(table, experiment, recording.outputNames, experiment.outputs, signals_.outputs,
                     pointer + "/outputs", EmptyCells::NotMeasured, *time, recording.outputs, recording.units);
        recording.weights.resize(static_cast<Eigen::Index>(recording.outputNames.size()));
        for (std::size_t i = 0; i < recording.outputNames.size(); ++i)
            recording.weights[static_cast<Eigen::Index>(i)] = experiment.outputs.at(recording.outputNames[i]).weight;
        if (complete && read && recording.time.size() > 1) readClocks(experiment, pointer, recording);
        readStarts(table, experiment, pointer, recording);
        if (unused_ == UnusedColumns::Take) addSpares(*cut, experiment, recording);
        addRemarks(table, experiment);
        if (complete && read) shiftHeldInputs(experiment, recording);
        if (complete && read) task_.recordings.push_back(std::move(recording));
    }

    template <class T>
    bool keep(const Outcome<T>& outcome) {
        said_.insert(said_.end(), outcome.diagnostics().begin(), outcome.diagnostics().end());
        faults_ += outcome ? 0 : 1;
        return outcome.hasValue();
    }

    bool hasColumn(const Table& table, const ChannelName& name, const StudyExperiment& experiment,
                   const std::string& pointer) {
        const std::vector<ChannelPlace> places = placesOf(*file_, name);
        if (places.size() == 1 && table.find(name.column, name.group)) return true;
        return tellMissing(places, name, experiment, pointer);
    }

    bool tellMissing(const std::vector<ChannelPlace>& places, const ChannelName& name,
                     const StudyExperiment& experiment, const std::string& pointer) {
        if (places.size() > 1)
            fault(pointer,
                  phrase("experiment '{}': '{}' has {} channels '{}'", experiment.name, experiment.file, places.size(),
                         name.column),
                  phrase("Say which: {{\"column\": \"{}\", \"group\": …}}, one of {}.", name.column, groupsOf(places)));
        else if (const std::vector<ChannelPlace> elsewhere = placesOf(*file_, {name.column}); !elsewhere.empty())
            fault(pointer,
                  phrase("experiment '{}': '{}' has no channel '{}' in this group", experiment.name, experiment.file,
                         name.column),
                  phrase("It is in {}.", groupsOf(elsewhere)));
        else
            fault(pointer,
                  phrase("experiment '{}': '{}' has no column '{}'", experiment.name, experiment.file, name.column),
                  hintForMissing(name.column));
        return false;
    }

    /// "'XCP 1ms', 'CAN 10ms'"; by number where two have one name.
    static Text groupsOf(const std::vector<ChannelPlace>& places) {
        std::vector<std::string> names;
        for (const ChannelPlace& place : places) {
            const std::string& name = place.column->group;
            const auto same = std::count_if(places.begin(), places.end(),
                                            [&](const ChannelPlace& p) { return p.column->group == name; });
            names.push_back(name.empty() || same > 1 ? std::to_string(place.column->groupNumber) : "'" + name + "'");
        }
        return names.size() == 1 && places.front().column->group.empty() && places.front().column->groupNumber == 1
                   ? phrase("the only table of the file")
                   : listed(names);
    }

    Text hintForMissing(const std::string& name) const {
        for (const Table* const group : tablesOf(*file_))
            if (std::find(group->texts.begin(), group->texts.end(), name) != group->texts.end())
                return phrase(
                    "It holds words. If they are stamps of the time, tell how they are written: \"read\": "
                    "{{\"time_format\": \"%d.%m.%Y %H:%M:%S\"}}.");
        return meantOrAvailable(name, namesIn(*file_), noColumn());
    }

    /// A part of a measurement file: the columns that are used, cut, and where they begin in all of it.
    struct Cut {
        std::shared_ptr<const Table> used, whole;
        std::size_t first{};
    };

    /// In a file of several groups more than one may call its stamps so.
    bool hasTime(const Table& table, const StudyExperiment& experiment, const std::string& pointer) {
        return table.find(experiment.timeColumn, experiment.timeGroup) ||
               hasColumn(table, {experiment.timeColumn, experiment.timeGroup}, experiment, pointer);
    }

    /// The rows within "range"; the times of the others are not looked at.
    std::optional<Cut> cutToRange(const std::shared_ptr<const Table>& whole, const StudyExperiment& experiment,
                                  const std::string& pointer) {
        const Table& table = *whole;
        if (experiment.timeColumn.empty()) {
            fault(pointer,
                  phrase("experiment '{}': neither the study nor '{}' tells which column is the time", experiment.name,
                         experiment.file),
                  phrase("Name it: \"time\": \"…\"."));
            return std::nullopt;
        }
        if (!hasTime(table, experiment, pointer + "/time")) return std::nullopt;
        if (!experiment.range) return Cut{whole, whole, 0};
        const auto [first, last] = usedRows(table, experiment);
        if (last - first >= 2)
            return Cut{std::make_shared<const Table>(cutTo(table, first, last, usedColumns(table, experiment))), whole,
                       first};
        const Column& column = *table.find(experiment.timeColumn, experiment.timeGroup);
        const UnitConversion convert = secondsOf(column);
        fault(pointer + "/range",
              phrase("experiment '{}': fewer than two samples lie between {} s and {} s", experiment.name,
                     experiment.range->first, experiment.range->second),
              phrase("The file runs from {:.6g} s to {:.6g} s.", convert(column.values.front()),
                     convert(column.values.back())));
        return std::nullopt;
    }

    Text hintForUnknown(const std::string& name, const std::vector<std::string>& names, bool isInput) const {
        if (isInput && model_.find(name).valid())
            return phrase("It is neither an input of the model nor the output of a block that only produces a signal.");
        const bool mayBeVariable = !isInput && suggestion(name, names).empty();
        const std::string alike = mayBeVariable ? suggestion(name, variableNames()) : std::string();
        if (!alike.empty()) return phrase("Did you mean '{}'?", alike);
        return meantOrAvailable(name, names, phrase("There is no such signal."));
    }

    std::vector<std::string> variableNames() const {
        std::vector<std::string> names;
        for (const FlatVariable& v : model_.variables)
            if (v.type == FlatType::Real && v.variability == FlatVariability::Continuous) names.push_back(v.name);
        return names;
    }

    /// Every mapped signal exists, every input of the model is mapped, some output is.
    bool checkSignals(const StudyExperiment& experiment, const std::string& pointer) {
        const std::size_t before = faults_;
        const auto check = [&](const auto& mappings, const auto& own, const auto& other, const std::string& side,
                               const std::vector<std::string>& names) {
            for (const auto& [name, mapping] : mappings) {
                if (own.contains(name)) continue;
                Text hint = hintForUnknown(name, names, side == "input");
                if (other.contains(name))
                    hint = side == "input" ? phrase("It is an output of the model: list it under \"outputs\".")
                                           : phrase("It is an input of the model: list it under \"inputs\".");
                fault(fmt::format("{}/{}s/{}", pointer, side, JsonPlaces::escape(name)),
                      side == "input" ? phrase("experiment '{}': the model '{}' has no input '{}'", experiment.name,
                                               study_.className, name)
                                      : phrase("experiment '{}': the model '{}' has no output '{}'", experiment.name,
                                               study_.className, name),
                      std::move(hint));
            }
        };
        check(experiment.inputs, signals_.inputs, signals_.outputs, "input", signals_.inputNames);
        check(experiment.outputs, signals_.outputs, signals_.inputs, "output", signals_.outputNames);
        if (faults_ > before) return false;
        for (const std::string& name : signals_.inputNames)
            if (!experiment.inputs.contains(name))
                fault(pointer + "/inputs",
                      phrase("experiment '{}': the input '{}' of the model has no column", experiment.name, name),
                      phrase("Add \"{}\": \"COLUMN\" to \"inputs\". {}", name,
                             meantOrAvailable(name, namesIn(*file_), noColumn())));
        if (experiment.outputs.empty())
            fault(pointer + "/outputs", phrase("experiment '{}' measures no output of the model", experiment.name),
                  phrase("Map at least one of: {}.", joined(signals_.outputNames)));
        remarkSharedColumns(experiment, pointer);
        return faults_ == before;
    }

    static std::string keyOf(const ChannelName& name) {
        return fmt::format("{}\n{}\n{}", name.column, name.group.name, name.group.number);
    }

    /// Two outputs that are compared with one column are hardly meant.
    void remarkSharedColumns(const StudyExperiment& experiment, const std::string& pointer) {
        std::map<std::string, std::string> first;  // column -> output
        for (const auto& [output, mapping] : experiment.outputs) {
            const auto [known, isNew] = first.emplace(keyOf(mapping.channel()), output);
            if (isNew) continue;
            said_.push_back(places_.remark(
                fmt::format("{}/outputs/{}", pointer, JsonPlaces::escape(output)),
                phrase("experiment '{}': the outputs '{}' and '{}' are both compared with the column '{}'",
                       experiment.name, known->second, output, mapping.column)));
        }
    }

    static std::vector<std::string> mapped(const std::map<std::string, ChannelMapping>& mappings,
                                           const std::vector<std::string>& names) {
        std::vector<std::string> out;
        for (const std::string& name : names)
            if (mappings.contains(name)) out.push_back(name);
        return out;
    }

    /// Empty cells of an input are bridged where the study says how it runs between its samples.
    static Outcome<std::vector<double>> readInput(const Table& table, const ChannelMapping& mapping,
                                                  const std::string& unit, const std::vector<double>& time) {
        Outcome<std::vector<double>> whole = readChannel(table, mapping, unit, EmptyCells::Fault);
        if (whole || mapping.interpolation == Interpolation::Automatic) return whole;
        const Outcome<std::vector<double>> values = readChannel(table, mapping, unit, EmptyCells::NotMeasured);
        if (!values) return whole;
        const Course course = mapping.interpolation == Interpolation::Hold ? Course::Held : Course::Linear;
        std::vector<double> bridged = courseAt({time, *values}, time, course);
        if (std::any_of(bridged.begin(), bridged.end(), [](double v) { return std::isnan(v); })) return whole;
        return bridged;
    }

    bool readRows(const Table& table, const StudyExperiment& experiment, const std::vector<std::string>& names,
                  const std::map<std::string, ChannelMapping>& mappings,
                  const std::map<std::string, std::string>& units, const std::string& pointer, EmptyCells empty,
                  const std::vector<double>& time, Eigen::MatrixXd& rows, std::vector<ChannelUnit>& given) {
        rows.resize(static_cast<Eigen::Index>(names.size()), static_cast<Eigen::Index>(table.rows()));
        bool complete = true;
        for (std::size_t i = 0; i < names.size(); ++i) {
            const ChannelMapping& mapping = mappings.at(names[i]);
            const std::string place = pointer + '/' + JsonPlaces::escape(names[i]);
            if (!hasColumn(table, mapping.channel(), experiment, place)) {
                complete = false;
                continue;
            }
            if (!mapping.unit.empty() && !isKnownUnit(mapping.unit)) {
                const std::string alike = unitAlike(mapping.unit);
                fault(place + "/unit",
                      phrase("experiment '{}': the unit '{}' of '{}' is not known", experiment.name, mapping.unit,
                             mapping.column),
                      alike.empty() ? phrase("Write the unit that the numbers of the column are in.")
                                    : phrase("Did you mean '{}'?", alike));
                complete = false;
                continue;
            }
            const Outcome<std::vector<double>> values = empty == EmptyCells::NotMeasured
                                                            ? readChannel(table, mapping, units.at(names[i]), empty)
                                                            : readInput(table, mapping, units.at(names[i]), time);
            if (!keep(values)) {
                complete = false;
                continue;
            }
            const std::string& unit =
                mapping.unit.empty() ? table.find(mapping.column, mapping.group)->unit : mapping.unit;
            if (mapping.scale == 1 && mapping.offset == 0 && !unit.empty() && !units.at(names[i]).empty())
                given.push_back({names[i], mapping.column, unit, units.at(names[i])});
            rows.row(static_cast<Eigen::Index>(i)) =
                Eigen::Map<const Eigen::RowVectorXd>(values->data(), static_cast<Eigen::Index>(values->size()));
        }
        return complete;
    }

    void readStarts(const Table& table, const StudyExperiment& experiment, const std::string& pointer,
                    Recording& recording) {
        for (const auto& [name, value] : fixed_)
            if (!experiment.initial.contains(name)) recording.starts.push_back({name, value, false});
        for (const auto& [name, start] : experiment.initial) {
            const std::string place = pointer + "/initial/" + JsonPlaces::escape(name);
            const VariableId started = startedVariable(name);
            const std::string parameter = started.valid() ? startOf(model_[started].name) : name;
            const FlatVariable* variable = started.valid() ? &model_[started] : parameters_.startable(name, place);
            if (!variable || !mayStart(parameter, started, place, experiment.name, recording)) continue;
            const std::optional<RecordingStart> read = readStart(parameter, start, *variable, table, experiment, place);
            if (read && parameters_.isWithin(*variable, read->value, place)) recording.starts.push_back(*read);
        }
    }

    /// Whether the study is free to say where this begins, and says it once.
    bool mayStart(const std::string& parameter, VariableId started, const std::string& place,
                  const std::string& experiment, const Recording& recording) {
        const std::size_t before = faults_;
        const auto isItsStart = [&](const RecordingStart& s) { return s.parameter == parameter; };
        if (started.valid() && std::any_of(recording.starts.begin(), recording.starts.end(), isItsStart))
            fault(place, phrase("where '{}' begins is told twice", model_[started].name),
                  phrase("Keep one of the two entries."));
        else if (std::any_of(task_.parameters.begin(), task_.parameters.end(),
                             [&](const FitParameter& p) { return p.name == parameter; }))
            fault(place,
                  phrase("experiment '{}': {}", experiment,
                         phrase("{} is fitted for all experiments and has a start of its own here", parameter)),
                  phrase("remove one of the two"));
        return faults_ == before;
    }

    std::optional<RecordingStart> readStart(const std::string& parameter, const StudyStart& start,
                                            const FlatVariable& variable, const Table& table,
                                            const StudyExperiment& experiment, const std::string& place) {
        if (const double* number = std::get_if<double>(&start)) return RecordingStart{parameter, *number, false};
        if (const ColumnStart* column = std::get_if<ColumnStart>(&start)) {
            const ChannelMapping mapping = mappingOf({column->column, column->group}, experiment);
            if (!hasColumn(table, mapping.channel(), experiment, place)) return std::nullopt;
            const Outcome<std::vector<double>> first = readChannel(table.slice(0, 1), mapping, model_.unitOf(variable));
            if (!keep(first)) return std::nullopt;
            return RecordingStart{parameter, first->front(), false, column->column};
        }
        if (const std::optional<double> value = beginOf(parameter, parameter != variable.name))
            return RecordingStart{parameter, *value, true};
        fault(place, phrase("'{}' has no value to start from", variable.name), phrase("Give one in the model."));
        return std::nullopt;
    }

    /// Where the fit of a start value begins: as the study has it, or the model.
    std::optional<double> beginOf(const std::string& parameter, bool isOfVariable) const {
        const auto given = study_.parameters.find(parameter);
        if (given != study_.parameters.end() && given->second.value) return given->second.value;
        if (!isOfVariable) return model_.parameterValue(model_.find(parameter));
        const Outcome<FlatModel> started = withStart(model_, parameter);
        return started ? started->parameterValue(started->find(parameter)) : std::nullopt;
    }

    /// The variable of the model that is named, or of which the start value is ("rotor.w", "rotor.w.start").
    VariableId startedVariable(const std::string& name) const {
        const VariableId own = startedBy(model_, startOf(name));
        return own.valid() ? own : startedBy(model_, name);
    }

    /// How a column is read elsewhere in the experiment (its unit may be told there alone); else as it is.
    static ChannelMapping mappingOf(const ChannelName& name, const StudyExperiment& experiment) {
        for (const auto* mappings : {&experiment.inputs, &experiment.outputs})
            for (const auto& [signal, mapping] : *mappings)
                if (mapping.column == name.column && (!name.group.isTold() || mapping.group == name.group))
                    return mapping;
        ChannelMapping plain;
        plain.column = name.column;
        plain.group = name.group;
        return plain;
    }

    /// Columns that the model does not use. Gaps are bridged by straight lines; where little is left beside them the
    /// column is left out.
    void addSpares(const Cut& cut, const StudyExperiment& experiment, Recording& recording) const {
        const std::set<std::size_t> used = mappedColumns(*cut.whole, experiment);
        for (std::size_t i = 0; i < cut.whole->columns.size(); ++i)
            if (!used.contains(i)) addSpare(cut.whole->columns[i], cut.first, recording);
    }

    void addSpare(const Column& column, std::size_t first, Recording& recording) const {
        constexpr double mostBlanks = 0.5;
        const std::size_t count = recording.time.size();
        if (column.values.size() < first + count) return;
        const auto isInside = [&](const BlankCell& b) { return b.row >= first && b.row < first + count; };
        const auto blanks = std::count_if(column.blanks.begin(), column.blanks.end(), isInside);
        if (static_cast<double>(blanks) > mostBlanks * static_cast<double>(count)) return;
        const auto begin = column.values.begin() + static_cast<std::ptrdiff_t>(first);
        std::vector<double> values(begin, begin + static_cast<std::ptrdiff_t>(count));
        for (const BlankCell& blank : column.blanks)
            if (isInside(blank)) values[blank.row - first] = std::nan("");
        bridge(recording.time, values);
        recording.spares.push_back({labelOf(*file_, column), column.unit, std::move(values)});
    }

    /// What the numbers that are used cannot well be.
    void addRemarks(const Table& table, const StudyExperiment& experiment) {
        std::vector<const Column*> used;
        for (const auto* mappings : {&experiment.inputs, &experiment.outputs})
            for (const auto& [signal, mapping] : *mappings) {
                const Column* const column = table.find(mapping.column, mapping.group);
                const bool isAsItStands = mapping.unit.empty() && mapping.scale == 1 && mapping.offset == 0;
                const bool isNew = std::find(used.begin(), used.end(), column) == used.end();
                if (column && isAsItStands && isNew) used.push_back(column);
            }
        const Diagnostics told = implausibilities(table, used);
        said_.insert(said_.end(), told.begin(), told.end());
    }

    /// NaN become what the straight line between their neighbours has there; at the ends, the nearest value.
    static void bridge(const std::vector<double>& time, std::vector<double>& values) {
        std::vector<std::size_t> known;
        for (std::size_t k = 0; k < values.size(); ++k)
            if (!std::isnan(values[k])) known.push_back(k);
        if (known.empty()) return;
        auto behind = known.begin();
        for (std::size_t k = 0; k < values.size(); ++k) {
            while (behind != known.end() && *behind < k) ++behind;
            if (behind != known.end() && *behind == k) continue;
            const std::size_t after = behind == known.end() ? known.back() : *behind,
                              before = behind == known.begin() ? after : *std::prev(behind);
            values[k] = after <= before ? values[before]
                                        : values[before] + (values[after] - values[before]) * (time[k] - time[before]) /
                                                               (time[after] - time[before]);
        }
    }

    const Study& study_;
    std::shared_ptr<const Table> file_;  // of the experiment that is read
    StudyPlaces places_;
    const FlatModel& model_;
    UnusedColumns unused_;
    ModelSignals signals_;
    Diagnostics said_;
    std::size_t faults_{};  // of the experiments
    std::vector<FaultyRecording> faulty_;
    ParameterReader parameters_;
    std::vector<std::pair<std::string, double>> fixed_;  // set by the study, not fitted
    EstimationTask task_;
};

}  // namespace

bool asksForClock(const std::vector<StudyExperiment>& experiments, const std::string& output) {
    return std::any_of(experiments.begin(), experiments.end(), [&](const StudyExperiment& e) {
        const auto mapping = e.outputs.find(output);
        return mapping != e.outputs.end() && mapping->second.fitsClock;
    });
}

Outcome<Library> studyLibrary(const Study& study) {
    Outcome<Library> library = builtInLibrary();
    if (!library) return library;
    Diagnostics faults, warnings;
    const auto keep = [&](Outcome<Library> next) {
        Diagnostics& to = next ? warnings : faults;
        to.insert(to.end(), next.diagnostics().begin(), next.diagnostics().end());
        if (next) library = std::move(next);
    };
    for (const std::string& path : study.libraryPaths) keep(library->withPath(study.directory / path));
    std::vector<SourcePtr> sources;
    const auto add = [&](const std::string& name, const std::string& text) {
        const std::string shown = study.directory.empty() ? name : (study.directory / name).string();
        sources.push_back(std::make_shared<const Source>(shown, text));
    };
    for (const auto& [name, text] : study.models)
        if (name != study.modelFile) add(name, text);
    if (const auto model = study.models.find(study.modelFile); model != study.models.end())
        add(model->first, model->second);
    keep(library->withSources(sources));
    if (const LibraryClass* model = library->find(study.className))
        library = Outcome<Library>(library->withMeasured(mappedSignals(study, model->qualifiedName)));
    if (!faults.empty()) return faults;
    return {std::move(*library), std::move(warnings)};
}

namespace {

Outcome<EstimationTask> builtTask(const Study& study, UnusedColumns unused, std::vector<FaultyRecording>& faulty) {
    Outcome<Library> library = studyLibrary(study);
    if (!library) return library.diagnostics();
    if (!library->find(study.className)) {
        std::vector<std::string> own;
        for (const LibraryClass* known : library->classes())
            if (!known->qualifiedName.starts_with("Analogon.") && known->qualifiedName != "Analogon")
                own.push_back(known->qualifiedName);
        if (study.models.empty())
            return StudyPlaces(study).fault("/class", phrase("the study has no model of '{}'", study.className),
                                            phrase("Put the model's text beside study.json as model.mo."));
        return StudyPlaces(study).fault("/class",
                                        phrase("there is no class '{}' in the models of the study", study.className),
                                        meantOrAvailable(study.className, own, phrase("There is no class.")));
    }
    std::vector<std::string> named;
    for (const auto& [name, parameter] : study.parameters) named.push_back(name);
    const Outcome<FlatModel> model = flatten(*library, study.className, named);
    if (!model) return model.diagnostics();
    Diagnostics said = library.diagnostics();
    for (const Diagnostics& more : {model.diagnostics(), outsideRange(*model, study)})
        said.insert(said.end(), more.begin(), more.end());
    TaskBuilder builder(study, std::move(*library), *model, unused);
    Outcome<EstimationTask> task = builder.build(std::move(said));
    faulty = builder.faulty();
    return task;
}

}  // namespace

Outcome<EstimationTask> estimationTask(const Study& study, UnusedColumns unused) {
    std::vector<FaultyRecording> faulty;
    return builtTask(study, unused, faulty);
}

std::vector<FaultyRecording> faultyRecordings(const Study& study) {
    std::vector<FaultyRecording> faulty;
    static_cast<void>(builtTask(study, UnusedColumns::Leave, faulty));
    return faulty;
}

}  // namespace analogon
