#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// What a file says, as it may be shown to a person: a terminal obeys control characters, and some others change what
/// is read without being seen.
namespace analogon {

/// Control characters, those that cannot be seen or turn the direction of writing (Unicode: Cc, and of Cf the joiners,
/// marks, embeddings, isolates, tags and fillers), and bytes that are no UTF-8, as \u{…} or \x…. Line ends and tabs
/// stay.
std::string visible(std::string_view text);

/// The same with line ends and tabs escaped, too: a name on one line. What is longer than `longest` bytes is cut.
std::string visibleName(std::string_view text, std::size_t longest = 120);

/// At most so many bytes of a text, cut between characters; "…" stands for the rest.
std::string shortened(std::string_view text, std::size_t longest = 100);

}  // namespace analogon
