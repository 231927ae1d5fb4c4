#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure/question.hpp"

namespace analogon {

/// A row of a file under each reading of a question.
struct QuestionRow {
    int line{};
    std::string text;          // as it stands in the file
    std::vector<Text> values;  // of the column that differs, by reading; empty: it cannot be read so
};

/// Rows from the first one on that the readings of a question make differ, and the column in which they do. Where no
/// reading differs from another one, the first columns of the first rows.
struct QuestionRows {
    std::string column;
    std::vector<QuestionRow> rows;
};
QuestionRows rowsUnder(std::string_view bytes, const std::string& name, const Question& question, std::size_t most);
/// Of a file, of which no more is read than the question takes.
QuestionRows rowsUnder(const std::filesystem::path& file, const Question& question, std::size_t most);

}  // namespace analogon
