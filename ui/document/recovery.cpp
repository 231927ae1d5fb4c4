#include "ui/document/recovery.hpp"

#include <signal.h>
#include <unistd.h>

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <cerrno>

#include "core/archive/archive.hpp"
#include "ui/document/document.hpp"

namespace analogon::ui {

namespace {

QDir place() { return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery"); }

/// Beside the copy: where the study came from.
QString noteOf(const QString& file) { return file + ".origin"; }

}  // namespace

Recovery::Recovery(Document& document, QObject* parent) : QObject(parent), document_(document) {
    delay_.setSingleShot(true);
    delay_.setInterval(2000);
    connect(&delay_, &QTimer::timeout, this, &Recovery::write);
    for (auto signal : {&Document::modelChanged, &Document::parametersChanged, &Document::experimentsChanged})
        connect(&document, signal, this, &Recovery::changed);
    connect(&document, &Document::modifiedChanged, this, &Recovery::changed);
    connect(&document, &Document::opened, this, [this] {
        clear();
        inherited_ = document_.recoveredFrom();
    });
}

Recovery::~Recovery() = default;

QString Recovery::file() const { return place().filePath(QStringLiteral("%1.analogon").arg(getpid())); }

void Recovery::changed() {
    if (!document_.isModified()) return clear();
    if (!delay_.isActive()) delay_.start();  // who never pauses has a copy too
}

void Recovery::write() {
    if (!document_.isModified()) return;
    const QString target = file(), origin = document_.path();
    writer_.start<Outcome<Done>>(
        tr("Keeping a copy"),
        [study = document_.study(), history = document_.pastRuns(), target, origin](const Progress&) -> Outcome<Done> {
            QDir().mkpath(QFileInfo(target).path());
            QFile note(noteOf(target));
            if (note.open(QIODevice::WriteOnly)) note.write(origin.toUtf8());
            return saveStudy(study, target.toStdString(), history);
        },
        [this](const Outcome<Done>& written) {
            if (!document_.isModified()) return clear();
            if (written) dropInherited();
        });
}

void Recovery::clear() {
    delay_.stop();
    QFile::remove(file());
    QFile::remove(noteOf(file()));
    dropInherited();
}

void Recovery::dropInherited() {
    if (!inherited_.isEmpty()) discard({inherited_, {}, {}});
    inherited_.clear();
}

std::vector<Recovered> Recovery::abandoned() {
    std::vector<Recovered> result;
    for (const QFileInfo& entry : place().entryInfoList({"*.analogon"}, QDir::Files, QDir::Time)) {
        const auto owner = static_cast<pid_t>(entry.completeBaseName().toLongLong());
        const bool isAlive = owner <= 0 || kill(owner, 0) == 0 || errno != ESRCH;
        if (isAlive) continue;
        QFile note(noteOf(entry.filePath()));
        const QString origin = note.open(QIODevice::ReadOnly) ? QString::fromUtf8(note.readAll()) : QString();
        result.push_back({entry.filePath(), origin, entry.lastModified().toString("yyyy-MM-dd hh:mm")});
    }
    return result;
}

void Recovery::discard(const Recovered& recovered) {
    QFile::remove(recovered.file);
    QFile::remove(noteOf(recovered.file));
}

}  // namespace analogon::ui
