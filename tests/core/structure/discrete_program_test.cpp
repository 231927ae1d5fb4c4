#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <random>

#include "core/structure/hybrid.hpp"

namespace analogon {
namespace {

/// Sums, products, quotients, relations and choices of what stands before, over four slots, two readings and the time.
DiscreteProgram randomProgram(std::mt19937& random, int count) {
    DiscreteProgram program;
    const auto pick = [&](int below) { return std::uniform_int_distribution<int>(0, below - 1)(random); };
    for (int i = 0; i < count; ++i) {
        DiscreteProgram::Step step;
        if (i < 4) {
            step.operation = Operation::Variable;
            step.slot = i;
        } else if (i < 6) {
            step.operation = Operation::Variable;
            step.reading = i - 4;
        } else if (i < 8) {
            step.operation = i == 6 ? Operation::Time : Operation::Constant;
            step.value = 0.5;
        } else {
            constexpr Operation operations[] = {Operation::Add,  Operation::Multiply, Operation::Divide,
                                                Operation::Less, Operation::If,       Operation::Floor};
            step.operation = operations[pick(6)];
            step.a = pick(i);
            if (step.operation != Operation::Floor) step.b = pick(i);
            if (step.operation == Operation::If) step.c = pick(i);
        }
        program.steps.push_back(step);
    }
    program.findReaders();
    return program;
}

bool areSame(const std::vector<double>& a, const std::vector<double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
}

TEST(DiscreteProgram, UpdatedIsWhatAWholeRunGives) {
    std::mt19937 random(5);
    const DiscreteProgram program = randomProgram(random, 300);
    std::vector<double> slots{1, 0, 2, -3}, readings{0.25, 4}, whole, values;
    std::vector<char> room;
    double time = 0;
    constexpr double numbers[] = {0, 1, -2, 0.125, 1e300, std::numeric_limits<double>::quiet_NaN(), -0.0};
    for (int k = 0; k < 500; ++k) {
        const auto number = numbers[random() % std::size(numbers)];
        switch (random() % 4) {
            case 0:
                slots[random() % slots.size()] = number;
                break;
            case 1:
                readings[random() % readings.size()] = number;
                break;
            case 2:
                time += 0.5;
                break;
            default:
                break;  // nothing has changed
        }
        program.run(slots, readings, time, whole);
        program.update(slots, readings, time, values, room);
        ASSERT_TRUE(areSame(whole, values)) << k;
    }
}

TEST(DiscreteProgram, WhatDependsOnNothingNewIsNotWorkedOutAgain) {
    std::mt19937 random(7);
    const DiscreteProgram program = randomProgram(random, 100);
    std::vector<double> slots{1, 0, 2, -3}, readings{0.25, 4}, values;
    std::vector<char> room;
    program.update(slots, readings, 0, values, room);
    values[99] = 12345;  // a trace of whether it was touched
    program.update(slots, readings, 0, values, room);
    EXPECT_EQ(values[99], 12345);
}

}  // namespace
}  // namespace analogon
