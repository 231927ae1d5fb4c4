#pragma once

#include <fstream>
#include <iostream>
#include <sstream>

#include "calibrate.hpp"

/// Runs a given model with given values, effects and inputs, so that these equations can be compared with recordings
/// that others made. The input is lines of words:
///   model FILE          set INSTANCE.PARAMETER VALUE        start KELVIN
///   effect KIND AT NAME=VALUE ...        (AT: one of its connectors; blanks in it written as '_')
///   series N DT         then N lines: the inputs in the model's order [and the flow]
/// Printed: N lines with the outputs in the model's order.
namespace bench {

inline int replay(const std::string& file) {
    std::ifstream in(file);
    Model model;
    double startT = 293.15;
    struct Wanted {
        std::string kind, at;
        Parameters parameters;
    };
    std::vector<Wanted> wanted;
    Experiment e;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string key, a;
        words >> key;
        if (key == "model") {
            words >> a;
            std::stringstream text;
            text << std::ifstream(a).rdbuf();
            model = readModel(text.str());
        } else if (key == "set") {
            double v{};
            words >> a >> v;
            model.set(a, v);
        } else if (key == "start") {
            words >> startT;
        } else if (key == "effect") {
            Wanted w;
            words >> w.kind >> w.at;
            std::replace(w.at.begin(), w.at.end(), '_', ' ');
            while (words >> a)
                w.parameters.emplace_back(a.substr(0, a.find('=')), std::stod(a.substr(a.find('=') + 1)));
            wanted.push_back(w);
        } else if (key == "series") {
            words >> e.samples >> e.dt;
            e.inputs.resize(model.names(true).size());
            for (int k = 0; k < e.samples && std::getline(in, line); ++k) {
                std::istringstream row(line);
                double v{};
                for (auto& series : e.inputs) row >> v, series.push_back(v);
                if (row >> v) e.flow.push_back(v);
            }
        }
    }
    Plant plant = assemble(model);
    for (auto& n : plant.nodes) n.start = startT;
    const Recording base = simulate(plant, e);
    Random random(1);
    auto places = Catalogue(model, plant, e, base).inside();
    for (auto& p : Catalogue(model, plant, e, base).outside(random)) places.push_back(p);
    for (const auto& w : wanted) {
        bool found = false;
        for (const auto& p : places) {
            std::vector<std::string> at = p.place.at;
            for (auto& x : at) std::replace(x.begin(), x.end(), '_', ' ');
            if (p.place.kind != w.kind || found || (w.at != "-" && std::find(at.begin(), at.end(), w.at) == at.end()))
                continue;
            apply(plant, {p.place, w.parameters});
            found = true;
        }
        if (!found) {
            std::cerr << "no place for " << w.kind << " at " << w.at << '\n';
            return 2;
        }
    }
    const Recording r = simulate(plant, e), fine = simulate(plant, e, 0.25);
    double worst = 0.0;
    for (std::size_t c = 0; c < r.outputs.size(); ++c) {
        const auto [low, high] = std::minmax_element(fine.outputs[c].begin(), fine.outputs[c].end());
        worst = std::max(worst, rms(minus(r.outputs[c], fine.outputs[c])) / (*high - *low));
    }
    std::cerr << "step error, part of the range: " << shortNumber(worst, 3) << '\n';
    for (std::size_t k = 0; k < static_cast<std::size_t>(e.samples); ++k) {
        for (std::size_t c = 0; c < r.outputs.size(); ++c)
            std::cout << (c ? " " : "") << shortNumber(r.outputs[c][k], 10);
        std::cout << '\n';
    }
    return 0;
}

}  // namespace bench
