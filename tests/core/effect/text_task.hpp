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

}  // namespace analogon
