#include "core/base/apart.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>

#include "core/base/pipe.hpp"

namespace analogon {

namespace {

constexpr int pollMilliseconds = 20;  // between two looks at whether to stop

[[noreturn]] void workAndEnd(const std::function<std::string()>& work, double mostSeconds, int out) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const auto limit = static_cast<rlim_t>(std::ceil(mostSeconds));
    const rlimit processor{limit, limit};
    setrlimit(RLIMIT_CPU, &processor);
    for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(number, SIG_DFL);
    try {
        const std::string bytes = work();
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t written = write(out, bytes.data() + done, bytes.size() - done);
            if (written < 0 && errno != EINTR) _exit(EXIT_FAILURE);
            if (written > 0) done += static_cast<std::size_t>(written);
        }
        _exit(EXIT_SUCCESS);
    } catch (...) {
        _exit(EXIT_FAILURE);
    }
}

/// Everything that comes until the other end is closed; false: stopped before.
bool readAll(int in, const Progress& progress, std::string& bytes) {
    for (;;) {
        if (progress.stopRequested()) return false;
        pollfd ready{in, POLLIN, 0};
        if (poll(&ready, 1, pollMilliseconds) > 0 && !readSome(in, bytes)) return true;
    }
}

/// Whether it ended by itself and in success.
bool awaitSuccess(pid_t process) {
    int status = 0;
    while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR) return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

}  // namespace

Outcome<std::string> runApart(const std::function<std::string()>& work, double mostSeconds,
                              const Diagnostic& whenItEnds, const Progress& progress) {
    const std::string& file = whenItEnds.place.file;
    std::optional<Pipe> pipe = Pipe::make();
    const pid_t process = pipe ? fork() : -1;
    if (process == 0) workAndEnd(work, mostSeconds, pipe->write.number());
    if (process < 0)
        return fileError(phrase("the system refuses what the program asks for: {}", std::strerror(errno)), file, 0, 0,
                         phrase("Check the limits of the system (ulimit -a) and the space on the disk."));
    pipe->write.reset();
    std::string bytes;
    const bool isWhole = readAll(pipe->read.number(), progress, bytes);
    if (!isWhole) kill(process, SIGKILL);
    const bool ended = awaitSuccess(process);
    if (!isWhole) return fileError(phrase("reading was stopped"), file);
    if (!ended) return whenItEnds;
    return bytes;
}

double mostReadingTime(const std::filesystem::path& file) {
    constexpr double least = 2, bytesPerSecond = 5e6;
    std::error_code code;
    const auto size = std::filesystem::file_size(file, code);
    return least + (code ? 0 : static_cast<double>(size) / bytesPerSecond);
}

}  // namespace analogon
