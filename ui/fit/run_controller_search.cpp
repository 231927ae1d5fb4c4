#include <algorithm>
#include <utility>

#include "core/study/left_out.hpp"
#include "core/study/marked_part.hpp"
#include "ui/fit/run_controller.hpp"

/// Effects that are tried or only looked at, and a search that goes on.
namespace analogon::ui {

namespace {

constexpr int lookPause = 250;  // [ms] that the pointer rests on an effect before work begins
constexpr std::size_t keptLooks = 12;

SimulatedTraces tracesOf(const ModelState& state) {
    SimulatedTraces traces;
    for (const ExperimentState& e : state.experiments) {
        SimulatedExperiment experiment{e.name, {}, e.errorPercent};
        for (const OutputState& o : e.outputs)
            experiment.outputs.push_back(
                {o.name, {o.simulated.data(), o.simulated.data() + o.simulated.size()}, o.figures.errorPercent});
        traces.experiments.push_back(std::move(experiment));
    }
    return traces;
}

}  // namespace

void RunController::tryEffect(const EffectChoice& choice) {
    if (!document_.isOpen()) return;
    RunOptions options = options_;
    options.discover.choices = {choice};
    options.discover.maxRounds = 1;
    start(RunKind::Discover, options, document_.study());
}

bool RunController::canSearchLonger() const {
    const Finding* finding = document_.isOpen() ? document_.finding() : nullptr;
    return finding && finding->end.isAtLimitOfWork && document_.resultKind() == RunKind::Discover &&
           !document_.isResultStale() && document_.canRun();
}

void RunController::searchLonger() {
    if (!canSearchLonger()) return;
    constexpr double timesAsLong = 10;
    const auto known = searches_.find(document_.shownRun());  // none: of an earlier session
    Search search = known == searches_.end() ? Search{options_, {}} : known->second;
    search.options.discover.patience *= timesAsLong;
    const Study& study = document_.study();
    start(RunKind::Discover, search.options, search.recordings.empty() ? study : markedPart(study, search.recordings));
}

void RunController::lookAtEffect(const EffectChoice& choice, const QString& name) {
    if (!document_.canRun() || run_.isBusy()) return;
    if (wanted_ && wanted_->choice == choice && wanted_->revision == document_.revision()) return;
    look_.drop();
    wanted_ = Look{choice, name, document_.revision(), {}};
    std::erase_if(looks_, [this](const Look& l) { return l.revision != document_.revision(); });
    for (const Look& known : looks_)
        if (known.choice == choice) {
            lookDelay_.stop();
            return document_.setPreview(known.traces ? std::optional<Document::Preview>({name, *known.traces})
                                                     : std::nullopt);
        }
    lookDelay_.start(lookPause);
}

void RunController::leaveEffect() {
    lookDelay_.stop();
    look_.drop();
    wanted_.reset();
    document_.setPreview(std::nullopt);
}

void RunController::previewEffect() {
    if (!wanted_ || !document_.canRun() || run_.isBusy()) return;
    look_.start<Look>(
        tr("Simulation"),
        [look = *wanted_, study = document_.study(), options = options_](const Progress& progress) mutable {
            const Outcome<EstimationTask> task = taskOf(soundPart(study).study, options);
            if (!task) return look;
            if (const Outcome<ModelState> state = stateWith(*task, look.choice, options.discover.fit, progress))
                look.traces = tracesOf(*state);
            return look;
        },
        [this](Look look) {
            if (look.revision != document_.revision() || !wanted_ || !(wanted_->choice == look.choice)) return;
            document_.setPreview(look.traces ? std::optional<Document::Preview>({look.name, *look.traces})
                                             : std::nullopt);
            if (!look.traces) Q_EMIT concluded(tr("%1 does nothing there that the data show.").arg(look.name));
            if (looks_.size() >= keptLooks) looks_.erase(looks_.begin());
            looks_.push_back(std::move(look));
        });
}

}  // namespace analogon::ui
