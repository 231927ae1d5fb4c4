#include "core/effect/judge/disturbance.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/stop.hpp"
#include "core/effect/block/screen.hpp"
#include "core/effect/model/score.hpp"
#include "core/effect/thresholds.hpp"
#include "core/fit/coordinates.hpp"

namespace analogon {

using namespace threshold::disturbance;

namespace {

constexpr int piecesOfADisturbance = 100;
constexpr double correlations[] = {0.2, 0.8, 0.97};         // of neighbouring pieces
constexpr double leastVariance = 1e-3, varianceFactor = 3;  // of the flow's strongest trace, in units of the noise
constexpr int varianceSteps = 24;
constexpr int mostRounds = 10, stepsARound = 3;
// mean square that a sensor's error may leave on the other outputs, in units of the noise and as a share of all
constexpr double leastInformation = 1e-10;  // of the best known direction of the parameters

/// Root of the correlation of pieces that follow each other by a first-order Markov process.
Eigen::MatrixXd correlationRoot(Eigen::Index count, double neighbours) {
    Eigen::MatrixXd c(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
        for (Eigen::Index j = 0; j < count; ++j) c(i, j) = std::pow(neighbours, static_cast<double>(std::abs(i - j)));
    return Eigen::LLT<Eigen::MatrixXd>(c).matrixL();
}

}  // namespace

Disturbance::Disturbance(const NullModel& model, const SimulationOptions& simulation, const Progress& progress,
                         const std::set<std::string>& places)
    : Disturbance(model.channels, flowResponses(model, piecesOfADisturbance, simulation, progress, places),
                  piecesOfADisturbance) {}

Disturbance::Disturbance(std::vector<ResidualChannel> channels, std::vector<FlowResponse> responses, int pieces)
    : channels_(std::move(channels)), responses_(std::move(responses)), pieces_(pieces) {
    if (!responses_.empty()) settled_.root.resize(responses_.front().columns.rows(), 0);
    settled_.sources = sourcesBeside();
}

std::vector<Disturbance::Source> Disturbance::sourcesBeside() const {
    std::vector<Source> sources;
    const Eigen::Index count = pieces_ + 1;
    for (std::size_t i = 0; i < responses_.size(); ++i) {
        const auto isHere = [&](const Flow& f) { return f.response == i; };
        if (std::any_of(settled_.flows.begin(), settled_.flows.end(), isHere)) continue;
        const Eigen::MatrixXd& columns = responses_[i].columns;
        const Eigen::MatrixXd weighed = besideSettled(columns);
        const Eigen::Index all = columns.cols();
        std::vector<Eigen::MatrixXd> squares;  // of each recording: no flow is felt in another
        for (Eigen::Index k = 0; k + count <= all; k += count)
            squares.emplace_back(columns.middleCols(k, count).transpose() * weighed.middleCols(k, count));
        for (std::size_t c = 0; c < std::size(correlations); ++c) {
            const Eigen::MatrixXd root = correlationRoot(count, correlations[c]);
            Source source{i, c, Eigen::MatrixXd::Zero(all, all), Eigen::VectorXd::Zero(all)};
            for (std::size_t e = 0; e < squares.size(); ++e) {
                stopPoint();
                const Eigen::Index k = static_cast<Eigen::Index>(e) * count;
                const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(root.transpose() * squares[e] * root);
                source.turn.block(k, k, count, count) = root * eigen.eigenvectors();
                source.squares.segment(k, count) = eigen.eigenvalues().cwiseMax(0);
            }
            if (source.squares.maxCoeff() > 0) sources.push_back(std::move(source));
        }
    }
    return sources;
}

Eigen::MatrixXd Disturbance::besideSettled(const Eigen::MatrixXd& columns) const {
    if (settled_.flows.empty()) return columns;
    return columns - settled_.root * (settled_.root.transpose() * columns);
}

Disturbance::Flow Disturbance::flowOf(const Metric& metric) const {
    return {sourceOf(metric).response, sourceOf(metric).correlation, metric.variance};
}

/// Settles one flow more, of those that can still be sought.
void Disturbance::add(const Flow& flow) {
    const auto source = std::find_if(settled_.sources.begin(), settled_.sources.end(), [&](const Source& s) {
        return s.response == flow.response && s.correlation == flow.correlation;
    });
    if (source == settled_.sources.end()) return;
    // (B + q A C A')^-1 = B^-1 - B^-1 A T q/(1 + q s) T' A' B^-1 where T turns A' B^-1 A into its diagonal s
    const Eigen::MatrixXd more = besideSettled(responses_[flow.response].columns) * source->turn *
                                 source->part(flow.variance).cwiseSqrt().asDiagonal();
    Eigen::MatrixXd root(more.rows(), settled_.root.cols() + more.cols());
    root << settled_.root, more;
    settled_.root = std::move(root);
    settled_.spread += source->spread(flow.variance);
    settled_.flows.push_back(flow);
    settled_.sources = sourcesBeside();
}

void Disturbance::settle(const Eigen::VectorXd& residuals, std::size_t most) {
    const Settled none = settled_;
    Metric best = likeliest(residuals);
    while (best.source >= 0 && settled_.flows.size() + 1 < std::min(most, responses_.size())) {
        Settled before = settled_;
        add(flowOf(best));
        Metric next = likeliest(residuals);
        if (next.source < 0 || !(next.misfit < best.misfit - leastOfAPlace)) {
            settled_ = std::move(before);
            return;
        }
        // each was found beside fewer than there are now
        for (std::size_t count = settled_.flows.size(), i = 0; i < count; ++i) {
            std::vector<Flow> flows(settled_.flows.begin() + 1, settled_.flows.end());
            flows.push_back(flowOf(next));
            Settled now = std::move(settled_);
            settled_ = none;
            for (const Flow& f : flows) add(f);
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
    for (const Flow& f : settled_.flows) places.insert(responses_[f.response].place);
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
    std::vector<Eigen::Index> rows;
    for (Eigen::Index i = 0; i < response.columns.rows(); ++i)
        if (response.columns.row(i).isZero(0)) rows.push_back(i);
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
    const Eigen::MatrixXd weighed = besideSettled(both);
    const Eigen::MatrixXd plain = both.transpose() * weighed;
    each(Metric{}, plain);
    Eigen::MatrixXd pieces;
    for (std::size_t s = 0; s < settled_.sources.size(); ++s) {
        stopPoint();
        const Source& source = settled_.sources[s];
        if (s == 0 || source.response != settled_.sources[s - 1].response)
            pieces = responses_[source.response].columns.transpose() * weighed;
        const Eigen::MatrixXd onto = source.turn.transpose() * pieces;
        Metric metric{static_cast<int>(s), leastVariance / source.squares.maxCoeff()};
        for (int k = 0; k < varianceSteps; ++k, metric.variance *= varianceFactor)
            // (I + q A A')^-1 = I - A q/(1 + q s) A' where A'A is diagonal, s
            each(metric, plain - onto.transpose() * source.part(metric.variance).asDiagonal() * onto);
    }
}

Eigen::MatrixXd Disturbance::products(const Eigen::MatrixXd& both, const Metric& metric) const {
    const Eigen::MatrixXd weighed = besideSettled(both);
    Eigen::MatrixXd result = both.transpose() * weighed;
    if (metric.source < 0) return result;
    const Source& source = sourceOf(metric);
    const Eigen::MatrixXd onto = source.turn.transpose() * (responses_[source.response].columns.transpose() * weighed);
    result -= onto.transpose() * source.part(metric.variance).asDiagonal() * onto;
    return result;
}

double Disturbance::misfit(const Eigen::MatrixXd& products, const Metric& metric, double rows) const {
    double sumOfSquares = products(0, 0);
    if (products.cols() > 1) sumOfSquares += products.col(0).tail(products.cols() - 1).dot(follow(products, 0));
    const double spread = metric.source < 0 ? 0 : sourceOf(metric).spread(metric.variance);
    return misfitOf(sumOfSquares, rows) + settled_.spread + spread;
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

std::map<std::string, double> Disturbance::leastMisfits(const Linearisation& model) const {
    const Eigen::MatrixXd both = residualAndJacobian(model);
    std::map<std::string, double> least;
    visit(both, [&](const Metric& metric, const Eigen::MatrixXd& products) {
        const double m = misfit(products, metric, static_cast<double>(both.rows()));
        const std::string place = metric.source < 0 ? std::string() : responses_[sourceOf(metric).response].place;
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
    ofPlace[""] -= leastOfAPlace;
    const double all = model.residuals.squaredNorm() / static_cast<double>(model.residuals.size());
    std::set<std::string> flows;
    for (const FlowResponse& r : responses_) {
        if (r.isFlow) flows.insert(r.place);
        if (!r.isFlow && leftElsewhere(model, r) > std::max(mostElsewhere, shareElsewhere * all))
            ofPlace.erase(r.place);
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
    Eigen::VectorXd rest = besideSettled(residuals);
    if (metric.source >= 0) {
        const Source& source = sourceOf(metric);
        const Eigen::MatrixXd& columns = responses_[source.response].columns;
        const Eigen::VectorXd onto = source.turn.transpose() * (columns.transpose() * rest);
        rest -= besideSettled(columns * (source.turn * source.part(metric.variance).cwiseProduct(onto)));
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
            idle = metric_.misfit < least_.misfit - leastFall ? 0 : idle + 1;
            if (metric_.misfit < least_.misfit)
                least_ = {metric_.misfit, disturbance_->independentShare(here_.fit.optimum.residuals, metric_)};
            if (!prepared_ || progress_.stopRequested()) break;
            if (round == 0) {
                places = disturbance_->likelyPlaces(here_.fit.optimum, likelyShare);
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
            if (before - metric_.misfit < leastFall) break;
            before = metric_.misfit;
        }
        return begin - metric_.misfit > leastFall;
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
    BesideDisturbance least_{std::numeric_limits<double>::infinity(), 1};
};

}  // namespace

std::vector<std::string> likeliestPlaces(const NullModel& model, const SimulationOptions& simulation,
                                         const Progress& progress) {
    std::vector<std::string> places = Disturbance(model, simulation, progress).likeliestPlaces(model.fit.optimum);
    mostPartsFirst(model.variant, places, [](const std::string& place) -> const std::string& { return place; });
    return places;
}

BesideDisturbance besideDisturbance(const NullModel& model, const SimulationOptions& simulation,
                                    const Progress& progress, std::size_t most) {
    return Descent(model, simulation, progress, most).run();
}

double evidenceBeside(const BesideDisturbance& without, const BesideDisturbance& with, Eigen::Index rows, int more) {
    const double count = with.independent * static_cast<double>(rows);
    return with.independent * (without.misfit - with.misfit) - more * std::log(count);
}

}  // namespace analogon
