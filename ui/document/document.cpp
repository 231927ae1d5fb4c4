#include "ui/document/document.hpp"

#include <fmt/format.h>

#include "core/syntax/printer.hpp"
#include "ui/document/commands.hpp"

namespace analogon::ui {

namespace {

bool isSame(const StudyParameter& a, const StudyParameter& b) {
    return a.fit == b.fit && a.value == b.value && a.min == b.min && a.max == b.max && a.scale == b.scale;
}

bool isSameModel(const Study& a, const Study& b) {
    return a.models == b.models &&
           std::equal(a.parameters.begin(), a.parameters.end(), b.parameters.begin(), b.parameters.end(),
                      [](const auto& x, const auto& y) { return x.first == y.first && isSame(x.second, y.second); });
}

}  // namespace

struct Document::Opened {
    Outcome<Study> study;
};

Document::Document(QObject* parent) : QObject(parent) {
    connect(&reader_, &JobRunner::started, this, &Document::readingChanged);
    connect(&reader_, &JobRunner::finished, this, &Document::readingChanged);
}

Document::~Document() = default;

void Document::open(const QString& path) {
    const std::filesystem::path file = path.toStdString();
    reader_.start<Opened>(
        tr("Reading %1").arg(QString::fromStdString(file.filename().string())),
        [file](const Progress&) {
            Opened read{readStudy(file)};
            // The block library is parsed once a process: here, and not on the GUI thread.
            if (read.study) (void)builtInLibrary();
            return read;
        },
        [this](Opened read) { show(std::move(read)); });
}

void Document::show(Opened read) {
    setMessages(Message::Origin::Study, read.study.diagnostics());
    if (!read.study) return;  // a study that is open stays
    study_ = std::move(*read.study);
    undo_.clear();
    simulated_.reset();
    result_.reset();
    resultStudy_.reset();
    beforeFit_.reset();
    facts_ = {};
    setMessages(Message::Origin::Run, {});
    ++revision_;
    ++tracesVersion_;
    readModel();
    Q_EMIT opened();
    Q_EMIT modelChanged();
    Q_EMIT parametersChanged();
    Q_EMIT resultChanged();
}

QString Document::title() const { return isOpen() ? QString::fromStdString(study_->name) : QString(); }

QString Document::modelText() const {
    if (!isOpen()) return {};
    const auto found = study_->models.find(study_->modelFile);
    return found == study_->models.end() ? QString() : QString::fromStdString(found->second);
}

const syntax::ClassDefinition* Document::definition() const {
    const LibraryClass* cls = isOpen() ? library_.find(study_->className) : nullptr;
    return cls ? cls->definition.get() : nullptr;
}

void Document::readModel() {
    modelFaults_.clear();
    Outcome<Library> library = studyLibrary(*study_);
    modelFaults_ = library.diagnostics();
    diagram_ = {};
    library_ = {};
    if (library) {
        library_ = std::move(*library);
        Outcome<Diagram> diagram = readDiagram(library_, study_->className);
        for (const Diagnostic& d : diagram.diagnostics()) modelFaults_.push_back(d);
        if (diagram) diagram_ = std::move(*diagram);
    }
    setMessages(Message::Origin::Model, modelFaults_);
    if (!library) return;
    analyser_.start<ModelFacts>(
        tr("Analysing the model"), [study = *study_](const Progress&) { return modelFacts(study); },
        [this](ModelFacts facts) {
            facts_ = std::move(facts);
            setMessages(Message::Origin::Model, modelFaults_.empty() ? facts_.messages : modelFaults_);
            Q_EMIT factsChanged();
        });
}

void Document::modelTextChanged() {
    ++revision_;
    readModel();
    Q_EMIT modelChanged();
}

void Document::applyEdit(syntax::TextEdit edit) {
    if (isOpen() && !edit.replacements.empty()) undo_.push(new TextCommand(*this, std::move(edit)));
}

void Document::setParameterValue(const std::string& name, double value) {
    const auto own = study_->parameters.find(name);
    const QString what = tr("Set %1").arg(QString::fromStdString(name));
    if (own != study_->parameters.end() && own->second.value) {
        StudyParameter changed = own->second;
        changed.value = value;
        return setStudyParameter(name, changed, what);
    }
    if (!definition()) return;
    ModelEdit edit(*definition());
    edit.setParameter(name, syntax::printNumber(value));
    Outcome<syntax::TextEdit> text = edit.finish(what.toStdString());
    if (text)
        applyEdit(std::move(*text));
    else
        setRunMessages(text.diagnostics());
}

void Document::setStudyParameter(const std::string& name, const StudyParameter& parameter, const QString& what) {
    StudySettings settings{study_->models, study_->parameters};
    settings.parameters[name] = parameter;
    undo_.push(new StudyCommand(*this, std::move(settings), what));
}

void Document::adoptCompleted(const QString& what) {
    if (!result_ || isResultAdopted()) return;
    undo_.push(new StudyCommand(*this, {result_->completed.models, result_->completed.parameters}, what));
    Q_EMIT resultChanged();
}

std::optional<double> Document::parameterValue(const std::string& name) const {
    if (!isOpen()) return std::nullopt;
    const auto own = study_->parameters.find(name);
    if (own != study_->parameters.end() && own->second.value) return own->second.value;
    for (const ParameterFact& fact : facts_.parameters)
        if (fact.name == name) return fact.value;
    return std::nullopt;
}

void Document::setSimulated(ModelState state) {
    simulated_ = std::move(state);
    ++tracesVersion_;
    Q_EMIT resultChanged();
}

void Document::setResult(RunKind kind, RunResult result, const Study& ranOn) {
    beforeFit_ = simulated_;
    result_ = std::make_unique<RunResult>(std::move(result));
    resultStudy_ = ranOn;
    resultKind_ = kind;
    ++tracesVersion_;
    Q_EMIT resultChanged();
}

bool Document::isResultStale() const {
    return !result_ || !(isSameModel(*study_, *resultStudy_) || isSameModel(*study_, result_->completed));
}

bool Document::isResultAdopted() const { return result_ && isSameModel(*study_, result_->completed); }

const ModelState* Document::before() const {
    if (result_ && !isResultStale()) {
        if (resultKind_ == RunKind::Discover) return &result_->finding.baseline;
        return beforeFit_ ? &*beforeFit_ : nullptr;
    }
    return simulated_ ? &*simulated_ : nullptr;
}

const ModelState* Document::after() const {
    if (!result_ || isResultStale()) return nullptr;
    return &result_->finding.final;
}

void Document::setRunMessages(Diagnostics messages) { setMessages(Message::Origin::Run, messages); }

void Document::setMessages(Message::Origin origin, const Diagnostics& diagnostics) {
    std::erase_if(messages_, [origin](const Message& m) { return m.origin == origin; });
    for (const Diagnostic& d : diagnostics) messages_.push_back({origin, d});
    Q_EMIT messagesChanged();
}

}  // namespace analogon::ui
