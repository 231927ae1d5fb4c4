#include "ui/document/unfinished.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace analogon::ui {

namespace {

constexpr std::array<std::string_view, 5> sentences{
    "the input '{}' of {} is not connected",
    "The model is singular.",
    "experiment '{}': the input '{}' of the model has no column",
    "experiment '{}' measures no output of the model",
    "the study has no experiment",
};

}  // namespace

bool isUnfinished(const Diagnostic& fault) {
    const Text* first = &fault.message;  // of several sentences one behind the other
    while (first->pattern().empty() && !first->arguments().empty()) first = &first->arguments().front();
    const bool isOpenOutput = fault.hint.pattern() == "no equation holds the output {}";
    return fault.severity == Severity::Error &&
           (isOpenOutput || std::find(sentences.begin(), sentences.end(), first->pattern()) != sentences.end());
}

}  // namespace analogon::ui
