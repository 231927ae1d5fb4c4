#pragma once

#include <set>
#include <string>
#include <tuple>

#include "core/base/diagnostic.hpp"

namespace analogon {

/// Faults found while flattening: each once per place (an array of components repeats its faults), and no more
/// than a person reads.
class Messages {
public:
    static constexpr std::size_t most = 20;

    void error(const Text& message, const Span& span, const Text& hint = {});
    /// An error after which nothing more is done: the model is too large to go on.
    void fatal(const Text& message, const Span& span, const Text& hint = {});
    /// One that leaves nothing else to say of the model; nothing where it is only tried.
    void refusal(const Text& message, const Span& span, const Text& hint = {});
    void warning(const Text& message, const Span& span, const Text& hint = {});

    /// While one lives, faults are not taken: something is only tried.
    class Quiet {
    public:
        explicit Quiet(Messages& messages) : messages_(messages) { ++messages_.quiet_; }
        ~Quiet() {
            if (messages_.quiet_ > 0) --messages_.quiet_;
        }
        Quiet(const Quiet&) = delete;
        Quiet& operator=(const Quiet&) = delete;

    private:
        Messages& messages_;
    };

    bool hasErrors() const { return hasErrors_; }
    /// Nothing more will be taken: the work may stop.
    bool full() const { return isStopped_ || diagnostics_.size() >= most; }
    const Diagnostics& diagnostics() const { return diagnostics_; }
    /// Brings those from a number on into the order of the text, file by file as they came: a text was read in passes.
    void sortFrom(std::size_t first);

private:
    bool isNew(const std::string& message, const Span& span);

    Diagnostics diagnostics_;
    bool hasErrors_{};
    bool isStopped_{};
    int quiet_{};
    std::set<std::tuple<std::string, const Source*, std::uint32_t>> seen_;
};

/// "did you mean 'x'?" or empty.
Text didYouMean(std::string_view misspelt, const std::vector<std::string>& names);

}  // namespace analogon
