#include "core/flat/measured_variables.hpp"

#include "core/library/measured_signals.hpp"
#include "flat_support.hpp"

namespace analogon {
namespace {

constexpr const char* rig = R"(
  block Step parameter Real height = 1; parameter Real t0 = 0.5; Parts.RealOutput y;
    equation y = if time < t0 then 0 else height; end Step;
  model M
    Step step;
    Parts.Gain gain(k = 2);
    Parts.Torque drive;
    Parts.Inertia rotor;
    Parts.SpeedSensor tacho;
    Integer n = 3;
  equation
    connect(step.y, gain.u);
    connect(gain.y, drive.tau);
    connect(drive.flange, rotor.a);
    connect(rotor.b, tacho.flange);
  end M;)";

FlatModel measured(std::vector<std::string> compared, std::vector<std::string> driven) {
    const Library library = test::libraryOf(rig).withMeasured({"M", std::move(compared), std::move(driven)});
    const Outcome<FlatModel> flat = flatten(library, "M");
    EXPECT_TRUE(flat) << format(flat.diagnostics());
    return flat ? *flat : FlatModel{};
}

FlatCausality causalityOf(const FlatModel& flat, const std::string& name) {
    return test::variable(flat, name).causality;
}

TEST(MeasuredVariables, AreOutputsOfTheModel) {
    const FlatModel flat = measured({"rotor.w", "drive.flange.tau"}, {});
    EXPECT_EQ(causalityOf(flat, "rotor.w"), FlatCausality::Output);
    EXPECT_EQ(causalityOf(flat, "drive.flange.tau"), FlatCausality::Output);
    EXPECT_EQ(causalityOf(flat, "rotor.phi"), FlatCausality::Local);
}

TEST(MeasuredVariables, ARecordingDrivesInPlaceOfASource) {
    const FlatModel flat = measured({}, {"step.y"});
    EXPECT_EQ(causalityOf(flat, "step.y"), FlatCausality::Input);
    EXPECT_EQ(flat.equations.size() + 1, measured({}, {}).equations.size());
    for (const std::string& equation : test::equations(flat)) EXPECT_EQ(equation.find("step.t0"), std::string::npos);
}

// A gain has an input of its own, a sensor a flange; a parameter is none.
TEST(MeasuredVariables, StayWhatTheyAreWhereTheyCannotBeIt) {
    const FlatModel flat = measured({"n", "gain.k", "nowhere"}, {"gain.y", "tacho.w", "rotor.w"});
    for (const char* name : {"n", "gain.k", "gain.y", "tacho.w", "rotor.w"})
        EXPECT_EQ(causalityOf(flat, name), FlatCausality::Local) << name;
}

}  // namespace
}  // namespace analogon
