#pragma once

#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace analogon::cli {

/// While it lives, Ctrl-C (SIGINT), SIGTERM and SIGHUP ask the work to stop instead of ending the program. A second one
/// within a second is the same interrupt, which some shells and `timeout` send twice; any further one ends the program
/// at once. The handler only counts; a thread that looks every few milliseconds passes it on.
///
/// Work that does not come back soon is not waited for: that thread says the last words (what was found until then) and
/// ends the program with the status 130. What is told once is told to its end, by one of the two; after it signals
/// change nothing, since the program is about to end.
class Interrupt {
public:
    /// Counts signals from here on; where there was one, the Interrupt that is made later begins as one that was
    /// raised. The first thing that a program does: until then a signal ends it without a word.
    static void listen();

    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return stop_.get_token(); }
    bool wasRaised() const { return stop_.stop_requested(); }

    /// The work has come back: from here on nothing ends the program but itself. Does not return where the last words
    /// are being said.
    void tell();

    /// What is said instead of the work, while it lives. Without them: that there was no result.
    class LastWords {
    public:
        LastWords(Interrupt& interrupt, std::function<void()> say);
        ~LastWords();
        LastWords(const LastWords&) = delete;
        LastWords& operator=(const LastWords&) = delete;

    private:
        Interrupt& interrupt_;
    };

private:
    void watch(const std::stop_token& end);

    std::stop_source stop_;
    std::mutex telling_;
    bool isTold_{};  // by the thread of the work, which holds telling_ then
    std::function<void()> lastWords_;
    std::mutex words_;
    std::jthread watcher_;
};

}  // namespace analogon::cli
