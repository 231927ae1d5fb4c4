#include "ui/measurement/mapping.hpp"

#include <algorithm>
#include <cctype>
#include <set>

#include "core/base/unit.hpp"
#include "core/fit/clock.hpp"
#include "core/study/column_guess.hpp"

namespace analogon::ui {

namespace {

/// "u_heater", "uHeater1" as {u, heater}.
std::set<std::string> wordsOfName(const std::string& name) {
    std::set<std::string> words;
    std::string word;
    const auto close = [&] {
        if (!word.empty()) words.insert(std::exchange(word, {}));
    };
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        if (!std::isalpha(c)) {
            close();
            continue;
        }
        if (std::isupper(c) && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1]))) close();
        word += static_cast<char>(std::tolower(c));
    }
    close();
    return words;
}

int commonWords(const std::string& a, const std::string& b) {
    const auto first = wordsOfName(a), second = wordsOfName(b);
    return static_cast<int>(
        std::count_if(first.begin(), first.end(), [&](const auto& w) { return second.contains(w); }));
}

struct Pair {
    int score{};
    const SignalFact* signal{};
    bool isInput{};
    const Column* column{};
};

/// How well a column fits a signal; below 0: not at all.
int scoreOf(const SignalFact& signal, const Column& column) {
    const bool knowsUnits = !signal.unit.empty() && !column.unit.empty();
    if (knowsUnits && !areConvertible(column.unit, signal.unit)) return -1;
    int score = knowsUnits ? 10 : 0;
    if (signal.name == column.name) score += 40;
    score += 4 * commonWords(signal.name, column.name) + commonWords(signal.description, column.name);
    return score > 0 ? score : -1;
}

}  // namespace

std::string proposeTime(const Table& table) {
    for (const GuessedColumn& c : guessColumns(table))
        if (c.quantity == Quantity::Time) return c.name;
    return {};
}

void proposeMapping(StudyExperiment& experiment, const Table& table, const ModelFacts& facts,
                    const std::vector<StudyExperiment>& like) {
    for (const StudyExperiment& other : like) {
        for (const auto& [signal, mapping] : other.inputs)
            if (table.find(mapping.column, mapping.group)) experiment.inputs.try_emplace(signal, mapping);
        for (const auto& [signal, mapping] : other.outputs)
            if (table.find(mapping.column, mapping.group)) experiment.outputs.try_emplace(signal, mapping);
    }
    std::set<std::string> used{experiment.timeColumn};
    for (const auto* channels : {&experiment.inputs, &experiment.outputs})
        for (const auto& [signal, mapping] : *channels) used.insert(mapping.column);
    std::vector<Pair> pairs;
    const auto collect = [&](const std::vector<SignalFact>& signals, bool isInput) {
        const auto& mapped = isInput ? experiment.inputs : experiment.outputs;
        for (const SignalFact& signal : signals)
            for (const Column& column : table.columns)
                if (!mapped.contains(signal.name) && !used.contains(column.name))
                    if (const int score = scoreOf(signal, column); score > 0)
                        pairs.push_back({score, &signal, isInput, &column});
    };
    collect(facts.inputs, true);
    collect(facts.outputs, false);
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.score > b.score; });
    for (const Pair& pair : pairs) {
        auto& mapped = pair.isInput ? experiment.inputs : experiment.outputs;
        if (mapped.contains(pair.signal->name) || used.contains(pair.column->name)) continue;
        ChannelMapping& mapping = mapped[pair.signal->name];
        mapping.column = pair.column->name;
        if (pair.column->isOnOtherRaster) mapping.group = pair.column->groupName();
        used.insert(pair.column->name);
    }
}

void dropUnaskedClocks(std::map<std::string, StudyParameter>& parameters,
                       const std::vector<StudyExperiment>& experiments) {
    std::erase_if(parameters, [&](const auto& entry) {
        return isClock(entry.first) && !asksForClock(experiments, signalOfClock(entry.first));
    });
}

}  // namespace analogon::ui
