#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/study/study.hpp"
#include "ui/document/model_facts.hpp"

namespace analogon::ui {

/// For signals of the model that have no column yet: the column that fits by unit and name, each at most once. What
/// drives is sought among what moves, before what supplies the bench; where two fit alike, none is taken.
/// `like` are experiments whose mapping is taken over where the columns have the same names.
void proposeMapping(StudyExperiment& experiment, const Table& table, const ModelFacts& facts,
                    const std::vector<StudyExperiment>& like);

/// The columns, none of them used yet, that fit a signal alike and better than all others; empty: fewer than two.
std::vector<std::string> rivalColumns(const StudyExperiment& experiment, const SignalFact& signal, bool isInput,
                                      const Table& table);

/// The column that is time: by unit and name, rising; empty: none.
std::string proposeTime(const Table& table);

/// Settings of a clock that no mapping asks for any more are a fault of a study: they go with the last that did.
void dropUnaskedClocks(std::map<std::string, StudyParameter>& parameters,
                       const std::vector<StudyExperiment>& experiments);

}  // namespace analogon::ui
