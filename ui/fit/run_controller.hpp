#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <map>
#include <set>
#include <string>

#include "core/effect/tell/preview.hpp"
#include "ui/document/document.hpp"
#include "ui/job/job.hpp"

namespace analogon::ui {

/// Starts runs on the open study and hands their results to the document. A result for a study that has been
/// changed meanwhile is dropped, with a message.
class RunController : public QObject {
    Q_OBJECT

public:
    RunController(Document& document, QObject* parent = nullptr);

    void start(RunKind kind);
    /// On these recordings alone; the study stays as it is.
    void startOn(RunKind kind, const std::set<std::string>& recordings);
    /// A discovery that knows this effect at this place alone: what the model would be with it.
    void tryEffect(const EffectChoice& choice);
    /// Once more the search that is shown, with ten times its limit of work.
    void searchLonger();
    /// The search that is shown ended at its limit of work, and the study is as it was then.
    bool canSearchLonger() const;
    /// Works out what the traces would be with this effect and shows them until leaveEffect(); nothing is kept.
    void lookAtEffect(const EffectChoice& choice, const QString& name);
    void leaveEffect();
    void cancel();
    bool isRunning() const { return run_.isBusy(); }
    /// The work that the user is shown and may cancel: a run, or a simulation of the model as it stands that takes its
    /// time; null: none.
    const JobRunner* shownJob() const;
    RunOptions& options() { return options_; }

Q_SIGNALS:
    void runningChanged();
    void progressed(const analogon::Progress::Report& report);
    /// For the status line: "Fitted in 1.2 s".
    void concluded(const QString& sentence);
    /// A fit was asked for, and no parameter is checked for it.
    void parametersWanted();

private:
    /// What a search was asked for.
    struct Search {
        RunOptions options;
        std::set<std::string> recordings;
    };
    /// `part`: the study, or with some of its recordings alone.
    QString missingFor(RunKind kind) const;
    void start(RunKind kind, const RunOptions& options, const Study& part);
    std::vector<FaultyRecording> stillLeftOut(const Study& part) const;
    void preview();
    /// What was measured is there at once, however long the simulation takes.
    void showMeasured();
    void simulateAsItStands();
    bool hasNewRecordings() const;
    /// Why a run has failed is told until the study is another one that works.
    void forgetMended(bool isSound);
    void previewEffect();
    /// Simulates the best values a fit has reported, a few times a second and beside it.
    void watch(const Progress::Report& report);
    void simulateBest();
    void stopWatching();
    void conclude(RunKind kind, const Study& ranOn, unsigned long revision, Outcome<RunResult> outcome);
    void tellEnd(RunKind kind, const Finding& finding, bool isStopped, double seconds);

    Document& document_;
    RunOptions options_;
    JobRunner run_;
    JobRunner preview_;  // simulates the model as it stands whenever it has changed
    QTimer previewDelay_;
    QTimer patience_;  // that a simulation of the model as it stands may take unseen
    bool isPreviewShown_{}, isOpened_{};
    QElapsedTimer clock_;                    // of the run
    unsigned long revision_{};               // of the study it runs on
    Study part_;                             // of which it looks at the recordings that are used
    std::optional<unsigned long> failedAt_;  // revision of the study whose run has failed and is still told of
    JobRunner live_;                         // simulates the best so far while a fit runs
    QTimer liveDelay_;
    std::vector<Progress::Value> best_;                         // as last reported and not simulated yet
    std::shared_ptr<const Outcome<TraceSimulator>> simulator_;  // of the run; null: not compiled yet
    JobRunner look_;                                            // works out what an effect would bring
    QTimer lookDelay_;
    struct Look {
        EffectChoice choice;
        QString name;
        unsigned long revision{};               // of the study
        std::optional<SimulatedTraces> traces;  // none: the effect does nothing there
    };
    std::optional<Look> wanted_;
    std::vector<Look> looks_;                   // the last ones
    Search asked_;                              // of the run
    std::map<unsigned long, Search> searches_;  // by the number of their run
    RunKind kind_{};                            // of the run
};

QString runName(RunKind kind);

}  // namespace analogon::ui
