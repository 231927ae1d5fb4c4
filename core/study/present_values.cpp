#include "core/study/present_values.hpp"

#include "core/diagram/edit.hpp"
#include "core/flat/flat_model.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {

Outcome<Study> withPresentValues(const Study& study) {
    Study result = study;
    for (const auto& [name, parameter] : study.parameters) {
        if (!parameter.value) continue;
        const Outcome<Library> library = studyLibrary(result);
        if (!library) return library.diagnostics();
        const LibraryClass* cls = library->find(result.className);
        if (!cls) continue;
        ModelEdit edit(*cls->definition, nullptr, &*library);
        if (name.find('[') != std::string::npos) {
            Outcome<FlatModel> flat = flatten(*library, result.className);
            if (!flat) return flat.diagnostics();
            edit.valuesOf([model = std::move(*flat)](const std::string& element) {
                const VariableId id = model.find(element);
                const std::optional<double> value = id.valid() ? model.parameterValue(id) : std::nullopt;
                return value ? std::optional(syntax::printNumber(*value)) : std::nullopt;
            });
        }
        edit.setParameter(name, syntax::printNumber(*parameter.value));
        const Outcome<syntax::TextEdit> change = edit.finish("value");
        if (!change) return change.diagnostics();
        std::string& text = result.models[result.modelFile];
        text = syntax::apply(text, *change).text;
        result.parameters[name].value.reset();
    }
    return result;
}

}  // namespace analogon
