#include <fmt/format.h>

#include "core/base/guard.hpp"
#include "core/flat/balance.hpp"
#include "core/flat/binder.hpp"
#include "core/flat/connections.hpp"
#include "core/flat/equations.hpp"
#include "core/flat/flattening.hpp"
#include "core/flat/free_ordinates.hpp"
#include "core/flat/instantiator.hpp"
#include "core/flat/measured_variables.hpp"
#include "core/flat/unit_check.hpp"

namespace analogon {
namespace {

void listComponents(Flattening& work) {
    for (const Instance* component : work.components) {
        if (!component->parent) continue;
        work.model.components.push_back(
            {component->name, component->className, component->unknowns, component->equations, component->declared});
    }
}

/// The steps in order. A component that could not be made does not hide the faults of the others: what names it is
/// passed over. What counts the whole model needs it without faults.
void run(Flattening& work, const LibraryClass& definition) {
    if (!work.instantiator->instantiate(definition) || work.messages.full()) return;
    work.binder->bindAll();
    Balance balance(work);
    balance.checkConnectors();
    Equations(work).translateAll();
    if (work.messages.hasErrors()) return;
    work.binder->checkParameters();
    work.connections->addEquations();
    work.connections->listSets();
    if (work.messages.hasErrors()) return;
    balance.check();
    listComponents(work);
    takeMeasured(work);
    if (!work.messages.hasErrors()) UnitCheck(work).check();
}

}  // namespace

namespace {

Outcome<FlatModel> flattened(const Library& library, std::string_view className, const std::vector<std::string>& free) {
    const LibraryClass* definition = library.find(className);
    if (const Diagnostics faults = library.lazyFaults(); !definition && hasError(faults)) return faults;
    if (!definition)
        return error(phrase("the class '{}' is not known", className), {}, didYouMean(className, library.names()));
    Flattening work(library);
    work.free.insert(free.begin(), free.end());
    work.model.name = definition->qualifiedName;
    run(work, *definition);
    if (work.messages.hasErrors()) {
        Diagnostics all = work.messages.diagnostics();
        if (!work.lacksClass) return all;
        // that it is not known may be for a file that cannot be read
        const Diagnostics faults = library.lazyFaults();
        all.insert(all.end(), faults.begin(), faults.end());
        return all;
    }
    return Outcome<FlatModel>(std::move(work.model), work.messages.diagnostics());
}

}  // namespace

Outcome<FlatModel> flatten(const Library& library, std::string_view className) {
    return flatten(library, className, {});
}

Outcome<FlatModel> flatten(const Library& library, std::string_view className, const std::vector<std::string>& free) {
    return guardedOutcome([&] { return flattened(library, className, free); });
}

}  // namespace analogon
