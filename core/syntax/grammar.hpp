#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "core/syntax/ast.hpp"
#include "core/syntax/cursor.hpp"

/// The grammar of Modelica 3.6 (appendix A) as a recursive-descent parser; each function reads the construct it
/// is named after. Private to the parser.
namespace analogon::syntax {

class Grammar {
public:
    explicit Grammar(Cursor& cursor) : cursor_(cursor) {}

    // grammar_class.cpp
    StoredDefinition storedDefinition();

    // grammar_expression.cpp
    Expression expression();
    Name typeName();            // dotted, without subscripts
    Name componentReference();  // dotted, with subscripts

private:
    // Class definitions and their elements (A.2.2, A.2.3)
    struct ElementPrefixes;
    bool atClassDefinition() const;
    std::shared_ptr<ClassDefinition> classDefinition();
    void classPrefixes(ClassDefinition& definition);
    void longClass(ClassDefinition& definition);
    void shortClass(ClassDefinition& definition);
    void enumeration(ClassDefinition& definition);
    void composition(ClassDefinition& definition);
    void section(ClassDefinition& definition, bool& isProtected);
    void closeClass(ClassDefinition& definition);
    void classAnnotation(ClassDefinition& definition);
    void element(ClassDefinition& definition, bool isProtected);
    void importClause(ClassDefinition& definition);
    void extendsClause(ClassDefinition& definition, bool isProtected);
    ElementPrefixes elementPrefixes();
    void nestedClass(ClassDefinition& definition, const ElementPrefixes& prefixes, bool isProtected);
    void componentClause(ClassDefinition& definition, const ElementPrefixes& prefixes, bool isProtected);
    Component componentPrototype();
    void typePrefixes(Component& component);
    void declaration(Component& component, const Component& prototype);
    void derivativeClass(ClassDefinition& definition);
    Modification breakModification();
    void constrainingClause(std::optional<Name>& base, std::vector<Modification>& modifications);
    Text misspelt(Text otherwise, std::string_view word = {}) const;
    void checkDoubles(const ClassDefinition& definition);

    void recoverElement(std::size_t begin);
    bool atSection() const;
    bool closesClass() const;
    void restart() { inSubscript_ = false, annotationDepth_ = 0; }

    // Algorithms and external functions (A.2.6, A.2.2; grammar_statement.cpp)
    void statements(EquationSection& section);
    Equation statement();
    Equation simpleStatement();
    std::vector<Equation> statementBody();
    void externalClause(ClassDefinition& definition);

    // Equations (A.2.6)
    void equations(EquationSection& section);
    void recoverEquation(std::size_t begin);
    bool atBlock() const;
    void skipBlock();
    Equation equation();
    enum class Body { Equations, Statements };
    std::vector<Equation> body(Body of) { return of == Body::Equations ? equationBody() : statementBody(); }
    Equation conditional(Equation::Kind kind, Body of);
    Equation forLoop(Body of);
    bool atBodyEnd() const;
    Equation connectEquation();
    Equation simpleEquation();
    std::vector<Equation> equationBody();
    void endOf(std::string_view word);

    // Modifications (A.2.5)
    std::vector<Modification> classModification();
    Modification argument();
    Modification redeclaration(Modification modification, bool isRedeclare);
    void modificationValue(Modification& modification);
    std::string description();
    std::optional<Annotation> annotation();

    // Expressions (A.2.7)
    Expression ifExpression();
    Expression simpleExpression();
    Expression logicalExpression();
    Expression logicalTerm();
    Expression logicalFactor();
    Expression relation();
    Expression arithmetic();
    Expression term();
    Expression factor();
    Expression primary();
    Expression number();
    Expression string();
    Expression parenthesised();
    Expression braces();
    Expression matrix();
    Expression referenceOrCall();
    Expression partialApplication();
    Expression selection(Expression from, std::size_t begin);
    void namedArgument(Expression& call);
    Expression call(Name name, std::size_t begin);
    void callArguments(Expression& call);
    void iterators(Expression& expression);
    std::vector<Expression> subscripts();
    bool atAny(std::initializer_list<std::string_view> words) const;
    template <class Operand>
    Expression chainOf(Expression first, std::initializer_list<std::string_view> words, Operand operand);
    Expression chain(std::vector<Expression> operands, std::vector<std::string> operators);
    std::string unescape(const Token& token);

    Cursor& cursor_;
    int annotationDepth_{};  // > 0: within an annotation, whose content is not ours to judge
    bool inSubscript_{};     // `end` and `:` have a meaning
};

}  // namespace analogon::syntax
