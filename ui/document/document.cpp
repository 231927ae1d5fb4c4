#include "ui/document/document.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/fit/clock.hpp"
#include "core/study/recorded.hpp"
#include "core/syntax/printer.hpp"
#include "ui/document/same_study.hpp"

namespace analogon::ui {

struct Document::Opened {
    Outcome<OpenedStudy> study;
    QString path;
    QString recoveredFrom;
    std::optional<Outcome<Library>> library;

    static Opened failed(const Diagnostic& fault) { return {fault, {}, {}, {}}; }
};

Document::Document(QObject* parent) : QObject(parent) {
    connect(&reader_, &JobRunner::started, this, &Document::readingChanged);
    connect(&reader_, &JobRunner::finished, this, &Document::readingChanged);
    connect(&analyser_, &JobRunner::failed, this, [this](const Diagnostic& fault) { setModelMessages({fault}); });
    connect(&undo_, &QUndoStack::cleanChanged, this, &Document::modifiedChanged);
    // Typing and dragging change the text many times a second: the model is analysed once they pause.
    analysisDelay_.setSingleShot(true);
    analysisDelay_.setInterval(60);
    connect(&analysisDelay_, &QTimer::timeout, this, [this] {
        analyser_.start<ModelFacts>(
            tr("Analysing the model"), [study = *study_](const Progress&) { return modelFacts(study); },
            [this](ModelFacts facts) {
                facts_ = std::move(facts);
                setModelMessages(modelFaults_.empty() ? facts_.messages : modelFaults_);
                Q_EMIT factsChanged();
            });
    });
}

/// Its undo stack tells once more that it is clean: by then the window that owns the document is half gone.
Document::~Document() { blockSignals(true); }

namespace {

/// The block library is parsed once a process, and the texts of a study take their time: on another thread, and not on
/// that of the screen.
template <class Opened>
Opened withLibrary(Outcome<OpenedStudy> study) {
    Opened read{std::move(study), {}, {}, {}};
    if (read.study) read.library = studyLibrary(read.study->study);
    return read;
}

}  // namespace

void Document::open(const QString& path) {
    const std::filesystem::path file = path.toStdString();
    reader_.start<Opened>(
        tr("Reading %1").arg(QString::fromStdString(file.filename().string())),
        [file](const Progress&) { return withLibrary<Opened>(openStudy(file, UnreadMeasurement::Kept)); },
        [this, path](Opened read) {
            read.path = path;
            show(std::move(read));
        });
}

void Document::openRecovered(const QString& recovery, const QString& path) {
    const std::filesystem::path file = recovery.toStdString();
    reader_.start<Opened>(
        tr("Reading what was recovered"),
        [file](const Progress&) { return withLibrary<Opened>(openStudy(file, UnreadMeasurement::Kept)); },
        [this, recovery, path](Opened read) {
            read.path = path;
            read.recoveredFrom = recovery;
            show(std::move(read));
        });
}

void Document::show(Opened read) {
    setMessages(Message::Origin::Study, read.study.diagnostics());
    if (!read.study) return;  // a study that is open stays
    if (!read.recoveredFrom.isEmpty() && !read.path.isEmpty())
        read.study->study.name = std::filesystem::path(read.path.toStdString()).stem().string();
    recoveredFrom_ = read.recoveredFrom;
    adoptStudy(std::move(read.study->study), read.study->files, read.path, read.study->history,
               std::move(read.library));
}

void Document::startNew(const QString& suggested) {
    Study study;
    study.name = suggested.toStdString();
    study.className = "Model";
    study.models[study.modelFile] =
        "model Model\n  annotation (Diagram(coordinateSystem(extent={{-160,-100},{160,100}})));\nend Model;\n";
    reader_.drop();
    recoveredFrom_.clear();
    setMessages(Message::Origin::Study, {});
    adoptStudy(std::move(study), nullptr, {});
}

void Document::startWith(Study study, Diagnostics remarks) {
    const QString what = tr("Reading %1").arg(QString::fromStdString(study.name));
    reader_.start<Opened>(
        what,
        [study = std::move(study), remarks = std::move(remarks)](const Progress&) {
            return withLibrary<Opened>(Outcome<OpenedStudy>(OpenedStudy{study, nullptr, {}}, remarks));
        },
        [this](Opened read) { show(std::move(read)); });
}

void Document::adoptStudy(Study study, std::shared_ptr<const TemporaryDirectory> files, const QString& path,
                          const std::vector<PastRun>& history, std::optional<Outcome<Library>> library) {
    study_ = std::move(study);
    files_ = std::move(files);
    path_ = path;
    levels_.clear();
    undo_.clear();
    simulated_.reset();
    measured_.reset();
    live_.reset();
    preview_.reset();
    result_.reset();
    compared_.reset();
    resultStudy_.reset();
    beforeFit_.reset();
    takeHistory(history);
    facts_ = {};
    modelError_.reset();
    setMessages(Message::Origin::Check, {});
    setMessages(Message::Origin::Run, {});
    ++revision_;
    ++tracesVersion_;
    if (library)
        takeLibrary(std::move(*library));
    else
        readModel();
    Q_EMIT opened();
    Q_EMIT modelChanged();
    Q_EMIT parametersChanged();
    Q_EMIT experimentsChanged();
    Q_EMIT plotsChanged();
    Q_EMIT resultChanged();
    Q_EMIT modifiedChanged();
}

void Document::save(const QString& path) {
    if (!isOpen()) return;
    const std::filesystem::path file = path.toStdString();
    const int index = undo_.index();
    saver_.start<Outcome<Done>>(
        tr("Saving"),
        [study = *study_, history = pastRuns(), file](const Progress&) { return saveStudy(study, file, history); },
        [this, path, index, runs = runs_ + saidOfRuns_](Outcome<Done> done) {
            setRunMessages(done.diagnostics());
            if (done) {
                path_ = path;
                recoveredFrom_.clear();
                study_->name = std::filesystem::path(path.toStdString()).stem().string();
                if (undo_.index() == index) undo_.setClean();
                if (runs_ + saidOfRuns_ == runs) hasNewRuns_ = false;
                Q_EMIT modifiedChanged();
            }
            Q_EMIT saved(done.hasValue());
        });
}

bool Document::isSameStudy(const StudySettings& settings) const {
    const auto readings = [](const auto& experiments) {  // of which a model knows nothing
        std::string text;
        for (const StudyExperiment& e : experiments) text += readText(e.read) + tableKey(e) + '\n';
        return text;
    };
    return isSameModel(*study_, settings) && study_->modelFile == settings.modelFile &&
           study_->tables == settings.tables && readings(study_->experiments) == readings(settings.experiments);
}

QString Document::title() const { return isOpen() ? QString::fromStdString(study_->name) : QString(); }

QString Document::modelText() const {
    if (!isOpen()) return {};
    const auto found = study_->models.find(study_->modelFile);
    return found == study_->models.end() ? QString() : QString::fromStdString(found->second);
}

const syntax::ClassDefinition* Document::definition() const {
    const LibraryClass* cls = isOpen() ? library_.find(shownClass_) : nullptr;
    return cls ? cls->definition.get() : nullptr;
}

void Document::readModel() { takeLibrary(studyLibrary(*study_)); }

void Document::takeLibrary(Outcome<Library> library) {
    modelFaults_ = library.diagnostics();
    diagram_ = {};
    library_ = {};
    if (library) {
        library_ = std::move(*library);
        readDiagram();
    }
    // What the analysis found stands until the next one: else an error would come and go with every edit.
    if (hasError(modelFaults_))
        setModelMessages(modelFaults_);
    else
        setMessages(Message::Origin::Model, modelFaults_);
    if (library) analysisDelay_.start();
}

/// The class a component of this owner is of, when it stands in the same text.
const LibraryClass* Document::ownClass(const LibraryClass& owner, const std::string& component) const {
    using Restriction = syntax::ClassDefinition::Restriction;
    for (const syntax::Component& c : owner.definition->components) {
        if (c.name != component) continue;
        const LibraryClass* cls = library_.lookup(c.type, owner.qualifiedName);
        const bool isOwn = cls && cls->definition->source == owner.definition->source;
        return isOwn && cls->definition->restriction == Restriction::Model ? cls : nullptr;
    }
    return nullptr;
}

/// Of the level one is at; what is gone (by undo, say) is left.
void Document::readDiagram() {
    shownClass_ = study_->className;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
        const LibraryClass* owner = library_.find(shownClass_);
        const LibraryClass* inner = owner ? ownClass(*owner, levels_[i]) : nullptr;
        if (!inner) {
            levels_.resize(i);
            break;
        }
        shownClass_ = inner->qualifiedName;
    }
    Outcome<Diagram> diagram = analogon::readDiagram(library_, shownClass_);
    for (const Diagnostic& d : diagram.diagnostics()) modelFaults_.push_back(d);
    diagram_ = diagram ? std::move(*diagram) : Diagram{};
}

bool Document::canEnter(const std::string& block) const {
    const LibraryClass* owner = isOpen() ? library_.find(shownClass_) : nullptr;
    return owner && ownClass(*owner, block);
}

void Document::enter(const std::string& block) {
    if (!canEnter(block)) return;
    levels_.push_back(block);
    readDiagram();
    Q_EMIT levelsChanged();
}

void Document::leaveTo(std::size_t depth) {
    if (depth >= levels_.size()) return;
    levels_.resize(depth);
    if (definition()) readDiagram();
    Q_EMIT levelsChanged();
}

void Document::collectPrefixes(const LibraryClass& cls, const std::string& prefix,
                               std::vector<std::string>& found) const {
    constexpr auto deepest = 20;  // a class that holds itself has no end
    if (cls.qualifiedName == shownClass_) found.push_back(prefix);
    if (std::count(prefix.begin(), prefix.end(), '.') > deepest) return;
    for (const syntax::Component& c : cls.definition->components)
        if (const LibraryClass* inner = ownClass(cls, c.name)) collectPrefixes(*inner, prefix + c.name + ".", found);
}

std::vector<std::string> Document::prefixes() const {
    std::vector<std::string> found;
    if (const LibraryClass* model = isOpen() ? library_.find(study_->className) : nullptr)
        collectPrefixes(*model, {}, found);
    return found;
}

void Document::modelTextChanged() {
    ++revision_;
    readModel();
    Q_EMIT modelChanged();
}

void Document::applyEdit(syntax::TextEdit edit) {
    if (isOpen() && !edit.replacements.empty()) undo_.push(new TextCommand(*this, std::move(edit)));
}

void Document::typeText(const QString& text) {
    if (!isOpen()) return;
    const std::string now = modelText().toStdString(), typed = text.toStdString();
    const std::size_t shorter = std::min(now.size(), typed.size());
    std::size_t front = 0, back = 0;
    while (front < shorter && now[front] == typed[front]) ++front;
    while (back < shorter - front && now[now.size() - 1 - back] == typed[typed.size() - 1 - back]) ++back;
    if (front == now.size() && front == typed.size()) return;
    syntax::TextEdit edit;
    edit.what = tr("Type").toStdString();
    edit.replacements.push_back({static_cast<std::uint32_t>(front), static_cast<std::uint32_t>(now.size() - back),
                                 typed.substr(front, typed.size() - back - front)});
    undo_.push(new TextCommand(*this, std::move(edit), true));
}

void Document::applySettings(StudySettings settings, const QString& what) {
    if (isOpen()) undo_.push(new StudyCommand(*this, std::move(settings), what));
}

void Document::applyBoth(syntax::TextEdit edit, StudySettings settings) {
    if (!isOpen()) return;
    const QString what = QString::fromStdString(edit.what);
    std::string& text = settings.models[settings.modelFile];
    text = syntax::apply(text, std::move(edit)).text;
    applySettings(std::move(settings), what);
}

void Document::setParameterValue(const std::string& name, double value) {
    setParameterValues({{name, value}}, tr("Set %1").arg(QString::fromStdString(name)));
}

bool Document::setParameterValues(const std::vector<std::pair<std::string, double>>& values, const QString& what) {
    if (!isOpen()) return false;
    StudySettings changed = settings();
    const LibraryClass* model = library_.find(study_->className);
    std::optional<ModelEdit> edit;
    bool isInSettings = false;
    for (const auto& [name, value] : values) {
        const auto own = study_->parameters.find(name);
        const bool isOwn = own != study_->parameters.end();
        // No model has a clock, and a text that cannot be read takes nothing.
        if (isClock(name) || !model || (isOwn && own->second.value)) {
            StudyParameter& setting = changed.parameters[name];
            setting.fit = setting.fit && (isOwn || isClock(name));
            setting.value = value;
            isInSettings = true;
        } else {
            if (!edit) edit.emplace(*model->definition, nullptr, &library());
            edit->setParameter(name, syntax::printNumber(value));
        }
    }
    if (!edit) {
        applySettings(std::move(changed), what);
        return true;
    }
    Outcome<syntax::TextEdit> text = edit->finish(what.toStdString());
    if (!text) {
        setRunMessages(text.diagnostics());
        return false;
    }
    if (isInSettings)
        applyBoth(std::move(*text), std::move(changed));
    else
        applyEdit(std::move(*text));
    return true;
}

void Document::setStudyParameter(const std::string& name, const StudyParameter& parameter, const QString& what) {
    StudySettings changed = settings();
    changed.parameters[name] = parameter;
    applySettings(std::move(changed), what);
}

std::optional<double> Document::parameterValue(const std::string& name) const {
    if (!isOpen()) return std::nullopt;
    const auto own = study_->parameters.find(name);
    if (own != study_->parameters.end() && own->second.value) return own->second.value;
    for (const ParameterFact& fact : facts_.parameters)
        if (fact.name == name) return fact.value;
    if (isClock(name)) return 0.0;
    return std::nullopt;
}

void Document::setLeftOut(std::vector<FaultyRecording> recordings) {
    if (recordings.empty() && leftOut_.empty()) return;
    leftOut_ = std::move(recordings);
    Q_EMIT leftOutChanged();
}

const FaultyRecording* Document::leftOut(const std::string& recording) const {
    const auto known = std::find_if(leftOut_.begin(), leftOut_.end(),
                                    [&](const FaultyRecording& faulty) { return faulty.name == recording; });
    return known == leftOut_.end() ? nullptr : &*known;
}

bool Document::canRun() const {
    return isOpen() && std::any_of(study_->experiments.begin(), study_->experiments.end(),
                                   [](const StudyExperiment& e) { return e.isUsed && !e.outputs.empty(); });
}

void Document::setRunMessages(Diagnostics messages) { setMessages(Message::Origin::Run, messages); }

void Document::setModelMessages(const Diagnostics& diagnostics) {
    const auto error = std::find_if(diagnostics.begin(), diagnostics.end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::Error; });
    modelError_ = error == diagnostics.end() ? std::nullopt : std::optional(*error);
    setMessages(Message::Origin::Model, diagnostics);
}

void Document::setMessages(Message::Origin origin, const Diagnostics& diagnostics) {
    std::erase_if(messages_, [origin](const Message& m) { return m.origin == origin; });
    Diagnostics named = diagnostics;
    if (isOpen() && files_) named = namedAs(std::move(named), OpenedStudy{{}, files_, path_.toStdString()});
    for (Diagnostic& d : named) messages_.push_back({origin, std::move(d)});
    Q_EMIT messagesChanged();
}

}  // namespace analogon::ui
