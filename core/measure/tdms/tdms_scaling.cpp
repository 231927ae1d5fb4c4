#include "core/measure/tdms/tdms_scaling.hpp"

#include <algorithm>

namespace analogon::tdms {

namespace {

constexpr double rawValues = 4294967295.0;  // as an input source: the values in the file
constexpr int mostScales = 32;
constexpr int mostNumbers = 10000;

const double* number(const Object& object, const std::string& name) {
    const auto found = object.properties.find(name);
    return found == object.properties.end() ? nullptr : std::get_if<double>(&found->second);
}

std::string word(const Object& object, const std::string& name) {
    const auto found = object.properties.find(name);
    const std::string* text = found == object.properties.end() ? nullptr : std::get_if<std::string>(&found->second);
    return text ? *text : std::string();
}

/// NAME_Size, NAME[0] …
bool readNumbers(const Object& object, const std::string& name, std::vector<double>& numbers) {
    const double* size = number(object, name + "_Size");
    if (!size || !(*size >= 1) || *size > mostNumbers) return false;
    for (int i = 0; i < static_cast<int>(*size); ++i) {
        const double* value = number(object, name + "[" + std::to_string(i) + "]");
        if (!value) return false;
        numbers.push_back(*value);
    }
    return true;
}

double lookUp(const std::vector<double>& keys, const std::vector<double>& values, double x) {
    const auto above = std::upper_bound(keys.begin(), keys.end(), x);
    if (above == keys.begin()) return values.front();
    if (above == keys.end()) return values.back();
    const auto i = static_cast<std::size_t>(above - keys.begin());
    return values[i - 1] + (x - keys[i - 1]) * (values[i] - values[i - 1]) / (keys[i] - keys[i - 1]);
}

}  // namespace

Scaling::Scaling(const Object& channel) {
    const double* count = number(channel, "NI_Number_Of_Scales");
    if (!count || !(*count >= 1) || *count > mostScales || word(channel, "NI_Scaling_Status") == "scaled") return;
    double scale = *count - 1;  // the last one gives the quantity; each names the one it takes its values from
    // the raw values of DAQmx stand for a scale of their own
    while (scale != rawValues && !(channel.isDaqMx && scale == channel.scaleId)) {
        Step step;
        const bool isKnown = scale >= 0 && scale < *count && steps_.size() < mostScales;
        const auto index = isKnown ? static_cast<int>(scale) : -1;
        if (!isKnown || !readStep(channel, index, step, scale)) {
            unreadable_ = word(channel, "NI_Scale[" + std::to_string(index) + "]_Scale_Type");
            if (unreadable_.empty()) unreadable_ = "NI_Scale";
            steps_.clear();
            return;
        }
        steps_.insert(steps_.begin(), std::move(step));
    }
    isOn_ = !steps_.empty();
}

bool Scaling::readStep(const Object& channel, int scale, Step& step, double& source) {
    const std::string prefix = "NI_Scale[" + std::to_string(scale) + "]_";
    const std::string type = word(channel, prefix + "Scale_Type");
    const double* from = number(channel, prefix + type + "_Input_Source");
    source = from ? *from : rawValues;
    if (type == "Linear") {
        const double* slope = number(channel, prefix + "Linear_Slope");
        const double* intercept = number(channel, prefix + "Linear_Y_Intercept");
        if (!slope || !intercept) return false;
        step = {Step::Kind::Linear, {*slope, *intercept}, {}};
        return true;
    }
    if (type == "Polynomial") {
        step.kind = Step::Kind::Polynomial;
        return readNumbers(channel, prefix + "Polynomial_Coefficients", step.numbers);
    }
    if (type == "Table") {
        step.kind = Step::Kind::Table;
        return readNumbers(channel, prefix + "Table_Pre_Scaled_Values", step.numbers) &&
               readNumbers(channel, prefix + "Table_Scaled_Values", step.tableValues) &&
               step.numbers.size() == step.tableValues.size() &&
               std::is_sorted(step.numbers.begin(), step.numbers.end());
    }
    return false;
}

void Scaling::apply(std::span<double> values) const {
    for (const Step& step : steps_)
        for (double& x : values) {
            if (step.kind == Step::Kind::Linear) {
                x = x * step.numbers[0] + step.numbers[1];
            } else if (step.kind == Step::Kind::Polynomial) {
                double y = 0;
                for (std::size_t i = step.numbers.size(); i-- > 0;) y = y * x + step.numbers[i];
                x = y;
            } else {
                x = lookUp(step.numbers, step.tableValues, x);
            }
        }
}

}  // namespace analogon::tdms
