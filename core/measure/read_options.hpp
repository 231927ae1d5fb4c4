#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace analogon {

/// The marks with which a text may be written.
inline constexpr std::string_view knownSeparators = ",;|\t ", knownDecimals = ".,", knownThousands = ".,' ";

/// Which channels of a text with several columns of time have which. Found: as its layout tells; One: the first column
/// of time is that of all; Left, Right: each channel has the one on that side of it.
enum class TimeColumns { Found, One, Left, Right };

/// How a file is written, as it was told ("read" of an experiment), nearly all of it of texts; everything not told is
/// found out from the file. The names are those of the keys in the study.
struct ReadOptions {
    std::optional<char> separator;      // , ; | tab, or a blank
    std::optional<char> decimal;        // . or ,
    std::optional<char> thousands;      // . , ' or a blank
    std::optional<std::size_t> skip;    // lines before the header that are not looked at
    std::optional<std::size_t> header;  // rows of the header behind them, units included; 0: none
    std::optional<bool> hasUnitsRow;    // "units"
    std::string timeFormat;  // "%d.%m.%Y %H:%M:%S" or "dd.MM.yyyy HH:mm:ss"; or how the rows follow: "0.001 s",
                             // "1 kHz"; or the unit of a time that has none: "d"
    std::string timeZone;    // of stamps that have none: "Europe/Berlin", "+02:00", "UTC"
    TimeColumns times{TimeColumns::Found};  // "times"
    std::string encoding;  // "utf-8", "utf-16le", "utf-16be", "utf-32le", "utf-32be", "windows-1252", "iso-8859-1"
    std::map<std::string, std::string> unitNames{};  // what units of the file that nobody knows mean; of any file

    friend bool operator==(const ReadOptions&, const ReadOptions&) = default;
};

}  // namespace analogon
