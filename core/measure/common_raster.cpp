#include "core/measure/common_raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/base/file_fault.hpp"
#include "core/base/unit.hpp"
#include "core/measure/channel_place.hpp"
#include "core/measure/join.hpp"
#include "core/measure/recording.hpp"
#include "core/measure/time_faults.hpp"

namespace analogon {

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

Diagnostic warningOf(const Table& file, Text message, Text hint) {
    return asWarning(fileError(std::move(message), file.file, 0, 0, std::move(hint)));
}

/// The stamps of a group in seconds, and from where in it a stamp comes.
struct Group {
    const Table* table{};
    std::vector<double> stamps;
};

/// A channel on its own raster.
struct Own {
    const Column* place{};  // in the file
    const Group* group{};
    Column column;  // with its values
    bool isHeld{};

    Trace trace() const { return {group->stamps, column.values}; }
};

class RasterJoin {
public:
    RasterJoin(const Table& file, const RasterRequest& request) : file_(file), request_(request) {}

    bool isEmpty() const {
        const auto isKnown = [this](const ChannelName& name) { return onlyPlace(name).has_value(); };
        return std::none_of(request_.outputs.begin(), request_.outputs.end(), isKnown) &&
               std::none_of(request_.inputs.begin(), request_.inputs.end(),
                            [&](const InputUse& use) { return isKnown(use.channel); });
    }

    Outcome<std::shared_ptr<const Table>> join() {
        if (!readChannels()) return said_;
        findSlack();
        if (!makeStamps() || !cutToInputs()) return said_;
        auto table = std::make_shared<Table>();
        fill(*table);
        return {std::shared_ptr<const Table>(std::move(table)), std::move(said_)};
    }

private:
    bool fault(Diagnostic diagnostic) {
        said_.push_back(std::move(diagnostic));
        return false;
    }

    template <class T>
    bool keep(const Outcome<T>& outcome) {
        said_.insert(said_.end(), outcome.diagnostics().begin(), outcome.diagnostics().end());
        return outcome.hasValue();
    }

    std::optional<ChannelPlace> onlyPlace(const ChannelName& name) const {
        const std::vector<ChannelPlace> places = placesOf(file_, name);
        return places.size() == 1 ? std::optional(places.front()) : std::nullopt;
    }

    /// The column of a group's stamps: the one that the study calls the time, else the one that the file does.
    const Column* timeOf(const Table& group) const {
        if (const Column* told = group.find(request_.time.column, request_.time.group)) return told;
        return group.time ? &group.columns[*group.time] : nullptr;
    }

    /// Null: a fault was told. Where outputs are measured stamps must rise; those of inputs may repeat where they jump.
    const Group* groupOf(const Table& table, bool mustRise) {
        auto [found, isNew] = groups_.try_emplace(&table);
        if (isNew && !readStamps(table, found->second, mustRise)) return nullptr;
        return found->second.table ? &found->second : nullptr;
    }

    bool readStamps(const Table& table, Group& group, bool mustRise) {
        const Column* const time = timeOf(table);
        if (!time)
            return fault(fileError(
                phrase("group \"{}\" has no time", groupLabel(table.columns.front())), file_.file, 0, 0,
                phrase("Name the column of its stamps: \"time\": {{\"column\": …, \"group\": …}}; or take channels of "
                       "another group.")));
        const Table stamps = alone(table, *time);
        if (mustRise) {
            const Outcome<std::vector<double>> read = readTime(stamps, time->name);
            if (!keep(read)) return false;
            group.stamps = *read;
        } else {
            ChannelMapping mapping;
            mapping.column = time->name;
            const Outcome<std::vector<double>> read = readChannel(stamps, mapping, "s");
            if (!keep(read)) return false;
            if (!std::is_sorted(read->begin(), read->end()))
                return fault(*timeFault(stamps, stamps.columns.front(), *read));
            group.stamps = *read;
        }
        group.table = &table;
        return true;
    }

    static Table alone(const Table& table, const Column& column) {
        Table one;
        one.file = table.file;
        one.lines = table.lines;
        one.columns.push_back(column);
        return one;
    }

    /// With its values, which may still lie in the file.
    Outcome<Column> read(const ChannelPlace& place) const {
        Column column = *place.column;
        if (!column.values.empty() || !place.group->source) return column;
        Outcome<ChannelValues> values = readValues(*place.group->source, column.groupNumber - 1, place.column->channel);
        if (!values) return values.diagnostics();
        column.values = std::move(values->numbers);
        column.blanks = blanksOf(column.values);
        return column;
    }

    bool readChannels() {
        bool isRead = true;
        for (const ChannelName& name : request_.outputs)
            if (const auto place = onlyPlace(name); place && !find(outputs_, place->column))
                isRead = take(*place, outputs_, true) && isRead;
        for (const InputUse& use : request_.inputs)
            if (const auto place = onlyPlace(use.channel); place && !find(inputs_, place->column)) {
                isRead = take(*place, inputs_, false) && isRead;
                if (!isRead) continue;
                inputs_.back().isHeld = isHeld(*place->column, use.interpolation);
                isRead = areGapsMeant(inputs_.back(), use.interpolation);
            }
        return isRead;
    }

    static const Own* find(const std::vector<Own>& channels, const Column* place) {
        const auto found =
            std::find_if(channels.begin(), channels.end(), [&](const Own& o) { return o.place == place; });
        return found == channels.end() ? nullptr : &*found;
    }

    bool take(const ChannelPlace& place, std::vector<Own>& channels, bool mustRise) {
        const Group* const group = groupOf(*place.group, mustRise);
        if (!group) return false;
        Outcome<Column> column = read(place);
        if (!keep(column)) return false;
        channels.push_back({place.column, group, std::move(*column)});
        return true;
    }

    /// Gaps of an input are bridged where the study says how.
    bool areGapsMeant(const Own& input, Interpolation asked) {
        const bool hasInfinite =
            std::any_of(input.column.values.begin(), input.column.values.end(), [](double v) { return std::isinf(v); });
        const bool hasNumber = std::any_of(input.column.values.begin(), input.column.values.end(),
                                           [](double v) { return std::isfinite(v); });
        if (input.column.blanks.empty() || (asked != Interpolation::Automatic && !hasInfinite && hasNumber))
            return true;
        ChannelMapping mapping;
        mapping.column = input.column.name;
        return keep(readChannel(alone(*input.group->table, input.column), mapping, {}));
    }

    /// Stamps of two rasters that differ by less are one moment that was written with rounding.
    void findSlack() {
        constexpr double part = 1e-4, roundings = 8;
        double step = std::numeric_limits<double>::infinity(), largest = 0;
        for (const auto& [table, group] : groups_)
            for (std::size_t i = 0; i < group.stamps.size(); ++i) {
                largest = std::max(largest, std::abs(group.stamps[i]));
                if (i > 0 && group.stamps[i] > group.stamps[i - 1])
                    step = std::min(step, group.stamps[i] - group.stamps[i - 1]);
            }
        slack_ = roundings * std::numeric_limits<double>::epsilon() * largest;
        if (std::isfinite(step)) slack_ = std::max(slack_, part * step);
    }

    std::vector<double> merged(std::vector<double> stamps) const {
        std::vector<double> kept;
        for (const double stamp : stamps)
            if (kept.empty() || stamp - kept.back() > slack_) kept.push_back(stamp);
        return kept;
    }

    std::vector<double> measuredStamps() const {
        std::vector<Trace> traces;
        for (const auto* channels : {&outputs_, &inputs_}) {
            for (const Own& own : *channels) traces.push_back(own.trace());
            if (!traces.empty()) break;  // without outputs, the inputs
        }
        return merged(unitedStamps(traces));
    }

    bool makeStamps() {
        stamps_ = measuredStamps();
        if (stamps_.empty())
            return fault(fileError(phrase("none of the outputs was measured at any time"), file_.file));
        if (request_.raster.kind == Raster::Kind::Steps && !stepStamps()) return false;
        if (request_.raster.kind == Raster::Kind::Channel) {
            const std::optional<ChannelPlace> place = onlyPlace(request_.raster.channel);
            if (!place)
                return fault(fileError(phrase("there is no channel '{}'", request_.raster.channel.column), file_.file));
            const Group* const group = groupOf(*place->group, true);
            const Outcome<Column> column = read(*place);
            if (!group || !keep(column)) return false;
            const std::vector<Trace> traces{{group->stamps, column->values}};
            stamps_ = merged(unitedStamps(traces));
        }
        tellMissedOutputs();
        addJumps();
        return true;
    }

    bool stepStamps() {
        constexpr double most = 2e8;
        const double first = stamps_.front(), last = stamps_.back(), step = request_.raster.step;
        const double count = std::floor((last - first + slack_) / step) + 1;
        if (count > most)
            return fault(fileError(
                phrase("a raster of {:g} s has {:.3g} stamps in {:.6g} s of this recording", step, count, last - first),
                file_.file, 0, 0, phrase("Give a longer step.")));
        stamps_.clear();
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
            stamps_.push_back(first + static_cast<double>(i) * step);
        return true;
    }

    /// Values of outputs that are on no stamp of a raster that was told.
    void tellMissedOutputs() {
        if (request_.raster.kind == Raster::Kind::Outputs) return;
        for (const Own& own : outputs_) {
            const std::vector<double> values = measuredAt(own);
            const auto isNumber = [](double v) { return std::isfinite(v); };
            const auto there = std::count_if(values.begin(), values.end(), isNumber),
                       all = std::count_if(own.column.values.begin(), own.column.values.end(), isNumber);
            if (there < all)
                said_.push_back(warningOf(
                    file_,
                    phrase("{} of {} values of '{}' lie on no stamp of the raster and are not compared", all - there,
                           all, own.column.name),
                    phrase("An output is never resampled: take the raster \"outputs\", or that of its own channel.")));
        }
    }

    /// A held input steps at its samples, so that each step is a stamp of the raster.
    void addJumps() {
        std::vector<double> all = stamps_;
        for (const Own& input : inputs_) {
            if (!input.isHeld) continue;
            double last = gap;
            for (std::size_t i = 0; i < input.column.values.size(); ++i) {
                const double value = input.column.values[i], stamp = input.group->stamps[i];
                if (std::isnan(value)) continue;
                if (!std::isnan(last) && value != last && stamp > stamps_.front() && stamp < stamps_.back() &&
                    !isStamp(stamp))
                    all.push_back(stamp);
                last = value;
            }
        }
        if (all.size() == stamps_.size()) return;
        std::sort(all.begin(), all.end());
        stamps_ = merged(std::move(all));
    }

    bool isStamp(double moment) const {
        const auto next = std::lower_bound(stamps_.begin(), stamps_.end(), moment - slack_);
        return next != stamps_.end() && *next <= moment + slack_;
    }

    /// Nothing is extrapolated.
    bool cutToInputs() {
        double from = stamps_.front(), to = stamps_.back();
        const Column *first = nullptr, *last = nullptr;
        for (const Own& own : inputs_) {
            const auto [begin, end] = extentOf(own);
            if (begin > from + slack_) {
                from = begin;
                first = &own.column;
            }
            if (!own.isHeld && end < to - slack_) {
                to = end;
                last = &own.column;
            }
        }
        if (!first && !last) return true;
        const std::size_t before = stamps_.size();
        const double begin = stamps_.front(), end = stamps_.back();
        std::erase_if(stamps_, [&](double t) { return t < from - slack_ || t > to + slack_; });
        const Column& named = first ? *first : *last;
        if (stamps_.size() < 2)
            return fault(fileError(phrase("the outputs are recorded from {:.6g} s to {:.6g} s, the input '{}' is not "
                                          "known in that time",
                                          begin, end, named.name),
                                   file_.file, 0, 0, phrase("Map a channel that was recorded at the same time.")));
        tellExtent(from, to, before, named.name);
        return true;
    }

    /// Where channels are only looked at together there are neither inputs nor outputs.
    void tellExtent(double from, double to, std::size_t before, const std::string& shorter) {
        const std::size_t outside = before - stamps_.size();
        if (request_.outputs.empty())
            said_.push_back(warningOf(
                file_,
                phrase("from {:.6g} s to {:.6g} s every channel was recorded; {} of {} stamps lie outside and are not "
                       "shown",
                       from, to, outside, before),
                phrase("The channel '{}' is recorded for a shorter time.", shorter)));
        else
            said_.push_back(warningOf(
                file_,
                phrase("from {:.6g} s to {:.6g} s all inputs are known; {} of {} stamps of the outputs lie outside and "
                       "are left out",
                       from, to, outside, before),
                phrase("The input '{}' is recorded for a shorter time.", shorter)));
    }

    static std::pair<double, double> extentOf(const Own& own) {
        double first = std::numeric_limits<double>::infinity(), last = -first;
        for (std::size_t i = 0; i < own.column.values.size(); ++i) {
            if (std::isnan(own.column.values[i])) continue;
            first = std::min(first, own.group->stamps[i]);
            last = std::max(last, own.group->stamps[i]);
        }
        return {first, last};
    }

    /// The row of a group at each stamp; past the end: it has none there.
    std::vector<std::size_t> rowsAt(const Group& group) const {
        std::vector<std::size_t> rows(stamps_.size(), group.stamps.size());
        std::size_t behind = 0;  // the first row after the stamp
        for (std::size_t i = 0; i < stamps_.size(); ++i) {
            while (behind < group.stamps.size() && group.stamps[behind] <= stamps_[i] + slack_) ++behind;
            if (behind > 0 && group.stamps[behind - 1] >= stamps_[i] - slack_) rows[i] = behind - 1;
        }
        return rows;
    }

    std::vector<double> measuredAt(const Own& output) const {
        std::vector<double> values(stamps_.size(), gap);
        const std::vector<std::size_t> rows = rowsAt(*output.group);
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i] < output.column.values.size()) values[i] = output.column.values[rows[i]];
        return values;
    }

    /// Rounding at a stamp must not take the sample before for the one that is there.
    std::vector<double> courseOf(const Own& own) const {
        std::vector<double> moments = stamps_;
        const double last = extentOf(own).second;
        for (double& moment : moments)
            if (own.isHeld)
                moment += slack_;
            else if (moment > last && moment <= last + slack_)
                moment = last;
        std::vector<double> values = courseAt(own.trace(), moments, own.isHeld ? Course::Held : Course::Linear);
        const std::vector<std::size_t> rows = rowsAt(*own.group);
        for (std::size_t i = 0; i < rows.size(); ++i)  // what was measured there, to the last bit
            if (rows[i] < own.column.values.size() && !std::isnan(own.column.values[rows[i]]))
                values[i] = own.column.values[rows[i]];
        return values;
    }

    Column shell(const Column& from) const {
        Column column{from.name, from.unit, {}, {}, from.header, from.line, from.position};
        column.isHeld = from.isHeld;
        column.group = from.group;
        column.groupNumber = from.groupNumber;
        column.isOnOtherRaster = true;
        return column;
    }

    void fill(Table& table) {
        table.file = file_.file;
        Column time{request_.time.column, "s", stamps_, {}};
        time.isOnOtherRaster = true;
        time.group = request_.time.group.name;
        if (request_.time.group.number > 0) time.groupNumber = request_.time.group.number;
        table.columns.push_back(std::move(time));
        table.time = 0;
        for (const Table* const group : tablesOf(file_))
            for (const Column& column : group->columns)
                if (const Own* output = find(outputs_, &column))
                    addOutput(*output, table);
                else if (const Own* input = find(inputs_, &column))
                    addInput(*input, table);
                else if (&column != timeOf(*group) && !column.values.empty())
                    addSpare({group, &column}, table);
        setLines(table);
    }

    void addOutput(const Own& own, Table& table) {
        Column column = shell(own.column);
        column.values.assign(stamps_.size(), gap);
        const std::vector<std::size_t> rows = rowsAt(*own.group);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (rows[i] >= own.column.values.size()) continue;
            column.values[i] = own.column.values[rows[i]];
            if (!std::isfinite(column.values[i])) column.blanks.push_back({static_cast<std::uint32_t>(i), 0});
        }
        table.columns.push_back(std::move(column));
    }

    void addInput(const Own& own, Table& table) {
        Column column = shell(own.column);
        column.values = courseOf(own);
        if (!own.isHeld) tellLostMotion(own, column.values);
        table.columns.push_back(std::move(column));
    }

    /// Where an input is faster than the raster, straight lines between its stamps are not what it did.
    void tellLostMotion(const Own& own, const std::vector<double>& values) {
        constexpr double most = 0.02;  // of its range
        const Trace drawn{stamps_, values};
        const std::vector<double> lines = courseAt(drawn, own.group->stamps, Course::Linear);
        double least = INFINITY, largest = -INFINITY, departure = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double value = own.column.values[i];
            if (std::isnan(lines[i]) || std::isnan(value)) continue;
            least = std::min(least, value);
            largest = std::max(largest, value);
            departure = std::max(departure, std::abs(lines[i] - value));
        }
        if (!(largest > least) || departure <= most * (largest - least)) return;
        said_.push_back(warningOf(
            file_,
            phrase("between the stamps of the raster the input '{}' departs from straight lines by up to {:.2g} % of "
                   "its range",
                   own.column.name, 100 * departure / (largest - least)),
            phrase("Where that matters take its stamps: \"raster\": \"{}\".", own.column.name)));
    }

    void addSpare(const ChannelPlace& place, Table& table) {
        const Column* const time = timeOf(*place.group);
        if (!time || time->values.size() != place.column->values.size()) return;
        const auto known = groups_.find(place.group);
        if (known == groups_.end()) {
            const std::size_t told = said_.size();
            if (!groupOf(*place.group, false)) {  // nobody asked for it: it is left aside
                said_.erase(said_.begin() + static_cast<std::ptrdiff_t>(told), said_.end());
                return;
            }
        }
        const Group& group = groups_.at(place.group);
        if (!group.table) return;
        const Own own{place.column, &group, *place.column, place.column->isHeld};
        Column column = shell(*place.column);
        column.values = courseOf(own);
        column.blanks = blanksOf(column.values);
        table.columns.push_back(std::move(column));
    }

    /// Where in the file a stamp comes from: the row of the first group that has an output.
    void setLines(Table& table) const {
        const Group& group = outputs_.empty() ? *inputs_.front().group : *outputs_.front().group;
        std::size_t row = 0;
        for (const double stamp : stamps_) {
            while (row + 1 < group.stamps.size() && group.stamps[row + 1] <= stamp + slack_) ++row;
            table.lines.push_back(row < group.table->lines.size() ? group.table->lines[row] : 0);
        }
    }

    const Table& file_;
    const RasterRequest& request_;
    Diagnostics said_;
    std::map<const Table*, Group> groups_;
    std::vector<Own> outputs_, inputs_;
    std::vector<double> stamps_;
    double slack_{};
};

}  // namespace

bool isHeld(const Column& column, Interpolation asked) {
    return asked == Interpolation::Hold || (asked == Interpolation::Automatic && column.isHeld);
}

bool isOnOneRaster(const Table& file) { return file.others.empty() && !file.hasUnread(); }

Outcome<std::shared_ptr<const Table>> onCommonRaster(const std::shared_ptr<const Table>& file,
                                                     const RasterRequest& request) {
    if (isOnOneRaster(*file) && request.raster.kind == Raster::Kind::Outputs) return file;
    if (placesOf(*file, request.time).empty()) return file;  // whoever asks tells it with its place
    RasterJoin join(*file, request);
    return join.isEmpty() ? file : join.join();
}

}  // namespace analogon
