#pragma once

#include <gtest/gtest.h>

#include "core/fit/estimation_task.hpp"

namespace analogon {

/// A task for a class of this text, without parameters and recordings.
inline EstimationTask taskOf(const std::string& text, const std::string& className) {
    EstimationTask task;
    task.model = std::make_shared<Source>("model.mo", text);
    task.className = className;
    Outcome<Library> library = builtInLibrary()->withSource(task.model);
    EXPECT_TRUE(library) << format(library.diagnostics());
    if (library) task.library = std::move(*library);
    return task;
}

/// A recording of these inputs and outputs whose stamps and values are still to be filled in: `samples` of them.
inline Recording blankRecording(const std::string& name, std::vector<std::string> inputs,
                                std::vector<std::string> outputs, int samples) {
    Recording r;
    r.name = name;
    r.inputs.resize(static_cast<Eigen::Index>(inputs.size()), samples);
    r.outputs.resize(static_cast<Eigen::Index>(outputs.size()), samples);
    r.weights = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(outputs.size()));
    r.inputNames = std::move(inputs);
    r.outputNames = std::move(outputs);
    return r;
}

}  // namespace analogon
