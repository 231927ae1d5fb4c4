#pragma once

#include <vector>

/// The two problems as somebody would write them down for speed: equations simplified by hand, the classic
/// Runge-Kutta method, tangents by operators on short vectors, cost, gradient and Gauss-Newton matrix summed up
/// sample by sample.
namespace analogon::speed {

struct NormalEquations {
    double cost{};
    std::vector<double> gradient;
    std::vector<double> hessian;  // Gauss-Newton, K x K
};

/// Plain arrays, so that this side can be compiled for the machine at hand.
struct Record {
    int samples{};
    const double* time{};      // [s]
    const double* inputs{};    // samples x inputs
    const double* measured{};  // samples x outputs
    const double* sigma{};     // by output
};

/// What depends on the heater's inputs alone, by half samples.
std::vector<double> heaterTable(const Record& record);

/// samples x outputs
std::vector<double> heaterOutputs(const Record& record, const double* p, int substeps);
std::vector<double> motorOutputs(const Record& record, const double* p, int substeps);

/// One pass with all tangents, one step per sample. Parameters in the order of the problems.
NormalEquations heaterPass(const Record& record, const std::vector<double>& table, const double* p);
NormalEquations motorPass(const Record& record, const double* p);

/// A chain of 1, 2, 4, 10 or 20 masses, with tangents in the first `count` of its parameters.
NormalEquations chainPass(const Record& record, const double* p, int masses, int count);
/// samples x outputs, with so many steps per sample.
std::vector<double> chainOutputs(const Record& record, const double* p, int masses, int substeps);

}  // namespace analogon::speed
