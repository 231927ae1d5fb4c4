#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/library/library.hpp"

/// A test bench for library blocks: a model as text goes through the whole way (parse, flatten, analyse, compile,
/// simulate with the adaptive reference engine) and its outputs come back.
namespace analogon::bench {

/// An input of the bench as a function of time; between the samples it runs linearly.
using Signal = std::function<double(double time)>;
Signal constant(double value);

struct Recording {
    std::vector<double> time;
    std::vector<std::string> names;
    std::vector<std::vector<double>> values;  // per output, per sample
    std::string fault;                        // why there is no recording

    const std::vector<double>& operator[](const std::string& output) const;
    double last(const std::string& output) const { return (*this)[output].back(); }
};

/// The built-in library with the text of a model in it.
Outcome<Library> libraryWith(const std::string& text);

/// Simulates `model M … end M;` given by its declarations and equations. Samples run from 0 to `duration`.
/// Inputs are those declared in the text, in order.
Recording run(const std::string& body, double duration, int samples = 101, const std::vector<Signal>& inputs = {});

/// Largest difference between an output and a function of time.
double worst(const Recording& recording, const std::string& output, const Signal& expected);

}  // namespace analogon::bench
