#include "core/simulate/recorded_events.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/eval/event_parts.hpp"

namespace analogon {
namespace {

/// The class M of a text, with these parameters symbolic; 101 samples over 1 s.
struct Driven {
    SystemPtr system;
    SampledInputs inputs;
    std::vector<double> parameters;

    Driven(const std::string& text, const std::vector<std::string>& kept) {
        const auto library = Library().withSource(std::make_shared<const Source>("m.mo", text));
        if (!library) throw std::runtime_error(format(library.diagnostics()));
        const Outcome<FlatModel> flat = flatten(*library, "M");
        if (!flat) throw std::runtime_error(format(flat.diagnostics()));
        EXPECT_FALSE(flat->events.refusals.empty());
        Structure structure;
        const Outcome<SystemPtr> built = buildWithEvents(*flat, kept, structure);
        if (!built) throw std::runtime_error(format(built.diagnostics()));
        system = *built;
        for (int k = 0; k <= 100; ++k) inputs.time.push_back(k * 0.01);
        inputs.values = Eigen::MatrixXd::Zero(system->inputCount(), 101);
        for (const SignalInfo& p : system->parameters()) parameters.push_back(p.value);
    }
    double& operator[](const std::string& name) {
        return parameters.at(static_cast<std::size_t>(system->parameterIndex(name)));
    }
    Trajectory run(const std::vector<std::string>& along = {}) const {
        SimulationTask task;
        task.system = system.get();
        task.inputs = &inputs;
        task.parameters = parameters;
        task.directions = Eigen::MatrixXd::Zero(system->parameterCount(), static_cast<Eigen::Index>(along.size()));
        for (std::size_t k = 0; k < along.size(); ++k)
            task.directions(system->parameterIndex(along[k]), static_cast<Eigen::Index>(k)) = 1;
        SimulationOptions options;
        options.relativeTolerance = 1e-8;
        return simulate(task, options);
    }
    /// The greatest distance of a tangent from differences, over the greatest difference.
    double tangentError(const std::string& name, double h, int output = 0) {
        const Trajectory here = run({name});
        EXPECT_FALSE(here.failure.failed) << here.failure.cause.english();
        const double value = (*this)[name];
        (*this)[name] = value + h;
        const Trajectory up = run();
        (*this)[name] = value - h;
        const Trajectory down = run();
        (*this)[name] = value;
        const Eigen::VectorXd slope = (up.outputs.row(output) - down.outputs.row(output)).transpose() / (2 * h);
        const Eigen::VectorXd off = here.tangents.at(static_cast<std::size_t>(output)).col(0) - slope;
        return off.cwiseAbs().maxCoeff() / slope.cwiseAbs().maxCoeff();
    }
};

constexpr const char* ballText = R"(model M
  parameter Real g = 9.81;
  parameter Real e = 0.8;
  Real h(start = 1, fixed = true);
  Real v(start = 0, fixed = true);
  output Real y = h;
equation
  der(h) = v;
  der(v) = -g;
  when h <= 0 then
    reinit(v, -e*pre(v));
  end when;
end M;
)";

TEST(RecordedEvents, TangentsOfABouncingBallAreThoseOfTheFormula) {
    Driven ball(ballText, {"g", "e"});
    const Trajectory run = ball.run({"g", "e"});
    ASSERT_FALSE(run.failure.failed) << run.failure.cause.english();
    const auto height = [](double t, double g, double e) {
        const double t1 = std::sqrt(2 / g);
        return t < t1 ? 1 - g * t * t / 2 : e * g * t1 * (t - t1) - g * (t - t1) * (t - t1) / 2;
    };
    constexpr double h = 1e-6;
    for (const int k : {20, 44, 46, 60, 80, 100}) {
        const double t = 0.01 * k;
        EXPECT_NEAR(run.outputs(0, k), height(t, 9.81, 0.8), 1e-6) << t;
        EXPECT_NEAR(run.tangents[0](k, 0), (height(t, 9.81 + h, 0.8) - height(t, 9.81 - h, 0.8)) / (2 * h), 1e-5) << t;
        EXPECT_NEAR(run.tangents[0](k, 1), (height(t, 9.81, 0.8 + h) - height(t, 9.81, 0.8 - h)) / (2 * h), 1e-5) << t;
    }
}

TEST(RecordedEvents, TangentsGoThroughWhatIsSampled) {
    Driven held(R"(model M
  parameter Real k = 2;
  parameter Real T = 0.3;
  input Real u;
  Real x(start = 1, fixed = true);
  discrete Real z(start = 0, fixed = true);
  output Real y = z;
equation
  T*der(x) = u - x;
  when sample(0, 0.1) then
    z = k*x + pre(z)/2;
  end when;
end M;
)",
                {"k", "T"});
    for (int k = 0; k <= 100; ++k) held.inputs.values(0, k) = k < 40 ? 0 : 3;
    EXPECT_LT(held.tangentError("k", 1e-4), 1e-5);
    EXPECT_LT(held.tangentError("T", 1e-4), 1e-4);
    const Trajectory run = held.run();
    EXPECT_NEAR(run.outputs(0, 0), 2, 1e-9);            // what is behind the event at the start
    EXPECT_EQ(run.outputs(0, 13), run.outputs(0, 17));  // and held
    EXPECT_NEAR(run.outputs(0, 10), 2 * std::exp(-0.1 / 0.3) + 1, 1e-6);
}

/// Dry friction that sticks and slides, with the modes of sliding as discrete variables.
constexpr const char* frictionText = R"(model M
  parameter Real J = 0.2;
  parameter Real c = 0.5;
  parameter Real b = 0.1;
  input Real u;
  output Real y = w;
  Real w(start = 0, fixed = true);
  Real f;
  Integer mode(start = 0, fixed = true);
equation
  J*der(w) = u - f;
  f = if mode == 0 then u else mode*c + b*w;
  when mode == 1 and w < 0 or mode == -1 and w > 0 then
    reinit(w, 0);
  end when;
algorithm
  when mode == 0 and u > c then
    mode := 1;
  elsewhen mode == 0 and u < -c then
    mode := -1;
  elsewhen mode == 1 and w < 0 or mode == -1 and w > 0 then
    mode := 0;
  end when;
end M;
)";

TEST(RecordedEvents, TangentsOfDryFrictionAreItsSlopes) {
    Driven shaft(frictionText, {"J", "c", "b"});
    for (int k = 0; k <= 100; ++k) shaft.inputs.values(0, k) = 1.5 * std::sin(0.12 * k);
    const Trajectory run = shaft.run();
    ASSERT_FALSE(run.failure.failed) << run.failure.cause.english();
    EXPECT_NEAR(run.outputs(0, 2), 0, 1e-12);  // it sticks
    EXPECT_GT(run.outputs.row(0).maxCoeff(), 0.5);
    EXPECT_LT(run.outputs.row(0).minCoeff(), -0.5);
    EXPECT_LT(shaft.tangentError("J", 1e-4), 2e-3);
    EXPECT_LT(shaft.tangentError("c", 1e-4), 2e-3);
    EXPECT_LT(shaft.tangentError("b", 1e-4), 2e-3);
}

TEST(RecordedEvents, AHeldSignalThatJumpsMakesAnEvent) {
    Driven counter(R"(model M
  input Real u;
  Integer n(start = 0, fixed = true);
  output Real y = n;
equation
  when u > 0.5 then
    n = pre(n) + 1;
  end when;
end M;
)",
                   {});
    counter.inputs.held = {1};
    for (int k = 0; k <= 100; ++k) counter.inputs.values(0, k) = k / 10 % 2;
    const Trajectory run = counter.run();
    ASSERT_FALSE(run.failure.failed) << run.failure.cause.english();
    EXPECT_EQ(run.outputs(0, 9), 0);
    EXPECT_EQ(run.outputs(0, 10), 1);
    EXPECT_EQ(run.outputs(0, 29), 1);
    EXPECT_EQ(run.outputs(0, 100), 5);
}

TEST(RecordedEvents, AnOutputMayBeAQuantityThatChangesAtEventsAlone) {
    Driven gate(R"(model M
  input Real u;
  output Integer y(start = 0, fixed = true);
equation
  when {u > 0.5, u < 0.2} then
    y = pre(y) + 1;
  end when;
end M;
)",
                {});
    for (int k = 0; k <= 100; ++k) gate.inputs.values(0, k) = k % 50 / 50.0;
    const Trajectory run = gate.run();
    ASSERT_FALSE(run.failure.failed) << run.failure.cause.english();
    EXPECT_EQ(run.outputs(0, 24), 0);
    EXPECT_EQ(run.outputs(0, 26), 1);
    EXPECT_EQ(run.outputs(0, 55), 2);
    EXPECT_EQ(run.outputs(0, 100), 4);
}

TEST(RecordedEvents, AnAssertionEndsTheSimulationWithItsMessage) {
    Driven limited(R"(model M
  parameter Real limit = 0.5;
  Real x(start = 0, fixed = true);
  output Real y = x;
  Boolean isWarm = x > 0.2;
equation
  der(x) = 1;
  assert(x < limit, "too far");
  when isWarm then
    reinit(x, x);
  end when;
end M;
)",
                   {"limit"});
    const Trajectory run = limited.run();
    ASSERT_TRUE(run.failure.failed);
    EXPECT_NEAR(run.failure.time, 0.5, 0.01);
    EXPECT_NE(run.failure.cause.english().find("too far"), std::string::npos) << run.failure.cause.english();
    EXPECT_NEAR(run.outputs(0, 40), 0.4, 1e-6);
    EXPECT_TRUE(std::isnan(run.outputs(0, 60)));
}

}  // namespace
}  // namespace analogon
