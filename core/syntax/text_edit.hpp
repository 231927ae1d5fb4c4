#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace analogon::syntax {

/// Replaces the bytes [begin, end) of a text by another text.
struct Replacement {
    std::uint32_t begin{};
    std::uint32_t end{};
    std::string text;
};

/// One undoable change of a text: replacements that do not overlap, sorted by begin, in the offsets of the
/// text before the change. `what` is for the undo list ("Add dry friction at rotor.flange_a").
struct TextEdit {
    std::string what;
    std::vector<Replacement> replacements;

    /// Sorts the replacements; asserts that they do not overlap. Insertions at one offset keep their order.
    void normalise();
};

/// The changed text and the edit that takes it back: apply(result.text, result.inverse) is the old text.
struct AppliedEdit {
    std::string text;
    TextEdit inverse;
};

AppliedEdit apply(const std::string& text, TextEdit edit);

}  // namespace analogon::syntax
