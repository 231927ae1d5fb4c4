#include "core/eval/c_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/eval/equations_text.hpp"
#include "core/eval/system_builder.hpp"

namespace analogon {

namespace {

/// A number that C reads back as the same double.
std::string literal(double value) {
    if (std::isnan(value)) return "NAN";
    if (std::isinf(value)) return value > 0 ? "HUGE_VAL" : "(-HUGE_VAL)";
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return std::signbit(value) ? "(" + text + ")" : text;
}

std::string stringLiteral(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\' || c == '?') result += '\\';
        result += c;
    }
    return result + "\"";
}

/// A name as it may stand in a comment.
std::string comment(std::string name) {
    for (auto at = name.find("*/"); at != std::string::npos; at = name.find("*/")) name.replace(at, 2, "* /");
    return "/* " + name + " */";
}

template <class T, class Print>
std::string list(const std::vector<T>& values, Print print) {
    std::string text;
    for (const T& value : values) text += (text.empty() ? "" : ", ") + print(value);
    return text.empty() ? "0" : text;  // C has no empty arrays
}

template <class T>
std::string intArray(const std::string& name, const std::vector<T>& values) {
    return fmt::format("static const int {}[] = {{{}}};\n", name, list(values, [](T v) { return std::to_string(v); }));
}

std::string doubleArray(const std::string& name, const std::vector<double>& values) {
    return fmt::format("static const double {}[] = {{{}}};\n", name, list(values, literal));
}

class Writer {
public:
    explicit Writer(const SystemPrograms& programs) : s_(programs) {
        for (const auto& [reg, value] : s_.preloads) constants_.emplace(reg, value);
    }

    std::string text() {
        std::string text = sizes();
        text += equationsText;
        text += "\n";
        tables(text);
        text += "static inline void loadConstants(double* v) {\n    (void)v;\n";
        for (const auto& [reg, value] : s_.preloads) text += fmt::format("    v[{}] = {};\n", reg, literal(value));
        text += "}\n\n";
        program(text, "fromParameters", s_.prelude);
        program(text, "initialProgram", s_.initial);
        program(text, "derivativeProgram", s_.derivative);
        program(text, "outputProgram", s_.output);
        program(text, "rootProgram", s_.root);
        functions(text);
        return text;
    }

private:
    std::string sizes() const {
        std::size_t largest = 0;
        for (const LinearBlock& block : s_.tables.linear) largest = std::max(largest, block.unknowns.size());
        for (const NonlinearBlock& block : s_.tables.nonlinear) largest = std::max(largest, block.unknowns.size());
        std::string text = "#include <float.h>\n#include <math.h>\n#include <string.h>\n\n";
        const auto define = [&](const char* name, std::size_t value) {
            text += fmt::format("#define {} {}\n", name, value);
        };
        define("STATES", s_.states.size());
        define("INPUTS", s_.inputs.size());
        define("INPUT_SLOPES", s_.layout.hasDerivatives ? s_.inputs.size() : 0);
        define("DELAYS", s_.delays.size());
        define("SLOTS", static_cast<std::size_t>(s_.layout.slots));
        define("OUTPUTS", s_.outputs.size());
        define("PARAMETERS", s_.parameters.size());
        define("TAPS", s_.layout.taps.size());
        define("ROOTS", s_.rootRegisters.size());
        define("REGISTERS", s_.registerCount);
        define("GUESSES", s_.guessCount);
        define("LARGEST_BLOCK", largest);
        return text + "\n";
    }

    void tables(std::string& text) const {
        for (std::size_t i = 0; i < s_.tables.lookups.size(); ++i) {
            LookupTable table = s_.tables.lookups[i];
            table.prepare();
            text += doubleArray(fmt::format("table{}x", i), table.x) + doubleArray(fmt::format("table{}y", i), table.y);
            const bool isCubic = table.interpolation == LookupTable::Interpolation::MonotoneCubic ||
                                 table.interpolation == LookupTable::Interpolation::Hermite;
            if (isCubic) text += doubleArray(fmt::format("table{}slopes", i), table.slopes);
            text += fmt::format(
                "static const Table table{0} = {{{1}, {2}, {3}, table{0}x, table{0}y, {4}, {5}, {6}, {7}, {8}}};\n\n",
                i, table.x.size(), isCubic ? 1 : 0, table.order, isCubic ? fmt::format("table{}slopes", i) : "0",
                table.interpolation == LookupTable::Interpolation::Constant ? 1 : 0,
                static_cast<int>(table.extrapolation), std::isfinite(table.begin) ? literal(table.begin) : "-HUGE_VAL",
                literal(table.shift));
        }
    }

    std::string operand(std::uint32_t reg) const {
        const auto constant = constants_.find(reg);
        return constant == constants_.end() ? fmt::format("v[{}]", reg) : literal(constant->second);
    }

    std::string valueOf(const Instruction& i, const Program& program) const {
        if (i.opcode == Opcode::LoadConstant) return literal(program.constants[i.a]);
        const int operands = registerOperands(i.opcode);
        const std::string a = operand(i.a), b = operands > 1 ? operand(i.b) : "", c = operands > 2 ? operand(i.c) : "";
        const auto infix = [&](const char* sign) { return fmt::format("{} {} {}", a, sign, b); };
        const auto call = [&](const char* function) {
            return operands > 1 ? fmt::format("{}({}, {})", function, a, b) : fmt::format("{}({})", function, a);
        };
        switch (i.opcode) {
            // clang-format off
            case Opcode::Copy: return a;
            case Opcode::Negate: return "-" + a;
            case Opcode::Add: return infix("+");
            case Opcode::Subtract: return infix("-");
            case Opcode::Multiply: return infix("*");
            case Opcode::Divide: return infix("/");
            case Opcode::Power: return call("pow");
            case Opcode::Square: return fmt::format("{0} * {0}", a);
            case Opcode::Less: return infix("<");
            case Opcode::LessEqual: return infix("<=");
            case Opcode::Greater: return infix(">");
            case Opcode::GreaterEqual: return infix(">=");
            case Opcode::Equal: return infix("==");
            case Opcode::NotEqual: return infix("!=");
            case Opcode::And: return fmt::format("{} != 0 && {} != 0", a, b);
            case Opcode::Or: return fmt::format("{} != 0 || {} != 0", a, b);
            case Opcode::Not: return fmt::format("{} == 0", a);
            case Opcode::Select: return fmt::format("{} != 0 ? {} : {}", a, b, c);
            case Opcode::Abs: return call("fabs");
            case Opcode::Sign: return call("signOf");
            case Opcode::Sqrt: return call("sqrt");
            case Opcode::Exp: return call("exp");
            case Opcode::Log: return call("log");
            case Opcode::Log10: return call("log10");
            case Opcode::Sin: return call("sin");
            case Opcode::Cos: return call("cos");
            case Opcode::Tan: return call("tan");
            case Opcode::Asin: return call("asin");
            case Opcode::Acos: return call("acos");
            case Opcode::Atan: return call("atan");
            case Opcode::Atan2: return call("atan2");
            case Opcode::Sinh: return call("sinh");
            case Opcode::Cosh: return call("cosh");
            case Opcode::Tanh: return call("tanh");
            case Opcode::Min: return call("minOf");
            case Opcode::Max: return call("maxOf");
            case Opcode::Floor: return call("floor");
            case Opcode::Ceil: return call("ceil");
            case Opcode::Mod: return call("modOf");
            case Opcode::Rem: return call("remOf");
            case Opcode::Div: return fmt::format("trunc({} / {})", a, b);
            case Opcode::Table: return fmt::format("lookUp(&table{}, {}, 0)", i.b, a);
            case Opcode::TableDerivative: return fmt::format("lookUp(&table{}, {}, 1)", i.b, a);
            case Opcode::LoadConstant:
            case Opcode::SolveLinear:
            case Opcode::SolveNonlinear: break;
                // clang-format on
        }
        return "0";
    }

    void linear(std::string& text, std::uint32_t number) const {
        const LinearBlock& block = s_.tables.linear[number];
        const std::string name = fmt::format("linear{}", number);
        text += intArray(name + "unknowns", block.unknowns) + intArray(name + "matrix", block.matrix) +
                intArray(name + "constant", block.constant);
        text += fmt::format("static const LinearBlock {0} = {{{1}, {0}unknowns, {0}matrix, {0}constant, {2}}};\n\n",
                            name, block.unknowns.size(), stringLiteral(block.names.front()));
    }

    void nonlinear(std::string& text, std::uint32_t number) const {
        const NonlinearBlock& block = s_.tables.nonlinear[number];
        const std::string name = fmt::format("nonlinear{}", number);
        text += intArray(name + "unknowns", block.unknowns) + intArray(name + "residuals", block.residuals) +
                intArray(name + "jacobian", block.jacobian) + intArray(name + "starts", block.starts) +
                doubleArray(name + "nominal", block.nominal);
        text += fmt::format("static void {}body(double* v) {{\n    (void)v;\n", name);
        static const Program noConstants;
        for (const Instruction& i : block.body)
            text += fmt::format("    v[{}] = {};\n", i.dst, valueOf(i, noConstants));
        text += "}\n";
        text += fmt::format(
            "static const NonlinearBlock {0} = {{{1}, {2}, {0}unknowns, {0}residuals, {0}jacobian, {0}starts, "
            "{0}nominal, {0}body, {3}}};\n\n",
            name, block.unknowns.size(), block.guess, stringLiteral(block.names.front()));
    }

    void program(std::string& text, const char* name, const Program& program) const {
        for (const Instruction& i : program.code) {
            if (i.opcode == Opcode::SolveLinear) linear(text, i.a);
            if (i.opcode == Opcode::SolveNonlinear) nonlinear(text, i.a);
        }
        std::map<std::uint32_t, std::string> nameOf;
        for (const auto& [reg, unknown] : program.watched) nameOf.emplace(reg, unknown);
        text += fmt::format("static const Watched {}Watched[] = {{", name);
        for (const auto& [reg, unknown] : program.watched)
            text += fmt::format("{{{}, {}}}, ", reg, stringLiteral(unknown));
        text += "{0, 0}};\n";
        text += fmt::format("static int {}(Equations* e) {{\n    double* const v = e->v;\n    (void)v;\n", name);
        for (const Instruction& i : program.code) {
            if (i.opcode == Opcode::SolveLinear) {
                text += fmt::format("    if (!solveLinear(e, &linear{})) return 0;\n", i.a);
            } else if (i.opcode == Opcode::SolveNonlinear) {
                text += fmt::format("    if (!solveNonlinear(e, &nonlinear{})) return 0;\n", i.a);
            } else {
                const auto named = nameOf.find(i.dst);
                text += fmt::format("    v[{}] = {};{}\n", i.dst, valueOf(i, program),
                                    named == nameOf.end() ? "" : " " + comment(named->second));
            }
        }
        text += "    return 1;\n}\n\n";
    }

    /// Results of a program into `to`, which must be finite.
    static void results(std::string& text, const char* program, const std::vector<ResultRegister>& from,
                        const char* to) {
        for (std::size_t i = 0; i < from.size(); ++i)
            text += fmt::format("    {}[{}] = e->v[{}];\n", to, i, from[i].place);
        text += fmt::format(
            "    return allFinite({0}, {1}) ? 1 : blame(e, {2}Watched, (int)(sizeof {2}Watched / sizeof *{2}Watched) - "
            "1);\n}}\n\n",
            to, from.size(), program);
    }

    void at(std::string& text) const {
        text += fmt::format("    e->v[{}] = t;\n", s_.timeRegister);
        text += fmt::format("    if (x) memcpy(e->v + {}, x, STATES * sizeof(double));\n", s_.firstState);
        text += fmt::format("    memcpy(e->v + {}, u, SLOTS * sizeof(double));\n", s_.firstSlot);
    }

    void functions(std::string& text) const {
        text += "static inline void setAt(Equations* e, double t, const double* x, const double* u) {\n";
        at(text);
        text += "}\n\n";
        text += "/* Takes the parameters and evaluates what depends on nothing else. */\n";
        text += "static inline int setParameters(Equations* e, const double* p) {\n    loadConstants(e->v);\n";
        text += fmt::format("    memcpy(e->v + {}, p, PARAMETERS * sizeof(double));\n", s_.firstParameter);
        text += "    memset(e->hasGuess, 0, sizeof e->hasGuess);\n    return fromParameters(e);\n}\n\n";
        text += "static inline int initialise(Equations* e, double t, const double* u, double* x) {\n";
        text += "    memset(e->hasGuess, 0, sizeof e->hasGuess);\n    setAt(e, t, 0, u);\n";
        text += "    if (!initialProgram(e)) return 0;\n    (void)x;\n";
        results(text, "initialProgram", s_.initialStates, "x");
        const auto function = [&](const char* name, const char* program, const std::vector<ResultRegister>& from,
                                  const char* to) {
            text += fmt::format(
                "static inline int {}(Equations* e, double t, const double* x, const double* u, double* {}) {{\n"
                "    setAt(e, t, x, u);\n    if (!{}(e)) return 0;\n    (void){};\n",
                name, to, program, to);
            results(text, program, from, to);
        };
        function("derivatives", "derivativeProgram", s_.stateDerivatives, "xdot");
        function("outputs", "outputProgram", s_.outputResults, "y");
        function("roots", "rootProgram", s_.rootRegisters, "r");
        text += "/* The signals that are delayed somewhere, after outputs(). */\n";
        text += "static inline int taps(Equations* e, double* z) {\n    (void)z;\n";
        results(text, "outputProgram", s_.tapResults, "z");
        text += "static inline void delayTimes(const Equations* e, double* times) {\n    (void)e;\n    (void)times;\n";
        for (std::size_t i = 0; i < s_.delayTimes.size(); ++i)
            text += fmt::format("    times[{}] = e->v[{}];\n", i, s_.delayTimes[i].place);
        text += "}\n";
    }

    const SystemPrograms& s_;
    std::map<std::uint32_t, double> constants_;
};

/// Follows parameters, states and inputs through the programs.
class DependenceAnalysis {
public:
    explicit DependenceAnalysis(const SystemPrograms& programs) : s_(programs), of_(programs.registerCount) {
        const auto seed = [&](std::uint32_t first, std::size_t count, std::set<int> Leaves::*kind) {
            for (std::size_t i = 0; i < count; ++i) (of_[first + i].*kind).insert(static_cast<int>(i));
        };
        seed(s_.firstParameter, s_.parameters.size(), &Leaves::parameters);
        seed(s_.firstState, s_.states.size(), &Leaves::states);
        seed(s_.firstSlot, s_.inputs.size(), &Leaves::inputs);
        if (s_.layout.hasDerivatives)
            seed(s_.firstSlot + static_cast<std::uint32_t>(s_.inputs.size()), s_.inputs.size(), &Leaves::inputs);
        run(s_.prelude);
    }

    std::vector<DependsOn> of(const Program& program, const std::vector<ResultRegister>& results) {
        run(program);
        return of(results);
    }
    std::vector<DependsOn> of(const std::vector<ResultRegister>& results) const {
        std::vector<DependsOn> out;
        for (const ResultRegister& result : results) {
            const Leaves& leaves = of_[result.place];
            out.push_back({{leaves.parameters.begin(), leaves.parameters.end()},
                           {leaves.states.begin(), leaves.states.end()},
                           {leaves.inputs.begin(), leaves.inputs.end()}});
        }
        return out;
    }

private:
    struct Leaves {
        std::set<int> parameters, states, inputs;
        void add(const Leaves& other) {
            parameters.insert(other.parameters.begin(), other.parameters.end());
            states.insert(other.states.begin(), other.states.end());
            inputs.insert(other.inputs.begin(), other.inputs.end());
        }
    };

    void step(const Instruction& i) {
        const int operands = registerOperands(i.opcode);
        Leaves leaves;
        if (operands > 0) leaves.add(of_[i.a]);
        if (operands > 1) leaves.add(of_[i.b]);
        if (operands > 2) leaves.add(of_[i.c]);
        of_[i.dst] = std::move(leaves);
    }

    void spread(const std::vector<std::uint32_t>& unknowns,
                std::initializer_list<const std::vector<std::uint32_t>*> from) {
        Leaves leaves;
        for (const auto* group : from)
            for (const std::uint32_t reg : *group) leaves.add(of_[reg]);
        for (const std::uint32_t unknown : unknowns) of_[unknown] = leaves;
    }

    void run(const Program& program) {
        for (const Instruction& i : program.code) {
            if (i.opcode == Opcode::SolveLinear) {
                const LinearBlock& block = s_.tables.linear[i.a];
                spread(block.unknowns, {&block.matrix, &block.constant});
            } else if (i.opcode == Opcode::SolveNonlinear) {
                const NonlinearBlock& block = s_.tables.nonlinear[i.a];
                for (const std::uint32_t unknown : block.unknowns) of_[unknown] = {};
                for (const Instruction& inner : block.body) step(inner);
                spread(block.unknowns, {&block.residuals});
            } else {
                step(i);
            }
        }
    }

    const SystemPrograms& s_;
    std::vector<Leaves> of_;
};

}  // namespace

CCode cCode(const SystemPrograms& programs) {
    CCode code;
    code.text = Writer(programs).text();
    DependenceAnalysis dependence(programs);
    code.initialStates = dependence.of(programs.initial, programs.initialStates);
    code.derivatives = dependence.of(programs.derivative, programs.stateDerivatives);
    code.outputs = dependence.of(programs.output, programs.outputResults);
    code.delayTimes = dependence.of(programs.delayTimes);
    return code;
}

}  // namespace analogon
