#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/eval/system_builder.hpp"
#include "core/eval/vector_code.hpp"

namespace analogon {

/// A function with the image of its scratch memory: constants it reads, the rest zero.
struct CompiledProgram {
    std::unique_ptr<const VectorFunction> function;
    std::vector<std::pair<std::uint32_t, double>> constants;
    std::size_t scratchSize{};
    struct Block;
    std::vector<std::unique_ptr<const Block>> blocks;

    CompiledProgram();
    CompiledProgram(CompiledProgram&&) noexcept;
    CompiledProgram& operator=(CompiledProgram&&) noexcept;
    ~CompiledProgram();
};

/// Where the caller of a Runge-Kutta step puts its arguments in the scratch memory.
struct StepArguments {
    std::uint32_t fullStep{}, halfStep{}, thirdStep{}, sixthStep{};  // h, h/2, h/3, h/6
    std::uint32_t time[3]{};                                         // at its begin, middle, end
    std::uint32_t slots[3]{};                                        // first of u there
};

/// The programs of a system as machine code, for one number of lanes (0: values alone).
struct SystemCode {
    CompiledProgram derivative, output;  // as runTangents or runValues of the program, results in their registers
    /// The classic Runge-Kutta method, from and to the registers of the states; for inputs without tangents alone.
    CompiledProgram step;
    StepArguments arguments;

    /// What Newton's method evaluates in a nonlinear block, by its number in the tables of the programs.
    struct Body {
        CompiledProgram values, tangents;
    };
    std::vector<Body> bodies;
    const ProgramTables* tables{};
};

/// Null: no machine code here.
std::shared_ptr<const SystemCode> compileCode(const SystemPrograms& programs, int lanes, TangentMode mode,
                                              VectorTarget target);

}  // namespace analogon
