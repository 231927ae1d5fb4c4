#include "core/effect/judge/settled_flows.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/base/stop.hpp"

namespace analogon {
namespace {

constexpr double ofNeighbours[SettledFlows::correlations] = {0.2, 0.8, 0.97};  // correlation of neighbouring pieces

/// Root L of the correlation of pieces that follow each other by a first-order Markov process: each is `neighbours`
/// times the one before it, and what is new in it. L(i, j) = neighbours^(i - j) new(j) below the diagonal and on it.
class CorrelationRoot {
public:
    explicit CorrelationRoot(double neighbours)
        : neighbours_(neighbours), new_(std::sqrt(1 - neighbours * neighbours)) {}

    /// L' M L of a symmetric M.
    Eigen::MatrixXd both(const Eigen::MatrixXd& m) const { return after(after(m).transpose()); }

    /// L M.
    Eigen::MatrixXd before(Eigen::MatrixXd m) const {
        for (Eigen::Index j = 0; j < m.cols(); ++j)
            for (Eigen::Index i = 1; i < m.rows(); ++i) m(i, j) = neighbours_ * m(i - 1, j) + new_ * m(i, j);
        return m;
    }

private:
    /// M L.
    Eigen::MatrixXd after(Eigen::MatrixXd m) const {
        for (Eigen::Index j = m.cols() - 1; j-- > 0;) m.col(j) += neighbours_ * m.col(j + 1);
        m.rightCols(m.cols() - 1) *= new_;
        return m;
    }

    double neighbours_{}, new_{};
};

/// Over the rows that both have.
Eigen::MatrixXd product(const ResponseBlock& a, const ResponseBlock& b) {
    if (&a == &b) {
        Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(a.columns.cols(), a.columns.cols());
        squares.selfadjointView<Eigen::Lower>().rankUpdate(a.columns.transpose());
        return squares.selfadjointView<Eigen::Lower>();
    }
    const Eigen::Index begin = std::max(a.begin, b.begin),
                       end = std::min(a.begin + a.columns.rows(), b.begin + b.columns.rows());
    if (end <= begin) return Eigen::MatrixXd::Zero(a.columns.cols(), b.columns.cols());
    return a.columns.middleRows(begin - a.begin, end - begin).transpose() *
           b.columns.middleRows(begin - b.begin, end - begin);
}

auto rowsOf(const ResponseBlock& block, const Eigen::MatrixXd& columns) {
    return columns.middleRows(block.begin, block.columns.rows());
}

}  // namespace

const Eigen::MatrixXd& SettledFlows::Products::of(std::size_t one, std::size_t other, int recording) {
    const auto [found, isNew] = known.try_emplace({one, other, recording});
    if (isNew) found->second = product(*responses[one].of(recording), *responses[other].of(recording));
    return found->second;
}

Eigen::MatrixXd SettledFlows::Source::turned(const Eigen::MatrixXd& pieces) const {
    Eigen::MatrixXd amplitudes(pieces.rows(), pieces.cols());
    Eigen::Index at = 0;
    for (const Eigen::MatrixXd& turn : turns) {
        amplitudes.middleRows(at, turn.cols()) = turn.transpose() * pieces.middleRows(at, turn.rows());
        at += turn.rows();
    }
    return amplitudes;
}

Eigen::VectorXd SettledFlows::Source::piecesOf(const Eigen::VectorXd& amplitudes) const {
    Eigen::VectorXd pieces(amplitudes.size());
    Eigen::Index at = 0;
    for (const Eigen::MatrixXd& turn : turns) {
        pieces.segment(at, turn.rows()) = turn * amplitudes.segment(at, turn.cols());
        at += turn.rows();
    }
    return pieces;
}

SettledFlows::SettledFlows(std::vector<FlowResponse> responses, int pieces)
    : products_(std::make_shared<Products>(Products{std::move(responses), {}})), pieces_(pieces) {}

bool SettledFlows::has(std::size_t response) const {
    return std::any_of(flows_.begin(), flows_.end(), [&](const auto& f) { return f->flow.response == response; });
}

std::optional<SettledFlows::Source> SettledFlows::source(std::size_t response, std::size_t correlation) const {
    std::optional<Source> source = sourceOf(response, ofNeighbours[correlation]);
    if (source) source->correlation = correlation;
    return source;
}

std::optional<SettledFlows::Source> SettledFlows::sourceOf(std::size_t response, double neighbours) const {
    const Eigen::Index count = pieces_ + 1;
    const std::vector<ResponseBlock>& blocks = responses()[response].blocks;
    const CorrelationRoot root(neighbours);
    Source source{response, 0, {}, Eigen::VectorXd(count * static_cast<Eigen::Index>(blocks.size()))};
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        stopPoint();
        Eigen::MatrixXd squares = products_->of(response, response, blocks[b].recording);
        for (const auto& settled : flows_)
            if (const auto onto = settled->onto[response].find(blocks[b].recording);
                onto != settled->onto[response].end())
                squares -= onto->second * onto->second.transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(root.both(squares));
        source.turns.push_back(root.before(eigen.eigenvectors()));
        source.squares.segment(static_cast<Eigen::Index>(b) * count, count) = eigen.eigenvalues().cwiseMax(0);
    }
    if (!(source.squares.size() > 0 && source.squares.maxCoeff() > 0)) return std::nullopt;
    return source;
}

void SettledFlows::add(const Flow& flow) {
    const std::optional<Source> source = this->source(flow.response, flow.correlation);
    if (!source) return;
    auto more = std::make_shared<Settled>(Settled{flow, {}, {}});
    more->onto.resize(responses().size());
    const Eigen::VectorXd roots = source->part(flow.variance).cwiseSqrt();
    const std::vector<ResponseBlock>& blocks = responses()[flow.response].blocks;
    Eigen::Index at = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const int recording = blocks[b].recording;
        const Eigen::MatrixXd& turn = source->turns[b];
        const Eigen::MatrixXd shape = turn * roots.segment(at, turn.cols()).asDiagonal();
        at += turn.cols();
        for (std::size_t i = 0; i < responses().size(); ++i) {
            stopPoint();
            if (i == flow.response || has(i) || responses()[i].of(recording) == nullptr) continue;
            Eigen::MatrixXd beside = products_->of(i, flow.response, recording);
            for (const auto& before : flows_) {
                const auto mine = before->onto[i].find(recording), its = before->onto[flow.response].find(recording);
                if (mine != before->onto[i].end() && its != before->onto[flow.response].end())
                    beside -= mine->second * its->second.transpose();
            }
            more->onto[i].emplace(recording, beside * shape);
        }
        more->shapes.emplace(recording, shape);
    }
    spread_ += source->spread(flow.variance);
    flows_.push_back(std::move(more));
}

SettledFlows::Projected SettledFlows::project(const Eigen::MatrixXd& columns) const {
    Projected projected;
    projected.inner = columns.transpose() * columns;
    for (const FlowResponse& response : responses()) {
        stopPoint();
        std::vector<Eigen::MatrixXd>& own = projected.responses.emplace_back();
        for (const ResponseBlock& block : response.blocks)
            own.push_back(block.columns.transpose() * rowsOf(block, columns));
    }
    for (const auto& settled : flows_) {
        std::map<int, Eigen::MatrixXd> own;
        const std::vector<ResponseBlock>& blocks = responses()[settled->flow.response].blocks;
        const Eigen::MatrixXd beside = pieces(projected, settled->flow.response);
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            const Eigen::MatrixXd& shape = settled->shapes.at(blocks[b].recording);
            Eigen::MatrixXd onto =
                shape.transpose() * beside.middleRows(static_cast<Eigen::Index>(b) * shape.rows(), shape.rows());
            projected.inner -= onto.transpose() * onto;
            own.emplace(blocks[b].recording, std::move(onto));
        }
        projected.flows.push_back(std::move(own));
    }
    return projected;
}

Eigen::MatrixXd SettledFlows::pieces(const Projected& columns, std::size_t response) const {
    const std::vector<ResponseBlock>& blocks = responses()[response].blocks;
    const Eigen::Index count = pieces_ + 1;
    Eigen::MatrixXd all(count * static_cast<Eigen::Index>(blocks.size()), columns.inner.cols());
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        auto own = all.middleRows(static_cast<Eigen::Index>(b) * count, count);
        own = columns.responses[response][b];
        for (std::size_t f = 0; f < columns.flows.size(); ++f) {
            const auto onto = flows_[f]->onto[response].find(blocks[b].recording);
            const auto along = columns.flows[f].find(blocks[b].recording);
            if (onto != flows_[f]->onto[response].end() && along != columns.flows[f].end())
                own -= onto->second * along->second;
        }
    }
    return all;
}

Eigen::VectorXd SettledFlows::felt(std::size_t response, const Eigen::VectorXd& pieces, Eigen::Index rows) const {
    Eigen::VectorXd felt = Eigen::VectorXd::Zero(rows);
    Eigen::Index at = 0;
    for (const ResponseBlock& block : responses()[response].blocks) {
        felt.segment(block.begin, block.columns.rows()) += block.columns * pieces.segment(at, block.columns.cols());
        at += block.columns.cols();
    }
    return felt;
}

Eigen::VectorXd SettledFlows::weighed(Eigen::VectorXd column, std::size_t flows) const {
    if (flows == 0) return column;
    // B_f+1^-1 = B_f^-1 - B_f^-1 A S S' A' B_f^-1
    const Settled& last = *flows_[flows - 1];
    Eigen::VectorXd before = weighed(std::move(column), flows - 1);
    Eigen::VectorXd pieces((pieces_ + 1) * static_cast<Eigen::Index>(last.shapes.size()));
    Eigen::Index at = 0;
    for (const ResponseBlock& block : responses()[last.flow.response].blocks) {
        const Eigen::MatrixXd& shape = last.shapes.at(block.recording);
        pieces.segment(at, shape.rows()) =
            shape * (shape.transpose() * (block.columns.transpose() * rowsOf(block, before)));
        at += shape.rows();
    }
    before -= weighed(felt(last.flow.response, pieces, before.size()), flows - 1);
    return before;
}

}  // namespace analogon
