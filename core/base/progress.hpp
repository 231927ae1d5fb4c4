#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/text.hpp"

namespace analogon {

/// Handed to long work: asks whether to stop, tells how far it is. Copies share the same stop state.
/// The report function must be safe to call from any thread of the work.
class Progress {
public:
    /// What a fit has for a parameter; `experiment` is empty where all experiments share it.
    struct Value {
        std::string name, experiment;
        double value{};
    };
    struct Report {
        std::string stage;          // "fit", "screen", "trial" …
        Text detail;                // the candidate or experiment at hand
        double fraction{};          // 0 … 1; negative: not known
        double error{-1};           // best error_percent so far; negative: not known
        std::vector<Value> best{};  // so far, of the fit that reports
    };
    using Sink = std::function<void(const Report&)>;

    Progress() = default;
    Progress(std::stop_token stop, Sink sink) : stop_(std::move(stop)), sink_(std::move(sink)) {}

    bool stopRequested() const { return stop_.stop_requested(); }
    const std::stop_token& stopToken() const { return stop_; }
    void report(const Report& r) const {
        if (sink_) sink_(r);
    }

private:
    std::stop_token stop_;
    Sink sink_;
};

}  // namespace analogon
