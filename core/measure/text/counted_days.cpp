#include "core/measure/text/counted_days.hpp"

#include "core/base/file_fault.hpp"
#include "core/measure/cited.hpp"
#include "core/measure/csv_dialect.hpp"
#include "core/measure/text/stamp_traits.hpp"
#include "core/measure/text/time_format.hpp"

namespace analogon {

namespace {

/// "DDD:HH:MM:SS", "hh:mm:ss:ff"; none: the header says neither.
std::optional<bool> daysByHeader(const Column& column) {
    const std::string header = inLowerCase(column.header + column.unit);
    const bool areDays = header.find("d:h") != std::string::npos;
    bool areParts = false;
    for (const char* parts : {"s:f", "s:c", "s:z", "s:m", "s:h", "s:0"})
        areParts = areParts || header.find(parts) != std::string::npos;
    return areDays == areParts ? std::nullopt : std::optional(areDays);
}

class Settler {
public:
    Settler(RawTable& raw, std::size_t index, const ReadOptions& options, Questions& asked)
        : raw_(raw),
          column_(raw.table.columns[index]),
          stamps_(raw.stamps[index]),
          firstText_(raw.firstStamps[index]),
          options_(options),
          asked_(asked) {}

    Diagnostics run() {
        const StampTraits traits = traitsOf(stamps_);
        if (!traits.anyMayCountDays && !traits.anyCountsDays) return {};
        if (isStampFormat(options_.timeFormat)) return {};
        if (!traits.mayCountDays) return traits.anyCountsDays ? Diagnostics{mixed()} : Diagnostics{};
        if (!traits.anyCountsDays && hasDates()) return {};
        const std::optional<bool> areDays = traits.anyCountsDays ? true : daysByHeader(column_);
        if (!areDays) return {open()};
        for (std::size_t row = 0; *areDays && row < stamps_.size(); ++row)
            if (const Stamp stamp = stamps_[row]; stamp.mayCountDays) stamps_.put(row, inDays(stamp));
        return {};
    }

private:
    /// The days are told beside it.
    bool hasDates() const {
        for (std::size_t i = 0; i < raw_.kinds.size(); ++i)
            if (raw_.kinds[i] == CellKind::Stamp && traitsOf(raw_.stamps[i]).anyDate) return true;
        return false;
    }

    Diagnostic mixed() const {
        return fileError(
            phrase("some stamps in column '{}' {}", cited(column_.name), phrase("count days and some do not")),
            raw_.table.file, 0, 0,
            phrase("Tell how they are written in the study: \"read\": {{\"time_format\": …, \"time_zone\": …}}."));
    }

    Diagnostic open() {
        std::size_t row = 0;
        while (!isTold(stamps_[row])) ++row;
        const std::string text = cited(firstText_);
        const int line = raw_.table.lines[row];
        const auto reading = [&](Text label, const char* format) {
            Reading made{std::move(label), options_};
            made.options.timeFormat = format;
            return made;
        };
        asked_.push_back({Question::Kind::Choice,
                          phrase("What is '{}' in column '{}'?", text, cited(column_.name)),
                          line,
                          {reading(phrase("days, hours, minutes and seconds"), "%j:%H:%M:%S"),
                           reading(phrase("hours, minutes, seconds and hundredths"), "%H:%M:%S:%f")}});
        return fileError(phrase("'{}' in column '{}' may be days, hours, minutes and seconds, or hours, minutes, "
                                "seconds and hundredths",
                                text, cited(column_.name)),
                         raw_.table.file, line, 0,
                         phrase("Say it in the study: \"read\": {{\"time_format\": \"%j:%H:%M:%S\"}} or "
                                "\"%H:%M:%S:%f\"."));
    }

    RawTable& raw_;
    const Column& column_;
    StampSeries& stamps_;
    const std::string& firstText_;
    const ReadOptions& options_;
    Questions& asked_;
};

}  // namespace

Diagnostics settleDays(RawTable& raw, const ReadOptions& options, Questions& asked) {
    for (std::size_t i = 0; i < raw.kinds.size(); ++i) {
        if (raw.kinds[i] != CellKind::Stamp) continue;
        if (Diagnostics faults = Settler(raw, i, options, asked).run(); !faults.empty()) return faults;
    }
    return {};
}

}  // namespace analogon
