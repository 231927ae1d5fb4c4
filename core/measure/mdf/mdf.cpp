#include "core/measure/mdf/mdf.hpp"

#include "core/measure/mdf/mdf3.hpp"
#include "core/measure/mdf/mdf4.hpp"

namespace analogon {

namespace {

constexpr std::uint64_t identificationBytes = 64;

}  // namespace

bool isMdf(ByteView bytes) {
    const std::string_view head = bytes.part(0, 8).text();
    return head == "MDF     " || head == "UnFinMF ";
}

Outcome<MeasurementFile> openMdf(std::shared_ptr<const MappedFile> file, const std::string& name) {
    const ByteView bytes = file->bytes();
    if (bytes.size() <= identificationBytes)
        return fileError(phrase("the file ends behind its identification: no measurement is in it"), name, 0, 0,
                         phrase("copy it again from where it was recorded"));
    // the version as text, since format 2 leaves the number at other places
    const std::string_view version = bytes.part(8, 8).text();
    if (version.empty() || version[0] < '2' || version[0] > '4')
        return fileError(phrase("MDF version \"{}\" is not known", std::string(version.substr(0, version.find('\0')))),
                         name, 0, 0, phrase("versions 2 to 4.2 can be read"));
    return version[0] == '4' ? mdf::openMdf4(std::move(file), name) : mdf::openMdf3(std::move(file), name);
}

}  // namespace analogon
