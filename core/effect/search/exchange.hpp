#pragma once

#include <set>
#include <string>

#include "core/effect/judge/node.hpp"

/// Effects tried again beside those that joined them: one in the place of another, one in the place of two.
namespace analogon {

class SearchContext;

/// What speaks for a rival in the place of an effect.
struct RivalCase {
    double gain{};            // evidence that the model gains [BIC]
    double weight{1};         // part of the samples that are independent
    int likelier{};           // by how much it is the likelier kind; negative: the less likely
    bool isSimplerEqual{};    // it explains nearly as much with fewer parameters
    bool isLikelierEqual{};   // it explains nearly as much, is likelier, and much is left beside either
    bool isAtTheEndOfMuch{};  // much is left beside either, and the search is at its end
};
/// Whether it takes that place: exact twins do not, and what the data hardly tell apart is not exchanged for the less
/// likely.
bool isExchanged(const RivalCase& rival);

enum class Rivals { Known, New };  // of its round; what goes to its place or is the same fault of another signal

/// Whether a trial explains no less than so much evidence as far as the data tell, a part (`weight`) of whose samples
/// are independent.
bool isLike(const Trial& trial, double evidence, double weight);

/// Tries the rivals of one effect again, now that others have joined it: what came second alone may be the better
/// half of a pair. True when one of them took its place (at the end of the list). `elsewhere`: the same effect at that
/// place instead.
bool replace(SearchContext& search, Node& node, std::size_t effect, Rivals wanted,
             const EffectPlace* elsewhere = nullptr);

/// Sets of effects in which a node has stood.
class Visited {
public:
    explicit Visited(const Node& node) { add(node); }
    /// False: it has stood there before.
    bool add(const Node& node);

private:
    std::set<std::set<std::string>> sets_;
};

/// Gives the rivals of every effect but the newest another chance. It ends: no set of effects is come to twice.
bool reconsider(SearchContext& search, Node& node);

/// Puts together what the search has taken apart.
void unite(SearchContext& search, Node& node);

/// What goes to the place of an effect may do as well beside the others, though no round has tried it, and so may the
/// same fault of another signal: at the end each is held against what is new of that.
void completeClasses(SearchContext& search, Node& node);

}  // namespace analogon
