#include "ui/measurement/mapping.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
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

/// What feeds all of a test bench is seldom what drives one part of it.
bool isSupply(const Column& column) {
    static const std::set<std::string> supplies{"bat",    "batt",       "battery", "batterie", "ubat", "vbat",
                                                "supply", "versorgung", "netz",    "mains",    "kl"};
    const auto words = wordsOfName(column.name);
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) { return supplies.contains(word); });
}

/// It hardly changes: a model that is driven by it is not moved.
bool isStill(const Column& column) {
    constexpr double still = 0.05;  // of its largest value
    double low = 0, high = 0, largest = 0;
    bool isFirst = true;
    for (const double value : column.values) {
        if (!std::isfinite(value)) continue;
        low = isFirst ? value : std::min(low, value);
        high = isFirst ? value : std::max(high, value);
        largest = std::max(largest, std::abs(value));
        isFirst = false;
    }
    return !isFirst && high - low <= still * largest;
}

/// How well a column fits a signal; below 0: not at all.
int scoreOf(const SignalFact& signal, bool isInput, const Column& column) {
    const bool knowsUnits = !signal.unit.empty() && !column.unit.empty();
    if (knowsUnits && !areConvertible(column.unit, signal.unit)) return -1;
    int score = knowsUnits ? 10 : 0;
    if (signal.name == column.name) score += 40;
    score += 4 * commonWords(signal.name, column.name) + commonWords(signal.description, column.name);
    if (score <= 0) return -1;
    return 2 * score - (isInput && isSupply(column) ? 1 : 0);  // of two that fit alike, the one that drives
}

std::set<std::string> usedColumns(const StudyExperiment& experiment) {
    std::set<std::string> used{experiment.timeColumn};
    for (const auto* channels : {&experiment.inputs, &experiment.outputs})
        for (const auto& [signal, mapping] : *channels) used.insert(mapping.column);
    return used;
}

/// The columns that fit a signal best, of one name the first; more than one: they fit alike. Of those that would drive,
/// the ones that move.
std::vector<const Column*> bestColumns(const SignalFact& signal, bool isInput, const Table& table,
                                       const std::set<std::string>& used) {
    std::vector<const Column*> best;
    int most = 0;
    for (const Column& column : table.columns) {
        if (used.contains(column.name)) continue;
        const int score = scoreOf(signal, isInput, column);
        if (score <= 0 || score < most) continue;
        if (score > most) best.clear();
        most = score;
        best.push_back(&column);
    }
    if (isInput && best.size() > 1) {
        std::vector<const Column*> moving;
        std::copy_if(best.begin(), best.end(), std::back_inserter(moving),
                     [](const Column* c) { return !isStill(*c); });
        if (!moving.empty()) best = std::move(moving);
    }
    std::set<std::string> names;
    std::erase_if(best, [&](const Column* c) { return !names.insert(c->name).second; });
    return best;
}

}  // namespace

std::vector<std::string> rivalColumns(const StudyExperiment& experiment, const SignalFact& signal, bool isInput,
                                      const Table& table) {
    std::vector<std::string> names;
    for (const Column* c : bestColumns(signal, isInput, table, usedColumns(experiment))) names.push_back(c->name);
    return names.size() > 1 ? names : std::vector<std::string>();
}

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
    std::set<std::string> used = usedColumns(experiment), inDoubt;
    std::vector<Pair> pairs;
    const auto collect = [&](const std::vector<SignalFact>& signals, bool isInput) {
        const auto& mapped = isInput ? experiment.inputs : experiment.outputs;
        for (const SignalFact& signal : signals)
            for (const Column& column : table.columns)
                if (!mapped.contains(signal.name) && !used.contains(column.name))
                    if (const int score = scoreOf(signal, isInput, column); score > 0)
                        pairs.push_back({score, &signal, isInput, &column});
    };
    collect(facts.inputs, true);
    collect(facts.outputs, false);
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.score > b.score; });
    for (const Pair& pair : pairs) {
        auto& mapped = pair.isInput ? experiment.inputs : experiment.outputs;
        const std::string& name = pair.signal->name;
        if (mapped.contains(name) || used.contains(pair.column->name) || inDoubt.contains(name)) continue;
        const std::vector<const Column*> best = bestColumns(*pair.signal, pair.isInput, table, used);
        if (best.size() > 1) {
            inDoubt.insert(name);  // it is asked, not guessed
            continue;
        }
        ChannelMapping& mapping = mapped[name];
        mapping.column = best.front()->name;
        if (best.front()->isOnOtherRaster) mapping.group = best.front()->groupName();
        used.insert(best.front()->name);
    }
}

void dropUnaskedClocks(std::map<std::string, StudyParameter>& parameters,
                       const std::vector<StudyExperiment>& experiments) {
    std::erase_if(parameters, [&](const auto& entry) {
        return isClock(entry.first) && !asksForClock(experiments, signalOfClock(entry.first));
    });
}

}  // namespace analogon::ui
