#include "core/measure/text/zone_clock.hpp"

#include <QByteArray>
#include <QDateTime>
#include <QTimeZone>

#include "core/measure/text/stamp.hpp"

namespace analogon {

namespace {
constexpr std::int64_t second = 1'000'000'000;
}

std::optional<ZoneClock> ZoneClock::named(const std::string& name) {
    ZoneClock clock;
    if (const std::optional<int> minutes = readZone(name)) {
        clock.constant_ = *minutes * 60 * second;
        return clock;
    }
    if (!QTimeZone::isTimeZoneIdAvailable(QByteArray::fromStdString(name))) return std::nullopt;
    clock.zone_ = name;
    return clock;
}

std::int64_t ZoneClock::offsetAt(std::int64_t moment) const {
    if (zone_.empty()) return constant_;
    thread_local std::string name;
    thread_local QTimeZone zone;
    if (name != zone_) {
        zone = QTimeZone(QByteArray::fromStdString(zone_));
        name = zone_;
    }
    const std::int64_t seconds = moment / second - (moment % second < 0 ? 1 : 0);
    return zone.offsetFromUtc(QDateTime::fromSecsSinceEpoch(seconds, Qt::UTC)) * second;
}

std::int64_t ZoneClock::momentOf(std::int64_t local, std::int64_t previous) const {
    if (zone_.empty()) return local - constant_;
    constexpr std::int64_t day = 86400 * second;
    const std::int64_t before = offsetAt(local - day), after = offsetAt(local + day);
    const std::int64_t summer = local - std::max(before, after), winter = local - std::min(before, after);
    const bool isSummer = offsetAt(summer) == std::max(before, after);
    const bool isWinter = offsetAt(winter) == std::min(before, after);
    if (isSummer && isWinter) return summer >= previous ? summer : winter;
    if (isSummer) return summer;
    return isWinter ? winter : local - before;
}

}  // namespace analogon
