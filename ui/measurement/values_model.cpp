#include "ui/measurement/values_model.hpp"

#include <QGuiApplication>
#include <cmath>

#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

std::string unitOf(const std::vector<SignalFact>& facts, const std::string& signal, const std::string& otherwise) {
    const std::string unit = unitOf(facts, signal);
    return unit.empty() ? otherwise : unit;
}

}  // namespace

void ValuesModel::show(std::shared_ptr<const Table> table, const StudyExperiment& experiment, const ModelFacts& facts) {
    beginResetModel();
    table_ = std::move(table);
    all_.clear();
    time_ = nullptr;
    range_ = experiment.range;
    for (std::size_t c = 0; table_ && c < table_->columns.size(); ++c) {
        const Column& column = table_->columns[c];
        const bool isTime = &column == table_->find(experiment.timeColumn, experiment.timeGroup);
        all_.push_back({c,
                        QString::fromStdString(column.name),
                        QString::fromStdString(column.unit),
                        isTime ? tr("The time of each sample") : tr("As it stands in the file"),
                        {}});
        const auto addMapped = [&](const std::map<std::string, ChannelMapping>& channels,
                                   const std::vector<SignalFact>& signalFacts) {
            for (const auto& [signal, mapping] : channels) {
                if (&column != table_->find(mapping.column, mapping.group)) continue;
                const std::string from = mapping.unit.empty() ? column.unit : mapping.unit;
                const std::string to = unitOf(signalFacts, signal, from);
                const Outcome<UnitConversion> units = convertUnit(from, to);
                if (!units) continue;  // the messages say so
                all_.push_back(
                    {c, QStringLiteral("→ ") + QString::fromStdString(signal), QString::fromStdString(to),
                     tr("What the model gets as %1").arg(QString::fromStdString(signal)),
                     UnitConversion{mapping.scale * units->factor, mapping.scale * units->offset + mapping.offset}});
            }
        };
        addMapped(experiment.inputs, facts.inputs);
        addMapped(experiment.outputs, facts.outputs);
        if (isTime && range_) {
            time_ = &column;
            const Outcome<UnitConversion> seconds = convertUnit(column.unit.empty() ? "s" : column.unit, "s");
            toSeconds_ = seconds ? *seconds : UnitConversion{};
        }
    }
    arrange();
    endResetModel();
}

void ValuesModel::setShown(bool isRaw, bool isConverted) {
    beginResetModel();
    isRaw_ = isRaw;
    isConverted_ = isConverted;
    arrange();
    endResetModel();
}

void ValuesModel::arrange() {
    shown_.clear();
    for (const Shown& each : all_)
        if (each.conversion ? isConverted_ : isRaw_) shown_.push_back(each);
}

bool ValuesModel::isUsed(std::size_t row) const {
    if (!time_ || row >= time_->values.size()) return true;
    const double t = toSeconds_(time_->values[row]);
    return t >= range_->first && t <= range_->second;
}

int ValuesModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !table_ ? 0 : static_cast<int>(table_->rows());
}

int ValuesModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

QVariant ValuesModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const auto row = static_cast<std::size_t>(index.row());
    const Shown& shown = shown_[static_cast<std::size_t>(index.column())];
    switch (role) {
        case Qt::DisplayRole: {
            const double value = table_->columns[shown.column].values[row];
            if (!std::isfinite(value)) return {};
            return style::numberText(shown.conversion ? (*shown.conversion)(value) : value, 9);
        }
        case Qt::TextAlignmentRole:
            return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ForegroundRole:
            return isUsed(row) ? QVariant() : style::mutedText(QGuiApplication::palette());
        case Qt::ToolTipRole:
            return isUsed(row) ? shown.tip : shown.tip + "\n" + tr("Outside the range that is used");
        default:
            return {};
    }
}

QVariant ValuesModel::headerData(int section, Qt::Orientation orientation, int role) const {
    const auto i = static_cast<std::size_t>(section);
    if (orientation == Qt::Vertical) {
        if (role != Qt::DisplayRole || section >= rowCount()) return {};
        return i < table_->lines.size() ? table_->lines[i] : section + 1;
    }
    if (section >= columnCount()) return {};
    const Shown& shown = shown_[i];
    if (role == Qt::ToolTipRole) return shown.tip;
    if (role == Qt::ForegroundRole && shown.conversion) return style::accentText(QGuiApplication::palette());
    if (role != Qt::DisplayRole) return {};
    return shown.unit.isEmpty() ? shown.heading : shown.heading + QStringLiteral("\n[%1]").arg(shown.unit);
}

}  // namespace analogon::ui
