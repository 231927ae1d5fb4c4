#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/diagram/edit.hpp"

/// One element of an array of parameters cannot be modified in Modelica (section 7.2.5): the whole array is written.
namespace analogon {

/// "mass[2].link[1,3].C": the name without subscripts, and where they go.
struct ModelEdit::ArrayName {
    explicit ArrayName(std::string_view flatName) {
        for (std::size_t i = 0; i < flatName.size();) {
            if (flatName[i] != '[') {
                plain += flatName[i++];
                continue;
            }
            const std::size_t end = std::min(flatName.find(']', i), flatName.size());
            const std::string list(flatName.substr(i + 1, end - i - 1));
            int count = 0;
            for (const char* at = list.c_str(); *at != '\0'; ++count) {
                char* behind = nullptr;
                index.push_back(static_cast<int>(std::strtol(at, &behind, 10)));
                at = *behind == ',' ? behind + 1 : "";
            }
            groups.emplace_back(plain.size(), count);
            i = end + 1;
        }
    }

    /// The flat name of another element.
    std::string at(const std::vector<int>& subscripts) const {
        std::string name;
        std::size_t from = 0, next = 0;
        for (const auto& [position, count] : groups) {
            name += plain.substr(from, position - from) + "[";
            for (int i = 0; i < count; ++i) name += fmt::format("{}{}", i == 0 ? "" : ",", subscripts[next++]);
            name += "]";
            from = position;
        }
        return name + plain.substr(from);
    }

    std::string plain;
    std::vector<int> index;                           // all subscripts, from left to right
    std::vector<std::pair<std::size_t, int>> groups;  // place in `plain`, number of subscripts
};

ModelEdit& ModelEdit::valuesOf(std::function<std::optional<std::string>(const std::string&)> lookup) {
    lookup_ = std::move(lookup);
    return *this;
}

std::optional<std::string> ModelEdit::elementValue(const ArrayName& name, const std::vector<int>& index) const {
    const std::string flatName = name.at(index);
    const std::optional<std::string> present = lookup_ ? lookup_(flatName) : std::nullopt;
    if (const auto set = elements_.find(flatName); present && set != elements_.end()) return set->second;
    return present;
}

/// The values below the subscripts before `dimension`, as nested braces; empty when there are none.
std::string ModelEdit::arrayText(const ArrayName& name, std::vector<int>& index, std::size_t dimension) const {
    if (dimension == index.size()) return elementValue(name, index).value_or("");
    std::string text;
    for (index[dimension] = 1;; ++index[dimension]) {
        std::fill(index.begin() + static_cast<std::ptrdiff_t>(dimension) + 1, index.end(), 1);
        const std::string element = arrayText(name, index, dimension + 1);
        if (element.empty()) break;
        text += (text.empty() ? "" : ", ") + element;
    }
    return text.empty() ? text : "{" + text + "}";
}

void ModelEdit::setElement(std::string_view flatName, const std::string& value) {
    const ArrayName name(flatName);
    if (!elementValue(name, name.index)) {
        faults_.push_back(error(phrase("\"{}\" of model {} cannot be set: the values of the other elements are not "
                                       "known",
                                       name.at(name.index), definition_->name),
                                definition_->nameSpan, phrase("set the whole array")));
        return;
    }
    elements_[name.at(name.index)] = value;
    std::vector<int> index(name.index.size(), 1);
    setParameter(name.plain, arrayText(name, index, 0));
}

}  // namespace analogon
