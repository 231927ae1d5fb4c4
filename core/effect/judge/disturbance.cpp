#include "core/effect/judge/disturbance.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/stop.hpp"
#include "core/effect/block/screen.hpp"
#include "core/effect/model/score.hpp"
#include "core/effect/model/taken_values.hpp"
#include "core/effect/thresholds.hpp"
#include "core/fit/coordinates.hpp"

namespace analogon {

using namespace threshold::disturbance;

namespace {

constexpr int piecesOfADisturbance = 100;
constexpr double leastVariance = 1e-3, varianceFactor = 3;  // of the flow's strongest trace, in units of the noise
constexpr int varianceSteps = 24;
// of the time constant that is told: from half a piece on by this factor; of the size, finer than what is searched
constexpr double shortestTime = 0.5, timeFactor = 1.5;
constexpr int timesOfADisturbance = 13;
constexpr double sizeFactor = 1.3;
constexpr int sizeSteps = 100;
constexpr int mostRounds = 10, stepsARound = 3;
// mean square that a sensor's error may leave on the other outputs, in units of the noise and as a share of all
constexpr double leastInformation = 1e-10;  // of the best known direction of the parameters

}  // namespace

Disturbance::Disturbance(const NullModel& model, const SimulationOptions& simulation, const Progress& progress,
                         const std::set<std::string>& places)
    : Disturbance(model.channels, flowResponses(model, piecesOfADisturbance, simulation, progress, places),
                  piecesOfADisturbance) {}

Disturbance::Disturbance(std::vector<ResidualChannel> channels, std::vector<FlowResponse> responses, int pieces)
    : channels_(std::move(channels)), settled_{SettledFlows(std::move(responses), pieces)} {
    seekSources();
}

void Disturbance::seekSources() {
    std::vector<Source> sources;
    for (std::size_t i = 0; i < responses().size(); ++i) {
        if (settled_.flows.has(i)) continue;
        for (std::size_t c = 0; c < SettledFlows::correlations; ++c)
            if (std::optional<Source> source = settled_.flows.source(i, c)) sources.push_back(std::move(*source));
    }
    settled_.sources = std::make_shared<const std::vector<Source>>(std::move(sources));
}

Disturbance::Flow Disturbance::flowOf(const Metric& metric) const {
    return {sourceOf(metric).response, sourceOf(metric).correlation, metric.variance};
}

/// Settles these flows as well.
void Disturbance::add(const std::vector<Flow>& flows) {
    for (const Flow& flow : flows) settled_.flows.add(flow);
    seekSources();
}

void Disturbance::settle(const Eigen::VectorXd& residuals, std::size_t most) {
    const Settled none = settled_;
    Metric best = likeliest(residuals);
    while (best.source >= 0 && settled_.flows.count() + 1 < std::min(most, responses().size())) {
        Settled before = settled_;
        add({flowOf(best)});
        Metric next = likeliest(residuals);
        if (next.source < 0 || !(next.misfit < best.misfit - equivalenceMargin)) {
            settled_ = std::move(before);
            return;
        }
        // each was found beside fewer than there are now
        for (std::size_t count = settled_.flows.count(), i = 0; i < count; ++i) {
            std::vector<Flow> flows;
            for (std::size_t k = 1; k < count; ++k) flows.push_back(settled_.flows.flow(k));
            flows.push_back(flowOf(next));
            Settled now = std::move(settled_);
            settled_ = none;
            add(flows);
            const Metric again = likeliest(residuals);
            if (again.source < 0) {
                settled_ = std::move(now);
                break;
            }
            next = again;
        }
        best = next;
    }
}

std::set<std::string> Disturbance::settledPlaces() const {
    std::set<std::string> places;
    for (std::size_t f = 0; f < settled_.flows.count(); ++f)
        places.insert(responses()[settled_.flows.flow(f).response].place);
    return places;
}

namespace {

/// A model's residual (first column) and Jacobian, the latter of unit columns.
Eigen::MatrixXd residualAndJacobian(const Linearisation& model) {
    Eigen::MatrixXd both(model.residuals.size(), 1 + model.jacobian.cols());
    both.col(0) = model.residuals;
    both.rightCols(model.jacobian.cols()) = model.jacobian;
    for (Eigen::Index j = 1; j < both.cols(); ++j) {
        const double n = both.col(j).norm();
        if (n > 0) both.col(j) /= n;
    }
    return both;
}

/// How the parameters follow, from the products of residual and Jacobian in the metric of the noise.
Eigen::VectorXd follow(const Eigen::MatrixXd& products, double damping) {
    const Eigen::Index count = products.cols() - 1;
    Eigen::MatrixXd normal = products.bottomRightCorner(count, count);
    normal.diagonal() *= 1 + damping;
    normal.diagonal().array() += leastInformation * std::max(normal.diagonal().maxCoeff(), 1e-300);
    return -normal.ldlt().solve(products.bottomLeftCorner(count, 1));
}

/// Mean square of what is left of the samples at which a disturbance does not show, where the parameters follow them.
double leftElsewhere(const Linearisation& model, const FlowResponse& response) {
    std::vector<bool> isFelt(static_cast<std::size_t>(model.residuals.size()));
    for (const ResponseBlock& block : response.blocks)
        for (Eigen::Index i = 0; i < block.columns.rows(); ++i)
            if (!block.columns.row(i).isZero(0)) isFelt[static_cast<std::size_t>(block.begin + i)] = true;
    std::vector<Eigen::Index> rows;
    for (std::size_t i = 0; i < isFelt.size(); ++i)
        if (!isFelt[i]) rows.push_back(static_cast<Eigen::Index>(i));
    if (rows.empty()) return 0;
    const Eigen::VectorXd there = model.residuals(rows);
    const Eigen::VectorXd left = OrthogonalProjector(Eigen::MatrixXd(model.jacobian(rows, Eigen::all)))(there);
    return left.squaredNorm() / static_cast<double>(rows.size());
}

double misfitOf(double sumOfSquares, double rows) {
    return rows * std::log(std::max(sumOfSquares, std::numeric_limits<double>::min()) / rows);
}

}  // namespace

template <class Visit>
void Disturbance::visit(const Eigen::MatrixXd& both, const Visit& each) const {
    stopPoint();
    const SettledFlows::Projected beside = settled_.flows.project(both);
    each(Metric{}, beside.inner);
    Eigen::MatrixXd pieces;
    for (std::size_t s = 0; s < settled_.sources->size(); ++s) {
        stopPoint();
        const Source& source = (*settled_.sources)[s];
        if (s == 0 || source.response != (*settled_.sources)[s - 1].response)
            pieces = settled_.flows.pieces(beside, source.response);
        const Eigen::MatrixXd onto = source.turned(pieces);
        Metric metric{static_cast<int>(s), leastVariance / source.squares.maxCoeff()};
        for (int k = 0; k < varianceSteps; ++k, metric.variance *= varianceFactor)
            // (I + q A A')^-1 = I - A q/(1 + q s) A' where A'A is diagonal, s
            each(metric, beside.inner - onto.transpose() * source.part(metric.variance).asDiagonal() * onto);
    }
}

Eigen::MatrixXd Disturbance::products(const Eigen::MatrixXd& both, const Metric& metric) const {
    SettledFlows::Projected beside = settled_.flows.project(both);
    if (metric.source < 0) return std::move(beside.inner);
    const Source& source = sourceOf(metric);
    const Eigen::MatrixXd onto = source.turned(settled_.flows.pieces(beside, source.response));
    return beside.inner - onto.transpose() * source.part(metric.variance).asDiagonal() * onto;
}

double Disturbance::misfit(const Eigen::MatrixXd& products, const Metric& metric, double rows) const {
    double sumOfSquares = products(0, 0);
    if (products.cols() > 1) sumOfSquares += products.col(0).tail(products.cols() - 1).dot(follow(products, 0));
    const double spread = metric.source < 0 ? 0 : sourceOf(metric).spread(metric.variance);
    return misfitOf(sumOfSquares, rows) + settled_.flows.spread() + spread;
}

Disturbance::Metric Disturbance::leastMisfit(const Eigen::MatrixXd& both) const {
    Metric best;
    best.misfit = std::numeric_limits<double>::infinity();
    visit(both, [&](Metric metric, const Eigen::MatrixXd& products) {
        metric.misfit = misfit(products, metric, static_cast<double>(both.rows()));
        if (metric.misfit < best.misfit) best = metric;
    });
    return best;
}

Disturbance::Metric Disturbance::likeliest(const Eigen::VectorXd& residuals) const { return leastMisfit(residuals); }

Disturbance::Metric Disturbance::likeliest(const Linearisation& model) const {
    return leastMisfit(residualAndJacobian(model));
}

bool isFallen(double before, double now) { return now < before - leastFall; }

bool isFeltElsewhere(double left, double all) { return left > std::max(mostElsewhere, shareElsewhere * all); }

std::map<std::string, double> Disturbance::leastMisfits(const Linearisation& model) const {
    const Eigen::MatrixXd both = residualAndJacobian(model);
    std::map<std::string, double> least;
    visit(both, [&](const Metric& metric, const Eigen::MatrixXd& products) {
        const double m = misfit(products, metric, static_cast<double>(both.rows()));
        const std::string place = metric.source < 0 ? std::string() : responses()[sourceOf(metric).response].place;
        double& there = least.try_emplace(place, m).first->second;
        there = std::min(there, m);
    });
    return least;
}

std::set<std::string> Disturbance::likelyPlaces(const Linearisation& model, double share) const {
    const std::map<std::string, double> ofPlace = leastMisfits(model);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [place, m] : ofPlace) least = std::min(least, m);
    std::set<std::string> likely;
    const double undisturbed = ofPlace.at("");
    for (const auto& [place, m] : ofPlace)
        if (undisturbed - m > share * (undisturbed - least)) likely.insert(place);
    return likely;
}

std::vector<std::string> Disturbance::likeliestPlaces(const Linearisation& model) const {
    std::map<std::string, double> ofPlace = leastMisfits(model);
    ofPlace[""] -= equivalenceMargin;
    const double all = model.residuals.squaredNorm() / static_cast<double>(model.residuals.size());
    std::set<std::string> flows;
    for (const FlowResponse& r : responses()) {
        if (r.isFlow) flows.insert(r.place);
        if (!r.isFlow && isFeltElsewhere(leftElsewhere(model, r), all)) ofPlace.erase(r.place);
    }
    const auto best = std::min_element(ofPlace.begin(), ofPlace.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (best->first.empty()) return {};
    std::vector<std::string> places{best->first};
    for (const auto& [place, misfit] : ofPlace)
        if (flows.contains(best->first) && flows.contains(place) && place != best->first &&
            misfit - best->second < equivalenceMargin)
            places.push_back(place);
    return places;
}

std::optional<UnmeasuredFlow> Disturbance::flowAt(const Linearisation& model, const std::string& place) const {
    const auto felt = std::find_if(responses().begin(), responses().end(),
                                   [&](const FlowResponse& r) { return r.isFlow && r.place == place; });
    if (felt == responses().end()) return std::nullopt;
    const auto index = static_cast<std::size_t>(felt - responses().begin());
    const Eigen::MatrixXd both = residualAndJacobian(model);
    const double rows = static_cast<double>(both.rows());
    const SettledFlows::Projected beside = settled_.flows.project(both);
    const Eigen::MatrixXd pieces = settled_.flows.pieces(beside, index);
    std::optional<UnmeasuredFlow> likeliest;
    double least = std::numeric_limits<double>::infinity();
    for (int t = 0; t < timesOfADisturbance; ++t) {
        stopPoint();
        const double time = felt->spacing * shortestTime * std::pow(timeFactor, t);
        const std::optional<Source> source = settled_.flows.sourceOf(index, std::exp(-felt->spacing / time));
        if (!source) return std::nullopt;
        const Eigen::MatrixXd onto = source->turned(pieces);
        double variance = leastVariance / source->squares.maxCoeff();
        for (int k = 0; k < sizeSteps; ++k, variance *= sizeFactor) {
            const Eigen::MatrixXd left = beside.inner - onto.transpose() * source->part(variance).asDiagonal() * onto;
            const double squares = left(0, 0) + left.col(0).tail(left.cols() - 1).dot(follow(left, 0));
            const double misfit = misfitOf(squares, rows) + source->spread(variance);
            if (!(misfit < least)) continue;
            least = misfit;
            likeliest = UnmeasuredFlow{place, std::sqrt(variance * squares / rows), felt->unit, time};
        }
    }
    return likeliest;
}

Eigen::VectorXd Disturbance::step(const Linearisation& model, const Metric& metric, double damping,
                                  const std::vector<bool>& held) const {
    Eigen::MatrixXd both = residualAndJacobian(model);
    for (std::size_t j = 0; j < held.size(); ++j)
        if (held[j]) both.col(static_cast<Eigen::Index>(j) + 1).setZero();
    Eigen::VectorXd step = follow(products(both, metric), damping);
    for (Eigen::Index j = 0; j < step.size(); ++j) {
        const double length = model.jacobian.col(j).norm();
        step[j] = length > 0 ? step[j] / length : 0;
    }
    return step;
}

Eigen::VectorXd Disturbance::gradient(const Linearisation& model, const Metric& metric) const {
    return products(residualAndJacobian(model), metric).bottomLeftCorner(model.jacobian.cols(), 1);
}

double Disturbance::independentShare(const Eigen::VectorXd& residuals, const Metric& metric) const {
    const SettledFlows& flows = settled_.flows;
    Eigen::VectorXd rest = flows.weighed(residuals);
    if (metric.source >= 0) {
        const Source& source = sourceOf(metric);
        const Eigen::VectorXd onto = source.turned(flows.pieces(flows.project(residuals), source.response));
        const Eigen::VectorXd pieces = source.piecesOf(source.part(metric.variance).cwiseProduct(onto));
        rest -= flows.weighed(flows.felt(source.response, pieces, rest.size()));
    }
    return effectiveCount(channels_, rest) / static_cast<double>(rest.size());
}

namespace {

/// Levenberg and Marquardt's method in the metric of a disturbance, which is judged anew at every point; its responses
/// are simulated anew after some steps.
class Descent {
public:
    Descent(const NullModel& model, const SimulationOptions& simulation, const Progress& progress, std::size_t most)
        : simulation_(simulation),
          progress_(progress),
          most_(most),
          here_(model),
          prepared_(prepareAt(model.variant, model.noise)) {}

    BesideDisturbance run() {
        std::set<std::string> places;
        int idle = 0;
        for (int round = 0; round < mostRounds && idle < 2; ++round) {
            disturbance_.emplace(here_, simulation_, progress_, places);
            disturbance_->settle(here_.fit.optimum.residuals, most_);
            metric_ = disturbance_->likeliest(here_.fit.optimum.residuals);
            idle = isFallen(least_.misfit, metric_.misfit) ? 0 : idle + 1;
            if (metric_.misfit < least_.misfit)
                least_ = {metric_.misfit, disturbance_->independentShare(here_.fit.optimum.residuals, metric_),
                          here_.variant.values};
            if (!prepared_ || progress_.stopRequested()) break;
            if (round == 0) {
                places = disturbance_->likelyPlaces(here_.fit.optimum, threshold::likely::likelyShare);
                places.merge(disturbance_->settledPlaces());
            }
            if (places.empty() || !descend()) break;
        }
        return least_;
    }

private:
    /// Beside these responses; false where no step leads down.
    bool descend() {
        const double begin = metric_.misfit;
        double before = begin;
        for (int k = 0; k < stepsARound && !progress_.stopRequested() && goDown(); ++k) {
            if (!isFallen(before, metric_.misfit)) break;
            before = metric_.misfit;
        }
        return isFallen(begin, metric_.misfit);
    }

    /// First as the parameters and the metric would go together, then down the slope of the metric that holds here.
    bool goDown() {
        const Linearisation& model = here_.fit.optimum;
        const Eigen::VectorXd together = disturbance_->step(model, disturbance_->likeliest(model), 0);
        for (const double part : {1.0, 0.3, 0.1})
            if (accept(part * together)) return true;
        const Eigen::VectorXd slope = disturbance_->gradient(model, metric_);
        std::vector<bool> held;
        for (std::size_t i = 0; i < prepared_->problem.parameters.size(); ++i) {
            const FitParameter& p = prepared_->problem.parameters[i];
            const auto index = static_cast<Eigen::Index>(i);
            held.push_back((p.start <= p.min && slope[index] > 0) || (p.start >= p.max && slope[index] < 0));
        }
        for (const double damping : {0.0, 0.01, 1.0, 100.0})
            if (accept(disturbance_->step(model, metric_, damping, held))) return true;
        return false;
    }

    /// Goes that step if it lowers the misfit.
    bool accept(const Eigen::VectorXd& step) {
        std::vector<FitParameter>& parameters = prepared_->problem.parameters;
        const Eigen::VectorXd values = stepped(parameters, prepared_->problem.startValues(), step);
        Linearisation there = linearise(prepared_->problem, values, true, here_.fit.plans, simulation_, progress_);
        if (!there.ok || !there.jacobian.allFinite()) return false;
        const Disturbance::Metric metric = disturbance_->likeliest(there.residuals);
        if (!(metric.misfit < metric_.misfit)) return false;
        metric_ = metric;
        here_.fit.optimum = std::move(there);
        for (std::size_t i = 0; i < parameters.size(); ++i)
            here_.variant.values[i].value = parameters[i].start = values[static_cast<Eigen::Index>(i)];
        return true;
    }

    /// The parameters after a step: inside their bounds, none grown or fallen more than about threefold.
    static Eigen::VectorXd stepped(const std::vector<FitParameter>& parameters, const Eigen::VectorXd& values,
                                   const Eigen::VectorXd& step) {
        const Coordinates coordinates(parameters);
        Eigen::VectorXd next = values;
        for (Eigen::Index i = 0; i < values.size(); ++i) {
            const FitParameter& p = parameters[static_cast<std::size_t>(i)];
            if (coordinates.isLogarithmic(static_cast<int>(i)))
                next[i] *= std::exp(std::clamp(step[i] / values[i], -1.0, 1.0));
            else
                next[i] += step[i];
            next[i] = std::clamp(next[i], p.min, p.max);
        }
        return next;
    }

    const SimulationOptions& simulation_;
    const Progress& progress_;
    std::size_t most_;
    NullModel here_;
    Outcome<PreparedTask> prepared_;
    std::optional<Disturbance> disturbance_;
    Disturbance::Metric metric_;
    BesideDisturbance least_{std::numeric_limits<double>::infinity(), 1, {}};
};

}  // namespace

LikelySource likeliestSource(const NullModel& model, const SimulationOptions& simulation, const Progress& progress) {
    const Disturbance disturbance(model, simulation, progress);
    LikelySource source{disturbance.likeliestPlaces(model.fit.optimum), {}};
    mostPartsFirst(model.variant, source.places, [](const std::string& place) -> const std::string& { return place; });
    if (!source.places.empty()) source.flow = disturbance.flowAt(model.fit.optimum, source.places.front());
    return source;
}

BesideDisturbance besideDisturbance(const NullModel& model, const SimulationOptions& simulation,
                                    const Progress& progress, std::size_t most) {
    return Descent(model, simulation, progress, most).run();
}

BesideDisturbance besideDisturbanceAlso(const BesideDisturbance& alone, const NullModel& with,
                                        const SimulationOptions& simulation, const Progress& progress, std::size_t most,
                                        const std::vector<ParameterValue>& offered) {
    BesideDisturbance best = besideDisturbance(with, simulation, progress, most);
    const auto beginThere = [&](const std::vector<ParameterValue>& ofEffect) {
        NullModel there = with;
        takeValues(there.variant.values, alone.values);
        takeValues(there.variant.values, ofEffect);
        const Outcome<PreparedTask> prepared = prepareAt(there.variant, there.noise);
        if (!prepared) return;
        there.fit.optimum =
            linearise(prepared->problem, prepared->problem.startValues(), true, there.fit.plans, simulation, progress);
        if (!there.fit.optimum.ok || !there.fit.optimum.jacobian.allFinite()) return;
        const BesideDisturbance other = besideDisturbance(there, simulation, progress, most);
        if (other.misfit < best.misfit) best = other;
    };
    if (!(best.misfit < alone.misfit)) beginThere({});
    if (!offered.empty() && !(best.misfit < alone.misfit - equivalenceMargin)) beginThere(offered);
    return best;
}

double evidenceBeside(const BesideDisturbance& without, const BesideDisturbance& with, Eigen::Index rows, int more) {
    const double count = with.independent * static_cast<double>(rows);
    return with.independent * (without.misfit - with.misfit) - more * std::log(count);
}

}  // namespace analogon
