#include "ui/measurement/locate.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <algorithm>

#include "core/measure/open/read_table.hpp"
#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"

namespace analogon::ui {

namespace {

const StudyExperiment* recordingOf(const Document& document, const QString& name) {
    if (!document.isOpen()) return nullptr;
    const std::vector<StudyExperiment>& all = document.study().experiments;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& e) { return QString::fromStdString(e.name) == name; });
    return found == all.end() ? nullptr : &*found;
}

void replaceFile(Document& document, const std::string& from, const std::string& to,
                 const std::map<std::string, std::shared_ptr<const Table>>& read) {
    StudySettings settings = document.settings();
    for (StudyExperiment& e : settings.experiments) {
        if (e.file != from) continue;
        e.file = to;
        if (const auto table = read.find(readText(e.read)); table != read.end())
            settings.tables[tableKey(e)] = table->second;
        findTime(settings.tables, e);
    }
    document.applySettings(std::move(settings), QCoreApplication::translate("MeasurementPanel", "Locate %1")
                                                    .arg(QFileInfo(QString::fromStdString(to)).fileName()));
}

}  // namespace

bool isUnread(const Study& study, const StudyExperiment& experiment) {
    return !fileTable(study.tables, experiment) && study.unread.contains(tableKey(experiment));
}

bool isUnread(const Document& document, const QString& experiment) {
    const StudyExperiment* const recording = recordingOf(document, experiment);
    return recording && isUnread(document.study(), *recording);
}

void locateRecording(Document& document, JobRunner& reader, const QString& experiment, const QString& path) {
    const StudyExperiment* const asked = recordingOf(document, experiment);
    if (!asked) return;
    using Read = std::map<std::string, std::shared_ptr<const Table>>;  // by how it is read
    reader.start<Outcome<Read>>(
        QCoreApplication::translate("MeasurementPanel", "Reading %1").arg(QFileInfo(path).fileName()),
        [study = document.study(), from = asked->file, path](const Progress& progress) -> Outcome<Read> {
            Read tables;
            Diagnostics said;
            for (const StudyExperiment& e : study.experiments) {
                if (e.file != from || tables.contains(readText(e.read))) continue;
                Outcome<Table> table = readTable(path.toStdString(), e.read, namedChannels(study, e), progress);
                if (!table) return table.diagnostics();
                said.insert(said.end(), table.diagnostics().begin(), table.diagnostics().end());
                tables[readText(e.read)] = std::make_shared<const Table>(std::move(*table));
            }
            return {std::move(tables), std::move(said)};
        },
        [&document, from = asked->file, path](const Outcome<Read>& read) {
            document.setRunMessages(read.diagnostics());
            if (read) replaceFile(document, from, path.toStdString(), *read);
        });
}

}  // namespace analogon::ui
