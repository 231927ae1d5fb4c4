#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/study/study.hpp"
#include "ui/document/model_facts.hpp"

namespace analogon::ui {

/// For signals of the model that have no column yet: the column that fits by unit and name, each at most once.
/// `like` are experiments whose mapping is taken over where the columns have the same names.
void proposeMapping(StudyExperiment& experiment, const Table& table, const ModelFacts& facts,
                    const std::vector<StudyExperiment>& like);

/// The column that is time: by unit and name, rising; empty: none.
std::string proposeTime(const Table& table);

}  // namespace analogon::ui
