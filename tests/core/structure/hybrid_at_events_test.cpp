#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>

#include "core/flat/flat_model.hpp"
#include "core/structure/hybrid.hpp"

/// Which relations are watched for, and which discrete quantities the motion between events depends on.
namespace analogon {
namespace {

/// The model M with these equations, over x' = 1 and what is declared.
HybridModel hybridOf(const std::string& declarations, const std::string& equations) {
    const auto source = std::make_shared<const Source>(
        "m.mo", "model M Real x(start = 0, fixed = true); " + declarations + " equation " + equations + " end M;");
    const auto library = Library().withSource(source);
    EXPECT_TRUE(library) << format(library.diagnostics());
    const Outcome<FlatModel> flat = flatten(*library, "M");
    EXPECT_TRUE(flat) << format(flat.diagnostics());
    Outcome<HybridModel> hybrid = partition(*flat);
    EXPECT_TRUE(hybrid) << format(hybrid.diagnostics());
    return std::move(*hybrid);
}

std::multiset<std::string> watched(const HybridModel& model) {
    std::multiset<std::string> result;
    for (const HybridModel::Relation& r : model.relations)
        if (r.isWatched) result.insert(r.text);
    for (const HybridModel::Whole& w : model.wholes)
        if (w.isWatched) result.insert("floor");
    return result;
}

using Names = std::multiset<std::string>;

Names watchedIn(const std::string& declarations, const std::string& equations) {
    return watched(hybridOf(declarations, "der(x) = 1; " + equations));
}

TEST(HybridAtEvents, WhatAWhenWorksOutRaisesNoEventsItself) {
    const std::string n = "discrete Real n(start = 0, fixed = true);";
    EXPECT_EQ(watchedIn(n, "when sample(0, 0.1) then n = floor(3*x) + (if x > 2 then 1 else sign(x)); end when;"),
              Names{});
    EXPECT_EQ(watchedIn(n, "when x > 1 then n = mod(x, 0.5) + floor(time/0.1); end when;"), Names{"x > 1"});
    EXPECT_EQ(watchedIn(n, "when x > 1 then n = 1; elsewhen x > 2 then n = div(x, 3); end when;"),
              (Names{"x > 1", "x > 2"}));
    EXPECT_EQ(watchedIn(n, "when {initial(), sample(0, 1)} then if x < 3 then n = 4; else n = 5; end if; end when;"),
              Names{});
    EXPECT_EQ(watchedIn("", "when sample(0, 0.1) then reinit(x, if x > 5 then 0 else x); end when;"), Names{});
    EXPECT_EQ(watchedIn(n, "when sample(0, 0.1) then n = 1; assert(x < 7, \"far\"); end when;"), Names{});
    EXPECT_EQ(watchedIn("Boolean b, late(start = false, fixed = true);",
                        "b = x > 1; late = if edge(b) then x > 2 elseif change(b) then x > 3 else pre(late);"),
              Names{"x > 1"});
}

TEST(HybridAtEvents, WhatIsAskedForElsewhereTooIsWatched) {
    const std::string n = "discrete Real n(start = 0, fixed = true);";
    EXPECT_EQ(watchedIn(n + "Real y;",
                        "y = if x > 2 then 1 else 0; when sample(0, 1) then n = if x > 2 then 1 else 2; "
                        "end when;"),
              Names{"x > 2"});
    EXPECT_EQ(watchedIn(n + "Real y;", "when sample(0, 1) then n = floor(x); end when; y = floor(x);"), Names{"floor"});
    EXPECT_EQ(watchedIn(n, "assert(x < 7, \"far\"); when sample(0, 1) then n = 1; end when;"), Names{"x < 7"});
    // a Boolean that stays true for a time, and one that only was different a time ago
    EXPECT_EQ(watchedIn("Boolean b; Integer k;", "b = x > 1; k = if b then integer(x) else 0;"),
              (Names{"floor", "x > 1"}));
    EXPECT_EQ(
        watchedIn("Boolean b, c; Integer k;", "b = x > 1; c = x > 2; k = if b and not pre(c) then integer(x) else 0;"),
        (Names{"floor", "x > 1", "x > 2"}));
}

Names read(const HybridModel& model) {
    Names result;
    for (std::size_t s = 0; s < model.slots.size(); ++s)
        if (model.isRead.at(s)) result.insert(model.slots[s]);
    return result;
}

TEST(HybridAtEvents, OnlyWhatTheStatesFollowFromIsRead) {
    const std::string d = "discrete Real n(start = 0, fixed = true); Real y, z;";
    const std::string sampled = "when sample(0, 0.1) then n = x; end when; ";
    EXPECT_EQ(read(hybridOf(d, sampled + "der(x) = 1; y = n; z = 2*y + x;")), Names{});
    EXPECT_EQ(read(hybridOf(d, sampled + "der(x) = z; y = n; z = 2*y + x;")), Names{"n"});
    EXPECT_EQ(read(hybridOf(d, sampled + "der(x) = y; y + z = n; y - z = x;")), Names{"n"});
    EXPECT_EQ(read(hybridOf(d, sampled + "der(x) = 1; y = 1; z = if x > pre(n) then 1 else 0;")), Names{"pre(n)"});
    EXPECT_EQ(read(hybridOf(d, sampled + "der(x) = if time > 2 then 1 else 2; y = 1; z = n;")).size(), 1u);
}

}  // namespace
}  // namespace analogon
