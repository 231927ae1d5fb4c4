#include "tests/search/summary.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/base/fnv.hpp"

namespace analogon::net {
namespace {

using Json = nlohmann::ordered_json;

const std::string tracePrefix = "trace ", candidatesPrefix = "candidates/";
constexpr const char* condensedMark = "condensed";

/// Fowler-Noll-Vo 1a, 64 bits: the same on any machine.
std::string hashOf(const std::string& text) { return fmt::format("{:016x}", fnv1a(text)); }

bool isOfTheRun(const std::string& member) { return member == "seconds" || member == "version"; }

Json withoutTheRun(const Json& json) {
    if (!json.is_structured()) return json;
    Json kept = json.is_array() ? Json::array() : Json::object();
    for (auto item = json.begin(); item != json.end(); ++item)
        if (json.is_array())
            kept.push_back(withoutTheRun(*item));
        else if (!isOfTheRun(item.key()))
            kept[item.key()] = withoutTheRun(*item);
    return kept;
}

std::string valueOf(const Json& json) {
    if (json.is_number_float()) return fmt::format("{:.6g}", json.get<double>());
    return json.is_string() ? json.get<std::string>() : json.dump();
}

std::string text(const Json& object, const char* member) {
    return object.contains(member) && object[member].is_string() ? object[member].get<std::string>() : std::string();
}

/// What an element of a list is told by: what it is and where, its name, or its number.
std::string nameOf(const Json& element, std::size_t number) {
    if (element.is_object() && element.contains("kind") && element.contains("at")) {
        std::string name = text(element, "kind") + " at " + text(element, "at");
        if (const std::string of = text(element, "class"); !of.empty()) name += " (" + of + ")";
        if (element.contains("round")) name += " round " + element["round"].dump();
        return name;
    }
    for (const char* member : {"name", "output", "node", "variable"})
        if (element.is_object() && !text(element, member).empty()) return text(element, member);
    return std::to_string(number);
}

/// A name that no line has yet: the second of two alike is "… #2".
std::string freeName(const std::set<std::string>& taken, const std::string& name) {
    std::string free = name;
    for (int k = 2; taken.contains(free); ++k) free = name + " #" + std::to_string(k);
    return free;
}

void flatten(const Json& json, const std::string& name, Summary& into) {
    if (!json.is_structured() || json.empty()) {
        into[name] = valueOf(json);
        return;
    }
    const std::string before = name.empty() ? "" : name + "/";
    std::set<std::string> taken;
    std::size_t number = 0;
    for (auto item = json.begin(); item != json.end(); ++item, ++number) {
        const std::string own = freeName(taken, json.is_array() ? nameOf(*item, number) : item.key());
        taken.insert(own);
        flatten(*item, before + own, into);
    }
}

/// "trace 1.2 judge: Analogon.Effects…@rotor" -> "weaker; score 12.3; explains less than …"
void addTrace(const std::string& trace, Summary& into) {
    std::istringstream lines(trace);
    std::set<std::string> taken;
    std::string all;
    for (std::string line; std::getline(lines, line);) {
        all += line + '\n';
        const Json decision = Json::parse(line);
        const std::string name =
            freeName(taken, fmt::format("{}{}.{} {}: {}", tracePrefix, decision["path"].dump(),
                                        decision["round"].dump(), text(decision, "step"), text(decision, "key")));
        taken.insert(name);
        std::string value = text(decision, "verdict");
        if (decision.contains("figures"))
            for (const auto& [figure, number] : decision["figures"].items())
                value += "; " + figure + " " + valueOf(number);
        if (const std::string reason = text(decision, "reason"); !reason.empty()) value += "; " + reason;
        into[name] = std::move(value);
    }
    into["decisions"] = hashOf(all);
}

/// To which group of many a line belongs; empty: it stands for itself.
std::string groupOf(const std::string& name) {
    if (name.starts_with(candidatesPrefix)) return "candidates";
    if (!name.starts_with(tracePrefix)) return {};
    const std::string step = name.substr(0, name.find(':'));
    const std::string of = step.substr(step.find(' ', tracePrefix.size()) + 1);
    const bool isOfMany =
        of == "screen" || of == "judge" || of.starts_with("trial") || of == "law" || of.starts_with("rival of");
    return isOfMany ? step : std::string();
}

}  // namespace

Summary summaryOf(const std::string& report, const std::string& trace) {
    const Json kept = withoutTheRun(Json::parse(report));
    Summary summary;
    flatten(kept, "", summary);
    summary["exact"] = hashOf(kept.dump());
    addTrace(trace, summary);
    return summary;
}

Summary condensed(const Summary& summary) {
    if (summary.contains(condensedMark)) return summary;
    Summary kept{{condensedMark, "yes"}};
    std::map<std::string, std::pair<int, std::string>> groups;
    for (const auto& [name, value] : summary) {
        const std::string group = groupOf(name);
        if (group.empty()) {
            kept[name] = value;
            continue;
        }
        auto& [count, lines] = groups[group];
        ++count;
        lines += name + '\t' + value + '\n';
    }
    for (const auto& [group, of] : groups) kept[group] = fmt::format("{} lines, {}", of.first, hashOf(of.second));
    return kept;
}

std::vector<Difference> differences(const Summary& before, const Summary& after) {
    if (before.contains(condensedMark) != after.contains(condensedMark))
        return differences(condensed(before), condensed(after));
    std::vector<Difference> all;
    const auto valueIn = [](const Summary& summary, const std::string& name) {
        const auto line = summary.find(name);
        return line == summary.end() ? std::string("-") : line->second;
    };
    Summary names = before;
    names.insert(after.begin(), after.end());
    for (const auto& [name, value] : names) {
        const std::string was = valueIn(before, name), is = valueIn(after, name);
        if (was != is) all.push_back({name, was, is});
    }
    return all;
}

std::string textOf(const Summary& summary) {
    std::string lines;
    for (const auto& [name, value] : summary) {
        std::string line = name + '\t' + value;
        for (char& c : line)
            if (c == '\n') c = ' ';
        lines += line + '\n';
    }
    return lines;
}

Summary summaryFrom(const std::string& text) {
    Summary summary;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t tab = line.find('\t'); tab != std::string::npos)
            summary[line.substr(0, tab)] = line.substr(tab + 1);
    return summary;
}

}  // namespace analogon::net
