#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "core/syntax/parser.hpp"

namespace analogon::syntax {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Every span lies within the text and every message can be shown.
void expectSound(const ParseResult& result) {
    const auto size = result.definition.source->text().size();
    for (const Diagnostic& diagnostic : result.diagnostics) {
        EXPECT_FALSE(diagnostic.message.empty());
        EXPECT_FALSE(format(diagnostic).empty());
    }
    for (const ClassPtr& definition : result.definition.classes) {
        EXPECT_LE(definition->span.end, size);
        for (const Component& component : definition->components) {
            EXPECT_LE(component.clauseSpan.begin, component.span.begin);
            EXPECT_LE(component.span.end, component.clauseSpan.end);
        }
    }
}

const char* const sample =
    "within A.B;\n"
    "model M \"text\" extends N(x=1, redeclare P p(q={1,2}));\n"
    "  parameter Real a[3](each min=0, start={1,2,3}) = {i^2 for i in 1:3} if b \"d\" annotation (Dialog());\n"
    "  replaceable C c constrainedby D; type E = enumeration(u, v); import F.*;\n"
    "initial equation x = -1;\nequation\n"
    "  if a then x = if b then 1 else 2; elseif c then y = 2; else connect(a.b, c[1].d); end if;\n"
    "  for i in 1:3 loop der(x[i]) = f(x, k=2)/(1 + i) \"e\" annotation (Line(points={{0,0},{1,1}})); end for;\n"
    "  algorithm x := 1; when y then z = 1; end when;\n"
    "  annotation (Icon(graphics={Text(textString=\"%name\")}), Documentation(info=\"<html>µ</html>\"));\nend M;\n";

TEST(Hostile, EveryPrefixOfATextIsRead) {
    const std::string text = sample;
    for (std::size_t length = 0; length <= text.size(); ++length) {
        expectSound(parse(std::make_shared<const Source>("m.mo", text.substr(0, length))));
    }
}

TEST(Hostile, TextsWithAWordTakenOutOrDoubledAreRead) {
    const std::string text = sample;
    std::mt19937 random(5);
    for (int round = 0; round < 3000; ++round) {
        std::string changed = text;
        for (int change = 0; change < 1 + round % 4; ++change) {
            const std::size_t at = random() % changed.size();
            const std::size_t length = std::min<std::size_t>(random() % 12, changed.size() - at);
            const std::string piece = changed.substr(random() % (changed.size() - 8), random() % 8);
            switch (random() % 3) {
                case 0:
                    changed.erase(at, length);
                    break;
                case 1:
                    changed.insert(at, piece);
                    break;
                default:
                    changed.replace(at, length, piece);
                    break;
            }
        }
        expectSound(parse(std::make_shared<const Source>("m.mo", changed)));
    }
}

TEST(Hostile, TheCollectionIsAcceptedOrRefusedAsListed) {
    const fs::path folder = ANALOGON_ROOT "/../shared/verification/hostile";
    if (!fs::exists(folder / "MANIFEST.csv")) GTEST_SKIP() << "the collection of hostile files is not there";
    // What parsing alone must refuse; everything else is for later stages.
    const std::map<std::string, std::string> refused{
        {"open_string.mo", "the string is not closed"},
        {"dup.mo", "\"x\" is declared twice in \"A\""},
        {"binary.mo", "is not valid UTF-8"},
    };
    for (const auto& entry : fs::directory_iterator(folder / "model")) {
        const std::string name = entry.path().filename().string();
        const ParseResult result = parse(std::make_shared<const Source>(name, contentOf(entry.path())));
        expectSound(result);
        const auto refusal = refused.find(name);
        if (refusal == refused.end()) {
            EXPECT_TRUE(result.diagnostics.empty()) << format(result.diagnostics);
        } else {
            ASSERT_EQ(result.diagnostics.size(), 1u) << format(result.diagnostics);
            EXPECT_NE(result.diagnostics[0].message.find(refusal->second), std::string::npos)
                << result.diagnostics[0].message;
        }
    }
}

TEST(Hostile, TypicalComposedModelsAreAccepted) {
    const fs::path folder = ANALOGON_ROOT "/../shared/cases";
    if (!fs::exists(folder)) GTEST_SKIP() << "the collection of studies is not there";
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (!fs::exists(entry.path() / "model.mo")) continue;
        const auto result =
            parse(std::make_shared<const Source>(entry.path().string(), contentOf(entry.path() / "model.mo")));
        EXPECT_TRUE(result.diagnostics.empty()) << format(result.diagnostics);
        EXPECT_EQ(result.definition.classes.size(), 1u);
    }
}

}  // namespace
}  // namespace analogon::syntax
