#include "core/report/diagram_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "core/base/number_text.hpp"
#include "core/base/visible.hpp"
#include "core/report/icon_svg.hpp"
#include "core/report/svg_plot.hpp"

namespace analogon {

namespace {

constexpr double markGap = 3, margin = 6;  // [diagram units]
constexpr double leastName = 5.5;          // [diagram units]
constexpr double characterWidth = 0.58;    // of the size of a letter, on average
constexpr std::size_t longestName = 28;    // [byte]

/// The room of two diagrams where they are shown.
struct Room {
    double beside, whole, nameHeight;  // [px] of one of two, of one alone
    double widestBeside;               // [diagram units] a wider diagram has the whole width to itself
};
constexpr Room onPage{430, 940, 11, 400}, onPaper{310, 640, 9, 350};
constexpr double highestOnPaper = 380;     // [px] two of them and their legend fit on A4
constexpr double largestScaleOnPaper = 2;  // [px per diagram unit]

/// How a kind of thing is painted: by the style of the page, or where there is none by itself.
struct Ink {
    const char *kind, *attributes;
};
constexpr Ink nameInk{"class=\"name\"", "fill=\"#3a4048\""},
    markedInk{"class=\"marked\"", "fill=\"#c2185b\" font-weight=\"bold\""},
    markInk{"class=\"mark\"", "fill=\"#c2185b\" fill-opacity=\"0.1\" stroke=\"#c2185b\""},
    unknownInk{"class=\"unknown\"", "stroke=\"#777777\" stroke-dasharray=\"4 3\""};

/// What is drawn spans this much of the diagram, y upward.
struct Bounds {
    double left{1e300}, right{-1e300}, low{1e300}, high{-1e300};

    void take(const Point& p) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
        left = std::min(left, p.x), right = std::max(right, p.x);
        low = std::min(low, p.y), high = std::max(high, p.y);
    }
    void take(const Bounds& other) {
        take(Point{other.left, other.low});
        take(Point{other.right, other.high});
    }
    Point centre() const { return {(left + right) / 2, (low + high) / 2}; }
};

using Mapping = std::function<Point(const Point&)>;

Bounds boundsOf(const Extent& extent, const Mapping& inDiagram) {
    Bounds bounds;
    for (const double x : {extent.p1.x, extent.p2.x})
        for (const double y : {extent.p1.y, extent.p2.y}) bounds.take(inDiagram({x, y}));
    return bounds;
}

/// Icons by what they draw, each with the name of its definition in the page.
class Symbols {
public:
    /// Empty: it draws nothing.
    std::string nameOf(const Icon& icon) {
        const std::string shapes = iconShapes(icon);
        if (shapes.empty()) return {};
        return names_.try_emplace(shapes, fmt::format("icon{}", names_.size() + 1)).first->second;
    }
    std::string definitions() const {
        std::string out;
        for (const auto& [shapes, name] : names_) out += fmt::format("<g id=\"{}\">{}</g>", name, shapes);
        return out.empty() ? out : "<defs>" + out + "</defs>";
    }

private:
    std::map<std::string, std::string> names_;
};

class Picture {
public:
    Picture(const Diagram& diagram, const std::vector<DiagramMark>& marks, double nameSize, Symbols& symbols,
            bool isAlone = false)
        : diagram_(diagram), marks_(marks), nameSize_(nameSize), symbols_(symbols), isAlone_(isAlone) {}

    /// The SVG element, with the definitions that are given inside.
    std::string write(const std::string& title, const std::string& definitions) const {
        const double width = bounds_.right - bounds_.left + 2 * margin,
                     height = bounds_.high - bounds_.low + 2 * margin;
        return fmt::format(
            "<svg class=\"diagram\" stroke-width=\"{}\" viewBox=\"{} {} {} {}\" style=\"max-width:{}px\" role=\"img\" "
            "aria-label=\"{}\">"
            "<title>{}</title>{}{}</svg>",
            svgNumber(lineWidth()), svgNumber(bounds_.left - margin), svgNumber(-bounds_.high - margin),
            svgNumber(width), svgNumber(height), svgNumber(std::ceil(4 * width)), escapeHtml(title), escapeHtml(title),
            definitions, body_);
    }

    /// A whole file, for what knows no page and no order of painting; the width is that of the room.
    DiagramDrawing writeAlone(double room) const {
        const double width = bounds_.right - bounds_.left + 2 * margin,
                     height = bounds_.high - bounds_.low + 2 * margin;
        const double scale = std::min({room / width, highestOnPaper / height, largestScaleOnPaper});
        return {
            fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\" "
                        "stroke-width=\"{}\">{}<g fill=\"none\" font-family=\"sans-serif\" "
                        "text-anchor=\"middle\">{}</g></svg>",
                        svgNumber(scale * width), svgNumber(scale * height), svgNumber(bounds_.left - margin),
                        svgNumber(-bounds_.high - margin), svgNumber(width), svgNumber(height), svgNumber(lineWidth()),
                        symbols_.definitions(), body_),
            scale * width, scale * height};
    }

    void draw() {
        for (const Wire& wire : diagram_.wires) drawWire(wire);
        for (const Block& block : diagram_.blocks) drawBlock(block);
        if (bounds_.left > bounds_.right)
            bounds_.take(boundsOf(diagram_.coordinates, [](const Point& p) { return p; }));
    }

private:
    /// A pixel or a little more, where a name is as high as it should be.
    double lineWidth() const { return 0.1 * nameSize_; }

    const char* painted(const Ink& ink) const { return isAlone_ ? ink.attributes : ink.kind; }

    void drawWire(const Wire& wire) {
        std::string points;
        for (const Point& p : wire.points) {
            points += fmt::format("{}{},{}", points.empty() ? "" : " ", svgNumber(p.x), svgNumber(-p.y));
            bounds_.take(p);
        }
        if (!points.empty())
            body_ += fmt::format("<polyline points=\"{}\" stroke=\"{}\"/>", points, svgColour(wire.colour));
    }

    /// An icon where a mapping puts it.
    void use(const Icon& icon, const Mapping& inDiagram) {
        const std::string symbol = symbols_.nameOf(icon);
        if (symbol.empty()) return;
        const Point o = inDiagram({0, 0}), x = inDiagram({1, 0}), y = inDiagram({0, 1});
        const auto factor = [](double value) {
            return std::abs(value) > 1e-9 && std::isfinite(value) ? fmt::format("{:.4g}", value) : "0";
        };
        const double scale = std::sqrt(std::abs((x.x - o.x) * (y.y - o.y) - (x.y - o.y) * (y.x - o.x)));
        if (!(scale > 0)) return;  // it has no extent
        body_ += fmt::format("<use href=\"#{}\" stroke-width=\"{}\" transform=\"matrix({} {} {} {} {} {})\"/>", symbol,
                             factor(lineWidth() / scale), factor(x.x - o.x), factor(o.y - x.y), factor(y.x - o.x),
                             factor(o.y - y.y), svgNumber(o.x), svgNumber(-o.y));
    }

    void drawBlock(const Block& block) {
        const Mapping inDiagram = [&](const Point& p) { return map(block.placement, block.icon.coordinates, p); };
        Bounds body = boundsOf(block.icon.coordinates, inDiagram);
        body_ += "<g><title>" + escapeHtml(block.name) + "</title>";
        if (!block.isResolved || block.icon.primitives.empty()) box(body, 0, painted(unknownInk));
        use(block.icon, inDiagram);
        for (const Port& port : block.ports) {
            const Mapping ofPort = [&](const Point& p) {
                return inDiagram(map(port.placement, port.icon.coordinates, p));
            };
            use(port.icon, ofPort);
            body.take(boundsOf(port.icon.coordinates, ofPort));
        }
        for (const Primitive& p : block.icon.primitives)
            if (p.kind == Primitive::Kind::Text) drawText(p, inDiagram);
        const auto isOfBlock = [&](const DiagramMark& mark) { return mark.block == block.name; };
        const bool isMarked = std::any_of(marks_.begin(), marks_.end(), isOfBlock);
        if (isMarked)
            box(body, markGap,
                fmt::format("{} rx=\"2\" stroke-width=\"{}\"", painted(markInk), svgNumber(2 * lineWidth())));
        const std::string name = shortened(block.name, longestName);
        const double x = body.centre().x, y = body.low - (isMarked ? markGap : 0) - 1.3 * nameSize_;
        const Ink& ink = isMarked ? markedInk : nameInk;
        const Point foot{x, y + 0.3 * nameSize_};
        if (isAlone_)  // what lies below a name must not run through it
            text(foot, nameSize_, name, std::string(ink.attributes) + " stroke=\"#ffffff\" stroke-width=\"2\"");
        text(foot, nameSize_, name, painted(ink));
        body_ += "</g>";
        const double half = characterWidth * nameSize_ * static_cast<double>(displayWidth(name)) / 2;
        bounds_.take(body);
        for (const double side : {-half, half}) bounds_.take(Point{x + side, y});
        if (isMarked) bounds_.take(Point{body.right + markGap, body.high + markGap});
        if (isMarked) bounds_.take(Point{body.left - markGap, body.low - markGap});
    }

    void box(const Bounds& body, double gap, const std::string& how) {
        body_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" {}/>", svgNumber(body.left - gap),
                             svgNumber(-body.high - gap), svgNumber(body.right - body.left + 2 * gap),
                             svgNumber(body.high - body.low + 2 * gap), how);
    }

    /// Texts stay upright in blocks that are turned or mirrored; the name is set below the block.
    void drawText(const Primitive& p, const Mapping& inDiagram) {
        if (p.text.empty() || p.text.find('%') != std::string::npos) return;  // the name, or values
        const double angle = p.rotation * std::numbers::pi / 180;
        const Bounds at = boundsOf(p.extent, [&](const Point& q) {
            return inDiagram({p.origin.x + q.x * std::cos(angle) - q.y * std::sin(angle),
                              p.origin.y + q.x * std::sin(angle) + q.y * std::cos(angle)});
        });
        const double width = at.right - at.left, height = at.high - at.low;
        const double letters = std::max<double>(1, static_cast<double>(displayWidth(p.text)));
        const double size = std::min(0.72 * height, width / (letters * characterWidth));
        constexpr double smallest = 2;  // is not readable
        if (!(size >= smallest)) return;
        text({at.centre().x, at.centre().y - 0.35 * size}, size, p.text,
             fmt::format("fill=\"{}\"{}", svgColour(p.line), p.bold ? " font-weight=\"bold\"" : ""));
    }

    void text(const Point& at, double size, const std::string& words, const std::string& how) {
        body_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" {}>{}</text>", svgNumber(at.x), svgNumber(-at.y),
                             svgNumber(size), how, escapeHtml(words));
    }

    const Diagram& diagram_;
    const std::vector<DiagramMark>& marks_;
    double nameSize_;
    Symbols& symbols_;
    bool isAlone_;
    Bounds bounds_;
    std::string body_;
};

/// How far the blocks of a diagram reach from left to right.
double widthOf(const Diagram& diagram) {
    Bounds bounds;
    for (const Block& block : diagram.blocks)
        bounds.take(boundsOf(block.icon.coordinates,
                             [&](const Point& p) { return map(block.placement, block.icon.coordinates, p); }));
    return std::max(0.0, bounds.right - bounds.left);
}

struct Arrangement {
    bool isBeside;
    double nameSize;  // [diagram units]
};

Arrangement arrangementOf(const DiagramPair& pair, const Room& room) {
    const double width = std::max(widthOf(pair.before), widthOf(pair.after));
    const bool isBeside = width <= room.widestBeside;
    return {isBeside, std::max(leastName, room.nameHeight * width / (isBeside ? room.beside : room.whole))};
}

std::string figure(const char* caption, const std::string& picture) {
    return fmt::format("<figure class=\"card\"><figcaption>{}</figcaption>{}</figure>\n", caption, picture);
}

}  // namespace

std::string diagramsHtml(const DiagramPair& pair) {
    Symbols symbols;
    const std::vector<DiagramMark> none;
    const auto [isBeside, nameSize] = arrangementOf(pair, onPage);
    Picture before(pair.before, none, nameSize, symbols), after(pair.after, pair.marks, nameSize, symbols);
    before.draw();
    after.draw();
    std::string legend, marked;
    for (const DiagramMark& mark : pair.marks) {
        legend += fmt::format("<span><i class=\"i-mark\"></i><code>{}</code> {}</span>", escapeHtml(mark.block),
                              escapeHtml(mark.words));
        marked += (marked.empty() ? "" : ", ") + mark.block;
    }
    std::string out = isBeside ? "<div class=\"diagrams\">" : "<div class=\"diagrams wide\">";
    out += figure("Before", before.write("Diagram of the model as it was given", symbols.definitions()));
    out += figure("After", after.write("Diagram of the model with what was added: " + marked + " outlined", {}));
    return out + "</div>\n<div class=\"legend\">" + legend + "</div>\n";
}

DiagramDrawings diagramDrawings(const DiagramPair& pair) {
    Symbols ofBefore, ofAfter;
    const std::vector<DiagramMark> none;
    const auto [isBeside, nameSize] = arrangementOf(pair, onPaper);
    Picture before(pair.before, none, nameSize, ofBefore, true), after(pair.after, pair.marks, nameSize, ofAfter, true);
    before.draw();
    after.draw();
    const double room = isBeside ? onPaper.beside : onPaper.whole;
    return {before.writeAlone(room), after.writeAlone(room), isBeside};
}

const char* diagramStyle() {
    return R"css(
:root { --mark: #c2185b; }
.diagrams { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr)); gap: 14px; }
.diagrams.wide { grid-template-columns: 100%; }
.diagrams figure { margin: 0 0 10px; display: flex; flex-direction: column; }
.diagrams figcaption { font-weight: 600; margin: 0 0 8px; }
.diagram { display: block; width: 100%; margin: auto; font-family: system-ui, "DejaVu Sans", sans-serif; fill: none; }
.diagram text { text-anchor: middle; stroke: none; }
.diagram .name, .diagram .marked { stroke: #fff; stroke-width: 2; paint-order: stroke; }
.diagram .name { fill: #3a4048; }
.diagram .marked { fill: #c2185b; font-weight: 700; }
.diagram .mark { fill: #c2185b; fill-opacity: 0.1; stroke: #c2185b; }
.diagram .unknown { stroke: #777; stroke-dasharray: 4 3; }
.legend i.i-mark { width: 16px; height: 12px; border: 2px solid var(--mark); }
@media screen and (prefers-color-scheme: dark) {
  :root { --mark: #ff7fb2; }
  .diagram { filter: invert(0.88) hue-rotate(180deg); }
}
)css";
}

}  // namespace analogon
