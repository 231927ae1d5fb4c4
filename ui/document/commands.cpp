#include "ui/document/commands.hpp"

#include "ui/document/document.hpp"

namespace analogon::ui {

TextCommand::TextCommand(Document& document, syntax::TextEdit edit, bool isTyping)
    : QUndoCommand(QString::fromStdString(edit.what)),
      document_(document),
      edit_(std::move(edit)),
      isTyping_(isTyping) {}

void TextCommand::swap() {
    std::string& text = document_.study_->models[document_.study_->modelFile];
    syntax::AppliedEdit applied = syntax::apply(text, std::move(edit_));
    text = std::move(applied.text);
    edit_ = std::move(applied.inverse);
    document_.modelTextChanged();
}

/// Two inverses in a row as one: `later` takes its text back to where this one starts from. Only a run of typing or of
/// deleting at one place merges.
bool TextCommand::mergeWith(const QUndoCommand* other) {
    const auto& later = static_cast<const TextCommand&>(*other);
    if (edit_.replacements.size() != 1 || later.edit_.replacements.size() != 1) return false;
    syntax::Replacement& mine = edit_.replacements.front();
    const syntax::Replacement& next = later.edit_.replacements.front();
    const bool typesOn = next.text.empty() && next.begin == mine.end;
    if (!typesOn) return false;
    mine.end = next.end;
    return true;
}

StudySettings settingsOf(const Study& study) {
    return {study.className,   study.modelFile, study.models,   study.parameters,
            study.experiments, study.tables,    study.extraJson};
}

StudyCommand::StudyCommand(Document& document, StudySettings settings, const QString& what)
    : QUndoCommand(what), document_(document), other_(std::move(settings)) {}

void StudyCommand::swap() {
    Study& study = *document_.study_;
    const bool isOtherModel = study.models != other_.models || study.className != other_.className;
    const bool isOtherView = study.extraJson != other_.plots;
    const bool isOnlyView = isOtherView && !isOtherModel && document_.isSameStudy(other_);
    std::swap(study.extraJson, other_.plots);
    if (isOtherView) Q_EMIT document_.plotsChanged();
    if (isOnlyView) return;
    std::swap(study.className, other_.className);
    std::swap(study.modelFile, other_.modelFile);
    std::swap(study.models, other_.models);
    std::swap(study.parameters, other_.parameters);
    std::swap(study.experiments, other_.experiments);
    std::swap(study.tables, other_.tables);
    if (isOtherModel)
        document_.modelTextChanged();
    else
        document_.settingsChanged();
    Q_EMIT document_.parametersChanged();
    Q_EMIT document_.experimentsChanged();
}

}  // namespace analogon::ui
