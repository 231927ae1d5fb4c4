#include "core/eval/row_code.hpp"

#include <algorithm>
#include <set>

#include "core/eval/recurrence.hpp"
#include "core/eval/runge_kutta_code.hpp"

namespace analogon {
namespace {

using Entity = VectorCode::Entity;
using Space = VectorCode::Space;

/// Whether a value from a table is cheaper than another evaluation.
bool isExpensive(Opcode opcode) {
    switch (opcode) {
        case Opcode::Power:
        case Opcode::Divide:
        case Opcode::Sqrt:
        case Opcode::Exp:
        case Opcode::Log:
        case Opcode::Log10:
        case Opcode::Sin:
        case Opcode::Cos:
        case Opcode::Tan:
        case Opcode::Asin:
        case Opcode::Acos:
        case Opcode::Atan:
        case Opcode::Atan2:
        case Opcode::Sinh:
        case Opcode::Cosh:
        case Opcode::Tanh:
        case Opcode::Floor:
        case Opcode::Ceil:
        case Opcode::Mod:
        case Opcode::Rem:
        case Opcode::Div:
        case Opcode::Table:
        case Opcode::TableDerivative:
            return true;
        default:
            return false;
    }
}

/// What a register depends on: constants alone (both bits), and slots that all run linearly or are all held (one bit);
/// 0: on more.
enum Purity : char { Impure = 0, OfLinear = 1, OfHeld = 2, Constant = 3 };

char purityOf(const Instruction& i, const std::vector<char>& purity) {
    if (i.opcode == Opcode::SolveLinear || i.opcode == Opcode::SolveNonlinear || i.active[InputsConstant] != 0)
        return Impure;
    const std::uint32_t operands[] = {i.a, i.b, i.c};
    char common = Constant;
    for (int k = 0; k < registerOperands(i.opcode); ++k) common = static_cast<char>(common & purity[operands[k]]);
    return common;
}

struct InputTerm {
    std::uint32_t place{};  // register
    bool isHeld{};          // from one row to the next
};

/// Registers of a program that depend on slots of one kind and constants alone, cost something, and are read by what
/// depends on more.
std::vector<InputTerm> inputTerms(const SystemPrograms& s, const Program& program,
                                  const std::vector<ResultRegister>& results, const std::vector<char>& held) {
    std::vector<char> isPure(s.registerCount, 0), isCostly(s.registerCount, 0);
    for (const auto& [reg, value] : s.preloads) isPure[reg] = Constant;
    for (const Instruction& i : s.prelude.code) isPure[i.dst] = purityOf(i, isPure);
    for (int i = 0; i < s.layout.slots; ++i) {
        const auto at = static_cast<std::size_t>(i);
        isPure[s.firstSlot + at] = at < held.size() && held[at] != 0 ? OfHeld : OfLinear;
    }
    std::set<std::uint32_t> terms;
    for (const Instruction& i : program.code) {
        if (i.opcode == Opcode::SolveLinear || i.opcode == Opcode::SolveNonlinear) continue;
        const std::uint32_t operands[] = {i.a, i.b, i.c};
        const int count = registerOperands(i.opcode);
        const char purity = purityOf(i, isPure);
        const bool pure = purity != Impure;
        bool costly = isExpensive(i.opcode);
        for (int k = 0; k < count; ++k) costly = costly || isCostly[operands[k]];
        isPure[i.dst] = purity;
        isCostly[i.dst] = pure && costly;
        for (int k = 0; k < count && !pure; ++k)
            if (isCostly[operands[k]]) terms.insert(operands[k]);
    }
    const auto read = [&](std::uint32_t reg) {
        if (isCostly[reg]) terms.insert(reg);
    };
    for (const Instruction& i : program.code) {
        if (i.opcode == Opcode::SolveLinear) {
            for (const std::uint32_t reg : s.tables.linear[i.a].matrix) read(reg);
            for (const std::uint32_t reg : s.tables.linear[i.a].constant) read(reg);
        } else if (i.opcode == Opcode::SolveNonlinear) {
            for (const Instruction& inner : s.tables.nonlinear[i.a].body)
                for (const std::uint32_t reg : {inner.a, inner.b, inner.c})
                    if (reg < isCostly.size()) read(reg);
            for (const std::uint32_t reg : s.tables.nonlinear[i.a].starts) read(reg);
        }
    }
    for (const ResultRegister& result : results) read(result.place);
    std::vector<InputTerm> found;
    for (const std::uint32_t reg : terms) found.push_back({reg, isPure[reg] == OfHeld});
    return found;
}

class RowEmitter {
public:
    RowEmitter(const SystemPrograms& s, int lanes, VectorTarget target, const std::vector<char>& held, RowCode& code)
        : s_(s), lanes_(lanes), target_(target), held_(held), code_(code) {
        RowLayout& layout = code.layout;
        layout.slots = s.layout.slots;
        layout.lanes = lanes;
        layout.outputs = static_cast<int>(s.outputResults.size());
        layout.states = static_cast<int>(s.states.size());
        if (!code.isExact) rateTerms_ = inputTerms(s, s.derivative, s.stateDerivatives, held);
        outputTerms_ = inputTerms(s, s.output, s.outputResults, {});
        layout.rateTerms = static_cast<int>(rateTerms_.size());
        layout.outputTerms = static_cast<int>(outputTerms_.size());
    }

    bool run() { return walk(true, code_.walk) && (code_.isExact || walk(false, code_.step)) && tabulation(); }

private:
    bool isHeld(int slot) const {
        const auto i = static_cast<std::size_t>(slot);
        return i < held_.size() && held_[i] != 0;
    }

    Entity inRow(ProgramEmitter& emitter, int offset) const {
        return emitter.code().add(Space::Row, static_cast<std::uint32_t>(offset), 1, true);
    }

    bool walk(bool seesOutputs, CompiledProgram& program) {
        ProgramEmitter emitter(s_, lanes_, target_, program);
        VectorCode& out = emitter.code();
        const RowLayout& layout = code_.layout;
        out.repeat(static_cast<std::uint32_t>(layout.size()),
                   seesOutputs ? static_cast<std::uint32_t>(layout.resultSize()) : 0);
        StepPoints points = pointsOf(emitter);
        if (seesOutputs) outputs(emitter, points);
        if (code_.isExact) {
            emitRecurrence(s_, emitter, points.slots[0], points.slots[2], code_.entries, code_.tangents);
        } else {
            emitRungeKutta(s_, emitter, points);
        }
        return emitter.finish();
    }

    StepPoints pointsOf(ProgramEmitter& emitter) const {
        using Op = VectorCode::Operation;
        VectorCode& out = emitter.code();
        const RowLayout& layout = code_.layout;
        const int next = layout.size();
        StepPoints points;
        points.full = inRow(emitter, RowLayout::step);
        points.half = out.emit(Op::Multiply, 1, points.full, emitter.constant(0.5));
        points.third = out.emit(Op::Multiply, 1, points.full, emitter.constant(1.0 / 3.0));
        points.sixth = out.emit(Op::Multiply, 1, points.full, emitter.constant(1.0 / 6.0));
        points.time[0] = inRow(emitter, RowLayout::time);
        points.time[1] = out.emit(Op::Add, 1, points.time[0], points.half);
        points.time[2] = inRow(emitter, next + RowLayout::time);
        for (int i = 0; i < layout.slots; ++i) {
            const Entity begin = inRow(emitter, layout.slot() + i);
            points.slots[0].push_back(begin);
            if (isHeld(i)) {
                for (const int p : {1, 2}) points.slots[p].push_back(begin);
                continue;
            }
            const Entity end = inRow(emitter, next + layout.slot() + i);
            points.slots[1].push_back(
                out.emit(Op::Multiply, 1, emitter.constant(0.5), out.emit(Op::Add, 1, begin, end)));
            points.slots[2].push_back(end);
        }
        for (int i = 0; i < layout.rateTerms; ++i) {
            const auto [reg, isHeld] = rateTerms_[static_cast<std::size_t>(i)];
            const Entity begin = inRow(emitter, layout.rateTerm(0) + i);
            points.known[0][reg] = begin;
            points.known[1][reg] = isHeld ? begin : inRow(emitter, layout.rateTerm(1) + i);
            points.known[2][reg] = isHeld ? begin : inRow(emitter, next + layout.rateTerm(0) + i);
        }
        return points;
    }

    void outputs(ProgramEmitter& emitter, const StepPoints& points) const {
        using Op = VectorCode::Operation;
        VectorCode& out = emitter.code();
        const RowLayout& layout = code_.layout;
        const auto put = [&](Entity from, int offset, int width) {
            const Entity to = out.add(Space::Result, static_cast<std::uint32_t>(offset), width, false);
            out.emitTo(to, Op::Move, from);
            out.store(to);
        };
        emitter.bind(s_.timeRegister, points.time[0]);
        for (int i = 0; i < layout.slots; ++i)
            emitter.bind(s_.firstSlot + static_cast<std::uint32_t>(i), points.slots[0][static_cast<std::size_t>(i)]);
        ProgramEmitter::Known known;
        for (int i = 0; i < layout.outputTerms; ++i)
            known[outputTerms_[static_cast<std::size_t>(i)].place] = inRow(emitter, layout.outputTerm() + i);
        emitter.run(s_.output, nullptr, &known);
        for (int i = 0; i < layout.outputs; ++i) {
            const ResultRegister& y = s_.outputResults[static_cast<std::size_t>(i)];
            put(emitter.value(y.place), layout.value(i), 1);
            for (std::size_t c = 0; c < emitter.chunks().size(); ++c) {
                const ProgramEmitter::Chunk chunk = emitter.chunks()[c];
                const Entity tangent = y.active[InputsConstant] ? emitter.tangent(y.place, c) : emitter.zero(c);
                put(tangent, layout.tangent(i) + static_cast<int>(chunk.at), chunk.width);
            }
        }
        for (int i = 0; i < layout.states; ++i)
            put(emitter.value(s_.firstState + static_cast<std::uint32_t>(i)), layout.state(i), 1);
    }

    bool tabulation() {
        const RowLayout& layout = code_.layout;
        if (layout.terms() == 0) return true;
        ProgramEmitter emitter(s_, 0, target_, code_.tabulation);
        VectorCode& out = emitter.code();
        out.repeat(static_cast<std::uint32_t>(layout.slots), static_cast<std::uint32_t>(layout.terms()));
        for (int i = 0; i < layout.slots; ++i)
            emitter.bind(s_.firstSlot + static_cast<std::uint32_t>(i), inRow(emitter, i));
        int place = 0;
        const auto put = [&](const Program& program, const std::vector<InputTerm>& terms) {
            emitter.run(pureOf(program, terms));
            for (const auto& [reg, isHeld] : terms) {
                const Entity to = out.add(Space::Result, static_cast<std::uint32_t>(place++), 1, false);
                out.emitTo(to, VectorCode::Operation::Move, emitter.value(reg));
                out.store(to);
            }
        };
        put(s_.derivative, rateTerms_);
        put(s_.output, outputTerms_);
        return emitter.finish();
    }

    /// What of a program these registers need.
    static Program pureOf(const Program& program, const std::vector<InputTerm>& terms) {
        std::set<std::uint32_t> needed;
        for (const InputTerm& term : terms) needed.insert(term.place);
        Program pure;
        pure.constants = program.constants;
        for (std::size_t k = program.code.size(); k-- > 0;) {
            const Instruction& i = program.code[k];
            if (i.opcode == Opcode::SolveLinear || i.opcode == Opcode::SolveNonlinear || needed.count(i.dst) == 0)
                continue;
            const std::uint32_t operands[] = {i.a, i.b, i.c};
            for (int o = 0; o < registerOperands(i.opcode); ++o) needed.insert(operands[o]);
            pure.code.push_back(i);
        }
        std::reverse(pure.code.begin(), pure.code.end());
        return pure;
    }

    const SystemPrograms& s_;
    int lanes_{};
    VectorTarget target_{};
    const std::vector<char>& held_;
    RowCode& code_;
    std::vector<InputTerm> rateTerms_, outputTerms_;
};

}  // namespace

std::shared_ptr<const RowCode> compileRows(const SystemPrograms& s, int lanes, bool isExact, VectorTarget target,
                                           const std::vector<char>& held) {
    if (s.layout.hasDerivatives || !s.delays.empty() || s.states.empty()) return nullptr;
    auto code = std::make_shared<RowCode>();
    code->isExact = isExact;
    if (!RowEmitter(s, lanes, target, held, *code).run()) return nullptr;
    return code;
}

}  // namespace analogon
