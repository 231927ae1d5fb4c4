// The whole loop on recordings that lie beside the project: studies with a known answer, and measurements.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/study/run.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;

const fs::path root = ANALOGON_ROOT;
const fs::path shared = root / ".." / "shared";

double validationError(const ModelState& state) {
    double squares = 0;
    int count = 0;
    for (const ExperimentState& e : state.experiments)
        if (e.role == Role::Validate) {
            squares += e.errorPercent * e.errorPercent;
            ++count;
        }
    return count > 0 ? std::sqrt(squares / count) : 0;
}

Finding discovered(const fs::path& directory) {
    Outcome<Study> study = readStudy(directory);
    EXPECT_TRUE(study) << format(study.diagnostics());
    if (!study) return {};
    Outcome<RunResult> result = runDiscover(*study, {});
    EXPECT_TRUE(result) << format(result.diagnostics());
    return result ? result->finding : Finding{};
}

class CaseWithTruth : public testing::TestWithParam<const char*> {};

TEST_P(CaseWithTruth, IsNamedAtItsPlaceAndLeavesNoise) {
    const fs::path directory = shared / "cases" / GetParam();
    if (!fs::exists(directory)) GTEST_SKIP() << "no cases beside the project";
    std::ifstream file(directory / "truth.json");
    const nlohmann::json truth = nlohmann::json::parse(file);
    const Finding finding = discovered(directory);
    ASSERT_EQ(finding.effects.size(), truth["pairs_accepted"].size());
    for (const nlohmann::json& accepted : truth["pairs_accepted"]) {
        bool isNamed = false;
        for (const AddedEffect& effect : finding.effects)
            for (const nlohmann::json& pair : accepted)
                for (const nlohmann::json& at : pair["at"]) isNamed |= pair["kind"] == effect.kind && at == effect.at;
        EXPECT_TRUE(isNamed) << accepted.dump();
    }
    EXPECT_EQ(finding.kind, finding.effects.empty() ? FindingKind::Adequate : FindingKind::Effect);
    EXPECT_LT(validationError(finding.final), 1.1 * truth["floor"]["validation"].get<double>());
}

INSTANTIATE_TEST_SUITE_P(Shared, CaseWithTruth,
                         testing::Values("public-003", "public-004", "public-007", "public-009", "public-010",
                                         "public-014"),
                         [](const auto& tested) {
                             std::string name = tested.param;
                             name.erase(name.find('-'), 1);
                             return name;
                         });

/// Root mean square [K] over all channels of the validation.
double validationKelvin(const ModelState& state) {
    double squares = 0;
    int count = 0;
    for (const ExperimentState& e : state.experiments) {
        if (e.role != Role::Validate) continue;
        for (const OutputState& o : e.outputs) {
            squares += o.figures.rmse * o.figures.rmse;
            ++count;
        }
    }
    return count > 0 ? std::sqrt(squares / count) : 0;
}

TEST(TwoHeaters, ShowTheLagOfTheirThermistors) {
    if (!fs::exists(shared / "data" / "tclab_apmonitor")) GTEST_SKIP() << "no measurements beside the project";
    const Finding finding = discovered(root / "tests" / "studies" / "tclab");
    ASSERT_FALSE(finding.effects.empty());
    for (const AddedEffect& e : finding.effects) EXPECT_EQ(e.kind, "sensor.lag") << e.at;
    EXPECT_EQ(finding.effects.front().at, "output T1");
    EXPECT_GT(validationKelvin(finding.baseline), 1.4);
    EXPECT_LT(validationKelvin(finding.final), 0.75);
}

}  // namespace
}  // namespace analogon
