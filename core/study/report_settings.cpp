#include "core/study/report_settings.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/file_fault.hpp"
#include "core/report/logo.hpp"
#include "core/study/study_places.hpp"

namespace analogon {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* reportMember = "report";
constexpr const char* leftOut = "leave_out";

struct TextMember {
    const char* name;
    std::string ReportHead::*text;
};
constexpr TextMember textMembers[] = {{"title", &ReportHead::title},
                                      {"test_object", &ReportHead::testObject},
                                      {"author", &ReportHead::author},
                                      {"date", &ReportHead::date},
                                      {"logo", &ReportHead::logo}};

/// The member "report"; null: there is none.
Json reportOf(const std::string& extraJson) {
    if (extraJson.empty()) return {};
    const Json all = Json::parse(extraJson, nullptr, false);
    const auto found = all.is_object() ? all.find(reportMember) : all.end();
    return !all.is_object() || found == all.end() ? Json() : *found;
}

std::optional<ReportSection> sectionOf(const Json& value) {
    for (const ReportSection section : reportSections)
        if (value.is_string() && value.get_ref<const std::string&>() == name(section)) return section;
    return std::nullopt;
}

std::string sectionNames() {
    std::string names;
    for (const ReportSection section : reportSections)
        names += (names.empty() ? "" : ", ") + std::string(name(section));
    return names;
}

/// Why the parts of a head are not what they should be, each with its pointer within study.json.
std::vector<std::pair<std::string, Text>> wrongParts(const Json& report) {
    const std::string top = fmt::format("/{}", reportMember);
    if (!report.is_object()) return {{top, phrase("the head of the report must be a group of named texts")}};
    std::vector<std::pair<std::string, Text>> wrong;
    for (const TextMember& each : textMembers)
        if (const auto found = report.find(each.name); found != report.end() && !found->is_string())
            wrong.emplace_back(fmt::format("{}/{}", top, each.name),
                               phrase("the head of the report: \"{}\" must be a text", each.name));
    const auto sections = report.find(leftOut);
    if (sections == report.end()) return wrong;
    if (!sections->is_array())
        wrong.emplace_back(fmt::format("{}/{}", top, leftOut),
                           phrase("the head of the report: \"{}\" must be a list of sections", leftOut));
    for (std::size_t i = 0; sections->is_array() && i < sections->size(); ++i)
        if (!sectionOf((*sections)[i]))
            wrong.emplace_back(fmt::format("{}/{}/{}", top, leftOut, i),
                               phrase("the report has no such section; there are {}", sectionNames()));
    return wrong;
}

/// What an effect changed in the shown diagram: the block that was added, or the one it took the place of; of one
/// within a component the component.
std::string blockOf(const AddedEffect& effect, const Diagram& after) {
    for (const std::string& name : {effect.wired.instance, effect.at})
        for (std::string part = name; !part.empty();) {
            if (after.find(part)) return part;
            const std::size_t dot = part.rfind('.');
            part = dot == std::string::npos ? std::string() : part.substr(0, dot);
        }
    return {};
}

}  // namespace

ReportHead reportHeadOf(const std::string& extraJson) {
    ReportHead head;
    const Json report = reportOf(extraJson);
    if (!report.is_object()) return head;
    for (const TextMember& each : textMembers)
        if (const auto found = report.find(each.name); found != report.end() && found->is_string())
            head.*each.text = found->get<std::string>();
    if (const auto sections = report.find(leftOut); sections != report.end() && sections->is_array())
        for (const Json& section : *sections)
            if (const auto known = sectionOf(section)) head.leftOut.insert(*known);
    return head;
}

std::string withReportHead(const std::string& extraJson, const ReportHead& head) {
    Json all = extraJson.empty() ? Json::object() : Json::parse(extraJson, nullptr, false);
    if (!all.is_object()) all = Json::object();
    Json report = reportOf(extraJson);
    if (!report.is_object()) report = Json::object();
    for (const TextMember& each : textMembers) {
        report.erase(each.name);
        if (!(head.*each.text).empty()) report[each.name] = head.*each.text;
    }
    report.erase(leftOut);
    for (const ReportSection section : head.leftOut) report[leftOut].push_back(name(section));
    all.erase(reportMember);
    if (!report.empty()) all[reportMember] = std::move(report);
    return all.empty() ? std::string() : all.dump();
}

Diagnostics reportHeadFaults(const Study& study) {
    const Json report = reportOf(study.extraJson);
    if (report.is_null()) return {};
    const StudyPlaces places(study);
    Diagnostics faults;
    const auto tell = [&](const std::string& pointer, const Text& words, const Text& hint) {
        faults.push_back(asWarning(places.fault(pointer, words, hint)));
    };
    for (const auto& [pointer, words] : wrongParts(report))
        tell(pointer, words, phrase("The report is written without it."));
    if (const std::string logo = reportHeadOf(study.extraJson).logo; !logo.empty())
        if (const Outcome<std::string> uri = logoUri(study.directory / logo, logo); !uri) {
            const Diagnostic& fault = uri.diagnostics().front();
            tell(fmt::format("/{}/logo", reportMember), phrase("the logo '{}': {}", logo, fault.message), fault.hint);
        }
    return faults;
}

std::optional<DiagramPair> diagramsOf(const RunResult& result) {
    const Finding& finding = result.finding;
    if (finding.effects.empty() || finding.baseline.modelText.empty() || finding.final.modelText.empty())
        return std::nullopt;
    const auto read = [&](const std::string& text) -> std::optional<Diagram> {
        Study study = result.completed;
        study.models[study.modelFile] = text;
        const Outcome<Library> library = studyLibrary(study);
        if (!library) return std::nullopt;
        Outcome<Diagram> diagram = readDiagram(*library, study.className);
        return diagram ? std::optional(std::move(*diagram)) : std::nullopt;
    };
    std::optional<Diagram> before = read(finding.baseline.modelText), after = read(finding.final.modelText);
    if (!before || !after) return std::nullopt;
    DiagramPair pair{std::move(*before), std::move(*after), {}};
    for (const AddedEffect& effect : finding.effects)
        if (const std::string block = blockOf(effect, pair.after); !block.empty())
            pair.marks.push_back({block, effect.description.empty() ? effect.kind : effect.description});
    return pair;
}

}  // namespace analogon
