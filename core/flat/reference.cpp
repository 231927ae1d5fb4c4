#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/flat/binder.hpp"
#include "core/flat/class_rules.hpp"
#include "core/flat/events.hpp"
#include "core/flat/instantiator.hpp"
#include "core/flat/translator.hpp"

/// Names in expressions (Modelica 3.6, chapter 5 and section 10.5 for subscripts).
namespace analogon {
namespace {

using Kind = syntax::Expression::Kind;

std::string textUpTo(const syntax::Name& name, std::size_t parts) {
    std::string text;
    for (std::size_t i = 0; i < parts; ++i) {
        if (i) text += '.';
        text += name.parts[i].identifier;
    }
    return text;
}

}  // namespace

std::optional<Value> Translator::reference(const syntax::Name& name, const Scope& scope, const Span& span) {
    const std::string& first = name.parts.front().identifier;
    if (!name.absolute) {
        for (auto iterator = iterators_.rbegin(); iterator != iterators_.rend(); ++iterator)
            if (iterator->first == first) return local(iterator->second, name, scope, span);
        if (scope.instance && scope.instance->find(first)) {
            std::optional<Slice> slice;
            {
                const Messages::Quiet quiet(work_.messages);
                slice = resolve(name, scope);
            }
            if (!slice)
                if (auto chosen = chosenWhenItRuns(name, scope)) return chosen;
            if (!slice) slice = resolve(name, scope);  // to tell why
            return slice && mayBeUsed(*slice, span) ? valueOf(*slice) : std::nullopt;
        }
        if (first == "time" && name.parts.size() == 1) return time(scope, span);
    }
    bool found = false;
    auto constant = namedConstant(name, scope, found);
    if (found) return constant;
    reportUnknown(name, scope, span);
    return std::nullopt;
}

/// The time is there in models and blocks (section 3.6.7).
std::optional<Value> Translator::time(const Scope& scope, const Span& span) {
    if (scope.instance && scope.instance->isComponent()) return Value::scalar(FlatType::Real, work_.pool.time());
    work_.messages.error(phrase("'time' can be used in models and blocks only"), span,
                         phrase("give it as an argument, or set the variable in the model that holds it"));
    return std::nullopt;
}

/// x[i] where i changes while the model runs: if i = 1 then x[1] elseif …; nothing: the subscripts are known.
std::optional<Value> Translator::chosenWhenItRuns(const syntax::Name& name, const Scope& scope) {
    const std::vector<Expression>& subscripts = name.parts.back().subscripts;
    const bool mayRun = std::any_of(subscripts.begin(), subscripts.end(), [&](const Expression& e) {
        return e.kind == Kind::Reference || e.kind == Kind::Binary || e.kind == Kind::Call;
    });
    if (!mayRun) return std::nullopt;
    const Messages::Quiet quiet(work_.messages);
    syntax::Name whole = name;
    whole.parts.back().subscripts.clear();
    const auto slice = resolve(whole, scope);
    auto array = slice ? valueOf(*slice) : std::nullopt;
    return array ? chosenFrom(*array, subscripts, scope) : std::nullopt;
}

std::optional<Value> Translator::chosenFrom(const Value& array, const std::vector<Expression>& subscripts,
                                            const Scope& scope) {
    if (subscripts.size() > array.dimensions.size() || array.isRecord() || array.type == FlatType::String ||
        array.elements.empty())
        return std::nullopt;
    Value value;
    value.type = array.type;
    value.enumeration = array.enumeration;
    std::vector<ExpressionId> elements = array.elements;
    std::size_t behind = 1;  // elements of the dimensions behind that stay
    for (std::size_t d = array.dimensions.size(); d-- > 0;) {
        if (d >= subscripts.size() || subscripts[d].kind == Kind::Colon) {
            behind *= static_cast<std::size_t>(array.dimensions[d]);
            value.dimensions.insert(value.dimensions.begin(), array.dimensions[d]);
            continue;
        }
        ends_.push_back(array.dimensions[d]);
        const auto index = translate(subscripts[d], scope);
        ends_.pop_back();
        if (!index || !index->isScalar() || index->type != FlatType::Integer) return std::nullopt;
        const auto extent = static_cast<std::size_t>(array.dimensions[d]);
        std::vector<ExpressionId> next;
        if (const auto known = constantNumber(index->elements[0], true)) {
            if (!(*known >= 1 && *known <= array.dimensions[d])) return std::nullopt;
            for (std::size_t block = 0; block < elements.size(); block += extent * behind)
                for (std::size_t j = 0; j < behind; ++j)
                    next.push_back(elements[block + (static_cast<std::size_t>(*known) - 1) * behind + j]);
            elements = std::move(next);
            continue;
        }
        const ExpressionId none = work_.pool.constant(std::numeric_limits<double>::quiet_NaN());
        work_.model.events.subscripts.push_back({index->elements[0], array.dimensions[d], subscripts[d].span});
        for (std::size_t place = 0; place < elements.size() / extent; ++place) {
            const std::size_t block = place / behind * extent * behind + place % behind;
            ExpressionId chosen = none;
            for (std::size_t k = extent; k-- > 0;)
                chosen = work_.pool.ifThenElse(work_.pool.binary(Operation::Equal, index->elements[0],
                                                                 work_.pool.constant(static_cast<double>(k + 1))),
                                               elements[block + k * behind], chosen);
            next.push_back(chosen);
        }
        elements = std::move(next);
    }
    value.elements = std::move(elements);
    return value;
}

/// `x`, `x[i]`, `r.a[2]` of a variable of a function or an iterator.
std::optional<Value> Translator::local(Value value, const syntax::Name& name, const Scope& scope, const Span& span) {
    for (std::size_t p = 0; p < name.parts.size(); ++p) {
        if (p > 0) {
            const Value* member = value.member(name.parts[p].identifier);
            if (!member) {
                work_.messages.error(phrase("'{}' has no member '{}'", typeText(value), name.parts[p].identifier),
                                     span);
                return std::nullopt;
            }
            value = Value(*member);
        }
        if (name.parts[p].subscripts.empty()) continue;
        auto selected = selectFromValue(std::move(value), name.parts[p].subscripts, scope, span);
        if (!selected) return std::nullopt;
        value = std::move(*selected);
    }
    return value;
}

bool Translator::setLocal(const std::string& name, Value value) {
    for (auto own = iterators_.rbegin(); own != iterators_.rend(); ++own)
        if (own->first == name) {
            own->second = std::move(value);
            return true;
        }
    work_.messages.error(phrase("'{}' is not a variable of the function", name), {});
    return false;
}

void Translator::reportUnknown(const syntax::Name& name, const Scope& scope, const Span& span) {
    if (work_.isOfMissingLibrary(name, scope.lexical)) return;
    const std::string& first = name.parts.front().identifier;
    std::vector<std::string> candidates{"time"};
    if (scope.instance) candidates = scope.instance->elementNames();
    for (const auto& [iterator, value] : iterators_) candidates.push_back(iterator);
    const Text inside = scope.instance  ? scope.instance->label()
                        : scope.lexical ? Text("'" + scope.lexical->qualifiedName + "'")
                                        : phrase("the model");
    work_.messages.error(phrase("'{}' is not declared in {}", first, inside), span, didYouMean(first, candidates));
}

// ------------------------------------------------------------------------------------- components and variables

std::optional<Slice> Translator::resolve(const syntax::Name& name, const Scope& scope,
                                         const std::vector<std::string>& members) {
    if (!scope.instance || name.absolute || !scope.instance->find(name.parts.front().identifier)) {
        reportUnknown(name, scope, name.span);
        return std::nullopt;
    }
    Slice slice;
    slice.instances = {scope.instance};
    for (std::size_t i = 0; i < name.parts.size(); ++i) {
        const syntax::NamePart& part = name.parts[i];
        const Span& span = part.span.valid() ? part.span : name.span;
        if (!step(slice, part.identifier, &part.subscripts, scope, span, i == 0)) return std::nullopt;
        const Element& element = *slice.element;
        if (i == 0) slice.startsWithConnector = element.type.isConnector;
        const bool isModel = !slice.instances.empty() && slice.instances.front()->isComponent();
        if (i + 1 < name.parts.size() && isModel) ++slice.componentsBefore;
    }
    for (const std::string& member : members)
        if (!step(slice, member, nullptr, scope, name.span, false)) return std::nullopt;
    return slice;
}

/// From the components of the slice to their member.
bool Translator::step(Slice& slice, const std::string& identifier, const std::vector<Expression>* subscripts,
                      const Scope& scope, const Span& span, bool isFirst) {
    if (slice.instances.empty() && slice.element) {
        work_.messages.error(
            phrase("'{}' is a variable and has no member '{}'", slice.element->declaration->name, identifier), span);
        return false;
    }
    Slice next;
    next.dimensions = slice.dimensions;
    next.startsWithConnector = slice.startsWithConnector;
    next.componentsBefore = slice.componentsBefore;
    const bool isSubscripted = subscripts && !subscripts->empty();
    std::vector<std::size_t> chosen;
    for (Instance* instance : slice.instances) {
        Element* element = memberOf(*instance, identifier, span, isFirst);
        if (!element) return false;
        if (!next.element) {
            next.element = element;
            next.owner = instance;
            if (isSubscripted) {
                const auto lists = subscriptLists(element->dimensions, *subscripts, scope, span, next.dimensions);
                if (!lists || !mayIndex(*element, *subscripts, scope)) return false;
                chosen = elementOffsets(*lists, element->dimensions);
            } else {
                next.dimensions.insert(next.dimensions.end(), element->dimensions.begin(), element->dimensions.end());
            }
        }
        if (element->dimensions != next.element->dimensions) {
            work_.messages.error(phrase("'{}' has the size {} and '{}' the size {}; they are no array together",
                                        next.owner->memberName(identifier), sizeText(next.element->dimensions),
                                        instance->memberName(identifier), sizeText(element->dimensions)),
                                 span, phrase("name one of the components by its subscript"));
            return false;
        }
        if (isSubscripted)
            next.append(*element, chosen);
        else
            next.append(*element);
    }
    if (!next.element) {  // a member of an empty array of components
        work_.messages.error(phrase("'{}' is a member of an empty array", identifier), span);
        return false;
    }
    slice = std::move(next);
    return true;
}

/// A dimension that Boolean or an enumeration gives is indexed by values of that type (section 10.1).
bool Translator::mayIndex(const Element& element, const std::vector<Expression>& subscripts, const Scope& scope) {
    const auto& sizes = element.declaration->dimensions;
    for (std::size_t d = 0; d < subscripts.size() && d < sizes.size(); ++d) {
        if (sizes[d].kind != Kind::Reference || subscripts[d].kind == Kind::Colon) continue;
        const auto all = valuesOfType(sizes[d], element.scope);
        if (!all) continue;
        ends_.push_back(all->dimensions[0]);
        const auto index = translate(subscripts[d], scope);
        ends_.pop_back();
        if (!index) return false;
        const bool isEnd = subscripts[d].kind == Kind::End;
        if (isEnd || (index->type == all->type && index->enumeration == all->enumeration)) continue;
        work_.messages.error(
            phrase("a subscript of this dimension is a value of {}, not {}", sizes[d].span.text(), typeText(*index)),
            subscripts[d].span);
        return false;
    }
    return true;
}

/// The member of one component, instantiated.
Element* Translator::memberOf(Instance& instance, const std::string& identifier, const Span& span, bool isFirst) {
    Element* element = instance.find(identifier);
    if (!element) {
        work_.messages.error(phrase("{} has no member '{}'", instance.label(), identifier), span,
                             didYouMean(identifier, instance.elementNames()));
        return nullptr;
    }
    if (element->isProtected && !isFirst) {
        work_.messages.error(phrase("'{}' of {} is protected", identifier, instance.label()), span,
                             phrase("use a public variable, or make it public where it is declared"));
        return nullptr;
    }
    if (!work_.instantiator->ensure(instance, *element)) {
        if (!work_.messages.hasErrors())  // else why it could not be has been said
            work_.messages.error(phrase("'{}' could not be instantiated", instance.memberName(identifier)), span);
        return nullptr;
    }
    if (element->isDisabled) {
        work_.messages.error(phrase("'{}' is switched off by its condition", instance.memberName(identifier)), span,
                             phrase("a conditional component may be used in connect equations only"));
        return nullptr;
    }
    return element;
}

void Slice::append(const Element& of) {
    if (of.isVariable())
        for (std::uint32_t k = 0; k < of.count(); ++k) variables.push_back({of.firstVariable.value + k});
    else
        instances.insert(instances.end(), of.items.begin(), of.items.end());
}

/// Only what is chosen: a loop over a long array costs what its elements cost.
void Slice::append(const Element& of, const std::vector<std::size_t>& offsets) {
    for (const std::size_t k : offsets) {
        if (of.isVariable())
            variables.push_back({of.firstVariable.value + static_cast<std::uint32_t>(k)});
        else
            instances.push_back(of.items.at(k));
    }
}

/// Index lists (0-based) of the subscripts, one for each dimension; `remaining` gets the sizes that stay.
std::optional<std::vector<std::vector<int>>> Translator::subscriptLists(const std::vector<int>& dimensions,
                                                                        const std::vector<Expression>& subscripts,
                                                                        const Scope& scope, const Span& span,
                                                                        std::vector<int>& remaining) {
    if (subscripts.size() > dimensions.size()) {
        work_.messages.error(
            phrase("'{}' has {} subscripts for {} dimensions", span.text(), subscripts.size(), dimensions.size()),
            span);
        return std::nullopt;
    }
    std::vector<std::vector<int>> lists;
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
        std::vector<int>& list = lists.emplace_back();
        if (d >= subscripts.size() || subscripts[d].kind == Kind::Colon) {
            for (int i = 0; i < dimensions[d]; ++i) list.push_back(i);
            remaining.push_back(dimensions[d]);
            continue;
        }
        ends_.push_back(dimensions[d]);
        const auto value = translate(subscripts[d], scope);
        ends_.pop_back();
        if (!value) return std::nullopt;
        if (!value->isNumeric() && value->enumeration.empty() && value->type != FlatType::Boolean) {
            work_.messages.error(phrase("a subscript must be an Integer, not {}", typeText(*value)),
                                 subscripts[d].span);
            return std::nullopt;
        }
        for (ExpressionId element : value->elements) {
            auto number = constantNumber(element, true);
            if (number && value->type == FlatType::Boolean) ++*number;  // false comes first
            if (!number || *number != std::round(*number)) {
                work_.messages.error(phrase("a subscript must be an Integer that is known before the simulation"),
                                     subscripts[d].span,
                                     phrase("use a number, an iterator of a for loop or a parameter"));
                return std::nullopt;
            }
            if (*number < 1 || *number > dimensions[d]) {
                work_.messages.error(phrase("the subscript {} is outside 1:{}", *number, dimensions[d]),
                                     subscripts[d].span);
                return std::nullopt;
            }
            list.push_back(static_cast<int>(*number) - 1);
        }
        if (!value->isScalar()) remaining.push_back(value->dimensions[0]);
    }
    return lists;
}

std::optional<Value> Translator::selectFromValue(Value value, const std::vector<Expression>& subscripts,
                                                 const Scope& scope, const Span& span) {
    if (subscripts.empty()) return value;
    {
        const Messages::Quiet quiet(work_.messages);
        std::vector<int> remaining;
        if (!subscriptLists(value.dimensions, subscripts, scope, span, remaining))
            if (auto chosen = chosenFrom(value, subscripts, scope)) return chosen;
    }
    Value result;
    result.type = value.type;
    result.enumeration = value.enumeration;
    const auto lists = subscriptLists(value.dimensions, subscripts, scope, span, result.dimensions);
    if (!lists) return std::nullopt;
    if (value.isObject() || value.isFunction()) {
        work_.messages.error(phrase("'{}' is no array of values", span.text()), span);
        return std::nullopt;
    }
    if (value.isRecord()) {  // its dimensions lead those of its members
        result.record = value.record;
        for (auto& [name, member] : value.members) {
            auto part = selectFromValue(std::move(member), subscripts, scope, span);
            if (!part) return std::nullopt;
            result.members.emplace_back(name, std::move(*part));
        }
        return result;
    }
    for (std::size_t offset : elementOffsets(*lists, value.dimensions)) {
        if (value.type == FlatType::String)
            result.texts.push_back(value.texts[offset]);
        else
            result.elements.push_back(value.elements[offset]);
    }
    return result;
}

/// A variable that is there on a condition is known to connections only (section 4.4.5).
bool Translator::mayBeUsed(const Slice& slice, const Span& span) {
    if (!slice.element->isVariable() || !slice.element->original->condition) return true;
    work_.messages.error(phrase("'{}' is declared on a condition", slice.element->original->name), span,
                         phrase("a conditional component may be used in connect equations only"));
    return false;
}

std::optional<Value> Translator::valueOf(const Slice& slice) {
    const Element& element = *slice.element;
    if (element.isObject) return objectOf(*slice.element);
    const bool isRecord = !slice.instances.empty() && slice.instances.front()->isOfRecord();
    if (isRecord && slice.dimensions.empty()) return recordOf(*slice.instances.front());
    if (isRecord && slice.dimensions.size() == 1) {
        Value array;
        array.dimensions = {0};
        for (Instance* instance : slice.instances) {
            const auto one = recordOf(*instance);
            if (!one || !append(array, *one, element.declaration->nameSpan)) return std::nullopt;
        }
        return array;
    }
    if (!element.isVariable()) {
        work_.messages.error(phrase("'{}' is a component of class {}, not a value",
                                    slice.owner->memberName(element.declaration->name), element.type.className),
                             element.declaration->nameSpan, phrase("name one of its variables"));
        return std::nullopt;
    }
    Value value;
    value.type = element.type.builtin;
    value.dimensions = slice.dimensions;
    if (!spend(slice.variables.size(), element.declaration->nameSpan)) return std::nullopt;
    value.enumeration = element.type.enumerationName();
    for (VariableId id : slice.variables) {
        if (value.type != FlatType::String) {
            const auto set = overlay_.empty() ? overlay_.end() : overlay_.find(id.value);
            value.elements.push_back(set == overlay_.end() ? work_.pool.variable(id) : set->second);
            continue;
        }
        if (!work_.binder->bindParameter(*work_.records[id.value].owner, work_.elementOf(id))) return std::nullopt;
        const bool isFixed = element.original->variability == syntax::Variability::Parameter ||
                             element.original->variability == syntax::Variability::Constant ||
                             element.declaration->variability == syntax::Variability::Parameter ||
                             element.declaration->variability == syntax::Variability::Constant;
        if (!isFixed && !work_.records[id.value].isBound && !isTarget_) {
            work_.messages.error(phrase("the text '{}' is used before it is set", work_.variable(id).name),
                                 element.declaration->nameSpan, phrase("give it a value where it is declared"));
            return std::nullopt;
        }
        value.texts.push_back(work_.variable(id).text);
    }
    return value;
}

/// All members of a record with their values.
std::optional<Value> Translator::recordOf(Instance& instance) {
    Value value;
    value.record = instance.definition->qualifiedName;
    for (Element& element : instance.elements) {
        if (!work_.instantiator->ensure(instance, element)) return std::nullopt;
        if (element.isDisabled) continue;
        Slice slice;
        slice.element = &element;
        slice.owner = &instance;
        slice.dimensions = element.dimensions;
        slice.append(element);
        auto member = valueOf(slice);
        if (!member) return std::nullopt;
        value.members.emplace_back(element.declaration->name, std::move(*member));
    }
    return value;
}

std::optional<Value> Translator::objectOf(Element& element) {
    if (element.object < 0) {
        const auto value = element.modifier.value.valid() ? translate(element.modifier.value) : std::nullopt;
        if (!value || !value->isObject()) {
            work_.messages.error(phrase("the external object '{}' has no value", element.declaration->name),
                                 element.declaration->nameSpan);
            return std::nullopt;
        }
        element.object = value->object;
    }
    Value value;
    value.object = element.object;
    return value;
}

// -------------------------------------------------------------------------------- constants and literals

std::optional<Value> Translator::enumerationLiteral(const LibraryClass& definition, const std::string& literal,
                                                    const Span& span) {
    const auto& literals = definition.definition->enumeration;
    for (std::size_t i = 0; i < literals.size(); ++i)
        if (literals[i] == literal) {
            Value value = Value::scalar(FlatType::Integer, work_.pool.constant(static_cast<double>(i + 1)));
            value.enumeration = definition.qualifiedName;
            return value;
        }
    work_.messages.error(phrase("'{}' is not a value of the enumeration {}", literal, definition.qualifiedName), span,
                         didYouMean(literal, literals));
    return std::nullopt;
}

/// The enumeration that a short class stands for, `type T = E`; the class itself where it stands for none.
const LibraryClass* Translator::enumerationBehind(const LibraryClass* named) const {
    constexpr int most = 20;  // classes may go round
    const LibraryClass* definition = named;
    for (int i = 0; i < most && definition && definition->definition->isShort; ++i) {
        if (definition->definition->isEnumeration) return definition;
        definition = work_.library.lookup(definition->definition->shortBase, definition->scope);
    }
    return definition && definition->definition->isEnumeration ? definition : named;
}

/// A literal of an enumeration, a constant of a package by its full name, or one of the enclosing classes.
std::optional<Value> Translator::namedConstant(const syntax::Name& name, const Scope& scope, bool& found) {
    const std::string& last = name.parts.back().identifier;
    std::optional<Value> value;
    std::set<const LibraryClass*> seen;
    if (name.parts.size() > 1) {
        const std::string prefix = textUpTo(name, name.parts.size() - 1);
        const LibraryClass* definition =
            name.absolute ? work_.library.lookup(prefix, "") : work_.lookup(prefix, scope.lexical);
        if (!definition) return std::nullopt;
        if (!work_.rules->mayReach(name, scope.lexical)) {
            found = true;
            return std::nullopt;
        }
        definition = enumerationBehind(definition);
        if (definition->definition->isEnumeration) {
            work_.rules->check(*definition);
            found = true;
            return enumerationLiteral(*definition, last, name.span);
        }
        value = constantOf(*definition, last, found, seen);
        if (!found) {
            found = true;
            std::vector<std::string> names;
            for (const auto& component : definition->definition->components) names.push_back(component.name);
            work_.messages.error(phrase("'{}' has no constant '{}'", definition->qualifiedName, last), name.span,
                                 didYouMean(last, names));
            return std::nullopt;
        }
    } else {
        for (const LibraryClass* outer = scope.lexical; outer && !found; outer = work_.library.find(outer->scope)) {
            value = constantOf(*outer, last, found, seen);
            const auto& components = outer->definition->components;
            const auto nearer = std::find_if(components.begin(), components.end(),
                                             [&](const syntax::Component& c) { return c.name == last; });
            if (!found && nearer != components.end()) break;  // no constant: it hides those further out
            if (!found) value = importedConstant(name, *outer, found, seen);
            if (outer->scope.empty() || outer->definition->isEncapsulated) break;
        }
    }
    if (found && value) return selectFromValue(std::move(*value), name.parts.back().subscripts, scope, name.span);
    return value;
}

/// `import Modelica.Constants.pi;` and, behind all of these, `import Modelica.Constants.*;` (section 5.3.1).
std::optional<Value> Translator::importedConstant(const syntax::Name& name, const LibraryClass& in, bool& found,
                                                  std::set<const LibraryClass*>& seen) {
    const std::string& first = name.parts.front().identifier;
    for (const syntax::Import& import : in.definition->imports) {
        if (import.wildcard || import.alias != first || import.name.parts.size() < 2) continue;
        syntax::Name package = import.name;
        const std::string constant = package.parts.back().identifier;
        package.parts.pop_back();
        package.absolute = true;
        const LibraryClass* const holder = work_.library.lookup(package, "");
        auto value = holder ? constantOf(*holder, constant, found, seen) : std::nullopt;
        if (found) return value;
    }
    return constantOfWholeImports(name, in, found, seen);
}

/// What is public in the packages that are imported as a whole; a name that two of them have is refused.
std::optional<Value> Translator::constantOfWholeImports(const syntax::Name& name, const LibraryClass& in, bool& found,
                                                        std::set<const LibraryClass*>& seen) {
    const std::string& first = name.parts.front().identifier;
    const LibraryClass* from = nullptr;
    std::optional<Value> value;
    for (const syntax::Import& import : in.definition->imports) {
        if (!import.wildcard) continue;
        syntax::Name package = import.name;
        package.absolute = true;
        const LibraryClass* const holder = work_.library.lookup(package, "");
        if (!holder || holder == from) continue;
        const auto& components = holder->definition->components;
        if (std::any_of(components.begin(), components.end(),
                        [&](const syntax::Component& c) { return c.name == first && c.isProtected; }))
            continue;
        bool isHere = false;
        auto its = constantOf(*holder, first, isHere, seen);
        if (!isHere) continue;
        found = true;
        if (from) {
            work_.messages.error(
                phrase("'{}' is imported from '{}' and from '{}'", first, from->qualifiedName, holder->qualifiedName),
                name.span, phrase("import the one that is meant by its name"));
            return std::nullopt;
        }
        from = holder;
        value = std::move(its);
    }
    return value;
}

std::optional<Value> Translator::constantOf(const LibraryClass& definition, const std::string& name, bool& found,
                                            std::set<const LibraryClass*>& seen) {
    if (!seen.insert(&definition).second) return std::nullopt;
    work_.rules->check(definition);
    for (const auto& component : definition.definition->components) {
        if (component.name != name) continue;
        if (component.variability != syntax::Variability::Constant) return std::nullopt;
        found = true;
        work_.keepSource(*definition.definition);
        const auto busy = busyConstants_.emplace(&definition, name);
        if (!busy.second || !component.binding) {
            work_.messages.error(busy.second
                                     ? phrase("the constant '{}.{}' has no value", definition.qualifiedName, name)
                                     : phrase("the constant '{}.{}' depends on itself", definition.qualifiedName, name),
                                 component.nameSpan);
            if (busy.second) busyConstants_.erase(busy.first);
            return std::nullopt;
        }
        std::vector<std::pair<std::string, Value>> frame;  // variables of a function mean nothing here
        frame.swap(iterators_);
        auto value = translate(*component.binding, {nullptr, &definition});
        frame.swap(iterators_);
        busyConstants_.erase({&definition, name});
        return value;
    }
    const syntax::ClassDefinition& tree = *definition.definition;
    const LibraryClass* outside = work_.library.find(definition.scope);
    // A modification on the way to the base is nearer than the base's own value.
    const auto inherited = [&](const syntax::Name& baseName, const std::vector<syntax::Modification>& modifications,
                               const LibraryClass* scope) -> std::optional<Value> {
        const LibraryClass* base = work_.library.lookup(baseName, definition.qualifiedName);
        if (base == &definition) base = outside ? work_.lookup(baseName, outside) : nullptr;
        if (!base) return std::nullopt;
        for (const syntax::Modification& m : modifications) {
            if (m.name.text() != name || !m.value) continue;
            found = true;
            work_.keepSource(tree);
            if (!busyConstants_.emplace(&definition, name).second) {
                work_.messages.error(phrase("the constant '{}.{}' depends on itself", definition.qualifiedName, name),
                                     m.span);
                return std::nullopt;
            }
            std::vector<std::pair<std::string, Value>> frame;
            frame.swap(iterators_);
            auto value = translate(*m.value, {nullptr, scope});
            frame.swap(iterators_);
            busyConstants_.erase({&definition, name});
            return value;
        }
        return constantOf(*base, name, found, seen);
    };
    if (tree.isShort && !tree.isEnumeration) return inherited(tree.shortBase, tree.shortModifications, outside);
    for (const auto& base : tree.bases) {
        auto value = inherited(base.base, base.modifications, &definition);
        if (found) return value;
    }
    return std::nullopt;
}

}  // namespace analogon
