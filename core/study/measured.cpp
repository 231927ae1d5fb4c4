#include "core/study/measured.hpp"

#include <algorithm>

namespace analogon {

UnitConversion secondsOf(const Column& time) {
    if (time.unit.empty()) return {};
    const Outcome<UnitConversion> seconds = convertUnit(time.unit, "s");
    return seconds ? *seconds : UnitConversion{};
}

std::pair<std::size_t, std::size_t> usedRows(const Table& table, const StudyExperiment& experiment) {
    const Column& column = *table.find(experiment.timeColumn);
    if (!experiment.range) return {0, column.values.size()};
    const UnitConversion convert = secondsOf(column);
    const auto isInside = [&](double value) {
        const double t = convert(value);
        return t >= experiment.range->first && t <= experiment.range->second;
    };
    const auto first = std::find_if(column.values.begin(), column.values.end(), isInside);
    const auto last = std::find_if(column.values.rbegin(), column.values.rend(), isInside).base();
    if (last < first) return {0, 0};
    return {static_cast<std::size_t>(first - column.values.begin()),
            static_cast<std::size_t>(last - column.values.begin())};
}

std::set<std::string, std::less<>> mappedColumns(const Table& table, const StudyExperiment& experiment) {
    std::set<std::string, std::less<>> names;
    const auto add = [&](const std::string& column) {
        if (const Column* found = table.find(column)) names.insert(found->name);
    };
    add(experiment.timeColumn);
    for (const auto* mappings : {&experiment.inputs, &experiment.outputs})
        for (const auto& [signal, mapping] : *mappings) add(mapping.column);
    return names;
}

std::set<std::string, std::less<>> usedColumns(const Table& table, const StudyExperiment& experiment) {
    std::set<std::string, std::less<>> names = mappedColumns(table, experiment);
    for (const auto& [name, start] : experiment.initial) {
        const ColumnStart* const begin = std::get_if<ColumnStart>(&start);
        if (const Column* found = begin ? table.find(begin->column) : nullptr) names.insert(found->name);
    }
    return names;
}

Table cutTo(const Table& table, std::size_t first, std::size_t last,
            const std::set<std::string, std::less<>>& columns) {
    Table kept;
    kept.file = table.file;
    kept.lines = table.lines;
    for (const Column& column : table.columns)
        if (columns.contains(column.name)) kept.columns.push_back(column);
    return kept.slice(first, last);
}

std::vector<ExperimentState> measuredExperiments(const Study& study) {
    std::vector<ExperimentState> experiments;
    for (const StudyExperiment& recorded : study.experiments) {
        const auto found = study.tables.find(recorded.file);
        if (found == study.tables.end() || !found->second || !found->second->find(recorded.timeColumn)) continue;
        const auto [first, last] = usedRows(*found->second, recorded);
        if (last - first < 2) continue;
        const Table table = cutTo(*found->second, first, last, usedColumns(*found->second, recorded));
        const Outcome<std::vector<double>> time = readTime(table, recorded.timeColumn);
        if (!time) continue;
        ExperimentState experiment;
        experiment.name = recorded.name;
        experiment.role = recorded.role;
        experiment.time = *time;
        for (const auto& [output, mapping] : recorded.outputs) {
            const Column* column = table.find(mapping.column);
            const Outcome<std::vector<double>> values = readChannel(table, mapping, {}, EmptyCells::NotMeasured);
            if (!column || !values) continue;
            OutputState state;
            state.name = output;
            state.unit = mapping.unit.empty() ? column->unit : mapping.unit;
            state.measured =
                Eigen::Map<const Eigen::VectorXd>(values->data(), static_cast<Eigen::Index>(values->size()));
            experiment.outputs.push_back(std::move(state));
        }
        if (!experiment.outputs.empty()) experiments.push_back(std::move(experiment));
    }
    return experiments;
}

}  // namespace analogon
