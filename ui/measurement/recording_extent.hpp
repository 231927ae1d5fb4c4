#pragma once

#include <QString>
#include <cstddef>
#include <optional>

namespace analogon {
struct StudyExperiment;
struct Table;
}  // namespace analogon

namespace analogon::ui {

/// How long the part of a recording is that its experiment uses, on the raster of that experiment.
struct RecordingExtent {
    std::size_t samples{};
    std::optional<double> seconds{};  // none: its time is not known
};
RecordingExtent extentOf(const Table& table, const StudyExperiment& experiment);

/// As people say it: "1 201 samples · 12 s".
QString extentText(const RecordingExtent& extent);

}  // namespace analogon::ui
