#include "ui/signals/signal_list.hpp"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include "core/study/recorded.hpp"
#include "ui/document/document.hpp"
#include "ui/style/sought_words.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr std::array<const char*, 5> kindNames{"recorded", "variable", "residual", "derived", "sensitivity"};

QString tr(const char* text) { return QCoreApplication::translate("SignalList", text); }

QString of(const std::string& text) { return QString::fromStdString(text); }

/// Of "drive.rotor.phi" what is before the last dot outside of brackets; empty: the model's own.
QString componentOf(const QString& name) { return name.left(std::max<qsizetype>(0, name.lastIndexOf('.'))); }

void add(std::vector<Signal>& all, Signal signal) {
    signal.words =
        (signal.reference.name + ' ' + signal.unit + ' ' + signal.description + ' ' + signal.group).toLower();
    all.push_back(std::move(signal));
}

/// What a channel is used for by its recording: "current → i_mod".
QString useOf(const StudyExperiment& experiment, const std::string& column) {
    for (const auto* mappings : {&experiment.outputs, &experiment.inputs})
        for (const auto& [signal, mapping] : *mappings)
            if (mapping.column == column)
                return (mappings == &experiment.outputs ? tr("measured output %1") : tr("input %1")).arg(of(signal));
    return tr("not used by the model");
}

void addChannels(std::vector<Signal>& all, const Study& study) {
    for (const StudyExperiment& experiment : study.experiments) {
        const std::shared_ptr<const Table> file = fileTable(study.tables, experiment);
        if (!file) continue;
        std::set<std::string> listed;  // of a name that two groups have, the first
        const auto list = [&](const Table& table) {
            for (const Column& column : table.columns)
                if (column.name != experiment.timeColumn && listed.insert(column.name).second)
                    add(all, {{SignalKind::Recorded, of(experiment.name), of(column.name)},
                              of(experiment.name),
                              of(column.unit),
                              useOf(experiment, column.name),
                              {}});
        };
        list(*file);
        for (const std::shared_ptr<const Table>& other : file->others) list(*other);
    }
}

void addSensitivities(std::vector<Signal>& all, const Document& document) {
    const Study& study = document.study();
    for (const StudyExperiment& experiment : study.experiments) {
        if (experiment.role != Role::Fit || !experiment.isUsed) continue;
        for (const auto& [output, mapping] : experiment.outputs)
            for (const auto& [parameter, setting] : study.parameters)
                if (setting.fit)
                    add(all, {{SignalKind::Sensitivity, of(experiment.name), sensitivityName(output, parameter)},
                              tr("Sensitivities"),
                              of(unitOf(document.facts().outputs, output)),
                              tr("how far %1 moves per relative change of %2, %3")
                                  .arg(of(output), of(parameter), of(experiment.name)),
                              {}});
    }
}

void addVariables(std::vector<Signal>& all, const ModelFacts& facts) {
    std::vector<Signal> variables;
    for (const SignalFact& fact : facts.variables) {
        const QString name = of(fact.name), component = componentOf(name);
        add(variables, {{SignalKind::Variable, {}, name},
                        component.isEmpty() ? tr("Model") : component,
                        of(fact.unit),
                        libraryText(fact.description),
                        {}});
    }
    std::stable_sort(variables.begin(), variables.end(), [](const Signal& a, const Signal& b) {
        const bool isOwnA = !a.reference.name.contains('.'), isOwnB = !b.reference.name.contains('.');
        return isOwnA != isOwnB ? isOwnA : a.group < b.group;
    });
    all.insert(all.end(), std::make_move_iterator(variables.begin()), std::make_move_iterator(variables.end()));
}

}  // namespace

QString SignalRef::key() const {
    return QString::fromLatin1(kindNames[static_cast<std::size_t>(kind)]) + '\n' + recording + '\n' + name;
}

QJsonObject SignalRef::json() const {
    return {{"kind", kindNames[static_cast<std::size_t>(kind)]}, {"recording", recording}, {"name", name}};
}

SignalRef SignalRef::of(const QJsonObject& json) {
    const std::string kind = json.value("kind").toString().toStdString();
    const auto found = std::find(kindNames.begin(), kindNames.end(), kind);
    if (found == kindNames.end()) return {};
    return {static_cast<SignalKind>(found - kindNames.begin()), json.value("recording").toString(),
            json.value("name").toString()};
}

QString sensitivityName(const std::string& output, const std::string& parameter) {
    return QStringLiteral("∂%1/∂ln %2").arg(of(output), of(parameter));
}

QString sensitiveOutput(const QString& name) {
    const qsizetype end = name.indexOf(QStringLiteral("/∂ln "));
    return name.startsWith(u'∂') && end > 0 ? name.sliced(1, end - 1) : QString();
}

QByteArray mimeOf(const std::vector<SignalRef>& references) {
    QJsonArray list;
    for (const SignalRef& reference : references) list.append(reference.json());
    return QJsonDocument(list).toJson(QJsonDocument::Compact);
}

std::vector<SignalRef> signalsOf(const QByteArray& mime) {
    std::vector<SignalRef> references;
    const QJsonArray list = QJsonDocument::fromJson(mime).array();
    for (const auto& entry : list)
        if (SignalRef reference = SignalRef::of(entry.toObject()); !reference.name.isEmpty())
            references.push_back(std::move(reference));
    return references;
}

std::vector<Signal> allSignals(const Document& document, const std::vector<QString>& formulas) {
    std::vector<Signal> all;
    if (!document.isOpen()) return all;
    const Study& study = document.study();
    addChannels(all, study);
    for (const QString& formula : formulas)
        add(all, {{SignalKind::Derived, {}, formula}, tr("Formulas"), {}, tr("worked out from other signals"), {}});
    for (const StudyExperiment& experiment : study.experiments)
        for (const auto& [output, mapping] : experiment.outputs)
            add(all, {{SignalKind::Residual, of(experiment.name), of(output)},
                      tr("Residuals"),
                      of(unitOf(document.facts().outputs, output)),
                      tr("measured less simulated, %1").arg(of(experiment.name)),
                      {}});
    addSensitivities(all, document);
    addVariables(all, document.facts());
    return all;
}

std::vector<int> matching(const std::vector<Signal>& all, const QString& query) {
    std::vector<int> found;
    const style::SoughtWords sought(query);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (sought.areIn(all[i].words)) found.push_back(static_cast<int>(i));
    return found;
}

}  // namespace analogon::ui
