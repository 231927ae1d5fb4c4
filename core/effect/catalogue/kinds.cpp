#include "core/effect/catalogue/kinds.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

namespace analogon {

Diagnostics unknownKinds(const std::vector<std::string>& names, const std::vector<EffectClass>& catalogue) {
    std::set<std::string> known, named;  // and those that are offered as an equation alone
    for (const EffectClass& effect : catalogue) {
        known.insert(effect.kind);
        if (effect.proposal.empty()) named.insert(effect.kind);
    }
    const std::vector<std::string> list(known.begin(), known.end());
    Diagnostics faults;
    for (const std::string& name : names) {
        if (known.contains(name)) continue;
        const std::string like = suggestion(name, list);
        faults.push_back(error(
            phrase("there is no kind of effect '{}'", name), {},
            like.empty() ? phrase("Known are: {}.", fmt::join(named, ", ")) : phrase("Did you mean '{}'?", like)));
    }
    return faults;
}

}  // namespace analogon
