#include <cmath>

#include "tests/verification/model_runs.hpp"

/// Constraints between states that no incidence tells, or that no fixed choice of states can serve.
namespace analogon {
namespace {

using test::compiled;
using test::evenly;
using test::modelLibrary;
using test::run;

Library libraryWith(const std::string& text) {
    Outcome<Library> library = builtInLibrary();
    library = library->withSource(std::make_shared<const Source>("model.mo", text));
    EXPECT_TRUE(library) << format(library.diagnostics());
    return library ? *library : Library();
}

std::vector<std::string> statesOf(const System& system) {
    std::vector<std::string> names;
    for (const SignalInfo& s : system.states()) names.push_back(s.name);
    return names;
}

/// Largest |x^2 + y^2 - 1| over ten seconds.
double drift(const System& system) {
    SimulationOptions options;
    options.relativeTolerance = 1e-8;
    options.absoluteTolerance = 1e-10;
    const Trajectory t = run(system, evenly(0, 10, 1001), options);
    EXPECT_FALSE(t.failure.failed) << t.failure.reason;
    double worst = 0;
    for (Eigen::Index k = 0; k < t.outputs.cols(); ++k)
        worst = std::max(worst, std::fabs(std::hypot(t.outputs(0, k), t.outputs(1, k)) - 1));
    return worst;
}

TEST(Constraint, OfAPendulumDoesNotDrift) {
    const SystemPtr system = compiled(modelLibrary("InitialValueProblems.mo"), "InitialValueProblems.Pendulum");
    ASSERT_TRUE(system);
    const double worst = drift(*system);
    std::printf("constraint drift of the pendulum over 10 s: %.1e\n", worst);
    EXPECT_LT(worst, 1e-6);
}

/// Start values for all four where two are free: those that the constraint can be solved without count.
TEST(Constraint, TakesRedundantFixedStartValues) {
    const SystemPtr system = compiled(modelLibrary("InitialValueProblems.mo"), "InitialValueProblems.PendulumFixed");
    ASSERT_TRUE(system);
    EXPECT_LT(drift(*system), 1e-6);
}

TEST(Constraint, HonoursTheStatesThatTheModelChooses) {
    const Library library = libraryWith(R"(
model M
  Real x(start = 0.1, stateSelect = StateSelect.prefer);
  Real y(start = -1);
  Real vx(start = 0, stateSelect = StateSelect.prefer);
  Real vy;
  Real F;
equation
  der(x) = vx;
  der(y) = vy;
  der(vx) = -F*x;
  der(vy) = -F*y - 9.81;
  x^2 + y^2 = 1;
end M;
)");
    const SystemPtr system = compiled(library, "M");
    ASSERT_TRUE(system);
    EXPECT_EQ(statesOf(*system), (std::vector<std::string>{"x", "vx"}));
}

/// C1*(der(a) - der(b)) = i twice over: the currents are equal, one voltage alone is a state.
TEST(Constraint, HiddenInCancellingDerivativesIsFound) {
    for (const bool isKept : {false, true}) {
        const Library library = libraryWith(R"(
model M
  parameter Real C = 0.5;
  parameter Real R = 2;
  Real a(start = 1);
  Real b;
  output Real v;
equation
  C*(der(a) - der(b)) = -a/R;
  C*(der(b) - der(a)) = -b/R;
  v = a - b;
end M;
)");
        const Outcome<SystemPtr> system = compile(library, "M", isKept ? StructureOptions{{"C"}} : StructureOptions{});
        ASSERT_TRUE(system) << format(system.diagnostics());
        ASSERT_EQ((*system)->stateCount(), 1);
        SampledInputs inputs;
        inputs.time = {0, 1};
        inputs.values.resize(0, 2);
        SimulationTask task;
        task.system = system->get();
        task.inputs = &inputs;
        if (isKept) task.parameters = {0.5};
        SimulationOptions options;
        options.engine = Engine::Adaptive;
        const Trajectory t = simulate(task, options);
        ASSERT_FALSE(t.failure.failed) << t.failure.reason;
        // a = -b, 2*C*der(a) = -a/R
        EXPECT_NEAR(t.outputs(0, 1), 2 * std::exp(-0.5), 1e-6);
    }
}

}  // namespace
}  // namespace analogon
