#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace analogon {

/// Classes of equal (up to sign) or constant quantities, closed under time differentiation: union-find with
/// signs, where each class knows the class of its derivative. Entities are numbered by the caller.
class AliasClasses {
public:
    struct Signed {
        int entity{-1};
        int sign{1};
    };
    struct Class {
        std::optional<double> constant;  // of the class's root
        int known{-1};                   // an entity that is given from outside (an input)
        Signed derivative;               // derivative of the root; entity -1: not in use
        std::vector<int> waiting;        // rows to look at again when the class changes
    };
    enum class Merge { Done, Same, Contradiction, Cycle, BothKnown };

    int add();
    int size() const { return static_cast<int>(parent_.size()); }
    Signed find(int entity) const;
    const Class& of(int root) const { return classes_[static_cast<std::size_t>(root)]; }
    Class& of(int root) { return classes_[static_cast<std::size_t>(root)]; }

    /// `derivative` is the time derivative of `entity`.
    void link(int entity, int derivative);
    /// a = sign * b, and so for their derivatives.
    Merge unite(int a, int b, int sign);
    /// entity = value, and its derivative = 0.
    Merge assign(int entity, double value);

    /// Roots whose class changed since the last call.
    std::vector<int> takeChanged() { return std::exchange(changed_, {}); }
    /// Equalities a = sign * b that had to be left to the equations (a derivative equal to its own integral).
    struct Left {
        int a, b, sign;
    };
    std::vector<Left> takeLeft() { return std::exchange(left_, {}); }

private:
    bool reaches(int from, int to) const;
    Merge uniteOne(int a, int b, int sign, std::deque<Left>& more);

    mutable std::vector<int> parent_;
    mutable std::vector<signed char> sign_;
    std::vector<int> size_;
    std::vector<Class> classes_;
    std::vector<int> changed_;
    std::vector<Left> left_;
};

}  // namespace analogon
