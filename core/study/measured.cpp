#include "core/study/measured.hpp"

#include <algorithm>

#include "core/study/recorded.hpp"

namespace analogon {

UnitConversion secondsOf(const Column& time) {
    if (time.unit.empty()) return {};
    const Outcome<UnitConversion> seconds = convertUnit(time.unit, "s");
    return seconds ? *seconds : UnitConversion{};
}

std::pair<std::size_t, std::size_t> usedRows(const Table& table, const StudyExperiment& experiment) {
    const Column& column = *table.find(experiment.timeColumn, experiment.timeGroup);
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

std::set<std::size_t> mappedColumns(const Table& table, const StudyExperiment& experiment) {
    std::set<std::size_t> columns;
    const auto add = [&](const ChannelName& name) {
        if (const Column* found = table.find(name.column, name.group))
            columns.insert(static_cast<std::size_t>(found - table.columns.data()));
    };
    add({experiment.timeColumn, experiment.timeGroup});
    for (const auto* mappings : {&experiment.inputs, &experiment.outputs})
        for (const auto& [signal, mapping] : *mappings) add(mapping.channel());
    return columns;
}

std::set<std::size_t> usedColumns(const Table& table, const StudyExperiment& experiment) {
    std::set<std::size_t> columns = mappedColumns(table, experiment);
    for (const auto& [name, start] : experiment.initial) {
        const ColumnStart* const begin = std::get_if<ColumnStart>(&start);
        if (const Column* found = begin ? table.find(begin->column, begin->group) : nullptr)
            columns.insert(static_cast<std::size_t>(found - table.columns.data()));
    }
    return columns;
}

Table cutTo(const Table& table, std::size_t first, std::size_t last, const std::set<std::size_t>& columns) {
    Table kept;
    kept.file = table.file;
    kept.lines = table.lines;
    for (const std::size_t column : columns) kept.columns.push_back(table.columns[column]);
    return kept.slice(first, last);
}

std::vector<ExperimentState> measuredExperiments(const Study& study) {
    std::vector<ExperimentState> experiments;
    for (const StudyExperiment& recorded : study.experiments) {
        if (!recorded.isUsed) continue;
        const std::shared_ptr<const Table> whole = shownTable(study.tables, recorded);
        if (!whole || !whole->find(recorded.timeColumn, recorded.timeGroup)) continue;
        const auto [first, last] = usedRows(*whole, recorded);
        if (last - first < 2) continue;
        const Table table = cutTo(*whole, first, last, usedColumns(*whole, recorded));
        const Outcome<std::vector<double>> time = readTime(table, recorded.timeColumn);
        if (!time) continue;
        ExperimentState experiment;
        experiment.name = recorded.name;
        experiment.role = recorded.role;
        experiment.time = *time;
        for (const auto& [output, mapping] : recorded.outputs) {
            const Column* column = table.find(mapping.column, mapping.group);
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
