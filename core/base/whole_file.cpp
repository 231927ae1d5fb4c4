#include "core/base/whole_file.hpp"

#include <fstream>

#include "core/base/file_fault.hpp"
#include "core/base/file_step.hpp"
#include "core/base/owned_directory.hpp"

namespace analogon {

namespace fs = std::filesystem;

Outcome<Done> writeWhole(const fs::path& file, const std::function<Outcome<Done>(const fs::path&)>& write) {
    std::error_code code;
    fs::path target = fs::absolute(file, code);
    if (fs::is_symlink(fs::symlink_status(target, code))) {
        target = fs::canonical(target, code);
        if (code) return cannotWrite(file, code);
    }
    const fs::file_status status = fs::status(target, code);
    if (fs::is_directory(status)) return cannotWrite(file, phrase("a directory has this name"));
    if (fs::exists(status) && !fs::is_regular_file(status))
        return cannotWrite(file, phrase("this is a pipe or a device, not a file"));
    const Outcome<OwnedDirectory> own = OwnedDirectory::make(target.parent_path(), writingPrefix);
    if (!own) return cannotWrite(file, own.diagnostics().front().message);
    const fs::path beside = own->path() / "new";
    if (Outcome<Done> written = write(beside); !written) return written;
    syncToDisk(beside);
    if (fs::exists(status)) fs::permissions(beside, status.permissions(), code);
    code.clear();
    fs::rename(beside, target, code);
    if (code) return cannotWrite(file, code);
    syncToDisk(target.parent_path());
    return Done{};
}

Outcome<Done> writeWhole(const fs::path& file, const std::string& content) {
    return writeWhole(file, [&](const fs::path& beside) -> Outcome<Done> {
        std::ofstream stream(beside, std::ios::binary);
        stream << content;
        stream.close();
        return stream ? Outcome<Done>(Done{}) : Outcome<Done>(cannotWrite(file, phrase("the disk may be full")));
    });
}

}  // namespace analogon
