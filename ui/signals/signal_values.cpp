#include "ui/signals/signal_values.hpp"

#include <algorithm>
#include <utility>

#include "core/measure/channel.hpp"
#include "core/signal/formula.hpp"
#include "core/study/free_run.hpp"
#include "core/study/recorded.hpp"
#include "core/study/variable_values.hpp"
#include "ui/document/document.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

std::shared_ptr<const std::vector<double>> shared(std::vector<double> values) {
    return std::make_shared<const std::vector<double>>(std::move(values));
}

SignalData faulty(const Diagnostics& faults) {
    SignalData data;
    if (!faults.empty()) {
        data.fault = inWords(faults.front().message);
        if (!faults.front().hint.empty()) data.fault += ". " + inWords(faults.front().hint);
    }
    return data;
}

const StudyExperiment* experimentNamed(const Study& study, const QString& name) {
    for (const StudyExperiment& e : study.experiments)
        if (QString::fromStdString(e.name) == name) return &e;
    return nullptr;
}

/// A channel as it was recorded, in its own unit.
SignalData recorded(const Study& study, const SignalRef& reference) {
    const StudyExperiment* found = experimentNamed(study, reference.recording);
    if (!found) return faulty({error(phrase("the study has no experiment {}", reference.recording.toStdString()))});
    StudyExperiment experiment = *found;
    findTime(study.tables, experiment);
    const std::string name = reference.name.toStdString();
    const std::shared_ptr<const Table> whole = fileTable(study.tables, experiment);
    std::shared_ptr<const Table> table = shownTable(study.tables, experiment);
    if (!table) table = whole;
    if (!table) return faulty({error(phrase("the file of {} was not read", experiment.name))});
    const Column* column = table->find(name);
    if (!column || column->values.empty())
        return faulty({error(phrase("{} was not read from its file", name), {},
                             phrase("Map it to an input or an output of the model."))});
    const Outcome<std::vector<double>> time = readTime(*table, experiment.timeColumn);
    if (!time) return faulty(time.diagnostics());
    SignalData data;
    data.time = shared(*time);
    data.values = Series(table, column->values);
    data.unit = QString::fromStdString(column->unit);
    return data;
}

/// One parameter's share of an output, out of those of all.
SignalData sensitive(const std::shared_ptr<const Outcome<Sensitivity>>& found, const SignalRef& reference) {
    if (!*found) return faulty(found->diagnostics());
    const Sensitivity& all = **found;
    for (const OutputSensitivity& output : all.outputs) {
        if (QString::fromStdString(output.experiment) != reference.recording) continue;
        for (std::size_t p = 0; p < all.parameters.size(); ++p) {
            if (sensitivityName(output.output, all.parameters[p]) != reference.name) continue;
            const auto column = static_cast<Eigen::Index>(p);
            const auto values = std::make_shared<Eigen::VectorXd>(output.slopes.col(column) * all.values[column]);
            const std::span<const double> seen(values->data(), static_cast<std::size_t>(values->size()));
            return {std::shared_ptr<const std::vector<double>>(found, &output.time),
                    Series(values, seen),
                    QString::fromStdString(output.unit),
                    {}};
        }
    }
    return faulty({error(phrase("no parameter is fitted"))});
}

}  // namespace

SignalData SignalData::failed(const Diagnostic& fault) { return faulty({fault}); }

SignalValues::SignalValues(Document& document, QObject* parent) : QObject(parent), document_(document) {
    const auto modelMoves = [this] { forget([](SignalKind kind) { return kind != SignalKind::Recorded; }); };
    connect(&document, &Document::factsChanged, this, modelMoves);
    connect(&document, &Document::parametersChanged, this, modelMoves);
    connect(&document, &Document::experimentsChanged, this, [this] { forget([](SignalKind) { return true; }); });
    connect(&document, &Document::opened, this, [this] { forget([](SignalKind) { return true; }); });
    connect(&document, &Document::resultChanged, this, [this] {
        forget([](SignalKind kind) {
            return kind != SignalKind::Recorded && kind != SignalKind::Variable;  // these depend on no fit
        });
    });
}

void SignalValues::forget(const std::function<bool(SignalKind)>& isOld) {
    const auto kindOf = [](const QString& key) {
        for (const SignalKind kind :
             {SignalKind::Recorded, SignalKind::Variable, SignalKind::Residual, SignalKind::Sensitivity})
            if (key.startsWith(SignalRef{kind, {}, {}}.key().section('\n', 0, 0))) return kind;
        return SignalKind::Derived;
    };
    reader_.drop();
    wanted_.clear();
    if (isOld(SignalKind::Variable)) {
        simulator_.drop();
        variables_.clear();
    }
    if (isOld(SignalKind::Sensitivity)) {
        differentiator_.drop();
        sensitivities_.clear();
        slopes_.reset();
    }
    std::erase_if(known_, [&](const auto& entry) { return isOld(kindOf(entry.first)); });
    std::erase_if(underWay_, [&](const QString& key) {
        const SignalKind kind = kindOf(key);
        return isOld(kind) || (kind != SignalKind::Variable && kind != SignalKind::Sensitivity);
    });
    Q_EMIT outdated();
}

void SignalValues::keep(const SignalRef& reference, SignalData data) {
    underWay_.erase(reference.key());
    known_[reference.key()] = std::make_shared<const SignalData>(std::move(data));
}

std::shared_ptr<const SignalData> SignalValues::at(const SignalRef& reference) {
    if (!document_.isOpen()) return nullptr;
    if (const auto found = known_.find(reference.key()); found != known_.end()) return found->second;
    if (reference.kind == SignalKind::Residual) {
        if (std::optional<SignalData> data = residual(reference)) keep(reference, std::move(*data));
        const auto found = known_.find(reference.key());
        return found == known_.end() ? nullptr : found->second;
    }
    if (!underWay_.insert(reference.key()).second) return nullptr;
    if (reference.kind == SignalKind::Variable)
        variables_[reference.recording].insert(reference.name);
    else if (reference.kind == SignalKind::Sensitivity)
        sensitivities_.push_back(reference);
    else
        wanted_.push_back(reference);
    QMetaObject::invokeMethod(this, &SignalValues::work, Qt::QueuedConnection);
    return nullptr;
}

std::optional<SignalData> SignalValues::residual(const SignalRef& reference) const {
    std::shared_ptr<const ModelState> state = document_.after();
    if (!state) state = document_.before();
    if (!state) return std::nullopt;
    for (const ExperimentState& experiment : state->experiments) {
        if (QString::fromStdString(experiment.name) != reference.recording) continue;
        for (const OutputState& output : experiment.outputs) {
            if (QString::fromStdString(output.name) != reference.name) continue;
            const auto part = [&](const Eigen::VectorXd& values) {
                return Series(state, {values.data(), static_cast<std::size_t>(values.size())});
            };
            return SignalData{std::shared_ptr<const std::vector<double>>(state, &experiment.time),
                              residualOf(part(output.measured), part(output.simulated)),
                              QString::fromStdString(output.unit),
                              {}};
        }
    }
    return SignalData{nullptr, {}, {}, tr("Nothing is simulated of this output.")};
}

void SignalValues::work() {
    if (!document_.isOpen()) return;
    if (!reader_.isBusy()) startReading();
    if (!simulator_.isBusy() && !variables_.empty()) startSimulation();
    if (!differentiator_.isBusy() && !sensitivities_.empty()) startSensitivities();
}

void SignalValues::startReading() {
    for (auto next = wanted_.begin(); next != wanted_.end(); ++next) {
        const SignalRef reference = *next;
        std::function<SignalData()> read;
        if (reference.kind == SignalKind::Recorded) {
            read = [study = document_.study(), reference] { return recorded(study, reference); };
        } else {
            std::optional<std::function<SignalData()>> derived = derivation(reference);
            if (!derived) {
                next = std::find(wanted_.begin(), wanted_.end(), reference);  // what it uses may stand behind it now
                continue;
            }
            read = std::move(*derived);
        }
        std::erase(wanted_, reference);
        return reader_.start<SignalData>(
            tr("Reading %1").arg(reference.name), [read = std::move(read)](const Progress&) { return read(); },
            [this, reference](SignalData data) {
                keep(reference, std::move(data));
                Q_EMIT arrived();
                QMetaObject::invokeMethod(this, &SignalValues::work, Qt::QueuedConnection);
            });
    }
}

void SignalValues::startSimulation() {
    const auto [recording, asked] = *variables_.begin();
    variables_.erase(variables_.begin());
    std::vector<std::string> names;
    for (const QString& name : asked) names.push_back(name.toStdString());
    ++simulations_;
    simulator_.start<Outcome<VariableValues>>(
        tr("Simulating %1").arg(recording),
        [study = document_.study(), recording = recording.toStdString(), names](const Progress& progress) {
            const bool isFree = recording == freeRunName(study);
            return isFree ? freeVariableValues(study, {}, names, progress)
                          : variableValues(study, recording, names, progress);
        },
        [this, recording = recording, names](Outcome<VariableValues> result) {
            const auto time = result ? shared(std::move(result->time)) : nullptr;
            for (std::size_t i = 0; i < names.size(); ++i) {
                SignalData data = faulty(result.diagnostics());
                if (result)
                    data = {time,
                            Series(std::move(result->values[i])),
                            QString::fromStdString(unitOf(document_.facts().variables, names[i])),
                            {}};
                keep({SignalKind::Variable, recording, QString::fromStdString(names[i])}, std::move(data));
            }
            Q_EMIT arrived();
            QMetaObject::invokeMethod(this, &SignalValues::work, Qt::QueuedConnection);
        });
}

void SignalValues::startSensitivities() {
    const auto tell = [this] {
        for (const SignalRef& reference : std::exchange(sensitivities_, {}))
            keep(reference, sensitive(slopes_, reference));
        Q_EMIT arrived();
    };
    if (slopes_) return tell();
    const RunResult* result = document_.resultKind() == RunKind::Simulate ? nullptr : document_.result();
    differentiator_.start<Outcome<Sensitivity>>(
        tr("Sensitivities"),
        [study = result && document_.after() ? result->completed : document_.study()](const Progress& progress) {
            return sensitivityOf(study, progress);
        },
        [this, tell](Outcome<Sensitivity> found) {
            slopes_ = std::make_shared<const Outcome<Sensitivity>>(std::move(found));
            tell();
        });
}

SignalRef SignalValues::meant(const QString& name, const QString& recording) const {
    const std::vector<SignalFact>& variables = document_.facts().variables;
    const bool isVariable = std::any_of(variables.begin(), variables.end(),
                                        [&](const SignalFact& fact) { return fact.name == name.toStdString(); });
    return {isVariable ? SignalKind::Variable : SignalKind::Recorded, recording, name};
}

std::optional<std::function<SignalData()>> SignalValues::derivation(const SignalRef& reference) {
    Outcome<Formula> formula = Formula::parse(reference.name.toStdString());
    if (!formula || formula->names().empty())
        return [faults = formula ? Diagnostics{error(phrase("the formula uses no signal"))} : formula.diagnostics()] {
            return faulty(faults);
        };
    std::map<std::string, Data> operands;
    bool isWhole = true;
    for (const std::string& name : formula->names()) {
        operands[name] = at(meant(QString::fromStdString(name), reference.recording));
        isWhole = isWhole && operands[name];
    }
    if (!isWhole) return std::nullopt;
    return [formula = std::move(*formula), operands] {
        for (const auto& [name, data] : operands)
            if (!data->time) return SignalData{nullptr, {}, {}, data->fault};
        const auto time = operands.at(formula.names().front())->time;
        std::map<std::string, FormulaOperand> given;
        std::vector<std::vector<double>> resampled;
        resampled.reserve(operands.size());
        for (const auto& [name, data] : operands) {
            std::span<const double> values = data->values;
            if (*data->time != *time) {
                resampled.push_back(valuesAt(*data->time, values, *time));
                values = resampled.back();
            }
            given[name] = {data->unit.toStdString(), values};
        }
        Outcome<DerivedValues> derived = formula.evaluate(*time, given);
        if (!derived) return faulty(derived.diagnostics());
        return SignalData{time, Series(std::move(derived->values)), QString::fromStdString(derived->unit), {}};
    };
}

}  // namespace analogon::ui
