#include "ui/library/search_words.hpp"

#include <QStringList>
#include <algorithm>
#include <vector>

namespace analogon::ui {

namespace {

constexpr qsizetype shortest = 2;  // "dc"; a single letter begins too many words
constexpr qsizetype stem = 4;      // a word of so many letters may have an ending: "motors", "Widerstandes"
constexpr qsizetype ending = 2;

/// Small letters, umlauts as two.
QString folded(const QString& text) {
    QString all = text.toLower();
    for (const auto& [umlaut, letters] :
         {std::pair(u'ä', u"ae"), std::pair(u'ö', u"oe"), std::pair(u'ü', u"ue"), std::pair(u'ß', u"ss")})
        all.replace(umlaut, QStringView(letters).toString());
    return all;
}

/// A space before each word, also before those that a name runs together: "HeatCapacitor".
QString apart(const QString& text) {
    QString words(u' ');
    for (qsizetype i = 0; i < text.size(); ++i) {
        const bool isInside = text[i].isLetterOrNumber();
        if (isInside && i > 0 && text[i].isUpper() && text[i - 1].isLower()) words += u' ';
        words += isInside ? text[i] : QChar(u' ');
    }
    return folded(words);
}

/// What engineers call the same thing, in the spelling of folded().
const std::vector<QStringList>& meanings() {
    static const std::vector<QStringList> all = [] {
        const char* const lines[] = {
            "motor machine drive dc actuator antrieb maschine gleichstrom elektromotor stellmotor",
            "heater heating glow heizung heizer heizelement heizwiderstand glühkerze",
            "resistor resistance ohm widerstand",
            "pump fan blower compressor propeller pumpe lüfter gebläse verdichter",
            "mass inertia flywheel masse trägheit schwungrad schwungmasse",
            "capacity capacitor capacitance storage kapazität wärmekapazität wärmespeicher",
            "spring stiffness elastic feder steifigkeit elastisch",
            "damper damping damped friction viscous dämpfer dämpfung reibung",
            "bearing lager",
            "gear gearbox transmission getriebe übersetzung",
            "conductor conduction conductance insulation leitung leitwert wärmeleitung dämmung",
            "convection cooling cooler konvektion kühlung kühler",
            "radiation strahlung abstrahlung",
            "sensor probe gauge thermometer encoder tachometer fühler geber messfühler",
            "source supply prescribed imposes quelle vorgabe versorgung",
            "constant fixed konstante festwert",
            "ground housing anchor gehäuse einspannung",
            "table lookup map characteristic kennlinie kennfeld tabelle",
            "delay dead latency totzeit laufzeit",
            "lag filter lowpass pt1 tiefpass verzögerung",
            "gain factor amplifier verstärkung verstärker faktor",
            "sum add adder plus summe addierer",
            "product multiply multiplier times produkt multiplikation",
            "temperature thermal temperatur thermisch",
            "torque load brake drehmoment moment last bremse",
            "speed velocity drehzahl geschwindigkeit",
            "angle position winkel drehwinkel stellung",
            "loss leak verlust",
            "step jump sprung",
            "ramp rampe",
            "sine sinus oscillation schwingung",
            "pulse impuls puls rectangle square rechteck pwm",
            "trapezoid trapez",
            "chirp sweep wobbel gleitsinus",
            "excitation generator anregung",
        };
        std::vector<QStringList> groups;
        for (const char* line : lines) groups.push_back(folded(QString::fromUtf8(line)).split(u' '));
        return groups;
    }();
    return all;
}

bool isMeant(const QString& member, const QString& word) {
    return member.startsWith(word) ||
           (member.size() >= stem && word.size() <= member.size() + ending && word.startsWith(member));
}

bool hasMeaningOf(const QString& words, const QString& word) {
    if (word.size() < shortest) return false;
    return std::any_of(meanings().begin(), meanings().end(), [&](const QStringList& group) {
        return std::any_of(group.begin(), group.end(), [&](const QString& m) { return isMeant(m, word); }) &&
               std::any_of(group.begin(), group.end(), [&](const QString& m) { return words.contains(u' ' + m); });
    });
}

}  // namespace

bool isFoundIn(const QString& text, const QString& typed) {
    const QStringList asked = folded(typed).split(u' ', Qt::SkipEmptyParts);
    const QString plain = folded(text), words = apart(text);
    return std::all_of(asked.begin(), asked.end(),
                       [&](const QString& w) { return plain.contains(w) || hasMeaningOf(words, w); });
}

}  // namespace analogon::ui
