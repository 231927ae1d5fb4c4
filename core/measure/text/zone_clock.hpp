#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace analogon {

/// The clock of a place, with its summer time.
class ZoneClock {
public:
    /// "Europe/Berlin", "UTC", "+02:00"; none: no such zone is known.
    static std::optional<ZoneClock> named(const std::string& name);

    /// The moment [ns since 1970-01-01 UTC] of a local clock that shows so many nanoseconds since 1970-01-01. In the
    /// hour that comes twice at the end of summer time: the first that is not before `previous`.
    std::int64_t momentOf(std::int64_t local, std::int64_t previous) const;

private:
    std::int64_t offsetAt(std::int64_t moment) const;  // [ns] east of Greenwich

    std::string zone_;  // empty: a constant offset
    std::int64_t constant_{};
};

}  // namespace analogon
