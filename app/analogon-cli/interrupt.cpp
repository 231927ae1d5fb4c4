#include "app/analogon-cli/interrupt.hpp"

#include <unistd.h>

#include <chrono>
#include <csignal>

namespace analogon::cli {

namespace {

volatile std::sig_atomic_t raised = 0;  // all that a signal handler may touch

extern "C" void onSignal(int) {
    if (raised) _exit(130);
    raised = 1;
}

void install(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interrupt::Interrupt() {
    raised = 0;
    install(onSignal);
    watcher_ = std::jthread([this](const std::stop_token& end) {
        while (!end.stop_requested()) {
            if (raised) stop_.request_stop();
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
    });
}

Interrupt::~Interrupt() {
    watcher_.request_stop();
    watcher_.join();
    install(SIG_DFL);
}

}  // namespace analogon::cli
