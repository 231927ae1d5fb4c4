#include "core/structure/alias_classes.hpp"

#include <cmath>

namespace analogon {

int AliasClasses::add() {
    parent_.push_back(size());
    sign_.push_back(1);
    size_.push_back(1);
    classes_.emplace_back();
    return size() - 1;
}

AliasClasses::Signed AliasClasses::find(int entity) const {
    int root = entity, sign = 1;
    while (parent_[static_cast<std::size_t>(root)] != root) {
        sign *= sign_[static_cast<std::size_t>(root)];
        root = parent_[static_cast<std::size_t>(root)];
    }
    // Path compression: every entity on the way points at the root with its sign to it.
    for (int at = entity, s = sign; at != root;) {
        const auto i = static_cast<std::size_t>(at);
        const int next = parent_[i], nextSign = s * sign_[i];
        parent_[i] = root;
        sign_[i] = static_cast<signed char>(s);
        at = next;
        s = nextSign;
    }
    return {root, sign};
}

void AliasClasses::link(int entity, int derivative) {
    const Signed e = find(entity);
    Signed& slot = of(e.entity).derivative;
    if (slot.entity < 0)
        slot = {derivative, e.sign};
    else
        unite(slot.entity, derivative, slot.sign * e.sign);
}

/// Whether `to` is a derivative of `from`, of whatever order.
bool AliasClasses::reaches(int from, int to) const {
    const int target = find(to).entity;
    int at = find(from).entity;
    for (int steps = 0; steps < 64; ++steps) {
        const Signed next = of(at).derivative;
        if (next.entity < 0) return false;
        at = find(next.entity).entity;
        if (at == target) return true;
    }
    return true;
}

AliasClasses::Merge AliasClasses::uniteOne(int a, int b, int sign, std::deque<Left>& more) {
    Signed ra = find(a), rb = find(b);
    sign *= ra.sign * rb.sign;  // root a = sign * root b
    if (ra.entity == rb.entity) {
        if (sign > 0 || (of(ra.entity).constant && *of(ra.entity).constant == 0)) return Merge::Same;
        return assign(ra.entity, 0);  // x = -x
    }
    if (of(ra.entity).constant) return assign(rb.entity, sign * *of(ra.entity).constant);
    if (of(rb.entity).constant) return assign(ra.entity, sign * *of(rb.entity).constant);
    if (of(ra.entity).known >= 0 && of(rb.entity).known >= 0) return Merge::BothKnown;
    if (reaches(ra.entity, rb.entity) || reaches(rb.entity, ra.entity)) return Merge::Cycle;

    if (size_[static_cast<std::size_t>(ra.entity)] < size_[static_cast<std::size_t>(rb.entity)]) std::swap(ra, rb);
    const auto child = static_cast<std::size_t>(rb.entity);
    parent_[child] = ra.entity;
    sign_[child] = static_cast<signed char>(sign);
    size_[static_cast<std::size_t>(ra.entity)] += size_[child];
    Class& into = of(ra.entity);
    Class& from = of(rb.entity);
    if (from.known >= 0) into.known = from.known;
    if (into.waiting.size() < from.waiting.size()) into.waiting.swap(from.waiting);
    into.waiting.insert(into.waiting.end(), from.waiting.begin(), from.waiting.end());
    from.waiting = {};
    if (from.derivative.entity >= 0) {
        const Signed moved{from.derivative.entity, from.derivative.sign * sign};
        if (into.derivative.entity < 0)
            into.derivative = moved;
        else
            more.push_back({into.derivative.entity, moved.entity, into.derivative.sign * moved.sign});
    }
    changed_.push_back(ra.entity);
    return Merge::Done;
}

AliasClasses::Merge AliasClasses::unite(int a, int b, int sign) {
    std::deque<Left> more;
    const Merge first = uniteOne(a, b, sign, more);
    while (!more.empty()) {
        const Left next = more.front();
        more.pop_front();
        const Merge merged = uniteOne(next.a, next.b, next.sign, more);
        if (merged == Merge::Cycle || merged == Merge::BothKnown || merged == Merge::Contradiction)
            left_.push_back(next);
    }
    return first;
}

AliasClasses::Merge AliasClasses::assign(int entity, double value) {
    Signed root = find(entity);
    value *= root.sign;
    for (int order = 0; root.entity >= 0; ++order, value = 0) {
        Class& c = of(root.entity);
        if (c.known >= 0) return order == 0 ? Merge::BothKnown : Merge::Contradiction;
        if (c.constant) {
            const double scale = std::fabs(value) + std::fabs(*c.constant);
            if (std::fabs(value - *c.constant) > 1e-12 * scale) return Merge::Contradiction;
            return order == 0 ? Merge::Same : Merge::Done;
        }
        c.constant = value;
        changed_.push_back(root.entity);
        if (c.derivative.entity < 0) break;
        root = find(c.derivative.entity);
    }
    return Merge::Done;
}

}  // namespace analogon
