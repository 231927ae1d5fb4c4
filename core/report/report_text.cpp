#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/number_text.hpp"
#include "core/base/stop.hpp"
#include "core/base/unit.hpp"
#include "core/measure/table.hpp"
#include "core/report/report.hpp"
#include "core/report/words.hpp"

namespace analogon {

namespace {

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

/// Lines of cells in columns as wide as their widest cell; the first `left` columns to the left, others right.
std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], displayWidth(row[i]));
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line = " ";
        for (std::size_t i = 0; i < row.size(); ++i)
            line += ' ' + (i < left ? padRight(row[i], widths[i]) : padLeft(row[i], widths[i])) + ' ';
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

std::string errorTable(const Finding& finding) {
    const bool both = hasChanged(finding);
    std::vector<std::vector<std::string>> rows{{"experiment", "role", "output", both ? "error before" : "error"}};
    if (both) rows.front().push_back("after");
    for (const ExperimentState& experiment : finding.baseline.experiments) {
        const ExperimentState* const after = both ? find(finding.final, experiment.name) : nullptr;
        const auto add = [&](const std::string& output, double before, double then) {
            rows.push_back(
                {experiment.name, experiment.role == Role::Fit ? "fit" : "validate", output, percentText(before)});
            if (both) rows.back().push_back(percentText(then));
        };
        for (const OutputState& output : experiment.outputs) {
            const OutputState* const then = find(after, output.name);
            add(output.name, output.figures.errorPercent, then ? then->figures.errorPercent : std::nan(""));
        }
        if (experiment.outputs.size() > 1)
            add("all", experiment.errorPercent, after ? after->errorPercent : std::nan(""));
    }
    return aligned(rows, 3);
}

std::string effectLines(const Finding& finding) {
    std::string text;
    for (const AddedEffect& effect : finding.effects) {
        text += fmt::format("  + {}\n", effectWords(effect));
        for (const EffectValue& value : effect.parameters)
            text += fmt::format("      {} = {}{}\n", value.name, valueText(value.value, value.standardError),
                                behindNumber(value.unit));
        for (const Alternative& other : effect.instead.effects)
            if (other.equivalent)
                text += fmt::format("      this data cannot tell it from {} at {}\n", other.kind, other.at);
    }
    return text;
}

/// A parameter, and the experiment where it is the parameter of one alone.
std::string labelOf(const ReportedEstimate& reported) {
    const std::string& name = reported.estimate->name;
    return reported.experiment.empty() ? name : fmt::format("{} ({})", name, reported.experiment);
}

std::string parameterTable(const ModelState& state) {
    std::vector<std::vector<std::string>> rows{{"parameter", "value", "unit"}};
    const std::vector<ReportedEstimate> estimates = estimatesOf(state);
    for (const ReportedEstimate& reported : estimates) {
        const FitEstimate& estimate = *reported.estimate;
        std::string unit = estimate.unit;
        if (estimate.atBound) unit += unit.empty() ? "at its bound" : "  at its bound";
        if (estimate.prior)
            unit += fmt::format("{}prior {}, {:+.1f} std{}", unit.empty() ? "" : "  ",
                                valueText(estimate.prior->mean, estimate.prior->deviation),
                                estimate.prior->distance(estimate.value),
                                contradictsPrior(estimate) ? ": the data contradict it" : "");
        rows.push_back({labelOf(reported), valueText(estimate.value, estimate.standardError), unit});
    }
    if (estimates.empty()) return {};
    return '\n' + aligned(rows, 3) +
           (hasRobustErrors(state) ? "  What is left is correlated in time; the standard errors reckon with it.\n"
                                   : "");
}

/// Where the data limit each parameter, by its profile.
std::string intervalTable(const ModelState& state) {
    std::vector<std::vector<std::string>> rows{{"95 % interval", "from", "to"}};
    std::string remarks;
    for (const ReportedEstimate& reported : estimatesOf(state)) {
        const FitEstimate& estimate = *reported.estimate;
        if (!estimate.interval) continue;
        const ConfidenceInterval& interval = *estimate.interval;
        rows.push_back({labelOf(reported), interval.isOpenBelow ? "open" : numberText(interval.lower, 5),
                        interval.isOpenAbove ? "open" : numberText(interval.upper, 5)});
        if (!interval.remark.empty()) remarks += "  " + interval.remark + '\n';
    }
    return rows.size() == 1 ? std::string() : '\n' + aligned(rows, 3) + remarks;
}

/// Whether effects were looked for at all.
bool isSearch(const Finding& finding) {
    return finding.kind != FindingKind::Adequate || !finding.candidates.empty() || !finding.effects.empty();
}

}  // namespace

std::string summaryText(const Finding& finding) {
    std::string text;
    if (isSearch(finding))
        text += fmt::format("Finding: {}. {}\n\n", name(finding.kind), summaryWords(finding, "discover"));
    text += errorTable(finding);
    const ModelState& last = finding.final.experiments.empty() ? finding.baseline : finding.final;
    text += parameterTable(last);
    text += intervalTable(last);
    if (!finding.effects.empty()) text += "\nAdded\n" + effectLines(finding);
    for (const Remainder& remainder : finding.unexplained.remainders) text += "\n" + remainderWords(remainder) + "\n";
    if (finding.unexplained.disturbance)
        text += "\n" + disturbanceWords(*finding.unexplained.disturbance).english() + "\n";
    if (const std::string words = proposedStudyWords(finding); !words.empty()) text += "\n" + words + "\n";
    if (!finding.nextExperiment.empty()) text += "\nNext experiment: " + finding.nextExperiment + "\n";
    for (const std::string& warning : finding.warnings) text += "\nNote: " + warning + "\n";
    const auto failures = [&](const ModelState& state) {
        for (const ExperimentState& experiment : state.experiments)
            if (experiment.failure.failed)
                text += fmt::format("\nThe simulation of '{}' stopped at {} s: {}{}{}.\n", experiment.name,
                                    numberText(experiment.failure.time), experiment.failure.reason,
                                    experiment.failure.variable.empty() ? "" : " in ", experiment.failure.variable);
    };
    failures(finding.final.experiments.empty() ? finding.baseline : finding.final);
    return text;
}

std::string tracesCsv(const Finding& finding) {
    const bool both = hasChanged(finding);
    std::vector<std::pair<std::string, std::string>> outputs;  // name, unit: the union over the experiments
    for (const ExperimentState& experiment : finding.baseline.experiments)
        for (const OutputState& output : experiment.outputs) {
            const std::pair<std::string, std::string> entry{output.name, output.unit};
            if (std::find(outputs.begin(), outputs.end(), entry) == outputs.end()) outputs.push_back(entry);
        }
    std::string text = "experiment,time [s]";
    for (const auto& [output, unit] : outputs)
        for (const char* const kind : {"measured", "before", "after"}) {
            if (!both && std::string_view(kind) == "after") continue;
            const std::string label = !both && std::string_view(kind) == "before" ? "simulated" : kind;
            text += ',' + csvCell(fmt::format("{} {}{}", output, label, unit.empty() ? "" : " [" + unit + "]"));
        }
    // Standard deviations of the last model, behind everything else: of its value, and of a measurement of it.
    const ModelState& last = both ? finding.final : finding.baseline;
    const bool bands = hasBands(last);
    for (const auto& [output, unit] : outputs)
        for (const char* const kind : {"std of model", "std of measurement"})
            if (bands)
                text += ',' + csvCell(fmt::format("{} {}{}", output, kind, unit.empty() ? "" : " [" + unit + "]"));
    text += '\n';
    const auto appendNumber = [&](double value) {
        text += ',';
        if (std::isfinite(value)) fmt::format_to(std::back_inserter(text), "{:.9g}", value);
    };
    const auto append = [&](const Eigen::VectorXd* values, std::size_t row) {
        const auto index = static_cast<Eigen::Index>(row);
        appendNumber(values && index < values->size() ? (*values)[index] : std::nan(""));
    };
    for (const ExperimentState& experiment : finding.baseline.experiments) {
        const ExperimentState* const after = both ? find(finding.final, experiment.name) : nullptr;
        const std::string label = csvCell(experiment.name);
        for (std::size_t row = 0; row < experiment.time.size(); ++row) {
            if (row % 4096 == 0) stopPoint();
            fmt::format_to(std::back_inserter(text), "{},{:.9g}", label, experiment.time[row]);
            for (const auto& [name, unit] : outputs) {
                const OutputState* const output = find(&experiment, name);
                const OutputState* const then = find(after, name);
                append(output ? &output->measured : nullptr, row);
                append(output ? &output->simulated : nullptr, row);
                if (both) append(then ? &then->simulated : nullptr, row);
            }
            for (const auto& [name, unit] : outputs) {
                if (!bands) break;
                const OutputState* const output = find(find(last, experiment.name), name);
                const bool isKnown = output && hasBand(*output) && row < experiment.time.size();
                const double own = isKnown ? output->deviation[static_cast<Eigen::Index>(row)] : std::nan("");
                appendNumber(own);
                appendNumber(std::hypot(own, scatterOf(last, name)));
            }
            text += '\n';
        }
    }
    return text;
}

}  // namespace analogon
