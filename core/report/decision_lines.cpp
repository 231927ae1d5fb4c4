#include "core/report/decision_lines.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/file_fault.hpp"

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
    fs::path beside = file;
    beside += ".writing";
    std::ofstream stream(beside, std::ios::binary);
    for (std::size_t i = 0; i < decisions.size(); ++i) stream << decisionLine(decisions[i], i) << '\n';
    stream.close();
    std::error_code failed;
    if (!stream) failed = std::error_code(errno, std::generic_category());
    if (!failed) fs::rename(beside, file, failed);
    if (!failed) return Done{};
    const Diagnostic fault = cannotWrite(file, failed);
    fs::remove(beside, failed);
    return fault;
}

}  // namespace analogon
