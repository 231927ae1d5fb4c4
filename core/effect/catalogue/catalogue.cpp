#include "core/effect/catalogue/catalogue.hpp"

#include <fmt/format.h>

namespace analogon {
namespace {

using syntax::Expression;
using syntax::Modification;

const Modification* child(const Modification& parent, std::string_view name) {
    for (const Modification& m : parent.arguments)
        if (m.name.text() == name) return &m;
    return nullptr;
}

/// Reads the `effect(…)` annotation of one class; the first thing that is not as the grammar asks is a warning.
class AnnotationReader {
public:
    AnnotationReader(const std::string& className, Diagnostics& warnings)
        : className_(className), warnings_(warnings) {}

    bool ok() const { return ok_; }

    std::string text(const Modification& effect, std::string_view name, bool isRequired) {
        const Modification* m = child(effect, name);
        if (m == nullptr) {
            if (isRequired) complain(effect.span, phrase("the effect annotation of {} lacks '{}'", className_, name));
            return {};
        }
        if (!m->value || m->value->kind != Expression::Kind::String) {
            complain(m->span, phrase("'{}' must be a text in quotes", name));
            return {};
        }
        return m->value->text;
    }

    bool flag(const Modification& effect, std::string_view name) {
        const Modification* m = child(effect, name);
        if (m == nullptr) return false;
        if (!m->value || m->value->kind != Expression::Kind::Boolean) {
            complain(m->span, phrase("'{}' must be true or false", name));
            return false;
        }
        return m->value->number != 0;
    }

    std::vector<std::string> list(const Modification& effect, std::string_view name) {
        const Modification* m = child(effect, name);
        if (m == nullptr || !m->value) return {};
        return texts(*m->value, name);
    }

    double number(const Expression& value, std::string_view name) {
        if (value.kind == Expression::Kind::Number) return value.number;
        complain(value.span, phrase("'{}' must be a number", name));
        return 0;
    }

    std::vector<std::string> texts(const Expression& value, std::string_view name) {
        if (value.kind == Expression::Kind::String) return {value.text};
        std::vector<std::string> result;
        if (value.kind == Expression::Kind::Array)
            for (const Expression& e : value.operands) {
                if (e.kind != Expression::Kind::String) {
                    complain(e.span, phrase("'{}' must be a list of texts in quotes", name));
                    return {};
                }
                result.push_back(e.text);
            }
        else
            complain(value.span, phrase("'{}' must be a list of texts in braces", name));
        return result;
    }

private:
    void complain(const Span& span, Text message) {
        ok_ = false;
        warnings_.push_back(warning(std::move(message), span,
                                    phrase("the class takes no part in the search for effects until this is mended")));
    }

    const std::string& className_;
    Diagnostics& warnings_;
    bool ok_{true};
};

const Modification* vendorAnnotation(const syntax::ClassDefinition& definition, std::string_view name) {
    if (!definition.annotation) return nullptr;
    const Modification* vendor = definition.annotation->find("__Analogon");
    return vendor ? child(*vendor, name) : nullptr;
}

const Modification* effectAnnotation(const syntax::ClassDefinition& definition) {
    return vendorAnnotation(definition, "effect");
}

/// Parameters a class declares or inherits, with their unit: those an effect can name.
void collectParameters(const Library& library, const LibraryClass& of, std::map<std::string, std::string>& units,
                       int depth = 0) {
    if (depth > 20) return;
    for (const syntax::Extends& base : of.definition->bases)
        if (const LibraryClass* b = library.lookup(base.base, of.qualifiedName))
            collectParameters(library, *b, units, depth + 1);
    for (const syntax::Component& c : of.definition->components) {
        if (c.variability != syntax::Variability::Parameter) continue;
        std::string unit;
        for (const Modification& m : c.modifications)
            if (m.name.text() == "unit" && m.value && m.value->kind == Expression::Kind::String) unit = m.value->text;
        units[c.name] = unit;
    }
}

/// What the annotation says, each word as it is.
EffectClass readWords(const LibraryClass& of, const Modification& annotation, AnnotationReader& read) {
    EffectClass e;
    e.className = of.qualifiedName;
    e.description = of.definition->description;
    e.kind = read.text(annotation, "kind", true);
    e.placement.ports = read.list(annotation, "ports");
    e.placement.signalSide = read.text(annotation, "at", false);
    e.parameters.inSignalUnit = read.list(annotation, "inSignalUnit");
    e.parameters.inSignalRate = read.list(annotation, "inSignalRate");
    e.parameters.strength = read.text(annotation, "strength", true);
    e.parameters.oneSided = read.flag(annotation, "oneSided");
    e.placement.behindSource = read.flag(annotation, "behindSource");
    e.trial.flexible = read.flag(annotation, "flexible");
    e.parameters.linear = read.list(annotation, "linear");
    e.trial.secant = read.list(annotation, "secant");
    e.parameters.whole = read.list(annotation, "whole");
    e.wave.phase = read.text(annotation, "phase", false);
    e.wave.along = read.text(annotation, "along", false);
    e.wave.waves = read.text(annotation, "waves", false);
    e.placement.quantity = read.text(annotation, "quantity", false);
    e.trial.valid = read.text(annotation, "valid", false);
    e.proposal = read.text(annotation, "proposal", false);
    e.placement.channel = read.text(annotation, "channel", false);
    e.placement.orInput = read.flag(annotation, "orInput");
    e.placement.node = read.text(annotation, "node", false);
    if (const Modification* fixed = child(annotation, "fixed"))
        for (const Modification& m : fixed->arguments)
            if (m.value)
                for (const std::string& t : read.texts(*m.value, m.name.text())) e.parameters.fixed[m.name.text()] = t;
    if (const Modification* states = child(annotation, "states"); states && states->value)
        e.trial.states = static_cast<int>(read.number(*states->value, "states"));
    for (const auto& [name, factors] :
         {std::pair{"sharper", &e.trial.sharper}, std::pair{"reach", &e.trial.reach}, std::pair{"part", &e.trial.part}})
        if (const Modification* given = child(annotation, name))
            for (const Modification& m : given->arguments)
                if (m.value) (*factors)[m.name.text()] = read.number(*m.value, m.name.text());
    if (const Modification* shape = child(annotation, "shape"))
        for (const Modification& m : shape->arguments)
            if (m.value) e.parameters.shape[m.name.text()] = read.texts(*m.value, m.name.text());
    return e;
}

Diagnostic refusal(const Modification& annotation, Text message, Text hint) {
    return warning(std::move(message), annotation.span, std::move(hint));
}

/// How the effect enters a model, and that it has the connectors or the base class which that takes.
Diagnostics settleWay(const Library& library, const LibraryClass& of, const Modification& annotation,
                      const std::string& way, EffectClass& e) {
    if (way == "attach")
        e.placement.way = Way::Attach;
    else if (way == "insert")
        e.placement.way = Way::Insert;
    else if (way == "specialise")
        e.placement.way = Way::Specialise;
    else if (way == "bridge")
        e.placement.way = Way::Bridge;
    else
        return {refusal(annotation, phrase("unknown way '{}' of the effect {}", way, of.qualifiedName),
                        phrase("use \"attach\", \"insert\", \"specialise\" or \"bridge\""))};
    const std::size_t wanted = e.placement.way == Way::Attach ? 1 : e.placement.way == Way::Specialise ? 0 : 2;
    if (e.placement.ports.size() != wanted)
        return {refusal(annotation,
                        phrase("the effect {} names {} connectors, '{}' takes {}", of.qualifiedName,
                               e.placement.ports.size(), way, wanted),
                        phrase("list them as ports = {{\"…\"}}"))};
    if (e.placement.way != Way::Specialise) return {};
    if (of.definition->bases.empty())
        return {refusal(annotation, phrase("{} specialises nothing: it inherits from no class", of.qualifiedName),
                        phrase("let it extend the base class of the components it may replace"))};
    const LibraryClass* base = library.lookup(of.definition->bases.front().base, of.qualifiedName);
    if (base == nullptr)
        return {refusal(annotation, phrase("the base class of {} is not known", of.qualifiedName), "")};
    e.base = base->qualifiedName;
    return {};
}

/// The parameters that the effect adds, with their units.
void settleParameters(const Library& library, const LibraryClass& of, EffectClass& e) {
    collectParameters(library, of, e.parameters.units);
    if (e.placement.way != Way::Specialise) return;
    std::map<std::string, std::string> ofBase;
    collectParameters(library, *library.find(e.base), ofBase);
    for (const auto& [name, unit] : ofBase) e.parameters.units.erase(name);
}

/// All parameters that the annotation names.
std::vector<std::string> namedParameters(const EffectClass& e) {
    std::vector<std::string> named = e.parameters.linear;
    for (const std::vector<std::string>* more :
         {&e.parameters.whole, &e.parameters.inSignalUnit, &e.parameters.inSignalRate})
        named.insert(named.end(), more->begin(), more->end());
    named.push_back(e.parameters.strength);
    if (!e.wave.phase.empty()) named.push_back(e.wave.phase);
    if (!e.wave.waves.empty()) named.push_back(e.wave.waves);
    for (const auto& [parameter, value] : e.parameters.fixed) named.push_back(parameter);
    for (const auto& [parameter, values] : e.parameters.shape) named.push_back(parameter);
    return named;
}

Outcome<EffectClass> readEffect(const Library& library, const LibraryClass& of, const Modification& annotation) {
    Diagnostics warnings;
    AnnotationReader read(of.qualifiedName, warnings);
    const std::string way = read.text(annotation, "way", true);
    EffectClass e = readWords(of, annotation, read);
    if (!read.ok()) return warnings;
    if (Diagnostics refused = settleWay(library, of, annotation, way, e); !refused.empty()) return refused;
    settleParameters(library, of, e);
    for (const std::string& n : namedParameters(e))
        if (!e.parameters.units.contains(n))
            return {refusal(annotation, phrase("the effect {} has no parameter '{}'", of.qualifiedName, n),
                            phrase("declare it, or mend the name in the annotation"))};
    return e;
}

}  // namespace

std::string faultOf(const EffectClass& effect) { return effect.kind.substr(effect.kind.find('.') + 1); }

std::optional<EffectClass> effectOf(const Library& library, const LibraryClass& one) {
    const Modification* annotation = effectAnnotation(*one.definition);
    if (annotation == nullptr) return std::nullopt;
    Outcome<EffectClass> effect = readEffect(library, one, *annotation);
    return effect ? std::optional(std::move(*effect)) : std::nullopt;
}

std::vector<std::string> combinedIn(const LibraryClass& one) {
    std::vector<std::string> names;
    const Modification* combines = vendorAnnotation(*one.definition, "combines");
    if (combines == nullptr || !combines->value) return names;
    for (const Expression& e : combines->value->operands)
        if (e.kind == Expression::Kind::String) names.push_back(e.text);
    return names;
}

Outcome<std::vector<EffectClass>> effectCatalogue(const Library& library) {
    std::vector<EffectClass> effects;
    Diagnostics warnings;
    for (const LibraryClass* c : library.classes()) {
        const Modification* annotation = effectAnnotation(*c->definition);
        if (annotation == nullptr) continue;
        if (Outcome<EffectClass> effect = readEffect(library, *c, *annotation))
            effects.push_back(std::move(*effect));
        else
            warnings.insert(warnings.end(), effect.diagnostics().begin(), effect.diagnostics().end());
    }
    return {std::move(effects), std::move(warnings)};
}

}  // namespace analogon
