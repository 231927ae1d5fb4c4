#include "core/study/start_guess.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/median.hpp"

namespace analogon {

namespace {

constexpr double measuredFactor = 30;  // bounds of a value that was read from data
constexpr double usualFactor = 1000;   // and of one that was not

StartGuess around(double value, Text reason) {
    const double factor = reason.empty() ? usualFactor : measuredFactor;
    return {value, value / factor, value * factor, std::move(reason)};
}

double largest(const std::vector<double>& values) {
    double out = 0;
    for (const double value : values) out = std::max(out, std::abs(value));
    return out;
}

double quantile(std::vector<double> values, double part) {
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Voltage over current where both are at least a tenth of their largest and of one sign.
std::vector<double> resistances(const GuessData& data) {
    std::vector<double> out;
    const double v = largest(data.voltage), i = largest(data.current);
    for (std::size_t k = 0; k < std::min(data.voltage.size(), data.current.size()); ++k)
        if (std::abs(data.voltage[k]) > 0.1 * v && std::abs(data.current[k]) > 0.1 * i &&
            data.voltage[k] * data.current[k] > 0)
            out.push_back(data.voltage[k] / data.current[k]);
    return out;
}

/// f(k) over the samples at which the shaft turns with at least half its highest speed.
template <class Value>
std::vector<double> whereFast(const GuessData& data, const Value& value) {
    std::vector<double> out;
    const double fastest = largest(data.speed);
    for (std::size_t k = 0; k < data.speed.size(); ++k)
        if (std::abs(data.speed[k]) > 0.5 * fastest) out.push_back(value(k));
    return out;
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

}  // namespace

double changeTime(const std::vector<double>& time, const std::vector<double>& signal) {
    const std::size_t count = std::min(time.size(), signal.size());
    if (count < 10) return 1;
    const double average = mean(signal);
    double spread = 0;
    for (const double value : signal) spread += (value - average) * (value - average);
    spread /= static_cast<double>(count);
    // The lag at which two samples differ by half of what unrelated ones would (2 spread) is about the time wanted;
    // noise adds to every difference alike and hardly moves it.
    for (std::size_t lag = 1; lag < count / 2; lag += std::max<std::size_t>(1, lag / 8)) {
        double difference = 0;
        for (std::size_t k = 0; k + lag < count; ++k)
            difference += (signal[k + lag] - signal[k]) * (signal[k + lag] - signal[k]);
        if (difference / static_cast<double>(count - lag) > spread) return time[lag] - time[0];
    }
    return 0.5 * (time[count - 1] - time[0]);
}

StartGuess guessResistance(const GuessData& data) {
    const std::vector<double> all = resistances(data);
    return all.empty() ? around(1, "") : around(median(all), phrase("voltage over current"));
}

MotorGuess guessMotor(const GuessData& data) {
    constexpr double usualSpeed = 300;  // [rad/s] at the highest voltage
    const double highest = std::max(largest(data.voltage), 1e-6);
    MotorGuess guess{around(1, ""), around(highest / usualSpeed, "")};
    if (const std::vector<double> all = resistances(data); !all.empty())
        guess.resistance = around(quantile(all, 0.1), phrase("voltage over current where the current is high"));
    if (data.voltage.empty() || data.current.empty() || data.speed.empty()) return guess;
    double ii = 0, iw = 0, ww = 0, iv = 0, wv = 0;
    for (std::size_t n = 0; n < data.speed.size(); ++n) {
        const double v = data.voltage[n], i = data.current[n], w = data.speed[n];
        ii += i * i, iw += i * w, ww += w * w, iv += i * v, wv += w * v;
    }
    const double determinant = ii * ww - iw * iw;
    const double r = (iv * ww - wv * iw) / determinant, k = (wv * ii - iv * iw) / determinant;
    if (r > 0 && k > 0 && std::isfinite(r + k))
        guess = {around(r, phrase("v = R*i + k*w over the recording")),
                 around(k, phrase("v = R*i + k*w over the recording"))};
    return guess;
}

StartGuess guessInertia(const GuessData& data, double resistance, double torqueConstant) {
    const std::vector<double>& signal = data.speed.empty() ? data.current : data.speed;
    if (signal.empty()) return around(1e-4, "");
    StartGuess guess = around(changeTime(data.time, signal) * torqueConstant * torqueConstant / resistance, "");
    guess.reason = phrase("how fast it follows");
    return guess;
}

StartGuess guessQuadraticLoad(const GuessData& data, double torqueConstant) {
    if (data.speed.empty() || data.current.empty()) return around(1e-6, "");
    const double k = median(whereFast(data, [&](std::size_t n) {
        return torqueConstant * data.current[n] / (data.speed[n] * std::abs(data.speed[n]));
    }));
    if (!(k > 0)) return around(1e-6, "");
    StartGuess guess = around(k, "");  // friction may take most of the torque: wide bounds
    guess.reason = phrase("torque over the square of the speed");
    return guess;
}

StartGuess guessFriction(const GuessData& data, double torqueConstant) {
    if (data.speed.empty() || data.current.empty()) return around(1e-4, "");
    const double b =
        median(whereFast(data, [&](std::size_t n) { return torqueConstant * data.current[n] / data.speed[n]; }));
    if (!(b > 0)) return around(1e-4, "");
    StartGuess guess = around(b, "");
    guess.reason = phrase("torque over speed");
    return guess;
}

StartGuess guessConductance(const GuessData& data) {
    constexpr double usualDifference = 300;  // [K] of a heated body whose temperature is not measured
    std::vector<double> power;
    for (std::size_t k = 0; k < std::min(data.voltage.size(), data.current.size()); ++k)
        power.push_back(data.voltage[k] * data.current[k]);
    const double heat = mean(power);
    if (!(heat > 0)) return around(0.1, "");
    const double warmer = mean(data.bodyTemperature) - mean(data.surroundingTemperature);
    if (!data.bodyTemperature.empty() && !data.surroundingTemperature.empty() && warmer > 0.1)
        return around(heat / warmer, phrase("power over temperature difference"));
    return around(heat / usualDifference, "");
}

StartGuess guessHeatCapacity(const GuessData& data, double conductance) {
    const std::vector<double>& signal = data.bodyTemperature.empty() ? data.current : data.bodyTemperature;
    const double seconds = signal.empty() ? 10 : changeTime(data.time, signal);
    StartGuess guess = around(conductance * seconds, "");
    if (!signal.empty()) guess.reason = phrase("how fast it follows");
    return guess;
}

}  // namespace analogon
