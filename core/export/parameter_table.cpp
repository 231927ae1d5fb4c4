#include "core/export/parameter_table.hpp"

#include <fmt/format.h>

#include <QString>
#include <QXmlStreamWriter>
#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "core/base/unit.hpp"
#include "core/flat/flat_model.hpp"
#include "core/study/present_values.hpp"

namespace analogon {

namespace {

constexpr const char* csvHeader = "parameter,value,unit,min,max,fitted,description\n";
constexpr const char* jsonFormat = "analogon-parameters-1";
constexpr const char* said = "Exported by Analogon";

QString words(const std::string& text) { return QString::fromStdString(text); }

std::string csvText(const ParameterTable& table) {
    std::string text = csvHeader;
    const auto number = [](const std::optional<double>& value) { return value ? fmt::format("{}", *value) : ""; };
    for (const ParameterRow& row : table.rows)
        text += fmt::format("{},{},{},{},{},{},{}\n", csvCell(row.name), row.value, csvCell(row.unit), number(row.min),
                            number(row.max), row.isFitted ? "yes" : "no", csvCell(row.description));
    return text;
}

std::string jsonText(const ParameterTable& table) {
    nlohmann::ordered_json json{{"format", jsonFormat}, {"class", table.className}};
    json["parameters"] = nlohmann::ordered_json::object();
    for (const ParameterRow& row : table.rows) {
        nlohmann::ordered_json& own = json["parameters"][row.name];
        own["value"] = row.value;
        if (!row.unit.empty()) own["unit"] = row.unit;
        if (row.min) own["min"] = *row.min;
        if (row.max) own["max"] = *row.max;
        own["fitted"] = row.isFitted;
        if (!row.description.empty()) own["description"] = row.description;
    }
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

/// Text on one line in quotes.
std::string quotedWords(std::string text) {
    for (char& c : text)
        if (c == '"')
            c = '\'';
        else if (c == '\n' || c == '\r' || c == '\t')
            c = ' ';
    return '"' + text + '"';
}

/// The letters that tools for DCM read, ISO 8859-1: what it does not have is written with those that it has.
std::string inLatin1(const std::string& text) {
    static const std::vector<std::pair<QString, QString>> written{
        {QStringLiteral("\u2126"), "Ohm"},  {QStringLiteral("\u03A9"), "Ohm"}, {QStringLiteral("\u03BC"), QChar(0xB5)},
        {QStringLiteral("\u2013"), "-"},    {QStringLiteral("\u2014"), "-"},   {QStringLiteral("\u2212"), "-"},
        {QStringLiteral("\u2018"), "'"},    {QStringLiteral("\u2019"), "'"},   {QStringLiteral("\u201C"), "'"},
        {QStringLiteral("\u201D"), "'"},    {QStringLiteral("\u201E"), "'"},   {QStringLiteral("\u2026"), "..."},
        {QStringLiteral("\u2264"), "<="},   {QStringLiteral("\u2265"), ">="},  {QStringLiteral("\u0394"), "Delta "},
        {QStringLiteral("\u03D1"), "theta"}};
    QString plain = words(text);
    for (const auto& [from, to] : written) plain.replace(from, to);
    return plain.toLatin1().toStdString();
}

std::string dcmText(const ParameterTable& table) {
    std::string text = fmt::format("* {}: the parameters of {}\n\nKONSERVIERUNG_FORMAT 2.0\n", said, table.className);
    for (const ParameterRow& row : table.rows) {
        text += fmt::format("\nFESTWERT {}\n", row.name);
        if (!row.description.empty()) text += fmt::format("   LANGNAME {}\n", quotedWords(row.description));
        if (!row.unit.empty()) text += fmt::format("   EINHEIT_W {}\n", quotedWords(row.unit));
        text += fmt::format("   WERT {}\nEND\n", row.value);
    }
    return inLatin1(text);
}

/// A document that is written while the writer lives.
class Xml {
public:
    Xml() : writer_(&bytes_) {
        writer_.setAutoFormatting(true);
        writer_.setAutoFormattingIndent(2);
        writer_.writeStartDocument();
    }
    QXmlStreamWriter* operator->() { return &writer_; }
    std::string finish() {
        writer_.writeEndDocument();
        return bytes_.toStdString();
    }

private:
    QByteArray bytes_;
    QXmlStreamWriter writer_;
};

/// The unit by powers of those of SI, as SSP has it; empty: by none, or not by whole powers.
using Powers = std::vector<std::pair<const char*, QString>>;
std::optional<Powers> siOf(const std::string& unit) {
    const std::optional<Dimension> powers = dimensionOf(unit);
    if (!powers) return std::nullopt;
    const Outcome<UnitConversion> convert = convertUnit(unit, text(*powers));
    if (!convert || !std::isfinite(convert->factor)) return std::nullopt;
    constexpr const char* names[] = {"m", "kg", "s", "A", "K", "mol", "cd"};
    Powers attributes;
    for (std::size_t i = 0; i < powers->size(); ++i) {
        if ((*powers)[i] != std::round((*powers)[i])) return std::nullopt;
        if ((*powers)[i] != 0) attributes.emplace_back(names[i], QString::number(static_cast<int>((*powers)[i])));
    }
    if (convert->factor != 1) attributes.emplace_back("factor", words(fmt::format("{}", convert->factor)));
    if (convert->offset != 0) attributes.emplace_back("offset", words(fmt::format("{}", convert->offset)));
    return attributes;
}

std::string ssvText(const ParameterTable& table) {
    const QString values = "http://ssp-standard.org/SSP1/SystemStructureParameterValues",
                  common = "http://ssp-standard.org/SSP1/SystemStructureCommon";
    Xml xml;
    xml->writeNamespace(values, "ssv");
    xml->writeNamespace(common, "ssc");
    xml->writeStartElement(values, "ParameterSet");
    xml->writeAttribute("version", "1.0");
    xml->writeAttribute("name", words(table.className));
    xml->writeAttribute("generationTool", "Analogon");
    xml->writeStartElement(values, "Parameters");
    std::map<std::string, Powers> units;
    for (const ParameterRow& row : table.rows) {
        xml->writeStartElement(values, "Parameter");
        xml->writeAttribute("name", words(row.name));
        if (!row.description.empty()) xml->writeAttribute("description", words(row.description));
        xml->writeEmptyElement(values, "Real");
        xml->writeAttribute("value", words(fmt::format("{}", row.value)));
        if (const auto powers = row.unit.empty() ? std::nullopt : siOf(row.unit)) {
            xml->writeAttribute("unit", words(row.unit));
            units.emplace(row.unit, *powers);  // a unit must be described in the same file
        }
        xml->writeEndElement();
    }
    xml->writeEndElement();
    if (!units.empty()) xml->writeStartElement(values, "Units");
    for (const auto& [unit, powers] : units) {
        xml->writeStartElement(common, "Unit");
        xml->writeAttribute("name", words(unit));
        xml->writeEmptyElement(common, "BaseUnit");
        for (const auto& [name, value] : powers) xml->writeAttribute(name, value);
        xml->writeEndElement();
    }
    return xml.finish();
}

std::string cdfxText(const ParameterTable& table) {
    Xml xml;
    xml->writeDTD(
        "<!DOCTYPE MSRSW PUBLIC \"-//ASAM//DTD CALIBRATION DATA FORMAT:V2.0.0:LAI:IAI:XML:CDF200.XSD//EN\" "
        "\"cdf_v2.0.0.sl.dtd\">");
    xml->writeComment(QStringLiteral(" %1 ").arg(said));
    xml->writeStartElement("MSRSW");
    xml->writeTextElement("SHORT-NAME", words(table.className));
    xml->writeTextElement("CATEGORY", "CDF20");
    xml->writeStartElement("SW-SYSTEMS");
    xml->writeStartElement("SW-SYSTEM");
    xml->writeTextElement("SHORT-NAME", words(table.className));
    xml->writeStartElement("SW-INSTANCE-SPEC");
    xml->writeStartElement("SW-INSTANCE-TREE");
    xml->writeTextElement("SHORT-NAME", words(table.className));
    xml->writeTextElement("CATEGORY", "NO_VCD");
    for (const ParameterRow& row : table.rows) {
        xml->writeStartElement("SW-INSTANCE");
        xml->writeTextElement("SHORT-NAME", words(row.name));
        if (!row.description.empty()) xml->writeTextElement("LONG-NAME", words(row.description));
        xml->writeTextElement("CATEGORY", "VALUE");
        xml->writeStartElement("SW-VALUE-CONT");
        if (!row.unit.empty()) xml->writeTextElement("UNIT-DISPLAY-NAME", words(row.unit));
        xml->writeStartElement("SW-VALUES-PHYS");
        xml->writeTextElement("V", words(fmt::format("{}", row.value)));
        for (int open = 0; open < 3; ++open) xml->writeEndElement();
    }
    return xml.finish();
}

}  // namespace

std::optional<ParameterFormat> parameterFormatOf(const std::filesystem::path& file) {
    static const std::map<QString, ParameterFormat> formats{{".csv", ParameterFormat::Csv},
                                                            {".json", ParameterFormat::Json},
                                                            {".ssv", ParameterFormat::Ssv},
                                                            {".dcm", ParameterFormat::Dcm},
                                                            {".cdfx", ParameterFormat::Cdfx}};
    const auto found = formats.find(words(file.extension().string()).toLower());
    return found == formats.end() ? std::nullopt : std::optional(found->second);
}

Outcome<ParameterTable> parameterTable(const Study& study) {
    const Outcome<Study> present = withPresentValues(study);
    if (!present) return present.diagnostics();
    const Outcome<Library> library = studyLibrary(*present);
    if (!library) return library.diagnostics();
    const Outcome<FlatModel> model = flatten(*library, study.className);
    if (!model) return model.diagnostics();
    ParameterTable table;
    table.className = study.className;
    for (std::uint32_t i = 0; i < model->variables.size(); ++i) {
        const FlatVariable& variable = model->variables[i];
        const auto setting = study.parameters.find(variable.name);
        const bool isNamed = setting != study.parameters.end();
        if (variable.variability != FlatVariability::Parameter || variable.type != FlatType::Real) continue;
        const bool isOwn = variable.binding.valid() && model->pool->isConstant(variable.binding);
        const bool maySet = !variable.isFinal && !variable.isProtected && !variable.isStructural && isOwn;
        const std::optional<double> value = model->parameterValue({i});
        if ((!maySet && !isNamed) || !value || !std::isfinite(*value)) continue;
        ParameterRow row{variable.name, model->unitOf(variable),       variable.description, *value, variable.min,
                         variable.max,  isNamed && setting->second.fit};
        if (isNamed && setting->second.min) row.min = setting->second.min;
        if (isNamed && setting->second.max) row.max = setting->second.max;
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string parameterText(const ParameterTable& table, ParameterFormat format) {
    switch (format) {
        case ParameterFormat::Csv:
            return csvText(table);
        case ParameterFormat::Json:
            return jsonText(table);
        case ParameterFormat::Ssv:
            return ssvText(table);
        case ParameterFormat::Dcm:
            return dcmText(table);
        case ParameterFormat::Cdfx:
            break;
    }
    return cdfxText(table);
}

bool isParameterText(const std::string& begin, ParameterFormat format) {
    const auto has = [&](const std::string& words) { return begin.find(words) != std::string::npos; };
    switch (format) {
        case ParameterFormat::Csv:
            return begin.starts_with(csvHeader);
        case ParameterFormat::Json:
            return begin.starts_with("{\n  \"format\": \"" + std::string(jsonFormat) + '"');
        case ParameterFormat::Ssv:
            return has("<ssv:ParameterSet") && has("generationTool=\"Analogon\"");
        case ParameterFormat::Dcm:
            return begin.starts_with(std::string("* ") + said);
        case ParameterFormat::Cdfx:
            break;
    }
    return has("<!DOCTYPE MSRSW") && has(std::string("<!-- ") + said + " -->");
}

}  // namespace analogon
