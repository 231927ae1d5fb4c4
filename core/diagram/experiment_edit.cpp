#include "core/diagram/experiment_edit.hpp"

#include "core/diagram/edit_text.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {

Outcome<syntax::TextEdit> stopTimeEdit(const syntax::ClassDefinition& definition, double stop, std::string what) {
    if (!definition.endSpan.valid())
        return error(phrase("'{}' has no place for a stop time", definition.name), definition.span,
                     phrase("Write it as 'model {} extends …; end {};'.", definition.name, definition.name));
    syntax::TextEdit edit;
    edit.what = std::move(what);
    edit.replacements.push_back(
        edit_text::setClassAnnotation(definition, "experiment", "StopTime", "StopTime=" + syntax::printNumber(stop)));
    return edit;
}

}  // namespace analogon
