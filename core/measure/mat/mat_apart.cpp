#include "core/measure/mat/mat_apart.hpp"

#include <hdf5.h>

#include "core/base/apart.hpp"
#include "core/measure/mat/mat_hdf.hpp"
#include "core/measure/mat/mat_message.hpp"

namespace analogon::mat {

namespace {

Outcome<Channels> findChannels73(const std::string& file) {
    // what is wrong with a file is told here, not on the standard error of the program
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const Check check = checkLevel73(file);
    if (check.fault) return fileError(*check.fault, file, 0, 0, phrase("copy it again from where it was recorded"));
    return findChannels(file, check.opaque);
}

Diagnostic damaged(const std::string& file) {
    return fileError(phrase("the file is damaged: it cannot be read as MATLAB 7.3"), file, 0, 0,
                     phrase("copy it again from where it was recorded"));
}

Outcome<std::string> readApart(const std::function<std::string()>& work, const std::string& file,
                               const Progress& progress) {
    return runApart(work, {mostReadingTime(file), mostReadingMemory(file)}, damaged(file), progress);
}

}  // namespace

Outcome<Channels> findChannelsApart(const std::string& file) {
    const Outcome<std::string> bytes = readApart([&] { return encoded(findChannels73(file)); }, file, {});
    if (!bytes) return bytes.diagnostics();
    return decodedChannels(*bytes);
}

Outcome<std::vector<ChannelValues>> readPlacesApart(const std::string& file, const std::vector<VariablePlace>& places,
                                                    const Progress& progress) {
    const auto work = [&] {
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
        return encoded(readPlaces(file, places, progress));
    };
    const Outcome<std::string> bytes = readApart(work, file, progress);
    if (!bytes) return bytes.diagnostics();
    Outcome<std::vector<ChannelValues>> values = decodedValues(*bytes);
    for (std::size_t i = 0; values && i < places.size(); ++i)
        if (values->size() != places.size() || (*values)[i].numbers.size() != places[i].count) return damaged(file);
    return values;
}

}  // namespace analogon::mat
