/// Two effects that hide each other: neither need show alone, and the strongest alone need not be one of them.
#include <algorithm>

#include "core/effect/search.hpp"

namespace analogon {

/// The members of the pairs that explain most together, each pair by the one that explains more alone; at most `most`,
/// none of `taken`.
std::vector<std::size_t> Search::pairBeginnings(const NullModel& null, const Round& round, std::size_t most,
                                                const std::vector<std::size_t>& taken) const {
    struct Pair {
        std::size_t stronger, weaker;
        double explained;
    };
    const Eigen::VectorXd& residual = null.fit.optimum.residuals;
    std::vector<std::size_t> named;
    for (std::size_t i = 0; i < round.trials.size(); ++i)
        if (round.trials[i].ok && round.trials[i].evidence > 0 && !isProposal(round.trials[i])) named.push_back(i);
    std::vector<Pair> pairs;
    for (std::size_t a = 0; a < named.size(); ++a)
        for (std::size_t b = a + 1; b < named.size(); ++b) {
            const Trial &x = round.trials[named[a]], &y = round.trials[named[b]];
            if (x.screened.candidate.place.at == y.screened.candidate.place.at &&
                x.screened.candidate.effect.kind == y.screened.candidate.effect.kind)
                continue;
            pairs.push_back({named[a], named[b],
                             explainedTogether(x.screened.probes.front().plain.directions,
                                               y.screened.probes.front().plain.directions, residual)});
        }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& p, const Pair& q) { return p.explained > q.explained; });
    std::vector<std::size_t> begins;
    const auto isThere = [&](std::size_t i) {
        const auto holds = [&](const std::vector<std::size_t>& list) {
            return std::find(list.begin(), list.end(), i) != list.end();
        };
        return holds(taken) || holds(begins);
    };
    for (const Pair& p : pairs) {
        if (begins.size() == most) break;
        if (!isThere(p.stronger) && !isThere(p.weaker)) begins.push_back(p.stronger);
        if (p.explained < 0.95 * pairs.front().explained) break;
    }
    return begins;
}

}  // namespace analogon
