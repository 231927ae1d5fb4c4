#include "core/report/report_head.hpp"

#include <fmt/format.h>

#include "core/report/svg_plot.hpp"

namespace analogon {

namespace {

bool isTold(const ReportHead& head) {
    return !(head.title.empty() && head.testObject.empty() && head.author.empty() && head.date.empty() &&
             head.logo.empty());
}

}  // namespace

const char* name(ReportSection section) {
    static constexpr const char* names[] = {"errors",     "effects",   "diagram", "unexplained", "plots",
                                            "parameters", "residuals", "tried",   "remarks"};
    return names[static_cast<int>(section)];
}

std::string headHtml(const ReportHead& head, const std::string& study, const std::string& logoUri) {
    if (!isTold(head)) return {};
    std::string facts;
    const auto add = [&](const char* label, const std::string& text) {
        if (!text.empty()) facts += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", label, escapeHtml(text));
    };
    add("Test object", head.testObject);
    if (!head.title.empty()) add("Study", study);
    add("Author", head.author);
    add("Date", head.date);
    std::string out = "<header class=\"head\">";
    if (!facts.empty()) out += "<dl>" + facts + "</dl>";
    if (!logoUri.empty()) out += fmt::format("<img class=\"logo\" alt=\"Logo\" src=\"{}\">", escapeHtml(logoUri));
    return out + "</header>\n";
}

std::string headStyle(const ReportHead& head) {
    if (!isTold(head)) return {};
    return R"css(
.head { display: flex; justify-content: space-between; align-items: flex-start; gap: 14px 32px; margin: 0 0 30px;
  padding: 0 0 18px; border-bottom: 1px solid var(--edge); }
.head dl { display: flex; flex-wrap: wrap; gap: 10px 36px; margin: 0; }
.head dt { font-size: 12.5px; }
.head dd { font-weight: 600; overflow-wrap: anywhere; }
.head .logo { flex: none; max-width: 220px; max-height: 64px; margin-left: auto; background: #fff; padding: 4px;
  border-radius: 6px; }
)css";
}

}  // namespace analogon
