#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/flat/flat_model.hpp"
#include "core/study/study_places.hpp"

namespace analogon {

/// What a study says of the parameters of its model: which are fitted from where and within which bounds, which are
/// set. Every fault and every remark is added to what is said of the study.
class ParameterReader {
public:
    ParameterReader(const Study& study, const StudyPlaces& places, const FlatModel& model, Diagnostics& said);

    /// Those that are fitted, and the names and values of those that are set.
    void read(std::vector<FitParameter>& fitted, std::vector<std::pair<std::string, double>>& set);

    /// The variable when it is a parameter that may be set and fitted; else null, and why not is said.
    const FlatVariable* settable(const std::string& name, const std::string& pointer);
    /// The same for what may have a start value in one experiment: a parameter, and any variable that begins somewhere.
    const FlatVariable* startable(const std::string& name, const std::string& pointer);
    /// Whether a value is within the range of the model's declaration; where it is not, that is said.
    bool isWithin(const FlatVariable& variable, double value, const std::string& pointer);

private:
    void fault(const std::string& pointer, Text message, Text hint = {});
    const FlatVariable* find(const std::string& name, const std::string& pointer, bool isStart);
    void readFitted(const std::string& name, const StudyParameter& parameter, const FlatVariable& variable,
                    const std::string& pointer, std::vector<FitParameter>& fitted);
    void tellWhatIsPassedOver(const FlatVariable& variable, const std::string& pointer);
    void setBounds(const StudyParameter& parameter, const FlatVariable& variable, const std::string& pointer,
                   FitParameter& fitted);
    void setDefaultBounds(const FlatVariable& variable, double start, FitParameter& fitted);
    void tellDefaultBounds();
    void checkClock(const std::string& output, const std::string& pointer);

    const Study& study_;
    const StudyPlaces& places_;
    const FlatModel& model_;
    Diagnostics& said_;
    std::vector<std::string> unbounded_;           // that are fitted and have no bounds of their own
    std::vector<std::string> names_, startNames_;  // what may be meant by a name that is not known
};

/// Parameters whose values, as the model's text and the study have them, lie outside the ranges of their declarations.
/// Those that the study itself gives are left to the reader.
Diagnostics outsideRange(const FlatModel& model, const Study& study);

}  // namespace analogon
