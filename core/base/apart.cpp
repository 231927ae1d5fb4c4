#include "core/base/apart.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "core/base/pipe.hpp"

namespace analogon {

namespace {

constexpr int pollMilliseconds = 20;  // between two looks at whether to stop

/// [byte] of the address space of this process, the shadow of a sanitizer included.
double addressSpace() {
    unsigned long long pages = 0;
    if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%llu", &pages) != 1) pages = 0;
        std::fclose(file);
    }
    return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void limit(const ApartLimits& limits) {
    const auto seconds = static_cast<rlim_t>(std::ceil(limits.seconds));
    const rlimit processor{seconds, seconds};
    setrlimit(RLIMIT_CPU, &processor);
    const double before = addressSpace();
    if (!(before > 0) || !(limits.bytes < 1e18)) return;
    const auto bytes = static_cast<rlim_t>(before + limits.bytes);
    const rlimit memory{bytes, bytes};
    setrlimit(RLIMIT_AS, &memory);
}

[[noreturn]] void workAndEnd(const std::function<std::string()>& work, const ApartLimits& limits, int out) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(limits);
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

Outcome<std::string> runApart(const std::function<std::string()>& work, const ApartLimits& limits,
                              const Diagnostic& whenItEnds, const Progress& progress) {
    const std::string& file = whenItEnds.place.file;
    std::optional<Pipe> pipe = Pipe::make();
    const pid_t process = pipe ? fork() : -1;
    if (process == 0) workAndEnd(work, limits, pipe->write.number());
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

namespace {

double sizeOf(const std::filesystem::path& file) {
    std::error_code code;
    const auto size = std::filesystem::file_size(file, code);
    return code ? 0 : static_cast<double>(size);
}

}  // namespace

double mostReadingTime(const std::filesystem::path& file) {
    constexpr double least = 2, bytesPerSecond = 5e6;
    return least + sizeOf(file) / bytesPerSecond;
}

double mostReadingMemory(const std::filesystem::path& file) {
    constexpr double least = 768.0 * (1 << 20), mostPacked = 1032, copies = 4;  // deflate cannot do better
    return least + copies * mostPacked * sizeOf(file);
}

}  // namespace analogon
