#include "core/effect/catalogue/likeliest.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

struct Claim {
    double explained;
};

std::vector<double> kept(std::vector<Claim> likely) {
    keepLikeliest(likely);
    std::vector<double> explained;
    for (const Claim& each : likely) explained.push_back(each.explained);
    return explained;
}

TEST(Likeliest, AreWhatExplainsThreeTenthsOfTheFirst) {
    EXPECT_EQ(kept({{100}, {31}, {29}}), (std::vector<double>{100, 31}));
    EXPECT_TRUE(kept({}).empty());
}

TEST(Likeliest, AreFourAtMost) {
    EXPECT_EQ(kept({{100}, {99}, {98}, {97}, {96}}), (std::vector<double>{100, 99, 98, 97}));
}

TEST(TakeBest, TakesWhatExplainsMoreThanWhatIsThere) {
    const std::vector<Claim> likely{{1}, {3}, {2}};
    const auto doubled = [](const Claim& each) -> std::optional<Claim> {
        if (each.explained == 3) return std::nullopt;  // it cannot be fitted
        return Claim{2 * each.explained};
    };
    for (const int threads : {1, 2}) {
        std::optional<Claim> best;
        takeBest(likely, best, threads, {}, doubled);
        ASSERT_TRUE(best);
        EXPECT_EQ(best->explained, 4);
        std::optional<Claim> better = Claim{5};
        takeBest(likely, better, threads, {}, doubled);
        EXPECT_EQ(better->explained, 5);
    }
}

TEST(TakeBest, FitsNothingOnceItIsStopped) {
    std::stop_source stop;
    stop.request_stop();
    std::optional<Claim> best;
    takeBest(std::vector<Claim>{{1}}, best, 1, Progress(stop.get_token(), [](const Progress::Report&) {}),
             [](const Claim& each) { return std::optional(each); });
    EXPECT_FALSE(best);
}

}  // namespace
}  // namespace analogon
