#include "core/base/stop.hpp"

#include <pthread.h>

#include <ctime>
#include <utility>

namespace analogon {

namespace {

thread_local const std::stop_token* inForce = nullptr;  // lies in the innermost scope of the thread

std::chrono::nanoseconds timeOf(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

StopScope::StopScope(std::stop_token token) : token_(std::move(token)), outer_(inForce) {
    if (token_.stop_possible()) inForce = &token_;
}

StopScope::~StopScope() { inForce = outer_; }

std::stop_token stopInForce() { return inForce ? *inForce : std::stop_token(); }

bool isStopped() { return inForce && inForce->stop_requested(); }

void stopPoint() {
    if (isStopped()) throw Stopped();
}

StopAfter::StopAfter(std::chrono::milliseconds work) {
    clockid_t clock{};
    if (pthread_getcpuclockid(pthread_self(), &clock) != 0) return;  // then nothing is cut short
    timer_ = std::jthread([this, clock, work, begin = timeOf(clock)](const std::stop_token& end) {
        while (!end.stop_requested()) {
            if (timeOf(clock) - begin >= work) source_.request_stop();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    });
}

}  // namespace analogon
