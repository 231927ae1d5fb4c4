#include "core/eval/program.hpp"

namespace analogon {

int registerOperands(Opcode opcode) {
    switch (opcode) {
        case Opcode::LoadConstant:
        case Opcode::SolveLinear:
        case Opcode::SolveNonlinear:
            return 0;
        case Opcode::Select:
            return 3;
        case Opcode::Add:
        case Opcode::Subtract:
        case Opcode::Multiply:
        case Opcode::Divide:
        case Opcode::Power:
        case Opcode::Less:
        case Opcode::LessEqual:
        case Opcode::Greater:
        case Opcode::GreaterEqual:
        case Opcode::Equal:
        case Opcode::NotEqual:
        case Opcode::And:
        case Opcode::Or:
        case Opcode::Atan2:
        case Opcode::Min:
        case Opcode::Max:
        case Opcode::Mod:
        case Opcode::Rem:
        case Opcode::Div:
            return 2;
        default:
            return 1;
    }
}

Kernel kernelOf(Opcode opcode, unsigned active) {
    if (active == 0) return Kernel::Value;
    switch (opcode) {
        case Opcode::Add:
            return active == 3 ? Kernel::AddBoth : Kernel::AddOne;
        case Opcode::Subtract:
            return active == 3 ? Kernel::SubtractBoth : active == 1 ? Kernel::SubtractFirst : Kernel::SubtractSecond;
        case Opcode::Multiply:
            return active == 3 ? Kernel::MultiplyBoth : Kernel::MultiplyOne;
        case Opcode::Divide:
            return active == 3 ? Kernel::DivideBoth : active == 1 ? Kernel::DivideFirst : Kernel::DivideSecond;
        case Opcode::Negate:
            return Kernel::Negate;
        case Opcode::Square:
            return Kernel::Square;
        case Opcode::Select:
            return Kernel::Select;
        default:
            return registerOperands(opcode) == 1 ? Kernel::Unary : Kernel::Binary;
    }
}

const char* nameOf(Opcode opcode) {
    static constexpr const char* names[] = {
        "const", "copy",  "neg",  "add", "sub",  "mul",  "div",   "pow",    "sqr",    "lt",    "le",   "gt",
        "ge",    "eq",    "ne",   "and", "or",   "not",  "sel",   "abs",    "sign",   "sqrt",  "exp",  "log",
        "log10", "sin",   "cos",  "tan", "asin", "acos", "atan",  "atan2",  "sinh",   "cosh",  "tanh", "min",
        "max",   "floor", "ceil", "mod", "rem",  "idiv", "table", "dtable", "linear", "newton"};
    return names[static_cast<std::size_t>(opcode)];
}

}  // namespace analogon
