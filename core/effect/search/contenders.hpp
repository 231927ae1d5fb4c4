#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/effect/judge/node.hpp"
#include "core/effect/search/round.hpp"

/// Trials that compete by what they predict, and nodes compared by it.
namespace analogon {

class Journal;
class SearchContext;

/// Whether an effect is a name that may be indicated: with few enough parameters not to follow any course by its shape.
bool mayBeIndicated(const PlacedEffect& placed);

/// A line of the journal on how much better a model predicts with an effect (`key`).
void tell(const Journal& journal, const std::string& step, const std::string& key, const Prediction& prediction,
          const std::string& verdict);

/// A trial that makes the model predict clearly better.
struct Contender {
    std::size_t trial{};  // of those of the round
    Prediction prediction;
};

/// Those of the trials beside a model that do so. A long dead time must do so by a good part of what is left.
std::vector<Contender> contendersOf(const SearchContext& search, const NullModel& null,
                                    const std::vector<Trial>& trials);

/// The simplest of those that predict nearly as well as the best stands for all of them: the round's choice, with the
/// others as the members of its class; of those that are as simple and met as often, one that is clearly likelier
/// beside a flow that nobody measured. Where one has failed, what seems to predict best goes before the simplest.
enum class First { Simplest, Best };
void chooseAmong(const SearchContext& search, const NullModel& null, const std::vector<Contender>& contenders,
                 First first, Round& round);

/// Takes the round's choice, which has failed, out of the contenders, with those that follow the same course.
void passOver(const Round& round, std::vector<Contender>& contenders);

/// A node with what a round has chosen, refitted; nothing where the whole does not predict clearly better than it did
/// before: a trial that has not come to its end may seem to. `chosen`: what it was chosen by.
std::optional<Node> withChoice(SearchContext& search, const Node& node, const Round& round, const Prediction& chosen);

/// Tries up to mostTries of the contenders, the simplest first and then the best: the node with the first that,
/// refitted, makes it predict clearly better and that `accepts` takes; it is the round's choice then. Nothing: none
/// does.
std::optional<Node> firstThatHolds(SearchContext& search, const Node& node, std::vector<Contender> contenders,
                                   Round& round, const std::function<bool(const Node&)>& accepts);

/// Whether a model predicts clearly better than another on the same recordings, beside the same noise.
bool predictsClearlyBetter(const SearchContext& search, const NullModel& with, const NullModel& without);

/// Whether a node is the better account of another's recordings: by what it predicts, beside fewer parameters and
/// without a long dead time also where it predicts nearly as well.
bool predictsBetter(const SearchContext& search, const Node& node, const Node& than);

}  // namespace analogon
