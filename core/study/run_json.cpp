#include "core/study/run_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <type_traits>

#include "core/base/json_limits.hpp"
#include "core/report/words.hpp"
#include "core/study/recorded.hpp"

namespace analogon {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* formatName = "analogon-run-1";

/// The values of an enumeration as the report calls them; empty beyond the last.
std::string wordOf(Role role) { return role == Role::Fit ? "fit" : role == Role::Validate ? "validate" : ""; }
std::string wordOf(FitStatus status) { return statusWords(status); }
std::string wordOf(Way way) { return name(way); }
std::string wordOf(Confidence confidence) { return static_cast<int>(confidence) > 1 ? "" : name(confidence); }
std::string wordOf(Verdict verdict) { return name(verdict); }
std::string wordOf(FindingKind kind) { return name(kind); }

/// Writes a struct member by member. Writer and Reader share one list of members for each struct (`members` below), so
/// that what is written is what is read.
class Writer {
public:
    explicit Writer(const KeepArray& keep) : keep_(keep) {}

    template <class Value>
    void member(const char* name, Value& value) {
        (*object_)[name] = written(value);
    }
    template <class Enum>
    void choice(const char* name, Enum& value) {
        (*object_)[name] = wordOf(value);
    }
    template <class Enum>
    void laterChoice(const char* name, Enum& value) {
        choice(name, value);
    }
    void array(const char* name, Eigen::VectorXd& values) {
        (*object_)[name] = kept({values.data(), static_cast<std::size_t>(values.size())});
    }
    void array(const char* name, std::vector<double>& values) { (*object_)[name] = kept(values); }

    template <class Value>
    Json written(const Value& value);

private:
    std::string kept(std::span<const double> values) { return values.empty() ? std::string() : keep_(values); }

    const KeepArray& keep_;
    Json* object_{};
};

class Reader {
public:
    explicit Reader(const FindArray& find) : find_(find) {}

    template <class Value>
    void member(const char* name, Value& value) {
        if (const auto found = object_->find(name); found != object_->end()) read(*found, value);
    }
    /// Of a kind that earlier versions did not have.
    template <class Enum>
    void laterChoice(const char* name, Enum& value) {
        if (object_->contains(name)) choice(name, value);
    }
    template <class Enum>
    void choice(const char* name, Enum& value) {
        const std::string wanted = object_->at(name).get<std::string>();
        for (int i = 0; !wordOf(static_cast<Enum>(i)).empty(); ++i)
            if (wanted == wordOf(static_cast<Enum>(i))) {
                value = static_cast<Enum>(i);
                return;
            }
        throw std::runtime_error(fmt::format("'{}' is no {}", wanted, name));
    }
    void array(const char* name, Eigen::VectorXd& values) {
        const std::vector<double> found = arrayOf(name);
        values = Eigen::Map<const Eigen::VectorXd>(found.data(), static_cast<Eigen::Index>(found.size()));
    }
    void array(const char* name, std::vector<double>& values) { values = arrayOf(name); }

    template <class Value>
    void read(const Json& json, Value& value);

private:
    std::vector<double> arrayOf(const char* name) {
        const std::string kept = object_->value(name, std::string());
        return kept.empty() ? std::vector<double>() : find_(kept);
    }

    const FindArray& find_;
    const Json* object_{};
};

// ---- the members of each struct ----

template <class Of>
void members(Of& of, ErrorFigures& f) {
    of.member("rmse", f.rmse);
    of.member("error_percent", f.errorPercent);
    of.member("relative_rms_percent", f.relativeRmsPercent);
    of.member("fit_percent", f.fitPercent);
    of.member("max_abs", f.maxAbs);
}

template <class Of>
void members(Of& of, NormalPrior& p) {
    of.member("mean", p.mean);
    of.member("std", p.deviation);
}

template <class Of>
void members(Of& of, ConfidenceInterval& i) {
    of.member("lower", i.lower);
    of.member("upper", i.upper);
    of.member("open_below", i.isOpenBelow);
    of.member("open_above", i.isOpenAbove);
    of.member("values", i.values);
    of.member("rises", i.rises);
    of.member("remark", i.remark);
}

template <class Of>
void members(Of& of, FitEstimate& e) {
    of.member("name", e.name);
    of.member("unit", e.unit);
    of.member("value", e.value);
    of.member("std", e.standardError);
    of.member("at_bound", e.atBound);
    of.member("experiment", e.experiment);
    of.member("std_robust", e.robustError);
    of.member("interval", e.interval);
    of.member("prior", e.prior);
    of.member("std_if_white", e.whiteError);
}

template <class Of>
void members(Of& of, OutputState& o) {
    of.member("name", o.name);
    of.member("unit", o.unit);
    of.member("figures", o.figures);
    of.array("measured", o.measured);
    of.array("simulated", o.simulated);
    of.array("deviation", o.deviation);
}

template <class Of>
void members(Of& of, SimulationFailure& f) {
    of.member("failed", f.failed);
    of.member("time", f.time);
    of.member("variable", f.variable);
    of.member("reason", f.reason);
}

template <class Of>
void members(Of& of, ExperimentState& e) {
    of.member("name", e.name);
    of.choice("role", e.role);
    of.member("error_percent", e.errorPercent);
    of.array("time", e.time);
    of.member("outputs", e.outputs);
    of.member("failure", e.failure);
    of.member("starts", e.starts);
}

template <class Of>
void members(Of& of, ResidualSummary& r) {
    of.member("noise_std", r.noiseStd);
    of.member("std", r.standardDeviation);
    of.member("autocorrelation_time", r.autocorrelationTime);
    of.member("white", r.white);
    of.member("white_probability", r.whiteProbability);
}

template <class Of>
void members(Of& of, ModelState& s) {
    of.member("model", s.modelText);
    of.member("parameters", s.parameters);
    of.member("experiments", s.experiments);
    of.member("residual", s.residual);
    of.choice("status", s.status);
    of.member("message", s.message);
    of.member("remarks", s.remarks);
    of.member("simulations", s.simulations);
    of.member("seconds", s.seconds);
}

template <class Of>
void members(Of& of, EffectValue& v) {
    of.member("name", v.name);
    of.member("value", v.value);
    of.member("std", v.standardError);
    of.member("unit", v.unit);
}

template <class Of>
void members(Of& of, Alternative& a) {
    of.member("kind", a.kind);
    of.member("at", a.at);
    of.member("delta_bic", a.deltaBic);
    of.member("equivalent", a.equivalent);
}

template <class Of>
void members(Of& of, Evidence& e) {
    of.member("score", e.score);
    of.member("p_value", e.pValue);
    of.member("delta_bic", e.deltaBic);
    of.member("held_out", e.heldOut);
    of.member("error_percent_before", e.errorPercentBefore);
    of.member("error_percent_after", e.errorPercentAfter);
}

template <class Of>
void members(Of& of, Prediction& p) {
    of.member("error_percent_before", p.errorPercentBefore);
    of.member("error_percent_after", p.errorPercentAfter);
    of.member("blocks", p.blocks);
    of.member("better_in", p.betterIn);
    of.member("are_recordings", p.areRecordings);
    of.member("beside_flow", p.besideFlow);
}

template <class Of>
void members(Of& of, AddedEffect& e) {
    of.member("kind", e.kind);
    of.member("class", e.className);
    of.member("at", e.at);
    of.choice("way", e.wired.way);
    of.member("instance", e.wired.instance);
    of.member("new_input", e.wired.newInput);
    of.member("channel", e.wired.channel);
    of.member("description", e.description);
    of.member("parameters", e.parameters);
    of.member("evidence", e.evidence);
    of.laterChoice("confidence", e.confidence);
    of.member("prediction", e.prediction);
    of.member("alternatives", e.instead.effects);
    of.member("values_instead", e.instead.values);
}

template <class Of>
void members(Of& of, CandidateResult& c) {
    of.member("kind", c.kind);
    of.member("at", c.at);
    of.member("class", c.className);
    of.member("score", c.screening.score);
    of.member("strength", c.screening.strength);
    of.member("delta_bic", c.deltaBic);
    of.choice("verdict", c.verdict);
    of.member("absorbed_by", c.screening.absorbedBy);
    of.member("round", c.round);
    of.member("failure", c.failure);
    of.member("reason", c.reason);
    of.member("channel", c.channel);
}

template <class Of>
void members(Of& of, Correlate& c) {
    of.member("variable", c.variable);
    of.member("correlation", c.correlation);
}

template <class Of>
void members(Of& of, Remainder& r) {
    of.member("output", r.output);
    of.member("node", r.node);
    of.member("equivalent_nodes", r.proposal.equalNodes);
    of.member("evidence", r.evidence);
    of.member("from", r.from);
    of.member("to", r.to);
    of.member("experiment", r.experiment);
    of.member("moves_with", r.movesWith);
    of.member("proposed_equation", r.proposal.equation);
    of.member("proposed_class", r.proposal.className);
    of.member("proposed_block", r.proposal.block);
    of.member("error_fit_with", r.proposal.errors.fit);
    of.member("error_validate_with", r.proposal.errors.validate);
    of.member("error_validate_without", r.proposal.errorValidateWithout);
}

template <class Of>
void members(Of& of, UnmeasuredFlow& f) {
    of.member("node", f.node);
    of.member("size", f.size);
    of.member("unit", f.unit);
    of.member("time_constant", f.timeConstant);
}

template <class Of>
void members(Of& of, ProposedModel& p) {
    of.member("state", p.state);
    of.member("new_inputs", p.newInputs);
}

template <class Of>
void members(Of& of, Finding& f) {
    of.choice("kind", f.kind);
    of.member("baseline", f.baseline);
    of.member("final", f.final);
    of.member("effects", f.effects);
    of.member("candidates", f.candidates);
    of.member("remainders", f.unexplained.remainders);
    of.member("disturbance", f.unexplained.disturbance);
    of.member("proposed", f.unexplained.proposed);
    of.member("next_experiment", f.nextExperiment);
    of.member("warnings", f.warnings);
    of.member("not_searched", f.end.notSearched);
    of.member("interrupted", f.end.interrupted);
    of.member("at_limit_of_work", f.end.isAtLimitOfWork);
    of.member("seconds", f.end.seconds);
}

// ---- values ----

template <class>
struct IsVector : std::false_type {};
template <class Element>
struct IsVector<std::vector<Element>> : std::true_type {};
template <class>
struct IsOptional : std::false_type {};
template <class Value>
struct IsOptional<std::optional<Value>> : std::true_type {};

/// JSON has no word for numbers that are not finite.
Json numberJson(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

double numberOf(const Json& json) {
    if (!json.is_string()) return json.get<double>();
    const std::string word = json.get<std::string>();
    if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (word == "inf" || word == "-inf") return (word == "inf" ? 1 : -1) * std::numeric_limits<double>::infinity();
    throw std::runtime_error(fmt::format("'{}' is no number", word));
}

/// A sentence keeps how it was made, so that a screen in another language can say it.
Json textJson(const Text& text) {
    const bool isPlain = text.pattern().empty() && text.arguments().empty();
    if (isPlain && !text.isNumber()) return text.english();
    Json arguments = Json::array();
    for (const Text& argument : text.arguments()) arguments.push_back(textJson(argument));
    Json json{{"text", text.english()}, {"pattern", text.pattern()}, {"arguments", arguments}};
    if (text.isNumber()) json["number"] = true;
    return json;
}

Text textOf(const Json& json, int depth = 0) {
    constexpr int deepest = 40;  // no sentence of ours: a text made to exhaust the stack
    if (depth > deepest) throw std::runtime_error("a text has too many parts within parts");
    if (json.is_string()) return json.get<std::string>();
    if (json.value("number", false)) return Text::number(json.at("text").get<std::string>());
    std::vector<Text> arguments;
    for (const Json& argument : json.at("arguments")) arguments.push_back(textOf(argument, depth + 1));
    return {json.at("pattern").get<std::string>(), std::move(arguments), json.at("text").get<std::string>()};
}

template <class Value>
Json Writer::written(const Value& value) {
    if constexpr (std::is_same_v<Value, double>) {
        return numberJson(value);
    } else if constexpr (std::is_same_v<Value, Text>) {
        return textJson(value);
    } else if constexpr (IsOptional<Value>::value) {
        return value ? written(*value) : Json(nullptr);
    } else if constexpr (IsVector<Value>::value) {
        Json list = Json::array();
        for (const auto& element : value) list.push_back(written(element));
        return list;
    } else if constexpr (std::is_same_v<Value, std::map<std::string, ResidualSummary>>) {
        Json object = Json::object();
        for (const auto& [name, each] : value) object[name] = written(each);
        return object;
    } else if constexpr (std::is_constructible_v<Json, Value>) {
        return value;
    } else {
        Json object = Json::object();
        Json* const outer = std::exchange(object_, &object);
        members(*this, const_cast<Value&>(value));  // a writer only reads
        object_ = outer;
        return object;
    }
}

template <class Value>
void Reader::read(const Json& json, Value& value) {
    if constexpr (std::is_same_v<Value, double>) {
        value = numberOf(json);
    } else if constexpr (std::is_same_v<Value, Text>) {
        value = textOf(json);
    } else if constexpr (IsOptional<Value>::value) {
        value.reset();
        if (!json.is_null()) read(json, value.emplace());
    } else if constexpr (IsVector<Value>::value) {
        value.clear();
        for (const Json& element : json) read(element, value.emplace_back());
    } else if constexpr (std::is_same_v<Value, std::map<std::string, ResidualSummary>>) {
        for (const auto& [name, each] : json.items()) read(each, value[name]);
    } else if constexpr (std::is_arithmetic_v<Value> || std::is_same_v<Value, std::string> ||
                         std::is_same_v<Value, std::map<std::string, std::string>>) {
        value = json.get<Value>();
    } else {
        const Json* const outer = std::exchange(object_, &json);
        if (!json.is_object()) throw std::runtime_error("an object is missing");
        members(*this, value);
        object_ = outer;
    }
}

/// What a study is without its measurements, which lie where the study itself has them.
Json studyAsJson(const Study& study) {
    Json json{{"name", study.name}, {"study", Json::parse(studyJson(study))}, {"model_file", study.modelFile}};
    json["models"] = study.models;
    return json;
}

/// The file of the present study that is this recording: of the same name, or, where the run saw it at its place
/// outside the study, that of the experiment of this name which came from there. Else as it was.
std::string presentFile(const StudyExperiment& then, const Study& present) {
    const auto isThere = [&](const std::string& path) {
        return std::any_of(present.tables.begin(), present.tables.end(),
                           [&](const auto& known) { return fileOfKey(known.first) == path; });
    };
    if (isThere(then.file)) return then.file;
    const std::filesystem::path file(then.file);
    for (const StudyExperiment& e : present.experiments)
        if (e.name == then.name && e.file.starts_with(file.stem().string())) return e.file;
    const std::string name = file.filename().string();
    return isThere(name) ? name : then.file;
}

Study studyFrom(const Json& json, const std::string& name, const Study& present) {
    Outcome<Study> study = parseStudyJson(std::make_shared<const Source>(name, json.at("study").dump()));
    if (!study) throw std::runtime_error(study.diagnostics().front().message.english());
    study->name = json.at("name").get<std::string>();
    study->modelFile = json.at("model_file").get<std::string>();
    study->models = json.at("models").get<std::map<std::string, std::string>>();
    study->json = nullptr;
    study->directory = present.directory;
    study->tables = present.tables;
    study->unread = present.unread;
    study->libraryPaths = present.libraryPaths;  // those of then were relative to another place
    for (StudyExperiment& e : study->experiments) e.file = presentFile(e, present);
    return std::move(*study);
}

}  // namespace

std::string runJson(const PastRun& run, const KeepArray& keep) {
    Json json{{"format", formatName}, {"command", run.command}, {"ended", run.ended}, {"seconds", run.seconds}};
    json["ran_on"] = studyAsJson(*run.ranOn);
    json["completed"] = studyAsJson(run.result->completed);
    if (run.result->proposed) json["proposed"] = studyAsJson(*run.result->proposed);
    if (!run.name.empty()) json["name"] = run.name;
    if (!run.note.empty()) json["note"] = run.note;
    if (run.isPinned) json["pinned"] = true;
    if (run.isShown) json["shown"] = true;
    if (!run.plots.empty()) json["plots"] = Json::parse(run.plots, nullptr, false);
    if (run.before) json["before"] = Writer(keep).written(*run.before);
    json["finding"] = Writer(keep).written(run.result->finding);
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

PastRun parseRun(const std::string& text, const std::string& name, const Study& present, const FindArray& find) {
    if (const Outcome<Done> limited = checkJsonLimits(Source(name, text)); !limited)
        throw std::runtime_error(limited.diagnostics().front().message.english());
    const Json json = Json::parse(text);
    if (const std::string format = json.at("format").get<std::string>(); format != formatName)
        throw std::runtime_error(fmt::format("its format is '{}'", format));
    PastRun run;
    run.command = json.at("command").get<std::string>();
    run.ended = json.at("ended").get<std::string>();
    run.seconds = json.at("seconds").get<double>();
    run.name = json.value("name", std::string());
    run.note = json.value("note", std::string());
    run.isPinned = json.value("pinned", false);
    run.isShown = json.value("shown", false);
    if (const auto plots = json.find("plots"); plots != json.end() && plots->is_object()) run.plots = plots->dump();
    if (const auto before = json.find("before"); before != json.end()) {
        auto state = std::make_shared<ModelState>();
        Reader(find).read(*before, *state);
        run.before = std::move(state);
    }
    run.ranOn = std::make_shared<const Study>(studyFrom(json.at("ran_on"), name, present));
    auto result = std::make_shared<RunResult>();
    result->completed = studyFrom(json.at("completed"), name, present);
    if (const auto proposed = json.find("proposed"); proposed != json.end())
        result->proposed = studyFrom(*proposed, name, present);
    Reader(find).read(json.at("finding"), result->finding);
    run.result = std::move(result);
    return run;
}

}  // namespace analogon
