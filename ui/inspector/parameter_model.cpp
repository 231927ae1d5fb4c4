#include "ui/inspector/parameter_model.hpp"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/base/number_text.hpp"
#include "core/fit/clock.hpp"
#include "ui/document/mention.hpp"
#include "ui/inspector/default_bounds.hpp"
#include "ui/inspector/prior_text.hpp"
#include "ui/style/number.hpp"
#include "ui/style/style.hpp"
#include "ui/words/common_units.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

ParameterModel::ParameterModel(Document& document, QObject* parent) : QAbstractTableModel(parent), document_(document) {
    connect(&document, &Document::opened, this, &ParameterModel::refresh);
    connect(&document, &Document::factsChanged, this, &ParameterModel::refresh);
    connect(&document, &Document::parametersChanged, this, &ParameterModel::refresh);
    connect(&document, &Document::experimentsChanged, this, &ParameterModel::refresh);
    connect(&document, &Document::resultChanged, this, [this] {
        isResultNew_ = true;
        refresh();
    });
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

/// A row for each clock that the mapping of an output asks the fit for, with what the study says of it.
std::vector<ParameterModel::Row> ParameterModel::fittedClocks() const {
    std::vector<Row> rows;
    for (const SignalFact& output : document_.facts().outputs) {
        if (!asksForClock(document_.study().experiments, output.name)) continue;
        Row row{clockOf(output.name), "s", {}, document_.parameterValue(clockOf(output.name)), StudyParameter{}, {}};
        row.description = tr("How far the clock of the logger of %1 is ahead of the others")
                              .arg(QString::fromStdString(output.name))
                              .toStdString();
        rows.push_back(std::move(row));
    }
    return rows;
}

void ParameterModel::refresh() {
    std::vector<Row> rows;
    isOfComponent_ = false;
    if (document_.isOpen()) {
        const std::string own = component_.toStdString();
        const auto isOwn = [&](const ParameterFact& f) { return f.name == own || f.name.starts_with(own + "."); };
        const auto& facts = document_.facts().parameters;
        isOfComponent_ = !own.empty() && std::any_of(facts.begin(), facts.end(), isOwn);
        const auto after = document_.after();
        std::vector<Row> candidates;
        for (const ParameterFact& fact : facts)
            if (!isOfComponent_ || isOwn(fact))
                candidates.push_back(
                    {fact.name, fact.unit, fact.description, document_.parameterValue(fact.name), {}, nullptr});
        if (!isOfComponent_)
            for (Row& clock : fittedClocks()) candidates.push_back(std::move(clock));
        for (Row& row : candidates) {
            const auto setting = document_.study().parameters.find(row.name);
            if (setting != document_.study().parameters.end()) row.setting = setting->second;
            if (after)
                for (const FitEstimate& e : after->parameters)
                    if (e.name == row.name && e.experiment < 0) row.estimate = &e;
            const QString name = QString::fromStdString(row.name);
            const bool isShown = (filter_.isEmpty() || name.contains(filter_, Qt::CaseInsensitive)) &&
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
        // Views measure every row that changes: a block that was only moved leaves all as they are.
        const bool isAsBefore =
            !std::exchange(isResultNew_, false) && std::equal(rows.begin(), rows.end(), rows_.begin(), showsSame);
        rows_ = std::move(rows);
        if (!rows_.empty() && !isAsBefore) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
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

bool ParameterModel::hasPriors() const {
    if (!document_.isOpen()) return false;
    const auto& parameters = document_.study().parameters;
    return std::any_of(parameters.begin(), parameters.end(), [](const auto& p) { return p.second.prior.has_value(); });
}

int ParameterModel::rowOf(const std::string& name) const {
    const auto it = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.name == name; });
    return it == rows_.end() ? -1 : static_cast<int>(it - rows_.begin());
}

QString ParameterModel::boundText(const Row& row) const {
    if (!row.estimate || !row.estimate->atBound) return {};
    const StudyParameter s = settingOf(row);
    const double v = row.estimate->value;
    // where one is not set it is declared, or the search's own: the value it began at lies between them
    const bool isMin =
        s.min && s.max ? std::abs(v - *s.min) <= std::abs(v - *s.max) : v < row.value.value_or(s.min ? v + 1 : v);
    return isMin ? tr("at min") : tr("at max");
}

UnitConversion ParameterModel::shownAs(const Row& row) const {
    const auto chosen = units_.find(row.name);
    if (chosen == units_.end()) return {};
    const Outcome<UnitConversion> conversion = convertUnit(row.unit, chosen->second);
    return conversion ? *conversion : UnitConversion{};
}

bool ParameterModel::showsSame(const Row& a, const Row& b) {
    const auto facts = [](const Row& r) { return std::tie(r.name, r.unit, r.description, r.value, r.estimate); };
    const auto setting = [](const StudyParameter& s) { return std::tie(s.fit, s.value, s.min, s.max, s.prior); };
    const bool isSameSetting =
        a.setting && b.setting ? setting(*a.setting) == setting(*b.setting) : !a.setting && !b.setting;
    return facts(a) == facts(b) && isSameSetting;
}

std::optional<NormalPrior> ParameterModel::shownPrior(const Row& row) const {
    if (!row.setting || !row.setting->prior) return std::nullopt;
    const UnitConversion shown = shownAs(row);
    const NormalPrior& prior = *row.setting->prior;
    return NormalPrior{shown(prior.mean), std::abs(shown.factor) * prior.deviation};
}

QString ParameterModel::unitText(const Row& row) const {
    const auto chosen = units_.find(row.name);
    return QString::fromStdString(chosen == units_.end() ? row.unit : chosen->second);
}

/// Bounds of one sign and far apart are seen on a logarithmic scale, as the fit sees them.
QVariantList ParameterModel::bar(const Row& row) const {
    const StudyParameter s = settingOf(row);
    const std::optional<double> value = row.estimate ? std::optional(row.estimate->value) : row.value;
    if (!s.min || !s.max || !value || !(*s.max > *s.min)) return {};
    const bool isLog = *s.min > 0 && *s.max >= 10 * *s.min;
    const auto at = [&](double v) {
        const double x = isLog ? std::log(std::max(v, *s.min) / *s.min) / std::log(*s.max / *s.min)
                               : (v - *s.min) / (*s.max - *s.min);
        return std::clamp(x, 0.0, 1.0);
    };
    const double spread = row.estimate && std::isfinite(row.estimate->standardError) ? row.estimate->standardError : 0;
    return {at(*value), at(*value - spread), at(*value + spread)};
}

/// What the fit says about this parameter and others: that they cannot be told apart.
const Text* ParameterModel::remarkOn(const Row& row) const {
    const auto after = document_.after();
    if (!row.estimate || !after) return nullptr;
    for (const Text& remark : after->remarks)
        if (namesIn(remark).contains(QString::fromStdString(row.name))) return &remark;
    return nullptr;
}

QString ParameterModel::boundHint(const Row& row) const {
    if (!row.estimate) return {};
    if (row.estimate->atBound)
        return tr("The fit ran into the bound: it wants a value beyond. Widen the bound, or ask what the model lacks.");
    if (!std::isfinite(row.estimate->standardError)) return tr("The data do not determine this value on its own.");
    return {};
}

QString ParameterModel::noteOn(int row) const {
    const Row& r = rows_[static_cast<std::size_t>(row)];
    const QString name = QString::fromStdString(r.name);
    QString note = "<b>" + name.toHtmlEscaped() + "</b>";
    if (!r.description.empty()) note += "&nbsp; " + libraryText(r.description).toHtmlEscaped();
    if (const QString hint = boundHint(r); !hint.isEmpty()) note += "<br>" + hint.toHtmlEscaped();
    if (const Text* remark = remarkOn(r))
        note += "<br>" + linkedWords(*remark, [&](const QString& other) {
                    const auto mention = other == name ? std::nullopt : mentionOf(document_, other);
                    return mention ? targetOf(*mention) : QString();
                });
    return note;
}

QVariant ParameterModel::display(const Row& row, int column) const {
    const UnitConversion shown = shownAs(row);
    switch (column) {
        case Name:
            return QString::fromStdString(row.name);
        case Value:
            return row.value ? style::numberText(shown(*row.value)) : QString();
        case Unit:
            return unitText(row);
        case Min:
            return row.setting && row.setting->min ? style::numberText(shown(*row.setting->min)) : QString();
        case Max:
            return row.setting && row.setting->max ? style::numberText(shown(*row.setting->max)) : QString();
        case Prior: {
            const std::optional<NormalPrior> prior = shownPrior(row);
            return prior ? priorText(*prior, 4) : QString();
        }
        case Result: {
            if (!row.estimate) return {};
            const double value = shown(row.estimate->value), error = row.estimate->standardError;
            if (row.estimate->atBound) return style::numberText(value, 4) + "  " + boundText(row);
            if (!std::isfinite(error)) return style::numberText(value, 4) + tr("  not determined");
            return style::withDecimalSign(valueText(value, std::abs(shown.factor) * error));
        }
        default:
            return {};
    }
}

/// With more digits than are shown, so that opening an editor and leaving it changes nothing.
QString ParameterModel::edited(const Row& row, int column) const {
    constexpr int digits = 12;
    const UnitConversion shown = shownAs(row);
    const auto text = [&](const std::optional<double>& value) {
        return value ? style::numberText(shown(*value), digits) : QString();
    };
    switch (column) {
        case Value:
            return text(row.value);
        case Min:
            return row.setting ? text(row.setting->min) : QString();
        case Max:
            return row.setting ? text(row.setting->max) : QString();
        case Prior: {
            const std::optional<NormalPrior> prior = shownPrior(row);
            return prior ? priorText(*prior, digits) : QString();
        }
        default:
            return display(row, column).toString();
    }
}

QString ParameterModel::tooltip(const Row& row, int column) const {
    QString tip = row.description.empty() ? QString::fromStdString(row.name) : libraryText(row.description);
    if (column == Result && row.estimate) {
        if (const QString hint = boundHint(row); !hint.isEmpty())
            tip += "\n" + hint;
        else if (row.estimate->value != 0)
            tip += tr("\nRelative standard error %1 %")
                       .arg(style::numberText(std::abs(row.estimate->standardError / row.estimate->value) * 100, 2));
        if (const auto& prior = row.estimate->prior)
            tip += tr("\n%1 standard deviations from what was known beforehand")
                       .arg(style::fixedText(std::abs(prior->distance(row.estimate->value)), 1));
        if (const Text* remark = remarkOn(row)) tip += "\n" + inWords(*remark);
    }
    if (column == Bounds && !bar(row).isEmpty())
        tip = tr("Where the value lies between its bounds; the broad part is its standard error");
    if (column == Prior)
        tip =
            tr("What is known beforehand: mean ± standard deviation. It counts as one more measured value; empty: "
               "nothing is known.");
    if (column == Unit) tip = tr("Double-click to see the value in another unit");
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
            return edited(row, index.column());
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
                (row.estimate->atBound || !std::isfinite(row.estimate->standardError) || remarkOn(row)))
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
        case BarRole:
            return bar(row);
        case UnitsRole:
            return row.unit.empty() ? QStringList() : unitsLike(row.unit);
        default:
            return {};
    }
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return Qt::NoItemFlags;
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.column() == Name) flags |= Qt::ItemIsUserCheckable;
    const int editable[] = {Value, Min, Max, Prior, Unit};
    if (std::count(std::begin(editable), std::end(editable), index.column()) > 0) flags |= Qt::ItemIsEditable;
    return flags;
}

QVariant ParameterModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return QVariant((section == Name || section == Unit ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && section == Name) return tr("Checked parameters are fitted");
    if (role == Qt::ToolTipRole && section == Value) return tr("Where a run starts from");
    if (role == Qt::ToolTipRole && section == Result) return tr("Estimate ± standard error of the last run");
    if (role == Qt::ToolTipRole && section == Prior) return tooltip({}, Prior);
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
        case Prior:
            return tr("Prior");
        case Bounds:
            return tr("Bounds");
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
    StudyParameter setting = settingOf(row);
    const std::string name = row.name;
    if (column != Value && text.trimmed().isEmpty()) {
        (column == Min ? setting.min : setting.max).reset();
        document_.setStudyParameter(name, setting, tr("Free the bound of %1").arg(QString::fromStdString(name)));
        return true;
    }
    const std::optional<double> typed = style::readNumber(text);
    if (!typed) return false;
    const UnitConversion shown = shownAs(row);
    const double number = (*typed - shown.offset) / shown.factor;
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

bool ParameterModel::setPrior(const Row& row, const QString& text) {
    StudyParameter setting = settingOf(row);
    const QString name = QString::fromStdString(row.name);
    if (text.trimmed().isEmpty()) {
        setting.prior.reset();
        document_.setStudyParameter(row.name, setting, tr("Forget what is known of %1").arg(name));
        return true;
    }
    const std::optional<NormalPrior> typed = readPrior(text);
    if (!typed) return false;
    const UnitConversion shown = shownAs(row);
    setting.prior = NormalPrior{(typed->mean - shown.offset) / shown.factor, typed->deviation / std::abs(shown.factor)};
    document_.setStudyParameter(row.name, setting, tr("Set what is known of %1").arg(name));
    return true;
}

/// How a value is shown is no change of the study.
bool ParameterModel::setUnit(const Row& row, const QString& unit) {
    if (!areConvertible(row.unit, unit.toStdString())) return false;
    if (unit.toStdString() == row.unit)
        units_.erase(row.name);
    else
        units_[row.name] = unit.toStdString();
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    return true;
}

bool ParameterModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.row() >= rowCount()) return false;
    const Row row = rows_[static_cast<std::size_t>(index.row())];  // a copy: the change below rebuilds the rows
    if (role == Qt::CheckStateRole && index.column() == Name) {
        StudyParameter setting = settingOf(row);
        setting.fit = value.toInt() == Qt::Checked;
        for (const ParameterFact& fact : document_.facts().parameters)
            if (setting.fit && fact.name == row.name && row.value) giveDefaultBounds(setting, fact, *row.value);
        const QString name = QString::fromStdString(row.name);
        document_.setStudyParameter(row.name, setting, setting.fit ? tr("Fit %1").arg(name) : tr("Fix %1").arg(name));
        return true;
    }
    if (role != Qt::EditRole) return false;
    if (index.column() == Unit) return setUnit(row, value.toString());
    if (value.toString() == edited(row, index.column())) return false;  // an editor that was only opened
    if (index.column() == Prior) return setPrior(row, value.toString());
    return setNumber(row, index.column(), value.toString());
}

}  // namespace analogon::ui
