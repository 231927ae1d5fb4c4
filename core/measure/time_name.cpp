#include "core/measure/time_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "core/base/unit.hpp"
#include "core/measure/column_header.hpp"

namespace analogon {

bool namesTime(std::string_view name) {
    static constexpr std::array<std::string_view, 10> names{"t",    "time",  "zeit",    "timestamp",  "zeitstempel",
                                                            "tijd", "temps", "elapsed", "datum/zeit", "date/time"};
    if (name == "T") return false;  // a temperature, or a torque
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (areConvertible(unitAtEnd(lower), "s")) lower.resize(lower.find_last_of("_ "));  // t_ms
    return std::find(names.begin(), names.end(), lower) != names.end() || lower.starts_with("time") ||
           lower.starts_with("zeit");
}

}  // namespace analogon
