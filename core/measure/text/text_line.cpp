#include "core/measure/text/text_line.hpp"

#include <algorithm>
#include <cstring>

namespace analogon {

/// Looked for once, though many lines may end before it with CR.
void LineReader::findFeed(const char* loaded) {
    const char* const begin = rest_.data();
    if (feed_ && feed_ >= begin) return;
    const char* const from = searched_ && searched_ > begin ? searched_ : begin;
    feed_ = static_cast<const char*>(std::memchr(from, '\n', static_cast<std::size_t>(loaded - from)));
    searched_ = feed_ ? feed_ : loaded;
}

const char* LineReader::endOfLine() {
    const char* const begin = rest_.data();
    const char* const end = begin + rest_.size();
    for (const char* from = begin;;) {
        const char* const loaded = supply_ ? std::min(supply_->loaded(), end) : end;
        findFeed(loaded);
        const char* const stop = feed_ ? feed_ : loaded;
        if (const void* const cr = std::memchr(from, '\r', static_cast<std::size_t>(stop - from))) {
            const auto* const found = static_cast<const char*>(cr);
            if (found + 1 == loaded && loaded != end) supply_->loadMore();  // a line feed may follow
            return found;
        }
        if (feed_ || loaded == end) return stop;
        from = loaded;
        supply_->loadMore();
    }
}

bool LineReader::next(TextLine& line) {
    if (rest_.empty()) return false;
    const char* const begin = rest_.data();
    const char* const end = begin + rest_.size();
    const char* stop = endOfLine();
    line = {std::string_view(begin, static_cast<std::size_t>(stop - begin)), ++number_};
    if (stop != end) ++stop;
    if (stop != end && stop[-1] == '\r' && *stop == '\n') ++stop;
    rest_ = std::string_view(stop, static_cast<std::size_t>(end - stop));
    return true;
}

namespace {

/// Whether a quotation mark opens a cell that does not end on the line.
bool isOpen(std::string_view text) {
    constexpr std::string_view separators = ",;\t|";
    bool isQuoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '"') continue;
        if (isQuoted && i + 1 < text.size() && text[i + 1] == '"') {
            ++i;
        } else if (isQuoted) {
            isQuoted = false;
        } else {
            const std::size_t before = text.substr(0, i).find_last_not_of(' ');
            isQuoted = before == std::string_view::npos || separators.find(text[before]) != std::string_view::npos;
        }
    }
    return isQuoted;
}

}  // namespace

void joinQuoted(TextLine& line, LineReader& reader) {
    constexpr int most = 5;
    if (!isOpen(line.text)) return;
    LineReader ahead = reader;
    TextLine next;
    for (int i = 0; i < most && ahead.next(next); ++i) {
        const char* const end = next.text.data() + next.text.size();
        const std::string_view whole(line.text.data(), static_cast<std::size_t>(end - line.text.data()));
        if (isOpen(whole)) continue;
        line.text = whole;
        reader = ahead;
        return;
    }
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
