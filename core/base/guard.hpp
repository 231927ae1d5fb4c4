#pragma once

#include <exception>
#include <optional>

#include "core/base/outcome.hpp"
#include "core/base/stop.hpp"

/// The last line of defence. Faults are values everywhere; what is thrown nevertheless (no memory left, a library that
/// gives up, a case that nobody thought of) ends the work at hand with a sentence, and not the program without one.
namespace analogon {

/// A limit of limits.hpp that is met in the depth of some work.
class LimitReached : public std::exception {
public:
    explicit LimitReached(Diagnostic fault) : fault_(std::move(fault)) {}
    const char* what() const noexcept override { return fault_.message.english().c_str(); }
    const Diagnostic& fault() const { return fault_; }

private:
    Diagnostic fault_;
};

/// What was thrown, in words for the engineer. No memory and what belongs to files are faults of the input, all else is
/// one of the numerics.
Diagnostic faultOf(const std::exception_ptr& thrown);

/// Runs the work; its fault where it throws.
template <class Work>
std::optional<Diagnostic> guarded(Work&& work) {
    try {
        work();
    } catch (const Stopped&) {
        throw;  // no fault: caught where what was found until then is told
    } catch (...) {
        return faultOf(std::current_exception());
    }
    return std::nullopt;
}

/// Work that gives an Outcome: what it throws becomes its fault.
template <class Work>
auto guardedOutcome(Work&& work) -> decltype(work()) {
    try {
        return work();
    } catch (const Stopped&) {
        throw;
    } catch (...) {
        return faultOf(std::current_exception());
    }
}

/// While it lives, a stack of this thread that overflows ends the program with a sentence and exit status 2, where
/// otherwise a signal would end it without one. Without effect in builds with sanitizers, which have their own.
class StackGuard {
public:
    StackGuard();
    ~StackGuard();
    StackGuard(const StackGuard&) = delete;
    StackGuard& operator=(const StackGuard&) = delete;

private:
    void* signalStack_{};
};

/// For the begin of a program: asking for more memory than the machine has fails at once, and what nobody catches ends
/// the program with a sentence.
void guardProgram();

}  // namespace analogon
