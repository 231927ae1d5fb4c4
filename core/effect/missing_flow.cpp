#include "core/effect/missing_flow.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/base/range.hpp"
#include "core/base/unit.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {
namespace {

constexpr std::size_t mostQuantities = 6, mostSingles = 4, mostLaws = 8;
constexpr double leastTermEvidence = 10;
constexpr double nearlyAll = 0.9;        // by which a term must explain more for each step of complexity
constexpr double sameTrace = 0.99;       // correlation of traces that are one to a search
constexpr double leastTermShare = 0.02;  // of what the first explains: less is decoration
constexpr double roundedSpeed = 0.01;    // of the largest: where the sign of a speed turns over

/// A quantity that a law may contain.
struct Quantity {
    std::string name;      // in the class: "w", "x1"
    std::string variable;  // of the model; empty: one of the node's own
    std::string shown;     // in the equation that people read
    std::optional<Dimension> dimension;
    double largest{};
};

struct Term {
    std::string text, shown;
    std::optional<Dimension> dimension;
    int complexity{};  // 1: of the node's own quantities; 2, 3: with others
};

std::optional<Dimension> power(const std::optional<Dimension>& d, int exponent) {
    if (!d) return d;
    Dimension result = *d;
    for (double& each : result) each *= exponent;
    return result;
}

std::optional<Dimension> product(const std::optional<Dimension>& a, const std::optional<Dimension>& b) {
    if (!a || !b) return std::nullopt;
    Dimension result = *a;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += (*b)[i];
    return result;
}

/// Smooth stand-in for the sign of a quantity, and what people read.
std::string signText(const Quantity& q) {
    return fmt::format("{0}/sqrt({0}^2 + {1}^2)", q.name, syntax::printNumber(roundedSpeed * q.largest));
}

void addPowers(const Quantity& q, bool withSign, int complexity, std::vector<Term>& terms) {
    terms.push_back({q.name, q.shown, q.dimension, complexity});
    terms.push_back(
        {fmt::format("{0}*abs({0})", q.name), fmt::format("{0}*abs({0})", q.shown), power(q.dimension, 2), complexity});
    terms.push_back({q.name + "^2", q.shown + "^2", power(q.dimension, 2), complexity});
    terms.push_back({q.name + "^3", q.shown + "^3", power(q.dimension, 3), complexity});
    terms.push_back({fmt::format("abs({})", q.name), fmt::format("abs({})", q.shown), q.dimension, complexity});
    if (withSign) terms.push_back({signText(q), fmt::format("sign({})", q.shown), Dimension{}, complexity});
}

void addProducts(const Quantity& a, const Quantity& b, bool withSign, int complexity, std::vector<Term>& terms) {
    const std::optional<Dimension> both = product(a.dimension, b.dimension);
    terms.push_back({a.name + "*" + b.name, a.shown + "*" + b.shown, both, complexity});
    terms.push_back(
        {fmt::format("{}*abs({})", a.name, b.name), fmt::format("{}*abs({})", a.shown, b.shown), both, complexity});
    terms.push_back({fmt::format("{}*{}^2", a.name, b.name), fmt::format("{}*{}^2", a.shown, b.shown),
                     product(both, b.dimension), complexity});
    if (withSign)
        terms.push_back({fmt::format("({})*abs({})", signText(a), b.name),
                         fmt::format("sign({})*abs({})", a.shown, b.shown), b.dimension, complexity});
}

/// What sets in above or below a value: an overflow, a stop, a valve.
void addHinges(const Quantity& q, const Range& range, std::vector<Term>& terms) {
    for (const double part : {0.3, 0.5, 0.65, 0.8, 0.9}) {
        const std::string high = fmt::format("{:.4g}", range.low + part * range.width()),
                          low = fmt::format("{:.4g}", range.high - part * range.width());
        terms.push_back({fmt::format("max(0, {} - ({}))", q.name, high),
                         fmt::format("max(0, {} - ({}))", q.shown, high), q.dimension, 2});
        terms.push_back({fmt::format("min(0, {} - ({}))", q.name, low), fmt::format("min(0, {} - ({}))", q.shown, low),
                         q.dimension, 2});
    }
}

/// Variables over the fitted experiments.
using Series = std::map<std::string, std::vector<Eigen::VectorXd>>;

/// What moves of these variables of a model; empty where it cannot be simulated.
Series movingSeries(const NullModel& null, const PreparedTask& held, const std::vector<std::string>& names,
                    const SimulationOptions& simulation) {
    Series values;
    for (const Trajectory& t : observe(null, held, names, simulation)) {
        if (t.failure.failed || t.observed.rows() != static_cast<Eigen::Index>(names.size())) return {};
        for (std::size_t i = 0; i < names.size(); ++i)
            values[names[i]].push_back(t.observed.row(static_cast<Eigen::Index>(i)).transpose());
    }
    std::erase_if(values, [](const auto& each) {
        Range range;
        for (const Eigen::VectorXd& v : each.second) range.take(rangeOf(v));
        return !(range.width() > 1e-9 * std::max(std::abs(range.low), std::abs(range.high)));
    });
    return values;
}

/// A number near the first value, for quantities (temperatures, angles) of which the differences matter.
double originOf(const Eigen::VectorXd& values) {
    if (std::abs(values[0]) < 1e-6 * values.cwiseAbs().maxCoeff()) return 0;
    const double scale = std::pow(10.0, std::floor(std::log10(std::abs(values[0]))) - 3);
    return scale * std::round(values[0] / scale);
}

std::string potentialName(const ModelNodes::FlowNode& node) { return node.place.connector + "." + node.potential; }

/// One node, with the class that is put there.
class FlowProbe {
public:
    FlowProbe(const NullModel& null, ModelNodes::FlowNode node) : null_(&null), node_(std::move(node)) {}

    const EffectPlace& place() const { return node_.place; }

    /// The quantities and all terms made of them.
    void collect(const std::vector<std::pair<std::string, std::string>>& others, const Series& values) {
        const std::string own = potentialName(node_);
        isMechanical_ = node_.flow == "tau";
        flowDimension_ = dimensionOf(isMechanical_ ? "N.m" : node_.flow == "Q_flow" ? "W" : "");
        const auto potential = values.find(own);
        std::vector<Quantity> foreign;
        for (const auto& [name, unit] : others) {
            const auto x = values.find(name);
            if (x == values.end() || foreign.size() == mostQuantities) continue;
            const bool isSame =
                potential != values.end() && (x->second.front() - potential->second.front()).cwiseAbs().maxCoeff() == 0;
            if (isSame) continue;
            const double origin = unit == "K" ? originOf(x->second.front()) : 0;
            foreign.push_back(quantity("x" + std::to_string(foreign.size() + 1), name, name, unit, x->second, origin));
        }
        std::vector<Quantity> local;
        if (potential != values.end()) {
            const char* unit = isMechanical_ ? "rad" : node_.flow == "Q_flow" ? "K" : "";
            local.push_back(
                quantity("p", "", node_.potential, unit, potential->second, originOf(potential->second.front())));
            if (isMechanical_) {
                std::vector<Eigen::VectorXd> speeds;
                for (std::size_t e = 0; e < potential->second.size(); ++e)
                    speeds.push_back(speed(potential->second[e], static_cast<int>(e)));
                local.insert(local.begin(), quantity("w", "", "w", "rad/s", speeds, 0));
            }
        }
        for (const Quantity& q : local) addPowers(q, q.name == "w", 1, terms_);
        if (potential != values.end()) {
            Range range;
            for (const Eigen::VectorXd& v : potential->second) range.take(rangeOf(v));
            const auto origin = origins_.find("p");
            const double zero = origin == origins_.end() ? 0 : origin->second;
            addHinges(local.back(), {range.low - zero, range.high - zero}, terms_);
        }
        if (local.size() == 2) {
            const double largest = local.front().largest;
            addHinges(local.front(), {-largest, largest}, terms_);
            addProducts(local[0], local[1], true, 1, terms_);
        }
        for (std::size_t j = 0; j < foreign.size(); ++j) {
            addPowers(foreign[j], false, 2, terms_);
            for (const Quantity& q : local) addProducts(q, foreign[j], q.name == "w", 2, terms_);
            for (std::size_t k = j + 1; k < foreign.size(); ++k)
                terms_.push_back({foreign[j].name + "*" + foreign[k].name, foreign[j].shown + "*" + foreign[k].shown,
                                  product(foreign[j].dimension, foreign[k].dimension), 3});
        }
        foreign_ = std::move(foreign);
    }

    /// Terms of an unknown course in time over each recording.
    void collectPieces(double begin, double end, int pieces) {
        const double width = (end - begin) / pieces;
        for (int k = 0; k <= pieces; ++k)
            terms_.push_back({fmt::format("noEvent(max(0, 1 - abs(time - {})/{}))",
                                          syntax::printNumber(begin + k * width), syntax::printNumber(width)),
                              {},
                              {},
                              1});
    }

    /// Traces of all terms at coefficients 0, in units of the noise. `perExperiment`: each has coefficients of its own.
    std::optional<Eigen::MatrixXd> traces(bool perExperiment, const SimulationOptions& simulation,
                                          const Progress& progress) const {
        if (terms_.empty()) return std::nullopt;
        std::vector<std::size_t> all(terms_.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
        const std::string name = className(0);
        const std::string text = classText(name, all);
        Outcome<Library> library = null_->variant.task.library.withSource(std::make_shared<Source>(name + ".mo", text));
        if (!library) return std::nullopt;
        Variant variant = null_->variant;
        variant.task.library = std::move(*library);
        Outcome<Variant> wired = withEffect(variant, effect(name, all), node_.place, {});
        if (!wired) return std::nullopt;
        std::vector<FitParameter> free;
        const int experiments = perExperiment ? static_cast<int>(recordingsOf(variant.task, Role::Fit).size()) : 1;
        for (int e = 0; e < experiments; ++e)
            for (const std::size_t i : all) {
                FitParameter p;
                p.name = wired->effects.back().instance + "." + coefficient(i);
                if (perExperiment) p.experiment = e;
                free.push_back(std::move(p));
            }
        Outcome<PreparedTask> held = prepareHeld(*wired, free, null_->noise);
        if (!held) return std::nullopt;
        const Eigen::VectorXd off = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(free.size()));
        Linearisation l = linearise(held->problem, off, true, null_->fit.plans, simulation, progress);
        if (l.residuals.size() != null_->fit.optimum.residuals.size()) return std::nullopt;
        return std::move(l.jacobian);
    }

    const std::vector<Term>& terms() const { return terms_; }

    FlowLaw law(const std::vector<std::size_t>& chosen, int number) const {
        const std::string name = className(number);
        return {{effect(name, chosen), node_.place}, classText(name, chosen)};
    }

private:
    Quantity quantity(std::string name, std::string variable, const std::string& shown, const std::string& unit,
                      const std::vector<Eigen::VectorXd>& values, double origin) {
        Quantity q;
        q.dimension = dimensionOf(unit.empty() ? "1" : unit);
        if (unit.empty()) q.dimension.reset();
        for (const Eigen::VectorXd& v : values) q.largest = std::max(q.largest, (v.array() - origin).abs().maxCoeff());
        q.variable = std::move(variable);
        q.name = std::move(name);
        q.shown = shown;
        if (origin != 0) {
            // the class takes the difference to the origin
            origins_[q.name] = origin;
            q.shown = fmt::format("({} {} {:.6g})", shown, origin < 0 ? "+" : "-", std::abs(origin));
        }
        return q;
    }

    Eigen::VectorXd speed(const Eigen::VectorXd& angle, int experiment) const {
        const std::vector<double>& time = fittedRecording(null_->variant.task, experiment).time;
        Eigen::VectorXd w = Eigen::VectorXd::Zero(angle.size());
        for (Eigen::Index k = 1; k < angle.size(); ++k)
            w[k] =
                (angle[k] - angle[k - 1]) / (time[static_cast<std::size_t>(k)] - time[static_cast<std::size_t>(k - 1)]);
        return w;
    }

    std::string className(int number) const {
        const char* base = isMechanical_ ? "MissingTorque" : node_.flow == "Q_flow" ? "MissingHeatFlow" : "MissingFlow";
        std::string name = base + std::to_string(number);
        while (null_->variant.task.library.find(name) != nullptr) name += "_";
        return name;
    }

    static std::string coefficient(std::size_t i) { return "a" + std::to_string(i + 1); }

    std::string unitOf(const Term& t) const {
        if (!flowDimension_ || !t.dimension) return {};
        const Dimension per = *power(t.dimension, -1);
        const bool isOfBaseUnits = per[0] != 0 || per[1] != 0;
        if (isOfBaseUnits) return text(*product(flowDimension_, per));
        // N.m/A and W/K2 read better than powers of kg, m and s
        const std::string flow = isMechanical_ ? "N.m" : "W", rest = text(per);
        if (rest == "1") return flow;
        return rest.starts_with("1/") ? flow + rest.substr(1) : flow + "." + rest;
    }

    bool uses(const std::vector<std::size_t>& chosen, const std::string& name) const {
        return std::any_of(chosen.begin(), chosen.end(), [&](std::size_t i) {
            const std::string& text = terms_[i].text;
            for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
                const auto isPart = [&](std::size_t k) {
                    return k < text.size() && (std::isalnum(static_cast<unsigned char>(text[k])) || text[k] == '_');
                };
                if ((at == 0 || !isPart(at - 1)) && !isPart(at + name.size())) return true;
            }
            return false;
        });
    }

    EffectClass effect(const std::string& name, const std::vector<std::size_t>& chosen) const {
        EffectClass e;
        e.className = name;
        e.description = "Law found in what a model leaves";
        e.kind = "proposal.law";
        e.way = Way::Attach;
        e.ports = {"port"};
        e.strength = coefficient(0);
        std::vector<std::string> sum;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (i > 0) e.linear.push_back(coefficient(i));
            e.units[coefficient(i)] = unitOf(terms_[chosen[i]]);
            sum.push_back(coefficient(i) + "*" + terms_[chosen[i]].shown);
        }
        e.proposal = fmt::format("{}.{} = {}", node_.place.connector, node_.flow, fmt::join(sum, " + "));
        for (const Quantity& q : foreign_)
            if (uses(chosen, q.name)) e.bound[inputOf(q)] = q.variable;
        return e;
    }

    std::string inputOf(const Quantity& q) const { return origins_.contains(q.name) ? q.name + "_in" : q.name; }

    std::string classText(const std::string& name, const std::vector<std::size_t>& chosen) const {
        std::string text = fmt::format("model {} \"Law found in what a model leaves\"\n", name);
        text += fmt::format("  {} port annotation (Placement(transformation(extent={{{{-110,-10}},{{-90,10}}}})));\n",
                            node_.connectorClass);
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            const std::string unit = unitOf(terms_[chosen[i]]);
            text += fmt::format("  parameter Real {}{} = 0;\n", coefficient(i),
                                unit.empty() || unit == "1" ? "" : fmt::format("(unit=\"{}\")", unit));
        }
        for (const Quantity& q : foreign_)
            if (uses(chosen, q.name)) text += fmt::format("  input Real {} \"{}\";\n", inputOf(q), q.variable);
        std::vector<std::string> equations;
        const auto define = [&](const std::string& quantity, const std::string& value) {
            const auto origin = origins_.find(quantity);
            if (origin == origins_.end() && quantity == value) return;
            text += fmt::format("  Real {};\n", quantity);
            equations.push_back(origin == origins_.end() ? fmt::format("{} = {}", quantity, value)
                                                         : fmt::format("{} = {} - ({})", quantity, value,
                                                                       syntax::printNumber(origin->second)));
        };
        if (uses(chosen, "p")) define("p", "port." + node_.potential);
        if (uses(chosen, "w")) define("w", "der(port." + node_.potential + ")");
        for (const Quantity& q : foreign_)
            if (uses(chosen, q.name)) define(q.name, inputOf(q));
        text += "equation\n";
        for (const std::string& e : equations) text += "  " + e + ";\n";
        std::vector<std::string> sum;
        for (std::size_t i = 0; i < chosen.size(); ++i) sum.push_back(coefficient(i) + "*" + terms_[chosen[i]].text);
        text += fmt::format("  port.{} = {};\nend {};\n", node_.flow, fmt::join(sum, " + "), name);
        return text;
    }

    const NullModel* null_;
    ModelNodes::FlowNode node_;
    bool isMechanical_{};
    std::optional<Dimension> flowDimension_;
    std::vector<Quantity> foreign_;
    std::map<std::string, double> origins_;
    std::vector<Term> terms_;
};

/// Terms that a law may consist of, and how much they explain to first order.
struct TermSet {
    std::vector<std::size_t> terms;
    double explained{};
};

/// The terms of one node against the residual: traces without what the parameters can imitate.
class TermChoice {
public:
    TermChoice(const NullModel& null, const std::vector<Term>& terms, const Eigen::MatrixXd& columns)
        : terms_(terms), residual_(null.fit.optimum.residuals), lengths_(columns.colwise().norm().transpose()) {
        columns_ = Complement(null.fit.optimum.jacobian)(columns);
    }

    /// Single terms that explain most, no two of them alike, and the best with the one that adds most to it.
    std::vector<TermSet> likeliest() const {
        std::vector<TermSet> sets;
        std::vector<Eigen::VectorXd> directions;
        const std::vector<double> gains = gainsOver(residual_, columns_);
        for (const std::size_t j : bestFirst(gains)) {
            if (sets.size() == mostSingles || !isMoreThanChance(gains[j], residual_)) break;
            const Eigen::VectorXd direction = columns_.col(static_cast<Eigen::Index>(j)).normalized();
            const bool isKnown = std::any_of(directions.begin(), directions.end(), [&](const Eigen::VectorXd& d) {
                return std::abs(d.dot(direction)) > sameTrace;
            });
            if (isKnown) continue;
            directions.push_back(direction);
            sets.push_back({{j}, gains[j]});
        }
        if (sets.empty()) return sets;
        const Eigen::VectorXd& first = directions.front();
        const Eigen::VectorXd left = residual_ - first * first.dot(residual_);
        const std::vector<double> further = gainsOver(left, columns_ - first * (first.transpose() * columns_));
        const std::size_t second = bestFirst(further).front();
        if (isMoreThanChance(further[second], left) && further[second] > leastTermShare * sets.front().explained)
            sets.push_back({{sets.front().terms.front(), second}, sets.front().explained + further[second]});
        return sets;
    }

private:
    std::vector<double> gainsOver(const Eigen::VectorXd& residual, const Eigen::MatrixXd& columns) const {
        std::vector<double> gains(static_cast<std::size_t>(columns.cols()));
        for (Eigen::Index j = 0; j < columns.cols(); ++j) {
            const double norm = columns.col(j).norm();
            if (!std::isfinite(norm) || !(norm > leastVisible * lengths_[j])) continue;
            const double along = columns.col(j).dot(residual) / norm;
            gains[static_cast<std::size_t>(j)] = along * along;
        }
        return gains;
    }

    /// By what they explain; of those that explain nearly the same, the simpler first.
    std::vector<std::size_t> bestFirst(const std::vector<double>& gains) const {
        std::vector<std::size_t> order(gains.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto worth = [&](std::size_t j) { return gains[j] * std::pow(nearlyAll, terms_[j].complexity); };
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return worth(a) > worth(b); });
        return order;
    }

    /// Whether a term stands is decided when it is fitted; this keeps out what chance brings among so many.
    bool isMoreThanChance(double gain, const Eigen::VectorXd& residual) const {
        const double rows = static_cast<double>(residual.size());
        const double evidence = gain / ((residual.squaredNorm() - gain) / rows) - std::log(rows) -
                                2 * std::log(static_cast<double>(terms_.size()));
        return evidence > leastTermEvidence;
    }

    const std::vector<Term>& terms_;
    const Eigen::VectorXd& residual_;
    Eigen::VectorXd lengths_;
    Eigen::MatrixXd columns_;
};

/// Inputs, states and outputs of the model: what a law may contain beside the node's own quantities.
std::vector<std::pair<std::string, std::string>> quantitiesOf(const System& system) {
    std::vector<std::pair<std::string, std::string>> names;
    const auto add = [&](const std::vector<SignalInfo>& signals) {
        for (const SignalInfo& s : signals)
            if (std::none_of(names.begin(), names.end(), [&](const auto& n) { return n.first == s.name; }))
                names.emplace_back(s.name, s.unit);
    };
    add(system.inputs());
    add(system.outputs());
    add(system.states());
    return names;
}

}  // namespace

std::vector<FlowLaw> likelyFlowLaws(const NullModel& null, int before, const SimulationOptions& simulation,
                                    const Progress& progress) {
    std::vector<FlowLaw> laws;
    Diagram diagram;
    const Outcome<ModelNodes> nodes = nodesOf(null.variant, diagram);
    const Outcome<PreparedTask> held = prepareHeld(null.variant, {}, null.noise);
    if (!nodes || !held) return laws;
    std::vector<FlowProbe> probes;
    std::vector<std::pair<std::size_t, TermSet>> likely;  // of which probe
    std::vector<ModelNodes::FlowNode> flowNodes = nodes->flowNodes();
    const std::vector<std::pair<std::string, std::string>> others = quantitiesOf(*held->system);
    std::set<std::string> names;
    for (const ModelNodes::FlowNode& node : flowNodes) names.insert(potentialName(node));
    for (const auto& [name, unit] : others) names.insert(name);
    const Series values = movingSeries(null, *held, {names.begin(), names.end()}, simulation);
    for (ModelNodes::FlowNode& node : flowNodes) {
        if (progress.stopRequested()) break;
        FlowProbe probe(null, std::move(node));
        probe.collect(others, values);
        const std::optional<Eigen::MatrixXd> columns = probe.traces(false, simulation, progress);
        if (!columns) continue;
        for (TermSet& set : TermChoice(null, probe.terms(), *columns).likeliest())
            likely.emplace_back(probes.size(), std::move(set));
        probes.push_back(std::move(probe));
    }
    std::stable_sort(likely.begin(), likely.end(),
                     [](const auto& a, const auto& b) { return a.second.explained > b.second.explained; });
    if (likely.size() > mostLaws) likely.erase(likely.begin() + mostLaws, likely.end());
    for (const auto& [probe, set] : likely) laws.push_back(probes[probe].law(set.terms, ++before));
    return laws;
}

std::vector<FlowResponse> flowResponses(const NullModel& null, int pieces, const SimulationOptions& simulation,
                                        const Progress& progress, const std::set<std::string>& wanted) {
    std::vector<FlowResponse> responses;
    const auto isWanted = [&](const std::string& place) { return wanted.empty() || wanted.contains(place); };
    Diagram diagram;
    const Outcome<ModelNodes> nodes = nodesOf(null.variant, diagram);
    const Outcome<PreparedTask> held = prepareHeld(null.variant, {}, null.noise);
    if (!nodes || !held) return responses;
    const std::vector<int> fitted = recordingsOf(null.variant.task, Role::Fit);
    Range time;
    for (const int r : fitted) time.take(rangeOf(null.variant.task.recordings[static_cast<std::size_t>(r)].time));
    for (ModelNodes::FlowNode& node : nodes->flowNodes()) {
        if (progress.stopRequested()) return responses;
        FlowProbe probe(null, std::move(node));
        if (!isWanted(probe.place().at)) continue;
        probe.collectPieces(time.low, time.high, pieces);
        std::optional<Eigen::MatrixXd> columns = probe.traces(fitted.size() > 1, simulation, progress);
        if (columns && columns->allFinite()) responses.push_back({probe.place().at, true, std::move(*columns)});
    }
    // an error of one sensor shows on its channel and nowhere else
    std::map<int, Eigen::MatrixXd> ofOutput;
    for (const ResidualChannel& c : null.channels) {
        Eigen::MatrixXd& columns = ofOutput[c.output];
        const Eigen::Index before = columns.cols();
        columns.conservativeResize(null.fit.optimum.residuals.size(), before + pieces + 1);
        columns.rightCols(pieces + 1).setZero();
        const int count = c.end - c.begin;
        for (int row = 0; row < count; ++row) {
            const double at = static_cast<double>(row) * pieces / std::max(1, count - 1);
            const int k = std::min(pieces - 1, static_cast<int>(at));
            columns(c.begin + row, before + k) = 1 - (at - k);
            columns(c.begin + row, before + k + 1) = at - k;
        }
    }
    for (auto& [output, columns] : ofOutput) {
        std::string place = std::string(outputPrefix) + held->system->outputs()[static_cast<std::size_t>(output)].name;
        if (isWanted(place)) responses.push_back({std::move(place), false, std::move(columns)});
    }
    return responses;
}

}  // namespace analogon
