#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/syntax/ast.hpp"
#include "core/syntax/text_edit.hpp"

/// Where new text goes in a Modelica file so that it looks as if its author had written it.
namespace analogon::edit_text {

/// "\r\n" in a file that uses it.
std::string lineEnd(std::string_view text);

/// The blanks a line starts with, for the line that holds the offset.
std::string indentation(std::string_view text, std::uint32_t offset);

/// Start of the line when nothing but blanks stands before the offset; else the offset itself.
std::uint32_t beforeIndentation(std::string_view text, std::uint32_t offset);

/// End of the line when nothing but blanks or a // comment follows the offset; else the offset itself. So a
/// comment that trails a declaration stays with it.
std::uint32_t behindTrailingComment(std::string_view text, std::uint32_t offset);

/// Removes [begin, end); takes the whole line along when nothing else stands on it.
syntax::Replacement removal(std::string_view text, std::uint32_t begin, std::uint32_t end);

/// Sets or (with empty value) removes modifications in a list `( … )`, which may be missing (an empty span).
/// Names may be dotted; of equal names the last counts. `classes` redeclares elements: name, new class.
std::vector<syntax::Replacement> setModifications(const std::vector<syntax::Modification>& list, const Span& listSpan,
                                                  const std::vector<std::pair<std::string, std::string>>& values,
                                                  const std::vector<std::pair<std::string, std::string>>& classes = {});

/// Sets member `inner` of the annotation record `outer` to a text, with all else in the annotation kept. Without an
/// annotation `fresh` goes into a new one at `without`.
syntax::Replacement setAnnotation(const std::optional<syntax::Annotation>& annotation, std::uint32_t without,
                                  std::string_view outer, std::string_view inner, const std::string& innerText,
                                  const std::string& fresh);

/// The same in the annotation of a class, which must have a body; where it has none, one is written before its end.
syntax::Replacement setClassAnnotation(const syntax::ClassDefinition& definition, std::string_view outer,
                                       std::string_view inner, const std::string& innerText);

/// The text under [begin, end) after replacements that lie inside.
std::string applied(std::string_view text, std::uint32_t begin, std::uint32_t end,
                    std::vector<syntax::Replacement> edits);

}  // namespace analogon::edit_text
