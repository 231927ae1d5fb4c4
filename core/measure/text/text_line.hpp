#pragma once

#include <string_view>

#include "core/measure/text/text_view.hpp"

namespace analogon {

struct TextLine {
    std::string_view text;
    int number{};  // 1-based
};

/// Takes lines off a text whose lines end with CR, LF or CRLF.
class LineReader {
public:
    explicit LineReader(TextView text, int before = 0) : rest_(text.text), supply_(text.supply), number_(before) {}

    bool next(TextLine& line);

private:
    const char* endOfLine();
    void findFeed(const char* loaded);

    std::string_view rest_;
    TextSupply* supply_;
    const char* feed_{};      // the next line feed; null: none in what is loaded
    const char* searched_{};  // up to where there is none
    int number_{};
};

/// Takes the lines behind one in which a quoted cell goes on, as spreadsheets write names of several lines. The line is
/// as it was where no mark closes the cell on one of the next lines.
void joinQuoted(TextLine& line, LineReader& reader);

/// A line that begins with #, % or //; with a semicolon, too, where that is no mark between columns.
bool isComment(std::string_view line, char separator);

/// Nothing but blanks and quotation marks.
bool isEmptyLine(std::string_view line);

}  // namespace analogon
