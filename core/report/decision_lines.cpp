#include "core/report/decision_lines.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/whole_file.hpp"

namespace analogon {

namespace fs = std::filesystem;

std::string decisionLine(const Decision& decision, std::size_t number) {
    nlohmann::ordered_json json{{"number", number},
                                {"step", decision.step},
                                {"key", decision.key},
                                {"path", decision.path},
                                {"round", decision.round}};
    nlohmann::ordered_json figures = nlohmann::ordered_json::object();
    for (const auto& [name, value] : decision.figures)
        if (std::isfinite(value)) figures[name] = std::stod(fmt::format("{:.6g}", value));
    if (!figures.empty()) json["figures"] = std::move(figures);
    if (!decision.verdict.empty()) json["verdict"] = decision.verdict;
    if (!decision.reason.empty()) json["reason"] = decision.reason;
    return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

Outcome<Done> writeDecisions(const std::vector<Decision>& decisions, const fs::path& file) {
    std::string lines;
    for (std::size_t i = 0; i < decisions.size(); ++i) lines += decisionLine(decisions[i], i) + '\n';
    return writeWhole(file, lines);
}

}  // namespace analogon
