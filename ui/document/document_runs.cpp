#include <QDateTime>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "core/study/free_run.hpp"
#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/document/same_study.hpp"

/// What runs left of an open study: the result that is shown, the traces that belong to it, and the runs so far.
namespace analogon::ui {

namespace {

constexpr const char* plotsMember = "plots";  // of study.json

QJsonObject membersOf(const std::string& json) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
}

std::string textOf(const QJsonObject& json) {
    return json.isEmpty() ? std::string() : QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

std::string plotsOf(const std::string& extraJson) { return textOf(membersOf(extraJson).value(plotsMember).toObject()); }

/// The further members of a study with other plots; all else of them stays.
std::string withPlots(const std::string& extraJson, const std::string& plots) {
    QJsonObject all = membersOf(extraJson);
    all[plotsMember] = membersOf(plots);
    return textOf(all);
}

/// The time of a run of today, else its day as well.
QString timeText(const QDateTime& ended) {
    return ended.toString(ended.date() == QDate::currentDate() ? "HH:mm:ss" : "yyyy-MM-dd HH:mm");
}

RunKind kindOf(const std::string& command) {
    for (const RunKind kind : {RunKind::Simulate, RunKind::Fit})
        if (command == commandName(kind)) return kind;
    return RunKind::Discover;
}

}  // namespace

const char* commandName(RunKind kind) {
    switch (kind) {
        case RunKind::Simulate:
            return "simulate";
        case RunKind::Fit:
            return "fit";
        case RunKind::Discover:
            break;
    }
    return "discover";
}

/// The runs of the study that was opened, with the result that was shown when it was saved.
void Document::takeHistory(const std::vector<PastRun>& history) {
    history_.clear();
    hasNewRuns_ = false;
    shownRun_ = 0;
    const PastRun* shown = history.empty() ? nullptr : &history.back();
    for (const PastRun& run : history) {
        const QDateTime ended = QDateTime::fromString(QString::fromStdString(run.ended), Qt::ISODate);
        history_.push_back({++runs_, kindOf(run.command), timeText(ended), run.ended, run.seconds, run.ranOn,
                            run.result, run.before, QString::fromStdString(run.name), QString::fromStdString(run.note),
                            run.isPinned, run.plots});
        if (run.isShown) shown = &run;
    }
    if (shown) showRun(history_[static_cast<std::size_t>(shown - history.data())]);
}

void Document::showRun(const RunRecord& record) {
    result_ = record.result;
    resultStudy_ = *record.ranOn;
    resultKind_ = record.kind;
    beforeFit_ = record.before;
    shownRun_ = record.number;
    ++tracesVersion_;
}

/// With the run that is shown, before another one is.
void Document::keepPlots() {
    for (RunRecord& run : history_)
        if (run.number == shownRun_) run.plots = plotsOf(study_->extraJson);
}

const RunRecord* Document::run(unsigned long number) const {
    const auto found =
        std::find_if(history_.begin(), history_.end(), [&](const auto& r) { return r.number == number; });
    return found == history_.end() ? nullptr : &*found;
}

void Document::describeRun(unsigned long number, const QString& name, const QString& note) {
    for (RunRecord& run : history_) {
        if (run.number != number || (run.name == name && run.note == note)) continue;
        run.name = name;
        run.note = note;
        keepNewRun();
    }
}

bool Document::pinRun(unsigned long number, bool isPinned) {
    const auto pinned = std::count_if(history_.begin(), history_.end(), [](const auto& r) { return r.isPinned; });
    if (isPinned && static_cast<std::size_t>(pinned) >= HistoryLimits().pinned) return false;
    for (RunRecord& run : history_) {
        if (run.number != number || run.isPinned == isPinned) continue;
        run.isPinned = isPinned;
        keepNewRun();
    }
    return true;
}

/// What is said of runs is part of the file, and no step of the study that could be undone.
void Document::keepNewRun() {
    hasNewRuns_ = true;
    ++saidOfRuns_;
    Q_EMIT historyChanged();
    Q_EMIT modifiedChanged();
}

std::vector<PastRun> Document::pastRuns() const {
    std::vector<PastRun> runs;
    for (const RunRecord& run : history_) {
        const bool isShown = run.number == shownRun_;
        runs.push_back({commandName(run.kind), run.ended, run.seconds, run.ranOn, run.result, run.before,
                        run.name.toStdString(), run.note.toStdString(), run.isPinned, isShown,
                        isShown ? plotsOf(study_->extraJson) : run.plots});
    }
    return runs;
}

void Document::adoptCompleted(const QString& what) {
    if (result_ && !isResultAdopted()) adopt(result_->completed, what);
}

void Document::adoptProposed() {
    if (result_ && result_->proposed && !isResultStale()) adopt(*result_->proposed, tr("Add what is proposed"));
}

void Document::adopt(const Study& completed, const QString& what) {
    StudySettings settings = settingsOf(completed);
    settings.tables = study_->tables;
    settings.plots = study_->extraJson;  // what one looks at stays
    applySettings(std::move(settings), what);
    Q_EMIT resultChanged();
}

void Document::setSimulated(ModelState state) {
    simulated_ = std::make_shared<const ModelState>(std::move(state));
    measured_.reset();
    ++tracesVersion_;
    Q_EMIT resultChanged();
}

void Document::setMeasured(std::vector<ExperimentState> measured) {
    simulated_.reset();
    ModelState state;
    state.experiments = std::move(measured);
    measured_ = std::make_shared<const ModelState>(std::move(state));
    ++tracesVersion_;
    Q_EMIT resultChanged();
}

void Document::setLiveTraces(std::optional<SimulatedTraces> traces, RunKind of) {
    if (!traces && !live_) return;
    live_ = std::move(traces);
    liveKind_ = of;
    Q_EMIT liveTracesChanged();
}

void Document::setPreview(std::optional<Preview> preview) {
    if (!preview && !preview_) return;
    preview_ = std::move(preview);
    Q_EMIT liveTracesChanged();
}

void Document::compareRuns(std::optional<RunPair> pair) {
    const auto numbers = [](const std::optional<RunPair>& of) {
        return of ? std::pair(of->first.number, of->second.number) : std::pair(0ul, 0ul);
    };
    if (numbers(pair) == numbers(compared_)) return;
    compared_ = std::move(pair);
    ++tracesVersion_;
    Q_EMIT comparisonChanged();
}

void Document::restoreRun(const RunRecord& chosen) {
    const RunRecord record = chosen;  // it may be one of the history, which changes on the way
    StudySettings settings = settingsOf(record.result->completed);
    settings.tables.insert(study_->tables.begin(), study_->tables.end());
    keepPlots();
    settings.plots = record.plots.empty() ? study_->extraJson : withPlots(study_->extraJson, record.plots);
    // A recording that was taken out of the study before it was saved is in no file any more.
    const std::size_t gone = std::erase_if(settings.experiments, [&](const auto& e) {
        return !fileTable(settings.tables, e) && !study_->unread.contains(tableKey(e));
    });
    applySettings(std::move(settings), tr("Go back to the run of %1").arg(record.when));
    if (gone > 0)
        return setRunMessages({warning(phrase("{} recordings of that run are not part of the study any more", gone))});
    showRun(record);
    Q_EMIT resultChanged();
}

void Document::setResult(RunKind kind, RunResult result, const Study& ranOn, double seconds) {
    beforeFit_ = kind == RunKind::Simulate ? nullptr : simulated_;
    live_.reset();
    result_ = std::make_shared<const RunResult>(std::move(result));
    keepPlots();
    const auto others = std::count_if(history_.begin(), history_.end(), [](const auto& r) { return !r.isPinned; });
    if (static_cast<std::size_t>(others) >= HistoryLimits().runs)
        history_.erase(std::find_if(history_.begin(), history_.end(), [](const auto& r) { return !r.isPinned; }));
    const QDateTime now = QDateTime::currentDateTime();
    history_.push_back({++runs_, kind, timeText(now), now.toString(Qt::ISODate).toStdString(), seconds,
                        std::make_shared<const Study>(ranOn), result_, kind == RunKind::Fit ? beforeFit_ : nullptr});
    shownRun_ = runs_;
    hasNewRuns_ = true;
    resultStudy_ = ranOn;
    resultKind_ = kind;
    ++tracesVersion_;
    Q_EMIT resultChanged();
    Q_EMIT modifiedChanged();
}

bool Document::isSimulated() const {
    if (!result_ || resultKind_ != RunKind::Simulate) return false;
    const std::vector<ExperimentState>& shown = result_->finding.final.experiments;
    return std::any_of(shown.begin(), shown.end(),
                       [name = freeRunName(*study_)](const ExperimentState& e) { return e.name == name; });
}

bool Document::isResultStale() const {
    return !result_ || !(isSameModel(*study_, *resultStudy_) || isSameModel(*study_, result_->completed));
}

bool Document::isResultAdopted() const { return result_ && isSameModel(*study_, result_->completed); }

std::shared_ptr<const ModelState> Document::before() const {
    if (!result_ || isResultStale() || !hasTraces(*result_)) return simulated_;
    return resultKind_ == RunKind::Discover ? std::shared_ptr<const ModelState>(result_, &result_->finding.baseline)
                                            : beforeFit_;
}

std::shared_ptr<const ModelState> Document::after() const {
    if (!result_ || isResultStale() || !hasTraces(*result_)) return nullptr;
    return {result_, &result_->finding.final};
}

}  // namespace analogon::ui
