#include <algorithm>
#include <string>

#include "core/flat/instantiator.hpp"
#include "core/flat/translator.hpp"

/// Sizes of what is declared (Modelica 3.6, section 10.1), and how large a model may become.
namespace analogon {

std::optional<std::vector<int>> Instantiator::dimensionsOf(Instance& instance, Element& element) {
    std::vector<ResolvedType::Dimension> sizes;
    const bool ownSizes = !element.declaration->dimensions.empty() || element.declaration == element.original;
    const Scope scope = ownSizes ? element.scope : Scope{&instance, element.owner};
    for (const auto& size : (ownSizes ? element.declaration : element.original)->dimensions)
        sizes.push_back({&size, scope});
    sizes.insert(sizes.end(), element.type.dimensions.begin(), element.type.dimensions.end());

    std::vector<int> result;
    for (const auto& [size, sizeScope] : sizes) {
        element.dimensions = result;  // a size may speak of those before it: A[:, size(A, 1)]
        const std::string name = instance.memberName(element.declaration->name);
        if (size->kind != syntax::Expression::Kind::Colon) {
            const auto ofType = work_.translator->valuesOfType(*size, sizeScope);
            const auto extent =
                ofType ? std::optional(ofType->dimensions[0])
                       : work_.translator->constantInteger(*size, sizeScope, phrase("the size of '{}'", name));
            if (!extent) return std::nullopt;
            if (*extent < 0) {
                work_.messages.error(phrase("the size of '{}' is negative ({})", name, *extent), size->span);
                return std::nullopt;
            }
            result.push_back(*extent);
            continue;
        }
        // The size is that of the value.
        if (!element.modifier.value.valid()) {
            work_.messages.error(phrase("'{}' has an open size and no value that would give it", name), size->span,
                                 phrase("write the size or a value"));
            return std::nullopt;
        }
        const auto value = work_.translator->translate(element.modifier.value);
        if (!value) return std::nullopt;
        if (value->dimensions.size() <= result.size()) {
            work_.messages.error(
                phrase("the value of '{}' has {} dimensions, its declaration more", name, value->dimensions.size()),
                element.modifier.value.expression->span);
            return std::nullopt;
        }
        result.push_back(value->dimensions[result.size()]);
    }
    return result;
}

bool Instantiator::reserve(const Element& element, const std::string& name) {
    std::size_t count = 1;
    for (int d : element.dimensions) {
        count *= static_cast<std::size_t>(d);
        if (count == 0 || count > mostScalars) break;
    }
    std::size_t& total = element.isVariable() ? scalars_ : items_;
    const std::size_t most = element.isVariable() ? mostScalars : mostComponents;
    total += std::min(count, most + 1);
    if (total <= most) return true;
    const std::string size = sizeText(element.dimensions);
    work_.messages.fatal(element.isVariable()
                             ? phrase("'{}{}' makes the model larger than {} scalars", name, size, most)
                             : phrase("'{}{}' makes the model larger than {} components", name, size, most),
                         element.declaration->nameSpan, phrase("use a smaller size"));
    return false;
}

}  // namespace analogon
