#include "core/eval/system.hpp"

namespace analogon {

Outcome<SystemPtr> compile(const Library& library, std::string_view className, const StructureOptions& options) {
    Outcome<FlatModel> flat = flatten(library, className);
    if (!flat) return flat.diagnostics();
    Diagnostics warnings = flat.diagnostics();
    Outcome<Structure> structure = analyse(std::make_shared<const FlatModel>(std::move(*flat)), options);
    if (!structure) return structure.diagnostics();
    warnings.insert(warnings.end(), structure->warnings.begin(), structure->warnings.end());
    Outcome<SystemPtr> system = System::build(*structure);
    if (!system) return system.diagnostics();
    return {std::move(*system), std::move(warnings)};
}

}  // namespace analogon
