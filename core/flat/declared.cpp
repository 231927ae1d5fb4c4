#include "core/flat/declared.hpp"

#include "core/base/guard.hpp"
#include "core/flat/binder.hpp"
#include "core/flat/flattening.hpp"
#include "core/flat/instantiator.hpp"

namespace analogon {

FlatModel declared(const Library& library, std::string_view className) {
    const LibraryClass* definition = library.find(className);
    if (!definition) return {};
    Outcome<FlatModel> told = guardedOutcome([&]() -> Outcome<FlatModel> {
        Flattening work(library);
        const Messages::Quiet unsaid(work.messages);  // flatten() says what is wrong
        work.model.name = definition->qualifiedName;
        if (work.instantiator->instantiate(*definition)) work.binder->bindAll();
        return std::move(work.model);
    });
    return told ? std::move(*told) : FlatModel{};
}

}  // namespace analogon
