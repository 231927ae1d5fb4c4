#include "core/base/unit.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <utility>

// A unit text goes three steps: its characters are made plain (² -> 2, · -> '.', µ -> u), its words are replaced
// by those UDUNITS-2 knows (Nm -> N.m, rpm -> revolution/min), and UDUNITS parses the result.
//
// UDUNITS takes the radian as 1, and so 1 Hz as 1 rad/s, which is never meant: a shaft at 1 Hz turns 2 pi rad/s.
// Counts of turns per time (Hz, 1/min, rpm) are therefore read as an angle per time when the other unit is one
// (rad/s, deg/s), and as a frequency when the other unit is one. A plain 1/s stays what SI says, 1 rad/s.
namespace analogon {

namespace {

struct UnitDeleter {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct SystemDeleter {
    void operator()(ut_system* system) const { ut_free_system(system); }
};
struct ConverterDeleter {
    void operator()(cv_converter* converter) const { cv_free(converter); }
};
using UnitPtr = std::unique_ptr<ut_unit, UnitDeleter>;
using ConverterPtr = std::unique_ptr<cv_converter, ConverterDeleter>;

enum class Reading { AsWritten, Rotation, Frequency };

struct Replacement {
    std::string_view from, to;
};

// Characters outside ASCII that occur in unit texts.
constexpr std::array plainCharacters{
    Replacement{"²", "2"},   Replacement{"³", "3"},   Replacement{"⁴", "4"},    Replacement{"¹", "1"},
    Replacement{"⁻", "-"},   Replacement{"−", "-"},   Replacement{"·", "."},    Replacement{"⋅", "."},
    Replacement{"∙", "."},   Replacement{"×", "."},   Replacement{"µ", "u"},    Replacement{"μ", "u"},
    Replacement{"Ω", "ohm"}, Replacement{"Ω", "ohm"}, Replacement{"℃", "degC"}, Replacement{"℉", "degF"},
};

// Words of the field that UDUNITS does not know, or reads as something else (mph: milliphot).
constexpr std::array wordAliases{
    Replacement{"deg", "arc_degree"},
    Replacement{"°", "arc_degree"},
    Replacement{"°CA", "arc_degree"},
    Replacement{"degCA", "arc_degree"},
    Replacement{"rev", "revolution"},
    Replacement{"revs", "revolution"},
    Replacement{"U", "revolution"},
    Replacement{"rpm", "revolution/min"},
    Replacement{"RPM", "revolution/min"},
    Replacement{"Upm", "revolution/min"},
    Replacement{"krpm", "1000.revolution/min"},
    Replacement{"rps", "revolution/s"},
    Replacement{"r", "revolution"},
    Replacement{"kmh", "km/h"},
    Replacement{"kph", "km/h"},
    Replacement{"mph", "mile/hour"},
    Replacement{"lpm", "l/min"},
    Replacement{"Nm", "N.m"},
    Replacement{"mNm", "mN.m"},
    Replacement{"uNm", "uN.m"},
    Replacement{"kNm", "kN.m"},
    Replacement{"Ncm", "N.cm"},
    Replacement{"Nmm", "N.mm"},
    Replacement{"Nms", "N.m.s"},
    Replacement{"mNms", "mN.m.s"},
    Replacement{"Ns", "N.s"},
    Replacement{"Ws", "W.s"},
    Replacement{"kWs", "kW.s"},
    Replacement{"Wh", "W.h"},
    Replacement{"mWh", "mW.h"},
    Replacement{"kWh", "kW.h"},
    Replacement{"As", "A.s"},
    Replacement{"mAs", "mA.s"},
    Replacement{"Ah", "A.h"},
    Replacement{"mAh", "mA.h"},
    Replacement{"Vs", "V.s"},
    Replacement{"mVs", "mV.s"},
    Replacement{"VA", "V.A"},
    Replacement{"ccm", "cm3"},
    Replacement{"cc", "cm3"},
    Replacement{"ccps", "cm3/s"},
    Replacement{"bara", "bar"},
    Replacement{"mbara", "mbar"},
    Replacement{"psia", "psi"},
    Replacement{"msec", "ms"},
    Replacement{"usec", "us"},
    Replacement{"kgm", "kg.m"},
    Replacement{"pct", "percent"},
    Replacement{"‰", "0.001"},
    Replacement{"VDC", "V"},
    Replacement{"Vdc", "V"},
    Replacement{"mVDC", "mV"},
    Replacement{"mVdc", "mV"},
    Replacement{"Vac", "V"},
    Replacement{"VAC", "V"},
    Replacement{"Vrms", "V"},
    Replacement{"Adc", "A"},
    Replacement{"mAdc", "mA"},
    Replacement{"Aac", "A"},
    Replacement{"Arms", "A"},
};

// Words with their exponent that must not be read as (word)^exponent.
constexpr std::array poweredAliases{
    Replacement{"kgm2", "kg.m2"},   Replacement{"gcm2", "g.cm2"},  Replacement{"kgcm2", "kg.cm2"},
    Replacement{"kgmm2", "kg.mm2"}, Replacement{"Nms2", "N.m.s2"},
};

// Whole texts, in small letters: what stands apart in them is no product.
constexpr std::array wholeAliases{
    Replacement{"deg c", "degC"},       Replacement{"deg. c", "degC"},   Replacement{"deg.c", "degC"},
    Replacement{"degrees c", "degC"},   Replacement{"degree c", "degC"}, Replacement{"grad c", "degC"},
    Replacement{"deg celsius", "degC"}, Replacement{"° c", "degC"},      Replacement{"degrees celsius", "degC"},
    Replacement{"deg f", "degF"},       Replacement{"deg. f", "degF"},   Replacement{"deg.f", "degF"},
    Replacement{"degrees f", "degF"},   Replacement{"degree f", "degF"}, Replacement{"° f", "degF"},
};

// Words behind a unit that say how a quantity was taken and leave its unit as it is.
constexpr std::array qualifiers{"abs", "abs.", "absolute", "rms", "eff", "dc", "ac"};
// And those that do so behind a time alone: behind a pressure they move its zero.
constexpr std::array timeQualifiers{"rel", "rel.", "relative", "elapsed"};

template <class Table>
std::optional<std::string_view> lookUp(const Table& table, std::string_view text) {
    for (const Replacement& entry : table) {
        if (entry.from == text) return entry.to;
    }
    return std::nullopt;
}

bool isContinuation(unsigned char byte) { return (byte & 0xc0) == 0x80; }

/// Bytes that are no UTF-8 are taken as Latin-1, which measurement files still use (° and µ are one byte there).
std::string asUtf8(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        std::size_t length = byte < 0x80 ? 1 : byte >= 0xf0 ? 4 : byte >= 0xe0 ? 3 : byte >= 0xc2 ? 2 : 0;
        for (std::size_t k = 1; k < length; ++k) {
            if (i + k >= text.size() || !isContinuation(static_cast<unsigned char>(text[i + k]))) length = 0;
        }
        if (length == 0) {
            result += static_cast<char>(0xc0 | (byte >> 6));
            result += static_cast<char>(0x80 | (byte & 0x3f));
            length = 1;
        } else {
            result += text.substr(i, length);
        }
        i += length;
    }
    return result;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

std::string plain(std::string_view text) {
    std::string result = asUtf8(trimmed(text));
    for (const Replacement& entry : plainCharacters) {
        for (std::size_t at = result.find(entry.from); at != std::string::npos; at = result.find(entry.from, at)) {
            result.replace(at, entry.from.size(), entry.to);
            at += entry.to.size();
        }
    }
    return result;
}

std::string inSmallLetters(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

bool isDigit(char c) { return c >= '0' && c <= '9'; }
/// Letters of a unit word: ASCII letters, %, and every byte of a character outside ASCII (°, ‰).
bool isWord(char c) { return std::isalpha(static_cast<unsigned char>(c)) || c == '_' || c == '%' || (c & 0x80); }

/// Rewrites a plain unit text for UDUNITS; empty when it holds characters no unit has.
class UnitTranslator {
public:
    UnitTranslator(std::string_view text, Reading reading) : text_(text), reading_(reading) {}

    std::optional<std::string> translate() {
        if (text_ == "-") return "1";
        if (text_.find("(re") != std::string_view::npos) return std::nullopt;  // logarithmic units are no line
        if (reading_ == Reading::Rotation &&
            (text_ == "1/min" || text_ == "/min" || text_ == "min-1" || text_ == "min^-1" || text_ == "1/(min)")) {
            return "revolution/min";
        }
        if (text_.starts_with('/')) result_ += '1';
        while (at_ < text_.size()) {
            if (isWord(text_[at_])) {
                factorGroup();
            } else if (!separator()) {
                return std::nullopt;
            }
        }
        return result_;
    }

private:
    /// Words that follow each other without a separator belong together: W/m2K is W/(m2.K).
    void factorGroup() {
        std::string group;
        int factors = 0;
        while (at_ < text_.size() && isWord(text_[at_])) {
            if (factors++ > 0) group += '.';
            group += factor();
        }
        result_ += factors > 1 ? fmt::format("({})", group) : group;
    }

    std::string factor() {
        std::size_t begin = at_;
        while (at_ < text_.size() && isWord(text_[at_])) ++at_;
        std::string_view word = text_.substr(begin, at_ - begin);
        begin = at_;
        if (at_ + 1 < text_.size() && (text_[at_] == '-' || text_[at_] == '+') && isDigit(text_[at_ + 1])) ++at_;
        while (at_ < text_.size() && isDigit(text_[at_])) ++at_;
        const std::string exponent(text_.substr(begin, at_ - begin));
        if (const auto alias = lookUp(poweredAliases, std::string(word) + exponent)) return fmt::format("({})", *alias);
        return translateWord(word) + exponent;
    }

    std::string translateWord(std::string_view word) const {
        if (reading_ == Reading::Rotation && word.ends_with("Hz")) return fmt::format("({}.revolution)", word);
        const auto alias = lookUp(wordAliases, word);
        if (!alias) return std::string(word);
        constexpr std::string_view turn = "revolution";
        const auto at = alias->find(turn);
        if (reading_ == Reading::Frequency && at != std::string_view::npos) {
            return fmt::format("({}1{})", alias->substr(0, at), alias->substr(at + turn.size()));
        }
        return fmt::format("({})", *alias);
    }

    bool separator() {
        const char c = text_[at_];
        const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
        const bool sign = (c == '-' || c == '+') && isDigit(next);
        if (c == ' ') {  // "N m" is a product, "m / s" is not
            const std::size_t end = text_.find_first_not_of(' ', at_);
            const bool between = end != std::string_view::npos && !result_.empty() &&
                                 (isWord(result_.back()) || isDigit(result_.back()) || result_.back() == ')') &&
                                 (isWord(text_[end]) || isDigit(text_[end]) || text_[end] == '(');
            if (between) result_ += '.';
            at_ = end;
            return end != std::string_view::npos;
        }
        if (!isDigit(c) && c != '.' && c != '/' && c != '*' && c != '^' && c != '(' && c != ')' && !sign) return false;
        result_ += c;
        ++at_;
        return true;
    }

    std::string_view text_;
    Reading reading_;
    std::size_t at_{};
    std::string result_;
};

/// Power of the radian in a unit (UDUNITS keeps the radian as a basic unit of dimension 1).
struct AnglePower {
    const ut_unit* radian{};
    int power{};
};

ut_status visitBasic(const ut_unit* unit, void* argument) {
    auto& angle = *static_cast<AnglePower*>(argument);
    angle.power = ut_compare(unit, angle.radian) == 0 ? 1 : 0;
    return UT_SUCCESS;
}
ut_status visitProduct(const ut_unit*, int count, const ut_unit* const* basics, const int* powers, void* argument) {
    auto& angle = *static_cast<AnglePower*>(argument);
    for (int i = 0; i < count; ++i) {
        if (ut_compare(basics[i], angle.radian) == 0) angle.power = powers[i];
    }
    return UT_SUCCESS;
}
extern const ut_visitor anglePowerVisitor;
ut_status visitGalilean(const ut_unit*, double, const ut_unit* underlying, double, void* argument) {
    return ut_accept_visitor(underlying, &anglePowerVisitor, argument);
}
ut_status visitTimestamp(const ut_unit*, const ut_unit*, double, void*) { return UT_SUCCESS; }
ut_status visitLogarithmic(const ut_unit*, double, const ut_unit*, void*) { return UT_SUCCESS; }
const ut_visitor anglePowerVisitor{visitBasic, visitProduct, visitGalilean, visitTimestamp, visitLogarithmic};

/// The base units by their names in UDUNITS, and the powers that are found of each.
constexpr std::array<const char*, 7> baseNames{"meter", "kilogram", "second", "ampere", "kelvin", "mole", "candela"};

struct BasePowers {
    std::array<UnitPtr, 7>* bases{};
    Dimension powers{};

    void add(const ut_unit* basic, int power) {
        for (std::size_t i = 0; i < bases->size(); ++i)
            if (ut_compare(basic, (*bases)[i].get()) == 0) powers[i] = power;
    }
};

ut_status addBasic(const ut_unit* unit, void* argument) {
    static_cast<BasePowers*>(argument)->add(unit, 1);
    return UT_SUCCESS;
}
ut_status addProduct(const ut_unit*, int count, const ut_unit* const* basics, const int* powers, void* argument) {
    for (int i = 0; i < count; ++i) static_cast<BasePowers*>(argument)->add(basics[i], powers[i]);
    return UT_SUCCESS;
}
extern const ut_visitor basePowersVisitor;
ut_status addGalilean(const ut_unit*, double, const ut_unit* underlying, double, void* argument) {
    return ut_accept_visitor(underlying, &basePowersVisitor, argument);
}
const ut_visitor basePowersVisitor{addBasic, addProduct, addGalilean, visitTimestamp, visitLogarithmic};

/// The unit system and what was converted before. UDUNITS is not thread-safe: everything runs under one lock.
class UnitTable {
public:
    static UnitTable& instance() {
        static UnitTable table;
        return table;
    }

    Outcome<UnitConversion> convert(std::string_view from, std::string_view to) {
        const std::lock_guard lock(mutex_);
        std::string key(from);
        key += '\n';
        key += to;
        if (const auto known = conversions_.find(key); known != conversions_.end()) return known->second;
        if (conversions_.size() > 10000) conversions_.clear();
        return conversions_.emplace(std::move(key), findConversion(from, to)).first->second;
    }

    bool isKnown(std::string_view unit) {
        const std::lock_guard lock(mutex_);
        return parse(unit, Reading::AsWritten) != nullptr;
    }

    std::optional<Dimension> dimension(std::string_view unit) {
        const std::lock_guard lock(mutex_);
        std::string key(unit);
        if (const auto known = dimensions_.find(key); known != dimensions_.end()) return known->second;
        if (dimensions_.size() > 10000) dimensions_.clear();
        std::optional<Dimension> found;
        if (const UnitPtr parsed = parse(unit, Reading::AsWritten)) {
            BasePowers powers{&bases_, {}};
            if (ut_accept_visitor(parsed.get(), &basePowersVisitor, &powers) == UT_SUCCESS) found = powers.powers;
        }
        return dimensions_.emplace(std::move(key), found).first->second;
    }

    /// Of the usual units the one that is written most alike.
    std::string alike(std::string_view unit) const {
        static const std::vector<std::string> common{
            "degC",     "degF", "rad/s", "rpm", "1/min", "Ohm",   "N.m",  "N.m/rad", "N.m.s/rad", "kg.m2", "W/K",
            "W/(m2.K)", "J/K",  "km/h",  "m/s", "deg",   "deg/s", "mbar", "hPa",     "kPa",       "l/min", "kg/h",
            "mA",       "mV",   "ms",    "min", "Hz",    "kHz",   "Volt", "Ampere",  "Kelvin",    "Watt",  "Celsius"};
        return unit.size() > 100 ? std::string() : suggestion(unit, common);
    }

private:
    UnitTable() {
        ut_set_error_message_handler(ut_ignore);
        system_.reset(ut_read_xml(nullptr));
        if (!system_) return;
        radian_.reset(ut_get_unit_by_name(system_.get(), "radian"));
        hertz_.reset(ut_get_unit_by_name(system_.get(), "hertz"));
        for (std::size_t i = 0; i < bases_.size(); ++i)
            bases_[i].reset(ut_get_unit_by_name(system_.get(), baseNames[i]));
    }

    UnitPtr parse(std::string_view text, Reading reading) const {
        if (!system_ || text.size() > 100) return nullptr;
        std::string written = plain(text);
        if (const auto alias = lookUp(wholeAliases, inSmallLetters(written))) written = *alias;
        if (const std::size_t blank = written.rfind(' '); blank != std::string::npos) {
            const std::string last = inSmallLetters(std::string_view(written).substr(blank + 1));
            const auto isLast = [&](const char* word) { return last == word; };
            const std::string before(trimmed(std::string_view(written).substr(0, blank)));
            if (std::any_of(qualifiers.begin(), qualifiers.end(), isLast) ||
                (std::any_of(timeQualifiers.begin(), timeQualifiers.end(), isLast) && isTime(before)))
                return parse(before, reading);
        }
        const auto translated = UnitTranslator(written, reading).translate();
        if (!translated || translated->empty()) return nullptr;
        return UnitPtr(ut_parse(system_.get(), translated->c_str(), UT_UTF8));
    }

    bool isTime(std::string_view unit) const {
        const UnitPtr time = parse(unit, Reading::AsWritten), second = parse("s", Reading::AsWritten);
        return time && lineBetween(time.get(), second.get()) != nullptr;
    }

    bool isPerTime(ut_unit* unit) const { return lineBetween(unit, hertz_.get()) != nullptr; }

    /// Null unless one unit is a straight line of the other: UDUNITS also turns a time into a frequency (1/x).
    static ConverterPtr lineBetween(ut_unit* from, ut_unit* to) {
        if (!ut_are_convertible(from, to)) return nullptr;
        ConverterPtr converter(ut_get_converter(from, to));
        if (converter && !std::isfinite(cv_convert_double(converter.get(), 0.0))) return nullptr;
        return converter;
    }

    int anglePower(const ut_unit* unit) const {
        AnglePower angle{radian_.get(), 0};
        ut_accept_visitor(unit, &anglePowerVisitor, &angle);
        return angle.power;
    }

    Diagnostic unknown(std::string_view unit) const {
        if (!system_) {
            return error(phrase("the unit table udunits2.xml could not be read"), {},
                         phrase("install libudunits2-data or set UDUNITS2_XML_PATH"));
        }
        const std::string near = alike(trimmed(unit));
        return error(phrase("unknown unit \"{}\"", unit), {},
                     near.empty()
                         ? phrase("write it as in \"degC\", \"rad/s\", \"N.m\", \"W/(m2.K)\"; \"1\" has no dimension")
                         : phrase("did you mean \"{}\"?", near));
    }

    static Text mismatchHint(std::string_view from, std::string_view to) {
        if (from == "C" || to == "C") return phrase("\"C\" is the coulomb; write \"degC\" for a temperature");
        if (from == "F" || to == "F") return phrase("\"F\" is the farad; write \"degF\" for a temperature");
        if (from.empty() || to.empty())
            return phrase("state the unit on both sides; \"1\" says that there is no dimension");
        return {};
    }

    Outcome<UnitConversion> findConversion(std::string_view from, std::string_view to) const {
        if (from == to && from.empty()) return UnitConversion{};
        if (from.empty() || to.empty()) {
            const std::string_view given = from.empty() ? to : from;
            if (!parse(given, Reading::AsWritten)) return unknown(given);
            return error(phrase("no unit is given on one side, \"{}\" on the other", given), {},
                         mismatchHint(from, to));
        }
        UnitPtr source = parse(from, Reading::AsWritten);
        UnitPtr target = parse(to, Reading::AsWritten);
        if (!source) return unknown(from);
        if (!target) return unknown(to);
        readTurns(from, source, to, target);
        const ConverterPtr converter = lineBetween(source.get(), target.get());
        if (!converter) {
            return error(phrase("\"{}\" cannot be converted to \"{}\": they measure different quantities", from, to),
                         {}, mismatchHint(from, to));
        }
        return lineOf(*converter);
    }

    /// Turns per time against angle per time, see the top of the file.
    void readTurns(std::string_view from, UnitPtr& source, std::string_view to, UnitPtr& target) const {
        if (!isPerTime(source.get()) || !isPerTime(target.get())) return;
        const int sourcePower = anglePower(source.get());
        const int targetPower = anglePower(target.get());
        if (sourcePower == targetPower) return;
        const bool sourceIsAngle = sourcePower > targetPower;
        UnitPtr& angle = sourceIsAngle ? source : target;
        UnitPtr& count = sourceIsAngle ? target : source;
        if (UnitPtr rotation = parse(sourceIsAngle ? to : from, Reading::Rotation)) count = std::move(rotation);
        if (anglePower(angle.get()) == anglePower(count.get())) return;
        if (UnitPtr frequency = parse(sourceIsAngle ? from : to, Reading::Frequency)) angle = std::move(frequency);
    }

    static UnitConversion lineOf(const cv_converter& converter) {
        const double offset = cv_convert_double(&converter, 0.0);
        // Far from 0 the offset costs the slope no digits.
        const double far = offset == 0.0 ? 1.0 : std::ldexp(1.0, 40);
        double factor = (cv_convert_double(&converter, far) - offset) / far;
        if (std::abs(factor - 1.0) < 1e-14) factor = 1.0;
        // Offsets are short decimal numbers (273.15, 32): take away what the conversion's rounding left on them.
        const double decimal = std::round(offset * 1e9) / 1e9;
        if (offset != 0.0 && std::abs(offset - decimal) < 1e-12) return {factor, decimal};
        return {factor, offset};
    }

    std::mutex mutex_;
    std::unique_ptr<ut_system, SystemDeleter> system_;
    UnitPtr radian_;
    UnitPtr hertz_;
    std::array<UnitPtr, 7> bases_;
    std::unordered_map<std::string, std::optional<Dimension>> dimensions_;
    std::unordered_map<std::string, Outcome<UnitConversion>> conversions_;
};

}  // namespace

Outcome<UnitConversion> convertUnit(std::string_view from, std::string_view to) {
    return UnitTable::instance().convert(from, to);
}

bool isKnownUnit(std::string_view unit) { return unit.empty() || UnitTable::instance().isKnown(unit); }

std::string unitAlike(std::string_view unit) {
    const std::string_view written = trimmed(unit), first = written.substr(0, written.find(' '));
    // What is measured from another zero is no number of that unit.
    const std::string rest = inSmallLetters(trimmed(written.substr(first.size())));
    const bool movesZero = rest == "g" || rest.starts_with("gau") || rest.starts_with("rel");
    if (!rest.empty() && !movesZero && isKnownUnit(first)) return std::string(first);
    return UnitTable::instance().alike(written);
}

bool beginsWithUnitOf(std::string_view text, std::string_view other) {
    const std::string_view first = text.substr(0, text.find_first_of(" ,;"));
    return first.size() < text.size() && areConvertible(first, other);
}

bool areConvertible(std::string_view a, std::string_view b) { return convertUnit(a, b).hasValue(); }

std::optional<Dimension> dimensionOf(std::string_view unit) { return UnitTable::instance().dimension(unit); }

std::string text(const Dimension& dimension) {
    constexpr std::array<const char*, 7> symbols{"m", "kg", "s", "A", "K", "mol", "cd"};
    constexpr std::array<std::size_t, 7> order{1, 0, 2, 3, 4, 5, 6};
    struct Derived {
        const char* symbol;
        Dimension dimension;
    };
    static constexpr std::array derived{Derived{"V", {2, 1, -3, -1, 0, 0, 0}}, Derived{"Ohm", {2, 1, -3, -2, 0, 0, 0}},
                                        Derived{"W", {2, 1, -3, 0, 0, 0, 0}}, Derived{"N", {1, 1, -2, 0, 0, 0, 0}},
                                        Derived{"Pa", {-1, 1, -2, 0, 0, 0, 0}}};
    for (const Derived& unit : derived)
        if (unit.dimension == dimension) return unit.symbol;
    std::string above, below;
    int divisors = 0;
    for (const std::size_t i : order) {
        const double power = dimension[i];
        if (power == 0) continue;
        std::string& side = power > 0 ? above : below;
        divisors += power < 0;
        side += (side.empty() ? "" : ".") + std::string(symbols[i]);
        if (std::abs(power) != 1) side += fmt::format("{:g}", std::abs(power));
    }
    if (above.empty()) above = "1";
    if (below.empty()) return above;
    return above + "/" + (divisors > 1 ? "(" + below + ")" : below);
}

}  // namespace analogon
