#include "core/base/guard.hpp"

#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <ios>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "core/base/limits.hpp"
#include "core/base/visible.hpp"

namespace analogon {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool isWatched = true;  // by sanitizers, which reserve more memory than there is and handle signals
#else
constexpr bool isWatched = false;
#endif

Diagnostic inputFault(Text message, Text hint) { return fileError(std::move(message), {}, 0, 0, std::move(hint)); }

Text reportHint() { return phrase("This is a fault of the program. Please report it with the study that led to it."); }

}  // namespace

Diagnostic faultOf(const std::exception_ptr& thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const LimitReached& limit) {
        return limit.fault();
    } catch (const std::bad_alloc&) {
        return inputFault(phrase("there is not enough memory for this"),
                          phrase("Use a part of the recordings (\"range\"), fewer of their columns or rows, a smaller "
                                 "model, or a machine with more memory."));
    } catch (const std::length_error&) {
        return inputFault(phrase("this is too large to be worked out"),
                          phrase("Use a part of the recordings (\"range\"), or a smaller model."));
    } catch (const std::filesystem::filesystem_error& fault) {
        return fileError(phrase("the file cannot be read or written: {}", fault.code().message()),
                         fault.path1().string(), 0, 0, phrase("Check its name and its access rights."));
    } catch (const std::system_error& fault) {  // a thread or a file that the system refuses
        return inputFault(phrase("the system refuses what the program asks for: {}", fault.code().message()),
                          phrase("Check the limits of the system (ulimit -a) and the space on the disk."));
    } catch (const std::exception& fault) {
        return numericalError(phrase("an error that was not foreseen: {}", shortened(fault.what(), 200)), reportHint());
    } catch (...) {
        return numericalError(phrase("an error that was not foreseen"), reportHint());
    }
}

namespace {

constexpr std::size_t signalStackSize = std::size_t{64} << 10;

/// The lowest address of the stack of each guarded thread.
thread_local std::uintptr_t stackEnd = 0;

/// Only what a signal handler may do.
extern "C" void onFault(int signal, siginfo_t* info, void*) {
    constexpr std::uintptr_t reach = std::uintptr_t{2} << 20;  // the gap that the system keeps below a stack
    const auto at = reinterpret_cast<std::uintptr_t>(info->si_addr);
    if (stackEnd == 0 || at > stackEnd + reach || at + reach < stackEnd) {
        std::signal(signal, SIG_DFL);  // another fault is the system's
        std::raise(signal);
        return;
    }
    constexpr char words[] =
        "error: this nests deeper than the program can follow\n"
        "    hint: Build the model, or the study, of fewer levels within each other.\n";
    [[maybe_unused]] const auto written = write(STDERR_FILENO, words, sizeof words - 1);
    _exit(2);
}

std::uintptr_t endOfStack() {
    pthread_attr_t attributes;
    if (pthread_getattr_np(pthread_self(), &attributes) != 0) return 0;
    void* lowest = nullptr;
    std::size_t size = 0;
    pthread_attr_getstack(&attributes, &lowest, &size);
    pthread_attr_destroy(&attributes);
    return reinterpret_cast<std::uintptr_t>(lowest);
}

void installHandler() {
    struct sigaction action {};
    action.sa_sigaction = onFault;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigaction(SIGSEGV, &action, nullptr);
    sigaction(SIGBUS, &action, nullptr);
}

/// What escapes from a thread, or from where nothing may be thrown.
[[noreturn]] void onTerminate() {
    Diagnostic fault = numericalError(phrase("an error that was not foreseen"), reportHint());
    try {
        if (const std::exception_ptr thrown = std::current_exception()) fault = faultOf(thrown);
        const std::string words = format(fault);
        [[maybe_unused]] const auto written = write(STDERR_FILENO, words.data(), words.size());
    } catch (...) {
        constexpr char words[] = "error: there is not enough memory for this\n";
        [[maybe_unused]] const auto written = write(STDERR_FILENO, words, sizeof words - 1);
    }
    _exit(fault.isNumerical ? 3 : 2);
}

}  // namespace

StackGuard::StackGuard() {
    if (isWatched) return;
    static const bool isInstalled = (installHandler(), true);
    static_cast<void>(isInstalled);
    signalStack_ = std::malloc(signalStackSize);
    if (!signalStack_) return;
    stack_t stack{};
    stack.ss_sp = signalStack_;
    stack.ss_size = signalStackSize;
    sigaltstack(&stack, nullptr);
    stackEnd = endOfStack();
}

StackGuard::~StackGuard() {
    if (!signalStack_) return;
    stackEnd = 0;
    stack_t none{};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
    std::free(signalStack_);
}

void guardProgram() {
    std::set_terminate(onTerminate);
    if (isWatched) return;
    rlimit limit{};
    if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, limits::memory());
    setrlimit(RLIMIT_DATA, &limit);
}

}  // namespace analogon
