#include "core/diagram/experiment_edit.hpp"

#include "core/diagram/edit_text.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {

Outcome<syntax::TextEdit> stopTimeEdit(const syntax::ClassDefinition& definition, double stop, std::string what) {
    if (!definition.endSpan.valid())
        return error(phrase("'{}' has no place for a stop time", definition.name), definition.span,
                     phrase("Write it as 'model {} extends …; end {};'.", definition.name, definition.name));
    const std::string value = "StopTime=" + syntax::printNumber(stop);
    const std::string fresh = "experiment(" + value + ")";
    syntax::TextEdit edit;
    edit.what = std::move(what);
    if (definition.annotation) {
        edit.replacements.push_back(
            edit_text::setAnnotation(definition.annotation, 0, "experiment", "StopTime", value, fresh));
        return edit;
    }
    const std::string& text = definition.source->text();
    const std::string newline = edit_text::lineEnd(text);
    const std::string indent = edit_text::indentation(text, definition.span.begin);
    const std::uint32_t at = edit_text::beforeIndentation(text, definition.endSpan.begin);
    const bool startsLine = at == 0 || text[at - 1] == '\n';
    edit.replacements.push_back({at, at,
                                 (startsLine ? "" : newline) + indent + "  annotation (" + fresh + ");" + newline +
                                     (startsLine ? "" : indent)});
    return edit;
}

}  // namespace analogon
