#include "core/structure/matching.hpp"

#include <algorithm>

#include "core/base/stop.hpp"

namespace analogon {

Matching::Matching(const Adjacency& adjacency, int columns) : adjacency_(adjacency) { resize(columns); }

void Matching::resize(int columns) {
    columnOf_.resize(adjacency_.size(), -1);
    lookAhead_.resize(adjacency_.size(), 0);
    rowVisit_.resize(adjacency_.size(), 0);
    rowOf_.resize(static_cast<std::size_t>(columns), -1);
    columnVisit_.resize(static_cast<std::size_t>(columns), 0);
}

void Matching::assign(int row, int column) {
    columnOf_[static_cast<std::size_t>(row)] = column;
    rowOf_[static_cast<std::size_t>(column)] = row;
}

/// Depth-first search for an augmenting path, on a stack of its own: chains may be as long as the model.
bool Matching::search(int root, const std::vector<char>& isUsable) {
    struct Frame {
        int row;
        std::size_t next;
    };
    const auto usable = [&](int column) { return isUsable.empty() || isUsable[static_cast<std::size_t>(column)]; };
    std::vector<Frame> path{{root, 0}};
    rowVisit_[static_cast<std::size_t>(root)] = visit_;
    visitedRows_.push_back(root);
    while (!path.empty()) {
        const int row = path.back().row;
        const std::vector<int>& columns = adjacency_[static_cast<std::size_t>(row)];
        // A free column ends the path: flip it.
        int free = -1;
        int& look = lookAhead_[static_cast<std::size_t>(row)];
        for (int i = look; i < static_cast<int>(columns.size()) && free < 0; ++i) {
            const int column = columns[static_cast<std::size_t>(i)];
            if (rowOf(column) >= 0)
                look += i == look;
            else if (usable(column))
                free = column;
        }
        if (free >= 0) {
            for (auto frame = path.rbegin(); frame != path.rend(); ++frame) {
                const int previous = columnOf(frame->row);
                assign(frame->row, free);
                free = previous;
            }
            return true;
        }
        bool descended = false;
        for (std::size_t& next = path.back().next; next < columns.size() && !descended;) {
            const int column = columns[next++];
            if (!usable(column) || columnVisit_[static_cast<std::size_t>(column)] == visit_) continue;
            columnVisit_[static_cast<std::size_t>(column)] = visit_;
            visitedColumns_.push_back(column);
            const int owner = rowOf(column);
            if (rowVisit_[static_cast<std::size_t>(owner)] == visit_) continue;
            rowVisit_[static_cast<std::size_t>(owner)] = visit_;
            visitedRows_.push_back(owner);
            path.push_back({owner, 0});
            descended = true;
            break;
        }
        if (!descended) path.pop_back();
    }
    return false;
}

bool Matching::augment(int row, const std::vector<char>& isUsable) {
    stopPoint();
    ++visit_;
    visitedRows_.clear();
    visitedColumns_.clear();
    return search(row, isUsable);
}

bool Matching::augmentAll(const std::vector<char>& isUsable) {
    std::vector<int> order;
    for (int row = 0; row < static_cast<int>(adjacency_.size()); ++row)
        if (columnOf(row) < 0) order.push_back(row);
    std::stable_sort(order.begin(), order.end(), [this](int a, int b) {
        return adjacency_[static_cast<std::size_t>(a)].size() < adjacency_[static_cast<std::size_t>(b)].size();
    });
    bool all = true;
    for (const int row : order) all = augment(row, isUsable) && all;
    return all;
}

std::vector<std::vector<int>> strongComponents(const Adjacency& successors) {
    const auto n = successors.size();
    std::vector<int> index(n, -1), low(n, 0), stack;
    std::vector<char> isOnStack(n, 0);
    std::vector<std::vector<int>> components;
    struct Frame {
        int node;
        std::size_t next;
    };
    std::vector<Frame> path;
    int counter = 0;
    const auto open = [&](int node) {
        const auto i = static_cast<std::size_t>(node);
        index[i] = low[i] = counter++;
        stack.push_back(node);
        isOnStack[i] = 1;
        path.push_back({node, 0});
    };
    for (int start = 0; start < static_cast<int>(n); ++start) {
        if (index[static_cast<std::size_t>(start)] >= 0) continue;
        open(start);
        while (!path.empty()) {
            const int node = path.back().node;
            const auto i = static_cast<std::size_t>(node);
            if (path.back().next < successors[i].size()) {
                const int to = successors[i][path.back().next++];
                const auto t = static_cast<std::size_t>(to);
                if (index[t] < 0)
                    open(to);
                else if (isOnStack[t])
                    low[i] = std::min(low[i], index[t]);
                continue;
            }
            path.pop_back();
            if (!path.empty()) {
                const auto parent = static_cast<std::size_t>(path.back().node);
                low[parent] = std::min(low[parent], low[i]);
            }
            if (low[i] != index[i]) continue;
            std::vector<int> component;
            int member;
            do {
                member = stack.back();
                stack.pop_back();
                isOnStack[static_cast<std::size_t>(member)] = 0;
                component.push_back(member);
            } while (member != node);
            std::sort(component.begin(), component.end());
            components.push_back(std::move(component));
        }
    }
    return components;
}

}  // namespace analogon
