#include <algorithm>
#include <cmath>

#include "ui/document/composer.hpp"
#include "ui/document/document.hpp"
#include "ui/route/route.hpp"

/// Several blocks of the diagram lined up.
namespace analogon::ui {

bool Composer::align(const std::vector<std::string>& blocks, Edge edge) {
    if (!isReady() || blocks.size() < 2) return false;
    const Block* first = document_.diagram().find(blocks.front());
    if (!first) return false;
    const auto place0 = [edge](const std::pair<Point, Point>& box) {
        switch (edge) {
            case Edge::Left:
                return box.first.x;
            case Edge::Right:
                return box.second.x;
            case Edge::Top:
                return box.second.y;
            case Edge::Bottom:
                return box.first.y;
            case Edge::Middle:
                return (box.first.y + box.second.y) / 2;
            case Edge::Centre:
                break;
        }
        return (box.first.x + box.second.x) / 2;
    };
    const bool isAcross = edge == Edge::Left || edge == Edge::Right || edge == Edge::Centre;
    double target = place0(boxOf(first->placement));
    for (const std::string& name : blocks)
        if (const Block* block = document_.diagram().find(name)) {
            const double at = place0(boxOf(block->placement));
            if (edge == Edge::Left || edge == Edge::Bottom) target = std::min(target, at);
            if (edge == Edge::Right || edge == Edge::Top) target = std::max(target, at);
        }
    std::vector<std::pair<std::string, Placement>> placements;
    for (const std::string& name : blocks)
        if (const Block* block = document_.diagram().find(name)) {
            const double by = target - place0(boxOf(block->placement));
            if (by != 0) placements.emplace_back(name, shifted(block->placement, isAcross ? by : 0, isAcross ? 0 : by));
        }
    return place(placements, QObject::tr("Align"));
}

/// The outermost stay where they are, and the gaps between become equal, to a whole unit of the diagram.
bool Composer::distribute(const std::vector<std::string>& blocks, bool isAcross) {
    if (!isReady() || blocks.size() < 3) return false;
    struct Span {
        const Block* block;
        double low, high;
    };
    std::vector<Span> spans;
    for (const std::string& name : blocks)
        if (const Block* block = document_.diagram().find(name)) {
            const auto [low, high] = boxOf(block->placement);
            spans.push_back({block, isAcross ? low.x : low.y, isAcross ? high.x : high.y});
        }
    if (spans.size() < 3) return false;
    const auto middle = [](const Span& s) { return s.low + s.high; };
    std::stable_sort(spans.begin(), spans.end(), [&](const Span& a, const Span& b) { return middle(a) < middle(b); });
    double gap = spans.back().high - spans.front().low;
    for (const Span& s : spans) gap -= s.high - s.low;
    gap /= static_cast<double>(spans.size() - 1);
    std::vector<std::pair<std::string, Placement>> placements;
    double at = spans.front().low;
    for (const Span& s : spans) {
        if (const double by = std::round(at - s.low); by != 0)
            placements.emplace_back(s.block->name, shifted(s.block->placement, isAcross ? by : 0, isAcross ? 0 : by));
        at += s.high - s.low + gap;
    }
    return place(placements, QObject::tr("Distribute"));
}

}  // namespace analogon::ui
