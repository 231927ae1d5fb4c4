#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <random>
#include <thread>

namespace analogon {

struct Kills {
    int all{}, firsts{};  // how many; after how many the first version was there
};

/// Lets a child save a first version and a second one in turn and kills it at random moments, as often as
/// ANALOGON_KILLS says (3000 take some minutes). `isFirst`: looks at what is there after each kill, with expectations
/// of its own, and says whether it is the first version.
template <class Save, class IsFirst>
Kills killWhileSaving(unsigned seed, const Save& save, const IsFirst& isFirst) {
    const char* wanted = std::getenv("ANALOGON_KILLS");
    Kills kills{wanted ? std::atoi(wanted) : 40, 0};
    std::mt19937 random(seed);
    unsigned reach = 40000;  // [us], of the moments; further as long as one version alone is found (a busy machine)
    for (int i = 0; i < kills.all && !::testing::Test::HasFatalFailure(); ++i) {
        SCOPED_TRACE(::testing::Message() << "kill " << i);
        const pid_t child = fork();
        if (child == 0)
            for (;;) save();
        std::this_thread::sleep_for(std::chrono::microseconds(500 + random() % reach));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        kills.firsts += isFirst() ? 1 : 0;
        const bool isOneAlone = kills.firsts == 0 || kills.firsts == i + 1;
        if (isOneAlone && i % 4 == 3) reach = std::min(2 * reach, 2'000'000u);
    }
    return kills;
}

}  // namespace analogon
