#include <algorithm>
#include <cmath>

#include "core/structure/hybrid.hpp"

namespace analogon {

using enum Operation;

void DiscreteProgram::run(const std::vector<double>& slots, const std::vector<double>& readings, double time,
                          std::vector<double>& values) const {
    values.resize(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Step& s = steps[i];
        const auto at = [&](int step) { return values[static_cast<std::size_t>(step)]; };
        switch (s.operation) {
            case Constant:
                values[i] = s.value;
                break;
            case Variable:
                values[i] = s.slot >= 0 ? slots[static_cast<std::size_t>(s.slot)]
                                        : readings[static_cast<std::size_t>(s.reading)];
                break;
            case Time:
                values[i] = time;
                break;
            case If:
                values[i] = at(s.a) != 0 ? at(s.b) : at(s.c);
                break;
            case Table:
                values[i] = tables[static_cast<std::size_t>(s.value)].value(at(s.a));
                break;
            case TableDerivative:
                values[i] = tables[static_cast<std::size_t>(s.value)].derivative(at(s.a));
                break;
            default:
                values[i] = apply(s.operation, at(s.a), s.b >= 0 ? at(s.b) : 0);
        }
    }
}

namespace {

/// How the result of an operation on numbers moves with them: by a small change of both, which is exact to the root of
/// the rounding; what compares or counts does not move.
double movementOf(Operation operation, double a, double b, double da, double db) {
    switch (operation) {
        case Less:
        case LessEqual:
        case Greater:
        case GreaterEqual:
        case Equal:
        case NotEqual:
        case Not:
        case And:
        case Or:
        case Floor:
        case Ceil:
        case Sign:
        case Div:
            return 0;
        default: {
            if (da == 0 && db == 0) return 0;
            constexpr double small = 1e-6;
            const double size = std::max({std::fabs(a), std::fabs(b), 1e-3});
            const double h = small * size / std::max(std::fabs(da), std::fabs(db));
            return (apply(operation, a + h * da, b + h * db) - apply(operation, a - h * da, b - h * db)) / (2 * h);
        }
    }
}

}  // namespace

void DiscreteProgram::runTangents(const std::vector<double>& values, const std::vector<double>& slots,
                                  const std::vector<double>& readings, const std::vector<double>& time,
                                  std::vector<double>& tangents) const {
    const std::size_t K = time.size();
    tangents.assign(steps.size() * K, 0);
    const auto at = [&](int step) { return step >= 0 ? values[static_cast<std::size_t>(step)] : 0; };
    const auto of = [&](int step, std::size_t k) {
        return step >= 0 ? tangents[static_cast<std::size_t>(step) * K + k] : 0;
    };
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Step& s = steps[i];
        for (std::size_t k = 0; k < K; ++k) {
            double& to = tangents[i * K + k];
            if (s.operation == Constant)
                to = 0;
            else if (s.operation == Variable)
                to = s.slot >= 0 ? slots[static_cast<std::size_t>(s.slot) * K + k]
                                 : readings[static_cast<std::size_t>(s.reading) * K + k];
            else if (s.operation == Time)
                to = time[k];
            else if (s.operation == If)
                to = at(s.a) != 0 ? of(s.b, k) : of(s.c, k);
            else if (s.operation == Table)
                to = tables[static_cast<std::size_t>(s.value)].derivative(at(s.a)) * of(s.a, k);
            else if (s.operation == TableDerivative)
                to = 0;
            else
                to = movementOf(s.operation, at(s.a), at(s.b), of(s.a, k), of(s.b, k));
        }
    }
}

}  // namespace analogon
