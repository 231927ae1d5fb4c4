#include "ui/words/common_units.hpp"

#include <QCoreApplication>

#include "core/base/unit.hpp"

namespace analogon::ui {

namespace {

constexpr const char* commonUnits[] = {
    "1",     "%",     "K",        "degC",      "m",        "cm",        "mm",      "um",        "m2",         "cm2",
    "mm2",   "m3",    "l",        "ml",        "kg",       "g",         "s",       "ms",        "min",        "h",
    "rad",   "deg",   "rad/s",    "rpm",       "Hz",       "N",         "kN",      "N.m",       "mN.m",       "J",
    "kJ",    "W",     "mW",       "kW",        "V",        "mV",        "A",       "mA",        "Ohm",        "mOhm",
    "kOhm",  "H",     "mH",       "uH",        "F",        "uF",        "Pa",      "hPa",       "kPa",        "bar",
    "J/K",   "kJ/K",  "W/K",      "mW/K",      "K/W",      "kg.m2",     "g.cm2",   "N.m.s/rad", "mN.m.s/rad", "m/s",
    "km/h",  "1/K",   "W/(m2.K)", "W/(cm2.K)", "J/(kg.K)", "kJ/(kg.K)", "V.s/rad", "mV.s/rad",  "kg/s",       "g/s",
    "l/min", "N.m/A", "mN.m/A",   "N.m/rad",   "1/s"};

}  // namespace

QStringList unitsLike(const std::string& unit) {
    QStringList units;
    if (!unit.empty()) units << QString::fromStdString(unit);
    for (const char* other : commonUnits)
        if (other != unit && (unit.empty() || areConvertible(unit, other))) units << QString::fromLatin1(other);
    return units;
}

QString whyNoUnit(const std::string& text) {
    if (text.empty() || isKnownUnit(text)) return {};
    const std::string meant = unitAlike(text);
    const QString why =
        QCoreApplication::translate("CommonUnits", "%1 is no unit that is known.").arg(QString::fromStdString(text));
    if (meant.empty()) return why;
    return why + " " +
           QCoreApplication::translate("CommonUnits", "Did you mean %1?").arg(QString::fromStdString(meant));
}

}  // namespace analogon::ui
