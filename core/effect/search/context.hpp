#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/work.hpp"
#include "core/effect/course/courses.hpp"
#include "core/effect/judge/node.hpp"
#include "core/effect/reading/readings.hpp"
#include "core/effect/search/discover.hpp"
#include "core/effect/search/journal.hpp"

/// What one search works with and where it has been. A pass takes it beside the node that it works on.
namespace analogon {

/// Ends a search that has done as much as it may, or that is asked to stop from outside.
class WorkLimit {
public:
    WorkLimit(double most, const std::stop_token& outside)
        : most_(most), asked_(outside, [this] { end_.request_stop(); }) {}

    void add(double steps);
    /// Ends the search where it has simulated more than `most` steps in all; 0: no limit.
    void limitSimulated(double most) { mostSimulated_ = most; }
    void check();
    bool isSpent() const { return isSpent_; }
    WorkCount simulated;
    double done{};       // in steps of the trials
    int clockChanges{};  // that is, inputs drawn at other times, which must not go on for ever
    std::stop_token token() const { return end_.get_token(); }

private:
    double most_;             // 0: no limit
    double mostSimulated_{};  // 0: no limit
    bool isSpent_{};
    std::stop_source end_;
    std::stop_callback<std::function<void()>> asked_;
};

/// What a search may simulate before it says what it has, in steps: as often as `patience` what the fit of the model as
/// given (`fitWork` steps) asks for, and at least what takes a minute. 0: no limit.
double workAllowed(double patience, double fitWork);

/// Where a path has been.
struct Stay {
    std::set<std::string> effects;  // by keysOf()
    double misfit{};                // by one measure or another, see Frontier
    int path{};

    /// The same effects at the same optimum: what follows is known.
    bool isLike(const Stay& other) const;
};

/// A node that may be reported, and how the recordings were read when it was reached: another reading may have been
/// begun since.
struct Whole {
    Node node;
    Readings readings;
    bool predicts{};                          // clearly better than the model as given
    bool isOnAll{};                           // the node is of all samples, where the search works on fewer
    std::optional<ModelState> errorsOnAll{};  // at its values, without bands; there alone
    bool isBehindLikeliest{};                 // predicts no better than BestOfNamed::likeliest, and leaves structure
};

/// Where a search has been: what follows there is known.
struct Stays {
    std::vector<Stay> visited{};  // with the error of the fitted data [%]
    std::vector<Stay> lawless{};  // where no law passed, with the sum of squares
};

/// What predicts clearly better than the model as given, or is likelier beside it than a flow alone that nobody
/// measured.
struct SoughtFirst {
    Eigen::VectorXd residuals{};  // of that model; empty: it was not sought
    std::size_t candidates{};     // among which
    std::optional<Node> node{};   // none is
    bool isFlowAlone{};           // and nothing at all is clearly likelier
    /// Whether it was sought beside this model: it leaves the same, whatever level of noise it is held against.
    bool isBeside(const NullModel& null) const;
};

/// The best so far, of named effects.
struct BestOfNamed {
    std::optional<Whole> whole{};      // what an interrupted search reports
    std::optional<Whole> clear{};      // that was clear, where `whole` is not
    std::optional<Whole> unweighed{};  // better by what a round chose and has not weighed against the rest
    std::optional<Whole> likeliest{};  // what predicts best beside the model as given, or is likeliest beside a flow;
                                       // told where none of these is clear, or predicts better
    SoughtFirst first{};
};

/// The nodes that were reached.
struct Frontier {
    std::vector<Node> otherEnds{};  // of paths that explain less than the best
    Stays stays{};
    std::optional<NullModel> origin{};  // of the path: without effects
    std::optional<Node> opening{};      // where the first choice of all led
    BestOfNamed best{};
    std::vector<CandidateResult> noted{};  // of the path that was walked on last
    std::optional<Finding> begun{};        // the model as given: from there on there is something to report
    bool isIndicating{};                   // the last pass: also what only stands in for another name is tried
    bool beginsAnew{};                     // what was allowed for in a later round
    double bestError{-1};                  // [%] of the fitted data

    /// What a search that is stopped now reports: named effects that are clear by themselves, or that predict clearly
    /// better; null: the model as given.
    Whole* toTell();
    /// Before `whole` gives way to what explains more, and may be less clear.
    void keepClear();
};

class SearchContext {
public:
    SearchContext(const EstimationTask& task, const DiscoverOptions& options, const Progress& progress);

    const DiscoverOptions options;
    WorkLimit work;
    const Progress progress;  // stops at the limit of the work, too
    FitOptions fit;           // of what is only searched: integrated as exactly as the noise asks for
    std::vector<EffectClass> catalogue;
    std::map<std::string, std::string> laws;  // texts of the classes that were written for this model, by name
    Readings readings;
    Courses courses;
    Frontier frontier;
    Journal journal;

    /// Called outside of parallel passes alone: the same at any number of threads.
    void checkWork() { work.check(); }
    void say(std::string stage, Text detail, double fraction) const {
        progress.report({std::move(stage), std::move(detail), fraction, frontier.bestError});
    }
};

/// The place of a model in the search.
Stay stayAt(const SearchContext& search, const NullModel& null, double misfit);

}  // namespace analogon
