#include "ui/document/mention.hpp"

#include <algorithm>

#include "core/fit/clock.hpp"
#include "ui/document/document.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

constexpr const char* kinds[] = {"experiment", "parameter", "block"};

bool isBlock(const Document& document, const std::string& name) {
    const ModelFacts& facts = document.facts();
    const auto isIt = [&](const SignalFact& s) { return s.name == name; };
    if (std::any_of(facts.inputs.begin(), facts.inputs.end(), isIt) ||
        std::any_of(facts.outputs.begin(), facts.outputs.end(), isIt))
        return true;
    // Of the model as a whole: another diagram may be shown.
    const std::string block = name.substr(0, name.find('.'));
    if (document.levels().empty() && document.diagram().find(block)) return true;
    return !block.empty() && std::any_of(facts.parameters.begin(), facts.parameters.end(),
                                         [&](const ParameterFact& p) { return p.name.starts_with(block + "."); });
}

}  // namespace

std::optional<Mention> mentionOf(const Document& document, const QString& name) {
    if (!document.isOpen() || name.isEmpty()) return std::nullopt;
    const std::string wanted = name.toStdString();
    for (const StudyExperiment& e : document.study().experiments)
        if (e.name == wanted) return Mention{Mention::Kind::Experiment, name};
    const auto& parameters = document.facts().parameters;
    if (isClock(wanted) ||
        std::any_of(parameters.begin(), parameters.end(), [&](const ParameterFact& p) { return p.name == wanted; }))
        return Mention{Mention::Kind::Parameter, name};
    if (isBlock(document, wanted)) return Mention{Mention::Kind::Block, name};
    return std::nullopt;
}

std::optional<Mention> mentionIn(const Document& document, const Text& text) {
    for (const QString& name : namesIn(text))
        if (auto mention = mentionOf(document, name)) return mention;
    return std::nullopt;
}

QString targetOf(const Mention& mention) {
    return QString::fromLatin1(kinds[static_cast<int>(mention.kind)]) + ":" + mention.name;
}

std::optional<Mention> mentionAt(const QString& target) {
    for (int i = 0; i < 3; ++i)
        if (target.section(':', 0, 0) == QLatin1String(kinds[i]))
            return Mention{static_cast<Mention::Kind>(i), target.section(':', 1)};
    return std::nullopt;
}

QString linkedWords(const Document& document, const Text& text) {
    return linkedWords(text, [&](const QString& name) {
        const auto mention = mentionOf(document, name);
        return mention ? targetOf(*mention) : QString();
    });
}

}  // namespace analogon::ui
