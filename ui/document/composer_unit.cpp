#include "ui/document/composer.hpp"
#include "ui/document/document.hpp"
#include "ui/words/common_units.hpp"

/// The units of the inputs and outputs of a model.
namespace analogon::ui {

bool hasUnit(const Block& block) {
    return block.isConnector && (block.domain == Domain::RealInput || block.domain == Domain::RealOutput);
}

std::string declaredUnit(const Block& block) {
    for (const auto& [name, text] : block.parameters)
        if (name == "unit" && text.size() >= 2 && text.front() == '"' && text.back() == '"')
            return text.substr(1, text.size() - 2);
    return {};
}

bool Composer::setUnit(const std::string& name, const std::string& unit) {
    if (!isReady()) return false;
    const Block* block = document_.diagram().find(name);
    if (!block || !hasUnit(*block) || declaredUnit(*block) == unit) return false;
    fault_ = whyNoUnit(unit);
    if (!fault_.isEmpty()) return false;
    ModelEdit edit(*document_.definition(), &document_.diagram(), &document_.library());
    edit.setModifier(name, "unit", unit.empty() ? std::string() : '"' + unit + '"');
    return apply(edit.finish(QObject::tr("Set the unit of %1").arg(QString::fromStdString(name)).toStdString()));
}

}  // namespace analogon::ui
