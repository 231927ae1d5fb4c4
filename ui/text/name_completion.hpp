#pragma once

#include <QString>
#include <string>
#include <vector>

namespace analogon {
class Library;
}

namespace analogon::ui {

/// One name that may be meant.
struct NameOffer {
    QString name;    // what is put in the place of what was typed
    QString detail;  // its type or what it is
};

/// What may stand at a place of the model's text.
struct NameOffers {
    int typed{};  // characters before the place that the name takes the place of
    std::vector<NameOffer> offers;
};

/// By what stands before the place: behind "name." the public parts of a component or the classes of a package, within
/// "name(" the parameters of the component's class, else components of the model, its own names and classes by the
/// begin of their short name ("Iner" → Analogon.Mechanics.Inertia). Nothing within a comment or a text.
/// `model`: the class whose text it is, as the library has it. `before`: the text up to the place, which need not
/// parse.
NameOffers nameOffers(const Library& library, const std::string& model, const QString& before);

}  // namespace analogon::ui
