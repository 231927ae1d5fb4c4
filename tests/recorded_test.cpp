// The whole loop on recordings that lie beside the project: studies with a known answer, and measurements.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

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

/// `change`: of the study, before the search.
Finding discovered(const fs::path& directory, const std::function<void(Study&)>& change = {}) {
    Outcome<Study> study = readStudy(directory);
    EXPECT_TRUE(study) << format(study.diagnostics());
    if (!study) return {};
    if (change) change(*study);
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

/// Two heaters side by side with parameters changed. Heat capacity, radiation and room are held in the study at the
/// values that are published with the recordings.
class TwoHeaters : public testing::Test {
protected:
    void SetUp() override {
        if (!fs::exists(shared / "data" / "tclab_apmonitor")) GTEST_SKIP() << "no measurements beside the project";
    }

    static Finding search(const std::map<std::string, StudyParameter>& changed = {}) {
        return discovered(root / "tests" / "studies" / "tclab", [&](Study& study) {
            for (const auto& [name, parameter] : changed) study.parameters[name] = parameter;
        });
    }

    static StudyParameter held(double value) {
        StudyParameter parameter;
        parameter.fit = false;
        parameter.value = value;
        return parameter;
    }

    static void expectLags(const Finding& finding, double most) {
        ASSERT_FALSE(finding.effects.empty());
        for (const AddedEffect& e : finding.effects) EXPECT_EQ(e.kind, "sensor.lag") << e.at;
        EXPECT_EQ(finding.effects.front().at, "output T1");
        EXPECT_GT(validationKelvin(finding.baseline), 1.4);
        EXPECT_LT(validationKelvin(finding.final), most);
    }
};

TEST_F(TwoHeaters, ShowTheLagOfTheirThermistors) { expectLags(search(), 0.70); }

TEST_F(TwoHeaters, ShowItWithoutRadiationInARoomOfUnknownTemperature) {
    StudyParameter room;
    room.min = 289;
    room.max = 301;
    expectLags(search({{"T_room", room}, {"k_r", held(0)}}), 0.75);
}

// Beside a model that is wrong elsewhere, too, a slow heater explains a little more of the fitted recording than a slow
// thermistor; it does worse on the other recording, and is met less often.
TEST_F(TwoHeaters, AreNotTakenForSlowWhereTheRoomIsHeldTooCold) {
    const Finding finding = search({{"T_room", held(295)}});
    expectLags(finding, 1.05);
    const std::vector<Alternative>& others = finding.effects.front().instead.effects;
    EXPECT_TRUE(std::any_of(others.begin(), others.end(), [](const Alternative& a) {
        return a.kind == "actuator.lag" && a.at == "input heater1" && a.equivalent;
    }));
}

/// Root mean square over the channels that have the role of their error relative to the signal [%].
double relativeError(const ModelState& state, Role role) {
    double squares = 0;
    int count = 0;
    for (const ExperimentState& e : state.experiments) {
        if (e.role != role) continue;
        for (const OutputState& o : e.outputs) {
            squares += o.figures.relativeRmsPercent * o.figures.relativeRmsPercent;
            ++count;
        }
    }
    return count > 0 ? std::sqrt(squares / count) : 0;
}

const AddedEffect* effectOf(const Finding& finding, std::initializer_list<const char*> kinds) {
    for (const AddedEffect& e : finding.effects)
        for (const char* kind : kinds)
            if (e.kind == kind) return &e;
    return nullptr;
}

// Fitted to a sweep of frequencies; ramps and steps of the voltage are not.
TEST(BrushedMotor, ShowsItsDryFriction) {
    if (!fs::exists(shared / "data" / "dcmotor_fra233")) GTEST_SKIP() << "no measurements beside the project";
    const Finding finding = discovered(root / "tests" / "studies" / "dcmotor");
    const AddedEffect* friction = effectOf(finding, {"friction.coulomb"});
    ASSERT_TRUE(friction);
    EXPECT_NEAR(friction->parameters.front().value, 0.0085, 0.0015);
    EXPECT_GT(relativeError(finding.baseline, Role::Validate), 7);
    EXPECT_LT(relativeError(finding.final, Role::Validate), 5.2);
    EXPECT_LT(relativeError(finding.final, Role::Fit), 4.3);
    EXPECT_EQ(finding.kind, FindingKind::Partial) << "cogging and the driver's dead time are not all of it";
}

/// A carriage on a ball screw: published are 20.4 N of dry friction and a constant force of -3.2 N beside mass and
/// viscous friction, which differs from one direction to the other.
class PositioningDrive : public testing::Test {
protected:
    void SetUp() override {
        if (!fs::exists(data_)) GTEST_SKIP() << "no measurements beside the project";
        fs::create_directories(study_);
        fs::copy(root / "tests" / "studies" / "emps", study_,
                 fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    }
    void TearDown() override { fs::remove_all(study_); }

    /// Of every so many samples.
    Finding search(std::size_t every, const std::function<void(Study&)>& change = {}) const {
        writeSpeeds(data_ / "emps_train.csv", study_ / "positioning.csv", every);
        writeSpeeds(data_ / "emps_test_pulses.csv", study_ / "pulses.csv", every);
        return discovered(study_, change);
    }

    static void expectFrictionAndForce(const Finding& finding) {
        const AddedEffect* friction = effectOf(finding, {"friction.coulomb"});
        ASSERT_TRUE(friction);
        EXPECT_NEAR(friction->parameters.front().value, 20.4, 2) << "as published";
        const AddedEffect* force = effectOf(finding, {"torque.constant", "actuator.offset"});
        ASSERT_TRUE(force) << "one and the same to every measurement";
        EXPECT_NEAR(std::abs(force->parameters.front().value), 3.2, 0.5);
        EXPECT_GT(relativeError(finding.baseline, Role::Validate), 15);
        EXPECT_LT(relativeError(finding.final, Role::Validate), 7);
        ASSERT_FALSE(finding.unexplained.remainders.empty());
        EXPECT_NE(finding.unexplained.remainders.front().proposal.equation.english().find("abs(w)"), std::string::npos);
    }

private:
    /// Speed [m/s] from positions, over ten samples either way where there are so many, with the force.
    static void writeSpeeds(const fs::path& from, const fs::path& to, std::size_t every) {
        std::ifstream in(from);
        std::string line;
        std::getline(in, line);
        std::vector<std::string> names;
        std::istringstream header(line);
        for (std::string name; std::getline(header, name, ',');) names.push_back(name);
        const auto column = [&](const char* name) {
            return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
        };
        const std::size_t time = column("time_s"), force = column("motor_force_N"), position = column("position_m");
        std::vector<std::vector<double>> rows;
        while (std::getline(in, line)) {
            std::istringstream cells(line);
            rows.emplace_back();
            for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(std::stod(cell));
        }
        std::ofstream out(to);
        out.precision(9);
        out << "t [s],force [N.m],speed [rad/s]\n";
        const std::size_t last = rows.size() - 1;
        for (std::size_t i = 0; i <= last; i += every) {
            const std::size_t reach = std::max<std::size_t>(1, std::min({std::size_t{10}, i, last - i}));
            const auto& before = rows[i > reach ? i - reach : 0];
            const auto& after = rows[std::min(last, i + reach)];
            out << rows[i][time] << ',' << rows[i][force] << ','
                << (after[position] - before[position]) / (after[time] - before[time]) << '\n';
        }
    }

    const fs::path data_ = shared / "data" / "emps";
    const fs::path study_ = fs::temp_directory_path() / ("analogon-emps-" + std::to_string(getpid()));
};

TEST_F(PositioningDrive, ShowsDryFrictionAndAConstantForce) { expectFrictionAndForce(search(5)); }

// Of so short a record neither is clear by itself: the drag that differs leaves too much of it.
TEST_F(PositioningDrive, ShowsDryFrictionAndAConstantForceInAPartOfTheRecord) {
    const Finding finding = search(10, [](Study& study) { study.experiments.front().range = {3, 20}; });
    expectFrictionAndForce(finding);
    const auto start = std::find_if(finding.final.parameters.begin(), finding.final.parameters.end(),
                                    [](const FitEstimate& e) { return e.name == "carriage.w.start"; });
    ASSERT_NE(start, finding.final.parameters.end()) << "the carriage moves where the part begins";
    EXPECT_NEAR(start->value, 0.037, 0.004);
}

TEST_F(PositioningDrive, ShowsThemWhereTheViscousFrictionIsNotInTheModelEither) {
    const Finding finding = search(10, [](Study& study) {
        std::string& model = study.models.at(study.modelFile);
        const std::string viscous = "guide(b=200)";
        const auto at = model.find(viscous);
        ASSERT_NE(at, std::string::npos);
        model.replace(at, viscous.size(), "guide(b=0)");
        study.parameters.erase("guide.b");
    });
    expectFrictionAndForce(finding);
    EXPECT_TRUE(effectOf(finding, {"friction.viscous"}));
}

// Two motors on one belt, a pulley whose speed is counted in pulses without its sign: that sensor is a block of the
// study's own.
TEST(CoupledDrives, AreExplainedByNamesOrByAProposalThatIsBorneOut) {
    if (!fs::exists(shared / "data" / "coupled_drives")) GTEST_SKIP() << "no measurements beside the project";
    const Finding finding = discovered(root / "tests" / "studies" / "coupled_drives");
    // friction, the filter of the sensor and a soft belt hide behind each other: where they are not named, what is
    // proposed in their place must bear out as well
    EXPECT_GT(validationError(finding.baseline), 10);
    EXPECT_TRUE(finding.kind == FindingKind::Partial || finding.kind == FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const Remainder& left = finding.unexplained.remainders.front();
    const double proposed =
        left.proposal.errors.validate >= 0 ? left.proposal.errors.validate : validationError(finding.baseline);
    EXPECT_LT(std::min(validationError(finding.final), proposed), 7);
    EXPECT_FALSE(left.node.empty());
}

// An electronic oscillator, read as a mass on a spring: the library has no name for a spring that stiffens.
TEST(Oscillator, IsGivenTheLawOfAStiffeningSpring) {
    if (!fs::exists(shared / "data" / "silverbox")) GTEST_SKIP() << "no measurements beside the project";
    const Finding finding = discovered(root / "tests" / "studies" / "oscillator");
    EXPECT_FALSE(effectOf(finding, {"spring.return", "friction.coulomb", "drag.quadratic"}));
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const Remainder& law = finding.unexplained.remainders.front();
    EXPECT_EQ(law.node, "drive.flange");
    EXPECT_EQ(law.proposal.className, "Analogon.Effects.Proposals.HardeningSpring") << law.proposal.equation;
    EXPECT_GT(validationError(finding.baseline), 2);
    EXPECT_LT(law.proposal.errors.validate, 0.3);
}

// Two tanks, one above the other, from blocks of the study's own on a connector of its own. The tanks overflow.
TEST(CascadedTanks, LackWhatSetsInAtAHighLevel) {
    if (!fs::exists(shared / "data" / "cascaded_tanks")) GTEST_SKIP() << "no measurements beside the project";
    const Finding finding = discovered(root / "tests" / "studies" / "tanks");
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const Remainder& law = finding.unexplained.remainders.front();
    EXPECT_NE(law.node, "output y") << "it is no fault of the level sensor";
    EXPECT_NE(law.proposal.equation.find("max(0, "), std::string::npos) << law.proposal.equation;
    EXPECT_LT(law.proposal.errors.validate, 0.85 * validationError(finding.baseline));
}

}  // namespace
}  // namespace analogon
