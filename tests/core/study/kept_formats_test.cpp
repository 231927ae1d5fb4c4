#include <nlohmann/json.hpp>

#include "study_fixture.hpp"

/// Studies as version 1.0 wrote them (docs/compatibility.md): the text below is never changed, later members get a text
/// of their own.
namespace analogon {
namespace {

using Json = nlohmann::json;

constexpr const char* studyOf10 = R"({
  "format": "analogon-study-1",
  "class": "Rig",
  "library": ["../blocks"],
  "experiments": [
    {"name": "run-up", "role": "fit", "file": "a.mf4", "time": "t", "range": [1, 2.5], "raster": 0.5,
     "inputs": {"u": {"column": "U", "group": "fast", "unit": "mV", "scale": 2, "offset": -1, "interpolation": "hold"}},
     "outputs": {"y": {"column": "Y", "weight": 0.5}, "drive.w": "n"},
     "initial": {"b.T": "fit", "b.w": 3, "b.x": "T_air"}},
    {"name": "warm", "role": "validate", "file": "b.csv", "use": false, "raster": "Y", "time": "clock",
     "read": {"separator": ";", "decimal": ",", "thousands": ".", "skip": 3, "header": 2, "units": true,
              "time_format": "%d.%m.%Y %H:%M:%S", "time_zone": "+01:00", "encoding": "windows-1252",
              "unit_names": {"kpa": "kPa"}},
     "inputs": {"u": "U"}, "outputs": {"y": {"column": "Y", "sheet": "Messung"}}}
  ],
  "parameters": {
    "b.R": {"fit": false, "value": 2},
    "b.k": {"fit": true, "min": 0.5, "max": 4, "scale": "lin"},
    "b.J": {"fit": true, "min": 1e-6, "max": 1, "scale": "log", "prior": {"mean": 1e-4, "std": 1e-5}}
  },
  "report": {"title": "Pump 7", "test_object": "B", "author": "E. Noether", "date": "12 March", "logo": "logo.png",
             "leave_out": ["tried"]}
})";

/// Whether all of `kept` is in `now`, with the same values.
::testing::AssertionResult holds(const Json& now, const Json& kept, const std::string& at) {
    if (kept.is_object()) {
        for (const auto& [name, value] : kept.items()) {
            if (!now.is_object() || !now.contains(name)) return ::testing::AssertionFailure() << at << "/" << name;
            if (const auto inside = holds(now[name], value, at + "/" + name); !inside) return inside;
        }
        return ::testing::AssertionSuccess();
    }
    if (kept.is_array()) {
        if (!now.is_array() || now.size() != kept.size()) return ::testing::AssertionFailure() << at;
        for (std::size_t i = 0; i < kept.size(); ++i)
            if (const auto inside = holds(now[i], kept[i], at + "/" + std::to_string(i)); !inside) return inside;
        return ::testing::AssertionSuccess();
    }
    return now == kept ? ::testing::AssertionSuccess()
                       : ::testing::AssertionFailure() << at << ": " << now.dump() << " for " << kept.dump();
}

TEST(KeptFormats, AStudyOfVersion10IsReadWithoutARemarkAndWrittenWithAllThatItSaid) {
    const Outcome<Study> study = parseStudyJson(std::make_shared<const Source>("study.json", studyOf10));
    ASSERT_TRUE(study.hasValue()) << format(study.diagnostics());
    EXPECT_TRUE(study.diagnostics().empty()) << format(study.diagnostics());
    EXPECT_TRUE(holds(Json::parse(studyJson(*study)), Json::parse(studyOf10), ""));
}

TEST(KeptFormats, WhatANewerVersionWroteBesideIsKeptAndTold) {
    Json newer = Json::parse(studyOf10);
    newer["made_by"] = {{"a newer version", 2}};
    newer["experiments"][0]["bench"] = "7";
    const Outcome<Study> study = parseStudyJson(std::make_shared<const Source>("study.json", newer.dump()));
    ASSERT_TRUE(study.hasValue()) << format(study.diagnostics());
    EXPECT_EQ(study.diagnostics().size(), 2u);
    EXPECT_TRUE(holds(Json::parse(studyJson(*study)), newer, ""));
}

}  // namespace
}  // namespace analogon
