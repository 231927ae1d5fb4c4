#include "core/study/measured.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {

std::vector<ExperimentState> measuredExperiments(const Study& study) {
    std::vector<ExperimentState> experiments;
    for (const StudyExperiment& recorded : study.experiments) {
        const auto found = study.tables.find(recorded.file);
        if (found == study.tables.end() || !found->second) continue;
        const Table& table = *found->second;
        const Outcome<std::vector<double>> time = readTime(table, recorded.timeColumn);
        if (!time) continue;
        auto first = time->begin(), last = time->end();
        if (recorded.range) {
            first = std::lower_bound(first, last, recorded.range->first);
            last = std::upper_bound(first, last, recorded.range->second);
        }
        if (last - first < 2) continue;
        ExperimentState experiment;
        experiment.name = recorded.name;
        experiment.role = recorded.role;
        experiment.time.assign(first, last);
        for (const auto& [output, mapping] : recorded.outputs) {
            const Column* column = table.find(mapping.column);
            const Outcome<std::vector<double>> values = readChannel(table, mapping, {}, EmptyCells::NotMeasured);
            if (!column || !values) continue;
            OutputState state;
            state.name = output;
            state.unit = mapping.unit.empty() ? column->unit : mapping.unit;
            state.measured = Eigen::Map<const Eigen::VectorXd>(values->data() + (first - time->begin()), last - first);
            experiment.outputs.push_back(std::move(state));
        }
        if (!experiment.outputs.empty()) experiments.push_back(std::move(experiment));
    }
    return experiments;
}

}  // namespace analogon
