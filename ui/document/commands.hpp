#pragma once

#include <QUndoCommand>
#include <map>
#include <string>

#include "core/study/study.hpp"
#include "core/syntax/text_edit.hpp"

namespace analogon::ui {

class Document;

/// A change of the model's text. Undo is the inverse edit. Typing in one place merges into one step.
class TextCommand : public QUndoCommand {
public:
    TextCommand(Document& document, syntax::TextEdit edit, bool isTyping = false);
    void redo() override { swap(); }
    void undo() override { swap(); }
    int id() const override { return isTyping_ ? 1 : -1; }
    bool mergeWith(const QUndoCommand* later) override;

private:
    void swap();
    Document& document_;
    syntax::TextEdit edit_;  // the next one to apply
    bool isTyping_;
};

/// What a command may change of a study.
struct StudySettings {
    std::string className, modelFile;
    std::map<std::string, std::string> models;
    std::map<std::string, StudyParameter> parameters;
    std::vector<StudyExperiment> experiments;
    std::map<std::string, std::shared_ptr<const Table>> tables;
    std::string plots{};  // Study::extraJson: among it what the plots of signals hold (ui/signals)
};
StudySettings settingsOf(const Study& study);

/// Swaps settings of the study with other ones.
class StudyCommand : public QUndoCommand {
public:
    StudyCommand(Document& document, StudySettings settings, const QString& what);
    void redo() override { swap(); }
    void undo() override { swap(); }

private:
    void swap();
    Document& document_;
    StudySettings other_;
};

}  // namespace analogon::ui
