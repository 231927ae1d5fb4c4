#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagram/diagram.hpp"
#include "core/syntax/ast.hpp"

/// Literal values in graphical annotations (Modelica 3.6, section 18.6). The same record is written as a
/// modification, `Line(points = …)`, or as a constructor call inside `graphics = {…}`; both read alike here.
namespace analogon::annotation {

class Record {
public:
    explicit Record(const syntax::Modification& modification) : modification_(&modification) {}
    explicit Record(const syntax::Expression& call) : call_(&call) {}

    std::string_view name() const;
    /// Value of a member; null when it is not given.
    const syntax::Expression* value(std::string_view member) const;
    /// A member that is itself a record, `transformation(…)`.
    std::optional<Record> record(std::string_view member) const;

    std::optional<double> number(std::string_view member) const;
    std::optional<bool> boolean(std::string_view member) const;
    std::optional<std::string> string(std::string_view member) const;
    std::optional<Point> point(std::string_view member) const;
    std::optional<Extent> extent(std::string_view member) const;
    std::optional<Colour> colour(std::string_view member) const;
    std::vector<Point> points(std::string_view member) const;
    /// Last part of an enumeration literal: "Dash" of LinePattern.Dash; empty when it is not given.
    std::string_view literal(std::string_view member) const;

private:
    const syntax::Modification* modification_{};
    const syntax::Expression* call_{};
};

std::optional<double> number(const syntax::Expression& expression);
std::optional<Point> point(const syntax::Expression& expression);
std::string_view literal(const syntax::Expression& expression);

/// The record `name(…)` of an annotation.
std::optional<Record> find(const std::optional<syntax::Annotation>& annotation, std::string_view name);

/// `Placement(transformation(…))`; with `asIcon` the `iconTransformation` when there is one.
std::optional<Placement> placement(const std::optional<syntax::Annotation>& annotation, bool asIcon = false);

/// The primitives of an Icon or Diagram annotation, and where each record begins in the text.
std::vector<Primitive> primitives(const Record& layer, std::vector<std::uint32_t>* begins = nullptr);

/// Of a Bitmap: the bytes of a picture file in base64, which stand in the text of the model; empty: they do not.
std::string_view pictureBytes(const Primitive& picture);
/// The file that holds them otherwise; empty: none that may be read.
std::string pictureFile(const Primitive& picture);

}  // namespace analogon::annotation
