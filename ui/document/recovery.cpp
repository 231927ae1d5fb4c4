#include "ui/document/recovery.hpp"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/archive/archive.hpp"
#include "core/base/owned_directory.hpp"
#include "core/base/whole_file.hpp"
#include "ui/document/document.hpp"

namespace analogon::ui {

namespace {

namespace fs = std::filesystem;

constexpr const char* prefix = "work-";

QDir place() { return QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/recovery"); }

/// In a directory of its own: the copy of a study, and beside it where this came from.
QString copyIn(const fs::path& directory) { return QFile::decodeName((directory / "copy.analogon").c_str()); }
QString noteOf(const QString& file) { return file + ".origin"; }

}  // namespace

/// The directory that this program keeps its copy in. Where there is a copy at its end, it stays for the next one.
struct Recovery::Store {
    explicit Store(OwnedDirectory directory) : own(std::move(directory)) {}
    ~Store() {
        if (QFile::exists(copyIn(own.path()))) own.release();
    }
    OwnedDirectory own;
};

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

QString Recovery::file() const { return store_ ? copyIn(store_->own.path()) : QString(); }

void Recovery::changed() {
    if (!document_.isModified()) return clear();
    if (!delay_.isActive()) delay_.start();  // who never pauses has a copy too
}

void Recovery::write() {
    if (!document_.isModified()) return;
    if (!store_) {
        place().mkpath(".");
        auto own =
            OwnedDirectory::make(QFile::encodeName(place().path()).toStdString(), prefix, OwnedDirectory::Left::Kept);
        if (!own) return tell(own.diagnostics());
        store_ = std::make_shared<Store>(std::move(*own));
    }
    const QString target = file(), origin = document_.path();
    writer_.start<Outcome<Done>>(
        tr("Keeping a copy"),
        [study = document_.study(), history = document_.pastRuns(), store = store_, target,
         origin](const Progress&) -> Outcome<Done> {
            const Outcome<Done> noted =
                writeWhole(QFile::encodeName(noteOf(target)).toStdString(), origin.toStdString());
            if (!noted) return noted;
            return saveStudy(study, target.toStdString(), history);
        },
        [this](const Outcome<Done>& written) {
            if (!document_.isModified()) return clear();
            if (!written) return tell(written.diagnostics());
            isTold_ = false;
            dropInherited();
        });
}

void Recovery::tell(const Diagnostics& faults) {
    if (!std::exchange(isTold_, true) && !faults.empty()) Q_EMIT notKept(faults.front());
}

void Recovery::clear() {
    delay_.stop();
    if (store_) QFile::remove(file());
    if (store_) QFile::remove(noteOf(file()));
    dropInherited();
}

void Recovery::dropInherited() {
    if (!inherited_.isEmpty()) discard({inherited_, {}, {}});
    inherited_.clear();
}

std::vector<Recovered> Recovery::abandoned() {
    std::vector<Recovered> result;
    for (const QFileInfo& entry : place().entryInfoList({prefix + QString("*")}, QDir::Dirs, QDir::Time)) {
        const fs::path directory = QFile::encodeName(entry.filePath()).toStdString();
        std::optional<OwnedDirectory> own = OwnedDirectory::adopt(directory);
        const QFileInfo copy(copyIn(directory));
        if (!own || !copy.isFile()) continue;  // one that holds nothing goes here
        own->release();
        QFile note(noteOf(copy.filePath()));
        const QString origin = note.open(QIODevice::ReadOnly) ? QString::fromUtf8(note.readAll()) : QString();
        result.push_back({copy.filePath(), origin, copy.lastModified().toString("yyyy-MM-dd hh:mm")});
    }
    return result;
}

void Recovery::discard(const Recovered& recovered) {
    (void)OwnedDirectory::adopt(fs::path(QFile::encodeName(recovered.file).toStdString()).parent_path());
}

}  // namespace analogon::ui
