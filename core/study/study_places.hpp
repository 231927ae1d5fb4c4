#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/study/json_places.hpp"
#include "core/study/study.hpp"

namespace analogon {

/// Messages that point into study.json as far as it is known.
class StudyPlaces {
public:
    explicit StudyPlaces(const Study& study);

    /// `pointer`: of the value that is meant (core/study/json_places.hpp).
    Diagnostic fault(const std::string& pointer, Text message, Text hint = {}) const;
    Diagnostic remark(const std::string& pointer, Text message, Text hint = {}) const;

private:
    std::optional<JsonPlaces> places_;
    std::string file_;
};

/// "Did you mean 'rotor.J'?", or which names there are; `none`: what to say where there are none.
Text meantOrAvailable(const std::string& name, const std::vector<std::string>& names, const Text& none);

/// The first of many names, separated by commas.
std::string joined(const std::vector<std::string>& names);

}  // namespace analogon
