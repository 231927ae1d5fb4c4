#include "core/base/json_limits.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

Outcome<Done> looked(std::string text) { return checkJsonLimits(Source("study.json", std::move(text))); }

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

std::string messageOf(std::string text) {
    const Outcome<Done> found = looked(std::move(text));
    return found ? std::string() : format(found.diagnostics());
}

TEST(JsonLimits, LeaveWhatAStudyHolds) {
    EXPECT_TRUE(looked("{\"a\": [1, {\"b\": \"[[[[{{{{\\\"[[\"}]}"));
    EXPECT_TRUE(looked(nested(limits::jsonDepth)));
    EXPECT_TRUE(looked(""));
    EXPECT_TRUE(looked("]]]]"));  // what is wrong with it the parser tells
}

TEST(JsonLimits, EndTheDepthWithItsPlace) {
    const std::string message = messageOf("{\"a\":\n" + nested(limits::jsonDepth));
    EXPECT_NE(message.find("study.json:2:100: error: objects and lists stand within each other more than 100 deep"),
              std::string::npos)
        << message;
    EXPECT_FALSE(messageOf(std::string(1'000'000, '[')).empty());
    EXPECT_FALSE(messageOf(std::string(1'000'000, '{')).empty());
}

TEST(JsonLimits, EndTheNumberOfValuesAndTheSize) {
    std::string list = "[0";
    for (std::size_t i = 0; i < limits::jsonValues; ++i) list += ",0";
    EXPECT_NE(messageOf(list + "]").find("more than 1000000 values"), std::string::npos);
    EXPECT_NE(messageOf(std::string(limits::jsonBytes + 1, ' ')).find("MB"), std::string::npos);
}

/// Each value is known by the names that lead to it: long ones around many take memory as their product.
TEST(JsonLimits, EndLongNamesAroundManyValues) {
    std::string text;
    for (int i = 0; i < 50; ++i) text += "{\"" + std::string(4000, 'n') + "\": ";
    text += "[0";
    for (int i = 0; i < 10000; ++i) text += ",0";
    EXPECT_NE(messageOf(text).find("too long and too many"), std::string::npos);
}

}  // namespace
}  // namespace analogon
