#include "core/flat/flattening.hpp"

#include "core/flat/binder.hpp"
#include "core/flat/connections.hpp"
#include "core/flat/events.hpp"
#include "core/flat/instantiator.hpp"
#include "core/flat/translator.hpp"

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
    if (name.absolute) return library.lookup(name, "");
    return lookup(name.text(), from);
}

void Flattening::keepSource(const syntax::ClassDefinition& definition) {
    if (definition.source && kept_.insert(definition.source.get()).second) model.sources.push_back(definition.source);
}

}  // namespace analogon
