#pragma once

#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/flat/flattening.hpp"

namespace analogon {

/// Variables or components named by a reference, with the sizes that its arrays leave open.
struct Slice {
    std::vector<int> dimensions;
    std::vector<VariableId> variables;  // of a built-in type
    std::vector<Instance*> instances;   // of a class
    Element* element{};                 // the last one named (of the first instance)
    Instance* owner{};                  // that holds it
    bool startsWithConnector{};         // the first component named is a connector
    int componentsBefore{};             // models among the parts before the last

    /// All elements of a member of one component, or those at these places of its array.
    void append(const Element& of);
    void append(const Element& of, const std::vector<std::size_t>& offsets);
};

/// Expressions of the text to expressions of the flat model. Every failure is reported once, where it is.
class Translator {
public:
    explicit Translator(Flattening& work) : work_(work) {}

    std::optional<Value> translate(const syntax::Expression& expression, const Scope& scope);
    std::optional<Value> translate(const ModifierValue& value);
    /// Variables or components behind a name; further members may be appended.
    std::optional<Slice> resolve(const syntax::Name& name, const Scope& scope,
                                 const std::vector<std::string>& members = {});

    /// Scalars that must be known at compile time; `what` completes "… must be …".
    std::optional<int> constantInteger(const syntax::Expression& expression, const Scope& scope, const Text& what);
    std::optional<bool> constantBoolean(const syntax::Expression& expression, const Scope& scope, const Text& what);
    std::optional<double> constantNumber(ExpressionId id, bool isStructural);
    /// The same as an expression, of what a table holds at an abscissa: itself where it depends on a parameter that is
    /// left free (Flattening::free), else a number.
    std::optional<ExpressionId> ordinate(ExpressionId id);
    /// Whether the expression depends on parameters and constants only.
    bool isParametric(ExpressionId id) const;
    /// The values of Boolean or of an enumeration that is named as a size or a range; nothing: another expression.
    std::optional<Value> valuesOfType(const syntax::Expression& expression, const Scope& scope);
    /// The values an iterator takes that is written without a range: those of the dimension whose subscript it is
    /// (section 11.2.2.1).
    std::optional<Value> impliedRange(const std::string& iterator, const std::vector<const syntax::Expression*>& within,
                                      const Scope& scope, const Span& span);
    /// The values of an iterator of a loop.
    std::optional<Value> rangeOf(const syntax::Equation& loop, std::size_t iterator, const Scope& scope);
    /// The values an iterator takes: a vector.
    std::optional<Value> range(const syntax::Expression& expression, const Scope& scope);

    void pushIterator(const std::string& name, Value value) { iterators_.emplace_back(name, std::move(value)); }
    /// While the left side of an equation is read: a text may be named there that has no value yet.
    void setTarget(bool isTarget) { isTarget_ = isTarget; }
    void popIterator() { iterators_.pop_back(); }

    /// All outputs of a call; of anything else that is one value.
    std::optional<std::vector<Value>> outputsOf(const syntax::Expression& expression, const Scope& scope);
    /// A number that does not change while the model runs; what it depends on then shapes the equations.
    std::optional<double> knownNow(ExpressionId id);
    /// Sets a variable of the function under way; false when it has none of that name (reported).
    bool setLocal(const std::string& name, Value value);

    ExpressionId derivative(ExpressionId of, const Span& span);
    /// Array elements worked on so far; false when it gets too much (reported): a text of a few lines can ask for
    /// any amount of work.
    bool spend(std::size_t elements, const Span& span);

private:
    friend class FunctionCall;
    friend class Executor;
    using Expression = syntax::Expression;

    std::optional<Value> translateNested(const Expression& expression, const Scope& scope);
    std::optional<Value> reference(const syntax::Name& name, const Scope& scope, const Span& span);
    std::optional<Value> time(const Scope& scope, const Span& span);
    std::optional<Value> chosenWhenItRuns(const syntax::Name& name, const Scope& scope);
    std::optional<Value> chosenFrom(const Value& array, const std::vector<Expression>& subscripts, const Scope& scope);
    std::optional<Value> local(Value value, const syntax::Name& name, const Scope& scope, const Span& span);
    bool mayBeUsed(const Slice& slice, const Span& span);
    std::optional<Value> valueOf(const Slice& slice);
    std::optional<Value> recordOf(Instance& instance);
    std::optional<Value> objectOf(Element& element);
    std::optional<Value> importedConstant(const syntax::Name& name, const LibraryClass& in, bool& found,
                                          std::set<const LibraryClass*>& seen);
    std::optional<Value> constantOfWholeImports(const syntax::Name& name, const LibraryClass& in, bool& found,
                                                std::set<const LibraryClass*>& seen);
    std::optional<Value> namedConstant(const syntax::Name& name, const Scope& scope, bool& found);
    std::optional<Value> constantOf(const LibraryClass& definition, const std::string& name, bool& found,
                                    std::set<const LibraryClass*>& seen);
    const LibraryClass* enumerationBehind(const LibraryClass* named) const;
    std::optional<Value> enumerationLiteral(const LibraryClass& definition, const std::string& literal,
                                            const Span& span);
    void reportUnknown(const syntax::Name& name, const Scope& scope, const Span& span);

    bool step(Slice& slice, const std::string& identifier, const std::vector<Expression>* subscripts,
              const Scope& scope, const Span& span, bool isFirst);
    bool mayIndex(const Element& element, const std::vector<Expression>& subscripts, const Scope& scope);
    Element* memberOf(Instance& instance, const std::string& identifier, const Span& span, bool isFirst);
    std::optional<Value> selectFromValue(Value value, const std::vector<Expression>& subscripts, const Scope& scope,
                                         const Span& span);
    std::optional<std::vector<std::vector<int>>> subscriptLists(const std::vector<int>& dimensions,
                                                                const std::vector<Expression>& subscripts,
                                                                const Scope& scope, const Span& span,
                                                                std::vector<int>& remaining);

    std::optional<Value> dimensionRange(const syntax::Name& name, std::size_t subscript, const Scope& scope);
    std::optional<Value> unary(const Expression& expression, const Scope& scope);
    std::optional<Value> binaryChain(const Expression& expression, const Scope& scope);
    const Expression* decided(const Expression& expression, const Scope& scope);
    bool chooseMembers(ExpressionId condition, const Value& branch, Value& result, const Span& span);
    std::optional<Value> conditional(const Expression& expression, const Scope& scope);
    std::optional<Value> array(const Expression& expression, const Scope& scope);
    std::optional<Value> comprehension(const Expression& expression, const Scope& scope, std::size_t outermost);
    bool append(Value& array, const Value& part, const Span& span);
    std::optional<Value> selected(const Expression& expression, const Scope& scope);
    std::optional<Value> matrix(const Expression& expression, const Scope& scope);
    std::optional<Value> concatenated(const std::vector<Value>& parts, std::size_t along, const Span& span);

    static constexpr int deepestNesting = 400;

    bool isFree(ExpressionId id);

    Flattening& work_;
    std::vector<std::pair<std::string, Value>> iterators_;     // and the variables of the function under way
    std::unordered_map<std::uint32_t, ExpressionId> overlay_;  // variables that the algorithm under way has set
    bool isTarget_{};
    int callDepth_{};
    std::vector<int> ends_;  // extents of the dimensions in which `end` may stand
    std::set<std::pair<const LibraryClass*, std::string>> busyConstants_;
    int depth_{};
    std::size_t spent_{};
};

/// Arithmetic, relations and logic on values (operator as written, ".*" included).
std::optional<Value> combine(Flattening& work, const std::string& operation, const Value& a, const Value& b,
                             const Span& span);

/// Calls of the built-in functions (Modelica 3.6, section 3.7).
std::optional<Value> callFunction(Flattening& work, const syntax::Expression& call, const Scope& scope);

}  // namespace analogon
