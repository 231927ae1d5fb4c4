#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/study/study.hpp"

/// The measurement files of a study, and the part of one that an experiment uses.
namespace analogon {

/// Under which name Study::tables holds the file of an experiment: its path, and how it is read where the study tells.
std::string tableKey(const StudyExperiment& experiment);
/// The path in such a name.
std::string fileOfKey(const std::string& key);

using Tables = std::map<std::string, std::shared_ptr<const Table>>;

/// The whole file; null: it was not read.
std::shared_ptr<const Table> fileTable(const Tables& tables, const StudyExperiment& experiment);

/// The channels of an experiment on its raster (core/measure/common_raster.hpp). The file must have been read.
Outcome<std::shared_ptr<const Table>> recordedTable(const Tables& tables, const StudyExperiment& experiment);

/// The same for those to whom the messages are told by others; null: there is none.
std::shared_ptr<const Table> shownTable(const Tables& tables, const StudyExperiment& experiment);

/// Whether that table is the file's own, and there at once.
bool isAtHand(const Tables& tables, const StudyExperiment& experiment);

/// Where the study does not name the time of an experiment: that of the channels which it uses, as the file tells it.
/// It stays without a name where the file does not. The file must have been read.
void findTime(const Tables& tables, StudyExperiment& experiment);

/// The names of the channels that experiments with the file of this one use.
std::set<std::string> namedChannels(const Study& study, const StudyExperiment& experiment);

/// The table of a file that is called by another path in messages.
std::shared_ptr<const Table> calledAs(const Table& table, const std::string& file);

}  // namespace analogon
