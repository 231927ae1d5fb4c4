#include "core/study/marked_part.hpp"

namespace analogon {

namespace {

std::vector<std::string> usedIn(const Study& study) {
    std::vector<std::string> names;
    for (const StudyExperiment& e : study.experiments)
        if (e.isUsed) names.push_back(e.name);
    return names;
}

void takeUses(Study& study, const Study& whole) {
    for (StudyExperiment& e : study.experiments)
        for (const StudyExperiment& own : whole.experiments)
            if (own.name == e.name) e.isUsed = own.isUsed;
}

}  // namespace

Study markedPart(const Study& study, const std::set<std::string>& recordings) {
    Study part = study;
    for (StudyExperiment& e : part.experiments) e.isUsed = e.isUsed && recordings.contains(e.name);
    return part;
}

RunResult forWhole(RunResult result, const Study& whole, const Study& part) {
    takeUses(result.completed, whole);
    if (result.proposed) takeUses(*result.proposed, whole);
    constexpr std::size_t mostNamed = 5;
    const std::vector<std::string> looked = usedIn(part);
    const std::size_t all = usedIn(whole).size();
    if (looked.size() == all) return result;
    std::vector<Text>& warnings = result.finding.warnings;
    warnings.insert(warnings.begin(),
                    looked.size() <= mostNamed
                        ? phrase("only {} of {} recordings were looked at: {}", looked.size(), all, listed(looked))
                        : phrase("only {} of {} recordings were looked at", looked.size(), all));
    return result;
}

}  // namespace analogon
