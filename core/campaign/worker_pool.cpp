#include "core/campaign/worker_pool.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>

#include "core/base/file_step.hpp"
#include "core/base/pipe.hpp"

namespace analogon {

namespace {

constexpr std::size_t lastWords = 2000;  // [byte] of what a worker says that are kept

/// Everything between fork and exec: system calls alone.
[[noreturn]] void becomeWorker(char* const* arguments, int in, int out, int error, pid_t parent) {
    setpgid(0, 0);  // Ctrl-C is for the one who started it
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(127);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(error, STDERR_FILENO);
    execv(arguments[0], arguments);
    _exit(127);
}

}  // namespace

WorkerPool::WorkerPool(std::vector<std::string> command, int size)
    : command_(std::move(command)), workers_(static_cast<std::size_t>(std::max(1, size))) {
    signal(SIGPIPE, SIG_IGN);  // a worker that is gone is told by its pipe
}

WorkerPool::~WorkerPool() {
    for (Worker& worker : workers_)
        if (worker.process > 0) kill(worker.process, SIGKILL);
    for (Worker& worker : workers_)
        if (worker.process > 0) waitpid(worker.process, nullptr, 0);
}

bool WorkerPool::isFree() const {
    return std::any_of(workers_.begin(), workers_.end(), [](const Worker& w) { return !w.unit; });
}

Outcome<Done> WorkerPool::start(Worker& worker) {
    std::optional<Pipe> in = Pipe::make(), out = Pipe::make(), error = Pipe::make();
    if (!in || !out || !error) return analogon::error(phrase("no process can be started: {}", lastFault().message()));
    std::vector<char*> arguments;
    for (std::string& argument : command_) arguments.push_back(argument.data());
    arguments.push_back(nullptr);
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process < 0) return analogon::error(phrase("no process can be started: {}", lastFault().message()));
    if (process == 0)
        becomeWorker(arguments.data(), in->read.number(), out->write.number(), error->write.number(), parent);
    worker = Worker();
    worker.process = process;
    worker.in = std::move(in->write);
    worker.out = std::move(out->read);
    worker.error = std::move(error->read);
    return Done{};
}

Outcome<Done> WorkerPool::give(std::size_t unit, const std::string& name) {
    auto free = std::find_if(workers_.begin(), workers_.end(), [](const Worker& w) { return !w.unit && w.process; });
    if (free == workers_.end())
        free = std::find_if(workers_.begin(), workers_.end(), [](const Worker& w) { return !w.unit; });
    if (free->process == 0)
        if (Outcome<Done> started = start(*free); !started) return started;
    free->unit = unit;
    const std::string line = fmt::format("{} {}\n", unit, name);
    // a worker that died meanwhile is seen when it is read
    if (write(free->in.number(), line.data(), line.size()) < 0 && errno != EPIPE)
        return error(phrase("no process can be started: {}", lastFault().message()));
    return Done{};
}

std::string WorkerPool::bury(Worker& worker) {
    while (readSome(worker.error.number(), worker.words))
        ;
    if (worker.words.size() > lastWords) worker.words.erase(0, worker.words.size() - lastWords);
    int status = 0;
    waitpid(worker.process, &status, 0);
    std::string death = WIFSIGNALED(status)
                            ? fmt::format("the process of the unit was ended by signal {} ({})", WTERMSIG(status),
                                          strsignal(WTERMSIG(status)))
                            : fmt::format("the process of the unit ended with status {}", WEXITSTATUS(status));
    std::string said = worker.words;
    std::replace(said.begin(), said.end(), '\n', ' ');
    while (said.ends_with(' ')) said.pop_back();
    return said.empty() ? death : death + ": " + said;
}

void WorkerPool::read(Worker& worker, std::vector<WorkerEvent>& events) {
    for (std::size_t end; (end = worker.answer.find('\n')) != std::string::npos;) {
        const std::string line = worker.answer.substr(0, end);
        worker.answer.erase(0, end + 1);
        if (line == "ready") hasBegun_ = true;
        if (worker.unit && line == std::to_string(*worker.unit)) {
            events.push_back({*worker.unit, {}});
            worker.unit.reset();
        }
    }
}

Outcome<std::vector<WorkerEvent>> WorkerPool::wait(std::chrono::milliseconds time) {
    std::vector<pollfd> watched;
    std::vector<Worker*> owners;
    for (Worker& worker : workers_)
        if (worker.process > 0)
            for (const int handle : {worker.out.number(), worker.error.number()}) {
                watched.push_back({handle, POLLIN, 0});
                owners.push_back(&worker);
            }
    std::vector<WorkerEvent> events;
    if (poll(watched.data(), watched.size(), static_cast<int>(time.count())) <= 0) return events;
    for (std::size_t i = 0; i < watched.size(); i += 2) {
        Worker& worker = *owners[i];
        if (watched[i + 1].revents & POLLIN) readSome(worker.error.number(), worker.words);
        if (worker.words.size() > 2 * lastWords) worker.words.erase(0, worker.words.size() - lastWords);
        if (watched[i].revents == 0) continue;
        const bool isAlive = readSome(worker.out.number(), worker.answer);
        read(worker, events);
        if (isAlive) continue;
        const std::string death = bury(worker);
        const std::optional<std::size_t> unit = worker.unit;
        worker = Worker();
        if (!hasBegun_) return error(phrase("a process for the units could not begin: {}", death));
        if (unit) events.push_back({*unit, death});
    }
    return events;
}

}  // namespace analogon
