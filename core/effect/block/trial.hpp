#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/effect/block/screen.hpp"
#include "core/effect/model/evidence.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using threshold::trial::trialIterations;

/// A candidate refitted together with all parameters of the model.
struct Trial {
    Screened screened;
    Variant variant;  // with the effect's parameters freed, at the optimum
    FitResult fit;
    bool ok{};
    bool isLean{};  // the fit has residuals, and neither slopes nor trajectories
    Text failure;
    double evidence{};  // decrease of chi-square over the residual variance, less k ln N_eff (set by `rank`)

    double sumOfSquares() const { return fit.optimum.residuals.squaredNorm(); }
    int freed() const { return static_cast<int>(variant.effects.back().freed.size()); }
};

FitOptions trialOptions(FitOptions options, int iterations);

/// Whether a start is weighed against those of its kind that are ready already: its trace explains so much, that of the
/// best start so much.
bool isWeighed(std::ptrdiff_t ready, double explained, double best);

struct TrialStart;

/// A candidate on the way through its starts (one a distinct shape or secant, at most `starts`, best promise first).
/// What it is made of must outlive it.
class TrialStarts {
public:
    TrialStarts(const NullModel& null, const Screened& screened, const FitOptions& options, int starts,
                const Progress& progress);
    TrialStarts(const TrialStarts&) = delete;
    TrialStarts& operator=(const TrialStarts&) = delete;
    ~TrialStarts();

    bool hasNext() const;
    /// Sum of squares that the linearised problem leaves from the next start.
    double promised() const;
    void takeNext();
    /// What is known of the slopes at the best, and its trajectories, take most of its room.
    void dropSlopes();
    /// The best that was reached so far.
    const Trial& best() const& { return best_; }
    Trial best() && { return std::move(best_); }

private:
    /// Made ready; nothing where it cannot be, with the reason in `best_`.
    std::optional<PreparedTask> prepared(const Variant& variant);
    std::optional<TrialStart> begin(const Variant& wired, const Probe& probe, double strength);
    bool resume(TrialStart& start);
    void holdWholeNumber(TrialStart& start, FitResult& result) const;

    const NullModel& null_;
    const Screened& screened_;
    const FitOptions& options_;
    const Progress& progress_;
    std::vector<TrialStart> ready_;
    std::size_t next_{};
    Trial best_;
};

/// Refits from all of them.
Trial refit(const NullModel& null, const Screened& screened, const FitOptions& options, int starts,
            const Progress& progress);

/// Goes on with the fit of a trial from where it stopped.
void proceed(const NullModel& null, Trial& trial, const FitOptions& options, const Progress& progress);

/// The trial that leaves least; nothing where none could be fitted.
const Trial* leastLeft(const std::vector<Trial>& trials);

/// Sorts by evidence, best first; the noise level and N_eff are those of the residual of the best fit among them.
void rank(const NullModel& null, std::vector<Trial>& trials);

}  // namespace analogon
