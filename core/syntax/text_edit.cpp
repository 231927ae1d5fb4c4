#include "core/syntax/text_edit.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace analogon::syntax {

void TextEdit::normalise() {
    // At one offset an insertion stands before a replacement of the text behind it, whatever order they came in.
    std::stable_sort(replacements.begin(), replacements.end(), [](const Replacement& a, const Replacement& b) {
        return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
    });
    for (std::size_t i = 0; i < replacements.size(); ++i) {
        assert(replacements[i].begin <= replacements[i].end);
        assert(i == 0 || replacements[i - 1].end <= replacements[i].begin);
    }
}

AppliedEdit apply(const std::string& text, TextEdit edit) {
    edit.normalise();
    assert(edit.replacements.empty() || edit.replacements.back().end <= text.size());
    AppliedEdit result;
    result.inverse.what = std::move(edit.what);
    result.inverse.replacements.reserve(edit.replacements.size());
    std::size_t copied = 0;
    for (const Replacement& replacement : edit.replacements) {
        result.text.append(text, copied, replacement.begin - copied);
        const auto begin = static_cast<std::uint32_t>(result.text.size());
        result.text += replacement.text;
        const auto end = static_cast<std::uint32_t>(result.text.size());
        result.inverse.replacements.push_back(
            {begin, end, text.substr(replacement.begin, replacement.end - replacement.begin)});
        copied = replacement.end;
    }
    result.text.append(text, copied, std::string::npos);
    return result;
}

}  // namespace analogon::syntax
