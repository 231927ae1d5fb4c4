#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/directory_lock.hpp"
#include "core/report/report_head.hpp"
#include "core/study/run.hpp"

namespace analogon {

/// The directory that a command's results go to. It is tested and locked before the work begins, so that what stands
/// in the way is told at once and no other run writes there meanwhile.
///
/// It must be new, empty (but for files that receive what this program prints), or hold earlier results, told by a file
/// inside. Results take the place of earlier ones in a
/// single step: whenever the program is ended, the old ones are there or the new ones. What else lies there stays, and
/// so does, under another name, what somebody has changed since it was written.
class ResultsPlace {
public:
    /// `study`: what the results come from, which must not lie among results that would be replaced.
    static Outcome<ResultsPlace> take(const std::filesystem::path& directory, const std::filesystem::path& study = {});
    /// Where nothing was written, the directory goes again that was made.
    ~ResultsPlace();
    ResultsPlace(ResultsPlace&&) = default;
    ResultsPlace& operator=(ResultsPlace&&) = delete;

    /// Notes: what was kept under another name. Throws Stopped (core/base/stop) where that was asked for before the
    /// results were at their place; nothing has changed there then, and they can be written anew.
    /// `head`: of the report; empty: that of the completed study. A logo that cannot be read is a warning.
    /// `unit`: what a campaign records of it (unit.json); empty: the study is of no campaign.
    Outcome<Done> write(const RunResult& result, const std::string& command, Traces traces = Traces::All,
                        const std::string& unit = {}, const std::optional<ReportHead>& head = {});
    /// The same of traces alone: of a class that is no study.
    Outcome<Done> writeTraces(const std::string& csv);
    /// The same of the record of a unit that has no results.
    Outcome<Done> writeUnit(const std::string& unit);

private:
    explicit ResultsPlace(std::filesystem::path directory) : directory_(std::move(directory)) {}
    Outcome<Done> prepare(const std::filesystem::path& study);
    /// What `fillIn` puts into a directory of our own takes the place of what is there.
    Outcome<Done> replace(const std::function<Outcome<Done>(const std::filesystem::path&)>& fillIn);
    Outcome<Done> probe() const;

    std::filesystem::path directory_;
    std::vector<std::filesystem::path> made_;  // directories that were not there before, the outermost first
    DirectoryLock lock_;
};

}  // namespace analogon
