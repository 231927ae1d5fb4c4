#include "ui/plot/run_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/style/number.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

/// An experiment as one run saw it.
struct Seen {
    std::shared_ptr<const ModelState> state;
    const ExperimentState* experiment{};

    const OutputState* output(const std::string& name) const {
        if (!experiment) return nullptr;
        for (const OutputState& o : experiment->outputs)
            if (o.name == name) return &o;
        return nullptr;
    }
};

Seen seenBy(const RunRecord& run, const std::string& name) {
    Seen seen{{run.result, &run.result->finding.final}, nullptr};
    for (const ExperimentState& e : seen.state->experiments)
        if (e.name == name) seen.experiment = &e;
    return seen;
}

using Times = std::shared_ptr<const std::vector<double>>;

Times timesOf(const Seen& seen) {
    return seen.experiment ? Times(seen.state, &seen.experiment->time) : std::make_shared<const std::vector<double>>();
}

/// All samples of both, each once.
Times merged(const Times& a, const Times& b) {
    if (b->empty() || *a == *b) return a;
    if (a->empty()) return b;
    auto all = std::make_shared<std::vector<double>>();
    all->reserve(a->size() + b->size());
    std::set_union(a->begin(), a->end(), b->begin(), b->end(), std::back_inserter(*all));
    return all;
}

/// Values at other times: on the straight line between two samples, as they are drawn; NaN beyond the first and last.
Series onto(const Times& grid, const Times& times, const Series& values) {
    if (values.empty() || grid == times || *grid == *times) return values;
    std::vector<double> moved(grid->size(), std::numeric_limits<double>::quiet_NaN());
    std::size_t next = 0;
    for (std::size_t i = 0; i < grid->size(); ++i) {
        const double t = (*grid)[i];
        while (next < times->size() && (*times)[next] < t) ++next;
        if (next == times->size()) break;
        if ((*times)[next] == t) {
            moved[i] = values[next];
        } else if (next > 0) {
            const double before = (*times)[next - 1], share = (t - before) / ((*times)[next] - before);
            moved[i] = values[next - 1] + share * (values[next] - values[next - 1]);
        }
    }
    return moved;
}

Series seriesOf(const Seen& seen, const Eigen::VectorXd& values) {
    return {seen.state, {values.data(), static_cast<std::size_t>(values.size())}};
}

/// Whether the two name another value at the same time.
bool contradict(const Series& a, const Series& b) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (a[i] != b[i] && std::isfinite(a[i]) && std::isfinite(b[i])) return true;
    return false;
}

/// The first one where it has a value, else the other.
Series joined(const Series& a, const Series& b) {
    if (a.empty()) return b;
    if (b.empty() || std::none_of(a.values().begin(), a.values().end(), [](double v) { return std::isnan(v); }))
        return a;
    std::vector<double> all = a.copy();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (std::isnan(all[i])) all[i] = b[i];
    return all;
}

QString labelOf(const QString& letter, const RunRecord& run, const OutputState& output) {
    return QStringLiteral("%1 %2 %3").arg(letter, run.label(), style::percentText(output.figures.errorPercent));
}

}  // namespace

std::vector<std::pair<std::string, Role>> experimentsOf(const Document::RunPair& runs) {
    std::vector<std::pair<std::string, Role>> all;
    for (const RunRecord* run : {&runs.first, &runs.second})
        for (const ExperimentState& e : run->result->finding.final.experiments)
            if (std::none_of(all.begin(), all.end(), [&](const auto& known) { return known.first == e.name; }))
                all.emplace_back(e.name, e.role);
    return all;
}

std::vector<OutputPlot::Content> contentsOf(const Document::RunPair& runs, const std::string& experiment) {
    const Seen a = seenBy(runs.first, experiment), b = seenBy(runs.second, experiment);
    std::vector<const OutputState*> outputs;
    for (const Seen* seen : {&a, &b})
        for (const OutputState& o : seen->experiment ? seen->experiment->outputs : std::vector<OutputState>())
            if (std::none_of(outputs.begin(), outputs.end(), [&](const auto* known) { return known->name == o.name; }))
                outputs.push_back(seen->output(o.name));
    const Times timesA = timesOf(a), timesB = timesOf(b), grid = merged(timesA, timesB);
    std::vector<OutputPlot::Content> contents;
    for (const OutputState* any : outputs) {
        OutputPlot::Content content;
        content.name = QString::fromStdString(any->name);
        content.unit = QString::fromStdString(any->unit);
        content.time = grid;
        Series measuredA, measuredB;
        if (const OutputState* o = a.output(any->name)) {
            measuredA = onto(grid, timesA, seriesOf(a, o->measured));
            content.before = onto(grid, timesA, seriesOf(a, o->simulated));
            content.beforeLabel = labelOf("A", runs.first, *o);
        }
        if (const OutputState* o = b.output(any->name)) {
            measuredB = onto(grid, timesB, seriesOf(b, o->measured));
            content.after = onto(grid, timesB, seriesOf(b, o->simulated));
            content.afterLabel = labelOf("B", runs.second, *o);
        }
        content.measured = joined(measuredB, measuredA);
        if (timesA->empty() || timesB->empty()) {
            const bool isFirst = timesA->empty();
            if ((isFirst ? a : b).experiment)  // an old run of a long recording
                content.note = OutputPlot::tr("The traces of %1 were not kept").arg(isFirst ? "A" : "B");
        } else if (contradict(measuredA, measuredB)) {
            content.measuredBefore = measuredA;
            content.note = OutputPlot::tr("A and B saw different measurements: that of B is shown");
        } else if (*timesA != *timesB) {
            content.note = OutputPlot::tr("A and B saw different parts of the recording");
        }
        contents.push_back(std::move(content));
    }
    return contents;
}

}  // namespace analogon::ui
