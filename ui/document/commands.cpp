#include "ui/document/commands.hpp"

#include "ui/document/document.hpp"

namespace analogon::ui {

TextCommand::TextCommand(Document& document, syntax::TextEdit edit)
    : QUndoCommand(QString::fromStdString(edit.what)), document_(document), edit_(std::move(edit)) {}

void TextCommand::swap() {
    std::string& text = document_.study_->models[document_.study_->modelFile];
    syntax::AppliedEdit applied = syntax::apply(text, std::move(edit_));
    text = std::move(applied.text);
    edit_ = std::move(applied.inverse);
    document_.modelTextChanged();
}

StudyCommand::StudyCommand(Document& document, StudySettings settings, const QString& what)
    : QUndoCommand(what), document_(document), other_(std::move(settings)) {}

void StudyCommand::swap() {
    Study& study = *document_.study_;
    const bool isOtherText = study.models != other_.models;
    std::swap(study.models, other_.models);
    std::swap(study.parameters, other_.parameters);
    if (isOtherText)
        document_.modelTextChanged();
    else
        ++document_.revision_;
    Q_EMIT document_.parametersChanged();
}

}  // namespace analogon::ui
