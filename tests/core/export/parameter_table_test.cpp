#include "core/export/parameter_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QXmlStreamReader>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/export/export.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

ParameterTable sample() {
    return {"Drive",
            {{"motor.R", "Ohm", "Resistance \"cold\", at <20> °C", 0.1, 0.05, std::nullopt, true},
             {"rotor.J", "kg.m2", "", 1.0 / 3, std::nullopt, std::nullopt, false},
             {"T_amb", "degC", "", 20, std::nullopt, std::nullopt, false},
             {"c[1]", "furlong", "", 1e-300, std::nullopt, 1e300, true}}};
}

/// The values that stand in elements of a name, by the text of the last other element before them.
std::map<std::string, double> elements(const std::string& text, const char* key, const char* value) {
    QXmlStreamReader xml(QByteArray::fromStdString(text));
    std::map<std::string, double> values;
    std::string name;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String(key))
            name = xml.readElementText().toStdString();
        else if (xml.name() == QLatin1String(value))
            values[name] = xml.readElementText().toDouble();
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return values;
}

TEST(ParameterTable, CsvHasOneRowForEach) {
    const std::string text = parameterText(sample(), ParameterFormat::Csv);
    EXPECT_THAT(text, HasSubstr("motor.R,0.1,Ohm,0.05,,yes,\"Resistance \"\"cold\"\", at <20> °C\"\n"));
    EXPECT_THAT(text, HasSubstr("rotor.J,0.3333333333333333,kg.m2,,,no,\n"));
}

TEST(ParameterTable, JsonHoldsTheSameNumbers) {
    const auto json = nlohmann::json::parse(parameterText(sample(), ParameterFormat::Json));
    EXPECT_EQ(json.at("class"), "Drive");
    EXPECT_EQ(json.at("parameters").at("rotor.J").at("value").get<double>(), 1.0 / 3);
    EXPECT_EQ(json.at("parameters").at("motor.R").at("min").get<double>(), 0.05);
    EXPECT_EQ(json.at("parameters").at("c[1]").at("unit"), "furlong");
}

TEST(ParameterTable, SsvDescribesEachUnitThatItNames) {
    const std::string text = parameterText(sample(), ParameterFormat::Ssv);
    QXmlStreamReader xml(QByteArray::fromStdString(text));
    std::map<std::string, double> values;
    std::map<std::string, std::string> units;  // of a parameter
    std::map<std::string, std::map<std::string, std::string>> described;
    std::string name, unit;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const QXmlStreamAttributes attributes = xml.attributes();
        const QString values1 = "http://ssp-standard.org/SSP1/SystemStructureParameterValues",
                      common = "http://ssp-standard.org/SSP1/SystemStructureCommon";
        if (xml.name() == QLatin1String("ParameterSet")) {
            EXPECT_EQ(xml.namespaceUri(), values1);
            EXPECT_EQ(attributes.value("version"), QLatin1String("1.0"));
            EXPECT_EQ(attributes.value("name"), QLatin1String("Drive"));
        } else if (xml.name() == QLatin1String("Parameter")) {
            name = attributes.value("name").toString().toStdString();
        } else if (xml.name() == QLatin1String("Real")) {
            values[name] = attributes.value("value").toDouble();
            if (attributes.hasAttribute("unit")) units[name] = attributes.value("unit").toString().toStdString();
        } else if (xml.name() == QLatin1String("Unit")) {
            EXPECT_EQ(xml.namespaceUri(), common);
            unit = attributes.value("name").toString().toStdString();
        } else if (xml.name() == QLatin1String("BaseUnit")) {
            for (const QXmlStreamAttribute& a : attributes)
                described[unit][a.name().toString().toStdString()] = a.value().toString().toStdString();
        }
    }
    ASSERT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    for (const ParameterRow& row : sample().rows) EXPECT_EQ(values[row.name], row.value) << row.name;
    for (const auto& [parameter, named] : units) EXPECT_TRUE(described.contains(named)) << parameter;
    using Powers = std::map<std::string, std::string>;
    EXPECT_EQ(described["Ohm"], (Powers{{"kg", "1"}, {"m", "2"}, {"s", "-3"}, {"A", "-2"}}));
    EXPECT_EQ(described["degC"], (Powers{{"K", "1"}, {"offset", "273.15"}}));
}

TEST(ParameterTable, DcmHasAFixedValueForEach) {
    const std::string text = parameterText(sample(), ParameterFormat::Dcm);
    EXPECT_THAT(text, HasSubstr("\nKONSERVIERUNG_FORMAT 2.0\n"));
    EXPECT_THAT(text, HasSubstr("\nFESTWERT motor.R\n   LANGNAME \"Resistance 'cold', at <20> \xB0"
                                "C\"\n   EINHEIT_W \"Ohm\"\n   WERT 0.1\nEND\n"));
    EXPECT_THAT(text, HasSubstr("FESTWERT rotor.J\n   EINHEIT_W \"kg.m2\"\n   WERT 0.3333333333333333\nEND\n"));
}

TEST(ParameterTable, DcmKeepsTheMeaningOfLettersThatItDoesNotHave) {
    ParameterTable table = sample();
    table.rows = {{"R", "m\xCE\xA9", "W\xC3\xA4rme \xE2\x80\x93 \xCE\xBCm", 1, {}, {}, false}};
    const std::string text = parameterText(table, ParameterFormat::Dcm);
    EXPECT_THAT(text, HasSubstr("LANGNAME \"W\xE4rme - \xB5m\"\n   EINHEIT_W \"mOhm\""));
}

TEST(ParameterTable, CdfxHasAnInstanceForEach) {
    const std::string text = parameterText(sample(), ParameterFormat::Cdfx);
    EXPECT_THAT(text, HasSubstr("<CATEGORY>CDF20</CATEGORY>"));
    EXPECT_THAT(text, HasSubstr("<UNIT-DISPLAY-NAME>kg.m2</UNIT-DISPLAY-NAME>"));
    const std::map<std::string, double> values = elements(text, "SHORT-NAME", "V");
    for (const ParameterRow& row : sample().rows) EXPECT_EQ(values.at(row.name), row.value) << row.name;
}

TEST(ParameterTable, HoldsThePresentValuesOfTheStudy) {
    Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
    ASSERT_TRUE(study) << format(study.diagnostics());
    study->parameters["heater.R"].value = 4.125;
    const Outcome<ParameterTable> table = parameterTable(*study);
    ASSERT_TRUE(table) << format(table.diagnostics());
    bool found = false;
    for (const ParameterRow& row : table->rows) {
        if (row.name != "heater.R") continue;
        found = true;
        EXPECT_EQ(row.value, 4.125);
        EXPECT_EQ(row.unit, "Ohm");
        EXPECT_TRUE(row.isFitted);
        EXPECT_TRUE(row.min && row.max);
    }
    EXPECT_TRUE(found);
}

TEST(ParameterTable, TheEndingSaysTheFormatAndOnlyEarlierOnesAreReplaced) {
    const std::filesystem::path directory = std::filesystem::temp_directory_path() / "analogon-parameter-table";
    std::filesystem::remove_all(directory);
    std::filesystem::create_directories(directory);
    const Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
    ASSERT_TRUE(study);
    for (const char* const name : {"p.csv", "p.JSON", "p.ssv", "p.dcm", "p.cdfx"}) {
        const std::filesystem::path file = directory / name;
        for (int time = 0; time < 2; ++time) {
            const auto exported = exportStudy(*study, ExportFormat::Parameters, file, {}, Existing::OwnAlone);
            ASSERT_TRUE(exported) << name << format(exported.diagnostics());
        }
        std::ofstream(file) << "mine";
        const auto refused = exportStudy(*study, ExportFormat::Parameters, file, {}, Existing::OwnAlone);
        ASSERT_FALSE(refused) << name;
        EXPECT_THAT(refused.diagnostics()[0].message.english(), HasSubstr("this exists already"));
    }
    const auto unknown = exportStudy(*study, ExportFormat::Parameters, directory / "p.txt", {}, Existing::OwnAlone);
    ASSERT_FALSE(unknown);
    EXPECT_THAT(unknown.diagnostics()[0].hint.english(), HasSubstr(".cdfx"));
    EXPECT_FALSE(std::filesystem::exists(directory / "p.txt"));
    std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace analogon
