#include "core/report/icon_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace analogon {

namespace {

std::string at(const Point& p) { return svgNumber(p.x) + ' ' + svgNumber(p.y); }

Point middle(const Point& a, const Point& b) { return {(a.x + b.x) / 2, (a.y + b.y) / 2}; }

/// Data of a path; Modelica's smooth line are quadratic arcs between the middles of its segments.
std::string course(const Primitive& p, bool isClosed) {
    std::vector<Point> points = p.points;
    if (points.empty()) return {};
    if (isClosed && points.size() > 2 && !(points.front() == points.back())) points.push_back(points.front());
    std::string path = "M" + at(points.front());
    if (p.smooth && points.size() > 2) {
        path += 'L' + at(middle(points[0], points[1]));
        for (std::size_t i = 1; i + 1 < points.size(); ++i)
            path += 'Q' + at(points[i]) + ' ' + at(middle(points[i], points[i + 1]));
        path += 'L' + at(points.back());
    } else {
        for (std::size_t i = 1; i < points.size(); ++i) path += 'L' + at(points[i]);
    }
    return isClosed ? path + 'Z' : path;
}

/// A part of an ellipse, from one angle to another against the clock.
std::string arc(const Primitive& p, const Point& centre, double rx, double ry) {
    const auto on = [&](double degrees) {
        const double angle = degrees * std::numbers::pi / 180;
        return Point{centre.x + rx * std::cos(angle), centre.y + ry * std::sin(angle)};
    };
    return fmt::format("M{}A{} {} 0 {} {} {}", at(on(p.startAngle)), svgNumber(rx), svgNumber(ry),
                       std::abs(p.endAngle - p.startAngle) > 180 ? 1 : 0, p.endAngle > p.startAngle ? 1 : 0,
                       at(on(p.endAngle)));
}

std::string paint(const Primitive& p, bool canFill) {
    std::string out = canFill && p.filled ? " fill=\"" + svgColour(p.fill) + '"' : std::string();
    if (p.outlined) out += " stroke=\"" + svgColour(p.line) + '"';
    if (p.outlined && p.dashed) out += " stroke-dasharray=\"4 3\"";
    return out;
}

std::string shape(const Primitive& p) {
    const double left = std::min(p.extent.p1.x, p.extent.p2.x), low = std::min(p.extent.p1.y, p.extent.p2.y);
    const double width = std::abs(p.extent.p2.x - p.extent.p1.x), height = std::abs(p.extent.p2.y - p.extent.p1.y);
    switch (p.kind) {
        case Primitive::Kind::Line:
            return fmt::format("<path d=\"{}\"{}/>", course(p, false), paint(p, false));
        case Primitive::Kind::Polygon:
            return fmt::format("<path d=\"{}\"{}/>", course(p, true), paint(p, true));
        case Primitive::Kind::Rectangle:
            return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{}{}/>", svgNumber(left),
                               svgNumber(low), svgNumber(width), svgNumber(height),
                               p.radius > 0 ? " rx=\"" + svgNumber(p.radius) + '"' : "", paint(p, true));
        case Primitive::Kind::Ellipse: {
            const Point centre{left + width / 2, low + height / 2};
            if (std::abs(p.endAngle - p.startAngle) < 360)
                return fmt::format("<path d=\"{}\"{}/>", arc(p, centre, width / 2, height / 2), paint(p, true));
            return fmt::format("<ellipse cx=\"{}\" cy=\"{}\" rx=\"{}\" ry=\"{}\"{}/>", svgNumber(centre.x),
                               svgNumber(centre.y), svgNumber(width / 2), svgNumber(height / 2), paint(p, true));
        }
        case Primitive::Kind::Text:
        case Primitive::Kind::Bitmap:  // its file lies outside the study
            break;
    }
    return {};
}

}  // namespace

std::string svgNumber(double value) {
    if (!std::isfinite(value)) return "0";
    const double rounded = std::round(value * 100) / 100;
    return fmt::format("{}", rounded == 0 ? 0.0 : rounded);
}

std::string svgColour(const Colour& colour) {
    return fmt::format("#{:02x}{:02x}{:02x}", colour.r & 255, colour.g & 255, colour.b & 255);
}

std::string iconShapes(const Icon& icon) {
    std::string out;
    for (const Primitive& p : icon.primitives) {
        const std::string drawn = shape(p);
        if (drawn.empty()) continue;
        const bool isMoved = p.origin.x != 0 || p.origin.y != 0 || p.rotation != 0;
        out += isMoved ? fmt::format("<g transform=\"translate({}) rotate({})\">{}</g>", at(p.origin),
                                     svgNumber(p.rotation), drawn)
                       : drawn;
    }
    return out;
}

}  // namespace analogon
