#include "core/flat/flattening.hpp"

#include <algorithm>

#include "core/flat/binder.hpp"
#include "core/flat/class_rules.hpp"
#include "core/flat/connections.hpp"
#include "core/flat/events.hpp"
#include "core/flat/instantiator.hpp"
#include "core/flat/refused_construct.hpp"
#include "core/flat/translator.hpp"
#include "core/library/moved_classes.hpp"

namespace analogon {

namespace {

FlatModel emptyModel() {
    FlatModel model;
    model.pool = std::make_shared<ExpressionPool>();
    return model;
}

}  // namespace

Flattening::Flattening(const Library& lib)
    : library(lib),
      model(emptyModel()),
      pool(*model.pool),
      rules(std::make_unique<ClassRules>(*this)),
      instantiator(std::make_unique<Instantiator>(*this)),
      translator(std::make_unique<Translator>(*this)),
      binder(std::make_unique<Binder>(*this)),
      connections(std::make_unique<Connections>(*this)),
      events(std::make_unique<Events>(*this)) {}

Flattening::~Flattening() = default;

const LibraryClass* Flattening::lookup(const std::string& name, const LibraryClass* from) {
    const auto [entry, isNew] = found_[from].try_emplace(name, nullptr);
    if (isNew) entry->second = library.lookup(name, from ? std::string_view(from->qualifiedName) : std::string_view());
    return entry->second;
}

const LibraryClass* Flattening::lookup(const syntax::Name& name, const LibraryClass* from) {
    const LibraryClass* const found = name.absolute ? library.lookup(name, "") : lookup(name.text(), from);
    if (found) tellNewName(name);
    return found;
}

void Flattening::tellNewName(const syntax::Name& name) {
    if (name.parts.empty() || name.parts.front().identifier != "Modelica") return;
    std::string text = name.text();
    if (text.starts_with('.')) text.erase(0, 1);
    const MovedClass* const moved = movedClass(text);
    if (!moved || told_.contains(moved->before)) return;
    const LibraryClass* const holder = library.find(moved->before);
    if (!holder || holder->qualifiedName == moved->before) return;  // a library in which it has this name
    told_.insert(moved->before);
    messages.warning(phrase("'{}' is called '{}' in the library that was found", moved->before, moved->now), name.span,
                     phrase("the newer name is taken; write it to be independent of the version"));
}

namespace {

/// The root of a name, an alias of an import followed.
std::string rootOf(const syntax::Name& name, const LibraryClass* from, const Library& library) {
    if (name.parts.empty()) return {};
    const std::string& first = name.parts.front().identifier;
    for (; from && !name.absolute; from = library.find(from->scope))
        for (const syntax::Import& import : from->definition->imports)
            if (!import.wildcard && import.alias == first) return import.name.parts.front().identifier;
    return first;
}

/// How many letters in a row two words have in common.
std::size_t likeness(std::string_view a, std::string_view b) {
    std::size_t best = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            std::size_t k = 0;
            while (i + k < a.size() && j + k < b.size() && (a[i + k] | 0x20) == (b[j + k] | 0x20)) ++k;
            best = std::max(best, k);
        }
    return best;
}

/// The class of the own library whose name is most like it; empty: none is.
std::string nearestOwn(std::string_view name, const Library& library) {
    constexpr std::size_t least = 5;  // letters
    std::string best;
    double most = 0;
    for (const std::string& each : library.names()) {
        if (!each.starts_with("Analogon.")) continue;
        const std::string_view last = std::string_view(each).substr(each.rfind('.') + 1);
        const std::size_t common = likeness(name, last);
        const double share = 2.0 * static_cast<double>(common) / static_cast<double>(name.size() + last.size());
        if ((common >= least || name == last) && share > most) {
            most = share;
            best = each;
        }
    }
    return best;
}

}  // namespace

bool Flattening::isOfMissingLibrary(const syntax::Name& name, const LibraryClass* from) {
    const std::string root = rootOf(name, from, library);
    if (root != "Modelica" || library.find(root)) return false;
    const std::string own = nearestOwn(name.parts.back().identifier, library);
    messages.fatal(phrase("'{}' belongs to the Modelica Standard Library, which was not found", name.text()), name.span,
                   own.empty() ? phrase("name the directory that holds it in MODELICAPATH or with --library")
                               : phrase("name the directory that holds it in MODELICAPATH or with --library; the "
                                        "nearest of Analogon's own classes is {}",
                                        own));
    return true;
}

void Flattening::reportUnknownClass(const syntax::Name& name, const LibraryClass* from) {
    if (isOfMissingLibrary(name, from)) return;
    const std::string text = name.text();
    if (tellRefused(messages, text, name.span)) return;
    lacksClass = true;
    messages.error(from ? phrase("the class '{}' is not known in '{}'", text, from->qualifiedName)
                        : phrase("the class '{}' is not known", text),
                   name.span, didYouMean(text, library.names()));
}

void Flattening::keepSource(const syntax::ClassDefinition& definition) {
    if (definition.source && kept_.insert(definition.source.get()).second) model.sources.push_back(definition.source);
}

}  // namespace analogon
