#pragma once

#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace analogon {

/// Rows of equations in groups that share an unknown, directly or through others: what is eliminated in one of them
/// concerns no other (disjoint sets, Galler and Fischer 1964). `unknownsOf(row)`: the numbers of those that count.
template <class Row, class UnknownsOf>
std::vector<std::vector<Row>> groupsThatShare(std::vector<Row> rows, const UnknownsOf& unknownsOf) {
    std::vector<std::size_t> group(rows.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto find = [&group](std::size_t i) {
        while (group[i] != i) i = group[i] = group[group[i]];
        return i;
    };
    std::map<int, std::size_t> firstWith;
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (const int unknown : unknownsOf(rows[r])) {
            const auto [at, isNew] = firstWith.emplace(unknown, r);
            if (!isNew) group[find(r)] = find(at->second);
        }
    std::map<std::size_t, std::vector<Row>> members;
    for (std::size_t r = 0; r < rows.size(); ++r) members[find(r)].push_back(std::move(rows[r]));
    std::vector<std::vector<Row>> groups;
    for (auto& [first, each] : members) groups.push_back(std::move(each));
    return groups;
}

}  // namespace analogon
