#pragma once

#include <functional>
#include <vector>

#include "core/flat/cubic_slopes.hpp"

namespace analogon {

/// What a table holds at its abscissas: numbers, and expressions of parameters where they are valid (0 stands for them
/// among the numbers).
struct Ordinates {
    std::vector<double> numbers;
    std::vector<ExpressionId> open;  // by place; invalid: the number

    explicit Ordinates(std::size_t size) : numbers(size), open(size) {}
    /// A number where the expression is one.
    void set(const ExpressionPool& pool, std::size_t place, ExpressionId ordinate);
    bool isOpen() const;
};

/// A look-up table with ordinates that may be expressions: known(x) + sum of factor * shape(x).
struct TableSum {
    struct Part {
        ExpressionId factor;
        LookupTable shape;
    };
    LookupTable known;
    std::vector<Part> parts;

    ExpressionId at(ExpressionPool& pool, ExpressionId x) const;
    /// The same for the known table and each shape.
    void forEach(const std::function<void(LookupTable&)>& change);
};

/// A curve that is linear in its ordinates, as straight and constant pieces are; `curve` makes it of numbers.
TableSum linearSum(const Ordinates& y, const std::function<LookupTable(std::vector<double>)>& curve);
/// A table of the language through points; two or more abscissas that rise.
TableSum curveThrough(ExpressionPool& pool, const std::vector<double>& x, const Ordinates& y,
                      LookupTable::Interpolation interpolation);
/// Slopes at the nodes by a rule for their ordinates.
using SlopeRule = std::function<std::vector<PoolNumber>(const std::vector<PoolNumber>&)>;
Ordinates slopesOf(ExpressionPool& pool, const Ordinates& y, const SlopeRule& rule);
/// Cubic pieces through the ordinates with these slopes; `form` gives the abscissas and how the curve goes on.
TableSum cubicSum(ExpressionPool& pool, const LookupTable& form, const Ordinates& y, const Ordinates& slopes);

}  // namespace analogon
