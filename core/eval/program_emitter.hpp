#pragma once

#include <map>
#include <vector>

#include "core/eval/program_code.hpp"

namespace analogon {

/// Entities of registers, and the translation of programs over them.
class ProgramEmitter {
public:
    using Entity = VectorCode::Entity;
    using Op = VectorCode::Operation;
    static constexpr Entity none = VectorCode::none;

    ProgramEmitter(const SystemPrograms& programs, int lanes, VectorTarget target, CompiledProgram& out,
                   TangentMode mode = InputsConstant)
        : s_(programs), out_(out), lanes_(static_cast<std::uint32_t>(lanes)), mode_(mode), target_(target) {
        const auto widest = static_cast<std::uint32_t>(VectorCode::vectorWidth(target));
        for (std::uint32_t at = 0; at < lanes_;) {
            const std::uint32_t width = lanes_ - at >= widest ? widest : 4;
            chunks_.push_back({at, static_cast<int>(width)});
            at += width;
        }
        values_.assign(programs.registerCount, none);
        tangents_.assign(programs.registerCount * chunks_.size(), none);
        for (const Chunk& chunk : chunks_) zeros_.push_back(inMemory(chunk.width));
    }

    struct Chunk {
        std::uint32_t at{};
        int width{};
    };
    const std::vector<Chunk>& chunks() const { return chunks_; }
    VectorCode& code() { return code_; }

    Entity constant(double value) {
        const auto [at, isNew] = constants_.try_emplace(value, none);
        if (isNew) {
            at->second = inMemory(1);
            out_.constants.emplace_back(code_.homes()[at->second].offset, value);
        }
        return at->second;
    }
    /// A place of the scratch memory that holds something when the function is called.
    Entity inMemory(int width) {
        const Entity fresh = code_.fresh(width);
        const VectorCode::Home home = code_.homes()[fresh];
        return code_.add(home.space, home.offset, width, true);
    }
    std::uint32_t offsetOf(Entity e) const { return code_.homes()[e].offset; }

    void bind(std::uint32_t reg, Entity value) { values_[reg] = value; }
    void bindTangent(std::uint32_t reg, std::size_t chunk, Entity tangent) {
        tangents_[reg * chunks_.size() + chunk] = tangent;
    }
    Entity value(std::uint32_t reg) {
        Entity& e = values_[reg];
        if (e == none) e = code_.add(VectorCode::Space::Values, reg, 1, true);
        return e;
    }
    Entity tangent(std::uint32_t reg, std::size_t chunk) {
        Entity& e = tangents_[reg * chunks_.size() + chunk];
        if (e == none) e = tangentHome(reg, chunk, true);
        return e;
    }
    Entity zero(std::size_t chunk) const { return zeros_[chunk]; }

    /// Puts what stands for a register where the interpreter has it, and returns the entity there.
    Entity settle(std::uint32_t reg) {
        const Entity e = value(reg);
        if (isAt(e, VectorCode::Space::Values, reg)) return e;
        const Entity there = code_.add(VectorCode::Space::Values, reg, 1, false);
        code_.emitTo(there, Op::Move, e);
        return there;
    }
    Entity settleTangent(std::uint32_t reg, std::size_t chunk) {
        const Entity e = tangent(reg, chunk);
        if (isAt(e, VectorCode::Space::Tangents, reg * lanes_ + chunks_[chunk].at)) return e;
        const Entity there = tangentHome(reg, chunk, false);
        code_.emitTo(there, Op::Move, e);
        return there;
    }
    void storeResult(const ResultRegister& result) {
        code_.store(settle(result.place));
        for (std::size_t c = 0; c < chunks_.size() && result.active[static_cast<std::size_t>(mode_)]; ++c)
            code_.store(settleTangent(result.place, c));
    }

    /// With `varies` (by register) only what depends on one of these; the rest is as it was the last time. What is in
    /// `known` is not computed.
    using Known = std::map<std::uint32_t, Entity>;
    void run(const Program& program, const std::vector<char>* varies = nullptr, const Known* known = nullptr) {
        for (const Instruction& i : program.code) {
            const bool isBlock = i.opcode == Opcode::SolveLinear || i.opcode == Opcode::SolveNonlinear;
            if (varies && !isBlock && !(*varies)[i.dst]) continue;
            if (known && !isBlock && known->count(i.dst) > 0) {
                bind(i.dst, known->at(i.dst));
                continue;
            }
            if (isBlock) {
                block(i);
            } else {
                instruction(i, program);
            }
        }
    }

    /// The body of a nonlinear block: everything it computes goes to its register.
    void runBody(const NonlinearBlock& block) {
        static const Program noConstants;
        for (const Instruction& i : block.body) instruction(i, noConstants);
        for (const Instruction& i : block.body) code_.store(settle(i.dst));
        for (std::size_t i = 0; i < block.residuals.size(); ++i)
            if (block.activeOf[i][mode_]) storeResult({block.residuals[i], {1, 1}});
    }

    bool finish() {
        out_.function = VectorFunction::make(code_, target_);
        if (!out_.function) return false;
        out_.scratchSize = out_.function->scratchSize() + 8;
        return true;
    }

private:
    Entity tangentHome(std::uint32_t reg, std::size_t chunk, bool isInMemory) {
        return code_.add(VectorCode::Space::Tangents, reg * lanes_ + chunks_[chunk].at, chunks_[chunk].width,
                         isInMemory);
    }
    bool isAt(Entity e, VectorCode::Space space, std::uint32_t offset) const {
        return code_.homes()[e].space == space && code_.homes()[e].offset == offset;
    }

    Entity emit(Op operation, Entity a, Entity b = none, Entity c = none) { return code_.emit(operation, 1, a, b, c); }
    Entity negative(Entity a) { return emit(Op::Subtract, constant(0), a); }
    Entity unary(double (*function)(double), Entity a);
    Entity binary(double (*function)(double, double), Entity a, Entity b);
    Entity ternary(double (*function)(double, double, double), Entity a, Entity b, Entity c);
    Entity lookUp(double (*function)(const void*, double), const LookupTable& table, Entity a);

    Entity valueOf(const Instruction& i, const Program& program, Entity a, Entity b, Entity c);
    Entity slopeA(const Instruction& i, Entity a, Entity b, Entity value);
    Entity slopeB(const Instruction& i, Entity a, Entity b, Entity value);
    void instruction(const Instruction& i, const Program& program);
    void tangentsOf(const Instruction& i, Entity a, Entity b, Entity value);
    void scaled(const Instruction& i, Entity factor, std::uint32_t from);
    void block(const Instruction& i);
    void settleReads(const Instruction& i, std::vector<Entity>& reads);

    template <class Make>
    void perChunk(std::uint32_t reg, Make&& make) {
        for (std::size_t c = 0; c < chunks_.size(); ++c) bindTangent(reg, c, make(c, chunks_[c].width));
    }

    const SystemPrograms& s_;
    CompiledProgram& out_;
    std::uint32_t lanes_{};
    TangentMode mode_{};
    VectorTarget target_{};
    std::vector<Chunk> chunks_;
    VectorCode code_;
    std::vector<Entity> values_, tangents_, zeros_;
    std::map<double, Entity> constants_;
};

}  // namespace analogon
