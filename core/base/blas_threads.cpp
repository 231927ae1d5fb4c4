#include "core/base/blas_threads.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace analogon {

std::optional<std::vector<std::string>> withOneBlasThread(char* const* environment) {
    constexpr std::string_view name = "OPENBLAS_NUM_THREADS=";
    std::vector<std::string> changed;
    for (; *environment; ++environment) {
        if (!std::string_view(*environment).starts_with(name))
            changed.emplace_back(*environment);
        else if (std::atoi(*environment + name.size()) > 0)
            return std::nullopt;
    }
    changed.push_back(std::string(name) + "1");
    return changed;
}

void askForOneBlasThread(char** arguments, char** environment) {
    if (!dlsym(RTLD_DEFAULT, "openblas_set_num_threads")) return;
    std::optional<std::vector<std::string>> changed = withOneBlasThread(environment);
    if (!changed) return;
    std::vector<char*> pointers;
    for (std::string& entry : *changed) pointers.push_back(entry.data());
    pointers.push_back(nullptr);
    execve("/proc/self/exe", arguments, pointers.data());
    // refused: with as many threads as it takes
}

}  // namespace analogon
