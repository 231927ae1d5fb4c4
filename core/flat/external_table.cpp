#include "core/flat/external_table.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {
namespace {

LookupTable::Extrapolation extrapolationOf(TableExtrapolation given, Smoothness smoothness) {
    switch (given) {
        case TableExtrapolation::Periodic:
            return LookupTable::Extrapolation::Periodic;
        case TableExtrapolation::None:
            return LookupTable::Extrapolation::None;
        case TableExtrapolation::Hold:
            return LookupTable::Extrapolation::Hold;
        default:  // a slope of 0 beyond constant segments
            return smoothness == Smoothness::Constant ? LookupTable::Extrapolation::Hold
                                                      : LookupTable::Extrapolation::Slope;
    }
}

LookupTable lookupOf(std::vector<double> x, std::vector<double> y, Smoothness smoothness,
                     TableExtrapolation extrapolation) {
    LookupTable table;
    if (x.size() > 2 && smoothness != Smoothness::Linear && smoothness != Smoothness::Constant) {
        table.interpolation = LookupTable::Interpolation::Hermite;
        table.slopes = cubicSlopes(x, y, smoothness);
    } else if (smoothness == Smoothness::Constant) {
        table.interpolation = LookupTable::Interpolation::Constant;
    }
    table.extrapolation = extrapolationOf(extrapolation, smoothness);
    table.x = std::move(x);
    table.y = std::move(y);
    return table;
}

/// The abscissas must rise; `mayJump`: two may be equal.
std::optional<Diagnostic> unsorted(const std::vector<double>& x, bool mayJump) {
    for (std::size_t i = 1; i < x.size(); ++i)
        if (!(x[i] > x[i - 1] || (mayJump && x[i] == x[i - 1])))
            return error(phrase("the abscissas of the table must rise: {} follows {}", x[i], x[i - 1]));
    return std::nullopt;
}

/// The last two points say no slope where they are a jump: the table goes on as it ends there.
void goOnLevel(std::vector<double>& x, std::vector<double>& y) {
    const std::size_t n = x.size();
    if (n < 2) return;
    if (x[n - 1] == x[n - 2]) {
        x.push_back(x.back() + 1);
        y.push_back(y.back());
    }
    if (x[0] == x[1]) {
        x.insert(x.begin(), x.front() - 1);
        y.insert(y.begin(), y.front());
    }
}

/// Constant segments as straight lines with jumps, which go on along the line through the last two points.
void goOnFromSteps(std::vector<double>& x, std::vector<double>& y) {
    const std::size_t n = x.size();
    const auto slope = [&](std::size_t i) { return x[i + 1] > x[i] ? (y[i + 1] - y[i]) / (x[i + 1] - x[i]) : 0; };
    const double before = slope(0), behind = slope(n - 2);
    std::vector<double> at{x[0] - 1, x[0]}, values{y[0] - before, y[0]};
    for (std::size_t i = 1; i < n; ++i) {
        at.insert(at.end(), {x[i], x[i]});
        values.insert(values.end(), {y[i - 1], y[i]});
    }
    at.push_back(x.back() + 1);
    values.push_back(y.back() + behind);
    x = std::move(at);
    y = std::move(values);
}

}  // namespace

namespace {

/// A column over the abscissas x.
TableSum columnOf(const std::vector<double>& x, const Ordinates& y, Smoothness smoothness,
                  TableExtrapolation extrapolation, ExpressionPool* pool) {
    const bool isStraight = smoothness == Smoothness::Linear || smoothness == Smoothness::Constant || x.size() < 3;
    if (!isStraight && y.isOpen()) {
        LookupTable form;
        form.x = x;
        form.extrapolation = extrapolationOf(extrapolation, smoothness);
        return cubicSum(*pool, form, y, slopesOf(*pool, y, [&](const std::vector<PoolNumber>& values) {
            return cubicSlopes(x, values, smoothness);
        }));
    }
    return linearSum(y, [&](std::vector<double> values) {
        std::vector<double> at = x;
        Smoothness pieces = smoothness;
        if (extrapolation == TableExtrapolation::LastTwoPoints) {
            if (smoothness == Smoothness::Constant && x.size() > 1) {
                goOnFromSteps(at, values);
                pieces = Smoothness::Linear;
            } else if (smoothness == Smoothness::Linear) {
                goOnLevel(at, values);
            }
        }
        return lookupOf(std::move(at), std::move(values), pieces, extrapolation);
    });
}

/// A column of the table, with what stands for numbers in it.
Ordinates ordinatesOf(const Matrix& table, std::size_t column, const OpenEntries& open) {
    Ordinates y(table.rows);
    for (std::size_t i = 0; i < table.rows; ++i) {
        const auto entry = open.entries.find(i * table.columns + column);
        if (entry == open.entries.end())
            y.numbers[i] = table(i, column);
        else
            y.set(*open.pool, i, entry->second);
    }
    return y;
}

}  // namespace

Outcome<ExternalTable> oneDimensional(const Matrix& table, const std::vector<int>& columns, Smoothness smoothness,
                                      TableExtrapolation extrapolation, const OpenEntries& open) {
    if (table.rows == 0 || table.columns < 2) return error(phrase("the table has no values"));
    ExternalTable result;
    std::vector<double> x(table.rows);
    for (std::size_t i = 0; i < table.rows; ++i) x[i] = table(i, 0);
    if (auto fault = unsorted(x, smoothness == Smoothness::Linear || smoothness == Smoothness::Constant)) return *fault;
    for (const int column : columns) {
        if (column < 1 || static_cast<std::size_t>(column) > table.columns)
            return error(phrase("the table has {} columns, not {}", table.columns, column));
        const Ordinates y = ordinatesOf(table, static_cast<std::size_t>(column) - 1, open);
        result.columns.push_back(columnOf(x, y, smoothness, extrapolation, open.pool));
    }
    result.first = x.front();
    result.last = x.back();
    return result;
}

namespace {

/// Two more grid lines on each side, and values there by which second divided differences go on (Akima 1974).
struct Extended {
    std::vector<double> x;  // n + 4

    explicit Extended(const std::vector<double>& grid) {
        const std::size_t n = grid.size();
        x.resize(n + 4);
        std::copy(grid.begin(), grid.end(), x.begin() + 2);
        const double* g = grid.data();
        if (n == 2) {
            const double h = g[1] - g[0];
            x[1] = g[0] - h, x[0] = g[0] - 2 * h, x[4] = g[1] + h, x[5] = g[1] + 2 * h;
            return;
        }
        x[1] = g[0] + g[1] - g[2];
        x[0] = 2 * g[0] - g[2];
        x[n + 2] = g[n - 1] + g[n - 2] - g[n - 3];
        x[n + 3] = 2 * g[n - 1] - g[n - 3];
    }
    /// Values at the grid lines (2 … n + 1 of z are given).
    void extend(std::vector<double>& z) const {
        const std::size_t n = x.size() - 4;
        const auto secant = [&](std::size_t i) { return (z[i + 1] - z[i]) / (x[i + 1] - x[i]); };
        if (n == 2) {
            const double s = secant(2);
            z[1] = z[2] - s * (x[2] - x[1]), z[0] = z[2] - s * (x[2] - x[0]);
            z[4] = z[3] + s * (x[4] - x[3]), z[5] = z[3] + s * (x[5] - x[3]);
            return;
        }
        const double a = secant(2), b = secant(3);
        z[1] = z[2] - (2 * a - b) * (x[2] - x[1]);
        z[0] = z[1] - (3 * a - 2 * b) * (x[1] - x[0]);
        const double c = secant(n), e = secant(n - 1);
        z[n + 2] = z[n + 1] + (2 * c - e) * (x[n + 2] - x[n + 1]);
        z[n + 3] = z[n + 2] + (3 * c - 2 * e) * (x[n + 3] - x[n + 2]);
    }
};

struct Surface {
    std::vector<double> x, y, z, zx, zy, zxy;  // row-major over the grid
};

/// Partial derivatives at the nodes by Akima's bivariate method (Commun. ACM 17 (1974) 18-20).
void akimaSurface(Surface& s) {
    const std::size_t n = s.x.size(), m = s.y.size();
    const Extended ex(s.x), ey(s.y);
    std::vector<std::vector<double>> z(n + 4, std::vector<double>(m + 4));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < m; ++j) z[i + 2][j + 2] = s.z[i * m + j];
        ey.extend(z[i + 2]);
    }
    for (std::size_t j = 0; j < m + 4; ++j) {
        std::vector<double> column(n + 4);
        for (std::size_t i = 2; i < n + 2; ++i) column[i] = z[i][j];
        ex.extend(column);
        for (std::size_t i = 0; i < n + 4; ++i) z[i][j] = column[i];
    }
    s.zx.resize(n * m), s.zy.resize(n * m), s.zxy.resize(n * m);
    const auto& x = ex.x;
    const auto& y = ey.x;
    for (std::size_t i = 2; i < n + 2; ++i)
        for (std::size_t j = 2; j < m + 2; ++j) {
            const auto dx = [&](std::size_t k, std::size_t l) { return (z[k + 1][l] - z[k][l]) / (x[k + 1] - x[k]); };
            const auto dy = [&](std::size_t k, std::size_t l) { return (z[k][l + 1] - z[k][l]) / (y[l + 1] - y[l]); };
            const auto dxy = [&](std::size_t k, std::size_t l) {
                return (dy(k + 1, l) - dy(k, l)) / (x[k + 1] - x[k]);
            };
            double wx2 = std::fabs(dx(i + 1, j) - dx(i, j)), wx3 = std::fabs(dx(i - 1, j) - dx(i - 2, j));
            double wy2 = std::fabs(dy(i, j + 1) - dy(i, j)), wy3 = std::fabs(dy(i, j - 1) - dy(i, j - 2));
            if (wx2 + wx3 == 0) wx2 = wx3 = 1;
            if (wy2 + wy3 == 0) wy2 = wy3 = 1;
            const std::size_t at = (i - 2) * m + (j - 2);
            s.zx[at] = weighted(dx(i - 1, j), wx2, dx(i, j), wx3);
            s.zy[at] = weighted(dy(i, j - 1), wy2, dy(i, j), wy3);
            s.zxy[at] = (wx2 * (wy2 * dxy(i - 1, j - 1) + wy3 * dxy(i - 1, j)) +
                         wx3 * (wy2 * dxy(i, j - 1) + wy3 * dxy(i, j))) /
                        ((wx2 + wx3) * (wy2 + wy3));
        }
}

}  // namespace

/// The surface as a sum over the lines of the grid: each is a table along u1 times a basis function of u2, which is 1
/// at its line and 0 at the others; for cubic pieces one more, with slope 1, carries the slope across.
Outcome<ExternalTable> twoDimensional(const Matrix& table, Smoothness smoothness, TableExtrapolation extrapolation,
                                      const OpenEntries& open) {
    if (table.rows < 2 || table.columns < 2) return error(phrase("the table has no values"));
    if (smoothness != Smoothness::Linear && smoothness != Smoothness::Constant && smoothness != Smoothness::Akima)
        return error(
            phrase("a table of two dimensions is interpolated linearly, by Akima's method or in constant "
                   "segments"));
    Surface s;
    for (std::size_t i = 1; i < table.rows; ++i) s.x.push_back(table(i, 0));
    for (std::size_t j = 1; j < table.columns; ++j) s.y.push_back(table(0, j));
    for (const auto* grid : {&s.x, &s.y})
        if (auto fault = unsorted(*grid, false)) return *fault;
    for (std::size_t i = 1; i < table.rows; ++i)
        for (std::size_t j = 1; j < table.columns; ++j) s.z.push_back(table(i, j));
    const std::size_t n = s.x.size(), m = s.y.size();
    // one dimension alone, or two points in each, is no surface
    const bool isCubic = smoothness == Smoothness::Akima && (n > 2 || m > 2);
    if (isCubic && n > 1 && m > 1) akimaSurface(s);
    ExternalTable result;
    result.kind = ExternalTable::Kind::TwoDimensions;
    const auto linear = isCubic ? Smoothness::Linear : smoothness;
    const auto lookup = [&](const std::vector<double>& x, std::vector<double> y, std::vector<double> slopes) {
        LookupTable one = lookupOf(x, std::move(y), slopes.empty() ? linear : Smoothness::Linear, extrapolation);
        if (!slopes.empty()) {
            one.interpolation = LookupTable::Interpolation::Hermite;
            one.slopes = std::move(slopes);
        }
        return one;
    };
    const auto line = [&](const std::vector<double>& of, std::size_t j) {
        std::vector<double> values(n);
        for (std::size_t i = 0; i < n && !of.empty(); ++i) values[i] = of[i * m + j];
        return values;
    };
    std::vector<double> slopesAlong, slopesAcross;
    if (isCubic && m == 1) slopesAlong = cubicSlopes(s.x, s.z, smoothness);
    for (std::size_t j = 0; j < m; ++j) {
        std::vector<double> basis(m), none(m);
        basis[j] = 1;
        if (!isCubic || m == 1) {
            Ordinates z = ordinatesOf(table, j + 1, open);
            z.numbers.erase(z.numbers.begin());  // the grid line
            z.open.erase(z.open.begin());
            result.along.push_back(
                linearSum(z, [&](std::vector<double> values) { return lookup(s.x, std::move(values), slopesAlong); }));
            result.across.push_back(lookup(s.y, basis, {}));
            continue;
        }
        if (n == 1) {  // the slope across is that of the one line
            const std::vector<double> slopes = cubicSlopes(s.y, s.z, smoothness);
            result.along.push_back({lookup(s.x, {1}, {}), {}});
            result.across.push_back(lookup(s.y, s.z, slopes));
            break;
        }
        result.along.push_back({lookup(s.x, line(s.z, j), line(s.zx, j)), {}});
        result.across.push_back(lookup(s.y, basis, none));
        result.along.push_back({lookup(s.x, line(s.zy, j), line(s.zxy, j)), {}});
        result.across.push_back(lookup(s.y, none, basis));
    }
    result.first = s.x.front(), result.last = s.x.back();
    result.first2 = s.y.front(), result.last2 = s.y.back();
    // constant segments that go on by their last two points are planes outside of the grid, in both directions
    if (smoothness == Smoothness::Constant && extrapolation == TableExtrapolation::LastTwoPoints && (n > 1 || m > 1)) {
        const Outcome<ExternalTable> planes = twoDimensional(table, Smoothness::Linear, extrapolation, open);
        if (!planes) return planes;
        result.alongBeyond = planes->along;
        result.acrossBeyond = planes->across;
    }
    return result;
}

Outcome<ExternalTable> timeTable(const Matrix& table, const std::vector<int>& columns, Smoothness smoothness,
                                 TableExtrapolation extrapolation, double start, double shift, TimeEvents events,
                                 const OpenEntries& open) {
    Outcome<ExternalTable> made = oneDimensional(table, columns, smoothness, extrapolation, open);
    if (!made) return made;
    ExternalTable& result = *made;
    result.kind = ExternalTable::Kind::Time;
    result.start = start;
    for (TableSum& column : result.columns)
        column.forEach([&](LookupTable& one) {
            one.begin = start;
            one.shift = shift;
        });
    const double first = result.first, last = result.last;
    result.isPeriodic = extrapolation == TableExtrapolation::Periodic && last > first;
    // a start before the table, as "from ever" (-1e60), says nothing of the times at which it is looked up
    result.rounding = 1e-13 * std::max({1e-3 * (last - first), std::fabs(first + shift), std::fabs(last + shift),
                                        start > first + shift ? std::fabs(start) : 0.0});
    std::vector<double> times;
    for (std::size_t i = 0; i < table.rows; ++i) {
        const double t = table(i, 0);
        const bool isJump = i > 0 && table(i - 1, 0) == t;
        if (events == TimeEvents::Always || smoothness == Smoothness::Constant || isJump || i == 0 ||
            i + 1 == table.rows)
            if (times.empty() || t > times.back()) times.push_back(t);
    }
    LookupTable& next = result.next;
    if (result.isPeriodic) {
        next.extrapolation = LookupTable::Extrapolation::Periodic;
        next.shift = shift;
        for (std::size_t i = 0; i + 1 < times.size(); ++i) {
            next.x.insert(next.x.end(), {times[i], times[i + 1]});
            next.y.insert(next.y.end(), {times[i + 1] - times[i], 0.0});
        }
        return made;
    }
    constexpr double never = 1e300;
    std::vector<double> all{start};
    for (const double t : times)
        if (t + shift > start) all.push_back(t + shift);
    next.interpolation = LookupTable::Interpolation::Constant;
    next.extrapolation = LookupTable::Extrapolation::Hold;
    next.x.push_back(all.front() - 1);
    next.y.push_back(all.front());
    for (std::size_t i = 0; i < all.size(); ++i) {
        next.x.push_back(all[i]);
        next.y.push_back(i + 1 < all.size() ? all[i + 1] : never);
    }
    return made;
}

}  // namespace analogon
