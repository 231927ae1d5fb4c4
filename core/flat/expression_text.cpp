#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "core/flat/expression.hpp"

namespace analogon {
namespace {

using enum Operation;

// Modelica 3.6, section 3.2, from loose to tight.
enum Precedence { Conditional, Disjunction, Conjunction, Negation, Relation, Sum, Term, Factor, Primary };

// A shared graph may have exponentially long text: people read no further than this.
constexpr std::size_t longestText = 20000;

struct Infix {
    const char* symbol;
    Precedence precedence;
};

Infix infixOf(Operation operation) {
    switch (operation) {
        case Add:
            return {" + ", Sum};
        case Subtract:
            return {" - ", Sum};
        case Multiply:
            return {"*", Term};
        case Divide:
            return {"/", Term};
        case Power:
            return {"^", Factor};
        case Less:
            return {" < ", Relation};
        case LessEqual:
            return {" <= ", Relation};
        case Greater:
            return {" > ", Relation};
        case GreaterEqual:
            return {" >= ", Relation};
        case Equal:
            return {" == ", Relation};
        case NotEqual:
            return {" <> ", Relation};
        case And:
            return {" and ", Conjunction};
        case Or:
            return {" or ", Disjunction};
        default:
            return {nullptr, Primary};
    }
}

const char* functionName(Operation operation) {
    switch (operation) {
        case Abs:
            return "abs";
        case Sign:
            return "sign";
        case Sqrt:
            return "sqrt";
        case Exp:
            return "exp";
        case Log:
            return "log";
        case Log10:
            return "log10";
        case Sin:
            return "sin";
        case Cos:
            return "cos";
        case Tan:
            return "tan";
        case Asin:
            return "asin";
        case Acos:
            return "acos";
        case Atan:
            return "atan";
        case Atan2:
            return "atan2";
        case Sinh:
            return "sinh";
        case Cosh:
            return "cosh";
        case Tanh:
            return "tanh";
        case Min:
            return "min";
        case Max:
            return "max";
        case Floor:
            return "floor";
        case Ceil:
            return "ceil";
        case Mod:
            return "mod";
        case Rem:
            return "rem";
        case Div:
            return "div";
        case NoEvent:
            return "noEvent";
        case Delay:
            return "delay";
        default:
            return "";
    }
}

/// Writes a graph as text with a stack of pieces still to write instead of recursion.
class ExpressionWriter {
public:
    ExpressionWriter(const ExpressionPool& pool, const std::function<std::string(VariableId)>& name)
        : pool_(pool), name_(name) {}

    std::string write(ExpressionId root) {
        push(root, Conditional);
        while (!stack_.empty()) {
            if (text_.size() > longestText) return text_ + " …";
            const Piece piece = std::move(stack_.back());
            stack_.pop_back();
            if (piece.node.valid())
                open(piece.node, piece.context);
            else
                text_ += piece.text;
        }
        return std::move(text_);
    }

private:
    struct Piece {
        ExpressionId node{};
        Precedence context{};
        std::string text;
    };

    void push(ExpressionId node, Precedence context) { stack_.push_back({node, context, {}}); }
    void push(std::string text) { stack_.push_back({{}, Conditional, std::move(text)}); }

    void open(ExpressionId id, Precedence context) {
        const ExpressionNode& node = pool_[id];
        const Infix infix = infixOf(node.operation);
        if (infix.symbol)
            return parenthesised(infix.precedence < context, [&] {
                // Pieces are pushed last first.
                const bool leftAssociative = node.operation != Power && infix.precedence != Relation;
                push(node.b, tighter(infix.precedence));
                push(std::string(infix.symbol));
                push(node.a, leftAssociative ? infix.precedence : tighter(infix.precedence));
            });
        switch (node.operation) {
            case Constant: {
                std::string number = fmt::format("{}", node.value);
                if (std::signbit(node.value) && context > Sum) number = "(" + number + ")";
                push(std::move(number));
                break;
            }
            case Variable:
                push(name_(node.variable));
                break;
            case Derivative:
                push("der(" + name_(node.variable) + ")");
                break;
            case Time:
                push("time");
                break;
            case Negate:
                parenthesised(context >= Sum, [&] {
                    push(node.a, Term);
                    push("-");
                });
                break;
            case Not:
                parenthesised(context > Negation, [&] {
                    push(node.a, Relation);
                    push("not ");
                });
                break;
            case If:
                parenthesised(context > Conditional, [&] {
                    push(node.c, Conditional);
                    push(" else ");
                    push(node.b, Conditional);
                    push(" then ");
                    push(node.a, Conditional);
                    push("if ");
                });
                break;
            case Smooth:
                call(fmt::format("smooth({}, ", node.value), node);
                break;
            case Table:
                call(fmt::format("table{}(", node.value + 1), node);
                break;
            case TableDerivative:
                call(fmt::format("tableDerivative{}(", node.value + 1), node);
                break;
            default:
                call(std::string(functionName(node.operation)) + "(", node);
        }
    }

    void call(std::string head, const ExpressionNode& node) {
        push(")");
        if (node.b.valid()) {
            push(node.b, Conditional);
            push(", ");
        }
        push(node.a, Conditional);
        push(std::move(head));
    }

    template <class Pieces>
    void parenthesised(bool needed, Pieces pieces) {
        if (needed) push(")");
        pieces();
        if (needed) push("(");
    }

    static Precedence tighter(Precedence p) { return static_cast<Precedence>(p + 1); }

    const ExpressionPool& pool_;
    const std::function<std::string(VariableId)>& name_;
    std::string text_;
    std::vector<Piece> stack_;
};

}  // namespace

std::string ExpressionPool::print(ExpressionId id, const std::function<std::string(VariableId)>& name) const {
    return ExpressionWriter(*this, name).write(id);
}

}  // namespace analogon
