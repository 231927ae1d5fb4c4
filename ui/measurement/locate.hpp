#pragma once

#include <QString>

namespace analogon {
struct Study;
struct StudyExperiment;
}  // namespace analogon

namespace analogon::ui {

class Document;
class JobRunner;

/// Whether the file of a recording was not found or could not be read when the study was opened.
bool isUnread(const Study& study, const StudyExperiment& experiment);
bool isUnread(const Document& document, const QString& experiment);

/// Takes another file in the place of that of a recording, for all recordings that had it, as one step of undo. It is
/// read beside the window; a file that cannot be read changes nothing and says why.
void locateRecording(Document& document, JobRunner& reader, const QString& experiment, const QString& path);

}  // namespace analogon::ui
