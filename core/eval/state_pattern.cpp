#include "core/eval/state_pattern.hpp"

#include <algorithm>
#include <iterator>
#include <memory>

#include "core/eval/system_builder.hpp"

namespace analogon {
namespace {

constexpr std::size_t kMostFull = 12;             // states with which a full matrix is always the cheaper one
constexpr std::size_t kMostFilled = 4;            // one entry in so many may be there, else the matrix counts as full
constexpr std::size_t kMostNumbers = 40'000'000;  // kept in sets: a model that needs more is not sparse

/// The states that each register depends on. Equal sets are one object: most registers only hand theirs on.
class StateDependence {
public:
    explicit StateDependence(const SystemPrograms& programs) : s_(programs), of_(programs.registerCount) {}

    /// Nothing: it grew too large.
    std::optional<std::vector<std::vector<int>>> ofRates() {
        for (std::size_t i = 0; i < s_.states.size(); ++i)
            of_[s_.firstState + i] = std::make_shared<const std::vector<int>>(1, static_cast<int>(i));
        for (const Instruction& i : s_.derivative.code)
            if (!pass(i)) return std::nullopt;
        std::vector<std::vector<int>> sets;
        for (const ResultRegister& rate : s_.stateDerivatives) {
            const Set& set = of_[rate.place];
            sets.push_back(set && rate.active[InputsConstant] ? *set : std::vector<int>());
        }
        return sets;
    }

private:
    using Set = std::shared_ptr<const std::vector<int>>;  // ascending; null: of none

    void add(Set& to, const Set& more) {
        if (!more || to == more) return;
        if (!to || std::includes(more->begin(), more->end(), to->begin(), to->end())) {
            to = more;
        } else if (!std::includes(to->begin(), to->end(), more->begin(), more->end())) {
            std::vector<int> both;
            both.reserve(to->size() + more->size());
            std::set_union(to->begin(), to->end(), more->begin(), more->end(), std::back_inserter(both));
            numbers_ += both.size();
            to = std::make_shared<const std::vector<int>>(std::move(both));
        }
    }

    /// False: too much.
    bool pass(const Instruction& i) {
        if (i.opcode == Opcode::SolveLinear) {
            const LinearBlock& block = s_.tables.linear[i.a];
            Set all;
            for (const std::uint32_t reg : block.matrix) add(all, of_[reg]);
            for (const std::uint32_t reg : block.constant) add(all, of_[reg]);
            for (const std::uint32_t unknown : block.unknowns) of_[unknown] = all;
        } else if (i.opcode == Opcode::SolveNonlinear) {
            const NonlinearBlock& block = s_.tables.nonlinear[i.a];
            for (const std::uint32_t unknown : block.unknowns) of_[unknown] = nullptr;
            for (const Instruction& inner : block.body) step(inner);
            Set all;
            for (const std::uint32_t reg : block.residuals) add(all, of_[reg]);
            for (const std::uint32_t unknown : block.unknowns) of_[unknown] = all;
        } else {
            step(i);
        }
        return numbers_ <= kMostNumbers;
    }

    void step(const Instruction& i) {
        const unsigned active = i.active[InputsConstant];
        Set all;
        if (i.kernel[InputsConstant] != Kernel::Value) {
            if ((active & 1u) != 0 && i.opcode != Opcode::Select) add(all, of_[i.a]);
            if ((active & 2u) != 0) add(all, of_[i.b]);
            if ((active & 4u) != 0) add(all, of_[i.c]);
        }
        of_[i.dst] = std::move(all);
    }

    const SystemPrograms& s_;
    std::vector<Set> of_;
    std::size_t numbers_{};
};

/// One group after the other takes each column as the first that has none of its rows yet.
void group(StatePattern& pattern, const std::vector<std::vector<int>>& columnsOfRow) {
    const auto n = static_cast<std::size_t>(pattern.states());
    std::vector<int> takenFor(n, -1);  // by group: the last column that may not join it
    std::fill(pattern.groupOf.begin(), pattern.groupOf.end(), -1);
    for (std::size_t j = 0; j < n; ++j) {
        for (int e = pattern.starts[j]; e < pattern.starts[j + 1]; ++e)
            for (const int other : columnsOfRow[static_cast<std::size_t>(pattern.rows[static_cast<std::size_t>(e)])])
                if (const int g = pattern.groupOf[static_cast<std::size_t>(other)]; g >= 0)
                    takenFor[static_cast<std::size_t>(g)] = static_cast<int>(j);
        int own = 0;
        while (takenFor[static_cast<std::size_t>(own)] == static_cast<int>(j)) ++own;
        pattern.groupOf[j] = own;
        pattern.groups = std::max(pattern.groups, own + 1);
    }
}

}  // namespace

std::optional<StatePattern> statePatternOf(const std::vector<std::vector<int>>& dependences) {
    const std::size_t n = dependences.size();
    std::size_t entries = 0;
    for (const std::vector<int>& row : dependences) entries += row.size();
    if (n <= kMostFull || entries * kMostFilled > n * n) return std::nullopt;
    StatePattern pattern;
    pattern.starts.assign(n + 1, 0);
    pattern.rows.resize(entries);
    pattern.groupOf.resize(n);
    for (const std::vector<int>& row : dependences)
        for (const int j : row) ++pattern.starts[static_cast<std::size_t>(j) + 1];
    for (std::size_t j = 0; j < n; ++j) pattern.starts[j + 1] += pattern.starts[j];
    std::vector<int> next(pattern.starts.begin(), pattern.starts.end() - 1);
    for (std::size_t i = 0; i < n; ++i)
        for (const int j : dependences[i])
            pattern.rows[static_cast<std::size_t>(next[static_cast<std::size_t>(j)]++)] = static_cast<int>(i);
    group(pattern, dependences);
    return pattern;
}

std::optional<StatePattern> statePatternOf(const SystemPrograms& programs) {
    if (programs.states.size() <= kMostFull) return std::nullopt;
    const std::optional<std::vector<std::vector<int>>> dependences = StateDependence(programs).ofRates();
    return dependences ? statePatternOf(*dependences) : std::nullopt;
}

}  // namespace analogon
