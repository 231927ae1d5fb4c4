#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "calibrate.hpp"

/// A finished case as files: study.json, model.mo, train.csv, validation.csv, truth.json.
namespace bench {

// ---------------------------------------------------------------- a little JSON

inline std::string quote(const std::string& s) { return "\"" + s + "\""; }
inline std::string number(double v) { return std::isfinite(v) ? shortNumber(v, 6) : "null"; }

inline std::string list(const std::vector<std::string>& items) {
    std::string out = "[";
    for (std::size_t k = 0; k < items.size(); ++k) out += (k ? ", " : "") + items[k];
    return out + "]";
}
inline std::string listOfNames(const std::vector<std::string>& names) {
    std::vector<std::string> items;
    for (const auto& n : names) items.push_back(quote(n));
    return list(items);
}
inline std::string object(const std::vector<std::pair<std::string, std::string>>& members) {
    std::string out = "{";
    for (std::size_t k = 0; k < members.size(); ++k)
        out += (k ? ", " : "") + quote(members[k].first) + ": " + members[k].second;
    return out + "}";
}
inline std::string numbers(const Parameters& p) {
    std::vector<std::pair<std::string, std::string>> members;
    for (const auto& [key, value] : p) members.emplace_back(key, number(value));
    return object(members);
}

// ---------------------------------------------------------------- the case

struct Run {
    Experiment experiment;
    double startT{293.15};
    std::vector<Series> clean, measured;  // outputs, in the model's units
    Recording recording;
    std::vector<double> floor, baseline;  // error_percent of each output
};

struct Hidden {
    Effect effect;
    double rho{};
    std::vector<Twin> twins;
};

struct Case {
    std::string name, cls, variant;  // variant: how the class is made hard
    Design design;
    Run train, validation;
    std::vector<double> sigma;
    std::vector<Hidden> hidden;
    std::optional<Hidden> disturbance;  // an unmeasured flow beside what is hidden
    double rho{}, target{};
};

/// 100*RMSE/(max - min of the measured channel).
inline double errorPercent(const Series& model, const Series& measured) {
    const auto [low, high] = std::minmax_element(measured.begin(), measured.end());
    return 100.0 * rms(minus(model, measured)) / (*high - *low);
}

inline double inUnit(double v, const std::string& unit) {
    if (unit == "mA" || unit == "mV") return 1e3 * v;
    if (unit == "degC") return v - 273.15;
    if (unit == "rpm") return v * 30.0 / std::numbers::pi;
    if (unit == "deg") return v * 180.0 / std::numbers::pi;
    if (unit == "%") return 100.0 * v;
    return v;
}

class CaseWriter {
public:
    CaseWriter(const Case& c, Random& random) : case_(c), random_(random) {}

    void write(const std::filesystem::path& folder) {
        std::filesystem::create_directories(folder);
        decimalComma_ = random_.chance(0.15);
        takeColumn_ = random_.chance(0.4);
        std::ofstream(folder / "study.json") << study();
        Model start = case_.design.model;
        for (const auto& f : case_.design.fitted) start.set(f.path, f.start);
        std::ofstream(folder / "model.mo") << writeModel(start);
        table(folder / "train.csv", case_.train);
        table(folder / "validation.csv", case_.validation);
        std::ofstream(folder / "truth.json") << truth();
    }

private:
    using Members = std::vector<std::pair<std::string, std::string>>;

    std::string study() const {
        const Design& d = case_.design;
        const auto experiment = [&](const char* name, const char* role, const char* file, const Run& run) {
            Members in, out, initial;
            std::string temperature;
            for (const auto& s : d.model.signals) {
                (s.input ? in : out).emplace_back(s.name, quote(d.columns.at(s.name).name));
                if (s.input && s.unit == "K") temperature = d.columns.at(s.name).name;
            }
            for (const auto& t : d.temperatures)
                initial.emplace_back(t, takeColumn_ ? quote(temperature) : number(run.startT));
            Members m{{"name", quote(name)}, {"role", quote(role)},  {"file", quote(file)},
                      {"time", quote("t")},  {"inputs", object(in)}, {"outputs", object(out)}};
            if (!initial.empty()) m.emplace_back("initial", object(initial));
            return "\n    " + object(m);
        };
        Members fitted;
        for (const auto& f : d.fitted) {
            Members m{{"fit", "true"}, {"min", number(f.low)}, {"max", number(f.high)}};
            if (f.logarithmic) m.emplace_back("scale", quote("log"));
            fitted.emplace_back(f.path, object(m));
        }
        std::ostringstream out;
        out << "{\n  \"format\": \"analogon-study-1\",\n  \"class\": " << quote(d.model.name)
            << ",\n  \"experiments\": [" << experiment("run 1", "fit", "train.csv", case_.train) << ","
            << experiment("run 2", "validate", "validation.csv", case_.validation) << "\n  ],\n  \"parameters\": {";
        for (std::size_t k = 0; k < fitted.size(); ++k)
            out << (k ? "," : "") << "\n    " << quote(fitted[k].first) << ": " << fitted[k].second;
        out << "\n  }\n}\n";
        return out.str();
    }

    void table(const std::filesystem::path& file, const Run& run) {
        struct Track {
            Column column;
            Series values;
        };
        const Design& d = case_.design;
        const Experiment& e = run.experiment;
        std::vector<Track> tracks;
        std::size_t in = 0, out = 0;
        for (const auto& s : d.model.signals) {
            const Column& c = d.columns.at(s.name);
            Series v = s.input ? e.inputs[in++] : run.measured[out++];
            for (double& x : v) x = inUnit(x, c.unit);
            tracks.push_back({c, std::move(v)});
        }
        const auto noisy = [&](double level, auto&& course) {
            Series v(static_cast<std::size_t>(e.samples));
            for (std::size_t k = 0; k < v.size(); ++k) v[k] = course(k) + level * random_.normal();
            return v;
        };
        const std::size_t last = static_cast<std::size_t>(e.samples - 1);
        if (!d.flow.name.empty())
            tracks.push_back({d.flow, noisy(0.005 * *std::max_element(e.flow.begin(), e.flow.end()),
                                            [&](std::size_t k) { return e.flow[k]; })});
        if (d.battery) {
            const std::size_t i = static_cast<std::size_t>(currentChannel());
            const double sag = 0.3 / std::max(1e-9, run.recording.maxCurrent);
            tracks.push_back(
                {{"U_bat", "V"}, noisy(0.02, [&](std::size_t k) { return 13.6 - sag * std::abs(run.clean[i][k]); })});
        }
        if (d.oil) {
            const double rise = random_.uniform(3.0, 6.0);
            tracks.push_back({{"T_oil", "degC"}, noisy(0.03, [&](std::size_t k) {
                                  return 27.1 + rise * (1.0 - std::exp(-2.0 * double(k) / double(last)));
                              })});
        }
        if (d.pressure) {
            const double level = random_.uniform(995.0, 1030.0);
            const Series drift = coloured(random_, e.samples, 0.3 * e.samples);
            tracks.push_back(
                {{"p_ambient", "hPa"}, noisy(0.03, [&](std::size_t k) { return level + 1.2 * drift[k]; })});
        }
        random_.shuffle(tracks);
        std::ostringstream text;
        const char separator = decimalComma_ ? ';' : ',';
        text << (decimalComma_ ? "t" : "t [s]");
        for (const auto& t : tracks)
            text << separator << t.column.name << (decimalComma_ ? "" : " [" + t.column.unit + "]");
        if (decimalComma_) {
            text << "\ns";
            for (const auto& t : tracks) text << separator << t.column.unit;
        }
        text << '\n';
        for (std::size_t k = 0; k <= last; ++k) {
            std::string row = shortNumber(static_cast<double>(k) * e.dt, 8);
            for (const auto& t : tracks) row += separator + shortNumber(t.values[k], 6);
            if (decimalComma_) std::replace(row.begin(), row.end(), '.', ',');
            text << row << '\n';
        }
        std::ofstream(file) << text.str();
    }
    int currentChannel() const {
        const auto plant = assemble(case_.design.model);
        for (std::size_t k = 0; k < plant.sensors.size(); ++k)
            if (plant.sensors[k].quantity == Quantity::Current) return static_cast<int>(k);
        return 0;
    }

    std::string truth() const;
    std::string hiddenText(const Hidden& h) const {
        Members m{{"kind", quote(h.effect.place.kind)}};
        if (!h.effect.place.at.empty()) m.emplace_back("at", listOfNames(h.effect.place.at));
        std::string parameters = numbers(h.effect.parameters);
        if (h.effect.place.kind == "convection.flow")
            parameters.insert(parameters.size() - 1,
                              ", \"channel\": " + quote(case_.design.flow.name) + ", \"form\": \"mult\"");
        if (h.effect.place.kind == "x.jump") {
            const std::vector<std::string> whats{"R", "k", "load", "G"};
            parameters.insert(parameters.size() - 1,
                              ", \"what\": " + quote(whats.at(static_cast<std::size_t>(h.effect.place.what))));
        }
        m.emplace_back("parameters", parameters);
        m.emplace_back("rho", number(h.rho));
        return object(m);
    }

    const Case& case_;
    Random& random_;
    bool decimalComma_{}, takeColumn_{};
};

inline std::string CaseWriter::truth() const {
    const auto pair = [](const Place& p) { return object({{"kind", quote(p.kind)}, {"at", listOfNames(p.at)}}); };
    const bool inLibrary = case_.cls == "single" || case_.cls == "double";
    std::vector<std::string> hidden, kinds, places, pairs, tolerated, twinTexts;
    for (const auto& h : case_.hidden) {
        hidden.push_back("\n  " + hiddenText(h));
        if (!inLibrary) continue;
        std::vector<std::string> ways{pair(h.effect.place)};
        for (const auto& t : h.twins) {
            ways.push_back(pair(t.place));
            twinTexts.push_back(object(
                {{"kind", quote(t.place.kind)}, {"at", listOfNames(t.place.at)}, {"delta_chi2", number(t.remaining)}}));
        }
        kinds.push_back(list({quote(h.effect.place.kind)}));
        places.push_back(listOfNames(h.effect.place.at));
        pairs.push_back("\n  " + list(ways));
        if (h.effect.place.kind == "friction.stribeck")
            tolerated.push_back(pair({"friction.coulomb", h.effect.place.at, 0}));
    }
    Members parameters, sigma;
    for (const auto& f : case_.design.fitted) parameters.emplace_back(f.path, number(f.truth));
    const auto outputs = case_.design.model.names(false);
    for (std::size_t k = 0; k < outputs.size(); ++k) sigma.emplace_back(outputs[k], number(case_.sigma[k]));
    const auto both = [&](auto&& of) {
        return object({{"train", number(of(case_.train))}, {"validation", number(of(case_.validation))}});
    };
    const auto channels = [&](auto&& of) {
        const auto one = [&](const Run& r) {
            Members m;
            for (std::size_t k = 0; k < outputs.size(); ++k) m.emplace_back(outputs[k], number(of(r)[k]));
            return object(m);
        };
        return object({{"train", one(case_.train)}, {"validation", one(case_.validation)}});
    };
    const std::string floor = both([](const Run& r) { return rms(r.floor); });
    const double samples = double(case_.train.experiment.samples) * double(outputs.size());
    std::vector<std::string> findings;
    if (case_.cls == "none")
        findings = case_.variant.empty() ? std::vector<std::string>{"adequate"}
                                         : std::vector<std::string>{"adequate", "unexplained"};

    Members m{{"format", quote("blind-truth-1")},
              {"case", quote(case_.name)},
              {"set", quote("bench")},
              {"class", quote(case_.cls)},
              {"variant", quote(case_.variant)},
              {"system", quote(case_.design.systemName)},
              {"hidden", list(hidden)},
              {"kinds_accepted", list(kinds)},
              {"at_accepted", list(places)},
              {"pairs_accepted", list(pairs)},
              {"tolerated", list(tolerated)},
              {"twins", list(twinTexts)}};
    if (!findings.empty()) m.emplace_back("findings_accepted", listOfNames(findings));
    if (case_.disturbance) m.emplace_back("disturbance", hiddenText(*case_.disturbance));
    const Members rest{{"parameters", object(parameters)},
                       {"noise_std", object(sigma)},
                       {"baseline", both([](const Run& r) { return rms(r.baseline); })},
                       {"baseline_outputs", channels([](const Run& r) { return r.baseline; })},
                       {"floor", floor},
                       {"floor_outputs", channels([](const Run& r) { return r.floor; })},
                       {"noise_floor", floor},
                       {"rho", number(case_.rho)},
                       {"rho_target", number(case_.target)},
                       {"detectable", object({{"delta_chi2_train", number(case_.rho * case_.rho * samples)},
                                              {"samples", number(samples)}})}};
    m.insert(m.end(), rest.begin(), rest.end());
    std::string out = "{";
    for (std::size_t k = 0; k < m.size(); ++k) out += (k ? ",\n " : "\n ") + quote(m[k].first) + ": " + m[k].second;
    return out + "\n}\n";
}

}  // namespace bench
