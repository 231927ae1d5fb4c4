#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <random>
#include <string>

/// Files that are nearly sound: bytes and pieces of a sound one changed at random. Whatever reads them must end in a
/// result or in messages, within 10 s and 1 GiB. ANALOGON_MUTANTS sets how many; the long runs take 10 000 of each
/// kind.
namespace analogon {

/// The same text for the same number, on every machine.
inline std::string mutated(std::string text, unsigned number) {
    static const char* const spices[] = {"[[[[[[[[[[",
                                         "{\"a\":",
                                         "}",
                                         "]",
                                         "\"",
                                         "\\",
                                         ",",
                                         ",,,,,,,",
                                         ":",
                                         "null",
                                         "-1",
                                         "1e999",
                                         "-1e-999",
                                         "0",
                                         "true",
                                         "\x1b",
                                         "\xff",
                                         "\n",
                                         "\r",
                                         ";",
                                         "\t",
                                         "NaN",
                                         "\xef\xbb\xbf",
                                         "[x]",
                                         "(degC)",
                                         "rpm",
                                         "\"\"",
                                         "der(",
                                         "1:1000000",
                                         "u^u^u",
                                         "fill(1, 10, 10)",
                                         "T.T.T",
                                         "#"};
    std::mt19937 random(number);
    const auto pick = [&](std::size_t below) {
        return static_cast<std::size_t>(random() % std::max<std::size_t>(1, below));
    };
    for (std::size_t changes = 1 + pick(3); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = pick(text.size()), length = std::min(pick(20), text.size() - at);
        std::string piece = spices[pick(std::size(spices))];
        if (pick(20) == 0)
            for (int i = 0; i < 12; ++i) piece += piece;  // 4096 times
        switch (pick(5)) {
            case 0:
                text[at] = static_cast<char>(random() & 0xff);
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, piece);
                break;
            case 3:
                text.insert(pick(text.size()), std::string(text, at, length));
                break;
            default:
                text.replace(at, length, piece);
        }
    }
    return text;
}

inline unsigned mutants(unsigned usual) {
    const char* const told = std::getenv("ANALOGON_MUTANTS");
    return told ? static_cast<unsigned>(std::strtoul(told, nullptr, 10)) : usual;
}

/// Says which mutant it was where the program ends in the midst of one: by a fault, after 10 s of a processor, or where
/// it waits for two minutes.
class MutantWatch {
public:
    MutantWatch() {
        for (const int signal : {SIGALRM, SIGPROF, SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL})
            before_[signal] = std::signal(signal, [](int number) {
                char text[80];
                const int length = std::snprintf(text, sizeof text, "signal %d at mutant %u\n", number, current());
                if (write(STDERR_FILENO, text, static_cast<std::size_t>(length)) < 0) _exit(4);
                _exit(3);
            });
    }
    ~MutantWatch() {
        setitimer(ITIMER_REAL, &none_, nullptr);
        setitimer(ITIMER_PROF, &none_, nullptr);
        for (const int signal : {SIGALRM, SIGPROF, SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL})
            std::signal(signal, before_[signal]);
    }
    MutantWatch(const MutantWatch&) = delete;
    MutantWatch& operator=(const MutantWatch&) = delete;

    void begin(unsigned number) {
        current() = number;
        const itimerval work{{0, 0}, {10, 0}}, wait{{0, 0}, {120, 0}};
        setitimer(ITIMER_PROF, &work, nullptr);
        setitimer(ITIMER_REAL, &wait, nullptr);
    }

private:
    static volatile unsigned& current() {
        static volatile unsigned number = 0;
        return number;
    }
    itimerval none_{};
    void (*before_[NSIG])(int){};
};

/// [s] of a processor that this process and those that it waited for have worked: others on the machine do not count.
inline double processorTime() {
    double seconds = 0;
    for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        getrusage(whose, &usage);
        for (const timeval& time : {usage.ru_utime, usage.ru_stime})
            seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
    return seconds;
}

/// `make(number)`: does with that mutant whatever can be done; whether it went through. Some must not.
template <class Make>
void expectAllEnd(const Make& make, unsigned usual = 150) {
    const unsigned all = mutants(usual);
    unsigned through = 0, slowestNumber = 0;
    double slowest = 0;
    MutantWatch watch;
    for (unsigned number = 0; number < all; ++number) {
        SCOPED_TRACE(number);
        watch.begin(number);
        const double begin = processorTime();
        through += make(number);
        const double spent = processorTime() - begin;
        if (spent > slowest) {
            slowest = spent;
            slowestNumber = number;
        }
    }
    EXPECT_LT(slowest, 10.0) << "mutant " << slowestNumber;
    EXPECT_LT(through, all);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double memory = static_cast<double>(usage.ru_maxrss) / 1024;  // [MiB]
    EXPECT_LT(memory, 1024);
    std::printf("%u mutants, %u went through; slowest %.2f s (number %u); %.0f MiB\n", all, through, slowest,
                slowestNumber, memory);
}

}  // namespace analogon
