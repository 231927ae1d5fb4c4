#pragma once

#include <chrono>
#include <mutex>
#include <ostream>
#include <string>

#include "app/analogon-cli/command_line.hpp"
#include "core/base/progress.hpp"

namespace analogon::cli {

/// Shows progress on a stream: a bar that is drawn over and over on a terminal, one JSON object a line, or nothing.
/// Safe to call from any thread of the work.
class ProgressView {
public:
    /// `isTerminal` decides what Automatic means: a bar, or nothing.
    ProgressView(ProgressKind kind, std::ostream& stream, bool isTerminal);
    ~ProgressView();

    Progress::Sink sink();
    /// Wipes the bar, so that other text can follow.
    void clear();
    /// What people should know of the result: a line, or a JSON object like the rest.
    void note(const Text& remark);

private:
    void show(const Progress::Report& report);
    void showBar(const Progress::Report& report);

    std::mutex mutex_;
    ProgressKind kind_;
    std::ostream& stream_;
    std::chrono::steady_clock::time_point lastShown_{};
    std::string lastStage_;
    bool hasBar_{}, isSearching_{};
};

/// One report as a JSON object, without the line end.
std::string progressJson(const Progress::Report& report);

/// A remark as a JSON object, without the line end: with its pattern and arguments where it has them, so that a window
/// can say it in its own language.
std::string noteJson(const Text& remark);

}  // namespace analogon::cli
