#include "core/study/mapped_signals.hpp"

#include <set>

namespace analogon {

MeasuredSignals mappedSignals(const Study& study, const std::string& className) {
    std::set<std::string> compared, driven;
    for (const StudyExperiment& experiment : study.experiments) {
        for (const auto& [name, mapping] : experiment.outputs) compared.insert(name);
        for (const auto& [name, mapping] : experiment.inputs) driven.insert(name);
    }
    return {className, {compared.begin(), compared.end()}, {driven.begin(), driven.end()}};
}

}  // namespace analogon
