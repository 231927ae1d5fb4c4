#pragma once

#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/eval/program.hpp"
#include "core/structure/rewrite.hpp"
#include "core/structure/structure.hpp"

namespace analogon {

/// What a value depends on, and where it stands.
struct RegisterInfo {
    enum Stage : std::uint8_t { Parameter, Dynamic };
    Stage stage{Dynamic};
    std::array<std::uint8_t, 2> active{};  // has tangents, by TangentMode
    std::uint8_t degree{};  // in states and inputs: 0, 1 (affine, coefficients of parameters alone), 2 (anything else)
    bool isScoped{};        // depends on the unknowns of the nonlinear block that is being lowered
    bool isOwn{};           // of one program: place counts from the end of the shared registers
    std::uint32_t place{};
};

/// A delayed signal as it enters the programs.
struct DelaySlot {
    ExpressionId signal;  // what is delayed: an input variable, or any expression (a tap)
    ExpressionId time;    // delay time, over parameters
    int slot{};           // position in u
    int input{-1}, tap{-1};
    bool isNegated{};  // the signal is minus the input
};

/// The order of u.
struct InputLayout {
    int inputs{};
    bool hasDerivatives{};
    std::vector<char> differentiated;  // by input; empty: none is
    std::vector<DelaySlot> delays;
    std::vector<ExpressionId> taps;
    int slots{};
};

/// Lowers parts of a structure to programs. Equal nodes become one register; what depends on parameters alone
/// goes to the prelude, which every other program relies on. Registers are virtual until `place`.
class Lowering {
public:
    /// Which solution of the unknowns a program sees.
    enum class Given { States, Nothing };

    Lowering(const Structure& structure, const InputLayout& layout, ProgramTables& tables);

    /// Where blocks of the programs to come are listed.
    void useTables(ProgramTables& tables) { tables_ = &tables; }
    void begin(Given given);
    /// Emits all blocks that the expressions need; then registers of them can be asked for.
    void require(std::span<const ExpressionId> expressions);
    std::uint32_t registerOf(ExpressionId expression) { return lower(expression); }
    /// Whether the program under way has, or can make, a register for the node (require() came before).
    bool isKnown(ExpressionId node) const;
    std::uint32_t number(double value) { return constant(value); }
    std::uint32_t difference(std::uint32_t a, std::uint32_t b) { return emit(Opcode::Subtract, a, b); }
    ExpressionId variableNode(VariableId id) const { return variableNode_[id.value]; }
    Program end();

    /// Gives the shared registers their places. From here on programs compute for themselves what the prelude
    /// does not hold yet.
    void closePrelude();
    /// From virtual registers to places; after closePrelude().
    void finish(Program& program);
    std::uint32_t place(std::uint32_t reg) const {
        return registers_[reg].place + (registers_[reg].isOwn ? sharedCount_ : 0);
    }

    const RegisterInfo& info(std::uint32_t reg) const { return registers_[reg]; }
    std::uint32_t guessCount() const { return guessCount_; }
    Program& prelude() { return prelude_; }
    /// Constants, set once when a workspace is made.
    const std::vector<std::pair<std::uint32_t, double>>& preloads() const { return preloads_; }
    std::uint32_t parameterRegister(std::size_t i) const { return parameterRegisters_[i]; }
    std::uint32_t stateRegister(std::size_t i) const { return stateRegisters_[i]; }
    std::uint32_t slotRegister(std::size_t i) const { return slotRegisters_[i]; }
    std::uint32_t timeRegister() const { return timeRegister_; }
    /// The blocks the program under way has used, in order.
    const std::vector<const SolutionBlock*>& usedBlocks() const { return used_; }
    /// The delayed taps the program under way has read (numbers in InputLayout::delays).
    const std::vector<int>& usedTapDelays() const { return usedTapDelays_; }

private:
    void createShared();
    std::uint32_t newRegister(const RegisterInfo& info);
    std::uint32_t constant(double value);
    std::uint32_t lower(ExpressionId expression);
    std::uint32_t lowerNode(ExpressionId expression, const ExpressionNode& node);
    std::uint32_t lowerLeaf(const ExpressionNode& node);
    std::uint32_t lowerDelay(ExpressionId expression);
    std::uint32_t lowerPower(const ExpressionNode& node);
    std::uint32_t powerOf(std::uint32_t a, double exponent);
    std::uint32_t emit(Opcode opcode, std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0);
    std::uint8_t degreeOf(const Instruction& instruction) const;
    void lowerBlock(const SolutionBlock& block);
    /// Indices of what is not 0 in every model.
    std::vector<std::uint32_t> entriesOf(const std::vector<ExpressionId>& matrix) const;
    void lowerLinear(const SolutionBlock& block);
    void lowerNonlinear(const SolutionBlock& block);
    void define(ExpressionId node, std::uint32_t reg);
    bool isPure(ExpressionId expression);
    std::string nameOf(ExpressionId node) const;
    void relocate(Instruction& instruction) const;
    /// A shorter way to the same value, if there is one: what follows one another in a step is what takes the time.
    std::optional<std::uint32_t> shortened(Opcode opcode, std::uint32_t a, std::uint32_t b);
    const Instruction* madeBy(std::uint32_t reg, Opcode opcode) const;
    std::vector<Instruction>& target(const RegisterInfo& info);

    const Structure& structure_;
    const InputLayout& layout_;
    ProgramTables* tables_;
    const ExpressionPool& pool_;
    LeafCollector collect_;
    std::vector<RegisterInfo> registers_;
    std::map<std::uint32_t, Instruction> made_;  // the instruction behind a register
    std::vector<std::uint32_t> shared_, local_;  // register by node: for all programs, for the one under way
    std::vector<std::uint32_t> localNodes_;      // nodes entered in local_
    std::vector<ExpressionId> scopedNodes_;      // those of the nonlinear block under way
    std::vector<std::int8_t> isPure_;            // by node: over parameters alone; -1 not asked yet
    std::vector<ExpressionId> variableNode_, derivativeNode_;  // by variable; invalid: no such node
    std::vector<int> blockOf_, initialBlockOf_;                // by node: the block that solves for it; -1 none
    std::vector<char> isLowered_;                              // by block, in the program under way
    std::unordered_map<std::uint32_t, const StartValue*> startOf_;
    std::unordered_map<std::uint32_t, const SolutionBlock*> parameterBlockOf_;
    std::unordered_map<std::uint32_t, int> delayOf_;
    std::unordered_map<std::uint64_t, std::uint32_t> constants_;        // bits of the value -> register
    std::unordered_map<std::uint32_t, std::uint32_t> reciprocals_;      // of registers of the prelude
    std::map<std::pair<std::uint32_t, double>, std::uint32_t> powers_;  // by base and exponent, of what is under way
    Program prelude_, program_;
    std::vector<Instruction>* scope_{};  // body of the nonlinear block under way
    Given given_{Given::States};
    bool isPreludeClosed_{};
    std::uint32_t ownCount_{}, sharedCount_{}, guessCount_{};
    std::vector<std::uint32_t> sharedRegisters_;
    std::vector<std::pair<std::uint32_t, double>> preloads_;
    std::vector<std::uint32_t> parameterRegisters_, stateRegisters_, slotRegisters_;
    std::uint32_t timeRegister_{};
    std::vector<const SolutionBlock*> used_;
    std::vector<int> usedTapDelays_;
};

}  // namespace analogon
