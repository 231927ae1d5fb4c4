#pragma once

#include <chrono>
#include <exception>
#include <stop_token>
#include <thread>

namespace analogon {

/// Ends work that was asked to stop, from however deep within it. Thrown by stopPoint() alone, and caught where what
/// was found until then is told: in a search, a fit, a command.
class Stopped final : public std::exception {
public:
    const char* what() const noexcept override { return "stopped"; }
};

/// While it lives, what this thread does is asked to stop by this token; parallelFor passes it on to its threads. A
/// token that can never ask leaves the one in force.
class StopScope {
public:
    explicit StopScope(std::stop_token token);
    ~StopScope();
    StopScope(const StopScope&) = delete;
    StopScope& operator=(const StopScope&) = delete;

private:
    std::stop_token token_;
    const std::stop_token* outer_;
};

/// The token of the innermost scope; one that never asks where there is none.
std::stop_token stopInForce();

/// Whether what this thread does was asked to stop.
bool isStopped();

/// Throws Stopped where it was. Costs next to nothing beside a few microseconds of work.
void stopPoint();

/// A token that asks to stop once this thread has worked for so long (processor time: the same on a busy machine):
/// what is left for telling what was found.
class StopAfter {
public:
    explicit StopAfter(std::chrono::milliseconds work);

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::jthread timer_;  // the last member: it ends before what it uses
};

}  // namespace analogon
