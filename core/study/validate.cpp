#include "core/study/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/distinct.hpp"
#include "core/study/study_places.hpp"

namespace analogon {

namespace {

bool isFitted(const Recording& recording) { return recording.role == Role::Fit; }

bool hasFitted(const EstimationTask& task) {
    const auto hasFittedStart = [](const Recording& r) {
        return isFitted(r) && std::any_of(r.starts.begin(), r.starts.end(), [](const auto& s) { return s.isFitted; });
    };
    return !task.parameters.empty() || std::any_of(task.recordings.begin(), task.recordings.end(), hasFittedStart);
}

/// Parameters of a fit, and how many values of it are known beforehand.
std::pair<std::size_t, std::size_t> unknownsOf(const EstimationTask& task) {
    std::size_t count = task.parameters.size();
    for (const Recording& r : task.recordings)
        if (isFitted(r))
            count += static_cast<std::size_t>(
                std::count_if(r.starts.begin(), r.starts.end(), [](const auto& s) { return s.isFitted; }));
    const auto known = std::count_if(task.parameters.begin(), task.parameters.end(),
                                     [](const FitParameter& p) { return p.prior.has_value(); });
    return {count, static_cast<std::size_t>(known)};
}

/// Measured values that weigh something in a fit.
std::size_t measuredValues(const EstimationTask& task) {
    std::size_t count = 0;
    for (const Recording& r : task.recordings)
        for (Eigen::Index o = 0; isFitted(r) && o < r.outputs.rows(); ++o)
            if (r.weights[o] > 0) count += static_cast<std::size_t>(r.outputs.row(o).array().isFinite().count());
    return count;
}

/// What a fit needs beside a study that can be simulated.
class FitNeeds {
public:
    FitNeeds(const Study& study, const EstimationTask& task, Purpose purpose)
        : places_(study), task_(task), purpose_(purpose) {}

    Diagnostics unmet() {
        if (purpose_ == Purpose::Simulate) return {};
        if (std::none_of(task_.recordings.begin(), task_.recordings.end(), isFitted))
            say("/experiments", phrase("the study has no experiment with the role \"fit\""),
                phrase("give at least one experiment that role"), purpose_ != Purpose::Check);
        else if (measuredValues(task_) == 0)
            say(placeOfWeights(),
                phrase("nothing is compared: no output that is fitted has values and a weight above 0"),
                phrase("Give an output of an experiment that is fitted a \"weight\" above 0, or none."),
                purpose_ != Purpose::Check);
        else
            checkParameters();
        return std::move(said_);
    }

private:
    void checkParameters() {
        const auto [unknowns, known] = unknownsOf(task_);
        const std::size_t values = measuredValues(task_);
        if (!hasFitted(task_))
            say("/parameters", phrase("there is nothing to fit: no parameter and no start value is to be found"),
                phrase("List parameters under \"parameters\", as \"NAME\": {{\"fit\": true}}."),
                purpose_ == Purpose::Fit);
        else if (values + known < unknowns)
            say("/parameters", phrase("{} measured values cannot determine {} parameters", values, unknowns),
                phrase("fix some parameters or add measurements"), purpose_ != Purpose::Check);
    }

    std::string placeOfWeights() const {
        for (std::size_t i = 0; i < task_.recordings.size(); ++i)
            if (isFitted(task_.recordings[i])) return fmt::format("/experiments/{}/outputs", i);
        return "/experiments";
    }

    void say(const std::string& pointer, Text message, Text hint, bool isFault) {
        said_.push_back(isFault ? places_.fault(pointer, std::move(message), std::move(hint))
                                : places_.remark(pointer, std::move(message), std::move(hint)));
    }

    StudyPlaces places_;
    const EstimationTask& task_;
    Purpose purpose_;
    Diagnostics said_;
};

}  // namespace

Outcome<ValidStudy> validated(const Study& study, Purpose purpose) {
    Outcome<EstimationTask> task = estimationTask(study);
    if (!task) return task.diagnostics();
    Diagnostics said = task.diagnostics();
    const auto add = [&](const Diagnostics& more) { said.insert(said.end(), more.begin(), more.end()); };
    add(FitNeeds(study, *task, purpose).unmet());
    Outcome<CompiledTask> model = compiled(*task);
    add(model.diagnostics());
    if (hasError(said)) return distinct(std::move(said));
    return {ValidStudy{std::move(*task), std::move(*model)}, distinct(std::move(said))};
}

}  // namespace analogon
