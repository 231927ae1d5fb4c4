#include "core/flat/dependent_nodes.hpp"

#include <algorithm>

namespace analogon {

DependentNodes::DependentNodes(const ExpressionPool& pool, std::span<const ExpressionId> roots) {
    NodeMap seen;
    std::vector<ExpressionId> stack;
    const auto visit = [&](ExpressionId id) {
        if (!id.valid() || !seen.insert(id.value, 0)) return;
        nodes_.push_back(id.value);
        stack.push_back(id);
    };
    const auto forEachPart = [&](std::uint32_t id, const auto& take) {
        const ExpressionNode& node = pool[ExpressionId{id}];
        if (node.operation == Operation::Delay) return;
        for (const ExpressionId part : {node.a, node.b, node.c})
            if (part.valid()) take(part);
    };
    for (const ExpressionId root : roots) visit(root);
    while (!stack.empty()) {
        const std::uint32_t id = stack.back().value;
        stack.pop_back();
        forEachPart(id, visit);
    }
    std::sort(nodes_.begin(), nodes_.end());
    for (std::uint32_t place = 0; place < nodes_.size(); ++place) placeOf_.insert(nodes_[place], place);

    // Parents of all nodes in one list: first how many each has, then who they are.
    firstParent_.assign(nodes_.size() + 1, 0);
    for (const std::uint32_t id : nodes_)
        forEachPart(id, [&](ExpressionId part) { ++firstParent_[*placeOf_.find(part.value) + 1]; });
    for (std::size_t place = 0; place < nodes_.size(); ++place) firstParent_[place + 1] += firstParent_[place];
    parents_.resize(firstParent_.back());
    std::vector<std::uint32_t> next(firstParent_.begin(), firstParent_.end() - 1);
    for (std::uint32_t place = 0; place < nodes_.size(); ++place)
        forEachPart(nodes_[place], [&](ExpressionId part) { parents_[next[*placeOf_.find(part.value)]++] = place; });
    visitOf_.assign(nodes_.size(), 0);
}

std::span<const std::uint32_t> DependentNodes::of(ExpressionId leaf) {
    found_.clear();
    const std::uint32_t* start = placeOf_.find(leaf.value);
    if (!start) return found_;
    ++visit_;
    visitOf_[*start] = visit_;
    found_.push_back(*start);
    for (std::size_t i = 0; i < found_.size(); ++i)
        for (std::uint32_t p = firstParent_[found_[i]]; p < firstParent_[found_[i] + 1]; ++p) {
            if (visitOf_[parents_[p]] == visit_) continue;
            visitOf_[parents_[p]] = visit_;
            found_.push_back(parents_[p]);
        }
    if (!std::is_sorted(found_.begin(), found_.end())) std::sort(found_.begin(), found_.end());
    for (std::uint32_t& place : found_) place = nodes_[place];
    return found_;
}

}  // namespace analogon
