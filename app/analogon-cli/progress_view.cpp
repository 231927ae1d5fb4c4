#include "app/analogon-cli/progress_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/visible.hpp"

namespace analogon::cli {
namespace {

/// On one line and in ASCII, whatever bytes a file put into it: a terminal obeys some that stand above 127, too.
std::string line(const nlohmann::ordered_json& json) {
    return json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

ProgressView::ProgressView(ProgressKind kind, std::ostream& stream, bool isTerminal) : kind_(kind), stream_(stream) {
    if (kind_ == ProgressKind::Automatic) kind_ = isTerminal ? ProgressKind::Bar : ProgressKind::None;
}

ProgressView::~ProgressView() { clear(); }

Progress::Sink ProgressView::sink() {
    if (kind_ == ProgressKind::None) return {};
    return [this](const Progress::Report& report) { show(report); };
}

void ProgressView::show(const Progress::Report& report) {
    const std::lock_guard lock(mutex_);
    // The fits of single candidates, side by side, say nothing of how far the search is: a bar would jump about.
    isSearching_ = isSearching_ || (report.stage != "fit" && report.stage != "simulate");
    if (kind_ == ProgressKind::Bar && isSearching_ && report.stage == "fit") return;
    const auto now = std::chrono::steady_clock::now();
    // A new stage is always shown; within one, ten times a second is enough for anybody.
    if (report.stage == lastStage_ && now - lastShown_ < std::chrono::milliseconds(100)) return;
    lastShown_ = now;
    lastStage_ = report.stage;
    if (kind_ == ProgressKind::Json)
        stream_ << progressJson(report) << std::endl;
    else
        showBar(report);
}

void ProgressView::showBar(const Progress::Report& report) {
    constexpr int width = 24, textWidth = 52;
    std::string bar;
    if (report.fraction >= 0) {
        const int full = static_cast<int>(std::lround(std::clamp(report.fraction, 0.0, 1.0) * width));
        for (int i = 0; i < width; ++i) bar += i < full ? "━" : "─";
        bar += fmt::format(" {:3.0f} %", 100 * std::clamp(report.fraction, 0.0, 1.0));
    }
    const std::string& detail = report.detail;
    std::string text = detail.empty() ? report.stage : report.stage + ": " + visibleName(detail, textWidth);
    if (report.error >= 0) text += fmt::format("  (error {:.3g} %)", report.error);
    if (text.size() > textWidth) text = shortened(text, textWidth - 2);
    stream_ << "\r\033[K" << bar << "  " << text << std::flush;
    hasBar_ = true;
}

void ProgressView::clear() {
    const std::lock_guard lock(mutex_);
    if (hasBar_) stream_ << "\r\033[K" << std::flush;
    hasBar_ = false;
}

void ProgressView::note(const Text& remark) {
    clear();
    if (kind_ != ProgressKind::Json)
        stream_ << "note: " << visible(remark.english()) << std::endl;
    else
        stream_ << noteJson(remark) << std::endl;
}

std::string progressJson(const Progress::Report& report) {
    nlohmann::ordered_json json{{"stage", report.stage}};
    if (!report.detail.empty()) json["detail"] = report.detail.english();
    if (report.fraction >= 0) json["fraction"] = report.fraction;
    if (report.error >= 0) json["error_percent"] = report.error;
    return line(json);
}

std::string noteJson(const Text& remark) {
    nlohmann::ordered_json json{{"note", remark.english()}};
    if (!remark.pattern().empty()) {
        json["pattern"] = remark.pattern();
        json["arguments"] = nlohmann::ordered_json::array();
        for (const Text& argument : remark.arguments()) json["arguments"].push_back(argument.english());
    }
    return line(json);
}

}  // namespace analogon::cli
