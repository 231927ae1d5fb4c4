#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/number_text.hpp"
#include "core/base/unit.hpp"
#include "core/base/whole_file.hpp"
#include "core/campaign/campaign_summary.hpp"
#include "core/report/style.hpp"
#include "core/report/svg_plot.hpp"

namespace analogon {

namespace {

constexpr std::size_t mostNamed = 200;  // units of one list

/// A path within the directory of the campaign, as a link has it (RFC 3986).
std::string linkTo(const std::string& unit) {
    std::string link = "units/";
    for (const char c : unit) {
        const bool isPlain =
            std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_' || c == '.' || c == '~';
        link += isPlain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return link + "/report.html";
}

std::string anchor(const std::string& unit) {
    return fmt::format("<a href=\"{}\">{}</a>", linkTo(unit), escapeHtml(unit));
}

std::string row(std::initializer_list<std::string> cells) {
    std::string text = "<tr>";
    for (const std::string& cell : cells) text += "<td>" + cell + "</td>";
    return text + "</tr>\n";
}

/// "0.03", "< 1e-15"
std::string pText(double p) { return p < 1e-15 ? "&lt; 1e-15" : numberText(p, 2); }

class CampaignPage {
public:
    CampaignPage(const Campaign& campaign, const CampaignState& state, const CampaignSummary& summary)
        : campaign_(campaign), state_(state), summary_(summary) {}

    std::string write() {
        const std::string title = escapeHtml(campaign_.study.stem().string());
        out_ =
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
            "content=\"width=device-width\"><title>" +
            title + " – campaign</title><style>" + reportStyle() +
            ".plot .bar { fill: var(--after); } .plot .odd { fill: var(--bad); } a { color: var(--note); }\n"
            ".figures { grid-template-columns: repeat(auto-fit, minmax(180px, 1fr)); }\n"
            ".all a { display: inline-block; margin: 2px 10px 2px 0; }</style></head><body><main>\n"
            "<p class=\"kicker\">Campaign · " +
            std::string(name(campaign_.command)) + "</p><h1>" + title + "</h1>\n";
        head();
        effects();
        parameters();
        attributes();
        failures();
        units();
        return out_ + "</main></body></html>\n";
    }

private:
    void figure(const std::string& title, std::size_t value) {
        out_ += fmt::format("<div class=\"figure\"><div class=\"name\">{}</div><div class=\"value\">{}</div></div>\n",
                            title, value);
    }

    void head() {
        std::size_t odd = 0;
        for (const ParameterSummary& p : summary_.parameters) odd += p.odd.size();
        out_ += "<div class=\"figures\" style=\"margin-top:22px\">";
        figure("units done", summary_.counts.done);
        figure("failed", summary_.counts.failed);
        figure("waiting", summary_.counts.waiting + summary_.counts.running);
        figure("odd values", odd);
        out_ += "</div>\n";
    }

    void effects() {
        if (campaign_.command != CampaignCommand::Discover) return;
        out_ +=
            "<h2>Findings and effects</h2>\n<div class=\"card table\"><table><thead><tr><th>what</th><th>units</th>"
            "<th>share</th></tr></thead><tbody>\n";
        const auto rows = [&](const std::map<std::string, std::size_t>& counted, const char* before) {
            std::vector<std::pair<std::string, std::size_t>> ordered(counted.begin(), counted.end());
            std::stable_sort(ordered.begin(), ordered.end(), [](auto& a, auto& b) { return a.second > b.second; });
            for (const auto& [what, count] : ordered)
                out_ += row({before + escapeHtml(what), std::to_string(count),
                             percentText(100.0 * static_cast<double>(count) /
                                         static_cast<double>(std::max<std::size_t>(1, summary_.counts.done)))});
        };
        rows(summary_.findings, "finding: ");
        rows(summary_.effects, "effect: ");
        out_ += "</tbody></table></div>\n";
    }

    void parameters() {
        out_ += "<h2>Parameters</h2>\n";
        for (const ParameterSummary& p : summary_.parameters) {
            const std::string unit = escapeHtml(behindNumber(p.parameter.unit));
            out_ += "<div class=\"card\"><h3><code>" + escapeHtml(p.parameter.name) + "</code></h3>\n" + histogram(p);
            out_ += fmt::format("<dl><dt>units</dt><dd>{}</dd><dt>median</dt><dd>{}{}</dd>", p.population.units,
                                numberText(p.middle), unit);
            if (p.population.units >= 2) population(p, unit);
            out_ += "<dt>odd units</dt><dd>";
            for (std::size_t i = 0; i < std::min(p.odd.size(), mostNamed); ++i)
                out_ += fmt::format("{} {} ({:+.1f} σ){}", i ? "," : "", anchor(campaign_.units[p.odd[i].unit].name),
                                    p.odd[i].deviation, "");
            if (p.odd.size() > mostNamed) out_ += fmt::format(" and {} more", p.odd.size() - mostNamed);
            out_ += std::string(p.odd.empty() ? "none" : "") + "</dd></dl></div>\n";
        }
    }

    void population(const ParameterSummary& p, const std::string& unit) {
        const Population& of = p.population;
        const double deviation = std::sqrt(of.between);
        out_ += fmt::format(
            "<dt>mean of all units</dt><dd>{}{}</dd><dt>between units</dt><dd>{}{} (standard deviation)</dd>"
            "<dt>within a unit</dt><dd>{}{}</dd><dt>common to all</dt><dd>{} (p: {})</dd>",
            valueText(of.mean, of.meanError), unit,
            valueText(deviation, deviation > 0 ? of.betweenError / (2 * deviation) : std::nan("")), unit,
            numberText(std::sqrt(of.within)), unit, p.isCommon() ? "may be" : "no", pText(p.pCommon));
    }

    /// Densities between the outer values that are not odd, or all; odd ones as strokes, at the edge where they lie
    /// beyond.
    std::string histogram(const ParameterSummary& p) const {
        constexpr int bins = 40, width = 640, height = 90;
        std::vector<double> known;
        for (std::size_t i = 0; i < p.values.size(); ++i)
            if (std::isfinite(p.values[i]) &&
                std::none_of(p.odd.begin(), p.odd.end(), [&](const OddUnit& o) { return o.unit == i; }))
                known.push_back(p.values[i]);
        if (known.empty()) return {};
        const auto [least, most] = std::minmax_element(known.begin(), known.end());
        const double low = *least, size = *most > *least ? *most - *least : 1;
        std::array<int, bins> counts{};
        for (const double v : known) ++counts[static_cast<std::size_t>(std::min(bins - 1.0, (v - low) / size * bins))];
        const double highest = *std::max_element(counts.begin(), counts.end());
        std::string svg =
            fmt::format("<svg class=\"plot\" viewBox=\"-20 0 {} {}\" role=\"img\">", width + 40, height + 22);
        for (int i = 0; i < bins; ++i)
            if (const int count = counts[static_cast<std::size_t>(i)])
                svg += fmt::format("<rect class=\"bar\" x=\"{}\" y=\"{:.1f}\" width=\"15\" height=\"{:.1f}\"/>", i * 16,
                                   height - height * count / highest, height * count / highest);
        for (std::size_t i = 0; i < std::min(p.odd.size(), mostNamed); ++i) {
            const double x = std::clamp((p.values[p.odd[i].unit] - low) / size * width, -14.0, width + 14.0);
            svg += fmt::format(
                "<a href=\"{0}\"><circle class=\"odd\" cx=\"{1:.1f}\" cy=\"{2}\" r=\"5\"><title>{3}: {4}"
                "</title></circle></a>",
                linkTo(campaign_.units[p.odd[i].unit].name), x, height - 6,
                escapeHtml(campaign_.units[p.odd[i].unit].name), numberText(p.values[p.odd[i].unit]));
        }
        svg += fmt::format(
            "<text class=\"tick\" x=\"0\" y=\"{0}\">{1}</text><text class=\"tick\" x=\"{2}\" y=\"{0}\" "
            "text-anchor=\"end\">{3}{4}</text></svg>\n",
            height + 16, numberText(low), width, numberText(low + size), escapeHtml(behindNumber(p.parameter.unit)));
        return svg;
    }

    void attributes() {
        if (summary_.attributes.empty()) return;
        out_ +=
            "<h2>Parameters against attributes</h2>\n<div class=\"card table\"><table><thead><tr><th>parameter</th>"
            "<th>attribute</th><th>held against</th><th>units</th><th>p of one</th><th>p over all</th><th></th></tr>"
            "</thead><tbody>\n";
        for (const AttributeSummary& a : summary_.attributes)
            out_ += row({"<code>" + escapeHtml(a.parameter) + "</code>", escapeHtml(a.attribute),
                         a.isNumber ? fmt::format("ranks (ρ = {:+.2f}), slope {}", a.ranks.correlation,
                                                  numberText(a.ranks.slope, 3))
                                    : std::string("groups (Kruskal-Wallis)"),
                         std::to_string(a.units), pText(a.p), pText(a.corrected),
                         a.corrected < summaryLevel ? "<span class=\"chip warn\">significant</span>" : ""});
        out_ += "</tbody></table></div>\n";
    }

    void failures() {
        std::size_t told = 0;
        for (std::size_t i = 0; i < campaign_.units.size(); ++i) {
            if (state_.of(i) != UnitState::Failed || told == mostNamed) continue;
            if (told++ == 0) out_ += "<h2>Failed</h2>\n<div class=\"card table\"><table><tbody>\n";
            out_ += row({escapeHtml(campaign_.units[i].name), escapeHtml(state_.record(i).fault)});
        }
        if (told > 0) out_ += "</tbody></table></div>\n";
    }

    void units() {
        out_ += "<h2>Units</h2>\n<details class=\"card all\"><summary>The report of each unit</summary>\n";
        for (std::size_t i = 0; i < campaign_.units.size(); ++i)
            if (state_.of(i) == UnitState::Done) out_ += anchor(campaign_.units[i].name) + "\n";
        out_ += "</details>\n";
    }

    const Campaign& campaign_;
    const CampaignState& state_;
    const CampaignSummary& summary_;
    std::string out_;
};

}  // namespace

Outcome<Done> writeCampaignPage(const Campaign& campaign, const CampaignState& state, const CampaignSummary& summary) {
    return writeWhole(state.out() / "campaign.html", CampaignPage(campaign, state, summary).write());
}

}  // namespace analogon
