#include "core/measure/text/text_line.hpp"

#include <cstring>

namespace analogon {

bool LineReader::next(TextLine& line) {
    if (rest_.empty()) return false;
    const char* const begin = rest_.data();
    const char* const end = begin + rest_.size();
    if (feed_ < begin || !feed_) {  // looked for once, though many lines end before it with CR
        feed_ = static_cast<const char*>(std::memchr(begin, '\n', rest_.size()));
        if (!feed_) feed_ = end;
    }
    const char* stop = feed_;
    if (const void* const cr = std::memchr(begin, '\r', static_cast<std::size_t>(stop - begin)))
        stop = static_cast<const char*>(cr);
    line = {std::string_view(begin, static_cast<std::size_t>(stop - begin)), ++number_};
    if (stop != end) ++stop;
    if (stop != end && stop[-1] == '\r' && *stop == '\n') ++stop;
    rest_ = std::string_view(stop, static_cast<std::size_t>(end - stop));
    return true;
}

bool isComment(std::string_view line, char separator) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return false;
    line.remove_prefix(first);
    return line.front() == '#' || line.front() == '%' || line.starts_with("//") ||
           (line.front() == ';' && separator != ';');
}

bool isEmptyLine(std::string_view line) { return line.find_first_not_of(" \t\"") == std::string_view::npos; }

}  // namespace analogon
