#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/base/progress.hpp"

/// What a measurement file holds, whatever its format: found out without reading the values.
namespace analogon {

/// What the samples of a group are counted by.
enum class MasterKind { Time, Angle, Distance, Index, None };

/// Status: a number with a name for some or all of its values.
enum class ChannelKind { Number, Status, Text };

/// The name of a status between two values (both included; equal for one value).
struct StatusText {
    double lower{};
    double upper{};
    std::string text;
};

struct RecordedChannel {
    std::string name;
    std::string unit;     // as the file has it; empty: none given
    std::string comment;  // empty: none given
    std::string source;   // which device or bus it came from; empty: none given
    ChannelKind kind{ChannelKind::Number};
    std::size_t samples{};
    bool isInteger{};  // counts or states: nothing lies between two of its values
    std::vector<StatusText> statusTexts{};
    std::string otherStatus{};  // the name of every other value; empty: none
};

/// Channels that were sampled together.
struct RecordedGroup {
    std::string name;  // empty: the file gives none
    MasterKind master{MasterKind::None};
    std::optional<std::size_t> masterChannel{};  // index into channels
    std::size_t samples{};
    std::vector<RecordedChannel> channels{};
};

/// The values of one channel after conversion, in the file's unit.
struct ChannelValues {
    std::vector<double> numbers{};                    // NaN: a gap; of a status its numbers; empty for a text channel
    std::vector<std::optional<std::string>> texts{};  // of a text channel alone; empty optional: a gap
};

/// Reads values of a file that was opened. Const and free of state: several threads may read.
class RecordingReader {
public:
    virtual ~RecordingReader() = default;
    /// The channels of one group in one pass over the file, in the order in which they are asked for. What is doubtful
    /// about the values comes along as warnings.
    virtual Outcome<std::vector<ChannelValues>> read(std::size_t group, std::span<const std::size_t> channels,
                                                     const Progress& progress) const = 0;
};

struct MeasurementFile {
    std::string file;    // its name, for messages
    std::string format;  // "ASAM MDF 4.10"
    std::string start;   // ISO 8601; empty: the file does not tell
    std::vector<Text> notes;
    std::vector<RecordedGroup> groups;
    std::shared_ptr<const RecordingReader> reader;
};

/// The name of a status; empty where it has none.
std::string statusTextOf(const RecordedChannel& channel, double value);

/// One channel alone.
Outcome<ChannelValues> readValues(const MeasurementFile& recording, std::size_t group, std::size_t channel,
                                  const Progress& progress = {});

/// What can be said of a channel in few numbers. Gaps (NaN and infinite values) take no part in min, max and mean.
struct ValueSummary {
    std::size_t gaps{};
    std::optional<double> first{}, last{};               // none: a gap, or no samples
    std::optional<double> min{}, max{}, mean{};          // none: nothing but gaps
    std::optional<std::string> firstText{}, lastText{};  // of a text channel
};

ValueSummary summaryOf(const ChannelValues& values);

/// A group as it is called in a note: its name, or its number (from 1).
std::string groupLabel(const RecordedGroup& group, std::size_t index);

/// What is odd about the values of a group's master: jumps back, repeated stamps, gaps.
std::vector<Text> masterNotes(const std::string& group, std::span<const double> values);

}  // namespace analogon
