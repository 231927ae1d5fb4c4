#pragma once

#include <atomic>
#include <stop_token>
#include <thread>

namespace analogon::cli {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM ask the work to stop instead of ending the program; a second one
/// ends it. The handler only raises a flag; a thread that looks at it every few milliseconds passes it on.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return stop_.get_token(); }
    bool wasRaised() const { return stop_.stop_requested(); }

private:
    std::stop_source stop_;
    std::jthread watcher_;
};

}  // namespace analogon::cli
