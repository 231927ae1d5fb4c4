#include "core/flat/table_sum.hpp"

#include <algorithm>

namespace analogon {

void Ordinates::set(const ExpressionPool& pool, std::size_t place, ExpressionId ordinate) {
    const bool isNumber = pool.isConstant(ordinate);
    numbers[place] = isNumber ? pool[ordinate].value : 0;
    open[place] = isNumber ? ExpressionId{} : ordinate;
}

bool Ordinates::isOpen() const {
    return std::any_of(open.begin(), open.end(), [](ExpressionId id) { return id.valid(); });
}

ExpressionId TableSum::at(ExpressionPool& pool, ExpressionId x) const {
    ExpressionId sum = pool.table(known, x);
    for (const Part& part : parts) sum = pool.add(sum, pool.multiply(part.factor, pool.table(part.shape, x)));
    return sum;
}

void TableSum::forEach(const std::function<void(LookupTable&)>& change) {
    change(known);
    for (Part& part : parts) change(part.shape);
}

namespace {

std::vector<double> unit(std::size_t size, std::size_t place) {
    std::vector<double> values(size);
    values[place] = 1;
    return values;
}

}  // namespace

TableSum linearSum(const Ordinates& y, const std::function<LookupTable(std::vector<double>)>& curve) {
    TableSum sum{curve(y.numbers), {}};
    for (std::size_t i = 0; i < y.open.size(); ++i)
        if (y.open[i].valid()) sum.parts.push_back({y.open[i], curve(unit(y.open.size(), i))});
    return sum;
}

TableSum curveThrough(ExpressionPool& pool, const std::vector<double>& x, const Ordinates& y,
                      LookupTable::Interpolation interpolation) {
    LookupTable form;
    form.x = x;
    if (interpolation == LookupTable::Interpolation::MonotoneCubic && y.isOpen())
        return cubicSum(pool, form, y, slopesOf(pool, y, [&](const std::vector<PoolNumber>& values) {
                            return limitedSlopes(x, values);
                        }));
    form.interpolation = interpolation;
    return linearSum(y, [&](std::vector<double> values) {
        LookupTable table = form;
        table.y = std::move(values);
        return table;
    });
}

Ordinates slopesOf(ExpressionPool& pool, const Ordinates& y, const SlopeRule& rule) {
    std::vector<PoolNumber> values;
    for (std::size_t i = 0; i < y.open.size(); ++i)
        values.emplace_back(pool, y.open[i].valid() ? y.open[i] : pool.constant(y.numbers[i]));
    const std::vector<PoolNumber> found = rule(values);
    Ordinates slopes(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) slopes.set(pool, i, found[i].in(pool));
    return slopes;
}

TableSum cubicSum(ExpressionPool& pool, const LookupTable& form, const Ordinates& y, const Ordinates& slopes) {
    const std::size_t n = form.x.size();
    const auto curve = [&](std::vector<double> values, std::vector<double> rises) {
        LookupTable table = form;
        table.interpolation = LookupTable::Interpolation::Hermite;
        table.y = std::move(values);
        table.slopes = std::move(rises);
        return table;
    };
    const std::vector<double> none(n);
    TableSum sum{curve(y.numbers, slopes.numbers), {}};
    for (std::size_t i = 0; i < n; ++i) {
        if (y.open[i].valid()) sum.parts.push_back({y.open[i], curve(unit(n, i), none)});
        // what the slopes are chosen by is no event
        if (slopes.open[i].valid())
            sum.parts.push_back({pool.unary(Operation::NoEvent, slopes.open[i]), curve(none, unit(n, i))});
    }
    return sum;
}

}  // namespace analogon
