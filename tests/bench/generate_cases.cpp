// Generates studies with a hidden effect and a known truth; see README.md beside this file.
//
//   generate_cases --out DIR [--seed N] [--count N] [--system A..F] [--class C] [--kind K] [--with K] [--rho X]
//                  [--no-twins]
//
//   generate_cases --replay FILE
//
//   generate_cases --self-check N [--seed N]
//
// Classes: none, none-coloured, none-disturbed, single, single-disturbed, double, outside. What is not given is drawn
// at random; single-disturbed comes only when it is asked for.

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <set>

#include "replay.hpp"
#include "write_case.hpp"

namespace bench {

struct Options {
    std::uint64_t seed{1};
    int count{1};
    std::string out, system, cls, kind, with;
    double rho{};
    bool twins{true};
    double threshold{10.0};  // chi-square under which two effects count as not told apart
};

/// Builds one case from its own random stream.
class CaseMaker {
public:
    CaseMaker(const Options& options, Random random) : options_(options), random_(random) {}

    std::optional<Case> make(const std::string& name) {
        cls_ = options_.cls.empty() ? drawClass() : options_.cls;
        target_ = options_.rho > 0.0 ? options_.rho : random_.pick(std::vector<double>{0.3, 0.5, 1.0, 2.0, 4.0});
        for (int attempt = 0; attempt < 30; ++attempt) {
            case_ = Case{};
            case_.name = name;
            case_.cls = cls_.substr(0, cls_.find('-'));
            case_.variant = case_.cls.size() < cls_.size() ? cls_.substr(case_.cls.size() + 1) : "";
            if (!prepare() || !hide()) continue;
            // a winding may run away thermally in the one recording and not in the other
            if (record(case_.train) && record(case_.validation)) return case_;
        }
        return std::nullopt;
    }
    Random& random() { return random_; }
    int runs() const { return runs_; }

private:
    std::string drawClass() {
        if (!options_.kind.empty()) return options_.kind.starts_with("x.") ? "outside" : "single";
        const double p = random_.unit();
        return p < 0.12   ? "none"
               : p < 0.16 ? "none-coloured"
               : p < 0.20 ? "none-disturbed"
               : p < 0.78 ? "single"
               : p < 0.89 ? "double"
                          : "outside";
    }

    /// Design, inputs, noise levels.
    bool prepare() {
        const char system =
            options_.system.empty() ? static_cast<char>('A' + random_.integer(0, 5)) : options_.system[0];
        case_.design = Builder(system, random_).design();
        const Design& d = case_.design;
        case_.train.experiment = excite(d, d.duration, random_);
        case_.validation.experiment = excite(d, 0.85 * d.duration, random_);
        for (Run* run : {&case_.train, &case_.validation}) {
            const auto inputs = d.model.names(true);
            for (std::size_t k = 0; k < inputs.size(); ++k)
                for (const auto& s : d.model.signals)
                    if (s.name == inputs[k] && s.unit == "K") run->startT = run->experiment.inputs[k][0];
            if (case_.variant == "disturbed")
                run->experiment.disturbance =
                    coloured(random_, run->experiment.samples, random_.uniform(0.01, 0.04) * run->experiment.samples);
        }
        base_ = Refit(d, case_.train.experiment, {}, case_.train.startT).record({}, {});
        if (!base_.ok) return false;
        const double level = random_.uniform(0.003, 0.012);
        for (const auto& y : base_.outputs) {
            const auto [low, high] = std::minmax_element(y.begin(), y.end());
            case_.sigma.push_back(level * random_.uniform(0.9, 1.1) * (*high - *low));
        }
        return true;
    }

    bool hide() {
        const Refit refit(case_.design, case_.train.experiment, case_.sigma, case_.train.startT);
        const Plant plant = refit.plant({});
        Catalogue catalogue(case_.design.model, plant, case_.train.experiment, base_);
        bool ok = true;
        if (case_.cls == "none") {
            if (case_.variant == "disturbed") ok = single(refit, catalogue.disturbance());
        } else if (case_.cls == "outside") {
            ok = single(refit, catalogue.outside(random_));
        } else {
            const auto proposals = catalogue.inside();
            ok = case_.cls == "double"          ? pairOf(refit, proposals)
                 : case_.variant == "disturbed" ? besideDisturbance(refit, proposals, catalogue.disturbance())
                                                : single(refit, proposals);
        }
        if (ok)
            describe(refit,
                     case_.cls == "single" || case_.cls == "double" ? catalogue_(plant) : std::vector<Proposal>{});
        runs_ += refit.runs;
        return ok;
    }
    std::vector<Proposal> catalogue_(const Plant& plant) {
        return Catalogue(case_.design.model, plant, case_.train.experiment, base_).inside();
    }

    /// A kind, those of the plant twice as often as those of its signals; then a place of it.
    Choice draw(const std::vector<Proposal>& from) {
        std::set<std::string> kinds;
        for (const auto& p : from) kinds.insert(p.place.kind);
        std::vector<std::string> lots(kinds.begin(), kinds.end());
        for (const auto& k : kinds)
            if (!k.starts_with("sensor.") && !k.starts_with("actuator.")) lots.push_back(k);
        const std::string kind = random_.pick(lots);
        std::vector<Proposal> places;
        for (const auto& p : from)
            if (p.place.kind == kind) places.push_back(p);
        const Proposal& p = random_.pick(places);
        Choice c{p, random_.pick(p.shapes), p.typical * (p.bothSigns ? random_.sign() : 1.0)};
        if (p.place.kind == "friction.stribeck")
            for (auto& [key, v] : c.shape)
                v = rounded(key == "ratio" ? random_.uniform(0.6, 1.6) : v * random_.uniform(0.7, 1.4), 2);
        if (p.place.kind == "thermal.mass")
            for (auto& [key, v] : c.shape) v = rounded(v * random_.uniform(0.7, 1.4), 2);
        for (auto& [key, v] : c.shape)
            if (key == "phi_0") v = rounded(v + random_.uniform(0.0, 0.5), 2);
        return c;
    }
    static std::vector<Proposal> wanted(const std::vector<Proposal>& from, const std::string& kind) {
        std::vector<Proposal> out;
        for (const auto& p : from)
            if (kind.empty() || p.place.kind == kind) out.push_back(p);
        return out;
    }

    bool single(const Refit& refit, const std::vector<Proposal>& from) {
        const auto proposals = wanted(from, options_.kind);
        if (proposals.empty()) return false;
        for (int attempt = 0; attempt < 6; ++attempt) {
            Choice c = draw(proposals);
            if (!scaleTo(refit, c, target_)) continue;
            choices_ = {tidy(c)};
            return true;
        }
        return false;
    }

    /// Two kinds at two places, each leaving at least the noise when the other is known.
    bool pairOf(const Refit& refit, const std::vector<Proposal>& proposals) {
        target_ = std::max(1.0, target_);
        for (int attempt = 0; attempt < 4; ++attempt) {
            const auto mine = wanted(proposals, options_.kind), others = wanted(proposals, options_.with);
            if (mine.empty() || others.empty()) return false;
            Choice a = draw(mine), b = draw(others);
            const auto group = [](const Choice& c) {
                return c.proposal.place.kind.substr(0, c.proposal.place.kind.find('.'));
            };
            const std::string& at = a.proposal.place.at.front();
            const bool isSignal = at.starts_with("input ") || at.starts_with("output ");
            const bool sameSignal = isSignal && a.proposal.place.at == b.proposal.place.at;
            const bool sameGroup = group(a) == group(b) && options_.with.empty();
            if (a.proposal.place.kind == b.proposal.place.kind || sameGroup || sameSignal) continue;
            if (!scaleTo(refit, a, target_) || !scaleTo(refit, b, target_)) continue;
            choices_ = {a, b};
            bool ok = false;
            for (int round = 0; round < 3 && !ok; ++round) {
                ok = true;
                for (std::size_t k = 0; k < 2; ++k) {
                    const auto left = leftOver(refit, choices_, k, 5);
                    if (!left) return false;
                    const double rho = left->rho();
                    if (rho >= 1.0) continue;
                    ok = false;
                    choices_[k].strength *= std::min(3.0, 1.15 / std::max(rho, 0.1));
                    if (std::abs(choices_[k].strength) > choices_[k].proposal.most) return false;
                }
            }
            if (!ok) continue;
            for (auto& c : choices_) c = tidy(c);
            return true;
        }
        return false;
    }

    /// An effect and an unmeasured flow that leaves as much, each at least the noise.
    bool besideDisturbance(const Refit& refit, const std::vector<Proposal>& proposals,
                           const std::vector<Proposal>& disturbances) {
        target_ = std::max(1.0, target_);
        if (!single(refit, proposals)) return false;
        Choice flow = draw(disturbances);
        if (!scaleTo(refit, flow, target_)) return false;
        choices_.push_back(tidy(flow));
        return true;
    }

    /// Four digits are enough for a strength.
    static Choice tidy(Choice c) {
        c.strength = rounded(c.strength, 4);
        return c;
    }

    /// Residual strength, baseline and twins of what was hidden.
    void describe(const Refit& refit, const std::vector<Proposal>& catalogue) {
        case_.target = choices_.empty() ? 0.0 : target_;
        std::vector<double> baseline(refit.parameters(), 0.0);
        for (std::size_t k = 0; k < choices_.size(); ++k) {
            const auto left = leftOver(refit, choices_, k);
            if (!left) continue;
            Hidden h{choices_[k].effect(), left->rho(), {}};
            if (k == 1 && case_.variant == "disturbed") {
                case_.disturbance = h;
                break;
            }
            if (options_.twins && !catalogue.empty())
                h.twins = twins(refit, choices_, k, *left, catalogue, options_.threshold);
            case_.hidden.push_back(h);
            case_.rho = k == 0 ? h.rho : std::min(case_.rho, h.rho);
            if (choices_.size() == 1)
                baseline.assign(left->z.begin(), left->z.begin() + static_cast<std::ptrdiff_t>(refit.parameters()));
        }
        if (choices_.size() == 2) {
            const auto target = refit.weighted({}, effectsOf(choices_));
            if (const auto both = EffectFit(refit, {}).fit(*target, baseline, 8)) baseline = both->z;
        }
        baseline_ = baseline;
    }

    /// What can be foretold of a run: all that is hidden but an unmeasured flow.
    std::vector<Choice> foretold() const {
        const bool beside = case_.disturbance.has_value();
        return {choices_.begin(), choices_.begin() + static_cast<std::ptrdiff_t>(choices_.size() - (beside ? 1 : 0))};
    }

    /// Adds noise and states the error figures; false: the plant does not stay finite.
    bool record(Run& run) {
        const Refit refit(case_.design, run.experiment, case_.sigma, run.startT);
        run.recording = refit.record({}, effectsOf(choices_));
        run.clean = run.measured = run.recording.outputs;
        const Recording base = refit.record(baseline_, {}), best = refit.record({}, effectsOf(foretold()));
        runs_ += refit.runs;
        if (!run.recording.ok || !base.ok || !best.ok) return false;
        const bool correlated = case_.variant == "coloured";
        const double memory = correlated ? random_.uniform(5.0, 40.0) : 0.0;
        for (std::size_t c = 0; c < run.clean.size(); ++c) {
            const Series slow = correlated ? coloured(random_, run.experiment.samples, memory) : Series{};
            for (std::size_t k = 0; k < run.clean[c].size(); ++k)
                run.measured[c][k] +=
                    case_.sigma[c] * (correlated ? 0.9 * slow[k] + 0.44 * random_.normal() : random_.normal());
            run.baseline.push_back(errorPercent(base.outputs[c], run.measured[c]));
            run.floor.push_back(case_.cls == "none" ? run.baseline.back()
                                                    : errorPercent(best.outputs[c], run.measured[c]));
        }
        return true;
    }

    const Options& options_;
    Random random_;
    std::string cls_;
    double target_{};
    Case case_;
    Recording base_;
    std::vector<Choice> choices_;
    std::vector<double> baseline_;
    int runs_{};
};

std::string describe(const Case& c) {
    std::string text = c.cls + (c.variant.empty() ? "" : "-" + c.variant) + "  " + c.design.systemName;
    for (const auto& h : c.hidden) {
        text += "  " + h.effect.place.kind + " @ " + (h.effect.place.at.empty() ? "-" : h.effect.place.at.front()) +
                " rho " + shortNumber(h.rho, 3);
        for (const auto& t : h.twins) text += " ~" + t.place.kind + "@" + t.place.at.front();
    }
    return text;
}

int generate(const Options& options) {
    int failed = 0;
    for (int k = 0; k < options.count; ++k) {
        const auto begin = std::chrono::steady_clock::now();
        CaseMaker maker(options, Random(Random(options.seed * 1000003ULL + static_cast<std::uint64_t>(k)).bits()));
        char name[64];
        std::snprintf(name, sizeof name, "bench-%llu-%04d", static_cast<unsigned long long>(options.seed), k + 1);
        std::optional<Case> made;
        try {
            made = maker.make(name);
        } catch (const std::exception& e) {  // one odd draw must not end the series
            std::fprintf(stderr, "%s: %s\n", name, e.what());
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        if (!made) {
            std::printf("%s  no such case found\n", name);
            ++failed;
            continue;
        }
        CaseWriter(*made, maker.random()).write(std::filesystem::path(options.out) / name);
        std::printf("%s  %s  [%d runs, %.2f s]\n", name, describe(*made).c_str(), maker.runs(), seconds);
        std::fflush(stdout);
    }
    return failed == options.count ? 3 : 0;
}

/// Base models fitted to their own noise-free records, from the start values of the study: nothing may be left over.
int selfCheck(int count, std::uint64_t seed) {
    bool good = true;
    for (char system = 'A'; system <= 'F'; ++system)
        for (int k = 0; k < count; ++k) {
            Random random(Random(seed * 7919ULL + static_cast<std::uint64_t>(100 * system + k)).bits());
            const Design d = Builder(system, random).design();
            const Experiment e = excite(d, d.duration, random);
            Refit plain(d, e, {}, 293.15);
            const Recording base = plain.record({}, {});
            const Recording fine = simulate(plain.plant({}), e, 0.25);
            std::vector<double> sigma, start;
            double step = 0.0;
            std::string ranges;
            for (std::size_t c = 0; c < base.outputs.size(); ++c) {
                const auto [low, high] = std::minmax_element(base.outputs[c].begin(), base.outputs[c].end());
                sigma.push_back(0.005 * (*high - *low));
                step = std::max(step, rms(minus(base.outputs[c], fine.outputs[c])) / sigma.back());
                ranges += " [" + shortNumber(*low, 4) + ", " + shortNumber(*high, 4) + "]";
            }
            for (const auto& f : d.fitted) start.push_back(std::log(f.start / f.truth));
            const Refit refit(d, e, sigma, 293.15);
            const auto target = refit.weighted({}, {});
            const auto optimum =
                leastSquares([&](const std::vector<double>& z) { return refit.weighted(z, {}); }, *target, start, 30);
            double worst = 0.0;
            for (double z : optimum->z) worst = std::max(worst, std::abs(z));
            const bool ok = optimum->rho() < 0.01 && step < 0.1;
            good = good && ok;
            std::printf("%s %-32s rho %.1e  parameters off by %.1e  step error %.1e sigma  outputs%s\n",
                        ok ? "ok  " : "BAD ", d.systemName.c_str(), optimum->rho(), worst, step, ranges.c_str());
        }
    return good ? 0 : 1;
}

int main_(int argc, char** argv) {
    Options options;
    int checks = 0;
    for (int k = 1; k < argc; ++k) {
        const std::string key = argv[k];
        if (key == "--no-twins") {
            options.twins = false;
            continue;
        }
        if (k + 1 >= argc) throw std::runtime_error(key + " needs a value");
        const std::string value = argv[++k];
        if (key == "--replay") return replay(value);
        if (key == "--out")
            options.out = value;
        else if (key == "--seed")
            options.seed = std::stoull(value);
        else if (key == "--self-check")
            checks = std::stoi(value);
        else if (key == "--count")
            options.count = std::stoi(value);
        else if (key == "--system")
            options.system = value;
        else if (key == "--class")
            options.cls = value;
        else if (key == "--kind")
            options.kind = value;
        else if (key == "--with")
            options.with = value;
        else if (key == "--rho")
            options.rho = std::stod(value);
        else
            throw std::runtime_error("unknown option " + key);
    }
    if (checks > 0) return selfCheck(checks, options.seed);
    if (options.out.empty()) throw std::runtime_error("--out DIR is missing");
    return generate(options);
}

}  // namespace bench

int main(int argc, char** argv) {
    try {
        return bench::main_(argc, argv);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "generate_cases: %s\n", e.what());
        return 2;
    }
}
