// A recording that was interrupted for weeks, and went on from rest.
#include <gtest/gtest.h>

#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "core/study/run.hpp"
#include "core/study/study.hpp"

namespace analogon {
namespace {

Study heater() {
    Outcome<Study> study = readStudy(ANALOGON_ROOT "/examples/lambda-sensor-heating");
    EXPECT_TRUE(study) << format(study.diagnostics());
    return study ? std::move(*study) : Study{};
}

/// Its recording twice, one after the other, and nothing between.
Study withGap(Study study, double gap) {
    Table table = *study.tables.at("train.csv");
    const std::size_t rows = table.rows();
    for (Column& column : table.columns) {
        const bool isTime = column.name == "t";
        for (std::size_t k = 0; k < rows; ++k)
            column.values.push_back(column.values[k] + (isTime ? column.values[rows - 1] + gap : 0));
    }
    for (std::size_t k = 0; k < rows; ++k) table.lines.push_back(table.lines.back() + 1);
    study.tables["train.csv"] = std::make_shared<const Table>(std::move(table));
    return study;
}

struct Search {
    std::string effects;
    FindingKind kind{};
    double seconds{};
    std::vector<FitEstimate> parameters{};
};

Search searched(const Study& study) {
    const std::clock_t begin = std::clock();
    const Outcome<RunResult> result = runDiscover(study, {});
    Search search;
    EXPECT_TRUE(result) << format(result.diagnostics());
    if (!result) return search;
    for (const AddedEffect& effect : result->finding.effects) search.effects += effect.className + " ";
    search.kind = result->finding.kind;
    search.parameters = result->finding.final.parameters;
    search.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return search;
}

TEST(DiscoveryAcrossAGap, FindsTheSameInAboutTheSameTime) {
    const Search plain = searched(heater()), gap = searched(withGap(heater(), 5e6));
    EXPECT_NE(plain.effects, "");
    EXPECT_EQ(gap.effects, plain.effects);
    EXPECT_EQ(gap.kind, plain.kind);
    ASSERT_EQ(gap.parameters.size(), plain.parameters.size());
    for (std::size_t i = 0; i < plain.parameters.size(); ++i)
        EXPECT_NEAR(gap.parameters[i].value, plain.parameters[i].value, 0.05 * plain.parameters[i].value)
            << plain.parameters[i].name;
    EXPECT_LT(gap.seconds, 4 * plain.seconds) << "of twice as many samples";
}

}  // namespace
}  // namespace analogon
