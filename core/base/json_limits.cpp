#include "core/base/json_limits.hpp"

#include <vector>

namespace analogon {

Outcome<Done> checkJsonLimits(const Source& json, const JsonSize& most) {
    const std::string& text = json.text();
    if (text.size() > most.bytes)
        return fileError(phrase("the file has {:.3g} MB, more than the {} MB that are read",
                                static_cast<double>(text.size()) / 1048576.0, most.bytes >> 20),
                         json.name(), 0, 0, phrase("Measured values belong into files of their own."));
    std::vector<std::size_t> paths;  // bytes of the names that lead into each object or list that is open
    std::size_t values = 0, allPaths = 0, name = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        const Span here{&json, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(at + 1)};
        if (c == '"') {
            const std::size_t begin = at;
            for (++at; at < text.size() && text[at] != '"'; ++at)
                if (text[at] == '\\') ++at;
            name = at - begin;
        } else if (c == '[' || c == '{') {
            paths.push_back((paths.empty() ? 0 : paths.back()) + name + 1);
            name = 0;
            if (paths.size() > limits::jsonDepth)
                return error(phrase("objects and lists stand within each other more than {} deep", limits::jsonDepth),
                             here, phrase("A study needs fewer than ten levels."));
        } else if ((c == ']' || c == '}') && !paths.empty()) {
            paths.pop_back();
        }
        if (c != '[' && c != '{' && c != ',') continue;
        allPaths += paths.empty() ? 0 : paths.back();
        if (++values > most.values || allPaths > limits::jsonPaths)
            return error(values > most.values ? phrase("the file has more than {} values", most.values)
                                              : phrase("the names in this file are too long and too many"),
                         here, phrase("Measured values belong into files of their own."));
    }
    return Done{};
}

}  // namespace analogon
