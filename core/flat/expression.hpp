#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Expressions of the flat model: a hash-consed directed acyclic graph. Equal subexpressions are the same
/// node, so common subexpressions are shared by construction and a derivative is symbolic on the same graph.
namespace analogon {

/// Index of a flat variable (FlatModel::variables).
struct VariableId {
    std::uint32_t value{0xffffffffu};
    bool valid() const { return value != 0xffffffffu; }
    friend bool operator==(VariableId, VariableId) = default;
    friend auto operator<=>(VariableId, VariableId) = default;
};

/// Index of a node in an ExpressionPool.
struct ExpressionId {
    std::uint32_t value{0xffffffffu};
    bool valid() const { return value != 0xffffffffu; }
    friend bool operator==(ExpressionId, ExpressionId) = default;
    friend auto operator<=>(ExpressionId, ExpressionId) = default;
};

enum class Operation : std::uint8_t {
    Constant,    // value
    Variable,    // variable
    Derivative,  // der(variable)
    Time,
    Negate,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,  // 0 or 1
    And,
    Or,
    Not,
    If,  // a: condition, b: then, c: else
    Abs,
    Sign,
    Sqrt,
    Exp,
    Log,
    Log10,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Atan2,
    Sinh,
    Cosh,
    Tanh,
    Min,
    Max,
    Floor,
    Ceil,
    Mod,
    Rem,
    Div,
    NoEvent,          // a; relations below raise no event
    Smooth,           // a; order in value
    Table,            // table look-up: value is the index of the table, a: the abscissa
    TableDerivative,  // derivative of the look-up
    Delay             // a: the signal, b: the delay time (parameter expression)
};

struct ExpressionNode {
    Operation operation{Operation::Constant};
    double value{};         // Constant, Table (index), Smooth (order)
    VariableId variable{};  // Variable, Derivative
    ExpressionId a{}, b{}, c{};
};

/// A one-dimensional look-up table; x increasing, strictly where it is not one of constant or linear segments: two
/// equal abscissas are a jump there, and the value at it is the one behind.
struct LookupTable {
    enum class Interpolation { Linear, MonotoneCubic, Hermite, Constant };
    enum class Extrapolation { Slope, Hold, Periodic, None };  // None: there is no value (NaN)
    std::vector<double> x, y;
    Interpolation interpolation{Interpolation::Linear};
    int order{};                 // value() is this derivative of the interpolant; 0: the interpolant itself
    std::vector<double> slopes;  // dy/dx at the nodes; monotone cubic: filled by prepare(), Hermite: given
    Extrapolation extrapolation{Extrapolation::Slope};
    double begin{-std::numeric_limits<double>::infinity()};  // below, the value is 0
    double shift{};                                          // of the abscissa

    /// Fills `slopes` (Fritsch & Carlson, SIAM J. Numer. Anal. 17 (1980) 238-246). A table of a pool is prepared;
    /// one that is not computes them at each look-up.
    void prepare();
    double value(double at) const;
    double derivative(double at) const;

    friend bool operator==(const LookupTable&, const LookupTable&) = default;
};

/// Value of an operation on numbers (unary: b is ignored). Not for leaves, If, tables and Delay.
double apply(Operation operation, double a, double b = 0);

class ExpressionPool {
public:
    const ExpressionNode& operator[](ExpressionId id) const { return nodes_[id.value]; }
    std::size_t size() const { return nodes_.size(); }

    // Constructors fold constants and apply the identities that hold for every real value
    // (x+0, x*1, x*0, --x, x-x …), and nothing that changes where the expression is defined.
    ExpressionId constant(double value);
    ExpressionId variable(VariableId variable);
    ExpressionId derivativeOf(VariableId variable);  // der(x)
    ExpressionId time();
    ExpressionId unary(Operation operation, ExpressionId a);
    ExpressionId binary(Operation operation, ExpressionId a, ExpressionId b);
    ExpressionId ifThenElse(ExpressionId condition, ExpressionId then, ExpressionId otherwise);
    ExpressionId smooth(int order, ExpressionId a);
    ExpressionId table(const LookupTable& table, ExpressionId x);
    ExpressionId tableDerivative(std::size_t table, ExpressionId x);
    ExpressionId delay(ExpressionId signal, ExpressionId delayTime);

    ExpressionId add(ExpressionId a, ExpressionId b) { return binary(Operation::Add, a, b); }
    ExpressionId subtract(ExpressionId a, ExpressionId b) { return binary(Operation::Subtract, a, b); }
    ExpressionId multiply(ExpressionId a, ExpressionId b) { return binary(Operation::Multiply, a, b); }
    ExpressionId divide(ExpressionId a, ExpressionId b) { return binary(Operation::Divide, a, b); }
    ExpressionId power(ExpressionId a, ExpressionId b) { return binary(Operation::Power, a, b); }
    ExpressionId negate(ExpressionId a) { return unary(Operation::Negate, a); }

    const std::vector<LookupTable>& tables() const { return tables_; }

    bool isConstant(ExpressionId id) const { return nodes_[id.value].operation == Operation::Constant; }
    bool isConstant(ExpressionId id, double value) const { return isConstant(id) && nodes_[id.value].value == value; }

    /// Partial derivative with respect to one node of kind Variable or Derivative (all others held).
    ExpressionId differentiate(ExpressionId of, ExpressionId with);
    /// The same where it is known which nodes of the expression depend on it, in ascending order (DependentNodes).
    ExpressionId differentiate(ExpressionId of, ExpressionId with, std::span<const std::uint32_t> dependent);
    /// Total time derivative: der(x) for a variable x where `isState`-like variables give Derivative nodes,
    /// 0 for parameters and constants, as told by the callback (which returns the derivative of a variable
    /// node or of a Derivative node: the caller owns the names of higher derivatives).
    ExpressionId timeDerivative(ExpressionId of, const std::function<ExpressionId(const ExpressionNode&)>& leaf);
    /// Replaces leaves (Variable, Derivative, Time, Delay); the callback returns an invalid id to keep one.
    ExpressionId substitute(ExpressionId in, const std::function<ExpressionId(const ExpressionNode&)>& leaf);

    /// Each distinct Variable or Derivative node below the roots, once.
    std::vector<ExpressionId> leaves(std::span<const ExpressionId> roots) const;

    /// Value for given leaves (the callback returns the value of a Variable, Derivative, Time or Delay node).
    double evaluate(ExpressionId id, const std::function<double(const ExpressionNode&)>& leaf) const;

    /// Infix text in Modelica notation; the callback names variables.
    std::string print(ExpressionId id, const std::function<std::string(VariableId)>& name) const;

private:
    using LeafDerivative = std::function<ExpressionId(const ExpressionNode&)>;

    ExpressionId intern(const ExpressionNode& node);
    ExpressionId find(const ExpressionNode& node) const;
    std::size_t slotOf(const ExpressionNode& node) const;
    void growIndex();
    std::size_t tableIndex(const LookupTable& table);
    ExpressionId foldUnary(Operation operation, ExpressionId a);
    ExpressionId foldBinary(Operation operation, ExpressionId a, ExpressionId b);
    ExpressionId foldAdd(ExpressionId a, ExpressionId b);
    ExpressionId foldSubtract(ExpressionId a, ExpressionId b);
    ExpressionId foldMultiply(ExpressionId a, ExpressionId b);
    ExpressionId derive(ExpressionId of, std::span<const std::uint32_t> order, const LeafDerivative& leaf,
                        bool delaysMove);
    ExpressionId chainRule(const ExpressionNode& node, ExpressionId self, ExpressionId da, ExpressionId db,
                           ExpressionId dc);

    // Children are interned before their parents, so ascending ids are a topological order.
    std::vector<ExpressionNode> nodes_;
    std::vector<std::uint32_t> index_;  // open addressing: id + 1, 0 is empty; size a power of two
    std::vector<LookupTable> tables_;
};

}  // namespace analogon
