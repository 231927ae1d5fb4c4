#pragma once

#include <QUndoCommand>
#include <map>
#include <string>

#include "core/study/study.hpp"
#include "core/syntax/text_edit.hpp"

namespace analogon::ui {

class Document;

/// A change of the model's text. Undo is the inverse edit.
class TextCommand : public QUndoCommand {
public:
    TextCommand(Document& document, syntax::TextEdit edit);
    void redo() override { swap(); }
    void undo() override { swap(); }

private:
    void swap();
    Document& document_;
    syntax::TextEdit edit_;  // the next one to apply
};

/// What a command may change of a study besides the model's text.
struct StudySettings {
    std::map<std::string, std::string> models;
    std::map<std::string, StudyParameter> parameters;
};

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
