#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/structure/hybrid.hpp"

namespace analogon {

using enum Operation;

double DiscreteProgram::valueOf(const Step& s, const std::vector<double>& slots, const std::vector<double>& readings,
                                double time, const std::vector<double>& values) const {
    const auto at = [&](int step) { return values[static_cast<std::size_t>(step)]; };
    switch (s.operation) {
        case Constant:
            return s.value;
        case Variable:
            return s.slot >= 0 ? slots[static_cast<std::size_t>(s.slot)]
                               : readings[static_cast<std::size_t>(s.reading)];
        case Time:
            return time;
        case If:
            return at(s.a) != 0 ? at(s.b) : at(s.c);
        case Table:
            return tables[static_cast<std::size_t>(s.value)].value(at(s.a));
        case TableDerivative:
            return tables[static_cast<std::size_t>(s.value)].derivative(at(s.a));
        default:
            return apply(s.operation, at(s.a), s.b >= 0 ? at(s.b) : 0);
    }
}

void DiscreteProgram::run(const std::vector<double>& slots, const std::vector<double>& readings, double time,
                          std::vector<double>& values) const {
    values.resize(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) values[i] = valueOf(steps[i], slots, readings, time, values);
}

void DiscreteProgram::findReaders() {
    leaves_.clear();
    firstReader_.assign(steps.size() + 1, 0);
    const auto forEachRead = [this](const auto& see) {
        for (std::size_t i = 0; i < steps.size(); ++i)
            for (const int read : {steps[i].a, steps[i].b, steps[i].c})
                if (read >= 0) see(static_cast<std::size_t>(read), static_cast<int>(i));
    };
    forEachRead([this](std::size_t read, int) { ++firstReader_[read + 1]; });
    for (std::size_t i = 0; i < steps.size(); ++i) {
        firstReader_[i + 1] += firstReader_[i];
        if (steps[i].operation == Variable || steps[i].operation == Time) leaves_.push_back(static_cast<int>(i));
    }
    readers_.resize(static_cast<std::size_t>(firstReader_.back()));
    std::vector<int> next = firstReader_;
    forEachRead([&](std::size_t read, int reader) { readers_[static_cast<std::size_t>(next[read]++)] = reader; });
}

void DiscreteProgram::update(const std::vector<double>& slots, const std::vector<double>& readings, double time,
                             std::vector<double>& values, std::vector<char>& isDue) const {
    if (values.size() != steps.size() || firstReader_.size() != steps.size() + 1)
        return run(slots, readings, time, values);
    isDue.assign(steps.size(), 0);
    for (const int leaf : leaves_) isDue[static_cast<std::size_t>(leaf)] = 1;
    const auto nextDue = [&](std::size_t from) {
        const void* found = from < isDue.size() ? std::memchr(isDue.data() + from, 1, isDue.size() - from) : nullptr;
        return found ? static_cast<std::size_t>(static_cast<const char*>(found) - isDue.data()) : isDue.size();
    };
    for (std::size_t i = nextDue(0); i < isDue.size(); i = nextDue(i + 1)) {
        const double now = valueOf(steps[i], slots, readings, time, values);
        // by their bits: what has no value has still none
        if (std::bit_cast<std::uint64_t>(now) == std::bit_cast<std::uint64_t>(values[i])) continue;
        values[i] = now;
        for (int r = firstReader_[i]; r < firstReader_[i + 1]; ++r)
            isDue[static_cast<std::size_t>(readers_[static_cast<std::size_t>(r)])] = 1;
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
