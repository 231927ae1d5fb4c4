#include "core/study/generate.hpp"

#include <cmath>

#include "core/flat/flat_model.hpp"
#include "core/measure/open/read_table.hpp"
#include "core/measure/text/text_recording.hpp"
#include "core/study/column_guess.hpp"
#include "core/study/start_guess.hpp"
#include "mdf_recording.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::shared_ptr<const Table> tableOf(const std::string& text, const std::string& name = "run.csv") {
    Outcome<Table> table = textTables(text, name);
    EXPECT_TRUE(table.hasValue()) << format(table.diagnostics());
    return std::make_shared<const Table>(table ? *table : Table{});
}

/// A heater of 4 Ohm in an exhaust of 500 degC: the current falls while it warms up.
std::shared_ptr<const Table> lambdaTable(const std::string& name = "lambda.csv") {
    std::string text = "t [s],T_exhaust [degC],i_heater [mA],u_heater [V],u_bat [V]\n";
    for (int k = 0; k <= 400; ++k) {
        const double t = 0.1 * k, u = k % 100 < 80 ? 10 : 6;
        text += std::to_string(t) + "," + std::to_string(500 + 5 * std::sin(t)) + "," +
                std::to_string(1000 * u / (4 * (1.8 - 0.8 * std::exp(-t / 8)))) + "," + std::to_string(u) + ",13.5\n";
    }
    return tableOf(text, name);
}

/// A pump motor: R = 0.5 Ohm, k = 0.03 V.s, load 1e-5 N.m.s2.
std::shared_ptr<const Table> pumpTable() {
    std::string text = "time_s,U_M [V],I_M [A],n_pump [rpm]\n";
    double w = 0;
    for (int k = 0; k <= 1000; ++k) {
        const double t = 0.01 * k, u = t < 0.5 ? 0 : t < 5 ? 12 : 8;
        const double i = (u - 0.03 * w) / 0.5;
        w += 0.01 * (0.03 * i - 1e-5 * w * w) / 2e-4;
        text += std::to_string(t) + "," + std::to_string(u) + "," + std::to_string(i) + "," +
                std::to_string(w * 9.5492966) + "\n";
    }
    return tableOf(text, "pump.csv");
}

GeneratedStudy generated(const std::vector<std::string>& domains, std::vector<std::shared_ptr<const Table>> tables) {
    GenerateRequest request;
    request.domains = domains;
    request.recordings = std::move(tables);
    request.className = "Made";
    const Outcome<Library> library = builtInLibrary();
    EXPECT_TRUE(library.hasValue());
    Outcome<GeneratedStudy> out = generateStudy(*library, request);
    EXPECT_TRUE(out.hasValue()) << format(out.diagnostics());
    return out ? *out : GeneratedStudy{};
}

Diagnostic faultOf(const std::vector<std::string>& domains, const std::shared_ptr<const Table>& table) {
    GenerateRequest request;
    request.domains = domains;
    request.recordings = {table};
    const Outcome<GeneratedStudy> out = generateStudy(*builtInLibrary(), request);
    EXPECT_FALSE(out.hasValue());
    return out ? Diagnostic{} : out.diagnostics().front();
}

EstimationTask taskOf(const Study& study) {
    Outcome<EstimationTask> task = estimationTask(study);
    EXPECT_TRUE(task.hasValue()) << format(task.diagnostics()) << study.models.at("model.mo");
    return task ? *task : EstimationTask{};
}

using GenerateFiles = analogon::test::StudyTest;

TEST(Generate, ComposesAHeatedSensor) {
    const GeneratedStudy made = generated({"electric-thermal", "thermal-fluid"}, {lambdaTable()});
    const std::string& text = made.study.models.at("model.mo");
    for (const char* part : {"Analogon.ElectricThermal.BasicElectricThermal heater",
                             "Analogon.ThermalFluid.BasicThermalFluid body", "connect(heater.heatPort, body.solid)",
                             "Analogon.Sources.PrescribedTemperature ambient", "Placement(transformation(extent="})
        EXPECT_THAT(text, HasSubstr(part));
    const EstimationTask task = taskOf(made.study);
    ASSERT_EQ(task.recordings.size(), 2u);
    EXPECT_EQ(task.recordings[0].role, Role::Fit);
    EXPECT_EQ(task.recordings[1].role, Role::Validate);
    EXPECT_NEAR(task.recordings[0].time.back(), 28, 0.2);
    EXPECT_THAT(task.recordings[0].inputNames, ElementsAre("v", "T_amb"));
    EXPECT_NEAR(task.recordings[0].inputs(0, 0), 10, 1e-9);
    EXPECT_NEAR(task.recordings[0].inputs(1, 0), 773.15, 1e-6);
    EXPECT_NEAR(task.recordings[0].outputs(0, 0), 2.5, 1e-3);
    EXPECT_EQ(task.recordings[0].spares.size(), 1u);  // the battery
}

TEST(Generate, TakesStartValuesFromTheData) {
    const GeneratedStudy made = generated({"electric-thermal", "thermal-fluid"}, {lambdaTable()});
    for (const FitParameter& parameter : taskOf(made.study).parameters) {
        EXPECT_GE(parameter.start, parameter.min) << parameter.name;
        EXPECT_LE(parameter.start, parameter.max) << parameter.name;
        if (parameter.name == "heater.R") {
            EXPECT_GT(parameter.start, 3.9);
            EXPECT_LT(parameter.start, 7.3);
        }
    }
    EXPECT_TRUE(made.study.parameters.contains("body.C"));
    EXPECT_TRUE(made.study.parameters.contains("body.c_o"));
    EXPECT_FALSE(made.study.parameters.contains("body.A"));
    EXPECT_EQ(std::get<ColumnStart>(made.study.experiments[0].initial.at("body.T_start")).column, "T_exhaust");
}

TEST(Generate, DoesNotDependOnTheOrderOfTheDomains) {
    const GeneratedStudy made = generated({"thermal-fluid", "electric-thermal"}, {lambdaTable()});
    EXPECT_THAT(made.study.models.at("model.mo"), HasSubstr("connect(heater.heatPort, body.solid)"));
    taskOf(made.study);
}

TEST(Generate, ComposesAPumpWithLoadAndSpeedSensor) {
    const GeneratedStudy made = generated({"electric-mechanical", "mechanics"}, {pumpTable()});
    const std::string& text = made.study.models.at("model.mo");
    for (const char* part : {"connect(motor.flange, mechanics.flange_a)", "Analogon.Mechanics.QuadraticLoad load",
                             "connect(mechanics.flange_b, load.flange)", "Analogon.Sensors.SpeedSensor"})
        EXPECT_THAT(text, HasSubstr(part));
    const EstimationTask task = taskOf(made.study);
    EXPECT_THAT(task.recordings.all().at(0).outputNames, ::testing::UnorderedElementsAre("i", "w"));
    std::map<std::string, double> start;
    for (const FitParameter& parameter : task.parameters) start[parameter.name] = parameter.start;
    EXPECT_NEAR(start.at("motor.k"), 0.03, 0.01);
    EXPECT_GT(start.at("motor.R"), 0.2);
    EXPECT_LT(start.at("motor.R"), 3);
    EXPECT_NEAR(std::log10(start.at("load.k_q")), -5, 0.7);
    EXPECT_NEAR(std::log10(start.at("mechanics.J1")), std::log10(2e-4), 1.5);
    EXPECT_THAT(made.assumptions, Contains(HasSubstr("'time_s' is the time")));
}

TEST(Generate, PutsAnInertiaOnAMotorAlone) {
    const GeneratedStudy made = generated({"electric-mechanical"}, {pumpTable()});
    EXPECT_THAT(made.study.models.at("model.mo"), HasSubstr("connect(motor.flange, rotor.flange_a)"));
    EXPECT_TRUE(made.study.parameters.contains("rotor.J"));
    taskOf(made.study);
}

TEST(Generate, JoinsDomainsThatAreNotNeighbours) {
    const GeneratedStudy made =
        generated({"electric-mechanical", "thermal-fluid", "mechanic-thermal"},
                  {tableOf("t [s],u [V],i [A],n [rpm],T_air [degC],T_housing [degC]\n0,0,0,0,20,20\n1,12,1,3000,20,21\n"
                           "2,12,1,3100,20,22\n3,12,1,3100,20,23\n")});
    const std::string& text = made.study.models.at("model.mo");
    EXPECT_THAT(text, HasSubstr("connect(bearing.heatPort, body.solid)"));
    EXPECT_THAT(text, HasSubstr("connect(motor.flange, bearing.flange_a)"));
    const Study& study = made.study;
    EXPECT_EQ(study.experiments[0].inputs.at("T_amb").column, "T_air");
    EXPECT_EQ(study.experiments[0].outputs.at("T").column, "T_housing");
    EXPECT_EQ(std::get<ColumnStart>(study.experiments[0].initial.at("body.T_start")).column, "T_housing");
    taskOf(study);
}

TEST(Generate, SuppliesADutyCycleAndGuessesUnitsFromNames) {
    const GeneratedStudy made =
        generated({"electric-thermal", "thermal-fluid"},
                  {tableOf("time_s,heater1_pct,T1_degC\n0,0,21\n1,50,21.5\n2,50,22\n3,100,23\n4,100,24\n5,0,25\n")});
    EXPECT_THAT(made.study.models.at("model.mo"), HasSubstr("Analogon.Signals.Gain supply(k=12)"));
    EXPECT_THAT(made.study.models.at("model.mo"), HasSubstr("Analogon.Sources.FixedTemperature"));
    const EstimationTask task = taskOf(made.study);
    EXPECT_THAT(task.recordings[0].outputNames, ElementsAre("T"));
    EXPECT_NEAR(task.recordings[0].outputs(0, 0), 294.15, 1e-9);
    EXPECT_NEAR(task.recordings[0].inputs(0, 1), 0.5, 1e-12);
}

TEST(Generate, ValidatesOnTheLastOfSeveralRecordings) {
    const GeneratedStudy made =
        generated({"electric-thermal", "thermal-fluid"}, {lambdaTable("a.csv"), lambdaTable("b.csv")});
    ASSERT_EQ(made.study.experiments.size(), 2u);
    EXPECT_EQ(made.study.experiments[1].name, "b");
    EXPECT_EQ(made.study.experiments[1].role, Role::Validate);
    EXPECT_FALSE(made.study.experiments[0].range);
}

TEST(Generate, SplitsOneRecordingWhereItIsAtRest) {
    std::string text = "t [s],u [V],i [A]\n";
    for (int k = 0; k < 1000; ++k) {
        const double u = k > 10 && (k < 750 || k > 790) ? 5 : 0;
        text += std::to_string(0.01 * k) + "," + std::to_string(u) + "," + std::to_string(u / 4) + "\n";
    }
    const Study study = generated({"electric-thermal"}, {tableOf(text)}).study;
    EXPECT_GE(study.experiments.at(0).range->second, 7.5);
    EXPECT_LE(study.experiments.at(0).range->second, 7.9);
    EXPECT_EQ(study.experiments.at(1).range->first, study.experiments.at(0).range->second);
    EXPECT_EQ(study.experiments.at(1).role, Role::Validate);
}

TEST(Generate, NamesWhatItCannotDo) {
    const Diagnostic unknown = faultOf({"electric-termal"}, lambdaTable());
    EXPECT_EQ(unknown.message, "the domain 'electric-termal' is not known");
    EXPECT_THAT(unknown.hint, HasSubstr("Did you mean 'electric-thermal'?"));
    EXPECT_THAT(faultOf({"electric-thermal", "mechanics"}, lambdaTable()).message,
                HasSubstr("no connector joins mechanics"));
    EXPECT_THAT(faultOf({"electric-thermal"}, tableOf("t [s],u [V]\n0,1\n1,2\n")).message,
                HasSubstr("could be compared with"));
    EXPECT_THAT(faultOf({"electric-thermal"}, tableOf("t [s],x [m]\n0,1\n1,2\n")).message,
                HasSubstr("a voltage [V] is needed"));
    EXPECT_THAT(faultOf({"electric-thermal"}, tableOf("u [V],i [A]\n0,1\n0,2\n")).message,
                HasSubstr("can be the time"));
    EXPECT_THAT(faultOf({"electric-thermal"}, tableOf("time_ms,u [V]\n0,1\n1,2\n")).message,
                HasSubstr("could be compared with"))
        << "the time is in the unit that its name tells";
}

TEST_F(GenerateFiles, AreAStudyThatReadsBack) {
    put("lambda.csv", writeCsv(*lambdaTable()));
    const Outcome<Table> table = readTable(directory_ / "lambda.csv");
    ASSERT_TRUE(table.hasValue());
    const GeneratedStudy made =
        generated({"electric-thermal", "thermal-fluid"}, {std::make_shared<const Table>(*table)});
    const Outcome<Done> done = writeStudy(made.study, directory_ / "out");
    ASSERT_TRUE(done.hasValue()) << format(done.diagnostics());
    EXPECT_EQ(get(directory_ / "out" / "lambda.csv"), get(directory_ / "lambda.csv"));
    const Outcome<Study> again = readStudy(directory_ / "out");
    ASSERT_TRUE(again.hasValue()) << format(again.diagnostics());
    EXPECT_TRUE(again.diagnostics().empty());
    EXPECT_EQ(again->experiments[0].file, "lambda.csv");
    taskOf(*again);
}

TEST_F(GenerateFiles, TakeAnMdfFileWithSeveralRasters) {
    const Table table = *lambdaTable();
    std::vector<analogon::test::MdfGroup> groups{{"outputs", {}}, {"inputs", {}}};
    const Column& time = table.columns.front();
    std::vector<double> twice;  // the inputs are sampled twice as often
    for (std::size_t k = 0; k + 1 < time.values.size(); ++k)
        for (const double part : {0.0, 0.5}) twice.push_back((1 - part) * time.values[k] + part * time.values[k + 1]);
    twice.push_back(time.values.back());
    groups[0].channels.push_back({"t", time.unit, time.values});
    groups[1].channels.push_back({"t", time.unit, twice});
    for (std::size_t c = 1; c < table.columns.size(); ++c) {
        const Column& column = table.columns[c];
        if (column.name.starts_with("i")) {
            groups[0].channels.push_back({column.name, column.unit, column.values});
            continue;
        }
        std::vector<double> values;
        for (std::size_t k = 0; k + 1 < column.values.size(); ++k)
            for (const double part : {0.0, 0.5})
                values.push_back((1 - part) * column.values[k] + part * column.values[k + 1]);
        values.push_back(column.values.back());
        groups[1].channels.push_back({column.name, column.unit, values});
    }
    analogon::test::putMdf(directory_ / "lambda.mf4", groups);
    const Outcome<Table> read = readTable(directory_ / "lambda.mf4");
    ASSERT_TRUE(read.hasValue()) << format(read.diagnostics());
    const GeneratedStudy made =
        generated({"electric-thermal", "thermal-fluid"}, {std::make_shared<const Table>(*read)});
    const Outcome<Done> done = writeStudy(made.study, directory_ / "out");
    ASSERT_TRUE(done.hasValue()) << format(done.diagnostics());
    EXPECT_EQ(get(directory_ / "out" / "lambda.mf4"), get(directory_ / "lambda.mf4"));
    const Outcome<Study> again = readStudy(directory_ / "out");
    ASSERT_TRUE(again.hasValue()) << format(again.diagnostics());
    const EstimationTask task = taskOf(*again);
    ASSERT_FALSE(task.recordings.empty());
    EXPECT_EQ(again->experiments[0].outputs.begin()->second.group.name, "outputs");
    EXPECT_EQ(again->experiments[0].inputs.begin()->second.group.name, "inputs");
}

TEST(ColumnGuess, TellsQuantitiesApart) {
    const auto columns =
        guessColumns(*tableOf("T_air [K],U_bat [V],zeit [ms],phi [deg],n [1/min],p [hPa],M [Nm],P [W],d [%]\n"
                              "290,13,0,0,0,1000,0,1,5\n290,13,10,9,0,1000,0,1,5\n"));
    std::vector<Quantity> quantities;
    for (const GuessedColumn& column : columns) quantities.push_back(column.quantity);
    EXPECT_THAT(quantities,
                ElementsAre(Quantity::Time, Quantity::Temperature, Quantity::Voltage, Quantity::Angle, Quantity::Speed,
                            Quantity::Other, Quantity::Torque, Quantity::HeatFlow, Quantity::Other));
    EXPECT_TRUE(columns[1].isSurroundings);
    EXPECT_TRUE(columns[2].isSupply);
    EXPECT_NEAR(columns[0].values[1], 0.01, 1e-12);
}

TEST(ColumnGuess, ReadsUnitsFromNames) {
    const auto columns =
        guessColumns(*tableOf("time_s,motor_voltage_V,motor_speed_rad_s,u,current\n0,1,2,3,4\n1,1,2,3,4\n"));
    EXPECT_EQ(columns[1].unit, "V");
    EXPECT_EQ(columns[2].unit, "rad/s");
    EXPECT_EQ(columns[3].unit, "V");
    EXPECT_EQ(columns[4].quantity, Quantity::Current);
    EXPECT_TRUE(columns[4].isUnitAssumed);
    EXPECT_EQ(columns[4].mapping().unit, "A");
}

TEST(ColumnGuess, TakesNoCounterForATimeThatRepeats) {
    const auto table =
        tableOf("No,time [ms],u [V],i [A]\n1,0,0,0\n2,100,12,1\n3,200,12,2\n4,300,12,2.5\n5,300,12,2.7\n");
    const auto columns = guessColumns(*table);
    EXPECT_EQ(columns.front().name, "time");
    EXPECT_EQ(columns.front().quantity, Quantity::Time);
    for (std::size_t i = 1; i < columns.size(); ++i) EXPECT_NE(columns[i].quantity, Quantity::Time) << columns[i].name;
    // without a time, a counter may stand for it
    EXPECT_EQ(guessColumns(*tableOf("No,u [V]\n1,0\n2,12\n3,12\n")).front().name, "No");
}

TEST(StartGuess, FindsTheTimeInWhichASignalChanges) {
    std::vector<double> time, signal;
    for (int k = 0; k < 5000; ++k) {
        time.push_back(0.01 * k);
        signal.push_back(std::sin(2 * M_PI * 0.01 * k / 10));  // period 10 s
    }
    EXPECT_NEAR(changeTime(time, signal), 10.0 / 6, 0.4);
}

TEST(StartGuess, UsesUsualValuesWithoutData) {
    const StartGuess guess = guessResistance({});
    EXPECT_TRUE(guess.reason.empty());
    EXPECT_GT(guess.value, guess.min);
    EXPECT_LT(guess.value, guess.max);
}

}  // namespace
}  // namespace analogon
