#include "ui/fit/run_controller.hpp"

#include <algorithm>
#include <utility>

#include "core/study/free_run.hpp"
#include "core/study/left_out.hpp"
#include "core/study/marked_part.hpp"
#include "core/study/measured.hpp"
#include "ui/document/told_values.hpp"
#include "ui/style/number.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

Outcome<RunResult> run(RunKind kind, const Study& study, const RunOptions& options, const Progress& progress) {
    switch (kind) {
        case RunKind::Simulate:
            return runSimulate(study, options, progress);
        case RunKind::Fit:
            return runFit(study, options, progress);
        case RunKind::Discover:
            break;
    }
    return runDiscover(study, options, progress);
}

/// What a run on the sound recordings came to, and which were left out.
struct SoundRun {
    Outcome<RunResult> run;
    std::vector<FaultyRecording> leftOut;

    static SoundRun failed(const Diagnostic& fault) { return {fault, {}}; }
};

/// A recording with a fault does not keep the others from being worked on.
SoundRun runSound(RunKind kind, const Study& study, const RunOptions& options, const Progress& progress) {
    SoundRun sound{run(kind, study, options, progress), {}};
    if (sound.run || progress.stopRequested()) return sound;
    SoundPart part = soundPart(study);
    if (part.leftOut.empty()) return sound;
    sound.leftOut = std::move(part.leftOut);
    Outcome<RunResult> done = run(kind, part.study, options, progress);
    Diagnostics said = done.diagnostics();
    said.insert(said.end(), part.remarks.begin(), part.remarks.end());
    if (done) {
        done->completed = withLeftOut(std::move(done->completed), study, sound.leftOut);
        if (done->proposed) done->proposed = withLeftOut(std::move(*done->proposed), study, sound.leftOut);
        sound.run = {std::move(*done), std::move(said)};
    } else {
        sound.run = std::move(said);
    }
    return sound;
}

bool hasRecordings(const Study& study) {
    return std::any_of(study.experiments.begin(), study.experiments.end(),
                       [](const StudyExperiment& e) { return e.isUsed && !e.outputs.empty(); });
}

/// The model over its recordings, and, where nothing but sources of its own drives it, by itself.
SoundRun runAll(const Study& study, const RunOptions& options, const Progress& progress) {
    Outcome<RunResult> free = runFreely(study, {}, options, progress);
    if (!hasRecordings(study)) return {std::move(free), {}};
    SoundRun sound = runSound(RunKind::Simulate, study, options, progress);
    if (sound.run && free) {
        Diagnostics said = sound.run.diagnostics();
        said.insert(said.end(), free.diagnostics().begin(), free.diagnostics().end());
        sound.run = {withFreeRun(std::move(*sound.run), *free), std::move(said)};
    }
    return sound;
}

constexpr int livePause = 200;  // [ms] between two views of a fit that runs

bool hasFitted(const Study& study) {
    const auto isFitted = [](const auto& entry) { return entry.second.fit; };
    const auto isFree = [](const auto& entry) { return std::holds_alternative<FittedStart>(entry.second); };
    return std::any_of(study.parameters.begin(), study.parameters.end(), isFitted) ||
           std::any_of(study.experiments.begin(), study.experiments.end(), [&](const StudyExperiment& e) {
               const auto asksForClock = [](const auto& entry) { return entry.second.fitsClock; };
               return std::any_of(e.initial.begin(), e.initial.end(), isFree) ||
                      std::any_of(e.outputs.begin(), e.outputs.end(), asksForClock);
           });
}

QElapsedTimer startedClock() {
    QElapsedTimer clock;
    clock.start();
    return clock;
}

Diagnostics messagesOf(const RunResult& result) {
    Diagnostics messages;
    for (const Text& text : result.finding.warnings) messages.push_back(warning(text));
    for (const Text& text : result.finding.final.remarks) {
        Diagnostic note = warning(text);
        note.severity = Severity::Note;
        messages.push_back(std::move(note));
    }
    return messages;
}

}  // namespace

QString runName(RunKind kind) {
    switch (kind) {
        case RunKind::Simulate:
            return RunController::tr("Simulation");
        case RunKind::Fit:
            return RunController::tr("Fit");
        case RunKind::Discover:
            break;
    }
    return RunController::tr("Discovery");
}

RunController::RunController(Document& document, QObject* parent) : QObject(parent), document_(document) {
    connect(&run_, &JobRunner::started, this, &RunController::runningChanged);
    connect(&run_, &JobRunner::finished, this, &RunController::runningChanged);
    connect(&run_, &JobRunner::progressed, this, &RunController::progressed);
    connect(&run_, &JobRunner::progressed, this, &RunController::watch);
    connect(&run_, &JobRunner::finished, this, &RunController::stopWatching);
    for (const JobRunner* job : {&live_, &look_, &preview_})
        connect(job, &JobRunner::failed, this,
                [this](const Diagnostic& fault) { Q_EMIT concluded(inWords(fault.message)); });
    options_.discover.patience = 1;  // as on the command line; searchLonger() goes on
    liveDelay_.setSingleShot(true);
    connect(&liveDelay_, &QTimer::timeout, this, &RunController::simulateBest);
    lookDelay_.setSingleShot(true);
    connect(&lookDelay_, &QTimer::timeout, this, &RunController::previewEffect);
    previewDelay_.setSingleShot(true);
    previewDelay_.setInterval(150);
    connect(&previewDelay_, &QTimer::timeout, this, &RunController::preview);
    constexpr int patience = 700;  // [ms]
    patience_.setSingleShot(true);
    patience_.setInterval(patience);
    const auto showPreview = [this](bool isShown) {
        if (std::exchange(isPreviewShown_, isShown) != isShown && !run_.isBusy()) Q_EMIT runningChanged();
    };
    connect(&preview_, &JobRunner::started, this, [this] { patience_.start(); });
    connect(&patience_, &QTimer::timeout, this, [this, showPreview] { showPreview(preview_.isBusy()); });
    connect(&preview_, &JobRunner::finished, this, [this, showPreview] {
        patience_.stop();
        showPreview(false);
    });
    connect(&preview_, &JobRunner::progressed, this, [this](const Progress::Report& report) {
        if (shownJob() == &preview_) Q_EMIT progressed(report);
    });
    const auto soon = [this] { previewDelay_.start(); };
    connect(&document, &Document::modelChanged, this, soon);
    connect(&document, &Document::parametersChanged, this, soon);
    connect(&document, &Document::experimentsChanged, this, soon);
    connect(&document, &Document::opened, this, [this] {
        run_.drop();
        document_.setLeftOut({});
        leaveEffect();
        searches_.clear();
        isOpened_ = true;
        if (!document_.isResultStale()) document_.setRunMessages(messagesOf(*document_.result()));
    });
}

void RunController::start(RunKind kind) {
    if (document_.isOpen()) start(kind, options_, document_.study());
}

void RunController::startOn(RunKind kind, const std::set<std::string>& recordings) {
    if (document_.isOpen()) start(kind, options_, markedPart(document_.study(), recordings));
}

/// Marks of recordings that a run on others does not look at.
std::vector<FaultyRecording> RunController::stillLeftOut(const Study& part) const {
    std::vector<FaultyRecording> known;
    for (std::size_t i = 0; i < part.experiments.size(); ++i)
        if (!part.experiments[i].isUsed && document_.study().experiments[i].isUsed)
            if (const FaultyRecording* const faulty = document_.leftOut(part.experiments[i].name))
                known.push_back(*faulty);
    return known;
}

/// What has to be said of the parameters before such a run makes sense; empty: nothing. With the values of the library
/// alone an effect would make up for every one of them.
QString RunController::missingFor(RunKind kind) const {
    if (kind == RunKind::Simulate || hasFitted(document_.study())) return {};
    if (kind == RunKind::Fit) return tr("There is nothing to fit yet: check parameters in the list.");
    const syntax::ClassDefinition* const model = document_.definition();
    if (!model || document_.facts().parameters.empty() || isAnyValueTold(document_.study(), *model)) return {};
    return tr(
        "All values are those of the library yet: check the parameters that are to be found, and enter those that "
        "are known.");
}

void RunController::start(RunKind kind, const RunOptions& options, const Study& part) {
    if (run_.isBusy()) return;
    if (const QString missing = missingFor(kind); !missing.isEmpty()) {
        Q_EMIT parametersWanted();
        return Q_EMIT concluded(missing);
    }
    leaveEffect();
    document_.setRunMessages({});
    failedAt_.reset();
    if (document_.before()) preview_.drop();  // else its traces are what a fit is watched against
    simulator_.reset();
    const Study study = document_.study();
    const unsigned long revision = revision_ = document_.revision();
    kind_ = kind;
    part_ = part;
    asked_ = {options, {}};
    for (const StudyExperiment& e : part.experiments)
        if (e.isUsed) asked_.recordings.insert(e.name);
    clock_.start();
    run_.start<SoundRun>(
        runName(kind),
        [kind, study, part, options](const Progress& progress) {
            SoundRun sound =
                kind == RunKind::Simulate ? runAll(part, options, progress) : runSound(kind, part, options, progress);
            if (sound.run) *sound.run = forWhole(std::move(*sound.run), study, part);
            return sound;
        },
        [this, kind, study, part, revision](SoundRun sound) {
            if (revision == document_.revision()) {
                const std::vector<FaultyRecording> others = stillLeftOut(part);
                sound.leftOut.insert(sound.leftOut.end(), others.begin(), others.end());
                document_.setLeftOut(std::move(sound.leftOut));
            }
            conclude(kind, study, revision, std::move(sound.run));
        });
}

void RunController::watch(const Progress::Report& report) {
    if (report.best.empty() || run_.isCancelling()) return;
    if (revision_ != document_.revision()) return stopWatching();
    best_ = report.best;
    if (!liveDelay_.isActive() && !live_.isBusy()) liveDelay_.start(livePause);
}

void RunController::simulateBest() {
    if (!run_.isBusy() || best_.empty()) return;
    struct Watched {
        std::shared_ptr<const Outcome<TraceSimulator>> simulator;
        std::optional<SimulatedTraces> traces;
    };
    live_.start<Watched>(
        tr("Simulation"),
        [study = part_, options = options_, simulator = simulator_,
         best = std::exchange(best_, {})](const Progress& progress) {
            Watched watched{simulator, {}};
            if (!watched.simulator)
                watched.simulator = std::make_shared<const Outcome<TraceSimulator>>(
                    TraceSimulator::make(soundPart(study).study, options));
            if (*watched.simulator) watched.traces = (*watched.simulator)->at(best, progress);
            return watched;
        },
        [this, clock = startedClock()](Watched watched) {
            if (!run_.isBusy()) return;
            simulator_ = std::move(watched.simulator);
            // Several starts report by turns: the best of them is what is shown.
            const SimulatedTraces* shown = document_.liveTraces();
            if (watched.traces && (!shown || watched.traces->errorPercent <= shown->errorPercent))
                document_.setLiveTraces(std::move(watched.traces), kind_);
            // At most half of the time: the fit is what the machine is wanted for.
            if (!best_.empty()) liveDelay_.start(std::max<int>(livePause, static_cast<int>(clock.elapsed())));
        });
}

void RunController::stopWatching() {
    liveDelay_.stop();
    live_.drop();
    best_.clear();
    part_ = {};
    simulator_.reset();
    document_.setLiveTraces(std::nullopt);
}

const JobRunner* RunController::shownJob() const {
    if (run_.isBusy()) return &run_;
    return isPreviewShown_ ? &preview_ : nullptr;
}

void RunController::cancel() {
    if (run_.isBusy())
        run_.cancel();
    else if (isPreviewShown_)
        preview_.cancel();
}

void RunController::conclude(RunKind kind, const Study& ranOn, unsigned long revision, Outcome<RunResult> outcome) {
    const QString name = runName(kind);
    if (!outcome) {
        if (run_.isCancelling()) return Q_EMIT concluded(tr("%1 stopped.").arg(name));
        document_.setRunMessages(outcome.diagnostics());
        failedAt_ = revision;
        return Q_EMIT concluded(tr("%1 failed: see the messages.").arg(name));
    }
    if (revision != document_.revision()) {
        document_.setRunMessages(
            {warning(tr("the study was changed during the run; its result does not belong to what is shown and was "
                        "dropped")
                         .toStdString())});
        return Q_EMIT concluded(tr("%1: the study changed meanwhile, result dropped.").arg(name));
    }
    const bool isStopped = outcome->finding.end.interrupted || run_.isCancelling();
    const double seconds = static_cast<double>(clock_.elapsed()) / 1000;
    Diagnostics messages = messagesOf(*outcome);
    for (const Diagnostic& d : outcome.diagnostics()) messages.push_back(d);
    document_.setResult(kind, std::move(*outcome), ranOn, seconds);
    document_.setRunMessages(std::move(messages));
    searches_[document_.shownRun()] = asked_;
    tellEnd(kind, *document_.finding(), isStopped, seconds);
}

void RunController::tellEnd(RunKind kind, const Finding& finding, bool isStopped, double seconds) {
    if (finding.end.isAtLimitOfWork && !run_.isCancelling())
        return Q_EMIT concluded(tr("Discover ended at its limit of work; what it has found is shown."));
    const QString name = runName(kind);
    Q_EMIT concluded(isStopped ? tr("%1 stopped; best result so far is shown.").arg(name)
                               : tr("%1 done in %2 s.").arg(name, style::numberText(seconds, 3)));
}

void RunController::preview() {
    if (!document_.isOpen() || (run_.isBusy() && document_.before())) return;
    if (!document_.definition() && document_.before()) return;  // a text being typed: the last traces stay
    if (!document_.canRun() && !document_.isSimulated()) return preview_.drop();
    const bool isOpened = std::exchange(isOpened_, false);  // what the study itself says was not told yet
    if (document_.after() && !isOpened) {                   // its traces and remarks are what is shown
        document_.setCheckMessages({});
        return;
    }
    if (hasNewRecordings())
        showMeasured();
    else
        simulateAsItStands();
}

void RunController::forgetMended(bool isSound) {
    if (!isSound || !failedAt_ || *failedAt_ == document_.revision()) return;
    failedAt_.reset();
    document_.setRunMessages({});
}

/// Whether the study has recordings of which nothing is shown.
bool RunController::hasNewRecordings() const {
    const std::shared_ptr<const ModelState> shown = document_.before() ? document_.before() : document_.measured();
    const std::vector<StudyExperiment>& recorded = document_.study().experiments;
    return std::any_of(recorded.begin(), recorded.end(), [&](const StudyExperiment& e) {
        if (!e.isUsed || (shown && document_.leftOut(e.name))) return false;
        return !shown || std::none_of(shown->experiments.begin(), shown->experiments.end(),
                                      [&](const ExperimentState& s) { return s.name == e.name; });
    });
}

void RunController::showMeasured() {
    preview_.start<std::vector<ExperimentState>>(
        tr("Simulation"), [study = document_.study()](const Progress&) { return measuredExperiments(study); },
        [this](std::vector<ExperimentState> measured) {
            document_.setMeasured(std::move(measured));
            simulateAsItStands();
        });
}

void RunController::simulateAsItStands() {
    struct Seen {
        SoundRun sound;
        std::vector<ExperimentState> measured;  // when nothing could be simulated, or not to its end

        static Seen failed(const Diagnostic& fault) { return {SoundRun::failed(fault), {}}; }
    };
    preview_.start<Seen>(
        tr("Simulation"),
        [study = document_.study(), options = options_,
         isSimulated = document_.isSimulated()](const Progress& progress) {
            Seen seen{
                isSimulated ? runAll(study, options, progress) : runSound(RunKind::Simulate, study, options, progress),
                {}};
            if (!seen.sound.run || progress.stopRequested()) seen.measured = measuredExperiments(study);
            return seen;
        },
        [this](Seen seen) {
            if (preview_.isCancelling()) {
                document_.setMeasured(std::move(seen.measured));
                return Q_EMIT concluded(tr("%1 stopped.").arg(runName(RunKind::Simulate)));
            }
            // What the analysis says of the model is told already.
            Outcome<RunResult>& run = seen.sound.run;
            const bool isTold = !run && (document_.modelError() || !document_.definition());
            document_.setLeftOut(std::move(seen.sound.leftOut));
            document_.setCheckMessages(isTold ? Diagnostics() : run.diagnostics());
            forgetMended(run.hasValue());
            if (run) return document_.setSimulated(std::move(run->finding.baseline));
            document_.setMeasured(std::move(seen.measured));
        });
}

}  // namespace analogon::ui
