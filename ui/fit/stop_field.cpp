#include "ui/fit/stop_field.hpp"

#include <cmath>

#include "core/diagram/experiment_edit.hpp"
#include "core/study/free_run.hpp"
#include "ui/document/document.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

StopField::StopField(Document& document, QWidget* parent) : QLineEdit(parent), document_(document) {
    setObjectName("stop-time");
    setAccessibleName(tr("Simulate until"));
    setToolTip(tr("When a simulation of the model by itself (F4) ends, in seconds; it is kept in the model's text"));
    for (auto signal : {&Document::opened, &Document::modelChanged})
        connect(&document, signal, this, &StopField::refresh);
    connect(this, &QLineEdit::editingFinished, this, &StopField::apply);
    connect(this, &QLineEdit::textEdited, this, [this] {
        QPalette palette = parentWidget()->palette();
        if (!typed()) palette.setColor(QPalette::Text, style::fault(palette));
        setPalette(palette);
    });
    refresh();
}

/// "20" or "20 s".
std::optional<double> StopField::typed() const {
    QString number = text().trimmed();
    if (number.endsWith('s')) number.chop(1);
    const std::optional<double> seconds = style::readNumber(number);
    return seconds && std::isfinite(*seconds) && *seconds > 0 ? seconds : std::nullopt;
}

void StopField::refresh() {
    setEnabled(document_.isOpen() && document_.definition());
    if (!document_.isOpen()) return clear();
    setPalette(parentWidget()->palette());
    setText(style::numberText(freeRunStop(document_.library(), document_.study().className), 9) + QStringLiteral(" s"));
}

void StopField::apply() {
    const std::optional<double> seconds = typed();
    const LibraryClass* const model =
        document_.isOpen() ? document_.library().find(document_.study().className) : nullptr;
    if (!model || !seconds || *seconds == freeRunStop(document_.library(), model->qualifiedName)) return refresh();
    Outcome<syntax::TextEdit> edit = stopTimeEdit(*model->definition, *seconds, tr("Set the stop time").toStdString());
    if (edit) return document_.applyEdit(std::move(*edit));
    document_.setRunMessages(edit.diagnostics());
    refresh();
}

}  // namespace analogon::ui
