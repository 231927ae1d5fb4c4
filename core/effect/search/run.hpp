#pragma once

#include "core/effect/search/context.hpp"
#include "core/effect/search/ending.hpp"

namespace analogon {

/// One search, from the model as given to the model that leaves noise.
class Run {
public:
    /// `progress` must outlive it.
    Run(const EstimationTask& task, const DiscoverOptions& options, const Progress& progress)
        : outside_(progress), search_(task, options, progress) {}

    Outcome<Finding> run();

private:
    // The phases of a search, in their order.
    Outcome<Finding> searched();
    Outcome<Done> chooseCatalogue();
    Outcome<Done> fitAsGiven();
    Outcome<Done> tellAsGiven();
    bool isNotToBeSearched();
    Outcome<Done> seekBestPath();
    void freeChecks();
    void concludeBestPath();
    void weighHeldValues();
    Outcome<Done> fitAtLast();
    Outcome<Done> keepOwnFit(const Text& why);

    void takeBestOnAll();
    Outcome<Done> fitOnAll();
    bool isBlurred(const NullModel& onMeans) const;
    /// What the search works on of long recordings.
    Text shortened() const;
    bool isOfBeginning(const NullModel& read) const;
    bool isOfMistakenUnit();
    bool isOfMistakenWiring();
    void keepAsInterrupted();
    bool isAsGiven() const;
    bool isOpen() const;

    const Progress& outside_;  // which does not stop at the limit of the work
    SearchContext search_;
    NullModel first_;                 // the first fit
    std::optional<NullModel> onAll_;  // of the model as given, on every sample where the search works on means of them
    /// The model as given, on what is reported.
    struct AsGiven {
        Variant variant;
        FitResult fit;  // without its optimum
    };
    AsGiven asGiven_;
    double fitWork_{};  // until the model as given was fitted
    Ending end_;
};

}  // namespace analogon
