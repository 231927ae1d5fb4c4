#pragma once

#include <mutex>
#include <string>
#include <utility>
#include <vector>

/// What the search decided, one after the other: by it one sees why a finding is what it is, and what another version
/// of the search decides otherwise.
namespace analogon {

struct Decision {
    using Figures = std::vector<std::pair<std::string, double>>;

    std::string step;  // "null fit", "screen", "trial", "judge", "choose", "revise", "reading", "path", "finding" …
    /// What is claimed, the same in every run: keyOf() of an effect at a place, those of several joined by " + ", a
    /// reading of a recording ("clock u"), a course of a parameter ("change rotor.J"); empty: the model as given.
    std::string key;
    int path{}, round{};
    Figures figures;      // by which it was decided; not finite: not known
    std::string verdict;  // "chosen", "kept", "taken out", "accepted" …
    std::string reason;   // in words; empty: the verdict says it all
};

/// Receives decisions from any thread. The search makes them between its parallel passes: their order is the same on
/// any number of threads.
class DecisionTrace {
public:
    void add(Decision decision);
    std::vector<Decision> decisions() const;

private:
    mutable std::mutex guard_;
    std::vector<Decision> decisions_;
};

}  // namespace analogon
