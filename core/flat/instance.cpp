#include "core/flat/instance.hpp"

#include <fmt/format.h>

namespace analogon {

Element* Instance::find(std::string_view elementName) {
    constexpr std::size_t few = 16;  // a linear search is faster up to here
    if (elements.size() <= few) {
        for (Element& element : elements)
            if (element.declaration->name == elementName) return &element;
        return nullptr;
    }
    for (std::size_t i = index_.size(); i < elements.size(); ++i) index_.emplace(elements[i].declaration->name, i);
    const auto found = index_.find(elementName);
    return found == index_.end() ? nullptr : &elements[found->second];
}

std::vector<std::string> Instance::elementNames() const {
    std::vector<std::string> names;
    for (const Element& element : elements) names.push_back(element.declaration->name);
    return names;
}

std::string Instance::memberName(std::string_view member) const {
    return name.empty() ? std::string(member) : fmt::format("{}.{}", name, member);
}

Instance& Instance::component() {
    Instance* instance = this;
    while (!instance->isComponent() && instance->parent) instance = instance->parent;
    return *instance;
}

bool Instance::isOfRecord() const {
    return isRecord() || definition->definition->restriction == syntax::ClassDefinition::Restriction::Record;
}

Text Instance::label() const {
    return name.empty() ? phrase("model '{}'", className) : phrase("component '{}' ({})", name, className);
}

}  // namespace analogon
