#pragma once

#include <filesystem>
#include <map>
#include <string>

/// What a directory of results holds, and which of it is as it was written: a file inside tells.
namespace analogon {

/// The names at the top of a directory of results, in the order in which they are replaced.
inline constexpr const char* resultNames[] = {"report.json", "report.html",    "traces.csv", "proposed.mo",
                                              "study",       "study-proposed", "unit.json",  ".analogon-results"};

class ResultsRecord {
public:
    /// Of the files below a directory as they are now. Whether it is whole on the disk.
    [[nodiscard]] static bool write(const std::filesystem::path& directory);
    /// As it was written into a directory; one without it knows no file.
    static ResultsRecord read(const std::filesystem::path& directory);

    /// Whether all below a name of the directory is as it was written.
    bool isUnchanged(const std::string& name) const;
    /// Whether the directory holds nothing but what was written, unchanged.
    bool isAll() const;

private:
    bool isUnchangedFile(const std::filesystem::path& file) const;

    std::filesystem::path directory_;
    std::map<std::string, std::string> files_;  // by name: size and time of the last change
};

/// Whether a directory holds results, by the record or by a report of ours.
bool holdsResults(const std::filesystem::path& directory);

bool isResultName(const std::string& name);

}  // namespace analogon
