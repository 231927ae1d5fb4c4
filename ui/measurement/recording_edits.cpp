#include "ui/measurement/recording_edits.hpp"

#include <QCoreApplication>

#include "ui/document/document.hpp"

namespace analogon::ui {

void changeRecordings(Document& document, const std::set<std::string>& recordings, const QString& what,
                      const std::function<void(StudyExperiment&)>& edit) {
    StudySettings settings = document.settings();
    for (StudyExperiment& e : settings.experiments)
        if (recordings.contains(e.name)) edit(e);
    const QString name = recordings.size() == 1
                             ? QString::fromStdString(*recordings.begin())
                             : QCoreApplication::translate("RecordingsModel", "%1 recordings").arg(recordings.size());
    document.applySettings(std::move(settings), what.arg(name));
}

void useRecordings(Document& document, const std::set<std::string>& recordings, bool isUsed) {
    std::set<std::string> others;
    for (const StudyExperiment& e : document.study().experiments)
        if (recordings.contains(e.name) && e.isUsed != isUsed) others.insert(e.name);
    if (others.empty()) return;
    changeRecordings(document, others,
                     isUsed ? QCoreApplication::translate("RecordingsModel", "Take %1 in")
                            : QCoreApplication::translate("RecordingsModel", "Leave %1 out"),
                     [&](StudyExperiment& e) { e.isUsed = isUsed; });
}

}  // namespace analogon::ui
