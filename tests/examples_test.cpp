#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/study/run.hpp"

/// Every shipped example is a proof: its recordings were made by a script that knows what the model lacks, and the
/// program, which does not, must find it.
namespace analogon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json expectationOf(const fs::path& example) {
    std::ifstream text(example / "expected.json");
    return json::parse(text);
}

const ExperimentState* experiment(const ModelState& state, const std::string& name) {
    for (const ExperimentState& e : state.experiments)
        if (e.name == name) return &e;
    return nullptr;
}

class Example : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Shipped, Example, testing::Values("lambda-sensor-heating", "water-pump"),
                         [](const auto& tested) {
                             std::string name = tested.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(Example, FindsWhatTheModelLacks) {
    const fs::path directory = fs::path(ANALOGON_ROOT) / "examples" / GetParam();
    const json expected = expectationOf(directory);
    const Outcome<Study> study = readStudy(directory);
    ASSERT_TRUE(study) << format(study.diagnostics());
    const Outcome<RunResult> result = runDiscover(*study, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    const Finding& finding = result->finding;

    EXPECT_EQ(name(finding.kind), expected["finding"].get<std::string>());
    ASSERT_EQ(finding.effects.size(), expected["effects"].size());
    for (std::size_t i = 0; i < finding.effects.size(); ++i) {
        const AddedEffect& effect = finding.effects[i];
        const json& wanted = expected["effects"][i];
        EXPECT_EQ(effect.kind, wanted["kind"].get<std::string>());
        const auto places = wanted["at"].get<std::vector<std::string>>();
        EXPECT_NE(std::find(places.begin(), places.end(), effect.at), places.end()) << effect.at;
        for (const auto& [parameter, truth] : wanted["parameters"].items())
            for (const EffectValue& v : effect.parameters)
                if (v.name == parameter) {
                    EXPECT_NEAR(v.value, truth.get<double>(), 0.1 * std::abs(truth.get<double>())) << v.name;
                }
    }
    for (const auto& [parameter, truth] : expected["parameters"].items())
        for (const FitEstimate& e : finding.final.parameters)
            if (e.name == parameter) {
                EXPECT_NEAR(e.value, truth.get<double>(), 0.1 * truth.get<double>()) << e.name;
            }
    for (const auto& [name, floorValue] : expected["noise_floor_percent"].items()) {
        SCOPED_TRACE(name);
        const double floor = floorValue.get<double>();
        const ExperimentState* before = experiment(finding.baseline, name);
        const ExperimentState* after = experiment(finding.final, name);
        ASSERT_NE(before, nullptr);
        ASSERT_NE(after, nullptr);
        EXPECT_LE(after->errorPercent, expected["after_over_floor_max"].get<double>() * floor);
        if (before->role == Role::Validate) {
            EXPECT_GE(before->errorPercent, expected["before_over_floor_min"].get<double>() * floor);
        }
    }
}

}  // namespace
}  // namespace analogon
