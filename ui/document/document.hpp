#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <QUndoStack>
#include <filesystem>
#include <memory>
#include <optional>

#include "core/archive/archive.hpp"
#include "core/diagram/diagram.hpp"
#include "core/diagram/edit.hpp"
#include "core/study/left_out.hpp"
#include "core/study/run.hpp"
#include "core/study/trace_simulator.hpp"
#include "ui/document/commands.hpp"
#include "ui/document/model_facts.hpp"
#include "ui/job/job.hpp"

namespace analogon::ui {

enum class RunKind { Simulate, Fit, Discover };
/// Its name on the command line and in a report: "fit".
const char* commandName(RunKind kind);

/// A message with the part of the work it came from; opening a study or changing the model replaces its own.
struct Message {
    enum class Origin { Study, Model, Check, Run };
    Origin origin{Origin::Study};
    Diagnostic diagnostic;
};

/// A run as it was: the study it ran on and what it came to.
struct RunRecord {
    unsigned long number{};  // counts all runs since the program began
    RunKind kind{RunKind::Fit};
    QString when;       // for people
    std::string ended;  // local time, "2026-03-01T14:02:11"
    double seconds{};
    std::shared_ptr<const Study> ranOn;
    std::shared_ptr<const RunResult> result;
    std::shared_ptr<const ModelState> before{};  // of a fit: traces with its start values; null: not known
    QString name{}, note{};                      // given by the user
    bool isPinned{};                             // stays, however many runs follow
    std::string plots{};                         // how the plots of signals were arranged with it (PastRun::plots)

    QString label() const { return name.isEmpty() ? when : name; }
};

/// What the screen shows: one study, the picture of its model, and what was found. The only owner of state.
/// The model's text is the truth: the diagram is read from it after every change, and each change is an
/// undoable edit with its exact inverse.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// Reads a study in the background: a directory, its study.json or an archive.
    void open(const QString& path);
    /// An empty study; `suggested` is its name until it is saved.
    void startNew(const QString& suggested);
    /// A study that was made in memory, not saved anywhere yet, and what there is to say of it. Its texts are read in
    /// the background, as those of a file are.
    void startWith(Study study, Diagnostics remarks = {});
    bool isOpen() const { return study_.has_value(); }
    /// Where it was opened from or last saved to; empty: nowhere yet.
    QString path() const { return path_; }
    /// There is a recording with something to compare with.
    bool canRun() const;
    /// Why the model cannot be simulated, as its last analysis says; null: it can.
    const Diagnostic* modelError() const { return modelError_ ? &*modelError_ : nullptr; }
    /// Writes the study in the background; the document is clean when this has worked.
    void save(const QString& path);
    bool isSaving() const { return saver_.isBusy(); }
    /// Recovered work belongs to this path and is not saved there yet.
    void openRecovered(const QString& recovery, const QString& path);
    const QString& recoveredFrom() const { return recoveredFrom_; }
    bool isModified() const { return isOpen() && (!recoveredFrom_.isEmpty() || !undo_.isClean() || hasNewRuns_); }
    bool isReading() const { return reader_.isBusy(); }

    const Study& study() const { return *study_; }
    QString title() const;
    QString modelText() const;
    const Library& library() const { return library_; }
    const Diagram& diagram() const { return diagram_; }
    const ModelFacts& facts() const { return facts_; }
    /// The class whose diagram is shown: the study's model, or that of a component one has gone into.
    const std::string& shownClass() const { return shownClass_; }
    /// Names of the components one has gone into, from the study's model inward; empty: its own diagram is shown.
    const std::vector<std::string>& levels() const { return levels_; }
    /// A component of the diagram whose class is part of this text, with a diagram of its own.
    bool canEnter(const std::string& block) const;
    void enter(const std::string& block);
    void leaveTo(std::size_t depth);
    /// What stands before the names of the shown class's components in the whole model, once for each place where the
    /// class is used: "" for the study's model, "drive." for the class of its component "drive".
    std::vector<std::string> prefixes() const;
    /// Definition of the class that is shown; null when the text does not parse.
    const syntax::ClassDefinition* definition() const;
    QUndoStack& undoStack() { return undo_; }
    /// Counts every change of the study; results of an older revision are stale.
    unsigned long revision() const { return revision_; }

    // Changes, each undoable.
    void applyEdit(syntax::TextEdit edit);
    /// A whole new text of the model, as typed: becomes the one replacement that tells both apart.
    void typeText(const QString& text);
    void applySettings(StudySettings settings, const QString& what);
    StudySettings settings() const { return settingsOf(*study_); }
    /// Text and settings as one step.
    void applyBoth(syntax::TextEdit edit, StudySettings settings);
    /// The value a run starts from: the study's own when it has one, else the text of the model.
    void setParameterValue(const std::string& name, double value);
    /// Several as one step. False: none was set, the messages say why.
    bool setParameterValues(const std::vector<std::pair<std::string, double>>& values, const QString& what);
    void setStudyParameter(const std::string& name, const StudyParameter& parameter, const QString& what);
    /// Takes a run's study with the equations that are proposed over.
    void adoptProposed();
    /// Takes a run's completed study over: effects wired in, fitted values.
    void adoptCompleted(const QString& what);

    std::optional<double> parameterValue(const std::string& name) const;

    // Results. They are kept while the study moves on; isResultStale() tells.
    void setSimulated(ModelState state);  // the model as it stands
    /// The model cannot be simulated: what was measured is all there is to show.
    void setMeasured(std::vector<ExperimentState> measured);
    std::shared_ptr<const ModelState> measured() const { return measured_; }
    void setResult(RunKind kind, RunResult result, const Study& ranOn, double seconds = 0);
    /// The study as a run left it, as an edit.
    void restoreRun(const RunRecord& chosen);
    const Finding* finding() const { return result_ ? &result_->finding : nullptr; }
    const RunResult* result() const { return result_.get(); }
    std::shared_ptr<const RunResult> sharedResult() const { return result_; }  // outlives what happens to the study
    RunKind resultKind() const { return resultKind_; }
    /// The last run simulated the model by itself: then it is simulated again as it changes.
    bool isSimulated() const;
    bool isResultStale() const;
    /// The completed study is the current one.
    bool isResultAdopted() const;
    /// Traces to show: as it stood before, and with what was found (null: there is none).
    std::shared_ptr<const ModelState> before() const;
    std::shared_ptr<const ModelState> after() const;
    /// While a run goes on: the fitted experiments of the model as it is given, with the best values so far; null:
    /// none.
    void setLiveTraces(std::optional<SimulatedTraces> traces, RunKind of = RunKind::Fit);
    const SimulatedTraces* liveTraces() const { return live_ ? &*live_ : nullptr; }
    RunKind liveKind() const { return liveKind_; }
    /// What the traces would be with something that is only looked at.
    struct Preview {
        QString name;
        SimulatedTraces traces;
    };
    void setPreview(std::optional<Preview> preview);
    const Preview* preview() const { return preview_ ? &*preview_ : nullptr; }
    /// Two runs of the history whose traces are held against each other; null: none. They stay as they were, whatever
    /// becomes of the study. Where more are compared, those of the first and of the last.
    struct RunPair {
        RunRecord first, second;
    };
    void compareRuns(std::optional<RunPair> pair);
    const RunPair* comparedRuns() const { return compared_ ? &*compared_ : nullptr; }
    /// Changes whenever the traces to show do.
    unsigned long tracesVersion() const { return 2 * tracesVersion_ + (isResultStale() ? 1 : 0); }

    /// Every run of this study, oldest first; later edits do not touch them. Kept in the project file.
    const std::vector<RunRecord>& history() const { return history_; }
    const RunRecord* run(unsigned long number) const;  // null: it is not kept any more
    /// The run whose result is shown; 0: none.
    unsigned long shownRun() const { return shownRun_; }
    /// What the user calls a run and says of it.
    void describeRun(unsigned long number, const QString& name, const QString& note);
    /// False: as many are pinned as a study keeps.
    bool pinRun(unsigned long number, bool isPinned);
    std::vector<PastRun> pastRuns() const;

    /// Recordings with a fault, which the last run or simulation did without.
    void setLeftOut(std::vector<FaultyRecording> recordings);
    /// Why a recording was left out; null: it was not.
    const FaultyRecording* leftOut(const std::string& recording) const;

    void setRunMessages(Diagnostics messages);
    /// What the examination of the study says, as every command does before it works on it.
    void setCheckMessages(const Diagnostics& messages) { setMessages(Message::Origin::Check, messages); }
    const std::vector<Message>& messages() const { return messages_; }

Q_SIGNALS:
    void readingChanged();
    void opened();         // another study; everything below has changed
    void modelChanged();   // text and diagram
    void levelsChanged();  // another diagram of the same model
    void factsChanged();
    void parametersChanged();  // the study's own settings of parameters
    void experimentsChanged();
    void plotsChanged();  // what is said of plots of signals in the study
    void saved(bool isDone);
    void modifiedChanged();
    void resultChanged();
    void historyChanged();     // what is said of runs
    void liveTracesChanged();  // or the preview
    void comparisonChanged();
    void messagesChanged();
    void leftOutChanged();

private:
    friend class TextCommand;
    friend class StudyCommand;
    struct Opened;
    void show(Opened opened);
    /// `library`: that of the study, where it has been read already.
    void adoptStudy(Study study, std::shared_ptr<const TemporaryDirectory> files, const QString& path,
                    const std::vector<PastRun>& history = {}, std::optional<Outcome<Library>> library = {});
    void adopt(const Study& completed, const QString& what);
    void takeHistory(const std::vector<PastRun>& history);
    void showRun(const RunRecord& record);
    void keepPlots();
    void keepNewRun();
    void settingsChanged() { ++revision_; }
    /// But for what is shown of it.
    bool isSameStudy(const StudySettings& settings) const;
    void readModel();  // library and diagram from the texts
    void takeLibrary(Outcome<Library> library);
    void readDiagram();
    const LibraryClass* ownClass(const LibraryClass& owner, const std::string& component) const;
    void collectPrefixes(const LibraryClass& cls, const std::string& prefix, std::vector<std::string>& found) const;
    void modelTextChanged();
    void setMessages(Message::Origin origin, const Diagnostics& diagnostics);
    void setModelMessages(const Diagnostics& diagnostics);

    std::optional<Study> study_;
    Library library_;
    Diagram diagram_;
    std::string shownClass_;
    std::vector<std::string> levels_;
    ModelFacts facts_;
    Diagnostics modelFaults_;  // found while reading the diagram
    std::optional<Diagnostic> modelError_;
    std::shared_ptr<const ModelState> simulated_;
    std::shared_ptr<const ModelState> measured_;  // recordings alone, as long as nothing can be simulated
    std::optional<SimulatedTraces> live_;
    std::optional<Preview> preview_;
    std::shared_ptr<const RunResult> result_;
    std::vector<RunRecord> history_;
    std::optional<RunPair> compared_;
    std::optional<Study> resultStudy_;  // the study the result was computed for
    std::shared_ptr<const ModelState> beforeFit_;
    RunKind resultKind_{RunKind::Simulate};
    std::vector<Message> messages_;
    std::vector<FaultyRecording> leftOut_;
    unsigned long revision_{}, tracesVersion_{};
    QUndoStack undo_;
    QString path_;
    QString recoveredFrom_;  // the copy that was opened, until its work is saved
    unsigned long runs_{}, shownRun_{}, saidOfRuns_{};
    bool hasNewRuns_{};                                // that are in no file yet
    std::shared_ptr<const TemporaryDirectory> files_;  // of an unpacked archive, as long as the study is open
    QTimer analysisDelay_;
    JobRunner reader_;
    JobRunner analyser_;
    JobRunner saver_;
    RunKind liveKind_{};  // that of live_
};

}  // namespace analogon::ui
