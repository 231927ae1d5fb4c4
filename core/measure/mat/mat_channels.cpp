#include "core/measure/mat/mat_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "core/measure/counted_time.hpp"
#include "core/measure/mat/mat_values.hpp"
#include "core/measure/time_name.hpp"

namespace analogon::mat {

namespace {

std::vector<std::string> fieldNames(const matvar_t& structure) {
    const unsigned count = Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&structure));
    char* const* names = Mat_VarGetStructFieldnames(&structure);
    std::vector<std::string> list;
    for (unsigned i = 0; names && i < count; ++i)
        if (names[i]) list.emplace_back(names[i]);
    return list;
}

/// A vector that was found, before it has a group.
struct Signal {
    std::string container;  // of the structure; empty: a variable of its own
    std::string name, path, unit, comment;
    VariablePlace place;
    bool isTime{};  // rises, and is called time
    bool isInteger{};
};

class ChannelFinder {
public:
    Channels find(mat_t& file, const std::vector<OpaqueVariable>& opaque) {
        readNames(file);
        Mat_Rewind(&file);
        while (const VariablePtr variable{Mat_VarReadNext(&file)}) {
            const std::string name = variable->name ? variable->name : "";
            const bool isOpaque =
                variable->class_type == MAT_C_OPAQUE ||
                std::any_of(opaque.begin(), opaque.end(), [&](const OpaqueVariable& o) { return o.name == name; });
            if (name.empty() || isOpaque) continue;
            visit(*variable, {}, name, {name}, 0);
        }
        for (const OpaqueVariable& object : opaque) noteObject(object);
        if (!others_.empty()) found_.notes.push_back(phrase("no channels: {}", listed(others_)));
        makeGroups();
        return std::move(found_);
    }

private:
    /// Lists of texts may name the columns of a matrix, wherever they stand in the file.
    void readNames(mat_t& file) {
        while (const VariablePtr variable{Mat_VarReadNext(&file)}) {
            if (!variable->name) continue;
            if (std::vector<std::string> texts = textList(*variable); texts.size() > 1)
                names_[variable->name] = std::move(texts);
        }
    }

    std::string columnName(const std::string& matrix, std::size_t column, std::size_t columns, bool byRows) const {
        for (const std::string& list : {matrix + "_names", matrix + "_labels", matrix + "names", std::string("names"),
                                        std::string("labels"), std::string("header")})
            if (const auto found = names_.find(list); found != names_.end() && found->second.size() == columns)
                return found->second[column];
        return byRows ? fmt::format("{}({},:)", matrix, column + 1) : fmt::format("{}(:,{})", matrix, column + 1);
    }

    static bool rises(const std::vector<double>& values) {
        return values.size() > 1 && std::is_sorted(values.begin(), values.end()) && values.front() < values.back();
    }

    /// "t1", "t_fast": a time where its steps are even; a temperature may be called so.
    static bool isOneOfTimes(const std::string& name) {
        if (name.size() < 2 || name.front() != 't') return false;
        return name[1] == '_' || std::all_of(name.begin() + 1, name.end(), [](char c) { return c >= '0' && c <= '9'; });
    }
    static bool isEven(const std::vector<double>& values) {
        if (values.size() < 3) return false;
        const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
        for (std::size_t i = 1; i < values.size(); ++i)
            if (!(std::abs(values[i] - values[i - 1] - step) <= 0.01 * step)) return false;
        return step > 0;
    }

    void add(const matvar_t& variable, const std::string& container, std::string name, const std::string& path,
             VariablePlace place, const std::string& unit = {}, const std::string& comment = {}) {
        Signal signal{container, std::move(name), path, unit, comment, std::move(place), false, false};
        signal.isInteger = variable.class_type != MAT_C_DOUBLE && variable.class_type != MAT_C_SINGLE;
        if (namesTime(signal.name) || isOneOfTimes(signal.name)) {
            const std::vector<double> values =
                numbers(variable, signal.place.first, signal.place.stride, signal.place.count);
            signal.isTime = namesTime(signal.name) ? rises(values) : isEven(values);
            if (signal.isTime && signal.unit.empty()) signal.unit = takenTimeUnit(signal.path, values, found_.notes);
        }
        signals_.push_back(std::move(signal));
    }

    /// `name` within `container`; `path` is the whole way, as MATLAB writes it.
    void visit(const matvar_t& variable, const std::string& container, const std::string& path, VariablePlace place,
               int depth) {
        const std::string name = path.substr(container.empty() ? 0 : container.size() + 1);
        const std::size_t count = valuesOf(variable);
        if (variable.class_type == MAT_C_STRUCT && depth < 8) return structure(variable, path, place, depth);
        if (variable.class_type == MAT_C_EMPTY || (count == 0 && isNumeric(variable))) return;
        if (variable.class_type == MAT_C_CELL) {
            if (!names_.contains(path)) others_.push_back(path + " (cell array)");
        } else if (variable.class_type == MAT_C_CHAR || (isNumeric(variable) && count == 1)) {
            return;  // texts and single numbers tell about the measurement
        } else if (!isNumeric(variable)) {
            others_.push_back(path + (variable.class_type == MAT_C_SPARSE ? " (sparse matrix)" : " (object)"));
        } else if (variable.isComplex) {
            others_.push_back(path + " (complex)");
        } else if (variable.rank != 2) {
            others_.push_back(fmt::format("{} ({} dimensions)", path, variable.rank));
        } else {
            matrix(variable, container, name, path, std::move(place));
        }
    }

    void matrix(const matvar_t& variable, const std::string& container, const std::string& name,
                const std::string& path, VariablePlace place) {
        const std::size_t rows = variable.dims[0], columns = variable.dims[1];
        const bool byRows = rows < columns;  // the samples are along the longer side
        const std::size_t signals = byRows ? rows : columns;
        if (signals > 4096) {
            others_.push_back(path + " (matrix)");
            return;
        }
        place.count = byRows ? columns : rows;
        for (std::size_t i = 0; i < signals; ++i) {
            place.first = byRows ? i : i * rows;
            place.stride = byRows ? rows : 1;
            add(variable, container, signals == 1 ? name : columnName(name, i, signals, byRows), path, place);
        }
    }

    void structure(const matvar_t& variable, const std::string& path, const VariablePlace& place, int depth) {
        const std::vector<std::string> fields = fieldNames(variable);
        const auto has = [&](const char* name) {
            return std::find(fields.begin(), fields.end(), name) != fields.end();
        };
        const std::size_t count = valuesOf(variable);
        if (count > 4096) {
            others_.push_back(path + " (array of structures)");
            return;
        }
        const matvar_t* signals =
            has("time") && has("signals") && count == 1 ? fieldOf(variable, "signals", 0) : nullptr;
        for (std::size_t i = 0; i < count; ++i) {
            const auto within = [&](const std::string& field) {
                VariablePlace inner = place;
                inner.steps.push_back({field, i});
                return inner;
            };
            const std::string here = count == 1 ? path : fmt::format("{}({})", path, i + 1);
            if (has("name") && has("data") && describedSignal(variable, path, i, within("data"))) continue;
            for (const std::string& field : fields) {
                const matvar_t* inner = fieldOf(variable, field, i);
                if (!inner) continue;
                if (inner == signals && inner->class_type == MAT_C_STRUCT)
                    scope(*inner, path, within("signals"));
                else
                    visit(*inner, here, here + "." + field, within(field), depth + 1);
            }
        }
    }

    /// {name, data, unit, scale, offset}: one channel.
    bool describedSignal(const matvar_t& variable, const std::string& path, std::size_t index, VariablePlace place) {
        const matvar_t* data = fieldOf(variable, "data", index);
        const auto text = [&](const char* field) {
            const matvar_t* found = fieldOf(variable, field, index);
            const std::vector<std::string> rows = found ? textRows(*found) : std::vector<std::string>();
            return rows.empty() ? std::string() : rows.front();
        };
        const auto number = [&](const char* field, double otherwise) {
            const matvar_t* found = fieldOf(variable, field, index);
            const std::vector<double> value =
                found && isNumeric(*found) && valuesOf(*found) == 1 ? numbers(*found, 0, 1, 1) : std::vector<double>();
            return value.empty() ? otherwise : value.front();
        };
        const std::string name = text("name");
        const bool isVector = data && isNumeric(*data) && !data->isComplex && data->rank == 2 &&
                              std::min(data->dims[0], data->dims[1]) == 1 && valuesOf(*data) > 1;
        if (name.empty() || !isVector) return false;
        place.count = valuesOf(*data);
        place.scale = number("scale", 1);
        place.offset = number("offset", 0);
        if (place.scale != 1 || place.offset != 0)
            found_.notes.push_back(phrase("channel \"{}\": its fields scale and offset are applied, data*{} + {}", name,
                                          place.scale, place.offset));
        add(*data, path, name, fmt::format("{}({}).data", path, index + 1), place, text("unit"), text("comment"));
        return true;
    }

    static std::string labelOf(const matvar_t& signals, std::size_t index) {
        const matvar_t* label = fieldOf(signals, "label", index);
        const std::vector<std::string> rows = label ? textRows(*label) : std::vector<std::string>();
        return rows.empty() || rows.front().empty() ? fmt::format("signals({})", index + 1) : rows.front();
    }

    /// A vector or a matrix at each moment, one behind the other.
    void stacked(const matvar_t& values, const matvar_t& signals, const std::string& path, const VariablePlace& place,
                 std::size_t index) {
        const std::size_t rows = values.dims[0], columns = values.dims[1], each = rows * columns;
        const std::string name = labelOf(signals, index);
        VariablePlace inner = place;
        inner.steps.push_back({"values", index});
        inner.count = values.dims[2];
        inner.stride = each;
        for (std::size_t k = 0; k < each && k < 4096; ++k) {
            inner.first = k;
            const bool isVector = rows == 1 || columns == 1;
            add(values, path,
                each == 1  ? name
                : isVector ? fmt::format("{}({})", name, k + 1)
                           : fmt::format("{}({},{})", name, k % rows + 1, k / rows + 1),
                path, inner);
        }
    }

    /// Simulink's structure with time: the label names the values, whose columns are channels.
    void scope(const matvar_t& signals, const std::string& path, const VariablePlace& place) {
        for (std::size_t i = 0; i < valuesOf(signals) && i < 4096; ++i) {
            const matvar_t* values = fieldOf(signals, "values", i);
            if (values && isNumeric(*values) && !values->isComplex && values->rank == 3) {
                stacked(*values, signals, path, place, i);
                continue;
            }
            if (!values || !isNumeric(*values) || values->isComplex || values->rank != 2) {
                others_.push_back(fmt::format("{}.signals({})", path, i + 1));
                continue;
            }
            const std::string name = labelOf(signals, i);
            VariablePlace inner = place;
            inner.steps.push_back({"values", i});
            const bool byRows = values->dims[0] < values->dims[1];
            const std::size_t columns = byRows ? values->dims[0] : values->dims[1];
            inner.count = byRows ? values->dims[1] : values->dims[0];
            for (std::size_t c = 0; c < columns && c < 4096; ++c) {
                inner.first = byRows ? c : c * values->dims[0];
                inner.stride = byRows ? columns : 1;
                add(*values, path, columns == 1 ? name : fmt::format("{}({})", name, c + 1), path, inner);
            }
        }
    }

    void noteObject(const OpaqueVariable& object) {
        const std::string& v = object.name;
        std::string lines = fmt::format("s = struct({}); save('readable.mat', '-struct', 's')", v);
        if (object.className == "timetable" || object.className == "table")
            lines = fmt::format(
                "s = table2struct({}({}), 'ToScalar', true); s.time = seconds(s.Time - s.Time(1)); s = rmfield(s, "
                "'Time'); save('readable.mat', '-struct', 's')",
                object.className == "timetable" ? "timetable2table" : "", v);
        if (object.className == "timeseries")
            lines = fmt::format("time = {0}.Time; {0} = {0}.Data; save('readable.mat', 'time', '{0}')", v);
        found_.notes.push_back(phrase("variable \"{}\" is an object ({}) that only MATLAB can read; there: {}", v,
                                      object.className, lines));
    }

    /// What stands behind the letters in front: "_fast" of "t_fast", "1" of "U1".
    static std::string endOf(const std::string& name) {
        const std::size_t at = std::min(name.find_first_of("_0123456789"), name.size());
        return name.substr(at);
    }

    /// Of several times in a place with as many values, the one whose name ends as that of the signal, else the first.
    const Signal* nearestOf(const Signal& signal, const std::string& container) const {
        const Signal* first = nullptr;
        for (const Signal& time : signals_) {
            if (!time.isTime || time.container != container || time.place.count != signal.place.count) continue;
            if (endOf(time.name) == endOf(signal.name)) return &time;
            if (!first) first = &time;
        }
        return first;
    }

    /// The time of a signal: of its own structure, of a structure around it, or a variable, with as many values.
    const Signal* timeOf(const Signal& signal) const {
        for (std::string container = signal.container;;) {
            if (const Signal* time = nearestOf(signal, container)) return time;
            if (container.empty()) return nullptr;
            const std::size_t dot = container.rfind('.');
            container = dot == std::string::npos ? "" : container.substr(0, dot);
        }
    }

    void makeGroups() {
        std::map<std::pair<std::string, const Signal*>, std::size_t> known;
        // groups that have a time come first, in the order of the file
        for (const bool wantsTime : {true, false})
            for (const Signal& signal : signals_) {
                if (signal.isTime && timeOf(signal) == &signal) continue;
                const Signal* time = timeOf(signal);
                if ((time != nullptr) != wantsTime) continue;
                if (time) tellOtherTimes(signal, *time);
                // without a time, signals of one length are together
                const std::string key = time ? signal.container : std::to_string(signal.place.count);
                const auto [group, isNew] = known.try_emplace({key, time}, found_.groups.size());
                if (isNew) begin(signal, time);
                put(group->second, signal, signal.name);
            }
        addLonelyTimes(known);
    }

    /// A time with nothing beside it is a measurement of nothing else.
    void addLonelyTimes(const std::map<std::pair<std::string, const Signal*>, std::size_t>& known) {
        for (const Signal& signal : signals_) {
            const bool isUsed = std::any_of(known.begin(), known.end(),
                                            [&](const auto& group) { return group.first.second == &signal; });
            if (signal.isTime && timeOf(signal) == &signal && !isUsed) begin(signal, &signal);
        }
    }

    void begin(const Signal& signal, const Signal* time) {
        RecordedGroup group;
        group.samples = signal.place.count;
        group.name = !time ? "no time" : signal.container.empty() ? "workspace" : signal.container;
        found_.groups.push_back(std::move(group));
        found_.places.emplace_back();
        if (!time) {
            found_.notes.push_back(
                phrase("group \"{}\" has no time: its samples can only be counted", found_.groups.back().name));
            return;
        }
        found_.groups.back().master = MasterKind::Time;
        found_.groups.back().masterChannel = 0;
        put(found_.groups.size() - 1, *time, time->path);
        if (found_.groups.back().channels[0].unit.empty()) found_.groups.back().channels[0].unit = "s";
    }

    /// Which of several times belongs to a signal nothing may tell.
    void tellOtherTimes(const Signal& signal, const Signal& time) {
        if (&signal == &time || endOf(signal.name) == endOf(time.name) || toldTimes_.contains(&time)) return;
        for (const Signal& other : signals_)
            if (&other != &time && other.isTime && other.container == time.container &&
                other.place.count == time.place.count && timeOf(other) == &other) {
                toldTimes_.insert(&time);
                found_.notes.push_back(phrase("\"{}\" is taken for the time of \"{}\"; \"{}\" has as many values",
                                              time.path, signal.path, other.path));
                return;
            }
    }

    void put(std::size_t group, const Signal& signal, const std::string& name) {
        found_.groups[group].channels.push_back(
            {name, signal.unit, signal.comment, {}, ChannelKind::Number, signal.place.count, signal.isInteger});
        found_.places[group].push_back(signal.place);
    }

    Channels found_;
    std::map<std::string, std::vector<std::string>> names_;
    std::vector<Signal> signals_;
    std::set<const Signal*> toldTimes_;
    std::vector<std::string> others_;
};

/// MATLAB writes a text in front of HDF5; other programs do not.
bool isPlainHdf(const std::string& name) {
    std::string head(8, '\0');
    std::ifstream(name, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
    return head == "\x89HDF\r\n\x1A\n";
}

}  // namespace

Outcome<Channels> findChannels(const std::string& name, const std::vector<OpaqueVariable>& opaque) {
    const FilePtr file(Mat_Open(name.c_str(), MAT_ACC_RDONLY));
    if (!file)
        return isPlainHdf(name) ? fileError(phrase("this is an HDF5 file that MATLAB did not write"), name, 0, 0,
                                            phrase("Export the recording as MDF, as a MATLAB file or as CSV."))
                                : fileError(phrase("the file is damaged: it cannot be opened"), name, 0, 0,
                                            phrase("copy it again from where it was recorded"));
    Channels found = ChannelFinder().find(*file, opaque);
    if (!found.groups.empty()) return found;
    return fileError(phrase("the file holds no channel with values"), name, 0, 0,
                     found.notes.empty()
                         ? phrase("in MATLAB save vectors and their time of one length: save('readable.mat', 't', 'y')")
                         : found.notes.front());
}

}  // namespace analogon::mat
