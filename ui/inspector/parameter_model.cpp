#include "ui/inspector/parameter_model.hpp"

#include <QFont>
#include <QGuiApplication>
#include <QLocale>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "ui/style/style.hpp"

namespace analogon::ui {

QString numberText(double value, int digits) {
    if (!std::isfinite(value)) return QStringLiteral("–");
    return QString::number(value, 'g', digits);
}

ParameterModel::ParameterModel(Document& document, QObject* parent) : QAbstractTableModel(parent), document_(document) {
    connect(&document, &Document::opened, this, &ParameterModel::refresh);
    connect(&document, &Document::factsChanged, this, &ParameterModel::refresh);
    connect(&document, &Document::parametersChanged, this, &ParameterModel::refresh);
    connect(&document, &Document::resultChanged, this, &ParameterModel::refresh);
    connect(&document, &Document::modelChanged, this, &ParameterModel::refresh);
}

void ParameterModel::setComponent(const QString& component) {
    component_ = component;
    refresh();
}

void ParameterModel::setFilter(const QString& text) {
    filter_ = text;
    refresh();
}

void ParameterModel::setOnlyFitted(bool onlyFitted) {
    onlyFitted_ = onlyFitted;
    refresh();
}

void ParameterModel::refresh() {
    std::vector<Row> rows;
    if (document_.isOpen()) {
        const ModelState* after = document_.after();
        for (const ParameterFact& fact : document_.facts().parameters) {
            Row row{fact.name, fact.unit, fact.description, document_.parameterValue(fact.name), {}, nullptr};
            const auto setting = document_.study().parameters.find(fact.name);
            if (setting != document_.study().parameters.end()) row.setting = setting->second;
            if (after)
                for (const FitEstimate& e : after->parameters)
                    if (e.name == fact.name && e.experiment < 0) row.estimate = &e;
            const QString name = QString::fromStdString(fact.name);
            const bool isShown = (component_.isEmpty() || name.startsWith(component_ + ".") || name == component_) &&
                                 (filter_.isEmpty() || name.contains(filter_, Qt::CaseInsensitive)) &&
                                 (!onlyFitted_ || (row.setting && row.setting->fit));
            if (isShown) rows.push_back(std::move(row));
        }
        // Those that are fitted first: they are what the table is for.
        std::stable_partition(rows.begin(), rows.end(), [](const Row& r) { return r.setting && r.setting->fit; });
    }
    const bool isSame =
        rows.size() == rows_.size() && std::equal(rows.begin(), rows.end(), rows_.begin(),
                                                  [](const Row& a, const Row& b) { return a.name == b.name; });
    if (isSame) {
        rows_ = std::move(rows);
        if (!rows_.empty()) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        return;
    }
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
}

int ParameterModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int ParameterModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

int ParameterModel::rowOf(const std::string& name) const {
    const auto it = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.name == name; });
    return it == rows_.end() ? -1 : static_cast<int>(it - rows_.begin());
}

QString ParameterModel::boundText(const Row& row) const {
    if (!row.estimate || !row.estimate->atBound) return {};
    const StudyParameter s = settingOf(row);
    const double v = row.estimate->value;
    const bool isMin = s.min && (!s.max || std::abs(v - *s.min) <= std::abs(v - *s.max));
    return isMin ? tr("at min") : tr("at max");
}

QVariant ParameterModel::display(const Row& row, int column) const {
    switch (column) {
        case Name:
            return QString::fromStdString(row.name);
        case Value:
            return row.value ? numberText(*row.value, 4) : QString();
        case Unit:
            return QString::fromStdString(row.unit);
        case Min:
            return row.setting && row.setting->min ? numberText(*row.setting->min) : QString();
        case Max:
            return row.setting && row.setting->max ? numberText(*row.setting->max) : QString();
        case Result: {
            if (!row.estimate) return {};
            QString text = numberText(row.estimate->value, 4);
            if (row.estimate->atBound) return text + "  " + boundText(row);
            if (std::isfinite(row.estimate->standardError))
                text += QStringLiteral(" ± ") + numberText(row.estimate->standardError, 2);
            else
                text += tr("  not determined");
            return text;
        }
        default:
            return {};
    }
}

QString ParameterModel::tooltip(const Row& row, int column) const {
    QString tip = QString::fromStdString(row.description.empty() ? row.name : row.description);
    if (column == Result && row.estimate) {
        if (row.estimate->atBound)
            tip +=
                tr("\nThe fit ran into the bound: it wants a value beyond. Widen the bound, or ask what the model "
                   "lacks.");
        else if (!std::isfinite(row.estimate->standardError))
            tip += tr("\nThe data do not determine this value on its own.");
        else if (row.estimate->value != 0)
            tip += tr("\nRelative standard error %1 %")
                       .arg(std::abs(row.estimate->standardError / row.estimate->value) * 100, 0, 'g', 2);
    }
    return tip;
}

QVariant ParameterModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    const bool isFitted = row.setting && row.setting->fit;
    switch (role) {
        case Qt::DisplayRole:
            return display(row, index.column());
        case Qt::EditRole:
            if (index.column() == Value && row.value) return QString::number(*row.value, 'g', 12);
            return display(row, index.column());
        case Qt::CheckStateRole:
            if (index.column() == Name) return isFitted ? Qt::Checked : Qt::Unchecked;
            return {};
        case Qt::TextAlignmentRole:
            if (index.column() == Name || index.column() == Unit) return QVariant(Qt::AlignLeft | Qt::AlignVCenter);
            return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        case Qt::ToolTipRole:
            return tooltip(row, index.column());
        case Qt::ForegroundRole: {
            const QPalette palette = QGuiApplication::palette();
            if (index.column() == Result && row.estimate &&
                (row.estimate->atBound || !std::isfinite(row.estimate->standardError)))
                return style::caution(palette);
            if (index.column() == Unit || (!isFitted && index.column() != Name)) return style::mutedText(palette);
            return {};
        }
        case IsFittedRole:
            return isFitted;
        case AtBoundRole:
            return row.estimate && row.estimate->atBound;
        case NameRole:
            return QString::fromStdString(row.name);
        default:
            return {};
    }
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.column() == Name) flags |= Qt::ItemIsUserCheckable;
    if (index.column() == Value || index.column() == Min || index.column() == Max) flags |= Qt::ItemIsEditable;
    return flags;
}

QVariant ParameterModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant((section == Name || section == Unit ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && section == Name) return tr("Checked parameters are fitted");
    if (role == Qt::ToolTipRole && section == Value) return tr("Where a run starts from");
    if (role == Qt::ToolTipRole && section == Result) return tr("Estimate ± standard error of the last run");
    if (role != Qt::DisplayRole) return {};
    switch (section) {
        case Name:
            return tr("Parameter");
        case Value:
            return tr("Value");
        case Unit:
            return tr("Unit");
        case Min:
            return tr("Min");
        case Max:
            return tr("Max");
        case Result:
            return tr("Result");
        default:
            return {};
    }
}

StudyParameter ParameterModel::settingOf(const Row& row) const {
    if (row.setting) return *row.setting;
    StudyParameter fresh;
    fresh.fit = false;
    return fresh;
}

bool ParameterModel::setNumber(const Row& row, int column, const QString& text) {
    const QString trimmed = QString(text).trimmed().replace(',', '.');
    StudyParameter setting = settingOf(row);
    const std::string name = row.name;
    if (column != Value && trimmed.isEmpty()) {
        (column == Min ? setting.min : setting.max).reset();
        document_.setStudyParameter(name, setting, tr("Free the bound of %1").arg(QString::fromStdString(name)));
        return true;
    }
    bool isNumber = false;
    const double number = QLocale::c().toDouble(trimmed, &isNumber);
    if (!isNumber || !std::isfinite(number)) return false;
    if (column == Value) {
        if (row.value == number) return false;
        document_.setParameterValue(name, number);
        return true;
    }
    (column == Min ? setting.min : setting.max) = number;
    if (setting.min && setting.max && *setting.min >= *setting.max) return false;
    document_.setStudyParameter(name, setting, tr("Set the bound of %1").arg(QString::fromStdString(name)));
    return true;
}

bool ParameterModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.row() >= rowCount()) return false;
    const Row row = rows_[static_cast<std::size_t>(index.row())];  // a copy: the change below rebuilds the rows
    if (role == Qt::CheckStateRole && index.column() == Name) {
        StudyParameter setting = settingOf(row);
        setting.fit = value.toInt() == Qt::Checked;
        const QString name = QString::fromStdString(row.name);
        document_.setStudyParameter(row.name, setting, setting.fit ? tr("Fit %1").arg(name) : tr("Fix %1").arg(name));
        return true;
    }
    if (role != Qt::EditRole) return false;
    return setNumber(row, index.column(), value.toString());
}

}  // namespace analogon::ui
