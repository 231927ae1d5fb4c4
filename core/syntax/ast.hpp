#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/source.hpp"

/// The tree of a Modelica text (the whole grammar of Modelica 3.6, appendix A). Every node has its span, so a
/// message can point at it and a text edit can replace it. Trees are immutable once parsed and shared.
namespace analogon::syntax {

struct Expression;
struct Component;
struct ClassDefinition;

/// One part of a dotted name with its subscripts: `a[1]` in `a[1].b`.
struct NamePart {
    std::string identifier;  // as written, with the quotes of a quoted identifier
    std::vector<Expression> subscripts;
    Span span;
};

/// `a.b[2].c`, or `.Analogon.Blocks` when absolute.
struct Name {
    bool absolute{};
    std::vector<NamePart> parts;
    Span span;

    /// Dotted text without subscripts.
    std::string text() const;
};

struct NamedArgument;

struct Expression {
    enum class Kind {
        Number,     // number; isInteger tells the literal's type
        String,     // text, unescaped
        Boolean,    // number is 0 or 1
        Reference,  // name
        Unary,      // text: "-" "+" "not" ".-" ".+"; operands[0]
        Binary,     // text: + - * / ^ .+ .- .* ./ .^ < <= > >= == <> and or; operands[0..1]
        If,         // operands: condition, value, (condition, value)…, else value
        Call,       // name(operands…, named…)
        Array,      // { operands… }; or { operand for iterators } when iterators is not empty
        Range,      // operands: first, last or first, step, last
        Colon,      // `:` as a subscript
        End,        // `end` in a subscript
        Tuple,      // ( a, b )
        Matrix,     // [ a, b; c, d ]: operands are the rows, each an Array
        Function,   // function name(named…): a function with some of its arguments, as an argument
        Select,     // (operands[0]) followed by subscripts or .member: the one part of name
        Empty,      // nothing between the commas of (a, , b)
        Break       // `break` as the value of a modification
    };

    Kind kind{Kind::Number};
    Span span;
    double number{};
    bool isInteger{};
    std::string text;
    Name name;
    std::vector<Expression> operands;
    std::vector<NamedArgument> named;
    std::vector<std::pair<std::string, std::vector<Expression>>> iterators;  // name, range (0 or 1 expression)
};

struct NamedArgument {
    std::string name;
    Expression value;
    Span span;
};

/// One argument of a modification list: `[each] [final] name(arguments) = value`, or a redeclaration.
struct Modification {
    bool each{};
    bool isFinal{};
    bool isReplaceable{};
    Name name;                                               // what is modified; for a redeclaration the element's name
    std::vector<Modification> arguments;                     // ( … )
    bool hasArguments{};                                     // `name()` differs from `name` on a round trip only
    std::optional<Expression> value;                         // = …
    std::shared_ptr<const Component> redeclaredComponent;    // redeclare T x(…)
    std::shared_ptr<const ClassDefinition> redeclaredClass;  // redeclare model M = …
    std::string description;
    bool isBreak{};                         // extends B(break x): the element is left out
    std::vector<Expression> brokenConnect;  // … break connect(a, b): the two connectors
    Span span;
};

/// `annotation( … )` as a list of modifications; the text under the span is the annotation word for word.
struct Annotation {
    std::vector<Modification> arguments;
    Span span;

    const Modification* find(std::string_view name) const;
};

enum class Variability { Continuous, Discrete, Parameter, Constant };
enum class Causality { None, Input, Output };

/// One declared component. `Real x, y;` gives two, which share the span of the clause.
struct Component {
    std::string name;
    Name type;
    Variability variability{Variability::Continuous};
    Causality causality{Causality::None};
    bool isFlow{};
    bool isStream{};
    bool isProtected{};
    bool isFinal{};
    bool isReplaceable{};
    bool isRedeclare{};
    bool isInner{};
    bool isOuter{};
    std::vector<Expression> dimensions;       // of the type and of the name, in the order they apply
    std::vector<Modification> modifications;  // ( … ) behind the name
    Span modificationsSpan;               // with the parentheses; empty (begin == end, right behind the name) without
    std::optional<Expression> binding;    // = …
    std::optional<Expression> condition;  // if …
    std::optional<Name> constrainedBy;
    std::vector<Modification> constrainedByModifications;
    std::string description;
    std::optional<Annotation> annotation;
    Span nameSpan;      // the identifier
    Span typeSpan;      // the type's name
    Span span;          // from the identifier to the last character of its annotation
    Span clauseSpan;    // the whole clause with its `;`
    int clauseSize{1};  // how many components the clause declares
};

struct Extends {
    Name base;
    std::vector<Modification> modifications;
    Span modificationsSpan;  // with the parentheses; empty, right behind the base's name, without
    std::optional<Annotation> annotation;
    bool isProtected{};
    Span span;  // with its `;`
};

/// An equation, or a statement of an algorithm.
struct Equation {
    enum class Kind {
        Equality,  // left = right
        Connect,   // connect(left, right): both references
        If,        // branches, else branch has no condition
        For,       // iterators, body
        When,      // branches, each with its condition
        Call,      // assert(…), terminate(…): left is the call
        Assign,    // left := right; left may be a tuple
        While,     // the one branch
        Break,
        Return
    };
    struct Branch {
        std::optional<Expression> condition;
        std::vector<Equation> body;
    };
    struct Iterator {
        std::string name;
        Expression range;
        Span span;
    };

    Kind kind{Kind::Equality};
    Expression left;
    Expression right;
    std::vector<Branch> branches;
    std::vector<Iterator> iterators;
    std::vector<Equation> body;
    std::string description;
    std::optional<Annotation> annotation;
    Span keyword;  // the word it begins with, of those that begin with one
    Span span;     // with its `;`
};

struct EquationSection {
    bool isInitial{};
    std::vector<Equation> equations;
    Span keyword;  // `equation`, `initial equation`, `algorithm` or `initial algorithm`
};

/// `external "C" y = f(x) annotation(…);`
struct External {
    std::string language;  // empty: not given
    std::optional<Expression> result;
    std::string function;  // empty: the name of the class
    std::vector<Expression> arguments;
    std::optional<Annotation> annotation;
    Span span;
};

struct Import {
    std::string alias;  // import A = B.C; or the last part
    Name name;
    bool wildcard{};
    Span span;
};

struct ClassDefinition {
    enum class Restriction { Model, Block, Connector, Record, Package, Type, Class, Function, Operator };

    Restriction restriction{Restriction::Model};
    bool isPartial{};
    bool isFinal{};
    bool isEncapsulated{};
    bool isReplaceable{};
    bool isRedeclare{};
    bool isProtected{};
    bool isInner{};
    bool isOuter{};
    bool isOperator{};    // operator record, operator function
    bool isExpandable{};  // connector
    bool isPure{};        // function: written so
    bool isImpure{};
    bool extendsItself{};  // `model extends M`: the inherited class M with more
    std::string name;
    std::string description;

    std::vector<Import> imports;
    std::vector<Extends> bases;
    std::vector<Component> components;
    std::vector<std::shared_ptr<const ClassDefinition>> classes;
    std::vector<EquationSection> equationSections;
    std::vector<EquationSection> algorithmSections;
    std::optional<External> external;
    std::optional<Annotation> annotation;
    Span restrictionSpan;  // the word that says the kind

    /// `type T = Base[dims](modifications)`, also `connector C = input Real`, `model M = N(…)`.
    bool isShort{};
    Name shortBase;
    Causality shortCausality{Causality::None};
    std::vector<Expression> shortDimensions;
    std::vector<Modification> shortModifications;
    Span shortModificationsSpan;                       // as in Extends
    std::vector<std::string> enumeration;              // type E = enumeration(…)
    std::vector<std::string> enumerationDescriptions;  // one per literal; may be empty texts
    bool isEnumeration{};
    bool isOpenEnumeration{};               // enumeration(:)
    std::vector<std::string> derivativeOf;  // function d = der(f, x, y): x, y; shortBase is f

    std::optional<Name> constrainedBy;  // of a replaceable class
    std::vector<Modification> constrainedByModifications;

    Span nameSpan;     // where the name is declared
    Span endSpan;      // `end Name` (without `;`); invalid for short classes
    Span span;         // without the final `;`
    SourcePtr source;  // keeps every span below alive
};

using ClassPtr = std::shared_ptr<const ClassDefinition>;

/// One file: `within A.B;` and its classes.
struct StoredDefinition {
    std::optional<Name> within;
    std::vector<ClassPtr> classes;
    SourcePtr source;
};

const char* keyword(ClassDefinition::Restriction restriction);

}  // namespace analogon::syntax
