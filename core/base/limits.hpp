#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/outcome.hpp"

/// What is refused before any work is done on it: each of these is far beyond what an engineer writes or records, and
/// near what would take a machine for minutes or all of its memory. One table for all stages; whoever reaches a limit
/// says so in one sentence, with the place and with what to do instead.
namespace analogon::limits {

// A text of JSON (study.json, the history of runs).
inline constexpr std::size_t jsonDepth = 100;  // objects and lists within each other
inline constexpr std::size_t jsonBytes = std::size_t{64} << 20;
inline constexpr std::size_t jsonValues = 1'000'000;  // members and elements
inline constexpr std::size_t jsonPaths = std::size_t{256}
                                         << 20;  // bytes of the names around each value, of all together

// Model texts. How deep they nest is limited where they are read (core/syntax/cursor.cpp), how deep classes are built
// of each other, and of how many scalars and equations a model is, where it is flattened (core/flat/instantiator.hpp).
inline constexpr std::size_t modelBytes = std::size_t{32} << 20;  // of one file

// Expressions of a flat model and of what is derived from it, 32 bytes and a place in an index each.
inline constexpr std::size_t expressions = 4'000'000;

// Unknowns of one algebraic loop, when those that follow from others of it are taken out: each evaluation of the model
// solves for all of them at once, at a cost that grows as their third power; several times where it is nonlinear.
inline constexpr std::size_t loopUnknowns = 500;
inline constexpr std::size_t nonlinearUnknowns = 200;
// What all equations together refer to, each with all that it shares with others: "sum(v)" in n equations over n
// variables is n*n.
inline constexpr std::size_t references = 20'000'000;

// Measurements.
inline constexpr std::size_t columns = 100'000;
inline constexpr std::size_t columnName = 4'096;  // bytes
inline constexpr std::size_t rows = 1'000'000'000;
inline constexpr double largestSize = 1e50;    // of the values of a signal: a fit squares them, and what they move
inline constexpr double smallestSize = 1e-50;  // of the largest value of a signal that is not 0

// What a message tells.
inline constexpr std::size_t quotedBytes = 100;  // of a name or cell of a file
inline constexpr std::size_t shownFaults = 50;   // of one kind of file

/// The memory that the machine, or the container around the program, has [byte]; what the environment variable
/// ANALOGON_MEMORY says [MiB] where it is set.
std::uint64_t memory();

/// Whether a stage may take so many bytes at once: no more than three quarters of memory(). Where not, a fault that
/// says how much it is and of what, and the remedy.
Outcome<Done> checkMemory(const Text& what, double bytes, const Text& remedy);

// What the stages whose size a user's files decide take, each asked before it begins.

/// A measurement of so many rows and columns beside the text it is read from.
Outcome<Done> checkTable(double rowCount, std::size_t columnCount, double cells, double textBytes);
/// Inputs, and measured, simulated and remaining outputs, over the samples of all recordings.
Outcome<Done> checkTraces(double samples, std::size_t inputs, std::size_t outputs);
/// The derivative of each measured value with respect to each fitted parameter, and the residuals.
Outcome<Done> checkSlopes(double values, std::size_t parameters);
/// What helps where a model has too many expressions.
Text shorterEquations();
/// The expressions of a model, for which room is made; `nodeBytes` for each.
Outcome<Done> checkExpressions(std::size_t count, std::size_t nodeBytes);

}  // namespace analogon::limits
