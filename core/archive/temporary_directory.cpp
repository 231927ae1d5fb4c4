#include "core/archive/temporary_directory.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

Diagnostic noneCanBeMade(const fs::path& place, const Text& why) {
    return fileError(phrase("no temporary directory can be made: {}", why), place.string(), 0, 0,
                     phrase("Check that it may be written and has room, or set TMPDIR."));
}

}  // namespace

Outcome<std::shared_ptr<const TemporaryDirectory>> TemporaryDirectory::make() {
    std::error_code code;
    const fs::path place = fs::temp_directory_path(code);
    if (code)
        return fileError(phrase("there is no place for temporary files: {}", code.message()), "", 0, 0,
                         phrase("Set TMPDIR to a directory that may be written."));
    Outcome<OwnedDirectory> around = OwnedDirectory::make(place, "analogon-study-");
    if (!around) return noneCanBeMade(place, around.diagnostics().front().message);
    const fs::path path = around->path() / "files";
    if (!fs::create_directory(path, code)) return noneCanBeMade(place, code.message());
    return std::shared_ptr<const TemporaryDirectory>(new TemporaryDirectory(std::move(*around), path));
}

}  // namespace analogon
