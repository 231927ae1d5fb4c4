#include "core/study/left_out.hpp"

#include <algorithm>

namespace analogon {

namespace {

bool isFitted(const StudyExperiment& experiment) { return experiment.isUsed && experiment.role == Role::Fit; }

Diagnostics remarksOn(const std::vector<FaultyRecording>& leftOut) {
    Diagnostics remarks;
    for (const FaultyRecording& recording : leftOut)
        for (Diagnostic said : recording.why) {
            if (said.severity == Severity::Error)
                said.message = phrase("the recording '{}' is left out: {}", recording.name, said.message);
            said.severity = Severity::Warning;
            remarks.push_back(std::move(said));
        }
    return remarks;
}

}  // namespace

SoundPart soundPart(const Study& study) {
    std::vector<FaultyRecording> faulty = faultyRecordings(study);
    Study sound = study;
    for (auto recording = faulty.rbegin(); recording != faulty.rend(); ++recording)
        sound.experiments.erase(sound.experiments.begin() + static_cast<std::ptrdiff_t>(recording->index));
    const auto hasFitted = [](const Study& s) {
        return std::any_of(s.experiments.begin(), s.experiments.end(), isFitted);
    };
    if (faulty.empty() || sound.experiments.empty() || (hasFitted(study) && !hasFitted(sound))) return {study, {}, {}};
    Diagnostics remarks = remarksOn(faulty);
    return {std::move(sound), std::move(faulty), std::move(remarks)};
}

Study withLeftOut(Study completed, const Study& whole, const std::vector<FaultyRecording>& leftOut) {
    for (const FaultyRecording& recording : leftOut)  // in their order: what stands before is there by then
        completed.experiments.insert(completed.experiments.begin() + static_cast<std::ptrdiff_t>(recording.index),
                                     whole.experiments[recording.index]);
    return completed;
}

}  // namespace analogon
