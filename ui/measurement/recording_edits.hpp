#pragma once

#include <QString>
#include <functional>
#include <set>
#include <string>

#include "core/study/study.hpp"

/// Edits of several recordings at once, each one step of undo.
namespace analogon::ui {

class Document;

/// `what`: of the step, with %1 for the recording or for how many there are.
void changeRecordings(Document& document, const std::set<std::string>& recordings, const QString& what,
                      const std::function<void(StudyExperiment&)>& edit);

/// Takes recordings in, or leaves them out of all work.
void useRecordings(Document& document, const std::set<std::string>& recordings, bool isUsed);

}  // namespace analogon::ui
