#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/number_text.hpp"
#include "core/base/unit.hpp"
#include "core/report/report.hpp"
#include "core/report/style.hpp"
#include "core/report/svg_plot.hpp"
#include "core/report/words.hpp"

namespace analogon {

namespace {

/// A name of the model; a long one may break behind a dot.
std::string code(std::string_view text) {
    std::string out = "<code>";
    for (const char c : escapeHtml(text)) {
        out += c;
        if (c == '.') out += "<wbr>";
    }
    return out + "</code>";
}

/// "2.1e-11" as 2.1·10⁻¹¹, a leading minus as the sign.
std::string html(std::string text) {
    const std::size_t e = text.rfind('e');
    const bool isExponent = e != std::string::npos && e > 0 && e + 1 < text.size() &&
                            text.find_first_not_of("+-0123456789", e + 1) == std::string::npos;
    if (isExponent) {
        std::string exponent = text.substr(e + 1);
        if (exponent.front() == '-') exponent.replace(0, 1, "−");
        text = text.substr(0, e) + "·10<sup>" + exponent + "</sup>";
    }
    if (text.starts_with('-')) text.replace(0, 1, "−");
    return text;
}

std::string unbroken(std::string_view text) { return "<code>" + escapeHtml(text) + "</code>"; }

std::string unitHtml(const std::string& unit) { return escapeHtml(behindNumber(unit)); }

/// Text in which a number stays with its percent sign.
std::string prose(std::string_view text) {
    std::string out = escapeHtml(text);
    for (std::size_t at = out.find(" %"); at != std::string::npos; at = out.find(" %", at))
        out.replace(at, 1, "&nbsp;");
    return out;
}

std::string fitText(double value) { return std::isfinite(value) ? html(fmt::format("{:.1f} %", value)) : "–"; }

std::string chip(std::string_view text, std::string_view tone) {
    return fmt::format("<span class=\"chip {}\">{}</span>", tone, escapeHtml(text));
}

const ExperimentState* find(const ModelState& state, const std::string& experiment) {
    for (const ExperimentState& candidate : state.experiments)
        if (candidate.name == experiment) return &candidate;
    return nullptr;
}

const OutputState* find(const ExperimentState* experiment, const std::string& output) {
    if (!experiment) return nullptr;
    for (const OutputState& candidate : experiment->outputs)
        if (candidate.name == output) return &candidate;
    return nullptr;
}

/// Writes the page section by section, in the order in which it is read.
class Page {
public:
    Page(const Finding& finding, const ReportContext& context)
        : finding_(finding),
          context_(context),
          isChanged_(hasChanged(finding)),
          before_(finding.baseline),
          after_(finding.final.experiments.empty() ? finding.baseline : finding.final) {}

    std::string write() {
        out_ =
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>" +
            escapeHtml(title()) + " – Analogon</title><style>" + reportStyle() + headStyle(context_.head) +
            (hasDiagrams() ? diagramStyle() : "") + "</style></head>\n<body><main>\n";
        out_ += headHtml(context_.head, context_.title, context_.logoUri);
        heading();
        const ReportHead& head = context_.head;
        if (head.shows(ReportSection::Errors)) errors();
        if (head.shows(ReportSection::Effects)) effects();
        if (hasDiagrams()) out_ += "<h2>The model before and after</h2>\n" + diagramsHtml(*context_.diagrams);
        if (head.shows(ReportSection::Unexplained)) remainders();
        if (head.shows(ReportSection::Plots)) plots();
        if (head.shows(ReportSection::Parameters)) parameters();
        if (head.shows(ReportSection::Residuals)) residuals();
        if (head.shows(ReportSection::Tried)) candidates();
        if (head.shows(ReportSection::Remarks)) remarks();
        out_ +=
            fmt::format("<footer>Analogon {} · {}{}</footer>\n</main></body></html>\n", escapeHtml(context_.version),
                        escapeHtml(context_.command),
                        finding_.end.seconds > 0 ? fmt::format(" · {} s", numberText(finding_.end.seconds, 3)) : "");
        return std::move(out_);
    }

private:
    const std::string& title() const { return context_.head.title.empty() ? context_.title : context_.head.title; }
    bool hasDiagrams() const { return context_.diagrams && context_.head.shows(ReportSection::Diagram); }

    void heading() {
        const char* const kind = context_.command == "simulate" ? "Simulation"
                                 : context_.command == "fit"    ? "Fit"
                                                                : "Search for missing effects";
        out_ += fmt::format("<p class=\"kicker\">{}</p><div class=\"heading\"><h1>{}</h1>", kind, escapeHtml(title()));
        if (context_.command != "simulate" && context_.command != "fit") {
            const char* const tone = finding_.kind == FindingKind::Partial || finding_.kind == FindingKind::Interrupted
                                         ? "warn"
                                     : finding_.kind == FindingKind::Unexplained ? "bad"
                                                                                 : "good";
            out_ += chip(name(finding_.kind), tone);
        }
        if (finding_.end.interrupted && finding_.kind != FindingKind::Interrupted) out_ += chip("interrupted", "warn");
        out_ += "</div>\n<p class=\"summary\">" + prose(summaryWords(finding_, context_.command)) + "</p>\n";
        out_ += "<div class=\"figures\">";
        figure("Error on validation data", Role::Validate);
        figure("Error on fitted data", Role::Fit);
        if (context_.command != "simulate" && context_.command != "fit")
            out_ += fmt::format(
                "<div class=\"figure\"><div class=\"name\">Effects added</div><div class=\"value\">{}</div></div>",
                finding_.effects.size());
        out_ += "</div>\n";
    }

    void figure(std::string_view label, Role role) {
        const double before = errorPercent(before_, role), after = errorPercent(after_, role);
        if (!std::isfinite(after) && !std::isfinite(before)) return;
        out_ += fmt::format("<div class=\"figure\"><div class=\"name\">{}</div><div class=\"value\">", label);
        if (isChanged_) out_ += fmt::format("<span class=\"old\">{} →</span> ", percentText(before));
        out_ += percentText(after) + "</div></div>";
    }

    void openTable(const std::vector<std::pair<const char*, bool>>& heads) {
        out_ += "<div class=\"card table\"><table><thead><tr>";
        for (const auto& [head, isNumber] : heads)
            out_ += fmt::format("<th{}>{}</th>", isNumber ? " class=\"n\"" : "", head);
        out_ += "</tr></thead><tbody>\n";
    }
    void closeTable() { out_ += "</tbody></table></div>\n"; }

    static std::string number(const std::string& text, std::string_view tone = {}) {
        return fmt::format("<td class=\"n {}\">{}</td>", tone, text);
    }

    void errors() {
        out_ += "<h2>How well the model follows the measurement</h2>\n";
        if (isChanged_) {
            openTable({{"Experiment", false},
                       {"Role", false},
                       {"Output", false},
                       {"Error before", true},
                       {"after", true},
                       {"RMSE before", true},
                       {"after", true},
                       {"Fit before", true},
                       {"after", true}});
        } else {
            openTable({{"Experiment", false},
                       {"Role", false},
                       {"Output", false},
                       {"Error", true},
                       {"RMSE", true},
                       {"Largest deviation", true},
                       {"Fit", true}});
        }
        for (const ExperimentState& experiment : before_.experiments) experimentRows(experiment);
        closeTable();
        out_ +=
            "<p class=\"soft\"><small>Error: root mean square deviation over the range of the measured channel, of one "
            "that "
            "stands still over its magnitude. "
            "Fit: 100 % is a perfect match, 0 % no better than the mean.</small></p>\n";
    }

    void experimentRows(const ExperimentState& experiment) {
        const ExperimentState* const after = find(after_, experiment.name);
        bool isFirst = true;
        const auto begin = [&](std::string_view output, std::string_view style) {
            out_ += fmt::format(
                "<tr class=\"{}\"><td>{}</td><td>{}</td><td>{}</td>",
                isFirst && &experiment != &before_.experiments.front() ? "group" : style,
                isFirst ? escapeHtml(experiment.name) : "",
                isFirst ? (experiment.role == Role::Fit ? chip("fit", "plain") : chip("validate", "")) : "", output);
            isFirst = false;
        };
        const auto tone = [](double old, double now) {
            return now < 0.995 * old ? "better" : now > 1.005 * old ? "worse" : "";
        };
        for (const OutputState& output : experiment.outputs) {
            begin(code(output.name), "");
            const ErrorFigures& old = output.figures;
            const OutputState* const then = find(after, output.name);
            const ErrorFigures now = then ? then->figures : old;
            const std::string unit = unitHtml(output.unit);
            if (isChanged_) {
                out_ += number(percentText(old.errorPercent)) +
                        number(percentText(now.errorPercent), tone(old.errorPercent, now.errorPercent)) +
                        number(html(numberText(old.rmse, 3)) + unit) + number(html(numberText(now.rmse, 3)) + unit) +
                        number(fitText(old.fitPercent)) + number(fitText(now.fitPercent));
            } else {
                out_ += number(percentText(now.errorPercent)) + number(html(numberText(now.rmse, 3)) + unit) +
                        number(html(numberText(now.maxAbs, 3)) + unit) + number(fitText(now.fitPercent));
            }
            out_ += "</tr>\n";
        }
        if (experiment.outputs.size() > 1) {
            begin("all", "total");
            const double old = experiment.errorPercent, now = after ? after->errorPercent : old;
            if (isChanged_) {
                out_ += number(percentText(old)) + number(percentText(now), tone(old, now)) + "<td colspan=\"4\"></td>";
            } else {
                out_ += number(percentText(now)) + "<td colspan=\"3\"></td>";
            }
            out_ += "</tr>\n";
        }
        const SimulationFailure& failure = after ? after->failure : experiment.failure;
        if (failure.failed)
            out_ += fmt::format(
                "<tr><td></td><td colspan=\"{}\" class=\"worse\">The simulation stopped at {} s: {}{}</td></tr>\n",
                isChanged_ ? 8 : 6, html(numberText(failure.time)), escapeHtml(failure.reason),
                failure.variable.empty() ? "" : " in " + code(failure.variable));
    }

    void effects() {
        if (finding_.effects.empty()) return;
        out_ += finding_.effects.size() == 1 ? "<h2>The effect that was missing</h2>\n"
                                             : "<h2>The effects that were missing</h2>\n";
        for (const AddedEffect& effect : finding_.effects) effectCard(effect);
    }

    void effectCard(const AddedEffect& effect) {
        static constexpr const char* ways[] = {"attached at ", "inserted at ", "replaces the equations of ",
                                               "bridges "};
        out_ += fmt::format("<div class=\"card\"><h3>{} {}</h3>",
                            escapeHtml(effect.description.empty() ? effect.kind : effect.description),
                            chip(effect.kind, ""));
        out_ += fmt::format("<p class=\"soft\">{}{} · {}{}</p>", ways[static_cast<int>(effect.wired.way)],
                            code(effect.at), code(effect.className),
                            effect.wired.instance.empty() ? "" : " as " + code(effect.wired.instance));
        out_ += "<dl>";
        for (const EffectValue& value : effect.parameters)
            out_ += fmt::format("<dt>{}</dt><dd>{}{}</dd>", code(value.name),
                                html(valueText(value.value, value.standardError)), unitHtml(value.unit));
        const Evidence& evidence = effect.evidence;
        out_ += fmt::format("<dt>Confidence</dt><dd>{}</dd>", html(confidenceWords(effect).english()));
        out_ += fmt::format("<dt>Error on fitted data</dt><dd>{} → {}</dd>", percentText(evidence.errorPercentBefore),
                            percentText(evidence.errorPercentAfter));
        out_ += fmt::format(
            "<dt>Evidence</dt><dd>ΔBIC {} <span class=\"soft\">(below −10 is strong)</span>, score {}, "
            "chance {}</dd>",
            html(numberText(evidence.deltaBic)), html(numberText(evidence.score)),
            evidence.pValue < 1e-300 ? "below 10<sup>−300</sup>" : html(numberText(evidence.pValue, 2)));
        out_ += fmt::format(
            "<dt>Left-out blocks</dt><dd>{} <span class=\"soft\">(+1: predicts them fully, −1: false)"
            "</span></dd>",
            html(numberText(evidence.heldOut, 2)));
        out_ += "</dl>";
        alternatives(effect);
        out_ += "</div>\n";
    }

    void alternatives(const AddedEffect& effect) {
        std::string same, weaker;
        for (const Alternative& other : effect.instead.effects) {
            std::string& to = other.equivalent ? same : weaker;
            to += fmt::format("<li>{} at {} <span class=\"soft\">(ΔBIC {})</span></li>", code(other.kind),
                              code(other.at), html(numberText(other.deltaBic)));
        }
        if (!same.empty())
            out_ += "<p style=\"margin-top:14px\">This data cannot tell it from:</p><ul>" + same + "</ul>";
        if (!weaker.empty())
            out_ +=
                "<p style=\"margin-top:14px\" class=\"soft\">Explain less:</p><ul class=\"soft\">" + weaker + "</ul>";
    }

    void remainders() {
        if (!finding_.unexplained.remainders.empty()) {
            out_ += "<h2>What is still unexplained</h2>\n";
            for (const Remainder& remainder : finding_.unexplained.remainders)
                out_ += "<div class=\"card\">" + escapeHtml(remainderWords(remainder)) + "</div>\n";
            if (finding_.unexplained.disturbance)
                out_ += "<p>" + escapeHtml(disturbanceWords(*finding_.unexplained.disturbance).english()) + "</p>\n";
            if (const std::string words = proposedStudyWords(finding_); !words.empty())
                out_ += "<p class=\"soft\">" + escapeHtml(words) + "</p>\n";
        }
        if (!finding_.nextExperiment.empty())
            out_ += "<h2>Next experiment</h2>\n<div class=\"card\">" + escapeHtml(finding_.nextExperiment.english()) +
                    "</div>\n";
    }

    void plots() {
        out_ +=
            "<h2>Measured and simulated</h2>\n<div class=\"legend\"><span><i class=\"i-measured\"></i>measured</span>";
        if (isChanged_) out_ += "<span><i class=\"i-before\"></i>model before</span>";
        out_ += fmt::format("<span><i class=\"i-after\"></i>{}</span>", isChanged_ ? "model after" : "model");
        if (hasBands(after_))
            out_ +=
                "<span><i class=\"i-band\"></i>95 % band: the parameters are uncertain</span>"
                "<span><i class=\"i-band noise\"></i>… and what the model leaves (a measurement)</span>";
        out_ += "</div>\n";
        int count = 0;
        for (const ExperimentState& experiment : before_.experiments)
            count += static_cast<int>(experiment.outputs.size());
        int index = 0;
        for (const ExperimentState& experiment : before_.experiments) {
            const ExperimentState* const after = find(after_, experiment.name);
            for (const OutputState& output : experiment.outputs)
                plot(experiment, output, isChanged_ ? find(after, output.name) : nullptr, ++index, count);
        }
    }

    void plot(const ExperimentState& experiment, const OutputState& output, const OutputState* then, int index,
              int count) {
        SignalPlot plot;
        plot.id = fmt::format("p{}", index);
        plot.title = fmt::format("{} of {}: measured and simulated over time", output.name, experiment.name);
        plot.label = output.unit.empty() ? output.name : fmt::format("{} [{}]", output.name, output.unit);
        plot.time = experiment.time;
        plot.columns = count > 16 ? 320 : 640;  // many plots: keep the page small
        const auto residual = [&](const OutputState& of) {
            return of.measured.size() == of.simulated.size() ? Eigen::VectorXd(of.measured - of.simulated)
                                                             : Eigen::VectorXd();
        };
        plot.signals.push_back({"measured", output.measured});
        plot.signals.push_back({then ? "before" : "after", output.simulated});
        plot.residuals.push_back({then ? "before" : "after", residual(output)});
        if (then) {
            plot.signals.push_back({"after", then->simulated});
            plot.residuals.push_back({"after", residual(*then)});
        }
        addBands(then ? *then : output, plot);
        out_ += fmt::format(
            "<div class=\"card\"><div class=\"plothead\"><h3>{} · {}</h3><span class=\"soft\">{}{}</span></div>",
            escapeHtml(experiment.name), code(output.name),
            then ? percentText(output.figures.errorPercent) + " → " : "",
            percentText((then ? then : &output)->figures.errorPercent));
        out_ += svgPlot(plot) + "</div>\n";
    }

    /// Where 95 % lie: of the model's own value, and of what a logger would measure of it.
    void addBands(const OutputState& output, SignalPlot& plot) const {
        if (!hasBand(output)) return;
        constexpr double quantile = 1.959963984540054;
        for (const double noise : {scatterOf(after_, output.name), 0.0}) {
            if (std::isnan(noise)) continue;
            const Eigen::VectorXd reach =
                quantile * (output.deviation.array().square() + noise * noise).sqrt().matrix();
            plot.bands.push_back(
                {noise > 0.0 ? "noise" : "parameters", output.simulated - reach, output.simulated + reach});
        }
    }

    void parameters() {
        const std::vector<ReportedEstimate> estimates = estimatesOf(after_), earlier = estimatesOf(before_);
        if (estimates.empty()) return;
        out_ += "<h2>Parameters</h2>\n";
        std::vector<std::pair<const char*, bool>> heads{{"Parameter", false}};
        if (isChanged_) heads.emplace_back("Before", true);
        heads.emplace_back(isChanged_ ? "After" : "Value", true);
        heads.emplace_back("Unit", false);
        const bool hasPriors = std::any_of(after_.parameters.begin(), after_.parameters.end(),
                                           [](const FitEstimate& e) { return e.prior.has_value(); });
        if (hasPriors) heads.insert(heads.end(), {{"Prior", true}, {"Distance", true}});
        heads.emplace_back("", false);
        openTable(heads);
        const auto cell = [](const FitEstimate* estimate) {
            return number(estimate ? html(valueText(estimate->value, estimate->standardError)) : "–");
        };
        for (const auto& [each, experiment] : estimates) {
            const FitEstimate& estimate = *each;
            const FitEstimate* old = nullptr;
            for (const ReportedEstimate& candidate : earlier)
                if (candidate.estimate->name == estimate.name && candidate.experiment == experiment)
                    old = candidate.estimate;
            out_ +=
                fmt::format("<tr><td>{}{}</td>", code(estimate.name),
                            experiment.empty() ? "" : " <span class=\"soft\">in " + escapeHtml(experiment) + "</span>");
            if (isChanged_) out_ += cell(old);
            out_ += cell(&estimate) + fmt::format("<td>{}</td>", escapeHtml(estimate.unit));
            if (hasPriors) priorCells(estimate);
            out_ += "<td>";
            if (estimate.atBound) out_ += chip("at its bound", "warn") + ' ';
            if (contradictsPrior(estimate)) out_ += chip("contradicts its prior", "warn") + ' ';
            if (context_.command != "simulate" && !std::isfinite(estimate.standardError))
                out_ += chip("not determined", "warn") + ' ';
            if (isChanged_ && !old) out_ += chip("new", "");
            out_ += "</td></tr>\n";
        }
        closeTable();
        const std::string status = statusWords(after_.status), message = escapeHtml(after_.message.english());
        std::string end = status == "converged" ? status : "stopped: " + status;
        if (message.starts_with(end))
            end = message;  // "converged after 7 iterations"
        else if (!message.empty())
            end += " (" + message + ")";
        const char* const colour =
            hasRobustErrors(after_)
                ? " What is left is correlated in time: neighbouring samples say the same again, and the standard "
                  "errors reckon with it (they would be smaller if it were white noise)."
                : "";
        std::string fit;
        if (context_.command != "simulate")
            fit = fmt::format(" The fit {}; {} simulation{}.", end, after_.simulations,
                              after_.simulations == 1 ? "" : "s");
        out_ += fmt::format("<p class=\"soft\"><small>± one standard error.{}{}</small></p>\n", colour, fit);
        profiles();
    }

    /// What was known of a parameter, and how far from it the fit ended.
    void priorCells(const FitEstimate& estimate) {
        if (!estimate.prior) {
            out_ += "<td></td><td></td>";
            return;
        }
        const NormalPrior& prior = *estimate.prior;
        out_ += number(html(valueText(prior.mean, prior.deviation)));
        const double distance = prior.distance(estimate.value);
        out_ += number(std::isfinite(distance) ? html(fmt::format("{:+.1f} std", distance)) : "–");
    }

    static const char* openWord(const ConfidenceInterval& interval) {
        if (interval.remark.find("flat valley") != std::string::npos) return "flat valley";
        if (interval.isOpenBelow && interval.isOpenAbove) return "no limits";
        return interval.isOpenBelow ? "no lower limit" : "no upper limit";
    }

    /// Where the data limit each parameter, as far as it was asked.
    void profiles() {
        std::string cards;
        for (const FitEstimate& estimate : after_.parameters) {
            if (!estimate.interval) continue;
            const ConfidenceInterval& interval = *estimate.interval;
            const auto end = [](bool isOpen, double value) { return isOpen ? "open" : numberText(value, 5); };
            ProfilePlot plot;
            plot.title = fmt::format("profile of {}: fall of twice the log-likelihood over its value", estimate.name);
            plot.label = estimate.unit.empty() ? estimate.name : fmt::format("{} [{}]", estimate.name, estimate.unit);
            plot.values = interval.values;
            plot.rises = interval.rises;
            plot.estimate = estimate.value;
            plot.lower = interval.lower;
            plot.upper = interval.upper;
            plot.isOpenBelow = interval.isOpenBelow;
            plot.isOpenAbove = interval.isOpenAbove;
            cards += fmt::format("<div>{} <span class=\"soft\">{} … {} {}</span>{}", code(estimate.name),
                                 html(end(interval.isOpenBelow, interval.lower)),
                                 html(end(interval.isOpenAbove, interval.upper)), escapeHtml(estimate.unit),
                                 svgProfile(plot));
            if (interval.isOpenBelow || interval.isOpenAbove) cards += chip(openWord(interval), "warn") + ' ';
            if (!interval.remark.empty()) cards += "<small>" + escapeHtml(interval.remark) + "</small>";
            cards += "</div>";
        }
        if (cards.empty()) return;
        out_ +=
            "<h3>95 % intervals</h3>\n<div class=\"card profiles\">" + cards +
            "</div>\n<p class=\"soft\"><small>How far the likelihood falls when a parameter is held and all others are "
            "fitted anew; the line is the 95 % threshold.</small></p>\n";
    }

    void residuals() {
        if (after_.residual.empty()) return;
        out_ += "<h2>What is left</h2>\n";
        openTable({{"Output", false},
                   {"Noise of the channel", true},
                   {"Residual", true},
                   {"Correlated over", true},
                   {"", false}});
        for (const auto& [output, residual] : after_.residual)
            out_ += "<tr><td>" + code(output) + "</td>" + number(html(numberText(residual.noiseStd, 3))) +
                    number(html(numberText(residual.standardDeviation, 3))) +
                    number(html(numberText(residual.autocorrelationTime, 3)) + " samples") + "<td>" +
                    (residual.white ? chip("noise", "good") : chip("has structure", "warn")) + "</td></tr>\n";
        closeTable();
    }

    void candidates() {
        if (finding_.candidates.empty()) return;
        std::vector<const CandidateResult*> main, rest;
        for (const CandidateResult& candidate : finding_.candidates) {
            const bool isRest = candidate.verdict == Verdict::NotSignificant ||
                                candidate.verdict == Verdict::Absorbed || candidate.verdict == Verdict::WrongSign;
            (isRest ? rest : main).push_back(&candidate);
        }
        const auto better = [](const CandidateResult* a, const CandidateResult* b) {
            if (a->round != b->round) return a->round < b->round;
            if ((a->verdict == Verdict::Chosen) != (b->verdict == Verdict::Chosen))
                return a->verdict == Verdict::Chosen;
            return a->screening.score > b->screening.score;
        };
        std::stable_sort(main.begin(), main.end(), better);
        std::stable_sort(rest.begin(), rest.end(), better);
        out_ += fmt::format(
            "<h2>What was tried, and why it was taken or not</h2>\n<p class=\"soft\">{} candidates: every "
            "effect of the library at every place where it fits.</p>\n",
            finding_.candidates.size());
        if (!main.empty()) candidateTable(main);
        if (rest.empty()) return;
        out_ += fmt::format("<details class=\"card table\"{}><summary>{} candidates without a case</summary>",
                            main.empty() && rest.size() <= 20 ? " open" : "", rest.size());
        candidateRows(rest);
        out_ += "</details>\n";
    }

    void candidateTable(const std::vector<const CandidateResult*>& list) {
        out_ += "<div class=\"card table\">";
        candidateRows(list);
        out_ += "</div>\n";
    }

    void candidateRows(const std::vector<const CandidateResult*>& list) {
        out_ +=
            "<table><thead><tr><th class=\"n\">Round</th><th>Effect</th><th>Place</th><th class=\"n\">Score</th>"
            "<th class=\"n\">Strength</th><th class=\"n\">ΔBIC</th><th>Verdict</th></tr></thead><tbody>\n";
        for (const CandidateResult* candidate : list) {
            const char* const tone = candidate->verdict == Verdict::Chosen       ? "good"
                                     : candidate->verdict == Verdict::Equivalent ? ""
                                                                                 : "plain";
            out_ += fmt::format(
                "<tr>{}<td class=\"name\">{}</td><td class=\"name\">{}</td>{}{}{}<td>{} <span "
                "class=\"soft\">{}</span></td></tr>\n",
                number(fmt::format("{}", candidate->round)), unbroken(candidate->kind),
                unbroken(placeWords(candidate->at, candidate->channel)),
                number(html(numberText(candidate->screening.score, 3))),
                number(html(numberText(candidate->screening.strength, 3))),
                number(candidate->deltaBic ? html(numberText(*candidate->deltaBic, 4)) : ""),
                chip(name(candidate->verdict), tone), escapeHtml(verdictWords(*candidate).english()));
        }
        out_ += "</tbody></table>";
    }

    void remarks() {
        std::vector<Text> lines = finding_.warnings;
        for (const Text& remark : after_.remarks)
            if (std::find(lines.begin(), lines.end(), remark) == lines.end()) lines.push_back(remark);
        if (lines.empty()) return;
        out_ += "<h2>Warnings and remarks</h2>\n<div class=\"card\"><ul>";
        for (const Text& text : lines) out_ += "<li>" + escapeHtml(text.english()) + "</li>";
        out_ += "</ul></div>\n";
    }

    const Finding& finding_;
    const ReportContext& context_;
    bool isChanged_;
    const ModelState& before_;
    const ModelState& after_;
    std::string out_;
};

}  // namespace

std::string reportHtml(const Finding& finding, const ReportContext& context) { return Page(finding, context).write(); }

}  // namespace analogon
