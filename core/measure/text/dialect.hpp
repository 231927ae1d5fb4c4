#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/measure/csv_dialect.hpp"
#include "core/measure/question.hpp"
#include "core/measure/read_options.hpp"
#include "core/measure/text/cell_kind.hpp"
#include "core/measure/text/text_line.hpp"

/// How the lines of a text are parted into cells, and where among them the rows of data are.
namespace analogon {

/// The first lines of a text.
struct TextHead {
    std::vector<TextLine> lines;    // neither empty nor skipped
    std::optional<char> separator;  // what a line "sep=;" in front says
    bool isWhole{};                 // there are no more lines
};
TextHead headOf(TextView text, const ReadOptions& options, std::size_t most);

struct SampleRow {
    TextLine line;
    std::vector<CsvCell> cells;
    std::vector<CellKind> kinds;
    std::size_t filled{};  // cells up to the last one that is not empty
    int openQuote{};       // position of a quotation mark that is not closed; 0: none
};

SampleRow sampleRowOf(const TextLine& line, char separator);

/// A fault where a row has more cells than are read: to be asked before each of them is examined.
Diagnostics tooWide(const SampleRow& row, const std::string& file);

/// A number, a quantity or a stamp.
bool isValue(CellKind kind);

/// The first lines as rows, and the rows of data among them: [begin, end).
struct SampledRows {
    char separator{','};
    std::vector<SampleRow> rows;
    std::vector<TextLine> comments;
    std::size_t begin{}, end{};
    double score{};
    bool isKeyed{};                // words stand in front of each row, as in a preamble
    int otherBegin{}, otherEnd{};  // lines of another block of the same shape with a header behind it; 0: none
};

/// Cells of the longest row of data.
std::size_t widest(const SampledRows& sample);

/// The separator under which the most cells are numbers in rows of the same length.
SampledRows sampledRows(const TextHead& head);

/// What parts the digits of the numbers.
struct NumberMarks {
    std::optional<char> decimal;  // none: no cell has a mark
    char thousands{};             // 0: none
};

/// Found out from the rows of data and from what was told. Two readings that both make sense are a fault, and asked.
Outcome<NumberMarks> numberMarks(const SampledRows& rows, const ReadOptions& options, const std::string& file,
                                 Questions& asked);

/// The fault of a cell of which nobody can tell whether its mark stands for decimals or between thousands; both are
/// asked.
Diagnostic openMark(const CsvCell& cell, int line, const ReadOptions& options, const std::string& file,
                    Questions& asked);

}  // namespace analogon
