#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/study/domain_part.hpp"
#include "core/study/study.hpp"

namespace analogon {

struct GenerateRequest {
    std::vector<std::string> domains;  // "electric-thermal", … in the order of the chain
    /// One: its first part is fitted, the rest validates. Several: the last one validates.
    std::vector<std::shared_ptr<const Table>> recordings;
    std::string className{"Component"};
};

struct GeneratedStudy {
    Study study;
    std::vector<Text> assumptions;  // in plain words, one each
};

/// Composes a first model from a classification: the basic class of each domain, joined through connectors that fit,
/// with sources, loads and sensors for what stays open and is measured; columns are told apart by unit and name,
/// start values and bounds come from the data. Faults: unknown domain, parts that no connector joins, no measured
/// column that the model could be compared with.
Outcome<GeneratedStudy> generateStudy(const Library& library, const GenerateRequest& request);

}  // namespace analogon
