#include "core/export/fmu.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <quazip/JlCompress.h>

#include <QXmlStreamReader>
#include <cmath>
#include <cstdarg>
#include <cstdlib>
#include <fstream>
#include <random>

#include "core/archive/archive.hpp"
#include "core/eval/system.hpp"
#include "core/export/fmu/fmi2.h"
#include "core/simulate/simulate.hpp"

namespace analogon {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

Study example(const char* name) {
    Outcome<Study> study = readStudy(std::string(ANALOGON_ROOT "/examples/") + name);
    EXPECT_TRUE(study) << format(study.diagnostics());
    return std::move(*study);
}

/// A study of one model text without recordings.
Study studyOf(const std::string& text) {
    Study study;
    study.name = "test";
    study.className = "M";
    study.models["model.mo"] = text;
    return study;
}

bool hasCompiler() { return std::system("command -v cc > /dev/null 2>&1") == 0; }

// ---- an FMU unpacked, with what its modelDescription.xml says ----

struct Variable {
    std::string name, causality, variability, unit;
    fmi2ValueReference reference{};
    std::optional<double> start;
    int derivative{};  // position of the state, from 1; 0: none
};

struct Unpacked {
    std::shared_ptr<const TemporaryDirectory> place;
    fs::path directory;
    bool hasModelExchange{};
    std::string guid, identifier;
    int eventIndicators{};
    std::vector<Variable> variables;
    std::map<std::string, std::vector<int>> structure;  // "Outputs" … -> indices
    std::map<std::string, std::map<std::string, std::string>> units;
    std::map<std::string, std::string> experiment;

    const Variable& at(const std::string& name) const {
        for (const Variable& v : variables)
            if (v.name == name) return v;
        ADD_FAILURE() << "there is no variable " << name;
        return variables.front();
    }
    std::vector<Variable> derivatives() const {
        std::vector<Variable> out;
        for (const Variable& v : variables)
            if (v.derivative > 0) out.push_back(v);
        return out;
    }
};

void readDescription(Unpacked& fmu) {
    QFile file(QString::fromStdString((fmu.directory / "modelDescription.xml").string()));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    QXmlStreamReader xml(&file);
    std::string group, unit;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        const std::string element = xml.name().toString().toStdString();
        std::map<std::string, std::string> attributes;
        for (const QXmlStreamAttribute& a : xml.attributes())
            attributes[a.name().toString().toStdString()] = a.value().toString().toStdString();
        if (element == "fmiModelDescription") {
            EXPECT_EQ(attributes["fmiVersion"], "2.0");
            fmu.guid = attributes["guid"];
            fmu.eventIndicators = std::stoi(attributes["numberOfEventIndicators"]);
        } else if (element == "ModelExchange" || element == "CoSimulation") {
            fmu.identifier = attributes["modelIdentifier"];
            fmu.hasModelExchange = fmu.hasModelExchange || element == "ModelExchange";
        } else if (element == "ScalarVariable") {
            fmu.variables.push_back({attributes["name"],
                                     attributes["causality"],
                                     attributes["variability"],
                                     {},
                                     static_cast<fmi2ValueReference>(std::stoul(attributes["valueReference"])),
                                     {},
                                     0});
        } else if (element == "Real") {
            Variable& v = fmu.variables.back();
            v.unit = attributes["unit"];
            if (attributes.contains("start")) v.start = std::stod(attributes["start"]);
            if (attributes.contains("derivative")) v.derivative = std::stoi(attributes["derivative"]);
        } else if (element == "Unknown") {
            fmu.structure[group].push_back(std::stoi(attributes["index"]));
        } else if (element == "Unit") {
            unit = attributes["name"];
            fmu.units[unit];
        } else if (element == "BaseUnit") {
            fmu.units[unit] = attributes;
        } else if (element == "DefaultExperiment") {
            fmu.experiment = attributes;
        }
        group = element == "Unknown" ? group : element;
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
}

Unpacked exported(const Study& study) {
    Unpacked out;
    const Outcome<Fmu> fmu = fmuOf(study);
    EXPECT_TRUE(fmu) << format(fmu.diagnostics());
    out.place = *TemporaryDirectory::make();
    if (!fmu) return out;
    const fs::path file = out.place->path() / "model.fmu";
    const Outcome<Done> written = writeFmu(*fmu, file);
    EXPECT_TRUE(written) << format(written.diagnostics());
    out.directory = out.place->path() / "unpacked";
    EXPECT_FALSE(
        JlCompress::extractDir(QString::fromStdString(file.string()), QString::fromStdString(out.directory.string()))
            .isEmpty());
    readDescription(out);
    return out;
}

// ---- an instance of its binary ----

void logged(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String text, ...) {
    char message[512];
    va_list arguments;
    va_start(arguments, text);
    std::vsnprintf(message, sizeof message, text, arguments);
    va_end(arguments);
    std::printf("FMU: %s\n", message);
}

class Instance {
public:
    Instance(const Unpacked& fmu, fmi2Type type) : fmu_(fmu) {
        library_ =
            dlopen((fmu.directory / "binaries" / "linux64" / (fmu.identifier + ".so")).c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!library_) {
            ADD_FAILURE() << dlerror();
            return;
        }
        component_ = call<fmi2Component>("fmi2Instantiate", fmi2String("one"), type, fmi2String(fmu.guid.c_str()),
                                         fmi2String(""), static_cast<const fmi2CallbackFunctions*>(&callbacks_),
                                         fmi2Boolean(0), fmi2Boolean(1));
    }
    ~Instance() {
        if (component_) call<void>("fmi2FreeInstance", component_);
        if (library_) dlclose(library_);
    }
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    bool isThere() const { return component_ != nullptr; }
    template <class... Arguments>
    fmi2Status operator()(const char* name, Arguments... arguments) {
        return call<fmi2Status>(name, component_, arguments...);
    }
    void set(const std::string& name, double value) {
        const fmi2ValueReference reference = fmu_.at(name).reference;
        EXPECT_EQ((*this)("fmi2SetReal", &reference, std::size_t(1), static_cast<const double*>(&value)), fmi2OK);
    }
    void setSlope(const std::string& name, double value) {
        const fmi2ValueReference reference = fmu_.at(name).reference;
        const fmi2Integer order = 1;
        EXPECT_EQ((*this)("fmi2SetRealInputDerivatives", &reference, std::size_t(1), &order,
                          static_cast<const double*>(&value)),
                  fmi2OK);
    }
    double get(const std::string& name) {
        const fmi2ValueReference reference = fmu_.at(name).reference;
        double value = std::nan("");
        EXPECT_EQ((*this)("fmi2GetReal", &reference, std::size_t(1), &value), fmi2OK);
        return value;
    }
    void start(double time) {
        EXPECT_EQ((*this)("fmi2SetupExperiment", fmi2Boolean(0), 0.0, time, fmi2Boolean(0), 0.0), fmi2OK);
        EXPECT_EQ((*this)("fmi2EnterInitializationMode"), fmi2OK);
        EXPECT_EQ((*this)("fmi2ExitInitializationMode"), fmi2OK);
    }

private:
    template <class Result, class... Arguments>
    Result call(const char* name, Arguments... arguments) {
        const auto function = reinterpret_cast<Result (*)(Arguments...)>(dlsym(library_, name));
        if (!function) throw std::runtime_error(fmt::format("the library has no {}", name));
        return function(arguments...);
    }

    const Unpacked& fmu_;
    fmi2CallbackFunctions callbacks_{logged, std::calloc, std::free, nullptr, nullptr};
    void* library_{};
    fmi2Component component_{};
};

// ---- the same by our own simulation ----

struct Reference {
    SystemPtr system;
    SampledInputs inputs;
    std::vector<double> parameters;

    Trajectory run(Engine engine = Engine::Auto, double tolerance = 1e-6) const {
        SimulationTask task;
        task.system = system.get();
        task.inputs = &inputs;
        task.parameters = parameters;
        task.keepStates = true;
        SimulationOptions options;
        options.engine = engine;
        options.relativeTolerance = tolerance;
        options.absoluteTolerance = 1e-3 * tolerance;
        Trajectory trajectory = simulate(task, options);
        EXPECT_FALSE(trajectory.failure.failed) << trajectory.failure.variable << trajectory.failure.reason;
        return trajectory;
    }
};

Reference referenceOf(const Study& study, std::size_t experiment) {
    const Outcome<EstimationTask> task = estimationTask(study);
    EXPECT_TRUE(task) << format(task.diagnostics());
    const Outcome<PreparedTask> prepared = prepare(*task, {}, task->recordings[experiment].role);
    EXPECT_TRUE(prepared) << format(prepared.diagnostics());
    const FitExperiment& own = prepared->problem.experiments.front();
    Reference reference{own.system, own.inputs, own.parameters};
    for (const FitParameter& p : prepared->problem.parameters) {
        const int at = own.system->parameterIndex(p.name);
        if (at >= 0 && p.experiment < 0) reference.parameters[static_cast<std::size_t>(at)] = p.start;
    }
    return reference;
}

/// Of a model text, along lines between samples of an input that rises, swings and turns.
Reference referenceOf(const std::string& text, const std::vector<std::string>& keep, double duration, int samples) {
    const Outcome<Library> library = studyLibrary(studyOf(text));
    EXPECT_TRUE(library) << format(library.diagnostics());
    const Outcome<SystemPtr> system = compile(*library, "M", {keep});
    EXPECT_TRUE(system) << format(system.diagnostics());
    Reference reference{*system, {}, {}};
    for (const SignalInfo& p : (*system)->parameters()) reference.parameters.push_back(p.value);
    reference.inputs.values.resize((*system)->inputCount(), samples);
    for (int k = 0; k < samples; ++k) {
        const double s = static_cast<double>(k) / (samples - 1);
        reference.inputs.time.push_back(s * duration);
        for (int i = 0; i < (*system)->inputCount(); ++i)
            reference.inputs.values(i, k) = 2 * std::sin(9 * s + i) + (s > 0.5 ? 1 : 0) - s;
    }
    return reference;
}

void setParameters(Instance& instance, const Unpacked& fmu, const Reference& reference) {
    for (std::size_t i = 0; i < reference.parameters.size(); ++i) {
        const std::string& name = reference.system->parameters()[i].name;
        for (const Variable& v : fmu.variables)
            if (v.name == name && v.causality == "parameter") instance.set(name, reference.parameters[i]);
    }
}

/// Sample by sample over the inputs.
class Drive {
public:
    Drive(Instance& instance, const Reference& reference) : instance_(instance), r_(reference) {
        outputs_.resize(r_.system->outputCount(), r_.inputs.values.cols());
    }
    void start() {
        setInputs(0);
        instance_.start(r_.inputs.time.front());
        setInputs(0);
        record(0);
    }
    bool step() {
        const auto k = static_cast<std::size_t>(next_ - 1);
        const fmi2Status status =
            instance_("fmi2DoStep", r_.inputs.time[k], r_.inputs.time[k + 1] - r_.inputs.time[k], fmi2Boolean(1));
        EXPECT_EQ(status, fmi2OK) << "at " << r_.inputs.time[k];
        setInputs(next_);
        record(next_++);
        return status == fmi2OK && next_ < r_.inputs.values.cols();
    }
    const Eigen::MatrixXd& run() {
        start();
        while (step()) {
        }
        return outputs_;
    }
    const Eigen::MatrixXd& outputs() const { return outputs_; }

private:
    void setInputs(Eigen::Index sample) {
        const Eigen::Index right = std::min(sample + 1, r_.inputs.values.cols() - 1), left = right - 1;
        const double width =
            r_.inputs.time[static_cast<std::size_t>(right)] - r_.inputs.time[static_cast<std::size_t>(left)];
        for (int i = 0; i < r_.system->inputCount(); ++i) {
            const std::string& name = r_.system->inputs()[static_cast<std::size_t>(i)].name;
            instance_.set(name, r_.inputs.values(i, sample));
            instance_.setSlope(name, (r_.inputs.values(i, right) - r_.inputs.values(i, left)) / width);
        }
    }
    void record(Eigen::Index sample) {
        for (int i = 0; i < r_.system->outputCount(); ++i)
            outputs_(i, sample) = instance_.get(r_.system->outputs()[static_cast<std::size_t>(i)].name);
    }

    Instance& instance_;
    const Reference& r_;
    Eigen::MatrixXd outputs_;
    Eigen::Index next_{1};
};

/// Largest difference of an output over its range.
double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    double worst = 0;
    for (Eigen::Index i = 0; i < a.rows(); ++i) {
        const double range = std::max(b.row(i).maxCoeff() - b.row(i).minCoeff(), 1e-12);
        worst = std::max(worst, (a.row(i) - b.row(i)).cwiseAbs().maxCoeff() / range);
    }
    return worst;
}

void expectSameCoSimulation(const Unpacked& fmu, const Reference& reference, const std::string& what,
                            Engine engine = Engine::Auto, double tolerance = 1e-6) {
    Instance instance(fmu, fmi2CoSimulation);
    ASSERT_TRUE(instance.isThere());
    setParameters(instance, fmu, reference);
    const double found = difference(Drive(instance, reference).run(), reference.run(engine, tolerance).outputs);
    std::printf("%s: co-simulation differs by %.1e of the range\n", what.c_str(), found);
    EXPECT_LT(found, 1e-4) << what;
}

/// Derivatives and event indicators at points beside the trajectory.
void expectSameModelExchange(const Unpacked& fmu, const Reference& reference, const std::string& what) {
    const System& system = *reference.system;
    const Trajectory trajectory = reference.run();
    Instance instance(fmu, fmi2ModelExchange);
    ASSERT_TRUE(instance.isThere());
    setParameters(instance, fmu, reference);
    for (int i = 0; i < system.inputCount(); ++i)
        instance.set(system.inputs()[static_cast<std::size_t>(i)].name, reference.inputs.values(i, 0));
    instance.start(reference.inputs.time.front());
    ASSERT_EQ(instance("fmi2EnterContinuousTimeMode"), fmi2OK);
    Workspace workspace = system.workspace(0, Execution::Interpreted);
    ASSERT_TRUE(system.setParameters(workspace, reference.parameters));
    const auto n = static_cast<std::size_t>(system.stateCount());
    std::vector<double> x(n), own(n), theirs(n), u(static_cast<std::size_t>(system.inputCount()));
    std::vector<double> ownRoots(static_cast<std::size_t>(system.rootCount())), theirRoots = ownRoots;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> near(0.9, 1.1);
    double worst = 0;
    for (int point = 0; point < 200; ++point) {
        const auto sample = static_cast<Eigen::Index>(random() % reference.inputs.time.size());
        const double t = reference.inputs.time[static_cast<std::size_t>(sample)];
        for (std::size_t i = 0; i < n; ++i)
            x[i] = near(random) * trajectory.states(static_cast<Eigen::Index>(i), sample);
        ASSERT_EQ(instance("fmi2SetTime", t), fmi2OK);
        for (std::size_t i = 0; i < u.size(); ++i) {
            u[i] = near(random) * reference.inputs.values(static_cast<Eigen::Index>(i), sample);
            instance.set(system.inputs()[i].name, u[i]);
        }
        ASSERT_EQ(instance("fmi2SetContinuousStates", static_cast<const double*>(x.data()), n), fmi2OK);
        ASSERT_EQ(instance("fmi2GetDerivatives", theirs.data(), n), fmi2OK);
        ASSERT_TRUE(system.derivatives(workspace, t, x, u, own));
        for (std::size_t i = 0; i < n; ++i)
            worst = std::max(worst, std::abs(theirs[i] - own[i]) / std::max(std::abs(own[i]), 1e-9));
        ASSERT_EQ(instance("fmi2GetEventIndicators", theirRoots.data(), theirRoots.size()), fmi2OK);
        ASSERT_TRUE(system.roots(workspace, t, x, u, ownRoots));
        for (std::size_t i = 0; i < ownRoots.size(); ++i) EXPECT_NEAR(theirRoots[i], ownRoots[i], 1e-12);
    }
    std::printf("%s: derivatives differ by %.1e\n", what.c_str(), worst);
    EXPECT_LT(worst, 1e-12) << what;
}

// ---- models ----

const std::string dryFriction = R"(model M
  parameter Real J(unit = "kg.m2") = 0.02;
  parameter Real k(unit = "N.m") = 1.5;
  input Real u;
  output Real w(unit = "rad/s");
  Analogon.Mechanics.Inertia inertia(J = J);
  Analogon.Effects.Mechanics.CoulombFriction friction(tau_c = 0.6, w_eps = 0.05);
  Analogon.Mechanics.ViscousLoad load(b = 0.1);
  Analogon.Sources.PrescribedTorque torque;
  Analogon.Sensors.SpeedSensor sensor;
equation
  torque.tau = k*u;
  connect(torque.flange, inertia.flange_a);
  connect(inertia.flange_b, friction.flange);
  connect(inertia.flange_b, load.flange);
  connect(inertia.flange_b, sensor.flange);
  w = sensor.w;
end M;)";

const std::string hardSwitch = R"(model M
  parameter Real a = 3;
  input Real u;
  output Real y;
  Real x(start = 0.2, fixed = true);
equation
  der(x) = if x > 0.5 then u - a*x else u + 1;
  y = if u > 1 then 2*x else x + 1;
end M;)";

const std::string rest = R"(model M
  input Real u;
  output Real w;
equation
  der(w) = u - 0.8*sign(w) - 0.1*w;
end M;)";

const std::string brakes = R"(model M
  input Real u;
  output Real v1(start = 1, fixed = true);
  output Real v2(start = 0, fixed = true);
equation
  der(v1) = 2*u - 2*sign(v1 - v2);
  der(v2) = 2*sign(v1 - v2) - sign(v2) - 0.2*v2;
end M;)";

const std::string nonlinear = R"(model M
  parameter Real R = 2;
  parameter Real g = 0.3;
  input Real u;
  output Real i;
  output Real v(start = 0.4);
  Real q(start = 0.1, fixed = true);
  Real a;
  Real b;
equation
  u = R*i + g*i^3 + tanh(i) + q;
  der(q) = i - q*v;
  a + 0.2*a^3*b + tanh(b) = i + 0.2;
  b + 0.2*b^3*a - sinh(0.3*a) = q;
  v = 1 + a^2 + b^2;
end M;)";

const std::string tables = R"(model M
  parameter Real T = 0.4;
  input Real u;
  output Real y;
  output Real z;
  Real x(start = 0.1, fixed = true);
equation
  T*der(x) = Analogon.Tables.monotoneCubic(u, {-2, -1, 0, 1.5, 3}, {-4, -1, 0, 1, 6}) - x;
  y = x;
  z = Analogon.Tables.linear(x, {-1, 0, 2}, {3, 0, 1});
end M;)";

const std::string delays = R"(model M
  parameter Real T_u(unit = "s") = 0.37;
  parameter Real T_y(unit = "s") = 0.21;
  parameter Real a = 2;
  input Real u;
  output Real y;
  output Real z;
  Real x(start = 0.3, fixed = true);
equation
  der(x) = a*(delay(u, T_u) - x);
  y = delay(x*x, T_y);
  z = x + delay(u, 0.01);
end M;)";

const std::string inputRate = R"(model M
  parameter Real T = 0.5;
  input Real u;
  output Real y;
  Real x(start = 0, fixed = true);
equation
  T*der(x) = u - x + 0.3*der(u);
  y = x + 0.1*der(u);
end M;)";

// ---- modelDescription.xml ----

TEST(Fmu, DescribesVariablesUnitsAndStructure) {
    Study study = example("lambda-sensor-heating");
    study.parameters["heater.R"].value = 4.125;
    const Unpacked fmu = exported(study);
    EXPECT_EQ(fmu.identifier, study.className);
    EXPECT_TRUE(fmu.hasModelExchange);
    EXPECT_TRUE(fs::exists(fmu.directory / "documentation" / "index.html"));
    EXPECT_TRUE(fs::exists(fmu.directory / "sources" / "fmu.c"));
    std::set<fmi2ValueReference> references;
    std::set<std::string> names;
    for (const Variable& v : fmu.variables) {
        EXPECT_TRUE(references.insert(v.reference).second) << v.name;
        EXPECT_TRUE(names.insert(v.name).second) << v.name;
        EXPECT_TRUE(v.unit.empty() || fmu.units.contains(v.unit)) << v.unit;
        EXPECT_EQ(v.start.has_value(), v.causality == "parameter" || v.causality == "input") << v.name;
    }
    EXPECT_EQ(fmu.at("heater.R").start, 4.125);
    EXPECT_EQ(fmu.at("heater.R").variability, "tunable");
    EXPECT_EQ(fmu.at("element.T_start").variability, "fixed") << "it acts on the start alone";
    EXPECT_EQ(fmu.at("ctrl_var").causality, "input");
    EXPECT_GT(*fmu.at("T_amb").start, 200) << "as in the first sample of the first experiment";
    EXPECT_EQ(fmu.at("i_mod").causality, "output");
    ASSERT_EQ(fmu.derivatives().size(), 1u);
    EXPECT_EQ(fmu.structure.at("Outputs").size(), 1u);
    EXPECT_EQ(fmu.structure.at("Derivatives").size(), 1u);
    EXPECT_EQ(fmu.structure.at("InitialUnknowns").size(), 3u);
    EXPECT_EQ(fmu.variables[static_cast<std::size_t>(fmu.structure.at("Outputs")[0] - 1)].name, "i_mod");
    const auto& volt = fmu.units.at("V");
    EXPECT_EQ(volt.at("kg") + volt.at("m") + volt.at("s") + volt.at("A"), "12-3-1");
    EXPECT_TRUE(fmu.experiment.contains("stopTime"));
}

TEST(Fmu, HasTheSameGuidForTheSameContentAlone) {
    Study study = example("lambda-sensor-heating");
    const Outcome<Fmu> one = fmuOf(study), again = fmuOf(study);
    study.parameters["heater.R"].value = 4.125;
    const Outcome<Fmu> other = fmuOf(study);
    ASSERT_TRUE(one && again && other);
    EXPECT_EQ(one->files, again->files);
    const auto guid = [](const Fmu& fmu) {
        const std::string& xml = fmu.files.at("modelDescription.xml");
        return xml.substr(xml.find("guid="), 48);
    };
    EXPECT_THAT(guid(*one), HasSubstr("guid=\"{"));
    EXPECT_NE(guid(*one), guid(*other));
}

TEST(Fmu, OffersNoModelExchangeWhereThePastOrAnInputRateIsNeeded) {
    for (const std::string& text : {delays, inputRate}) {
        const Outcome<Fmu> fmu = fmuOf(studyOf(text));
        ASSERT_TRUE(fmu) << format(fmu.diagnostics());
        EXPECT_FALSE(fmu->hasModelExchange);
        EXPECT_EQ(fmu->files.at("modelDescription.xml").find("<ModelExchange"), std::string::npos);
    }
}

TEST(Fmu, SaysThatItHasNoBinaryWithoutACompiler) {
    const Outcome<Fmu> fmu = fmuOf(studyOf(tables));
    ASSERT_TRUE(fmu) << format(fmu.diagnostics());
    const auto place = *TemporaryDirectory::make();
    const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
    setenv("PATH", "/nowhere", 1);
    const Outcome<Done> written = writeFmu(*fmu, place->path() / "m.fmu");
    setenv("PATH", path.c_str(), 1);
    ASSERT_TRUE(written) << format(written.diagnostics());
    EXPECT_THAT(format(written.diagnostics()), HasSubstr("no C compiler"));
    const QStringList files = JlCompress::getFileList(QString::fromStdString((place->path() / "m.fmu").string()));
    EXPECT_TRUE(files.contains("sources/fmu.c"));
    for (const QString& name : files) EXPECT_FALSE(name.startsWith("binaries")) << name.toStdString();
}

/// A compiler that never ends, with a process of its own beside it.
TEST(Fmu, EndsACompilerThatHangsAndHoldsItsSources) {
    const Outcome<Fmu> fmu = fmuOf(studyOf(tables));
    ASSERT_TRUE(fmu) << format(fmu.diagnostics());
    const auto place = *TemporaryDirectory::make();
    const fs::path compiler = place->path() / "cc", child = place->path() / "child";
    std::ofstream(compiler) << "#!/bin/sh\nsleep 600 &\necho $! > " << child.string() << "\nwait\n";
    fs::permissions(compiler, fs::perms::owner_all);
    const std::string path = std::getenv("PATH") ? std::getenv("PATH") : "";
    setenv("PATH", (place->path().string() + ":" + path).c_str(), 1);
    const auto begin = std::chrono::steady_clock::now();
    const Outcome<Done> written = writeFmu(*fmu, place->path() / "m.fmu", std::chrono::seconds(1));
    const auto took = std::chrono::steady_clock::now() - begin;
    setenv("PATH", path.c_str(), 1);
    ASSERT_TRUE(written) << format(written.diagnostics());
    EXPECT_THAT(format(written.diagnostics()), HasSubstr("still busy after 1 s"));
    EXPECT_LT(took, std::chrono::seconds(20));
    const QStringList files = JlCompress::getFileList(QString::fromStdString((place->path() / "m.fmu").string()));
    EXPECT_TRUE(files.contains("sources/fmu.c"));
    for (const QString& name : files) EXPECT_FALSE(name.startsWith("binaries")) << name.toStdString();
    int sleeper = 0;
    std::ifstream(child) >> sleeper;
    ASSERT_GT(sleeper, 0);
    const auto isGone = [&] {  // or a zombie that nobody has waited for
        std::ifstream status("/proc/" + std::to_string(sleeper) + "/stat");
        std::string stat;
        std::getline(status, stat);
        return stat.empty() || stat.find(") Z") != std::string::npos;
    };
    for (int tries = 0; tries < 200 && !isGone(); ++tries) usleep(10'000);
    EXPECT_TRUE(isGone()) << "what it has started is ended, too";
}

TEST(Fmu, StartsAsItsFirstExperimentDoes) {
    Study study = example("lambda-sensor-heating");
    study.experiments.front().initial["element.T_start"] = 555.5;
    const Unpacked fmu = exported(study);
    EXPECT_EQ(fmu.at("element.T_start").start, 555.5);
    EXPECT_EQ(fmu.at("element.T_start").variability, "fixed");
    if (!hasCompiler()) GTEST_SKIP() << "there is no C compiler (cc) on PATH";
    Instance instance(fmu, fmi2CoSimulation);
    ASSERT_TRUE(instance.isThere());
    instance.start(0);
    EXPECT_EQ(instance.get(fmu.derivatives().front().name.substr(4, fmu.derivatives().front().name.size() - 5)), 555.5);
}

// ---- the binary ----

class FmuBinary : public testing::Test {
protected:
    void SetUp() override {
#if !defined(__linux__) || !defined(__x86_64__)
        GTEST_SKIP() << "no binary is made on this platform";
#endif
        if (!hasCompiler()) GTEST_SKIP() << "there is no C compiler (cc) on PATH";
    }

    static void expectSameBothWays(const std::string& text, const std::vector<std::string>& parameters,
                                   const std::string& what) {
        const Unpacked fmu = exported(studyOf(text));
        const Reference reference = referenceOf(text, parameters, 10, 201);
        expectSameCoSimulation(fmu, reference, what, Engine::Adaptive, 1e-8);
        expectSameModelExchange(fmu, reference, what);
    }
};

TEST_F(FmuBinary, SourcesCompileWithoutWarnings) {
    for (const std::string& text : {dryFriction, hardSwitch, brakes, nonlinear, tables, delays, inputRate}) {
        const Unpacked fmu = exported(studyOf(text));
        const std::string command = fmt::format("cc -std=c99 -Wall -Wextra -Werror -fsyntax-only {}",
                                                (fmu.directory / "sources" / "fmu.c").string());
        EXPECT_EQ(std::system(command.c_str()), 0);
    }
}

TEST_F(FmuBinary, FollowsOurSimulationOfTheExamples) {
    for (const char* name : {"lambda-sensor-heating", "water-pump"}) {
        const Study study = example(name);
        const Unpacked fmu = exported(study);
        for (std::size_t e = 0; e < study.experiments.size(); ++e) {
            const Reference reference = referenceOf(study, e);
            expectSameCoSimulation(fmu, reference, fmt::format("{} {}", name, study.experiments[e].name));
            if (e == 0) expectSameModelExchange(fmu, reference, name);
        }
    }
}

TEST_F(FmuBinary, FollowsOurSimulationWithDryFriction) { expectSameBothWays(dryFriction, {"J", "k"}, "dry friction"); }

TEST_F(FmuBinary, IsIntegratedByAnImporterOfModelExchange) {
    const Unpacked fmu = exported(studyOf(dryFriction));
    const Reference reference = referenceOf(dryFriction, {"J", "k"}, 10, 201);
    const std::vector<double>& time = reference.inputs.time;
    Instance instance(fmu, fmi2ModelExchange);
    ASSERT_TRUE(instance.isThere());
    instance.set("u", reference.inputs.values(0, 0));
    instance.start(0);
    fmi2EventInfo info;
    ASSERT_EQ(instance("fmi2NewDiscreteStates", &info), fmi2OK);
    EXPECT_FALSE(info.newDiscreteStatesNeeded);
    ASSERT_EQ(instance("fmi2EnterContinuousTimeMode"), fmi2OK);
    const std::size_t n = fmu.derivatives().size();
    Eigen::VectorXd x(static_cast<Eigen::Index>(n)), rate(x.size());
    ASSERT_EQ(instance("fmi2GetContinuousStates", x.data(), n), fmi2OK);
    const auto go = [&](double t, const Eigen::VectorXd& at, double u) {
        instance("fmi2SetTime", t);
        instance.set("u", u);
        instance("fmi2SetContinuousStates", at.data(), n);
    };
    const auto rates = [&](double t, const Eigen::VectorXd& at, double u) {
        go(t, at, u);
        EXPECT_EQ(instance("fmi2GetDerivatives", rate.data(), n), fmi2OK);
        return rate;
    };
    Eigen::MatrixXd outputs(1, reference.inputs.values.cols());
    constexpr int substeps = 40;  // classic Runge-Kutta
    for (Eigen::Index k = 0; k < outputs.cols(); ++k) {
        const auto sample = static_cast<std::size_t>(k);
        go(time[sample], x, reference.inputs.values(0, k));
        outputs(0, k) = instance.get("w");
        if (k + 1 == outputs.cols()) break;
        const double h = (time[sample + 1] - time[sample]) / substeps;
        const auto at = [&](double s, const Eigen::VectorXd& state) {
            const double u0 = reference.inputs.values(0, k), u1 = reference.inputs.values(0, k + 1);
            return rates(time[sample] + s * h, state, u0 + s / substeps * (u1 - u0));
        };
        for (int s = 0; s < substeps; ++s) {
            const Eigen::VectorXd a = at(s, x), b = at(s + 0.5, x + 0.5 * h * a), c = at(s + 0.5, x + 0.5 * h * b),
                                  d = at(s + 1, x + h * c);
            x += h / 6 * (a + 2 * b + 2 * c + d);
        }
    }
    const double found = difference(outputs, reference.run(Engine::Adaptive, 1e-8).outputs);
    std::printf("model exchange by an importer differs by %.1e of the range\n", found);
    EXPECT_LT(found, 1e-5);
}

TEST_F(FmuBinary, FollowsOurSimulationAcrossEvents) {
    const Unpacked fmu = exported(studyOf(hardSwitch));
    EXPECT_EQ(fmu.eventIndicators, 2);
    const Reference reference = referenceOf(hardSwitch, {"a"}, 10, 201);
    expectSameCoSimulation(fmu, reference, "switches", Engine::Adaptive, 1e-8);
    expectSameModelExchange(fmu, reference, "switches");
}

TEST_F(FmuBinary, StaysAtRestWhereFrictionHolds) {
    const Unpacked fmu = exported(studyOf(rest));
    const Reference reference = referenceOf(rest, {}, 10, 201);
    expectSameCoSimulation(fmu, reference, "rest", Engine::Adaptive, 1e-8);
}

TEST_F(FmuBinary, ComesThroughAFieldThatJumpsWithoutAnEvent) {
    std::string hidden = rest;
    hidden.replace(hidden.find("sign(w)"), 7, "noEvent(sign(w))");
    const Unpacked fmu = exported(studyOf(hidden));
    EXPECT_EQ(fmu.eventIndicators, 0);
    Instance instance(fmu, fmi2CoSimulation);
    ASSERT_TRUE(instance.isThere());
    instance.set("u", 0.5);
    instance.start(0);
    ASSERT_EQ(instance("fmi2DoStep", 0.0, 5.0, fmi2Boolean(1)), fmi2OK);
    EXPECT_NEAR(instance.get("w"), 0, 1e-3) << "held by a friction of 0.8";
}

TEST_F(FmuBinary, HoldsAndSlipsBetweenTwoBrakes) {
    const Unpacked fmu = exported(studyOf(brakes));
    EXPECT_EQ(fmu.structure.at("InitialUnknowns").size(), 4u) << "an output that is a state is listed once";
    const Reference reference = referenceOf(brakes, {}, 10, 201);
    expectSameCoSimulation(fmu, reference, "two brakes", Engine::Adaptive, 1e-8);
}

TEST_F(FmuBinary, SolvesNonlinearBlocksAsWeDo) { expectSameBothWays(nonlinear, {"R", "g"}, "nonlinear blocks"); }

TEST_F(FmuBinary, LooksUpTablesAsWeDo) { expectSameBothWays(tables, {"T"}, "tables"); }

TEST_F(FmuBinary, RemembersWhatIsDelayed) {
    const Unpacked fmu = exported(studyOf(delays));
    EXPECT_EQ(fmu.at("T_u").variability, "fixed");
    EXPECT_EQ(fmu.at("a").variability, "tunable");
    expectSameCoSimulation(fmu, referenceOf(delays, {"T_u", "T_y", "a"}, 10, 201), "delays", Engine::Adaptive, 1e-8);
    Instance exchange(fmu, fmi2ModelExchange);
    EXPECT_FALSE(exchange.isThere());
}

TEST_F(FmuBinary, RemembersHeldInputsOverManySteps) {
    const Unpacked fmu = exported(studyOf(delays));
    Instance instance(fmu, fmi2CoSimulation);
    ASSERT_TRUE(instance.isThere());
    instance.start(0);
    const double step = 0.004;
    for (int k = 0; k < 10000; ++k) {
        instance.set("u", std::sin(0.01 * k));
        ASSERT_EQ(instance("fmi2DoStep", k * step, step, fmi2Boolean(1)), fmi2OK) << k;
        if (k < 2) continue;
        ASSERT_NEAR(instance.get("z") - instance.get("x"), std::sin(0.01 * (k - 2)), 1e-12) << "0.01 s before, " << k;
    }
}

TEST_F(FmuBinary, TakesTheRateOfAnInput) {
    const Unpacked fmu = exported(studyOf(inputRate));
    expectSameCoSimulation(fmu, referenceOf(inputRate, {"T"}, 10, 201), "input rate", Engine::Adaptive, 1e-8);
}

TEST_F(FmuBinary, InstancesDoNotDisturbEachOther) {
    const Unpacked fmu = exported(studyOf(delays));
    const Reference reference = referenceOf(delays, {"T_u", "T_y", "a"}, 10, 201);
    Reference other = reference;
    other.parameters = {0.1, 0.5, 4};
    other.inputs.values *= -0.7;
    Instance first(fmu, fmi2CoSimulation), second(fmu, fmi2CoSimulation), alone(fmu, fmi2CoSimulation);
    setParameters(second, fmu, other);
    setParameters(alone, fmu, other);
    Drive one(first, reference), two(second, other), aloneDrive(alone, other);
    one.start();
    two.start();
    while (one.step() & two.step()) {
    }
    EXPECT_EQ(two.outputs(), aloneDrive.run());
    EXPECT_LT(difference(one.outputs(), reference.run(Engine::Adaptive, 1e-8).outputs), 1e-4);
    EXPECT_LT(difference(two.outputs(), other.run(Engine::Adaptive, 1e-8).outputs), 1e-4);
}

TEST_F(FmuBinary, AParameterChangesTheResultAsInOurSimulation) {
    const Study study = example("lambda-sensor-heating");
    const Unpacked fmu = exported(study);
    const Reference before = referenceOf(study, 0);
    Reference after = before;
    after.parameters[static_cast<std::size_t>(after.system->parameterIndex("heater.R"))] *= 1.2;
    expectSameCoSimulation(fmu, after, "heater.R + 20 %");
    EXPECT_GT(difference(after.run().outputs, before.run().outputs), 0.01);
}

TEST_F(FmuBinary, RefusesWhatFmiForbids) {
    const Unpacked fmu = exported(studyOf(tables));
    Instance instance(fmu, fmi2CoSimulation);
    ASSERT_TRUE(instance.isThere());
    const double value = 1;
    const fmi2ValueReference output = fmu.at("y").reference, none = 9999;
    EXPECT_EQ(instance("fmi2DoStep", 0.0, 0.1, fmi2Boolean(1)), fmi2Error) << "before the initialization";
    instance.start(0);
    EXPECT_EQ(instance("fmi2SetReal", &output, std::size_t(1), &value), fmi2Error);
    EXPECT_EQ(instance("fmi2SetReal", &none, std::size_t(1), &value), fmi2Error);
    EXPECT_EQ(instance("fmi2DoStep", 5.0, 0.1, fmi2Boolean(1)), fmi2Error) << "not where it stands";
    EXPECT_EQ(instance("fmi2DoStep", 0.0, 0.1, fmi2Boolean(1)), fmi2OK);
    const double reached = instance.get("y");
    EXPECT_EQ(instance("fmi2Reset"), fmi2OK);
    instance.start(0);
    EXPECT_EQ(instance("fmi2DoStep", 0.0, 0.1, fmi2Boolean(1)), fmi2OK);
    EXPECT_EQ(instance.get("y"), reached);
    Unpacked stranger = fmu;
    stranger.guid = "{other}";
    EXPECT_FALSE(Instance(stranger, fmi2CoSimulation).isThere());
}

TEST_F(FmuBinary, TakesNothingThatIsNotANumberOrNotThere) {
    const Unpacked fmu = exported(studyOf(dryFriction));
    Instance instance(fmu, fmi2CoSimulation);
    ASSERT_TRUE(instance.isThere());
    const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
    const fmi2ValueReference parameter = fmu.at("J").reference, input = fmu.at("u").reference;
    const double* const nothing = nullptr;
    double* const nowhere = nullptr;
    const std::size_t one = 1;
    for (const double bad : {nan, inf, -inf}) {
        const double* const value = &bad;
        EXPECT_EQ(instance("fmi2SetReal", &parameter, one, value), fmi2Error);
        EXPECT_EQ(instance("fmi2SetReal", &input, one, value), fmi2Error);
        EXPECT_EQ(instance("fmi2SetupExperiment", fmi2Boolean(0), 0.0, bad, fmi2Boolean(0), 0.0), fmi2Error);
    }
    EXPECT_EQ(instance("fmi2SetupExperiment", fmi2Boolean(0), 0.0, 1.0, fmi2Boolean(1), 0.5), fmi2Error);
    instance.start(0);
    EXPECT_EQ(instance.get("J"), 0.02) << "what was refused is not taken";
    const fmi2Integer order = 1;
    const double* const slope = &inf;
    EXPECT_EQ(instance("fmi2SetRealInputDerivatives", &input, one, &order, slope), fmi2Error);
    for (const double step : {inf, nan, -1.0, 0.0})
        EXPECT_EQ(instance("fmi2DoStep", 0.0, step, fmi2Boolean(1)), fmi2Error) << step;
    double time = nan;
    EXPECT_EQ(instance("fmi2GetRealStatus", fmi2LastSuccessfulTime, &time), fmi2OK);
    EXPECT_EQ(time, 0) << "a step that is refused leaves the time where it was";
    EXPECT_EQ(instance("fmi2DoStep", 0.0, 0.1, fmi2Boolean(1)), fmi2OK);

    const fmi2ValueReference* const noReferences = nullptr;
    const fmi2Integer* const noOrders = nullptr;
    EXPECT_EQ(instance("fmi2GetReal", noReferences, one, &time), fmi2Error);
    EXPECT_EQ(instance("fmi2GetReal", &input, one, nowhere), fmi2Error);
    EXPECT_EQ(instance("fmi2SetReal", &input, one, nothing), fmi2Error);
    EXPECT_EQ(instance("fmi2SetRealInputDerivatives", &input, one, noOrders, static_cast<const double*>(&time)),
              fmi2Error);
    EXPECT_EQ(instance("fmi2GetRealStatus", fmi2LastSuccessfulTime, nowhere), fmi2Error);
    EXPECT_EQ(instance("fmi2GetReal", noReferences, std::size_t(0), nowhere), fmi2OK) << "nothing is asked for";

    Instance exchange(fmu, fmi2ModelExchange);
    ASSERT_TRUE(exchange.isThere());
    exchange.start(0);
    const auto states = fmu.derivatives().size();
    for (const char* get : {"fmi2GetDerivatives", "fmi2GetContinuousStates", "fmi2GetNominalsOfContinuousStates"})
        EXPECT_EQ(exchange(get, nowhere, states), fmi2Error) << get;
    EXPECT_EQ(exchange("fmi2SetContinuousStates", nothing, states), fmi2Error);
    EXPECT_EQ(exchange("fmi2SetTime", inf), fmi2Error);
}

}  // namespace
}  // namespace analogon
