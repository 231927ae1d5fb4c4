#include "ui/document/same_study.hpp"

#include <algorithm>

namespace analogon::ui {

namespace {

bool isSame(const StudyParameter& a, const StudyParameter& b) {
    return a.fit == b.fit && a.value == b.value && a.min == b.min && a.max == b.max && a.scale == b.scale &&
           a.prior == b.prior;
}

bool isSame(const std::map<std::string, StudyParameter>& a, const std::map<std::string, StudyParameter>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return x.first == y.first && isSame(x.second, y.second); });
}

bool isSame(const StudyExperiment& a, const StudyExperiment& b) {
    return a.name == b.name && a.role == b.role && a.file == b.file && a.timeColumn == b.timeColumn &&
           a.range == b.range && a.isUsed == b.isUsed && a.inputs == b.inputs && a.outputs == b.outputs &&
           a.initial == b.initial;
}

template <class A, class B>
bool isSameOf(const A& a, const B& b) {
    return a.models == b.models && a.className == b.className && isSame(a.parameters, b.parameters) &&
           std::equal(a.experiments.begin(), a.experiments.end(), b.experiments.begin(), b.experiments.end(),
                      [](const auto& x, const auto& y) { return isSame(x, y); });
}

}  // namespace

bool isSameModel(const Study& a, const Study& b) { return isSameOf(a, b); }

bool isSameModel(const Study& a, const StudySettings& b) { return isSameOf(a, b); }

}  // namespace analogon::ui
