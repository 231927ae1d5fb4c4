#include "core/measure/mat/mat.hpp"

#include "core/measure/mat/mat_apart.hpp"
#include "core/measure/mat/mat_channels.hpp"
#include "core/measure/mat/mat_check.hpp"
#include "core/measure/mat/mat_values.hpp"

namespace analogon {

namespace {

using namespace mat;

using ReadPlaces = Outcome<std::vector<ChannelValues>> (*)(const std::string& file,
                                                           const std::vector<VariablePlace>& places,
                                                           const Progress& progress);

class MatReader final : public RecordingReader {
public:
    MatReader(std::string file, std::vector<std::vector<VariablePlace>> places, ReadPlaces readPlaces)
        : file_(std::move(file)), places_(std::move(places)), read_(readPlaces) {}

    Outcome<std::vector<ChannelValues>> read(std::size_t group, std::span<const std::size_t> channels,
                                             const Progress& progress) const override {
        std::vector<VariablePlace> wanted;
        for (const std::size_t channel : channels) wanted.push_back(places_[group][channel]);
        return read_(file_, wanted, progress);
    }

private:
    std::string file_;
    std::vector<std::vector<VariablePlace>> places_;  // by group and channel
    ReadPlaces read_;
};

Outcome<MeasurementFile> recordingOf(Outcome<Channels> found, const std::string& file, std::string format,
                                     ReadPlaces read) {
    if (!found) return found.diagnostics();
    MeasurementFile recording;
    recording.file = file;
    recording.format = std::move(format);
    recording.notes = std::move(found->notes);
    recording.groups = std::move(found->groups);
    recording.reader = std::make_shared<MatReader>(file, std::move(found->places), read);
    return recording;
}

bool isLevel5(ByteView bytes) {
    const std::string_view mark = bytes.part(126, 2).text();
    return bytes.size() >= 128 && (mark == "IM" || mark == "MI");
}

bool isHdf5(ByteView bytes) {
    constexpr std::string_view signature = "\x89HDF\r\n\x1a\n";
    return bytes.part(0, 8).text() == signature || bytes.part(512, 8).text() == signature;
}

}  // namespace

bool isMat(ByteView bytes) {
    return isHdf5(bytes) || isLevel5(bytes) || bytes.part(0, 19).text() == "MATLAB 5.0 MAT-file" ||
           looksLikeLevel4(bytes);
}

Outcome<MeasurementFile> openMat(ByteView bytes, const std::string& file) {
    if (isHdf5(bytes)) return recordingOf(findChannelsApart(file), file, "MATLAB 7.3", &readPlacesApart);
    const bool isNew = isLevel5(bytes);
    const Check check =
        isNew || bytes.part(0, 19).text() == "MATLAB 5.0 MAT-file" ? checkLevel5(bytes) : checkLevel4(bytes);
    if (check.fault) return fileError(*check.fault, file, 0, 0, phrase("copy it again from where it was recorded"));
    return recordingOf(findChannels(file, check.opaque), file, isNew ? "MATLAB 5" : "MATLAB 4", &readPlaces);
}

}  // namespace analogon
