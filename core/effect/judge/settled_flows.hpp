#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "core/effect/block/missing_flow.hpp"

namespace analogon {

/// Flows that nobody measured, each a Gaussian process of its own variance q and correlation C at one place, as part of
/// the covariance of a residual, V = s^2 B with B = I + sum q A C A', A the responses to pieces of the flow. By
/// Woodbury's formula B^-1 = I - sum W W' with W = B_f^-1 A S, where B_f has the flows before and S S' = (C^-1/q + A'
/// B_f^-1 A)^-1. Recordings do not feel each other, and neither B nor W is formed: all that is asked for follows from
/// products of the responses of one recording, which are as large as there are pieces.
class SettledFlows {
public:
    struct Flow {
        std::size_t response{};     // its place
        std::size_t correlation{};  // less than `correlations`
        double variance{};          // in units of the noise
    };
    /// A flow of any variance at one place, with one correlation, beside those that are settled.
    struct Source {
        std::size_t response{};
        std::size_t correlation{};
        std::vector<Eigen::MatrixXd> turns;  // of each block of the response: from the pieces to amplitudes that are
                                             // independent and whose traces are orthogonal
        Eigen::VectorXd squares;             // squared lengths of these traces, block by block

        Eigen::VectorXd part(double variance) const { return variance / (1 + variance * squares.array()); }
        double spread(double variance) const { return (variance * squares.array()).log1p().sum(); }
        /// Amplitudes of the independent ones from products of the pieces (rows, block by block).
        Eigen::MatrixXd turned(const Eigen::MatrixXd& pieces) const;
        /// The pieces of such amplitudes.
        Eigen::VectorXd piecesOf(const Eigen::VectorXd& amplitudes) const;
    };
    static constexpr std::size_t correlations = 3;

    /// None yet. `pieces` of a flow over every recording: one column more for each in the responses.
    SettledFlows(std::vector<FlowResponse> responses, int pieces);

    const std::vector<FlowResponse>& responses() const { return products_->responses; }
    std::size_t count() const { return flows_.size(); }
    const Flow& flow(std::size_t index) const { return flows_[index]->flow; }
    bool has(std::size_t response) const;
    /// ln of the determinant of B.
    double spread() const { return spread_; }

    /// Nothing where the flow is not felt.
    std::optional<Source> source(std::size_t response, std::size_t correlation) const;
    /// The same of any correlation of neighbouring pieces.
    std::optional<Source> sourceOf(std::size_t response, double neighbours) const;
    /// Settles one flow more, at another place than those before; what is not felt changes nothing.
    void add(const Flow& flow);

    /// Columns of a residual's rows in the metric of B.
    struct Projected {
        Eigen::MatrixXd inner;                                // X' B^-1 X
        std::vector<std::vector<Eigen::MatrixXd>> responses;  // A' X of each response and block
        std::vector<std::map<int, Eigen::MatrixXd>> flows;    // W' X of each flow, by recording
    };
    Projected project(const Eigen::MatrixXd& columns) const;
    /// A' B^-1 X of a response, block by block.
    Eigen::MatrixXd pieces(const Projected& columns, std::size_t response) const;
    /// A response to pieces, block by block.
    Eigen::VectorXd felt(std::size_t response, const Eigen::VectorXd& pieces, Eigen::Index rows) const;
    /// B^-1 of a column.
    Eigen::VectorXd weighed(const Eigen::VectorXd& column) const { return weighed(column, flows_.size()); }

private:
    struct Products {
        std::vector<FlowResponse> responses;
        std::map<std::tuple<std::size_t, std::size_t, int>, Eigen::MatrixXd> known;

        /// A' A of two responses in one recording that both are felt in, found when first asked for.
        const Eigen::MatrixXd& of(std::size_t one, std::size_t other, int recording);
    };
    struct Settled {
        Flow flow;
        std::map<int, Eigen::MatrixXd> shapes;             // S, by recording
        std::vector<std::map<int, Eigen::MatrixXd>> onto;  // A' W of each response, by recording
    };

    Eigen::VectorXd weighed(Eigen::VectorXd column, std::size_t flows) const;

    std::shared_ptr<Products> products_;  // shared by copies of one thread
    int pieces_{};
    std::vector<std::shared_ptr<const Settled>> flows_;
    double spread_{};
};

}  // namespace analogon
