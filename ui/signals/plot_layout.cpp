#include "ui/signals/plot_layout.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <array>

namespace analogon::ui {

namespace {

constexpr const char* member = "plots";
constexpr std::array<const char*, 5> viewNames{"time", "xy", "spectrum", "coherence", "histogram"};

QJsonObject read(const std::string& json) { return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object(); }

PlotAxis axisFrom(const QJsonObject& json) {
    PlotAxis axis;
    const std::string view = json.value("view").toString().toStdString();
    const auto found = std::find(viewNames.begin(), viewNames.end(), view);
    if (found != viewNames.end()) axis.view = static_cast<PlotView>(found - viewNames.begin());
    const QJsonArray traces = json.value("traces").toArray();
    for (const auto& trace : traces)
        if (SignalRef reference = SignalRef::of(trace.toObject()); !reference.name.isEmpty())
            axis.traces.push_back(std::move(reference));
    return axis;
}

}  // namespace

PlotLayout plotLayoutOf(const std::string& extraJson) {
    PlotLayout layout;
    const QJsonObject plots = read(extraJson).value(member).toObject();
    const QJsonArray axes = plots.value("axes").toArray(), formulas = plots.value("formulas").toArray();
    for (const auto& axis : axes)
        if (PlotAxis read = axisFrom(axis.toObject()); !read.traces.empty()) layout.axes.push_back(std::move(read));
    for (const auto& formula : formulas)
        if (!formula.toString().isEmpty()) layout.formulas.push_back(formula.toString());
    return layout;
}

std::string withPlotLayout(const std::string& extraJson, const PlotLayout& layout) {
    QJsonObject all = read(extraJson);
    QJsonArray axes, formulas;
    for (const PlotAxis& axis : layout.axes) {
        QJsonArray traces;
        for (const SignalRef& trace : axis.traces) traces.append(trace.json());
        axes.append(QJsonObject{{"view", viewNames[static_cast<std::size_t>(axis.view)]}, {"traces", traces}});
    }
    for (const QString& formula : layout.formulas) formulas.append(formula);
    all.remove(member);
    if (!axes.isEmpty() || !formulas.isEmpty()) all[member] = QJsonObject{{"axes", axes}, {"formulas", formulas}};
    return all.isEmpty() ? std::string() : QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

}  // namespace analogon::ui
