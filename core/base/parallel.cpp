#include "core/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "core/base/guard.hpp"
#include "core/base/stop.hpp"
#include "core/base/work.hpp"

namespace analogon {

int threadCount(int threads) {
    return threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

void parallelFor(int count, int threads, const std::function<void(int)>& body) {
    threads = std::min(threadCount(threads), count);
    if (threads <= 1) {
        for (int i = 0; i < count; ++i) body(i);
        return;
    }
    std::atomic<int> next{0};
    std::exception_ptr fault;
    std::mutex guard;
    const auto work = [&, stop = stopInForce(), steps = workInForce()] {
        const StopScope scope(stop);
        const WorkScope counted(steps);
        for (int i = next++; i < count; i = next++) {
            try {
                body(i);
            } catch (...) {
                const std::lock_guard lock(guard);
                if (!fault) fault = std::current_exception();
                next = count;
            }
        }
    };
    {
        std::vector<std::jthread> pool;
        try {
            for (int k = 1; k < threads; ++k)
                pool.emplace_back([&work] {
                    const StackGuard stack;
                    work();
                });
        } catch (const std::system_error&) {
            // the system gives no more threads: those there are do it all
        }
        work();
    }
    if (fault) std::rethrow_exception(fault);
}

}  // namespace analogon
