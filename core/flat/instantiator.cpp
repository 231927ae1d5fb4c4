#include "core/flat/instantiator.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/flat/executor.hpp"
#include "core/flat/refused_construct.hpp"
#include "core/flat/translator.hpp"

namespace analogon {
namespace {

using Restriction = syntax::ClassDefinition::Restriction;

bool mayBeComponent(Restriction restriction) {
    return restriction == Restriction::Model || restriction == Restriction::Block ||
           restriction == Restriction::Class || restriction == Restriction::Connector ||
           restriction == Restriction::Record;
}

FlatVariability flatVariability(syntax::Variability variability) {
    switch (variability) {
        case syntax::Variability::Constant:
            return FlatVariability::Constant;
        case syntax::Variability::Parameter:
            return FlatVariability::Parameter;
        default:
            return FlatVariability::Continuous;
    }
}

bool isExternalObject(const LibraryClass& definition) {
    for (const syntax::Extends& base : definition.definition->bases)
        if (base.base.text() == "ExternalObject") return true;
    return false;
}

/// A prefix of a declaration, where it stands.
Span wordOf(const syntax::Component& component, std::string_view word) {
    const auto at = component.clauseSpan.text().find(word);
    if (at == std::string_view::npos) return component.nameSpan;
    const auto begin = static_cast<std::uint32_t>(component.clauseSpan.begin + at);
    return {component.clauseSpan.source, begin, static_cast<std::uint32_t>(begin + word.size())};
}

syntax::Variability stronger(syntax::Variability a, syntax::Variability b) {
    return static_cast<int>(a) > static_cast<int>(b) ? a : b;
}

/// Whether variables of the instance are the model's own interface: it is the model or a public connector of it.
bool isInterface(const Instance& instance) {
    for (const Instance* i = &instance; i->parent; i = i->parent)
        if (i->isComponent() || i->isProtected) return false;
    return true;
}

std::string scalarName(const std::string& name, std::size_t element, const std::vector<int>& dimensions) {
    return dimensions.empty() ? name : name + sizeText(subscriptsOf(element, dimensions));
}

}  // namespace

Instance& Instantiator::newInstance(const LibraryClass& definition, std::string name, Instance* parent) {
    Instance& instance = work_.instances.emplace_back();
    instance.name = std::move(name);
    instance.parent = parent;
    instance.definition = &definition;
    instance.className = definition.qualifiedName;
    instance.restriction = definition.definition->restriction;
    instance.depth = parent ? parent->depth + 1 : 0;
    return instance;
}

Instance* Instantiator::instantiate(const LibraryClass& definition) {
    const syntax::ClassDefinition& tree = *definition.definition;
    const bool isModel = tree.restriction == Restriction::Model || tree.restriction == Restriction::Block ||
                         tree.restriction == Restriction::Class;
    if (!isModel) {
        work_.messages.error(phrase("'{}' is a {}, not a model", definition.qualifiedName, keyword(tree.restriction)),
                             tree.nameSpan, phrase("choose a model or block"));
        return nullptr;
    }
    if (tree.isPartial) {
        work_.messages.error(phrase("'{}' is partial and cannot be used as it stands", definition.qualifiedName),
                             tree.nameSpan, phrase("use a model that extends it"));
        return nullptr;
    }
    Instance& root = newInstance(definition, {}, nullptr);
    root.declared = tree.nameSpan;
    std::vector<const LibraryClass*> path;
    collect(root, definition, {}, false, path);
    completeAll(root);
    return &root;
}

void Instantiator::completeAll(Instance& root) {
    struct Frame {
        Instance* instance;
        std::size_t next;
    };
    std::vector<Frame> stack{{&root, 0}};
    work_.components.push_back(&root);
    while (!stack.empty() && !work_.messages.full()) {
        Frame& frame = stack.back();
        if (frame.next == frame.instance->elements.size()) {
            stack.pop_back();
            continue;
        }
        Instance& instance = *frame.instance;
        Element& element = instance.elements[frame.next++];
        if (!ensure(instance, element) || element.isElsewhere) continue;
        for (auto item = element.items.rbegin(); item != element.items.rend(); ++item) stack.push_back({*item, 0});
        for (Instance* item : element.items)
            if (item->isComponent()) work_.components.push_back(item);
    }
}

bool Instantiator::ensure(Instance& instance, Element& element) {
    switch (element.state) {
        case Element::State::Ready:
            return true;
        case Element::State::Failed:
            return false;
        case Element::State::Busy:
            work_.messages.error(phrase("the size or condition of '{}' depends on itself",
                                        instance.memberName(element.declaration->name)),
                                 element.declaration->nameSpan);
            element.state = Element::State::Failed;
            return false;
        case Element::State::Pending:
            break;
    }
    element.state = Element::State::Busy;
    const bool succeeded = prepare(instance, element) && element.state == Element::State::Busy;
    element.state = succeeded ? Element::State::Ready : Element::State::Failed;
    return succeeded;
}

bool Instantiator::prepare(Instance& instance, Element& element) {
    const syntax::Component& declaration = *element.declaration;
    const syntax::Component& original = *element.original;
    if (original.isOuter) return prepareOuter(instance, element);
    if (original.isStream) {
        tellRefused(work_.messages, "stream", wordOf(original, "stream"));
        return false;
    }
    if (const auto& condition = declaration.condition ? declaration.condition : original.condition) {
        const Scope& scope = declaration.condition ? element.scope : Scope{&instance, element.owner};
        const auto enabled = work_.translator->constantBoolean(
            *condition, scope, phrase("the condition of '{}'", instance.memberName(declaration.name)));
        if (!enabled) return false;
        element.isDisabled = !*enabled;
        if (element.isDisabled) return true;
    }
    auto type = resolveType(declaration.type, element.scope);
    if (!type) return false;
    if (element.declaration != element.original) {
        const syntax::Name& constraint = original.constrainedBy ? *original.constrainedBy : original.type;
        if (!satisfies(*type, constraint, {&instance, element.owner}, declaration.typeSpan)) return false;
    }
    if (element.declaration == element.original && original.constrainedBy &&
        !satisfies(*type, *original.constrainedBy, {&instance, element.owner}, declaration.typeSpan))
        return false;
    element.type = std::move(*type);
    if (element.isVariable() && original.isFlow && element.type.builtin != FlatType::Real) {
        work_.messages.error(
            phrase("'{}' is a flow and must be Real, not {}", original.name, typeName(element.type.builtin)),
            original.nameSpan, phrase("remove the prefix, or declare it as Real"));
        return false;
    }
    if (element.isVariable() && declaration.causality != syntax::Causality::None &&
        element.type.causality != syntax::Causality::None && element.type.causality != declaration.causality) {
        work_.messages.error(phrase("'{}' is declared as input and as output", declaration.name), declaration.nameSpan);
        return false;
    }
    if (element.type.definition && isExternalObject(*element.type.definition)) {
        element.isObject = true;
        return true;
    }
    auto dimensions = dimensionsOf(instance, element);
    if (!dimensions) return false;
    element.dimensions = std::move(*dimensions);
    if (!reserve(element, instance.memberName(declaration.name))) return false;
    element.modifier = merge(element.modifier, std::move(element.type.modifier), work_.messages, declaration.name);
    if (element.isVariable()) {
        createVariables(instance, element);
        return true;
    }
    return createItems(instance, element);
}

namespace {

/// The inner component of a name; null: none. One that is outer as well stands behind its outer side.
Element* innerOf(Instance& instance, const std::string& name) {
    Element* const named = instance.find(name);
    if (!named || named->original->isInner || !named->original->isOuter) {
        return named && named->original->isInner ? named : nullptr;
    }
    const auto inner = std::find_if(instance.elements.begin(), instance.elements.end(), [&](const Element& element) {
        return element.original->isInner && element.original->name == name;
    });
    return inner == instance.elements.end() ? nullptr : &*inner;
}

}  // namespace

/// An outer component is the inner one of its name in the nearest instance around (section 5.4).
bool Instantiator::prepareOuter(Instance& instance, Element& element) {
    const syntax::Component& original = *element.original;
    const std::string& name = original.name;
    const auto refuse = [&](const Text& why, const Text& hint) {
        work_.messages.error(why, wordOf(original, "outer"), hint);
        return false;
    };
    if (!original.modifications.empty() || original.binding)
        return refuse(
            phrase("the outer component '{}' cannot be modified: it is the one of an instance around it", name),
            phrase("modify the inner component"));
    Element* meant = nullptr;
    Instance* around = instance.parent;
    for (; around; around = around->parent) {
        meant = innerOf(*around, name);
        if (meant) break;
    }
    if (!around)
        return refuse(phrase("the outer component '{}' of {} has no inner one around it", name, instance.label()),
                      phrase("declare it in a model that holds this one: inner {} {}", original.type.text(), name));
    if (!work_.instantiator->ensure(*around, *meant)) return false;
    const auto type = resolveType(element.declaration->type, element.scope);
    if (!type) return false;
    if (!meant->isDisabled &&
        !satisfies(meant->type, element.declaration->type, element.scope, meant->declaration->typeSpan))
        return false;
    if (!element.modifier.empty())
        return refuse(
            phrase("the outer component '{}' cannot be modified: it is the one of an instance around it", name),
            phrase("modify the inner component"));
    element.type = *type;
    const auto sizes = dimensionsOf(instance, element);
    if (!sizes) return false;
    if (!meant->isDisabled && *sizes != meant->dimensions)
        return refuse(
            phrase("the outer component '{}' has the size {}, the inner one {}", name,
                   sizes->empty() ? phrase("of a single value") : Text(sizeText(*sizes)),
                   meant->dimensions.empty() ? phrase("of a single value") : Text(sizeText(meant->dimensions))),
            phrase("declare both alike"));
    element.isElsewhere = true;
    element.isDisabled = meant->isDisabled;
    element.type = meant->type;
    element.dimensions = meant->dimensions;
    element.firstVariable = meant->firstVariable;
    element.items = meant->items;
    element.isObject = meant->isObject;
    element.modifier = meant->modifier;
    return true;
}

void Instantiator::createVariables(Instance& instance, Element& element) {
    const syntax::Component& declaration = *element.declaration;
    const syntax::Component& original = *element.original;
    const bool isDirected = element.type.causality != syntax::Causality::None ||
                            original.causality != syntax::Causality::None ||
                            declaration.causality != syntax::Causality::None;
    if (isDirected && instance.causality != syntax::Causality::None)
        work_.messages.error(
            phrase("'{}' is an input or output, and so is '{}', which holds it", declaration.name, instance.name),
            instance.declared, phrase("remove one of the two prefixes"));
    FlatVariable variable;
    variable.type = element.type.builtin;
    variable.variability =
        flatVariability(stronger(instance.variability, stronger(declaration.variability, original.variability)));
    // a text does not change while the model runs
    if (variable.type == FlatType::String && variable.variability == FlatVariability::Continuous)
        variable.variability = FlatVariability::Parameter;
    variable.isFlow = declaration.isFlow || original.isFlow || instance.isFlow;
    variable.isProtected = element.isProtected || instance.isProtected;
    variable.isFinal = element.modifier.isFinal || instance.isFinal;
    variable.description = declaration.description;
    variable.declared = declaration.nameSpan;

    VariableRecord record;
    record.owner = &instance;
    record.element = static_cast<std::uint32_t>(&element - instance.elements.data());
    record.isProtected = element.isProtected || instance.isHidden;
    record.causality = instance.causality;
    for (auto causality : {element.type.causality, original.causality, declaration.causality})
        if (causality != syntax::Causality::None) record.causality = causality;
    if (isInterface(instance) && !variable.isProtected && record.causality != syntax::Causality::None)
        variable.causality =
            record.causality == syntax::Causality::Input ? FlatCausality::Input : FlatCausality::Output;

    const std::string name = instance.memberName(declaration.name);
    element.firstVariable = {static_cast<std::uint32_t>(work_.model.variables.size())};
    for (std::size_t k = 0; k < element.count(); ++k) {
        variable.name = scalarName(name, k, element.dimensions);
        record.position = static_cast<std::uint32_t>(k);
        work_.model.byName.emplace(variable.name, VariableId{static_cast<std::uint32_t>(work_.model.variables.size())});
        work_.model.variables.push_back(variable);
        work_.records.push_back(record);
    }
}

/// What a connector holds that ties more of its variables than its connections are equations (Modelica 3.6, section
/// 9.4): refused once, where the model itself names a component with such connectors.
bool Instantiator::isOverconstrained(const Instance& instance, const LibraryClass& type) {
    if (!instance.isConnector() || !work_.library.find(type.qualifiedName + ".equalityConstraint")) return false;
    const Instance* named = &instance;
    while (named->parent && named->parent->parent) named = named->parent;
    const bool isOfBodies = instance.className.find(".MultiBody.") != std::string::npos;
    work_.messages.fatal(
        phrase("'{}' ({}) has connectors whose variables depend on each other ({}, with an equalityConstraint): "
               "overconstrained connections are not supported",
               named->name, named->className, instance.className),
        named->declared,
        isOfBodies ? phrase("Model what moves along one axis: a gravity about it is {} ({}), an arm an inertia.",
                            "Analogon.Effects.Mechanics.GravityTorque", "torque.gravity")
                   : phrase("Use components whose connectors have potentials and flows alone."));
    return true;
}

/// A class whose instance holds an instance of itself would never end.
bool Instantiator::mayContain(const Instance& instance, const Element& element) {
    const std::string name = instance.memberName(element.declaration->name);
    const LibraryClass* type = element.type.definition;
    const syntax::ClassDefinition& tree = *type->definition;
    for (const Instance* outer = &instance; outer; outer = outer->parent) {
        if (outer->definition != type) continue;
        std::string chain = type->qualifiedName;
        std::vector<const Instance*> path;
        for (const Instance* i = &instance; i != outer; i = i->parent) path.push_back(i);
        for (auto i = path.rbegin(); i != path.rend(); ++i) chain += " has " + (*i)->className;
        work_.messages.error(phrase("'{}' contains itself: {} has {}", type->qualifiedName, chain, type->qualifiedName),
                             element.declaration->nameSpan, phrase("break the circle of components"));
        return false;
    }
    if (instance.depth >= deepest) {
        work_.messages.error(phrase("components are nested more than {} deep at '{}'", deepest, name),
                             element.declaration->nameSpan);
        return false;
    }
    if (isOverconstrained(instance, *type)) return false;
    if ((tree.isOperator || tree.restriction == Restriction::Operator) && !hasOperators(*type)) {
        work_.messages.error(phrase("operator classes are not supported"), element.declaration->typeSpan,
                             phrase("write the relation as equations of a block"));
        return false;
    }
    if (!mayBeComponent(tree.restriction)) {
        work_.messages.error(
            phrase("'{}' cannot be a component: {} is a {}", name, type->qualifiedName, keyword(tree.restriction)),
            element.declaration->typeSpan);
        return false;
    }
    if (tree.isPartial) {
        work_.messages.error(phrase("'{}' is of the partial class {}", name, type->qualifiedName),
                             element.declaration->typeSpan,
                             phrase("use a class that extends it, or redeclare the component"));
        return false;
    }
    return true;
}

/// Prefixes of variables belong to what holds variables only (section 4.4.2.2); a connector is no parameter (9.3).
bool Instantiator::mayHavePrefix(const Element& element) {
    const syntax::Component& original = *element.original;
    const auto fixedly = stronger(element.declaration->variability, original.variability);
    const bool isFixed = fixedly == syntax::Variability::Parameter || fixedly == syntax::Variability::Constant;
    const Restriction restriction = element.type.definition->definition->restriction;
    const bool isModel = restriction == Restriction::Model || restriction == Restriction::Block;
    const bool isDirected = element.declaration->causality != syntax::Causality::None ||
                            original.causality != syntax::Causality::None || original.isFlow;
    if (!(isModel && (isFixed || isDirected)) && !(element.type.isConnector && isFixed)) return true;
    work_.messages.error(phrase("'{}' is a {} and cannot have the prefix of a variable", original.name,
                                isModel ? keyword(restriction) : "connector"),
                         original.nameSpan, phrase("remove the prefix"));
    return false;
}

bool Instantiator::createItems(Instance& instance, Element& element) {
    if (!mayContain(instance, element)) return false;
    const syntax::Component& declaration = *element.declaration;
    const syntax::Component& original = *element.original;
    if (!mayHavePrefix(element)) return false;
    const std::string name = instance.memberName(declaration.name);
    for (std::size_t k = 0; k < element.count() && !work_.messages.full(); ++k) {
        Instance& item = newInstance(*element.type.definition, scalarName(name, k, element.dimensions), &instance);
        item.className = element.type.className;
        if (element.type.isConnector) item.restriction = Restriction::Connector;
        item.declared = declaration.nameSpan;
        item.variability = stronger(instance.variability, stronger(declaration.variability, original.variability));
        item.causality = instance.causality;
        for (auto causality : {element.type.causality, original.causality, declaration.causality})
            if (causality != syntax::Causality::None) item.causality = causality;
        item.isFlow = instance.isFlow || declaration.isFlow || original.isFlow;
        item.isProtected = instance.isProtected || element.isProtected;
        item.isHidden = !item.isComponent() && (instance.isHidden || element.isProtected);
        item.isFinal = instance.isFinal || element.modifier.isFinal;
        const Modifier modifier = element.dimensions.empty()
                                      ? element.modifier
                                      : elementModifier(element.modifier, subscriptsOf(k, element.dimensions));
        std::vector<const LibraryClass*> path;
        collect(item, *element.type.definition, modifier, false, path);
        checkModifiedNames(item, modifier, true);
        if (modifier.value.valid()) bindRecord(item, modifier);
        element.items.push_back(&item);
    }
    return true;
}

/// `Limits l = other`: each member takes the member of the same name.
void Instantiator::bindRecord(Instance& record, const Modifier& modifier) {
    if (!record.isOfRecord()) {
        work_.messages.error(phrase("'{}' is a {}; it has no value that could be set with '='", record.name,
                                    keyword(record.restriction)),
                             modifier.value.expression->span, phrase("modify its parameters: name(parameter = value)"));
        return;
    }
    for (Element& member : record.elements) {
        if (const Modifier* own = modifier.find(member.declaration->name); own && own->value.valid()) continue;
        member.modifier.value = modifier.value;
        member.modifier.value.members.push_back(member.declaration->name);
        member.modifier.each = modifier.each;
    }
}

}  // namespace analogon
