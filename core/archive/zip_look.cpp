#include "core/archive/zip_look.hpp"

#include <fcntl.h>
#include <quazip/quazip.h>
#include <quazip/quazipfile.h>

#include "core/archive/zip_directory.hpp"

namespace analogon {

namespace fs = std::filesystem;

bool openForReading(QFile& file, const fs::path& path) {
    const int handle = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    return handle >= 0 && file.open(handle, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle);
}

namespace {

/// Opens a zip file whose list of entries is sound.
bool openSound(QuaZip& zip, QFile& bytes, const fs::path& file) {
    return readZipDirectory(file) && openForReading(bytes, file) && zip.open(QuaZip::mdUnzip);
}

}  // namespace

std::string zipComment(const fs::path& file) {
    QFile bytes;
    QuaZip zip(&bytes);
    if (!openSound(zip, bytes, file)) return {};
    return zip.getComment().toStdString();
}

std::string beginningOfEntry(const fs::path& file, const std::string& entry, std::size_t bytes) {
    QFile whole;
    QuaZip zip(&whole);
    if (!openSound(zip, whole, file)) return {};
    if (!zip.setCurrentFile(QString::fromStdString(entry), QuaZip::csSensitive)) return {};
    QuaZipFile from(&zip);
    if (!from.open(QIODevice::ReadOnly)) return {};
    return from.read(static_cast<qint64>(bytes)).toStdString();
}

}  // namespace analogon
