#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ui/document/document.hpp"
#include "ui/plot/plot_panel.hpp"

/// Two runs of the history held against each other: what was measured, and what the model of each said of it then.
namespace analogon::ui {

/// Every experiment of either run with its role, those of the first run first.
std::vector<std::pair<std::string, Role>> experimentsOf(const Document::RunPair& runs);

/// For each output that either run has of an experiment: run A as the trace before, run B as the one after. Where the
/// runs saw other parts of the recording, the traces reach as far as each did; where they saw other measurements, each
/// has the residual of its own.
std::vector<OutputPlot::Content> contentsOf(const Document::RunPair& runs, const std::string& experiment);

}  // namespace analogon::ui
