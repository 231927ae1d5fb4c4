#include "core/study/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/distinct.hpp"
#include "core/base/limits.hpp"
#include "core/base/range.hpp"
#include "core/study/study_places.hpp"

namespace analogon {

namespace {

/// The recordings of a task are those of the experiments that are used, in their order.
std::vector<std::size_t> usedExperiments(const Study& study) {
    std::vector<std::size_t> used;
    for (std::size_t e = 0; e < study.experiments.size(); ++e)
        if (study.experiments[e].isUsed) used.push_back(e);
    return used;
}

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
        : places_(study), used_(usedExperiments(study)), task_(task), purpose_(purpose) {}

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
        for (std::size_t e = 0; e < task_.recordings.size(); ++e) {
            const Recording& recording = task_.recordings[e];
            checkSizes(used_[e], "inputs", recording, recording.inputNames, recording.inputs);
            checkSizes(used_[e], "outputs", recording, recording.outputNames, recording.outputs);
        }
        return std::move(said_);
    }

private:
    /// Values of which the squares, and those of their slopes, are no numbers of a computer. An output that stands
    /// still tells nothing whatever its size, and that is said.
    void checkSizes(std::size_t experiment, const char* kind, const Recording& recording,
                    const std::vector<std::string>& names, const Eigen::MatrixXd& values) {
        for (Eigen::Index i = 0; i < values.rows(); ++i) {
            const Range range = rangeOf(values.row(i));
            const double size = range.isEmpty() ? 0 : std::max(std::fabs(range.low), std::fabs(range.high));
            const bool isTooLarge = size > limits::largestSize;
            if (!isTooLarge && !(size > 0 && size < limits::smallestSize)) continue;
            if (&values == &recording.outputs && !(range.width() > 0)) continue;
            const std::string& name = names[static_cast<std::size_t>(i)];
            say(fmt::format("/experiments/{}/{}/{}", experiment, kind, name),
                isTooLarge ? phrase("experiment '{}': '{}' is up to {:.3g} in size, too large to be fitted with",
                                    recording.name, name, size)
                           : phrase("experiment '{}': '{}' is at most {:.3g} in size, too small to be fitted with",
                                    recording.name, name, size),
                isTooLarge ? phrase("Look whether such values are marks for what was not measured, or in another unit "
                                    "than the study says; correct the column.")
                           : phrase("Look whether the column is in another unit than the study says; where such values "
                                    "stand for nothing, write 0."),
                purpose_ != Purpose::Check);
        }
    }

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
            if (isFitted(task_.recordings[i])) return fmt::format("/experiments/{}/outputs", used_[i]);
        return "/experiments";
    }

    void say(const std::string& pointer, Text message, Text hint, bool isFault) {
        said_.push_back(isFault ? places_.fault(pointer, std::move(message), std::move(hint))
                                : places_.remark(pointer, std::move(message), std::move(hint)));
    }

    StudyPlaces places_;
    std::vector<std::size_t> used_;
    const EstimationTask& task_;
    Purpose purpose_;
    Diagnostics said_;
};

/// Inputs that are held in one recording and joined by straight lines in another that does not ask for lines.
Diagnostics heldInPartAlone(const Study& study, const EstimationTask& task) {
    const std::vector<std::size_t> used = usedExperiments(study);
    if (task.recordings.size() != used.size()) return {};
    const StudyPlaces places(study);
    std::map<std::string, std::string> heldIn;  // the first recording in which each is
    for (const Recording& r : task.recordings)
        for (const std::string& input : r.held) heldIn.emplace(input, r.name);
    Diagnostics said;
    for (const auto& [input, first] : heldIn) {
        std::vector<std::string> others;
        std::string pointer;
        for (std::size_t e = 0; e < task.recordings.size(); ++e) {
            const Recording& r = task.recordings[e];
            const auto mapping = study.experiments[used[e]].inputs.find(input);
            const auto row = std::find(r.inputNames.begin(), r.inputNames.end(), input) - r.inputNames.begin();
            if (mapping == study.experiments[used[e]].inputs.end() || row >= r.inputs.rows() || r.isHeld(input))
                continue;
            const bool isAskedFor = mapping->second.interpolation == Interpolation::Linear;
            if (isAskedFor || !(rangeOf(r.inputs.row(row)).width() > 0)) continue;
            if (others.empty()) pointer = fmt::format("/experiments/{}/inputs/{}", used[e], input);
            others.push_back("'" + r.name + "'");
        }
        if (!others.empty())
            said.push_back(places.remark(
                pointer,
                phrase("the input '{}' is held between its samples in '{}' and joined by straight lines in {}", input,
                       first, listed(others)),
                phrase("Give it \"interpolation\": \"hold\" there, too, or say \"linear\" where it is meant.")));
    }
    return said;
}

}  // namespace

Outcome<ValidStudy> validated(const Study& study, Purpose purpose) {
    const UnusedColumns unused = purpose == Purpose::Discover ? UnusedColumns::Take : UnusedColumns::Leave;
    Outcome<EstimationTask> task = estimationTask(study, unused);
    if (!task) return task.diagnostics();
    Diagnostics said = task.diagnostics();
    const auto add = [&](const Diagnostics& more) { said.insert(said.end(), more.begin(), more.end()); };
    add(FitNeeds(study, *task, purpose).unmet());
    add(heldInPartAlone(study, *task));
    Outcome<CompiledTask> model = compiled(*task);
    add(model.diagnostics());
    if (hasError(said)) return distinct(std::move(said));
    return {ValidStudy{std::move(*task), std::move(*model)}, distinct(std::move(said))};
}

}  // namespace analogon
