#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/effect/model/score.hpp"
#include "core/fit/problem.hpp"

/// What two models leave of a part of the record that neither is fitted to: each follows the rest, to first order about
/// its optimum.
namespace analogon {

/// Residuals of a part that was left out (rows in its order), but for what that part alone tells of the parameters.
struct LeftOutPart {
    Eigen::VectorXd without, with;
    double unconfirmed{};  // sum of squares by which the models differ in what that part alone tells
};

class HeldOut {
public:
    /// Both of the same rows; they must outlive it.
    HeldOut(const Linearisation& without, const Linearisation& with);
    LeftOutPart part(const std::vector<Eigen::Index>& rows) const;

private:
    /// A model, and its normal equations with columns of unit length.
    struct Model {
        explicit Model(const Linearisation& l);

        const Linearisation& linear;
        Eigen::VectorXd scale;
        Eigen::MatrixXd normal;
    };
    Model without_, with_;
};

/// H = (SSE0 - SSE1) / |f1 - f0|^2 on blocks of the data left out in turn. Tends to +1 for a true effect and to -1 for
/// a false one. Every `folds`-th block is left out together: short blocks spread what excites an effect only now and
/// then, but must outlast the memory of the noise.
double heldOutGain(const std::vector<ResidualChannel>& channels, const Linearisation& without,
                   const Linearisation& with, int blocks, int folds);

}  // namespace analogon
