#include <cmath>
#include <cstdio>

#include "tests/verification/model_runs.hpp"

/// Initial value problems written as Modelica text, against values computed in quadruple precision (the first digits
/// are those of the published test set).
namespace analogon {
namespace {

using test::compiled;
using test::modelLibrary;
using test::run;

struct Point {
    double time;
    std::vector<double> values;  // in the order of the model's outputs
};
struct Problem {
    const char* model;
    std::vector<Point> points;
    double smallest{1e-3};  // values that still count: the absolute tolerance, as a part of the relative one
};

const Problem robertson{"Robertson",
                        {
                            {40, {0.7158270687194050, 9.1855347645577643e-06, 0.2841637457458303}},
                            {400000, {0.0049382745209798, 1.9849940879543756e-08, 0.9950617056290793}},
                            {400000000, {5.2077021035731726e-06, 2.0830915594153648e-11, 0.9999947922770655}},
                            {1e+11, {2.0833401497012941e-08, 8.3333607703347838e-14, 0.9999999791665151}},
                        }};
const Problem vanDerPol{"VanDerPol",
                        {
                            {2000, {1.7061677321704650, -0.000892809701024}},
                        }};
const Problem hires{"Hires",
                    {
                        {321.8122,
                         {0.0007371312573325, 0.0001442485726316, 5.8887297409675752e-05, 0.0011756513432831,
                          0.0023863561988313, 0.0062389682527427, 0.0028499983951857, 0.0028500016048142}},
                    }};
const Problem oregonator{"Oregonator",
                         {
                             {360, {1.0008148703185227, 1228.1785215498879, 132.05549428465082}},
                         }};
const Problem transistorAmplifier{
    "TransistorAmplifier",
    {
        {0.2,
         {-0.005562145012262, 3.0065224719030426, 2.8499587886081285, 2.9264225362062415, 2.7046178650105545,
          2.7618377783931440, 4.7709276316167721, 1.2369958680915475}},
    }};
const Problem akzoNobel{"AkzoNobel",
                        {
                            {180,
                             {0.1150794920661702, 0.0012038314715677, 0.1611562887407974, 0.0003656156421249,
                              0.0170801088526440, 0.0048735313103074}},
                        }};
const Problem pendulum{
    "Pendulum",
    {
        {1, {-0.986291751131875, -0.165010853125541, -0.296905515916315, 1.7746436411126556, 4.8562694074846765}},
        {2, {0.7935661953433217, -0.608483930443791, 2.1024378744361257, 2.7419353930105090, 17.907682072960784}},
        {5, {0.9423054350437573, -0.334754338414000, -0.857904256885949, -2.414928654370488, 9.8518201795240370}},
        {10, {0.2750874625761168, -0.961419205099125, -4.175598100951728, -1.194749054560475, 28.294567206067250}},
    }};
const Problem dcMotor{"DcMotor",
                      {
                          {0.01, {3.8279371558211822, 154.97154824203935}},
                          {0.05, {0.0919051893736189, 237.86807487039990}},
                          {0.1, {0.0513166046185613, 238.76865792357262}},
                          {0.5, {0.0511750779209107, 238.77179812989814}},
                      }};
const Problem heatChain{
    "HeatChain",
    {
        {60,
         {100.632838651322191, 82.880242180154989, 67.3193556803442449, 53.8411251003002207, 42.2875333973441285,
          32.4575745558360462, 24.1141856232327085, 16.9914980862000262, 10.8018599196066191, 5.24225813089488785}},
    }};

/// Correct digits: -log10 of the largest relative error of all components at all points.
double digits(const Problem& problem, double tolerance) {
    static const Library library = modelLibrary("InitialValueProblems.mo");
    const SystemPtr system = compiled(library, std::string("InitialValueProblems.") + problem.model);
    if (!system) return 0;
    std::vector<double> times{0};
    for (const Point& p : problem.points) times.push_back(p.time);
    SimulationOptions options;
    options.relativeTolerance = tolerance;
    options.absoluteTolerance = tolerance * problem.smallest;
    const Trajectory trajectory = run(*system, times, options);
    EXPECT_FALSE(trajectory.failure.failed)
        << trajectory.failure.reason << " " << trajectory.failure.variable << " at " << trajectory.failure.time;
    double worst = 0;
    for (std::size_t k = 0; k < problem.points.size(); ++k)
        for (std::size_t i = 0; i < problem.points[k].values.size(); ++i) {
            const double exact = problem.points[k].values[i];
            const double y = trajectory.outputs(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k) + 1);
            worst = std::max(worst, std::fabs(y - exact) / std::fabs(exact));
        }
    return std::isfinite(worst) ? -std::log10(worst) : 0;
}

void expectDigits(const Problem& problem, bool isExemptAtTheEnd = false) {
    const double at6 = digits(problem, 1e-6), at8 = digits(problem, 1e-8), at10 = digits(problem, 1e-10);
    std::printf("%-20s %5.1f %5.1f %5.1f digits\n", problem.model, at6, at8, at10);
    EXPECT_GE(at6, 3.5);
    EXPECT_GE(at8, 5.5);
    EXPECT_GE(at10, isExemptAtTheEnd ? 5.5 : 7.0);
}

TEST(InitialValueProblem, Robertson) { expectDigits({"Robertson", robertson.points, 1e-9}); }
TEST(InitialValueProblem, RobertsonAsADifferentialAlgebraicSystem) {
    expectDigits({"RobertsonConserved", robertson.points, 1e-9});
}
TEST(InitialValueProblem, VanDerPol) { expectDigits(vanDerPol); }
TEST(InitialValueProblem, Hires) { expectDigits(hires); }
TEST(InitialValueProblem, Oregonator) { expectDigits(oregonator); }
TEST(InitialValueProblem, TransistorAmplifier) { expectDigits(transistorAmplifier, true); }
TEST(InitialValueProblem, AkzoNobel) { expectDigits(akzoNobel); }
TEST(InitialValueProblem, Pendulum) { expectDigits(pendulum); }
TEST(InitialValueProblem, DcMotor) { expectDigits(dcMotor); }
TEST(InitialValueProblem, HeatChain) { expectDigits(heatChain); }

}  // namespace
}  // namespace analogon
