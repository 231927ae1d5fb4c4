#pragma once

#include <cmath>
#include <random>

#include "core/effect/search/context.hpp"
#include "core/effect/search/round.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {

/// A body heated in two steps, read by a sensor that lags by so many seconds and reads so much too high, in white
/// noise.
inline EstimationTask laggingBody(double lag, double offset = 0, double startsAt = 300) {
    constexpr double step = 0.25;
    constexpr int samples = 400;
    EstimationTask task = warmBody({{"joint.G", "W/K", 0.3, 0.01, 10}});
    Recording r = warmBodyRecording("warm-up", samples);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.05);
    double body = startsAt, sensor = startsAt;
    const auto powerAt = [](int k) { return k < samples / 2 ? 8.0 : 2.0; };
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(step * k);
        r.inputs(0, k) = powerAt(k);
        r.outputs(0, k) = (lag > 0 ? sensor : body) + offset + noise(random);
        for (int i = 0; i < 100; ++i) {
            const double part = (i + 0.5) / 100, power = (1 - part) * powerAt(k) + part * powerAt(k + 1);
            if (lag > 0) sensor += step / 100 * (body - sensor) / lag;
            body += step / 100 * (power - 0.2 * (body - 300)) / 4;
        }
    }
    task.recordings = {r};
    return task;
}

/// A search among a few faults of sensors, with the model as given fitted.
class WarmSearch {
public:
    explicit WarmSearch(const EstimationTask& task, DiscoverOptions options = {}) : search(task, options, progress_) {
        Outcome<std::vector<EffectClass>> all = effectCatalogue(task.library);
        EXPECT_TRUE(all) << format(all.diagnostics());
        for (EffectClass& e : *all)
            if (e.kind == "sensor.lag" || e.kind == "sensor.offset" || e.kind == "sensor.delay")
                search.catalogue.push_back(std::move(e));
        Outcome<NullModel> fitted =
            fitNull(search.readings.searched, {}, NoiseLevel::Estimate, search.fit, search.progress);
        EXPECT_TRUE(fitted) << format(fitted.diagnostics());
        if (fitted) base = std::move(*fitted);
    }

    Round decided() {
        Round round = tryAll(search, base);
        decide(search, base, round);
        return round;
    }
    static std::string kindOf(const Round& round) {
        return round.chosen ? round.candidate(*round.chosen).effect.kind : "";
    }

private:
    Progress progress_;

public:
    SearchContext search;
    NullModel base;
};

}  // namespace analogon
