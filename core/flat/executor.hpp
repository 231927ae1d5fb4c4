#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/flat/flattening.hpp"
#include "core/flat/value.hpp"

namespace analogon {

/// Runs statements on expressions (Modelica 3.6, chapters 11 and 12): what is known is worked out, what is not becomes
/// an expression of the flat model. Branches whose condition is not known are both run, and joined by it.
class Executor {
public:
    explicit Executor(Flattening& work) : work_(work) {}

    /// The outputs of a function of the library for these arguments; nothing when it cannot be run (reported).
    std::optional<std::vector<Value>> call(const LibraryClass& function, const syntax::Expression& call,
                                           const Scope& caller, const Value* partly = nullptr);
    /// An operator on values of which one is a record with operators of its own; reported when there is none that fits.
    std::optional<Value> operate(const std::string& operation, std::vector<Value> arguments, const Span& span);
    /// Such a record, made by its constructor.
    std::optional<Value> operatorRecord(const std::string& record, const std::vector<Value>& arguments,
                                        const Span& span);
    /// A function as a value: its name, or `function f(x = …)` with some of its arguments; nothing: it is none.
    std::optional<Value> functionValue(const syntax::Expression& expression, const Scope& scope);
    /// A record of its class, made by its constructor.
    std::optional<Value> construct(const LibraryClass& record, const syntax::Expression& call, const Scope& caller);
    /// The algorithm sections of an instance as equations.
    void section(const syntax::EquationSection& section, const Scope& scope);

private:
    using Statement = syntax::Equation;
    enum class Flow { Next, Break, Return, Failed };
    struct Input {
        const syntax::Component* declaration{};
        const LibraryClass* lexical{};
    };
    struct Signature {
        std::vector<Input> elements;  // in the order of declaration, those of bases first
        const syntax::ClassDefinition* body{};
        const LibraryClass* lexical{};  // of the body
    };

    bool signatureOf(const LibraryClass& function, Signature& signature, std::map<std::string, Input>& preset,
                     int depth);
    std::optional<std::vector<Value>> run(const Signature& signature, std::vector<std::pair<std::string, Value>> given,
                                          const std::map<std::string, Input>& preset, const syntax::Expression& call);
    std::optional<std::vector<Value>> each(const Signature& signature, std::vector<std::pair<std::string, Value>> given,
                                           const std::map<std::string, Input>& preset, const syntax::Expression& call);
    std::optional<Value> callWith(const LibraryClass& function, const std::vector<Value>& arguments, const Span& span);
    std::size_t rankOf(const Input& element);
    bool takesFunction(const Input& element);
    std::optional<Value> initialValue(const Input& element, const Scope& scope);
    std::optional<Value> emptyValue(const syntax::Name& type, const LibraryClass* lexical, std::vector<int> dimensions,
                                    int depth);
    std::optional<Value> fitted(Value value, const Input& element);

    Flow execute(const std::vector<Statement>& statements, const Scope& scope);
    Flow execute(const Statement& statement, const Scope& scope);
    Flow assign(const Statement& statement, const Scope& scope);
    Flow conditional(const Statement& statement, std::size_t branch, const Scope& scope);
    Flow loop(const Statement& statement, std::size_t iterator, const Scope& scope);
    Flow repeat(const Statement& statement, const Scope& scope);
    Flow when(const Statement& statement, const Scope& scope);
    Flow callOf(const Statement& statement, const Scope& scope);
    bool store(const syntax::Expression& target, const Value& value, const Scope& scope);
    std::optional<std::vector<ExpressionId>> elementsMeant(const std::vector<int>& dimensions,
                                                           const std::vector<syntax::Expression>& subscripts,
                                                           const Scope& scope, const Span& span);
    bool storeWhereItRuns(const syntax::Expression& target, const Value& value, const Scope& scope);
    bool storeIn(Value& target, const std::vector<syntax::NamePart>& parts, std::size_t part, const Value& value,
                 const Scope& scope, const Span& span);

    struct Memory {
        std::vector<std::pair<std::string, Value>> locals;
        std::unordered_map<std::uint32_t, ExpressionId> variables;
    };
    int turnsOf(const syntax::Expression& condition, const Scope& scope);
    Flow repeatOpen(const Statement& statement, const Scope& scope);
    Memory withoutValue(const Memory& first) const;
    Memory remember() const;
    void recall(Memory memory);
    void leave(Flow flow);
    bool join(ExpressionId condition, const Memory& then, const Span& span);
    bool join(ExpressionId condition, const Value& then, Value& otherwise, const Span& span);
    void collectTargets(const std::vector<Statement>& statements, const Scope& scope, bool isInWhen,
                        std::vector<std::pair<VariableId, bool>>& targets);

    Flattening& work_;
    std::vector<std::shared_ptr<const syntax::Component>> made_;  // arguments that short classes give
    bool isInitial_{};
    bool hasOpenLoop_{};                // of a function: how often it turns is known only when the model runs
    bool isModel_{};                    // an algorithm of a model: reinit and the like have a meaning
    ExpressionId broken_, returned_;    // when the loop, the function was left before; invalid: never
    std::vector<ExpressionId> guards_;  // conditions of the branches under way
};

/// Whether a record has operators of its own that are understood: `Complex`.
bool hasOperators(const LibraryClass& definition);

}  // namespace analogon
