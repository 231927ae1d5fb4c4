#include "core/study/recorded.hpp"

#include "core/measure/channel_place.hpp"

namespace analogon {

std::string tableKey(const StudyExperiment& experiment) {
    if (experiment.read == ReadOptions{}) return experiment.file;
    return experiment.file + '\n' + readText(experiment.read);
}

std::string fileOfKey(const std::string& key) { return key.substr(0, key.find('\n')); }

std::shared_ptr<const Table> fileTable(const Tables& tables, const StudyExperiment& experiment) {
    const auto found = tables.find(tableKey(experiment));
    return found == tables.end() ? nullptr : found->second;
}

Outcome<std::shared_ptr<const Table>> recordedTable(const Tables& tables, const StudyExperiment& experiment) {
    RasterRequest request;
    request.time = {experiment.timeColumn, experiment.timeGroup};
    request.raster = experiment.raster;
    for (const auto& [output, mapping] : experiment.outputs) request.outputs.push_back(mapping.channel());
    for (const auto& [input, mapping] : experiment.inputs)
        request.inputs.push_back({mapping.channel(), mapping.interpolation});
    return onCommonRaster(fileTable(tables, experiment), request);
}

std::shared_ptr<const Table> shownTable(const Tables& tables, const StudyExperiment& experiment) {
    const std::shared_ptr<const Table> file = fileTable(tables, experiment);
    if (!file) return nullptr;
    const Outcome<std::shared_ptr<const Table>> joined = recordedTable(tables, experiment);
    return joined ? *joined : nullptr;
}

bool isAtHand(const Tables& tables, const StudyExperiment& experiment) {
    const std::shared_ptr<const Table> file = fileTable(tables, experiment);
    return !file || (isOnOneRaster(*file) && experiment.raster.kind == Raster::Kind::Outputs);
}

void findTime(const Tables& tables, StudyExperiment& experiment) {
    const std::shared_ptr<const Table> file = fileTable(tables, experiment);
    if (!experiment.isTimeOfFile || !file) return;
    const auto take = [&](const Table& group) {
        if (!group.time) return false;
        experiment.timeColumn = group.columns[*group.time].name;
        experiment.timeGroup = file->others.empty() ? GroupName{} : group.columns[*group.time].groupName();
        return true;
    };
    for (const auto* mappings : {&experiment.outputs, &experiment.inputs})
        for (const auto& [signal, mapping] : *mappings)
            if (const auto places = placesOf(*file, mapping.channel()); places.size() == 1 && take(*places[0].group))
                return;
    for (const Table* const group : tablesOf(*file))
        if (take(*group)) return;
}

std::set<std::string> namedChannels(const Study& study, const StudyExperiment& experiment) {
    std::set<std::string> names;
    for (const StudyExperiment& other : study.experiments) {
        if (other.file != experiment.file) continue;
        names.insert(other.timeColumn);
        if (other.raster.kind == Raster::Kind::Channel) names.insert(other.raster.channel.column);
        for (const auto* mappings : {&other.inputs, &other.outputs})
            for (const auto& [signal, mapping] : *mappings) names.insert(mapping.column);
        for (const auto& [parameter, start] : other.initial)
            if (const ColumnStart* column = std::get_if<ColumnStart>(&start)) names.insert(column->column);
    }
    return names;
}

std::shared_ptr<const Table> calledAs(const Table& table, const std::string& file) {
    auto called = std::make_shared<Table>(table);
    called->file = file;
    for (std::shared_ptr<const Table>& other : called->others) other = calledAs(*other, file);
    return called;
}

}  // namespace analogon
