/* Solvers of the algebraic blocks and the look-up in tables. The methods, their order of operations and their limits
   are those of the program that wrote this file, so that both give the same numbers. */

#define AT_LEAST_ONE(n) ((n) > 0 ? (n) : 1)

typedef struct {
    double v[AT_LEAST_ONE(REGISTERS)];
    double guess[AT_LEAST_ONE(GUESSES)]; /* last solutions of the nonlinear blocks */
    unsigned char hasGuess[AT_LEAST_ONE(GUESSES)];
    double matrix[AT_LEAST_ONE(LARGEST_BLOCK * LARGEST_BLOCK)];
    double vector[AT_LEAST_ONE(LARGEST_BLOCK)], trial[AT_LEAST_ONE(LARGEST_BLOCK)];
    double start[AT_LEAST_ONE(LARGEST_BLOCK)], scale[AT_LEAST_ONE(LARGEST_BLOCK)];
    double rowScale[AT_LEAST_ONE(LARGEST_BLOCK)];
    int pivots[AT_LEAST_ONE(LARGEST_BLOCK)];
    const char* failure; /* the unknown at which the last evaluation failed */
} Equations;

typedef struct {
    int count, isCubic, order; /* order: the value is this derivative of the interpolant */
    const double *x, *y, *slopes;
    int isConstant, extrapolation;
    double begin, shift;
} Table;

typedef struct {
    int count;
    const int *unknowns, *matrix, *constant; /* matrix * unknowns + constant = 0 */
    const char* name;
} LinearBlock;

typedef struct {
    int count, guess;
    const int *unknowns, *residuals, *jacobian, *starts;
    const double* nominal;
    void (*body)(double* v); /* residuals and Jacobian from the unknowns */
    const char* name;
} NonlinearBlock;

static inline double signOf(double a) { return (a > 0) - (a < 0); }
static inline double minOf(double a, double b) { return b < a ? b : a; }
static inline double maxOf(double a, double b) { return b > a ? b : a; }
static inline double modOf(double a, double b) { return a - floor(a / b) * b; }
static inline double remOf(double a, double b) { return a - trunc(a / b) * b; }

static inline double cubicDerivative(double c0, double c1, double c2, double c3, double h, int n) {
    switch (n) {
        case 0:
            return c0 + h * (c1 + h * (c2 + h * c3));
        case 1:
            return c1 + h * (2 * c2 + h * 3 * c3);
        case 2:
            return 2 * c2 + 6 * c3 * h;
        case 3:
            return 6 * c3;
        default:
            return 0;
    }
}

/* n-th derivative of the table's value; extrapolates with the slope at the first or last node. */
static inline double interpolate(const Table* table, double at, int n) {
    const double *x = table->x, *y = table->y, *slopes = table->slopes;
    const int last = table->count - 1;
    double width, secant, c2, c3;
    int i = 0, above = last;
    if (last == 0) return n == 0 ? y[0] : 0.0;
    while (above - i > 1) {
        const int middle = (i + above) / 2;
        if (x[middle] <= at)
            i = middle;
        else
            above = middle;
    }
    while (i > 0 && x[i + 1] == x[i]) --i; /* a jump at the very end */
    if (table->isConstant) return n > 0 ? 0 : at >= x[last] ? y[last] : y[i];
    width = x[i + 1] - x[i];
    secant = (y[i + 1] - y[i]) / width;
    if (!table->isCubic && n == 0 && at == x[last]) return y[last];
    if (!table->isCubic) return cubicDerivative(y[i], secant, 0, 0, at - x[i], n);
    if (at < x[0]) return cubicDerivative(y[0], slopes[0], 0, 0, at - x[0], n);
    /* as at every node, what changes there is as it goes on behind it */
    if (at > x[last] || (at == x[last] && n > 1 && table->extrapolation != 3))
        return cubicDerivative(y[last], slopes[last], 0, 0, at - x[last], n);
    c2 = (3 * secant - 2 * slopes[i] - slopes[i + 1]) / width;
    c3 = (slopes[i] + slopes[i + 1] - 2 * secant) / (width * width);
    return cubicDerivative(y[i], slopes[i], c2, c3, at - x[i], n);
}

/* Beyond its ends a table goes on with its slope (0), is held (1), repeats itself (2) or has no value (3). */
static inline double lookUp(const Table* table, double at, int n) {
    const int last = table->count - 1;
    const double begin = table->x[0], end = table->x[last];
    n += table->order;
    if (at < table->begin) return 0;
    at -= table->shift;
    if (table->extrapolation == 0 || (at >= begin && at < end) || (at == end && table->extrapolation != 2))
        return interpolate(table, at, n);
    if (table->extrapolation == 2) {
        if (!(end > begin)) return interpolate(table, begin, n);
        at = begin + fmod(at - begin, end - begin);
        return interpolate(table, at < begin ? at + (end - begin) : at, n);
    }
    if (table->extrapolation == 1) return n > 0 ? 0 : at < begin ? table->y[0] : table->y[last];
    return NAN;
}

/* LU factors with scaled partial pivoting, row-major in place; 0 when singular to working precision. */
static inline int factorise(double* matrix, int* pivots, double* scale, int n) {
    int row, column, k;
    for (row = 0; row < n; ++row) {
        double largest = 0;
        for (column = 0; column < n; ++column) largest = fmax(largest, fabs(matrix[row * n + column]));
        if (!(largest > 0) || !isfinite(largest)) return 0;
        scale[row] = 1 / largest;
    }
    for (k = 0; k < n; ++k) {
        int best = k;
        double most = 0, before = 0, inverse;
        for (row = 0; row < n; ++row) {
            const double size = fabs(matrix[row * n + k]) * scale[row];
            if (row < k)
                before = fmax(before, size);
            else if (size > most)
                most = size, best = row;
        }
        if (!(most > 4 * DBL_EPSILON * before) || !isfinite(most)) return 0;
        pivots[k] = best;
        if (best != k) {
            const double swapped = scale[k];
            for (column = 0; column < n; ++column) {
                const double entry = matrix[k * n + column];
                matrix[k * n + column] = matrix[best * n + column];
                matrix[best * n + column] = entry;
            }
            scale[k] = scale[best];
            scale[best] = swapped;
        }
        inverse = 1 / matrix[k * n + k];
        for (row = k + 1; row < n; ++row) {
            const double factor = matrix[row * n + k] *= inverse;
            if (factor == 0) continue;
            for (column = k + 1; column < n; ++column) matrix[row * n + column] -= factor * matrix[k * n + column];
        }
    }
    return 1;
}

static inline void substitute(const double* matrix, const int* pivots, double* right, int n) {
    int row, k;
    for (k = 0; k < n; ++k) {
        const double entry = right[k];
        right[k] = right[pivots[k]];
        right[pivots[k]] = entry;
    }
    for (row = 1; row < n; ++row)
        for (k = 0; k < row; ++k) right[row] -= matrix[row * n + k] * right[k];
    for (row = n - 1; row >= 0; --row) {
        for (k = row + 1; k < n; ++k) right[row] -= matrix[row * n + k] * right[k];
        right[row] *= 1 / matrix[row * n + row];
    }
}

static inline int solveLinear(Equations* e, const LinearBlock* block) {
    const int n = block->count;
    int i;
    for (i = 0; i < n * n; ++i) e->matrix[i] = e->v[block->matrix[i]];
    if (!factorise(e->matrix, e->pivots, e->scale, n)) {
        e->failure = block->name;
        return 0;
    }
    for (i = 0; i < n; ++i) e->vector[i] = -e->v[block->constant[i]];
    substitute(e->matrix, e->pivots, e->vector, n);
    for (i = 0; i < n; ++i) e->v[block->unknowns[i]] = e->vector[i];
    return 1;
}

enum { mostSteps = 60, mostHalvings = 30 };
static const double converged = 1e-11, good = 1e-7;

/* Whether a full step reaches the solution: it is small, or the error it leaves, which falls quadratically, is. */
static inline int reaches(double step, double before) {
    return step <= converged || (step <= 1e-3 * before && step * step * step <= 0.1 * converged * before * before);
}

static inline double residualAt(Equations* e, const NonlinearBlock* block, double z) {
    e->v[block->unknowns[0]] = z;
    block->body(e->v);
    return e->v[block->residuals[0]];
}

/* Newton's method, damped by halving: one unknown, then many. */
static inline int newtonForOne(Equations* e, const NonlinearBlock* block, double start) {
    double z = start, value = residualAt(e, block, z), before = 0;
    int step, halving;
    for (step = 0; step < mostSteps; ++step) {
        double change, relative, fraction = 1, reached = value;
        if (value == 0) return 1;
        change = value / e->v[block->jacobian[0]];
        relative = fabs(change) / (fabs(z) + block->nominal[0]);
        if (!isfinite(relative)) return 0;
        for (halving = 0; halving < mostHalvings; ++halving, fraction /= 2) {
            reached = residualAt(e, block, z - fraction * change);
            if (halving == 0 && reaches(relative, before) && isfinite(reached)) return 1;
            if (fabs(reached) < fabs(value)) break;
        }
        if (!(fabs(reached) < fabs(value))) {
            residualAt(e, block, z);
            return relative <= good;
        }
        z -= fraction * change;
        value = reached;
        before = fraction == 1 ? relative : 0;
    }
    return 0;
}

static inline double residualNorm(const Equations* e, const NonlinearBlock* block) {
    double sum = 0;
    int i;
    for (i = 0; i < block->count; ++i) {
        const double scaled = e->v[block->residuals[i]] * e->rowScale[i];
        sum += scaled * scaled;
    }
    return sqrt(sum);
}

static inline void loadJacobian(Equations* e, const NonlinearBlock* block) {
    int i;
    for (i = 0; i < block->count * block->count; ++i) e->matrix[i] = e->v[block->jacobian[i]];
}

static inline int newtonForMany(Equations* e, const NonlinearBlock* block) {
    const int n = block->count;
    double size, before = 0;
    int step, halving, i, j;
    for (i = 0; i < n; ++i) e->v[block->unknowns[i]] = e->start[i];
    block->body(e->v);
    loadJacobian(e, block);
    for (i = 0; i < n; ++i) {
        double largest = 0;
        for (j = 0; j < n; ++j) largest = fmax(largest, fabs(e->matrix[i * n + j]) * block->nominal[j]);
        e->rowScale[i] = largest > 0 && isfinite(largest) ? 1 / largest : 1;
    }
    size = residualNorm(e, block);
    for (step = 0; step < mostSteps; ++step) {
        double relative = 0, fraction = 1, reached = size;
        if (size == 0) return 1;
        if (!isfinite(size)) return 0;
        if (!factorise(e->matrix, e->pivots, e->scale, n)) return 0;
        for (i = 0; i < n; ++i) e->vector[i] = e->v[block->residuals[i]];
        substitute(e->matrix, e->pivots, e->vector, n);
        for (i = 0; i < n; ++i) {
            const double z = e->trial[i] = e->v[block->unknowns[i]];
            relative = fmax(relative, fabs(e->vector[i]) / (fabs(z) + block->nominal[i]));
        }
        if (!isfinite(relative)) return 0;
        for (halving = 0; halving < mostHalvings; ++halving, fraction /= 2) {
            for (i = 0; i < n; ++i) e->v[block->unknowns[i]] = e->trial[i] - fraction * e->vector[i];
            block->body(e->v);
            reached = residualNorm(e, block);
            if (halving == 0 && reaches(relative, before) && isfinite(reached)) return 1;
            if (reached < size) break;
        }
        if (!(reached < size)) {
            for (i = 0; i < n; ++i) e->v[block->unknowns[i]] = e->trial[i];
            return relative <= good;
        }
        size = reached;
        before = fraction == 1 ? relative : 0;
        loadJacobian(e, block);
    }
    return 0;
}

/* A single unknown: looks for a change of sign around the start and closes in on it. */
static inline int bracketForOne(Equations* e, const NonlinearBlock* block, double start) {
    double low = start, high = start, atLow = residualAt(e, block, start), atHigh = atLow;
    double width = 1e-3 * (fabs(start) + block->nominal[0]);
    int i;
    if (atLow == 0) return 1;
    for (i = 0; i < 80 && !(atLow * atHigh < 0); ++i, width *= 2) {
        const double below = residualAt(e, block, start - width), above = residualAt(e, block, start + width);
        if (isfinite(below) && below * atHigh <= 0)
            low = start - width, atLow = below;
        else if (isfinite(above) && above * atLow <= 0)
            high = start + width, atHigh = above;
        if (below == 0) {
            residualAt(e, block, start - width);
            return 1;
        }
        if (above == 0) return 1;
    }
    if (!(atLow * atHigh < 0)) return 0;
    for (i = 0; i < 200 && high - low > 4e-16 * (fabs(low) + fabs(high)); ++i) {
        const double middle = 0.5 * (low + high), value = residualAt(e, block, middle);
        if (value == 0) return 1;
        if (!isfinite(value)) return 0;
        if (value * atLow < 0)
            high = middle;
        else
            low = middle, atLow = value;
    }
    residualAt(e, block, 0.5 * (low + high));
    return 1;
}

static inline int newton(Equations* e, const NonlinearBlock* block) {
    return block->count == 1 ? newtonForOne(e, block, e->start[0]) : newtonForMany(e, block);
}

/* From the last solution, then from the model's start values and some way off them. */
static inline int solveNonlinear(Equations* e, const NonlinearBlock* block) {
    static const double offsets[] = {0.0, 1.0, -1.0, 1e-3, -1e-3, 1e3, -1e3};
    const int n = block->count, tries = (int)(sizeof offsets / sizeof offsets[0]);
    int i, k, isSolved = 0;
    if (e->hasGuess[block->guess]) {
        for (i = 0; i < n; ++i) e->start[i] = e->guess[block->guess + i];
        isSolved = newton(e, block) || (n == 1 && bracketForOne(e, block, e->start[0]));
    }
    for (k = 0; k < tries && !isSolved; ++k) {
        for (i = 0; i < n; ++i) e->start[i] = e->v[block->starts[i]] + offsets[k] * block->nominal[i];
        isSolved = newton(e, block) || (n == 1 && k == 0 && bracketForOne(e, block, e->start[0]));
    }
    if (!isSolved) {
        e->failure = block->name;
        return 0;
    }
    for (i = 0; i < n; ++i) {
        e->guess[block->guess + i] = e->v[block->unknowns[i]];
        e->hasGuess[block->guess + i] = 1;
    }
    return 1;
}

typedef struct {
    int place;
    const char* name;
} Watched;

static inline int allFinite(const double* values, int count) {
    int i;
    for (i = 0; i < count; ++i)
        if (!isfinite(values[i])) return 0;
    return 1;
}

/* Names the first unknown that is not finite. */
static inline int blame(Equations* e, const Watched* watched, int count) {
    int i;
    e->failure = "a result";
    for (i = 0; i < count; ++i)
        if (!isfinite(e->v[watched[i].place])) {
            e->failure = watched[i].name;
            break;
        }
    return 0;
}
