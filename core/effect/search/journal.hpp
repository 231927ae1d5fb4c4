#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/effect/catalogue/finding.hpp"
#include "core/effect/course/held_parameter.hpp"
#include "core/effect/judge/decision_trace.hpp"
#include "core/effect/model/evidence.hpp"
#include "core/effect/search/round.hpp"

namespace analogon {

/// Where the search is, and what it decides, told to whoever asks (DiscoverOptions::trace). Never written to from
/// within a parallel pass.
class Journal {
public:
    explicit Journal(std::shared_ptr<DecisionTrace> trace) : trace_(std::move(trace)) {}

    int path{}, round{};  // the present one
    int choices{};        // so far

    void add(const std::string& step, const std::string& key, Decision::Figures figures, const std::string& verdict,
             const Text& reason = {}) const;
    void test(const std::string& step, const std::string& key, const Acceptance& test, const std::string& verdict,
              const Text& reason = {}) const;
    void model(const std::string& step, const NullModel& model, const std::string& verdict,
               const Text& reason = {}) const;
    void trials(const std::string& step, const NullModel& null, const std::vector<Trial>& trials) const;
    /// What was screened and refitted beside a model.
    void tried(const NullModel& null, const Round& round) const;
    void heldValues(const std::string& key, const std::vector<HeldInstead>& values, const std::string& verdict) const;
    void finding(const Finding& finding) const;

private:
    void screening(const std::vector<Screened>& screened) const;

    std::shared_ptr<DecisionTrace> trace_;
};

}  // namespace analogon
