#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "core/diagram/edit.hpp"
#include "core/diagram/edit_text.hpp"

/// Changes of what a class inherits: they are written where Modelica has them, as modifications of the extends clause
/// (Modelica 3.6, section 7.2).
namespace analogon {

using syntax::ClassDefinition;
using syntax::Component;
using syntax::Replacement;

namespace {

/// Calls `visit` with every class a base stands for, nearest first; ends when it says true.
bool visitInherited(const Library& library, const LibraryClass* cls,
                    const std::function<bool(const LibraryClass&)>& visit, std::set<const LibraryClass*>& seen) {
    if (!cls || !seen.insert(cls).second) return false;
    if (visit(*cls)) return true;
    const std::vector<const LibraryClass*> bases = library.bases(*cls);
    return std::any_of(bases.begin(), bases.end(),
                       [&](const LibraryClass* base) { return visitInherited(library, base, visit, seen); });
}

const LibraryClass* classOf(const Library& library, const ClassDefinition& definition) {
    for (const LibraryClass* cls : library.classes())
        if (cls->definition.get() == &definition) return cls;
    return library.find(definition.name);  // the same text, parsed a second time
}

std::vector<const syntax::Name*> baseNames(const ClassDefinition& definition) {
    std::vector<const syntax::Name*> names;
    if (definition.isShort && !definition.isEnumeration) names.push_back(&definition.shortBase);
    for (const syntax::Extends& base : definition.bases) names.push_back(&base.base);
    return names;
}

}  // namespace

std::optional<ModelEdit::Inherited> ModelEdit::inherited(std::string_view component) const {
    const std::vector<const syntax::Name*> names = baseNames(*definition_);
    const LibraryClass* self = library_ ? classOf(*library_, *definition_) : nullptr;
    if (!self) {
        // Nothing tells what the base holds: of one base it is believed, of several none is chosen.
        if (library_ || names.size() != 1) return std::nullopt;
        return Inherited{0, nullptr, names.front()->text()};
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        const LibraryClass* base =
            library_->lookup(*names[i], definition_->isShort ? self->scope : self->qualifiedName);
        Inherited result{i, nullptr, {}};
        std::set<const LibraryClass*> seen{self};
        const bool found = visitInherited(
            *library_, base,
            [&](const LibraryClass& cls) {
                for (const Component& c : cls.definition->components)
                    if (c.name == component) {
                        result.declaration = &c;
                        result.owner = cls.qualifiedName;
                    }
                return result.declaration != nullptr;
            },
            seen);
        if (found) return result;
    }
    return std::nullopt;
}

std::vector<std::string> ModelEdit::componentNames() const {
    std::vector<std::string> names;
    for (const Component& c : definition_->components) names.push_back(c.name);
    const LibraryClass* self = library_ ? classOf(*library_, *definition_) : nullptr;
    std::set<const LibraryClass*> seen;
    if (self)
        visitInherited(
            *library_, self,
            [&](const LibraryClass& cls) {
                if (&cls != self)
                    for (const Component& c : cls.definition->components) names.push_back(c.name);
                return false;
            },
            seen);
    return names;
}

bool ModelEdit::changeInherited(std::string_view component, std::string name, const std::string& value) {
    const std::optional<Inherited> found = inherited(component);
    if (found) inherited_[found->base].values.emplace_back(std::move(name), value);
    return found.has_value();
}

bool ModelEdit::redeclareInherited(std::string_view component, const std::string& className) {
    const std::optional<Inherited> found = inherited(component);
    if (!found) return false;
    if (found->declaration && !found->declaration->isReplaceable)
        faults_.push_back(error(phrase("the class of \"{}\" cannot change in model {}: it is inherited from {}, "
                                       "where it is not replaceable",
                                       component, definition_->name, found->owner),
                                found->declaration->nameSpan, phrase("declare it as \"replaceable\" there")));
    inherited_[found->base].classes.emplace_back(std::string(component), className);
    return true;
}

bool ModelEdit::refuseInherited(std::string_view component, const Text& what) {
    const std::optional<Inherited> found = inherited(component);
    if (found)
        faults_.push_back(error(phrase("\"{}\" is inherited from {} and cannot be {} in model {}", component,
                                       found->owner, what, definition_->name),
                                found->declaration ? found->declaration->nameSpan : definition_->nameSpan,
                                phrase("change the class it comes from")));
    return found.has_value();
}

void ModelEdit::writeInherited(Replacements& edits) const {
    for (const auto& [base, change] : inherited_) {
        const bool isShort = definition_->isShort;
        const auto& list = isShort ? definition_->shortModifications : definition_->bases[base].modifications;
        const Span& span = isShort ? definition_->shortModificationsSpan : definition_->bases[base].modificationsSpan;
        for (Replacement& r : edit_text::setModifications(list, span, change.values, change.classes))
            edits.push_back(std::move(r));
    }
}

/// A short class has no place for components and equations: `model A = B(…) "…"` becomes `model A "…" extends B(…); …
/// end A`, which means the same.
void ModelEdit::writeLongClass(Replacements& edits) const {
    const std::string& text = definition_->source->text();
    const std::string newline = edit_text::lineEnd(text);
    const std::string indent = edit_text::indentation(text, definition_->span.begin);
    const std::uint32_t behindName = definition_->nameSpan.end, behindBase = definition_->shortModificationsSpan.end;
    const std::uint32_t end = definition_->span.end;

    Replacements inside;
    writeInherited(inside);
    const std::string base = edit_text::applied(text, definition_->shortBase.span.begin, behindBase, std::move(inside));
    const std::uint32_t behindDescription = definition_->annotation ? definition_->annotation->span.begin : end;
    std::string description = text.substr(behindBase, behindDescription - behindBase);
    description.erase(description.find_last_not_of(" \t\r\n") + 1);
    std::string body = description + newline + indent + "  extends " + base + ";";
    body += newComponentsText(indent + "  ");
    if (!newConnections_.empty()) body += newline + indent + "equation" + newConnectionsText(indent + "  ");
    if (definition_->annotation)
        body += newline + indent + "  " + std::string(definition_->annotation->span.text()) + ";";
    body += newline + indent + "end " + definition_->name;
    edits.push_back({behindName, end, body});
}

std::string freeName(const Library& library, const ClassDefinition& definition, const std::string& base) {
    std::set<std::string> taken{definition.name};
    std::set<const LibraryClass*> seen;
    const auto take = [&](const ClassDefinition& d) {
        for (const Component& c : d.components) taken.insert(c.name);
        for (const syntax::ClassPtr& c : d.classes) taken.insert(c->name);
        for (const syntax::Import& i : d.imports) taken.insert(i.alias);
    };
    take(definition);
    if (const LibraryClass* self = classOf(library, definition))
        visitInherited(
            library, self,
            [&](const LibraryClass& cls) {
                take(*cls.definition);
                return false;
            },
            seen);
    std::string name = base;
    for (int number = 1; taken.contains(name); ++number) name = fmt::format("{}{}", base, number);
    return name;
}

}  // namespace analogon
