#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "core/syntax/grammar.hpp"

namespace analogon::syntax {

namespace {

using Restriction = ClassDefinition::Restriction;

struct RestrictionWord {
    std::string_view word;
    Restriction restriction;
};
constexpr std::array restrictions{
    RestrictionWord{"model", Restriction::Model},         RestrictionWord{"block", Restriction::Block},
    RestrictionWord{"connector", Restriction::Connector}, RestrictionWord{"record", Restriction::Record},
    RestrictionWord{"package", Restriction::Package},     RestrictionWord{"type", Restriction::Type},
    RestrictionWord{"class", Restriction::Class},         RestrictionWord{"function", Restriction::Function},
};

}  // namespace

/// `[redeclare] [final] [inner] [outer] [replaceable]` before an element.
struct Grammar::ElementPrefixes {
    std::size_t begin{};  // index of the first word of the element
    bool isRedeclare{};
    bool isFinal{};
    bool isInner{};
    bool isOuter{};
    bool isReplaceable{};
};

StoredDefinition Grammar::storedDefinition() {
    StoredDefinition result;
    if (cursor_.take("within")) {
        try {
            Name name;
            if (!cursor_.at(";")) name = typeName();
            result.within = std::move(name);
            cursor_.expectSemicolon("\"within\"");
        } catch (const SyntaxFault&) {
            while (!cursor_.atEnd() && !cursor_.take(";")) cursor_.next();
        }
    }
    while (!cursor_.atEnd() && !cursor_.gaveUp()) {
        const std::size_t begin = cursor_.index();
        try {
            const bool isFinal = cursor_.take("final");
            if (!atClassDefinition()) {
                cursor_.faultExpected(phrase("a class"),
                                      misspelt(phrase("a Modelica file holds classes: model A … end A;")));
            }
            const auto definition = classDefinition();
            definition->isFinal = definition->isFinal || isFinal;
            cursor_.expectSemicolon([&] { return phrase("the class \"{}\"", definition->name); });
            result.classes.push_back(definition);
        } catch (const SyntaxFault&) {
            restart();
            // The next class begins behind a `;`.
            do {
                cursor_.next();
            } while (!cursor_.atEnd() && !(atClassDefinition() && cursor_.index() > begin));
        }
    }
    if (result.classes.empty() && !hasError(cursor_.diagnostics())) {
        cursor_.report(error(phrase("the text holds no class"), cursor_.here(),
                             phrase("a Modelica file holds classes: model A … end A;")));
    }
    return result;
}

bool Grammar::atClassDefinition() const {
    static constexpr std::array<std::string_view, 5> others{"partial", "encapsulated", "operator", "expandable",
                                                            "impure"};
    if (cursor_.peek().kind != Token::Kind::Keyword) return false;
    const std::string_view word = cursor_.text();
    if (word == "pure") return !cursor_.at("(", 1);
    return std::any_of(restrictions.begin(), restrictions.end(),
                       [&](const RestrictionWord& entry) { return entry.word == word; }) ||
           std::find(others.begin(), others.end(), word) != others.end();
}

void Grammar::classPrefixes(ClassDefinition& definition) {
    definition.isEncapsulated = cursor_.take("encapsulated");
    definition.isPartial = cursor_.take("partial");
    const std::size_t begin = cursor_.index();
    definition.isPure = cursor_.take("pure");
    definition.isImpure = !definition.isPure && cursor_.take("impure");
    definition.isExpandable = cursor_.take("expandable");
    definition.isOperator = cursor_.take("operator");
    if (definition.isOperator && cursor_.atIdentifier()) {
        definition.isOperator = false;
        definition.restriction = Restriction::Operator;
        definition.restrictionSpan = cursor_.spanFrom(begin);
        return;
    }
    const auto entry = std::find_if(restrictions.begin(), restrictions.end(),
                                    [&](const RestrictionWord& candidate) { return cursor_.at(candidate.word); });
    if (entry == restrictions.end()) {
        cursor_.faultExpected(phrase("the kind of a class: model, block, connector, record, type or package"));
    }
    definition.restriction = entry->restriction;
    cursor_.next();
    definition.restrictionSpan = cursor_.spanFrom(begin);
    const bool isFunction = entry->restriction == Restriction::Function;
    if (((definition.isPure || definition.isImpure) && !isFunction) ||
        (definition.isExpandable && entry->restriction != Restriction::Connector) ||
        (definition.isOperator && !isFunction && entry->restriction != Restriction::Record)) {
        cursor_.fault(phrase("\"{}\" is no kind of class", definition.restrictionSpan.text()),
                      definition.restrictionSpan);
    }
}

std::shared_ptr<ClassDefinition> Grammar::classDefinition() {
    const Cursor::Nesting nesting(cursor_);
    const std::size_t begin = cursor_.index();
    auto definition = std::make_shared<ClassDefinition>();
    definition->source = cursor_.source();
    classPrefixes(*definition);
    definition->extendsItself = cursor_.take("extends");
    const Token name =
        cursor_.expectIdentifier([&] { return phrase("the name of the {}", keyword(definition->restriction)); });
    definition->name = cursor_.textOf(name);
    definition->nameSpan = cursor_.spanOf(name);
    if (definition->extendsItself) {
        definition->shortModificationsSpan = cursor_.behind();
        if (cursor_.at("(")) {
            const std::size_t open = cursor_.index();
            definition->shortModifications = classModification();
            definition->shortModificationsSpan = cursor_.spanFrom(open);
        }
        longClass(*definition);
    } else if (cursor_.take("=")) {
        shortClass(*definition);
    } else {
        longClass(*definition);
    }
    definition->span = cursor_.spanFrom(begin);
    return definition;
}

/// What stands behind `=`: a base with its modifications, or an enumeration.
void Grammar::shortClass(ClassDefinition& definition) {
    definition.isShort = true;
    if (cursor_.at("der")) {
        derivativeClass(definition);
    } else if (cursor_.at("enumeration")) {
        enumeration(definition);
    } else {
        if (cursor_.take("input"))
            definition.shortCausality = Causality::Input;
        else if (cursor_.take("output"))
            definition.shortCausality = Causality::Output;
        definition.shortBase = typeName();
        if (cursor_.at("[")) definition.shortDimensions = subscripts();
        definition.shortModificationsSpan = cursor_.behind();
        if (cursor_.at("(")) {
            const std::size_t open = cursor_.index();
            definition.shortModifications = classModification();
            definition.shortModificationsSpan = cursor_.spanFrom(open);
        }
    }
    definition.description = description();
    definition.annotation = annotation();
}

/// `= der(f, x, y)`: the partial derivative of a function (section 12.7.2).
void Grammar::derivativeClass(ClassDefinition& definition) {
    cursor_.next();
    cursor_.expect("(", "behind \"der\"");
    definition.shortBase = typeName();
    cursor_.expect(",", "behind the function that is differentiated");
    do {
        definition.derivativeOf.emplace_back(
            cursor_.textOf(cursor_.expectIdentifier("the name of an input of the function")));
    } while (cursor_.take(","));
    cursor_.expect(")", "to close \"der\"");
    definition.shortModificationsSpan = cursor_.behind();
}

void Grammar::enumeration(ClassDefinition& definition) {
    cursor_.next();
    definition.isEnumeration = true;
    cursor_.expect("(", "behind \"enumeration\"");
    definition.isOpenEnumeration = cursor_.take(":");
    while (!definition.isOpenEnumeration && !cursor_.at(")")) {
        const Token literal = cursor_.expectIdentifier("the name of a literal");
        definition.enumeration.emplace_back(cursor_.textOf(literal));
        definition.enumerationDescriptions.push_back(description());
        annotation();
        if (!cursor_.take(",")) break;
    }
    cursor_.expect(")", "to close the enumeration");
}

void Grammar::longClass(ClassDefinition& definition) {
    try {
        definition.description = description();
    } catch (const SyntaxFault&) {
        recoverElement(cursor_.index());
    }
    composition(definition);
    closeClass(definition);
    checkDoubles(definition);
}

/// Elements and sections up to `end`; a faulty element is reported and skipped.
void Grammar::composition(ClassDefinition& definition) {
    bool isProtected = false;
    while (!cursor_.atEnd() && !cursor_.gaveUp() && !closesClass()) {
        const std::size_t begin = cursor_.index();
        try {
            if (atSection()) {
                section(definition, isProtected);
            } else if (cursor_.at("annotation")) {
                classAnnotation(definition);
            } else {
                element(definition, isProtected);
            }
        } catch (const SyntaxFault&) {
            recoverElement(begin);
        }
    }
}

/// `end` of this class, rather than a stray `end if`.
bool Grammar::closesClass() const {
    if (!cursor_.at("end")) return false;
    return !cursor_.at("if", 1) && !cursor_.at("for", 1) && !cursor_.at("when", 1) && !cursor_.at("while", 1);
}

void Grammar::recoverElement(std::size_t begin) {
    restart();
    while (!cursor_.atEnd() && !cursor_.at(";") && !atSection() && !closesClass()) cursor_.next();
    cursor_.take(";");
    if (cursor_.index() == begin && !closesClass()) cursor_.next();
}

void Grammar::section(ClassDefinition& definition, bool& isProtected) {
    if (cursor_.at("external")) return externalClause(definition);
    if (cursor_.at("public") || cursor_.at("protected")) {
        isProtected = cursor_.at("protected");
        cursor_.next();
        return;
    }
    const std::size_t begin = cursor_.index();
    EquationSection result;
    result.isInitial = cursor_.take("initial");
    const bool isAlgorithm = cursor_.at("algorithm");
    cursor_.next();
    result.keyword = cursor_.spanFrom(begin);
    if (isAlgorithm) {
        statements(result);
        definition.algorithmSections.push_back(std::move(result));
    } else {
        equations(result);
        definition.equationSections.push_back(std::move(result));
    }
}

void Grammar::classAnnotation(ClassDefinition& definition) {
    const Span keywordSpan = cursor_.here();
    const bool isSecond = definition.annotation.has_value();
    definition.annotation = annotation();
    cursor_.expectSemicolon("the annotation");
    if (isSecond) {
        cursor_.report(error(phrase("a second annotation of \"{}\"", definition.name), keywordSpan,
                             phrase("a class has one annotation, as its last element")));
    } else if (!closesClass() && !cursor_.atEnd()) {
        cursor_.report(error(phrase("the annotation of \"{}\" is not its last element", definition.name), keywordSpan,
                             phrase("move it right before the \"end\"")));
    }
}

void Grammar::closeClass(ClassDefinition& definition) {
    const std::size_t begin = cursor_.index();
    if (cursor_.gaveUp()) return;
    if (!cursor_.take("end")) {
        cursor_.fault(phrase("the {} \"{}\" is not closed", keyword(definition.restriction), definition.name),
                      definition.nameSpan, phrase("it ends with \"end {};\"", definition.name));
    }
    if (cursor_.at(";") || cursor_.atEnd()) {
        cursor_.fault(phrase("expected the name of the class behind \"end\""), cursor_.behind(),
                      phrase("write \"end {};\"", definition.name));
    }
    const Token name = cursor_.expectIdentifier("the name of the class behind \"end\"");
    if (cursor_.textOf(name) != definition.name) {
        cursor_.report(error(phrase("\"{}\" is closed by the name \"{}\"", definition.name, cursor_.textOf(name)),
                             cursor_.spanOf(name), phrase("write \"end {};\"", definition.name)));
    }
    definition.endSpan = cursor_.spanFrom(begin);
}

void Grammar::element(ClassDefinition& definition, bool isProtected) {
    if (cursor_.at("import")) return importClause(definition);
    if (cursor_.at("extends")) return extendsClause(definition, isProtected);
    if (cursor_.take(";")) return;  // a stray `;` harms nobody
    const ElementPrefixes prefixes = elementPrefixes();
    if (atClassDefinition()) {
        return nestedClass(definition, prefixes, isProtected);
    }
    componentClause(definition, prefixes, isProtected);
}

void Grammar::importClause(ClassDefinition& definition) {
    const std::size_t begin = cursor_.index();
    cursor_.next();
    Import import;
    if (cursor_.atIdentifier() && cursor_.at("=", 1)) {
        import.alias = cursor_.textOf(cursor_.next());
        cursor_.next();
    }
    import.name.absolute = cursor_.take(".");
    std::vector<Token> several;  // import A.{b, c};
    do {
        if (cursor_.take("{")) {
            do {
                several.push_back(cursor_.expectIdentifier("the name of a class"));
            } while (cursor_.take(","));
            cursor_.expect("}", "to close the list of imports");
            break;
        }
        const Token part = cursor_.expectIdentifier("the name of a class or package");
        import.name.parts.push_back({std::string(cursor_.textOf(part)), {}, cursor_.spanOf(part)});
    } while (cursor_.take("."));
    import.wildcard = cursor_.take(".*");
    import.name.span = cover(import.name.parts.front().span, import.name.parts.back().span);
    description();
    annotation();
    cursor_.expectSemicolon("the import");
    import.span = cursor_.spanFrom(begin);
    if (import.alias.empty() && !import.wildcard) import.alias = import.name.parts.back().identifier;
    if (several.empty()) definition.imports.push_back(std::move(import));
    for (const Token& token : several) {
        Import one = import;
        one.alias = cursor_.textOf(token);
        one.name.parts.push_back({one.alias, {}, cursor_.spanOf(token)});
        definition.imports.push_back(std::move(one));
    }
}

void Grammar::extendsClause(ClassDefinition& definition, bool isProtected) {
    const std::size_t begin = cursor_.index();
    cursor_.next();
    Extends result;
    result.isProtected = isProtected;
    result.base = typeName();
    result.modificationsSpan = cursor_.behind();
    if (cursor_.at("(")) {
        const std::size_t open = cursor_.index();
        result.modifications = classModification();
        result.modificationsSpan = cursor_.spanFrom(open);
    }
    result.annotation = annotation();
    cursor_.expectSemicolon("\"extends\"");
    result.span = cursor_.spanFrom(begin);
    definition.bases.push_back(std::move(result));
}

Grammar::ElementPrefixes Grammar::elementPrefixes() {
    ElementPrefixes prefixes;
    prefixes.begin = cursor_.index();
    prefixes.isRedeclare = cursor_.take("redeclare");
    prefixes.isFinal = cursor_.take("final");
    prefixes.isInner = cursor_.take("inner");
    prefixes.isOuter = cursor_.take("outer");
    prefixes.isReplaceable = cursor_.take("replaceable");
    return prefixes;
}

void Grammar::nestedClass(ClassDefinition& definition, const ElementPrefixes& prefixes, bool isProtected) {
    const auto nested = classDefinition();
    nested->isProtected = isProtected;
    nested->isRedeclare = prefixes.isRedeclare;
    nested->isFinal = prefixes.isFinal;
    nested->isReplaceable = prefixes.isReplaceable;
    nested->isInner = prefixes.isInner;
    nested->isOuter = prefixes.isOuter;
    if (prefixes.isReplaceable) {
        constrainingClause(nested->constrainedBy, nested->constrainedByModifications);
        if (nested->description.empty()) nested->description = description();
        if (!nested->annotation) nested->annotation = annotation();
    }
    definition.classes.push_back(nested);
    cursor_.expectSemicolon([&] { return phrase("the {} \"{}\"", keyword(nested->restriction), nested->name); });
}

void Grammar::typePrefixes(Component& component) {
    // Their order is fixed: flow, then the variability, then the causality.
    int rank = 0;
    const auto advance = [&](int to) {
        if (to <= rank) {
            cursor_.fault(phrase("the prefix \"{}\" is doubled or out of order", cursor_.text()), cursor_.here(),
                          phrase("the order is: flow, then parameter, constant or discrete, then input or output"));
        }
        rank = to;
    };
    for (;; cursor_.next()) {
        if (cursor_.at("flow") || cursor_.at("stream")) {
            advance(1);
            (cursor_.at("flow") ? component.isFlow : component.isStream) = true;
        } else if (cursor_.at("discrete") || cursor_.at("parameter") || cursor_.at("constant")) {
            advance(2);
            component.variability = cursor_.at("discrete")    ? Variability::Discrete
                                    : cursor_.at("parameter") ? Variability::Parameter
                                                              : Variability::Constant;
        } else if (cursor_.at("input") || cursor_.at("output")) {
            advance(3);
            component.causality = cursor_.at("input") ? Causality::Input : Causality::Output;
        } else {
            return;
        }
    }
}

/// Prefixes, type and dimensions of the type, which all components of a clause share.
Component Grammar::componentPrototype() {
    Component prototype;
    typePrefixes(prototype);
    if (!cursor_.atIdentifier() && !cursor_.at(".")) {
        cursor_.faultExpected(phrase("a declaration, an equation section or \"end\""));
    }
    prototype.type = typeName();
    prototype.typeSpan = prototype.type.span;
    if (cursor_.at("[")) prototype.dimensions = subscripts();
    return prototype;
}

/// `name[dimensions](modifications) = binding if condition "description" annotation(…)`
void Grammar::declaration(Component& component, const Component& prototype) {
    const std::size_t begin = cursor_.index();
    const Token name = cursor_.expectIdentifier(
        [&] { return phrase("the name of a component of type \"{}\"", prototype.type.text()); });
    component.name = cursor_.textOf(name);
    component.nameSpan = cursor_.spanOf(name);
    component.dimensions.clear();
    if (cursor_.at("[")) component.dimensions = subscripts();
    component.dimensions.insert(component.dimensions.end(), prototype.dimensions.begin(), prototype.dimensions.end());
    component.modificationsSpan = cursor_.behind();
    if (cursor_.at("(")) {
        const std::size_t open = cursor_.index();
        component.modifications = classModification();
        component.modificationsSpan = cursor_.spanFrom(open);
    }
    if (cursor_.at(":="))
        cursor_.fault(phrase("\":=\" is an assignment"), cursor_.here(), phrase("a value is given with \"=\""));
    if (cursor_.take("=")) component.binding = expression();
    if (cursor_.take("if")) component.condition = expression();
    component.description = description();
    component.annotation = annotation();
    component.span = cursor_.spanFrom(begin);
}

void Grammar::componentClause(ClassDefinition& definition, const ElementPrefixes& prefixes, bool isProtected) {
    Component prototype = componentPrototype();
    prototype.isProtected = isProtected;
    prototype.isFinal = prefixes.isFinal;
    prototype.isRedeclare = prefixes.isRedeclare;
    prototype.isReplaceable = prefixes.isReplaceable;
    prototype.isInner = prefixes.isInner;
    prototype.isOuter = prefixes.isOuter;
    std::vector<Component> clause;
    do {
        Component component = prototype;
        declaration(component, prototype);
        clause.push_back(std::move(component));
    } while (cursor_.take(","));
    if (prefixes.isReplaceable && cursor_.at("constrainedby")) {
        std::optional<Name> base;
        std::vector<Modification> modifications;
        constrainingClause(base, modifications);
        const std::string text = description();
        const std::optional<Annotation> note = annotation();
        for (Component& component : clause) {
            component.constrainedBy = base;
            component.constrainedByModifications = modifications;
            if (component.description.empty()) component.description = text;
            if (!component.annotation) component.annotation = note;
        }
    }
    if (cursor_.atIdentifier() && !clause.back().binding) {
        // Two names in a row: a keyword may be misspelt (`paramter Real k`), or a `;` is missing.
        const Text hint = misspelt({}, clause.front().type.text());
        if (!hint.empty()) cursor_.fault(phrase("a declaration of three names"), clause.front().typeSpan, hint);
    }
    cursor_.expectSemicolon("the declaration");
    for (Component& component : clause) {
        component.clauseSpan = cursor_.spanFrom(prefixes.begin);
        component.clauseSize = static_cast<int>(clause.size());
        definition.components.push_back(std::move(component));
    }
}

/// `did you mean "parameter"?` when the word (or the one at hand) is nearly a keyword, else the other hint.
Text Grammar::misspelt(Text otherwise, std::string_view word) const {
    static const std::vector<std::string> keywords{
        "model",  "block", "connector", "package", "record", "type",    "parameter", "constant",   "input",
        "output", "flow",  "final",     "extends", "import", "partial", "within",    "replaceable"};
    const std::string near = suggestion(word.empty() ? cursor_.text() : word, keywords);
    return near.empty() ? otherwise : phrase("did you mean \"{}\"?", near);
}

/// A class cannot declare one name twice (section 5.6.1.4); redeclarations name an inherited element.
void Grammar::checkDoubles(const ClassDefinition& definition) {
    std::unordered_map<std::string_view, Span> seen;
    const auto check = [&](std::string_view name, const Span& span) {
        const auto [first, isNew] = seen.emplace(name, span);
        if (isNew) return;
        const Position position = cursor_.source()->position(first->second.begin);
        cursor_.report(error(phrase("\"{}\" is declared twice in \"{}\"", name, definition.name), span,
                             phrase("the first declaration is in line {}, column {}", position.line, position.column)));
    };
    for (const Component& component : definition.components) {
        if (!component.isRedeclare) check(component.name, component.nameSpan);
    }
    for (const ClassPtr& nested : definition.classes) {
        if (!nested->isRedeclare) check(nested->name, nested->nameSpan);
    }
}

}  // namespace analogon::syntax
