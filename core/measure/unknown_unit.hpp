#pragma once

#include <string>
#include <vector>

#include "core/measure/question.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/recording.hpp"
#include "core/measure/table.hpp"

/// Units of a file that are none here: nobody guesses what they mean, it is asked.
namespace analogon {

struct UnknownUnit {
    std::string text;                  // as the file has it
    std::vector<std::string> columns;  // that are measured in it
    int line{};                        // of the header of the first one; 0: nowhere
};

/// What is written as the unit of a column and is none; empty: nothing is.
std::string unknownUnitOf(const std::string& name, const std::string& unit);

/// What stands behind a name in round brackets counts, too, where it begins with a unit or is written nearly as one.
std::vector<UnknownUnit> unknownUnits(const Table& table);
std::vector<UnknownUnit> unknownUnits(const RecordedGroup& group);

/// "the unit 'mpa' of p1 and p2 is not known: did you mean 'MPa' or 'mPa'?"
Text told(const UnknownUnit& unknown);

/// Which unit is meant, with the readings that are near, beside how the file was read so far.
Question askedUnit(const UnknownUnit& unknown, const ReadOptions& options);

/// The unit of a column as it was told; as it is where nothing was told of it.
std::string unitMeant(const std::string& name, const std::string& unit, const ReadOptions& options);
void nameUnits(Table& table, const ReadOptions& options);
void nameUnits(MeasurementFile& recording, const ReadOptions& options);

}  // namespace analogon
