#include "ui/measurement/recordings_model.hpp"

#include <QIcon>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/study/recorded.hpp"
#include "core/study/weight.hpp"
#include "ui/document/document.hpp"
#include "ui/measurement/locate.hpp"
#include "ui/measurement/mapping.hpp"
#include "ui/measurement/recording_edits.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

/// In percent of the range, or in the unit of an output that stands still.
QString errorText(const ErrorFigures& figures) {
    return figures.hasScale() ? style::fixedText(figures.errorPercent, 2) : style::numberText(figures.rmse, 3);
}

QStringList wordsOfFaults(const Diagnostics& faults) {
    QStringList words;
    for (const Diagnostic& fault : faults)
        if (fault.severity == Severity::Error) words << inWords(fault.message);
    words.removeDuplicates();
    return words;
}

QString stopText(const SimulationFailure& failure) {
    const QString text = RecordingsModel::tr("the simulation stops at %1 s").arg(style::numberText(failure.time, 4));
    return failure.cause.empty() ? text : text + QStringLiteral(": ") + inWords(failure.cause);
}

}  // namespace

RecordingsModel::RecordingsModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), document_(document) {
    for (auto signal : {&Document::opened, &Document::experimentsChanged, &Document::resultChanged,
                        &Document::leftOutChanged, &Document::factsChanged})
        connect(&document, signal, this, &RecordingsModel::follow);
    connect(&document, &Document::opened, this, [this] { extents_.clear(); });
}

void RecordingsModel::setShown(bool isShown) {
    isShown_ = isShown;
    if (isShown_ && isBehind_) refresh();
    if (isShown_ || !measurer_.isBusy()) return;
    measurer_.drop();  // its rows may be others by then
    isBehind_ = true;
}

void RecordingsModel::follow() {
    isBehind_ = true;
    if (isShown_) refresh();
}

int RecordingsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int RecordingsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : faultColumn() + 1; }

/// A table that is there says nothing of what the extent was worked out from but its name: files are read once.
std::string RecordingsModel::extentKey(const StudyExperiment& experiment) const {
    std::string key = tableKey(experiment) + '\n' + experiment.timeColumn + '\n';
    if (experiment.range)
        key += std::to_string(experiment.range->first) + ' ' + std::to_string(experiment.range->second);
    for (const auto& [output, mapping] : experiment.outputs) key += '\n' + mapping.column;
    return key;
}

RecordingsModel::Row RecordingsModel::rowOf(const StudyExperiment& experiment) const {
    Row row;
    row.name = experiment.name;
    row.path = experiment.file;
    row.file = QString::fromStdString(std::filesystem::path(experiment.file).filename().string());
    row.isUsed = experiment.isUsed;
    row.isFit = experiment.role == analogon::Role::Fit;
    row.isMissing = isUnread(document_.study(), experiment);
    for (const auto& [output, mapping] : experiment.outputs)
        row.weights = row.weights ? std::pair(std::min(row.weights->first, mapping.weight),
                                              std::max(row.weights->second, mapping.weight))
                                  : std::pair(mapping.weight, mapping.weight);
    const Tables& tables = document_.study().tables;
    if (const auto known = extents_.find(extentKey(experiment)); known != extents_.end())
        row.extent = known->second;
    else if (const auto table = fileTable(tables, experiment);
             table && !experiment.range && isAtHand(tables, experiment))
        row.extent = extentOf(*table, experiment);
    if (row.isMissing)
        row.fault = wordsOfFaults(document_.study().unread.at(tableKey(experiment)));
    else if (const FaultyRecording* const faulty = row.isUsed ? document_.leftOut(experiment.name) : nullptr)
        row.fault = wordsOfFaults(faulty->why);
    return row;
}

void RecordingsModel::readErrors(std::vector<Row>& rows) const {
    std::map<std::string, Row*> named;
    for (Row& row : rows) named[row.name] = &row;
    const auto read = [&](const std::shared_ptr<const ModelState>& state, bool isAfter) {
        if (!state) return;
        for (const ExperimentState& experiment : state->experiments) {
            const auto row = named.find(experiment.name);
            if (row == named.end()) continue;
            if (experiment.failure.failed) {
                row->second->failure = stopText(experiment.failure);
                continue;
            }
            for (const OutputState& output : experiment.outputs) {
                Error& error = row->second->errors[output.name];
                error.unit = output.unit;
                (isAfter ? error.after : error.before) = output.figures;
            }
        }
    };
    read(document_.before(), false);
    read(document_.after(), true);
}

void RecordingsModel::refresh() {
    isBehind_ = false;
    std::vector<Row> rows;
    std::set<std::string> outputs;
    if (document_.isOpen())
        for (const StudyExperiment& e : document_.study().experiments) {
            rows.push_back(rowOf(e));
            for (const auto& [output, mapping] : e.outputs) outputs.insert(output);
        }
    readErrors(rows);
    const std::vector<std::string> columns(outputs.begin(), outputs.end());
    const bool isSame = columns == outputs_ && std::equal(rows.begin(), rows.end(), rows_.begin(), rows_.end(),
                                                          [](const Row& a, const Row& b) { return a.name == b.name; });
    if (!isSame) beginResetModel();
    rows_ = std::move(rows);
    outputs_ = columns;
    if (!isSame)
        endResetModel();
    else if (!rows_.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    measureExtents();
}

/// Of those that are not there at once, beside the window.
void RecordingsModel::measureExtents() {
    std::vector<std::pair<std::string, StudyExperiment>> wanted;
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (const StudyExperiment& e = document_.study().experiments[i];
            !rows_[i].extent && !rows_[i].isMissing && fileTable(document_.study().tables, e))
            wanted.emplace_back(extentKey(e), e);
    if (wanted.empty()) return measurer_.drop();
    using Extents = std::map<std::string, RecordingExtent>;
    measurer_.start<Extents>(
        tr("Reading"),
        [wanted, tables = document_.study().tables](const Progress& progress) {
            Extents extents;
            for (const auto& [key, experiment] : wanted) {
                if (progress.stopRequested()) break;
                const auto table = shownTable(tables, experiment);
                extents[key] = table ? extentOf(*table, experiment) : RecordingExtent{};
            }
            return extents;
        },
        [this](const Extents& extents) {
            extents_.insert(extents.begin(), extents.end());
            for (std::size_t i = 0; i < rows_.size(); ++i)
                if (const auto known = extents_.find(extentKey(document_.study().experiments[i]));
                    known != extents_.end())
                    rows_[i].extent = known->second;
            if (!rows_.empty()) Q_EMIT dataChanged(index(0, samplesColumn()), index(rowCount() - 1, durationColumn()));
        });
}

const RecordingsModel::Error* RecordingsModel::errorOf(const Row& row, int column) const {
    if (column < FirstError || column >= samplesColumn()) return nullptr;
    const auto error = row.errors.find(outputs_[static_cast<std::size_t>(column - FirstError)]);
    return error == row.errors.end() ? nullptr : &error->second;
}

QVariant RecordingsModel::display(const Row& row, int column) const {
    switch (column) {
        case Name:
            return QString::fromStdString(row.name);
        case File:
            return row.file;
        case Role:
            return row.isFit ? tr("fit") : tr("validate");
        case Weight: {
            if (!row.weights) return {};
            const auto [least, most] = *row.weights;
            const QString from = style::numberText(least, 6);
            return least == most ? from : QStringLiteral("%1 … %2").arg(from, style::numberText(most, 6));
        }
        default:
            break;
    }
    if (column == faultColumn()) return row.fault.isEmpty() ? row.failure : row.fault.front();
    if (column < samplesColumn()) return errorOfColumn(row, column);
    if (!row.extent) return {};
    if (column == samplesColumn()) return style::countText(row.extent->samples);
    return row.extent->seconds ? QStringLiteral("%1 s").arg(style::numberText(*row.extent->seconds, 6)) : QString();
}

QString RecordingsModel::errorOfColumn(const Row& row, int column) const {
    const Error* const error = errorOf(row, column);
    if (!error) return {};
    QStringList texts;
    for (const auto* figures : {&error->before, &error->after})
        if (*figures) texts << errorText(**figures);
    const auto& last = error->after ? error->after : error->before;
    const QString unit = last && last->hasScale() ? QStringLiteral("%") : QString::fromStdString(error->unit);
    return QString(texts.join(QStringLiteral(" → ")) + ' ' + unit);
}

QVariant RecordingsModel::sortKey(const Row& row, int column) const {
    constexpr double nothing = std::numeric_limits<double>::lowest();  // before all that is known
    if (column == Weight) return row.weights ? row.weights->first : nothing;
    if (column == samplesColumn()) return row.extent ? static_cast<double>(row.extent->samples) : nothing;
    if (column == durationColumn()) return row.extent && row.extent->seconds ? *row.extent->seconds : nothing;
    if (column < FirstError || column == faultColumn()) return display(row, column);
    const Error* const error = errorOf(row, column);
    const auto& figures = error && error->after ? error->after : error ? error->before : std::nullopt;
    if (!figures) return nothing;
    const double value = figures->hasScale() ? figures->errorPercent : figures->rmse;
    return std::isfinite(value) ? value : std::numeric_limits<double>::max();
}

QVariant RecordingsModel::tooltip(const Row& row, int column) const {
    if (!row.fault.isEmpty() && (column == Name || column == faultColumn()))
        return QString(tr("Left out until this is mended:") + '\n' + row.fault.join('\n'));
    if (column == faultColumn()) return row.failure;
    switch (column) {
        case Name:
            return row.isUsed ? tr("Clear the check box to leave the recording out of all work")
                              : tr("Left out of all work; set the check box to take it in");
        case File:
            return QString::fromStdString(row.path);
        case Role:
            return row.isFit ? tr("Used to fit and to choose effects")
                             : tr("Only reported; never used to fit or to choose");
        case Weight:
            return tr(
                "How much each output of the recording counts in a fit beside those of others: 1 is the common "
                "weight, 0 leaves it out");
        default:
            return {};
    }
}

QVariant RecordingsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    const int column = index.column();
    const bool isNumber = column >= Weight && column < faultColumn();
    switch (role) {
        case Qt::DisplayRole:
            return display(row, column);
        case Qt::EditRole:
            return column == Role ? QVariant(row.isFit) : display(row, column);
        case Qt::CheckStateRole:
            return column == Name ? QVariant(row.isUsed ? Qt::Checked : Qt::Unchecked) : QVariant();
        case Qt::DecorationRole:
            if (column != Name) return {};
            return style::icon(row.isMissing ? "error" : row.fault.isEmpty() ? "recording" : "warning");
        case Qt::ForegroundRole: {
            const QPalette palette;
            if (!row.fault.isEmpty() && (column == Name || column == faultColumn())) return style::caution(palette);
            return row.isUsed ? QVariant() : QVariant(style::mutedText(palette));
        }
        case Qt::TextAlignmentRole:
            return static_cast<int>((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        case Qt::ToolTipRole:
            return tooltip(row, column);
        case SortRole:
            return sortKey(row, column);
        case NameRole:
            return QString::fromStdString(row.name);
        default:
            return {};
    }
}

QVariant RecordingsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    const bool isError = section >= FirstError && section < samplesColumn();
    if (role == Qt::ToolTipRole && isError)
        return tr("Error of this output in the present run, before → after, in % of its range");
    const bool isNumber = section >= Weight && section < faultColumn();
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    if (isError)
        return tr("Error %1").arg(QString::fromStdString(outputs_[static_cast<std::size_t>(section - FirstError)]));
    if (section == faultColumn()) return tr("Fault");
    if (section == samplesColumn()) return tr("Samples");
    if (section == durationColumn()) return tr("Duration");
    return QStringList{tr("Recording"), tr("File"), tr("Role"), tr("Weight")}.value(section);
}

Qt::ItemFlags RecordingsModel::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (!index.isValid() || index.row() >= rowCount()) return flags;
    if (index.column() == Name) flags |= Qt::ItemIsUserCheckable;
    const bool hasWeight = rows_[static_cast<std::size_t>(index.row())].weights.has_value();
    if (index.column() == Role || (index.column() == Weight && hasWeight)) flags |= Qt::ItemIsEditable;
    return flags;
}

bool RecordingsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.row() >= rowCount()) return false;
    const std::set<std::string> one{rows_[static_cast<std::size_t>(index.row())].name};
    if (role == Qt::CheckStateRole && index.column() == Name) {
        setUsed(one, value.toInt() == Qt::Checked);
        return true;
    }
    if (role != Qt::EditRole) return false;
    if (index.column() == Role) {
        setRole(one, value.toBool() ? analogon::Role::Fit : analogon::Role::Validate);
        return true;
    }
    const std::optional<double> weight = index.column() == Weight ? readWeight(value.toString()) : std::nullopt;
    if (weight) setWeight(one, *weight);
    return weight.has_value();
}

std::optional<double> RecordingsModel::readWeight(const QString& typed) {
    const std::optional<double> weight = style::readNumber(typed);
    return weight && isWeight(*weight) ? weight : std::nullopt;
}

void RecordingsModel::setUsed(const std::set<std::string>& recordings, bool isUsed) {
    useRecordings(document_, recordings, isUsed);
}

void RecordingsModel::setRole(const std::set<std::string>& recordings, analogon::Role role) {
    const bool isFit = role == analogon::Role::Fit;
    std::set<std::string> others;
    for (const Row& row : rows_)
        if (recordings.contains(row.name) && row.isFit != isFit) others.insert(row.name);
    if (others.empty()) return;
    changeRecordings(document_, others, isFit ? tr("Use %1 to fit") : tr("Use %1 to validate"),
                     [&](StudyExperiment& e) { e.role = role; });
}

void RecordingsModel::setWeight(const std::set<std::string>& recordings, double weight) {
    std::set<std::string> others;
    for (const Row& row : rows_)
        if (recordings.contains(row.name) && row.weights && *row.weights != std::pair(weight, weight))
            others.insert(row.name);
    if (others.empty()) return;
    changeRecordings(document_, others, tr("Weigh %1"), [&](StudyExperiment& e) {
        for (auto& [output, mapping] : e.outputs) mapping.weight = weight;
    });
}

bool RecordingsModel::isUsed(const std::string& recording) const {
    return std::any_of(rows_.begin(), rows_.end(), [&](const Row& r) { return r.name == recording && r.isUsed; });
}

std::set<std::string> RecordingsModel::usable(const std::set<std::string>& recordings) const {
    std::set<std::string> used;
    for (const Row& row : rows_)
        if (row.isUsed && recordings.contains(row.name)) used.insert(row.name);
    return used;
}

bool RecordingsModel::hasFitted(const std::set<std::string>& recordings) const {
    return std::any_of(rows_.begin(), rows_.end(), [&](const Row& row) {
        return row.isUsed && row.isFit && row.weights && recordings.contains(row.name);
    });
}

}  // namespace analogon::ui
