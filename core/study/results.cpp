#include "core/study/results.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <optional>
#include <set>

#include "core/base/file_fault.hpp"
#include "core/base/file_step.hpp"
#include "core/base/owned_directory.hpp"
#include "core/base/stop.hpp"
#include "core/report/logo.hpp"
#include "core/report/report.hpp"
#include "core/study/report_settings.hpp"
#include "core/study/results_record.hpp"

namespace analogon {

namespace {

namespace fs = std::filesystem;

constexpr const char* version = ANALOGON_VERSION;
constexpr const char* inside = ".analogon-results-";  // our directory within that of the results
constexpr std::size_t probed = 1u << 18;              // [byte]

std::string besideOf(const fs::path& directory) { return "." + directory.filename().string() + inside; }

bool isThere(const fs::path& path) {
    std::error_code code;
    return fs::exists(fs::symlink_status(path, code));
}

Outcome<Done> putFile(const fs::path& file, const fs::path& shown, const std::string& content) {
    std::ofstream stream(file, std::ios::binary);
    stream << content;
    stream.close();
    if (!stream) return cannotWrite(shown, phrase("the disk may be full"));
    syncToDisk(file);
    return Done{};
}

/// What the report says beside the finding. A logo that cannot be used is told.
ReportContext contextOf(const RunResult& result, const std::string& command, const std::optional<ReportHead>& head,
                        Diagnostics& told) {
    ReportContext context{result.completed.name, command, version};
    context.head = head ? *head : reportHeadOf(result.completed.extraJson);
    if (const std::string& logo = context.head.logo; !logo.empty()) {
        Outcome<std::string> uri = logoUri(result.completed.directory / logo, logo);
        if (uri)
            context.logoUri = std::move(*uri);
        else
            std::transform(uri.diagnostics().begin(), uri.diagnostics().end(), std::back_inserter(told), asWarning);
    }
    if (context.head.shows(ReportSection::Diagram)) context.diagrams = diagramsOf(result);
    return context;
}

/// All results in a directory of our own.
Outcome<Done> fill(const fs::path& fresh, const fs::path& shown, const RunResult& result, Traces kept,
                   const std::string& unit, const ReportContext& context) {
    const std::pair<const char*, std::string> files[] = {
        {"report.json", reportJson(result.finding, context)},
        {"report.html", reportHtml(result.finding, context)},
        {"traces.csv", leavesTracesOut(result.finding, kept) ? std::string() : tracesCsv(result.finding)},
        {"proposed.mo", proposedBlocks(result.finding)},
        {"unit.json", unit}};
    for (const auto& [name, content] : files) {
        stopPoint();
        if (!content.empty())
            if (Outcome<Done> done = putFile(fresh / name, shown / name, content); !done) return done;
    }
    stopPoint();
    const auto put = [&](Study study, const char* name) {
        if (reportHeadOf(study.extraJson) != context.head)
            study.extraJson = withReportHead(study.extraJson, context.head);
        return writeStudy(study, fresh / name);
    };
    if (Outcome<Done> done = put(result.completed, "study"); !done) return done;
    if (result.proposed)
        if (Outcome<Done> done = put(*result.proposed, "study-proposed"); !done) return done;
    return Done{};
}

/// Replaces results one name after the other, where the directory cannot be exchanged as a whole. The renaming of
/// "new" to "ready" is the moment from which the new ones hold: what is not moved then is moved by the next run.
class EachByItself {
public:
    EachByItself(fs::path own, fs::path place) : own_(std::move(own)), place_(std::move(place)) {}

    std::error_code commit() const {
        std::ofstream gone(own_ / "gone");
        for (const char* name : resultNames)
            if (isThere(place_ / name) && !isThere(own_ / "new" / name)) gone << name << '\n';
        gone.close();
        if (!gone) return std::make_error_code(std::errc::no_space_on_device);
        syncToDisk(own_ / "gone");
        std::error_code code = renameToNew(own_ / "new", own_ / "ready");
        syncToDisk(own_);
        return code;
    }

    std::error_code move(Diagnostics& notes) const {
        if (!isPlainDirectory(own_ / "ready")) return {};
        std::set<std::string> gone;
        std::ifstream list(own_ / "gone");
        for (std::string name; std::getline(list, name);) gone.insert(name);
        for (const char* name : resultNames) {
            const bool isNew = isThere(own_ / "ready" / name);
            if (!isNew && !gone.contains(name)) continue;  // moved already
            if (const std::error_code code = setAside(name, notes)) return code;
            if (!isNew) continue;
            if (const std::error_code code = renameToNew(own_ / "ready" / name, place_ / name)) return code;
        }
        syncToDisk(place_);
        return {};
    }

private:
    /// To what goes with our directory where it is as it was written, else beside the new ones under another name.
    std::error_code setAside(const std::string& name, Diagnostics& notes) const {
        if (!isThere(place_ / name)) return {};
        if (ResultsRecord::read(place_).isUnchanged(name)) {
            std::error_code code;
            fs::create_directory(own_ / "old", code);
            return renameToNew(place_ / name, own_ / "old" / name);
        }
        for (int i = 1;; ++i) {
            const std::string kept = fmt::format("{}.kept-{}", name, i);
            const std::error_code code = renameToNew(place_ / name, place_ / kept);
            if (code == std::errc::file_exists || code == std::errc::directory_not_empty) continue;
            if (!code) {
                Diagnostic note = fileError(phrase("this was changed since it was written; it is kept as \"{}\"", kept),
                                            (place_ / name).string());
                note.severity = Severity::Note;
                notes.push_back(std::move(note));
            }
            return code;
        }
    }

    fs::path own_, place_;
};

/// Ends what a run that was killed has begun: new results that hold are moved to their places, the rest is removed.
void clearLeft(const fs::path& place) {
    std::error_code code;
    std::vector<fs::path> left;
    for (fs::directory_iterator entry(place, code), end; !code && entry != end; entry.increment(code))
        if (entry->path().filename().string().starts_with(inside)) left.push_back(entry->path());
    for (const fs::path& path : left) {
        std::optional<OwnedDirectory> own = OwnedDirectory::adopt(path);
        Diagnostics notes;
        if (own && EachByItself(path, place).move(notes)) own->release();  // what cannot be moved is not lost
    }
    removeAbandoned(place.parent_path(), besideOf(place));
}

/// Whether the directory as a whole may give way to another one: all that lies there is ours, nobody works in it, and
/// it is no place of a file system of its own.
bool canBeExchanged(const fs::path& place) {
    struct stat status {
    }, around{};
    if (stat(place.c_str(), &status) != 0 || stat(place.parent_path().c_str(), &around) != 0) return false;
    if (status.st_uid != geteuid() || status.st_dev != around.st_dev) return false;
    std::error_code code;
    for (fs::path at = fs::current_path(code); !code; at = at.parent_path()) {
        if (fs::equivalent(at, place, code)) return false;
        if (at == at.parent_path()) break;
    }
    return ResultsRecord::read(place).isAll();
}

/// What somebody has put there at the last moment goes back.
void bringBack(const fs::path& old, const fs::path& place) {
    std::error_code code;
    std::vector<std::string> foreign;
    for (fs::directory_iterator entry(old, code), end; !code && entry != end; entry.increment(code))
        if (const std::string name = entry->path().filename().string(); !isResultName(name)) foreign.push_back(name);
    for (const std::string& name : foreign) (void)renameToNew(old / name, place / name);
}

Outcome<Done> replaceEach(OwnedDirectory& own, const fs::path& place) {
    const EachByItself each(own.path(), place);
    Diagnostics notes;
    std::error_code code = each.commit();
    if (!code) code = each.move(notes);
    if (!code) return {Done{}, std::move(notes)};
    if (isThere(own.path() / "ready")) own.release();  // the next run moves what is not moved
    return cannotWrite(place, code);
}

Diagnostic holdsSomethingElse(const fs::path& directory) {
    return fileError(phrase("this directory holds something else than results"), directory.string(), 0, 0,
                     phrase("Give a new or an empty directory, or one with earlier results."));
}

/// Whether a file receives what this program prints: a shell that is told so makes it before the program begins.
bool isPrintedTo(const fs::path& file) {
    struct stat there {
    }, stream{};
    if (lstat(file.c_str(), &there) != 0 || !S_ISREG(there.st_mode)) return false;
    for (const int handle : {STDOUT_FILENO, STDERR_FILENO})
        if (fstat(handle, &stream) == 0 && stream.st_dev == there.st_dev && stream.st_ino == there.st_ino) return true;
    return false;
}

bool isFree(const fs::path& directory) {
    std::error_code code;
    for (fs::directory_iterator entry(directory, code), end; !code && entry != end; entry.increment(code))
        if (!isPrintedTo(entry->path())) return false;
    return !code;
}

bool isWithin(const fs::path& path, const fs::path& directory) {
    const fs::path relative = path.lexically_relative(directory);
    return !relative.empty() && *relative.begin() != "..";
}

}  // namespace

Outcome<ResultsPlace> ResultsPlace::take(const fs::path& directory, const fs::path& study) {
    std::error_code code;
    if (directory.empty())
        return fileError(phrase("results need a directory, and this is none"), "\"\"", 0, 0,
                         phrase("Give a new or an empty directory, or one with earlier results."));
    fs::path whole = fs::absolute(directory, code).lexically_normal();
    if (!whole.has_filename()) whole = whole.parent_path();
    if (isThere(whole)) {
        whole = fs::canonical(whole, code);
        if (code) return cannotWrite(directory, code);
        if (!fs::is_directory(whole, code))
            return fileError(phrase("results need a directory, and this is none"), directory.string(), 0, 0,
                             phrase("Give a new or an empty directory, or one with earlier results."));
    }
    ResultsPlace place(whole);
    if (Outcome<Done> ready = place.prepare(study); !ready) return ready.diagnostics();
    return place;
}

Outcome<Done> ResultsPlace::prepare(const fs::path& study) {
    std::error_code code;
    std::vector<fs::path> missing;
    for (fs::path at = directory_; !isThere(at); at = at.parent_path()) missing.insert(missing.begin(), at);
    for (const fs::path& path : missing) {
        if (mkdir(path.c_str(), 0777) == 0)
            made_.push_back(path);
        else if (errno != EEXIST)
            return cannotWrite(directory_, lastFault());
    }
    lock_ = DirectoryLock(directory_, DirectoryLock::Kind::Exclusive, std::chrono::milliseconds(0));
    if (lock_.isBusy())
        return fileError(phrase("another run writes its results there"), directory_.string(), 0, 0,
                         phrase("Wait until it has ended, or give another directory."));
    clearLeft(directory_);
    if (!isFree(directory_) && !holdsResults(directory_)) return holdsSomethingElse(directory_);
    if (!study.empty()) {
        const fs::path from = fs::canonical(study, code);
        for (const char* name : {"study", "study-proposed"})
            if (!code && isWithin(from, directory_ / name))
                return fileError(phrase("the study itself lies among the results that would be replaced"),
                                 directory_.string(), 0, 0, phrase("Give another directory."));
    }
    return probe();
}

/// Whether there is room, and the right to write.
Outcome<Done> ResultsPlace::probe() const {
    const Outcome<OwnedDirectory> own = OwnedDirectory::make(directory_, inside);
    if (!own) return cannotWrite(directory_, own.diagnostics().front().message);
    return putFile(own->path() / "probe", directory_, std::string(probed, '\0'));
}

ResultsPlace::~ResultsPlace() {
    for (auto made = made_.rbegin(); made != made_.rend(); ++made) rmdir(made->c_str());  // fails unless it is empty
}

Outcome<Done> ResultsPlace::write(const RunResult& result, const std::string& command, Traces traces,
                                  const std::string& unit, const std::optional<ReportHead>& head) {
    Diagnostics told;
    const ReportContext context = contextOf(result, command, head, told);
    const Outcome<Done> done =
        replace([&](const fs::path& fresh) { return fill(fresh, directory_, result, traces, unit, context); });
    if (!done) return done;
    told.insert(told.begin(), done.diagnostics().begin(), done.diagnostics().end());
    return {Done{}, std::move(told)};
}

Outcome<Done> ResultsPlace::writeTraces(const std::string& csv) {
    return replace(
        [&](const fs::path& fresh) { return putFile(fresh / "traces.csv", directory_ / "traces.csv", csv); });
}

Outcome<Done> ResultsPlace::writeUnit(const std::string& unit) {
    return replace([&](const fs::path& fresh) { return putFile(fresh / "unit.json", directory_ / "unit.json", unit); });
}

Outcome<Done> ResultsPlace::replace(const std::function<Outcome<Done>(const fs::path&)>& fillIn) {
    const bool isWhole = canBeExchanged(directory_);
    Outcome<OwnedDirectory> own =
        OwnedDirectory::make(isWhole ? directory_.parent_path() : directory_, isWhole ? besideOf(directory_) : inside);
    if (isWhole && !own) own = OwnedDirectory::make(directory_, inside);
    if (!own) return cannotWrite(directory_, own.diagnostics().front().message);
    const fs::path fresh = own->path() / "new";
    std::error_code code;
    if (!fs::create_directory(fresh, code)) return cannotWrite(directory_, code);
    if (Outcome<Done> filled = fillIn(fresh); !filled) return filled;
    if (!ResultsRecord::write(fresh)) return cannotWrite(directory_, phrase("the disk may be full"));
    struct stat status {};
    if (stat(directory_.c_str(), &status) == 0) chmod(fresh.c_str(), status.st_mode & 07777);
    syncToDisk(fresh);
    const bool isBeside = own->path().parent_path() != directory_;
    if (isBeside && canBeExchanged(directory_) && !exchange(fresh, directory_)) {
        syncToDisk(directory_.parent_path());
        bringBack(fresh, directory_);
        return Done{};
    }
    if (isBeside) {
        Outcome<OwnedDirectory> within = OwnedDirectory::make(directory_, inside);
        if (!within) return cannotWrite(directory_, within.diagnostics().front().message);
        fs::rename(fresh, within->path() / "new", code);
        if (code) return cannotWrite(directory_, code);
        *own = std::move(*within);
    }
    return replaceEach(*own, directory_);
}

Outcome<Done> writeResults(const RunResult& result, const std::string& command, const fs::path& directory) {
    Outcome<ResultsPlace> place = ResultsPlace::take(directory);
    return place ? place->write(result, command) : Outcome<Done>(place.diagnostics());
}

}  // namespace analogon
