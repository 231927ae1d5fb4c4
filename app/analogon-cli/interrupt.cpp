#include "app/analogon-cli/interrupt.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <ctime>
#include <iostream>

#include "app/analogon-cli/command_line.hpp"

namespace analogon::cli {

namespace {

using std::chrono::milliseconds;

constexpr long sameInterrupt = 1000;  // [ms]
// How long the work has to come back: so long at least, and so much processor time, which is what counts on a busy
// machine; what waits for something else than a processor uses none.
constexpr milliseconds leastWait{150}, leastWork{140}, mostWait{600};

// all that a signal handler may touch
volatile std::sig_atomic_t raised = 0, isHeld = 0;
volatile long firstAt = 0;

long timeOf(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return time.tv_sec * 1000 + time.tv_nsec / 1'000'000;
}

extern "C" void onSignal(int) {
    const long now = timeOf(CLOCK_MONOTONIC);
    if (raised == 0) firstAt = now;
    raised = raised + 1;
    const bool isSame = raised <= 2 && now - firstAt < sameInterrupt;
    if (!isSame && !isHeld) _exit(interrupted);
}

/// The program is about to end by itself, with a status of its own.
extern "C" void onLateSignal(int) {}

void install(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        struct sigaction before {};
        sigaction(signal, nullptr, &before);
        if (before.sa_handler == SIG_IGN) continue;  // nohup: who started the program wants it so
        sigaction(signal, &action, nullptr);
    }
}

}  // namespace

void Interrupt::listen() { install(onSignal); }

Interrupt::Interrupt() {
    isHeld = 0;
    listen();
    watcher_ = std::jthread([this](const std::stop_token& end) { watch(end); });
}

Interrupt::~Interrupt() {
    tell();
    watcher_.request_stop();
    watcher_.join();
    telling_.unlock();
    install(onLateSignal);
}

void Interrupt::watch(const std::stop_token& end) {
    const auto pause = [] { std::this_thread::sleep_for(milliseconds(3)); };
    while (!raised) {
        if (end.stop_requested()) return;
        pause();
    }
    stop_.request_stop();
    const long begin = timeOf(CLOCK_MONOTONIC), work = timeOf(CLOCK_PROCESS_CPUTIME_ID);
    for (; !end.stop_requested(); pause()) {
        const milliseconds waited(timeOf(CLOCK_MONOTONIC) - begin);
        const milliseconds worked(timeOf(CLOCK_PROCESS_CPUTIME_ID) - work);
        if (waited < mostWait && (waited < leastWait || worked < leastWork)) continue;
        if (!telling_.try_lock()) continue;
        isHeld = 1;
        const std::lock_guard lock(words_);
        if (lastWords_)
            lastWords_();
        else
            std::cerr << "interrupted before there was a result" << std::endl;
        _exit(interrupted);
    }
}

void Interrupt::tell() {
    if (isTold_) return;
    telling_.lock();
    isTold_ = true;
    isHeld = 1;
}

Interrupt::LastWords::LastWords(Interrupt& interrupt, std::function<void()> say) : interrupt_(interrupt) {
    const std::lock_guard lock(interrupt_.words_);
    interrupt_.lastWords_ = std::move(say);
}

Interrupt::LastWords::~LastWords() {
    const std::lock_guard lock(interrupt_.words_);
    interrupt_.lastWords_ = nullptr;
}

}  // namespace analogon::cli
