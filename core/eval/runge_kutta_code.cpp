#include "core/eval/runge_kutta_code.hpp"

#include <algorithm>

namespace analogon {
namespace {

using Entity = VectorCode::Entity;
using Op = VectorCode::Operation;

bool isBlock(const Instruction& i) { return i.opcode == Opcode::SolveLinear || i.opcode == Opcode::SolveNonlinear; }

class StepEmitter {
public:
    StepEmitter(const SystemPrograms& s, ProgramEmitter& emitter, const StepPoints& points)
        : s_(s), emitter_(emitter), code_(emitter.code()), points_(points) {}

    void run() {
        loadState();
        const std::vector<char> varies = dependsOnStates();
        for (int stage = 0; stage < 4; ++stage) {
            constexpr int place[] = {0, 1, 1, 2};
            const int p = place[stage];
            emitter_.bind(s_.timeRegister, points_.time[p]);
            for (std::size_t i = 0; i < points_.slots[p].size(); ++i)
                emitter_.bind(s_.firstSlot + static_cast<std::uint32_t>(i), points_.slots[p][i]);
            // The two stages in the middle see the same inputs.
            emitter_.run(s_.derivative, stage == 2 ? &varies : nullptr, &points_.known[p]);
            advance(stage);
        }
        for (std::size_t i = 0; i < s_.states.size(); ++i) finish(i);
    }

private:
    std::size_t chunkCount() const { return emitter_.chunks().size(); }
    std::uint32_t stateRegister(std::size_t i) const { return s_.firstState + static_cast<std::uint32_t>(i); }

    std::vector<char> dependsOnStates() const {
        std::vector<char> varies(s_.registerCount, 0);
        for (std::size_t i = 0; i < s_.states.size(); ++i) varies[stateRegister(i)] = 1;
        for (const Instruction& i : s_.derivative.code) {
            if (isBlock(i)) {
                const auto& unknowns = i.opcode == Opcode::SolveLinear ? s_.tables.linear[i.a].unknowns
                                                                       : s_.tables.nonlinear[i.a].unknowns;
                for (const std::uint32_t reg : unknowns) varies[reg] = 1;
                continue;
            }
            const std::uint32_t operands[] = {i.a, i.b, i.c};
            for (int k = 0; k < registerOperands(i.opcode); ++k)
                if (varies[operands[k]]) varies[i.dst] = 1;
        }
        return varies;
    }

    /// Blocks write where the states stand, so a copy is kept.
    void loadState() {
        const bool isCopied = std::any_of(s_.derivative.code.begin(), s_.derivative.code.end(), isBlock);
        for (std::size_t i = 0; i < s_.states.size(); ++i) {
            const std::uint32_t reg = stateRegister(i);
            State state;
            state.value = emitter_.value(reg);
            if (isCopied) state.value = code_.emit(Op::Move, 1, state.value);
            emitter_.bind(reg, state.value);
            for (std::size_t c = 0; c < chunkCount(); ++c) {
                Entity e = emitter_.tangent(reg, c);
                if (isCopied) e = code_.emit(Op::Move, emitter_.chunks()[c].width, e);
                state.tangents.push_back(e);
                emitter_.bindTangent(reg, c, e);
            }
            begin_.push_back(state);
        }
        sum_ = begin_;
    }

    /// sum + weight * slope, and the state at which the next stage looks.
    void advance(int stage) {
        const Entity weight = stage == 0 || stage == 3 ? points_.sixth : points_.third;
        const Entity reach = stage == 2 ? points_.full : points_.half;
        std::vector<State> next = begin_;
        for (std::size_t i = 0; i < s_.states.size(); ++i) {
            const ResultRegister& slope = s_.stateDerivatives[i];
            const Entity k = emitter_.value(slope.place);
            sum_[i].value = code_.emitAdvance(weight, k, sum_[i].value);
            if (stage < 3) next[i].value = code_.emitAdvance(reach, k, begin_[i].value);
            for (std::size_t c = 0; c < chunkCount() && slope.active[InputsConstant]; ++c) {
                const int width = emitter_.chunks()[c].width;
                const Entity dk = emitter_.tangent(slope.place, c);
                sum_[i].tangents[c] = code_.emit(Op::MultiplyAdd, width, weight, dk, sum_[i].tangents[c]);
                if (stage < 3)
                    next[i].tangents[c] = code_.emit(Op::MultiplyAdd, width, reach, dk, begin_[i].tangents[c]);
            }
        }
        for (std::size_t i = 0; i < s_.states.size() && stage < 3; ++i) {
            emitter_.bind(stateRegister(i), next[i].value);
            for (std::size_t c = 0; c < chunkCount(); ++c)
                emitter_.bindTangent(stateRegister(i), c, next[i].tangents[c]);
        }
    }

    void finish(std::size_t i) {
        const std::uint32_t reg = stateRegister(i);
        emitter_.bind(reg, sum_[i].value);
        const ResultRegister result{reg, {1, 1}};
        for (std::size_t c = 0; c < chunkCount(); ++c) emitter_.bindTangent(reg, c, sum_[i].tangents[c]);
        emitter_.storeResult(result);
    }

    struct State {
        Entity value{};
        std::vector<Entity> tangents;
    };
    const SystemPrograms& s_;
    ProgramEmitter& emitter_;
    VectorCode& code_;
    const StepPoints& points_;
    std::vector<State> begin_, sum_;
};

}  // namespace

void emitRungeKutta(const SystemPrograms& programs, ProgramEmitter& emitter, const StepPoints& points) {
    StepEmitter(programs, emitter, points).run();
}

}  // namespace analogon
