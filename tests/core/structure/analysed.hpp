#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/structure/structure.hpp"

namespace analogon::test {

inline Structure analysed(std::shared_ptr<const FlatModel> model, std::vector<std::string> keep = {}) {
    Outcome<Structure> structure = analyse(std::move(model), {std::move(keep)});
    EXPECT_TRUE(structure) << format(structure.diagnostics());
    return structure ? std::move(*structure) : Structure{};
}

inline std::string refusal(std::shared_ptr<const FlatModel> model, std::vector<std::string> keep = {}) {
    const Outcome<Structure> structure = analyse(std::move(model), {std::move(keep)});
    EXPECT_FALSE(structure);
    return structure ? "" : format(structure.diagnostics());
}

/// What stands for a variable.
inline std::string standIn(const Structure& s, const std::string& name) {
    for (const auto& [variable, stand] : s.aliases)
        if ((*s.model)[variable].name == name)
            return s.pool->print(stand, [&](VariableId v) { return (*s.model)[v].name; });
    return "";
}

}  // namespace analogon::test
