#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <stop_token>

#include "core/effect/course/change.hpp"
#include "core/effect/course/dependence.hpp"
#include "core/effect/course/held_parameter.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/reading/faulty_sample.hpp"
#include "core/effect/reading/input_clock.hpp"
#include "core/effect/reading/input_noise.hpp"
#include "core/effect/reading/likeliest_edges.hpp"
#include "core/effect/reading/mistaken_unit.hpp"
#include "core/effect/reading/start_value.hpp"
#include "core/effect/search/discover.hpp"

namespace analogon {

/// One search, from the model as given to the model that leaves noise.
class Search {
public:
    Search(const EstimationTask& task, const DiscoverOptions& options, const Progress& progress);

    Outcome<Finding> run();

private:
    static constexpr double rivalShare = 0.3;  // of the winner's evidence, for a weaker candidate to be tried again
    static constexpr int startsPerTrial = 2;
    static constexpr double mostForPairs =
        10;  // level of what is left: far from an optimum no slopes tell of two effects

    struct Step {
        Trial winner;
        Acceptance acceptance;
        std::size_t tried{1};                   // candidates from which it was chosen
        std::vector<Alternative> alternatives;  // deltaBic: by how much they are worse than the chosen one
        std::vector<Candidate> rivals;          // what else explained a good part of the same
        Text equation;                          // without a name, that explained as much at its place; empty: none did
        int order{};                            // of all choices
        double fall{};                          // in the sum of squares, that it alone is missed for
        double errorWithout{-1};  // [%] of the fitted data when this effect alone is left out; -1: not known
    };

    /// Every effect at every place, of what the options ask for.
    Outcome<std::vector<Candidate>> candidatesIn(const Variant& variant) const;
    std::vector<Screened> screenAll(const NullModel& null);
    std::vector<Trial> tryBest(const NullModel& null, std::vector<Screened>& screened, double leastScore);
    std::vector<Trial> tryThese(const NullModel& null, const std::vector<const Screened*>& chosen, int iterations,
                                int starts);
    void continueBest(const NullModel& null, std::vector<Trial>& trials);
    /// What was tried beside one model, and what was decided.
    struct Round {
        std::vector<Screened> screened;
        std::vector<Trial> trials;  // best first
        double threshold{};
        std::optional<std::size_t> chosen;  // of the trials
        std::vector<std::size_t> members;   // of its class
        std::set<std::size_t> failsHeldOut;
        std::vector<std::size_t> tooFaint;    // that fail no test but by the little evidence
        std::map<std::size_t, Text> refused;  // of the trials, why
        Text behind;                          // what the trials that no test refused came second to
        double leastScore{};                  // for a trial
        Acceptance acceptance;

        const Candidate& candidate(std::size_t trial) const { return trials[trial].screened.candidate; }
        /// Sets the choice aside.
        void passOver(const Text& why);
    };
    /// A named effect that was not needed any more beside a proposed equation.
    struct Displaced {
        PlacedEffect effect;
        Step step;
    };
    /// Effects added one after the other, and the model they lead to.
    struct Path {
        NullModel null;
        std::vector<Step> steps;
        std::vector<Displaced> displaced;
        std::vector<CandidateResult> candidates;
        std::optional<ModelState> state;  // where it is known
        bool meetsAnother{};              // it came to effects from which another has gone on already
    };
    /// Where a path has been.
    struct Stay {
        std::set<std::string> effects;  // by keysOf()
        double misfit{};                // by one measure or another, see the members
        int path{};

        /// The same effects at the same optimum: what follows is known.
        bool isLike(const Stay& other) const;
    };

    /// What the end of a path comes to.
    struct Conclusion {
        std::vector<Remainder> proposed;  // equations without a name
        std::optional<NullModel> with;    // the model with them; empty: there are none
        std::optional<ProposedModel> model;
        std::vector<Text> sameByName;  // effects that explain as much as one of these
        bool leavesMuch{};             // even with them
        double misfit{};               // with them
    };

    Round tryAll(const NullModel& null);
    void decide(const NullModel& null, Round& round) const;
    void preferSimple(const NullModel& null, Round& round) const;
    Step stepOf(const NullModel& null, const Round& round);
    void noteAll(const Round& round);
    void goOn(Path& path, Round first);
    std::vector<std::size_t> otherBeginnings(const NullModel& null, const Round& round) const;
    std::vector<std::size_t> pairBeginnings(const NullModel& null, const Round& round, std::size_t most,
                                            const std::vector<Candidate>& taken) const;
    Round withPairMembers(const NullModel& null, Round round);
    std::optional<Round> chosenTogether(const NullModel& null, Round& round);
    Path pathFrom(const NullModel& base, Round round, std::size_t begin);
    /// What a search has found of the recordings, drawn otherwise than they are given, and beside them.
    struct Drawn {
        NullModel base;
        EstimationTask searched, full;  // of base_ and full_
        std::vector<ToldStart> freedStarts;
        std::vector<NoisyInput> noisyInputs;
        std::vector<InputClock> clocks{};
        std::vector<InputEdge> edges{};
        std::vector<Recording> stamped{}, asRecorded{};
        std::vector<Path> otherEnds{};
        std::optional<Change> change{};
        std::optional<Dependence> dependence{};
    };
    Outcome<Path> bestPath(NullModel& base);
    Outcome<Path> bestPathOfDrawn(NullModel& base);
    Outcome<Path> bestPathBesideRecordings(NullModel& base);
    Outcome<Done> beginAnew(NullModel& base);
    void exchange(Drawn& drawn);
    bool isOddlyDrawn(const Path& path) const;
    bool isSimpler(const Path& plain, const Path& than, std::size_t told) const;
    Outcome<Path> bestPathFrom(NullModel& base);
    Round firstRound(NullModel& base);
    bool isColouredNoise(const NullModel& null) const;
    bool isExplainedBy(const Path& path, std::size_t most) const;
    bool isBetter(const Path& path, const Path& than) const;
    Stay stayAt(const NullModel& null, double misfit) const;
    bool isOnlyOfForm(const NullModel& base, const Path& path, const Path& named) const;
    void keepBetter(Path& best, Path path, const NullModel& base);
    Path bareOf(const NullModel& base, Round first, const Text& why);
    void addPairPaths(Path& best, const NullModel& base, const Round& first, const std::vector<Candidate>& taken);
    bool isWithinForms(double evidence) const;
    void addUnprovenPaths(Path& best, const NullModel& base, const Round& first);
    bool addLawPath(Path& best, const NullModel& base, Path begin);
    std::optional<Path> withLaw(Path begin);
    std::size_t termsIn(const NullModel& null) const;
    void exchange(Path& path);
    std::vector<std::size_t> equalPlaces(const NullModel& null, const std::vector<Trial>& trials,
                                         std::size_t best) const;
    std::vector<std::size_t> equivalents(const NullModel& null, const std::vector<Trial>& trials,
                                         std::size_t best) const;
    std::optional<NullModel> without(const NullModel& null, std::size_t effect) const;
    std::optional<NullModel> withoutOnAll(const NullModel& last, std::size_t effect);
    bool takeOut(NullModel& null, std::size_t effect, const Text& why);
    std::optional<NullModel> refittedWith(const NullModel& null, const std::vector<PlacedEffect>& effects) const;
    static double gainOver(const NullModel& null, double sumOfSquares, int more);
    bool reconsider(NullModel& null);
    void crossOver(NullModel& null);
    std::optional<Trial> trialOf(const NullModel& rest, const std::string& fault, const EffectPlace& place);
    Conclusion takeOutProposals(NullModel& null);
    void tellBesideNames(const NullModel& null, const std::vector<PlacedEffect>& before, Conclusion& conclusion) const;
    void setAsideBehindProposal(NullModel& null);
    bool addLaw(NullModel& null);
    std::vector<Trial> tryLaws(NullModel& null);
    void bringBackDisplaced(NullModel& null, double leftByProposals);
    enum class Rivals { Known, New };  // of its round; what goes to its place or is the same fault of another signal
    /// `elsewhere`: the same at that place instead.
    bool replace(NullModel& null, std::size_t effect, Rivals wanted = Rivals::Known,
                 const EffectPlace* elsewhere = nullptr);
    bool doesForBoth(NullModel& null, std::size_t effect, std::size_t part);
    void unite(NullModel& null);
    static bool isLike(const Trial& trial, double evidence, double weight);
    bool simplerFirst(const NullModel& null, double evidence, int freed, std::vector<Trial>& trials) const;
    void likelierFirst(const NullModel& null, const EffectClass& old, std::vector<Trial>& trials) const;
    void completeClasses(NullModel& null);
    void seekChange(const NullModel& base);
    bool isChangeAll(const NullModel& base, const NullModel& with, double leastGain = equivalenceMargin);
    bool isChangeAlone(const NullModel& base, const Round& first);
    void settleChange(const NullModel& base, const NullModel& with);
    Conclusion conclude(NullModel& null, const NullModel& base, bool mayAddLaw);
    bool leaveOutFaults(const NullModel& fitted);
    bool beginElsewhere(NullModel& null);
    Finding besideMistake(Finding finding, const NullModel& null, const MistakenUnit& mistake) const;
    void takeOutAll(NullModel& null, const NullModel& base, const Text& why);
    Outcome<Finding> searched();
    bool isClear(const Path& path) const;
    Outcome<Finding> foundSoFar();
    Finding tellWhole(const Path& path, const FlatModel* valued) const;
    void keepSoFar() const;
    bool onlyImitate(const NullModel& base, const NullModel& null) const;
    void removeUnneeded(NullModel& null, std::size_t least, bool isLast = false);
    void removeOutweighed(NullModel& null, double share);
    bool allowForRecordings(NullModel& null, const Round& round);
    bool refitQuiet(NullModel& null, Variant quiet, const std::vector<NoisyInput>& noisy);
    struct Allowed {
        FitResult fit;
        Acceptance gain;
    };
    std::optional<Allowed> allowed(const NullModel& null, const Variant& variant, int freed, double threshold) const;
    struct Late {
        std::vector<InputClock> clocks;
        Variant variant;
        Allowed with;
    };
    std::optional<Late> findClocks(const NullModel& null, double threshold, double most) const;
    bool refitLate(NullModel& null, Late late);
    void holdUnneededClocks(NullModel& null);
    const std::vector<Recording>& recordingsAsGiven() const;
    void takeRecordingsAsGiven();
    struct Redrawn {
        std::vector<InputEdge> edges;
        Variant variant;
        Allowed with;
    };
    using Drawings = std::array<std::optional<Redrawn>, 2>;  // by whether all jumps are alike
    std::optional<Redrawn> redrawn(const NullModel& null, const NullModel& there, bool areAlike,
                                   double threshold) const;
    Drawings drawings(const NullModel& null, double threshold) const;
    bool placeEdges(NullModel& null, Drawings first, double threshold, double most);
    bool canPlaceEdges(const NullModel& null) const;
    bool takesEdgesForDelays(const NullModel& null);
    bool refitPlaced(NullModel& null, Variant placed, std::vector<InputEdge> edges);
    Outcome<NullModel> fittedWith(Variant variant, const std::vector<Eigen::VectorXd>& noise,
                                  const std::vector<ToldStart>& starts, bool isFitted) const;
    void freeStarts(const std::vector<ToldStart>& starts);
    bool refitWith(NullModel& null, const std::vector<ToldStart>& starts, std::vector<ParameterValue> values);
    bool isNeeded(const ToldStart& start, const NullModel& null, const NullModel& held) const;
    /// Start values of records that begin elsewhere than the model, and what they explain.
    struct Begun {
        std::vector<ToldStart> starts;
        Acceptance gain;
        std::vector<ParameterValue> values;  // of all that is fitted
        double sumOfSquares{};               // that is left
    };
    std::optional<Begun> findBeginning(const NullModel& null, Against against, double threshold) const;
    void holdUnneededStarts(NullModel& null);
    void freeChecks(const NullModel& null);
    void reportAsRecorded(const NullModel& null, ModelState& state);
    std::vector<Text> recordingRemarks(const NullModel& null) const;
    void tellErrorWithout(Step& step, const NullModel& without) const;
    void treatAlike(NullModel& null);
    void sharpen(NullModel& null);
    Text proposeExperiments(const NullModel& null);
    using HeldValues = std::map<int, std::vector<HeldInstead>>;  // by the choice of the effect they imitate
    HeldValues heldValues(const NullModel& null);
    std::vector<Text> addEffects(Finding& finding, const NullModel& null, const std::vector<Step>& steps,
                                 const HeldValues& held, const FlatModel* valued) const;
    std::vector<HeldInstead> takeOutForHeld(NullModel& null, const HeldValues& held);
    std::vector<HeldInstead> takeOutAllForHeld(NullModel& null, const NullModel& base);
    void setVerdict(const Candidate& candidate, Verdict verdict, const Text& why);
    void setVerdict(const PlacedEffect& placed, Verdict verdict, const Text& why);
    void note(const Screened& s, Verdict verdict, const Text& why, std::optional<double> deltaBic, const Text& failure);
    struct Need {
        Text whyNot;                                // empty: the effect has to stay
        std::optional<double> besideDisturbance{};  // evidence for it beside a disturbance, where that was asked
    };
    Need needOf(const NullModel& null, std::size_t effect, const NullModel& without, const Acceptance& missed,
                bool isLast, const std::function<BesideDisturbance(std::size_t most)>& beside) const;
    void retryNames(const NullModel& null, std::vector<Trial>& trials);
    void drawNamesSharper(const NullModel& null, std::vector<Trial>& trials);
    void retryFrom(const NullModel& null, const std::vector<ParameterValue>& values,
                   const std::vector<std::size_t>& chosen, int iterations, std::vector<Trial>& trials);
    void retryNear(const NullModel& null, const std::vector<ParameterValue>& values, double sumOfSquares,
                   std::vector<Trial>& trials);
    static void settleVerdicts(const Finding& finding, std::vector<CandidateResult>& candidates);
    bool dropIndistinct(const NullModel& last, const ModelState& state, NullModel& null);
    bool dropUnmissed(const NullModel& last, NullModel& null);
    AddedEffect describe(const NullModel& last, const ModelState& state, const PlacedEffect& placed,
                         const Step& step) const;
    void say(std::string stage, Text detail, double fraction) const {
        progress_.report({std::move(stage), std::move(detail), fraction, bestError_});
    }

    // What is decided, for whoever asks (search_trace.cpp). Never from within a parallel pass.
    void trace(const std::string& step, const std::string& key, Decision::Figures figures, const std::string& verdict,
               const Text& reason = {}) const;
    void traceTest(const std::string& step, const std::string& key, const Acceptance& test, const std::string& verdict,
                   const Text& reason = {}) const;
    void traceModel(const std::string& step, const NullModel& model, const std::string& verdict,
                    const Text& reason = {}) const;
    void traceScreening(const std::vector<Screened>& screened) const;
    void traceTrials(const std::string& step, const NullModel& null, const std::vector<Trial>& trials) const;
    void traceRound(const NullModel& null, const Round& round) const;
    void traceHeld(const std::string& key, const std::vector<HeldInstead>& values, const std::string& verdict) const;
    void traceFinding(const Finding& finding) const;

    Variant full_;  // on every sample
    int thinning_;
    Variant base_;  // on what the search works with
    const DiscoverOptions options_;
    DiscoverOptions search_;  // integration as exact as the noise asks for
    std::stop_source end_;    // asked for from outside, or by the limit of the work
    std::stop_callback<std::function<void()>> asked_;
    const Progress progress_;
    std::vector<EffectClass> catalogue_;
    std::vector<CandidateResult> candidates_;
    std::vector<Step> steps_;
    std::vector<Displaced> displaced_;  // not needed any more beside a proposed equation
    std::vector<Path> otherEnds_;       // of paths that explain less
    std::vector<Stay> visited_;         // with the error of the fitted data [%]
    int paths_{};
    std::optional<Path> opening_;              // where the first choice of all led
    std::optional<Path> whole_;                // the best so far, of named effects: what an interrupted search reports
    NullModel first_;                          // the first fit
    std::optional<Finding> begun_;             // the model as given: from there on there is something to report
    std::map<std::string, std::string> laws_;  // texts of the classes that were written for this model, by name
    std::vector<Stay> lawless_;                // where no law passed, with the sum of squares
    std::optional<Change> change_;             // in mid run, that explains better than any effect
    std::optional<Dependence> dependence_;     // on a channel, that does
    bool soughtChange_{};
    std::vector<FaultySamples> faults_;    // of the measurement
    std::vector<ToldStart> freedStarts_;   // that were told wrongly
    std::vector<ToldStart> checkStarts_;   // estimated from recordings that only validate
    std::vector<NoisyInput> noisyInputs_;  // that base_ has without their noise
    std::vector<InputClock> clocks_;       // that base_ and full_ have where they are
    std::vector<Recording> stamped_;       // of base_, without them
    int clockChanges_{};
    std::vector<InputEdge> edges_;                           // that base_ and full_ have where they are
    std::vector<Recording> asRecorded_;                      // of full_, without either
    std::optional<std::pair<double, double>> errorsOnTime_;  // [%] with both: fitted, validated (negative: none)
    bool takesAsGiven_{};                                    // no recording is drawn otherwise
    bool beginsAnew_{};                                      // what was allowed for in a later round
    int round_{}, choices_{};
    double work_{};  // of the trials so far
    double bestError_{-1};
};

}  // namespace analogon
