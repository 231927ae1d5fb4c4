/* The functions of FMI 2.0 around the equations of the model: Co-Simulation with an integrator of its own, and Model
   Exchange. All state lies in the instance, so any number of instances live side by side. */

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "description.h"
#include "equations.h"
#include "fmi2.h"

enum { VALUES = PARAMETERS + INPUTS + OUTPUTS + 2 * STATES };
enum { firstInput = PARAMETERS, firstOutput = firstInput + INPUTS, firstState = firstOutput + OUTPUTS };
enum { firstDerivative = firstState + STATES };

typedef enum { instantiated, initializationMode, eventMode, continuousTimeMode, stepComplete, terminated } Phase;

/* What a signal was, as a line through points; two points of one time are a jump. */
typedef struct {
    int count, capacity;
    double *time, *value;
} History;

/* The surfaces on which relations switch and that hold the motion between them. */
typedef struct {
    int count, hasDistances;
    int root[AT_LEAST_ONE(ROOTS)];        /* its place among the root functions */
    double distance[AT_LEAST_ONE(ROOTS)]; /* |r| at which the relations are clearly decided */
    double share[AT_LEAST_ONE(ROOTS)];    /* of the far side in the mean */
    double gradient[AT_LEAST_ONE(ROOTS * STATES)], back[AT_LEAST_ONE(ROOTS * STATES)];
    double change[AT_LEAST_ONE(ROOTS * STATES)], matrix[AT_LEAST_ONE(ROOTS * ROOTS)];
    double r[AT_LEAST_ONE(ROOTS)], along[AT_LEAST_ONE(ROOTS)], scale[AT_LEAST_ONE(ROOTS)];
    double above[AT_LEAST_ONE(ROOTS)], below[AT_LEAST_ONE(ROOTS)];
    double onto[AT_LEAST_ONE(STATES)], beside[AT_LEAST_ONE(STATES)], rate[AT_LEAST_ONE(STATES)];
    int pivots[AT_LEAST_ONE(ROOTS)];
} Sliding;

/* Who runs the instance. */
typedef struct {
    fmi2CallbackFunctions callbacks;
    char* name; /* of the instance */
    int isLogging;
} Host;

typedef struct {
    Host host;
    Equations equations;
    fmi2Type type;
    Phase phase;

    double time, startTime, stopTime, tolerance;
    int hasStopTime;
    double p[AT_LEAST_ONE(PARAMETERS)];
    double u[AT_LEAST_ONE(INPUTS)], slope[AT_LEAST_ONE(INPUTS)]; /* inputs from inputTime on, as lines */
    double inputTime;
    double x[AT_LEAST_ONE(STATES)], xdot[AT_LEAST_ONE(STATES)];
    double y[AT_LEAST_ONE(OUTPUTS)];
    double slots[AT_LEAST_ONE(SLOTS)];
    int areParametersNew, isStartNew, areOutputsOld, areDerivativesOld;

    double delay[AT_LEAST_ONE(DELAYS)];
    History inputs[AT_LEAST_ONE(DELAYS > 0 ? INPUTS : 0)], taps[AT_LEAST_ONE(TAPS)];

    double step; /* of the integrator, as the last one suggests */
    Sliding sliding;
    double jacobian[AT_LEAST_ONE(STATES * STATES)], matrix[AT_LEAST_ONE(STATES * STATES)];
    double scale[AT_LEAST_ONE(STATES)];
    int pivots[AT_LEAST_ONE(STATES)];
    double stage[6][AT_LEAST_ONE(STATES)];
    double rate[AT_LEAST_ONE(STATES)], moved[AT_LEAST_ONE(STATES)], at[AT_LEAST_ONE(STATES)];
    double along[AT_LEAST_ONE(STATES)], next[AT_LEAST_ONE(STATES)];
    double rootBefore[AT_LEAST_ONE(ROOTS)], rootAfter[AT_LEAST_ONE(ROOTS)];
    unsigned char isTouched[AT_LEAST_ONE(ROOTS)]; /* switched at the end of a step or on the way */
} Instance;

/* ---- messages and memory ---- */

static fmi2Status say(const Host* host, fmi2Status status, const char* text, ...) {
    char message[512];
    va_list arguments;
    if (!host->callbacks.logger || (status < fmi2Error && !host->isLogging)) return status;
    va_start(arguments, text);
    vsnprintf(message, sizeof message, text, arguments);
    va_end(arguments);
    host->callbacks.logger(host->callbacks.componentEnvironment, host->name, status,
                           status == fmi2Discard ? "logStatusDiscard" : "logStatusError", "%s", message);
    return status;
}

/* An array that must be there, unless nothing is in it. */
static int isMissing(const Instance* m, const char* function, const void* array, size_t count) {
    if (array || count == 0) return 0;
    say(&m->host, fmi2Error, "%s: an array is missing", function);
    return 1;
}

static fmi2Status notSolved(Instance* m, fmi2Status status) {
    return say(&m->host, status, "no solution at t = %g s: %s", m->time,
               m->equations.failure ? m->equations.failure : "a result is not finite");
}

static void* allocate(const Host* host, size_t count, size_t size) {
    return host->callbacks.allocateMemory ? host->callbacks.allocateMemory(count, size) : calloc(count, size);
}

static void release(const Host* host, void* memory) {
    if (!memory) return;
    if (host->callbacks.freeMemory)
        host->callbacks.freeMemory(memory);
    else
        free(memory);
}

/* ---- delayed signals ---- */

static void clear(const Host* host, History* h) {
    release(host, h->time);
    release(host, h->value);
    memset(h, 0, sizeof *h);
}

/* Points before `needed` are forgotten, but for the last of them. */
static int remember(const Host* host, History* h, double time, double value, double needed) {
    if (h->count > 0 && h->time[h->count - 1] == time && h->value[h->count - 1] == value) return 1;
    if (h->count == h->capacity) {
        int old = 0;
        while (old + 1 < h->count && h->time[old + 1] < needed) ++old;
        if (2 * old > h->capacity) {
            h->count -= old;
            memmove(h->time, h->time + old, (size_t)h->count * sizeof(double));
            memmove(h->value, h->value + old, (size_t)h->count * sizeof(double));
        } else {
            const int capacity = 2 * h->capacity + 256;
            double* const times = (double*)allocate(host, (size_t)capacity, sizeof(double));
            double* const values = (double*)allocate(host, (size_t)capacity, sizeof(double));
            if (!times || !values) {
                release(host, times);
                release(host, values);
                return 0;
            }
            if (h->count > 0) {
                memcpy(times, h->time, (size_t)h->count * sizeof(double));
                memcpy(values, h->value, (size_t)h->count * sizeof(double));
            }
            release(host, h->time);
            release(host, h->value);
            h->time = times;
            h->value = values;
            h->capacity = capacity;
        }
    }
    h->time[h->count] = time;
    h->value[h->count] = value;
    ++h->count;
    return 1;
}

/* The last point at or before a time; -1: none. */
static int lastBefore(const History* h, double time) {
    int low = -1, high = h->count;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (h->time[middle] <= time)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Before the first point its value, after the last one that. */
static double recall(const History* h, double time) {
    const int i = lastBefore(h, time);
    if (i < 0) return h->value[0];
    if (i + 1 == h->count) return h->value[i];
    return h->value[i] + (h->value[i + 1] - h->value[i]) * (time - h->time[i]) / (h->time[i + 1] - h->time[i]);
}

/* How far back a signal is asked for: an input, or from INPUTS on a tap. */
static double longestDelay(const double* delay, int signal) {
    double longest = 0;
    int d;
    for (d = 0; d < DELAYS; ++d)
        if ((delayedInput[d] >= 0 ? delayedInput[d] : INPUTS + delayedTap[d]) == signal)
            longest = fmax(longest, delay[d]);
    return longest;
}

static int rememberInputs(Instance* m, double time) {
    int d;
    for (d = 0; d < DELAYS; ++d) {
        const int i = delayedInput[d];
        if (i >= 0 && !remember(&m->host, &m->inputs[i], time, m->u[i] + m->slope[i] * (time - m->inputTime),
                                time - longestDelay(m->delay, i)))
            return 0;
    }
    return 1;
}

/* ---- evaluation ---- */

static void setSlots(Instance* m, double t) {
    int i, d;
    for (i = 0; i < INPUTS; ++i) m->slots[i] = m->u[i] + m->slope[i] * (t - m->inputTime);
    for (i = 0; i < INPUT_SLOPES; ++i) m->slots[INPUTS + i] = m->slope[i];
    for (d = 0; d < DELAYS; ++d) {
        const double past = t - m->delay[d];
        const int input = delayedInput[d];
        const History* const h = input >= 0 ? &m->inputs[input] : &m->taps[delayedTap[d]];
        double value = input >= 0 ? m->u[input] : 0;
        if (input >= 0 && past >= m->inputTime && m->phase > initializationMode)
            value += m->slope[input] * (past - m->inputTime);
        else if (h->count > 0)
            value = recall(h, past);
        m->slots[INPUTS + INPUT_SLOPES + d] = value;
    }
}

/* Brings parameters, and before the start the states, up to date. */
static int prepare(Instance* m) {
    if (m->areParametersNew) {
        if (!setParameters(&m->equations, m->p)) return 0;
        delayTimes(&m->equations, m->delay);
        m->areParametersNew = 0;
        m->areOutputsOld = m->areDerivativesOld = 1;
    }
    if (m->phase <= initializationMode && m->isStartNew) {
        setSlots(m, m->time);
        if (!initialise(&m->equations, m->time, m->slots, m->x)) return 0;
        m->isStartNew = 0;
        m->areOutputsOld = m->areDerivativesOld = 1;
    }
    return 1;
}

static int fieldAt(Instance* m, double t, const double* x, double* xdot) {
    setSlots(m, t);
    return derivatives(&m->equations, t, x, m->slots, xdot);
}

static int relationsAt(Instance* m, double t, const double* x, double* values) {
    setSlots(m, t);
    return roots(&m->equations, t, x, m->slots, values);
}

/* ---- motion along switching surfaces (Co-Simulation) ----
   A brake that holds, a thermostat that would chatter: where the field on either side leads back to the surface, the
   motion follows the mean of both that stays on it (Filippov, Differential Equations with Discontinuous Righthand
   Sides, 1988). With several surfaces at a time the field on the side r > 0 of all is taken, and what crossing each of
   them alone changes. */

/* The point on all surfaces, moved to the side r > 0 of them; of one (-1: none) to the other side. */
static const double* besideSurfaces(Sliding* s, int other) {
    int i, j;
    for (i = 0; i < STATES; ++i) {
        s->beside[i] = s->onto[i];
        for (j = 0; j < s->count; ++j) s->beside[i] += (j == other ? -1 : 1) * s->distance[j] * s->back[j * STATES + i];
    }
    return s->beside;
}

/* Distances at which every relation is seen from its side in spite of rounding. */
static int findDistances(Instance* m, double t) {
    Sliding* const s = &m->sliding;
    int i, j, other, tries;
    for (j = 0; j < s->count; ++j) {
        double size = 0;
        for (i = 0; i < STATES; ++i) size += fabs(s->gradient[j * STATES + i]) * (fabs(s->onto[i]) + stateNominal[i]);
        s->distance[j] = 64 * DBL_EPSILON * size;
    }
    for (tries = 0; tries < 8; ++tries) {
        int isClear = 1;
        for (other = -1; other < s->count; ++other) {
            if (!relationsAt(m, t, besideSurfaces(s, other), s->above)) return 0;
            for (j = 0; j < s->count; ++j)
                if ((j == other ? -1 : 1) * s->above[s->root[j]] < 0.25 * s->distance[j]) {
                    isClear = 0;
                    s->distance[j] *= 8;
                }
        }
        if (isClear) return 1;
    }
    return 0;
}

/* The mean field; its shares and the point on the surfaces stay in m->sliding. What is left of r by rounding dies
   away. */
static int slidingField(Instance* m, double t, const double* x, double* mean) {
    static const double decay = 100; /* [1/s] */
    Sliding* const s = &m->sliding;
    const int n = s->count;
    const double shift = 1e-6 * fmax(fabs(t), 1e-3);
    int i, j, k;
    memcpy(s->beside, x, sizeof s->beside);
    for (i = 0; i < STATES; ++i) {
        /* Central differences: exact but for rounding where r is linear in the states, as it mostly is. */
        const double size = ldexp(1.0, (int)floor(log2(fmax(fabs(x[i]), stateNominal[i])) + 0.5) - 10);
        s->beside[i] = x[i] + size;
        if (!relationsAt(m, t, s->beside, s->above)) return 0;
        s->beside[i] = x[i] - size;
        if (!relationsAt(m, t, s->beside, s->below)) return 0;
        s->beside[i] = x[i];
        for (j = 0; j < n; ++j)
            s->gradient[j * STATES + i] = (s->above[s->root[j]] - s->below[s->root[j]]) / (2 * size);
    }
    if (!relationsAt(m, t + shift, x, s->above) || !relationsAt(m, t - shift, x, s->below)) return 0;
    for (j = 0; j < n; ++j) s->along[j] = (s->above[s->root[j]] - s->below[s->root[j]]) / (2 * shift);
    if (!relationsAt(m, t, x, s->above)) return 0;
    for (j = 0; j < n; ++j) s->r[j] = s->above[s->root[j]];
    /* The way back onto the surfaces, shortest in nominal values. */
    for (j = 0; j < n; ++j)
        for (k = 0; k < n; ++k) {
            double sum = 0;
            for (i = 0; i < STATES; ++i)
                sum += s->gradient[j * STATES + i] * stateNominal[i] * stateNominal[i] * s->gradient[k * STATES + i];
            s->matrix[j * n + k] = sum;
        }
    if (!factorise(s->matrix, s->pivots, s->scale, n)) return 0;
    for (i = 0; i < STATES; ++i) {
        for (j = 0; j < n; ++j) s->above[j] = stateNominal[i] * stateNominal[i] * s->gradient[j * STATES + i];
        substitute(s->matrix, s->pivots, s->above, n);
        s->onto[i] = x[i];
        for (j = 0; j < n; ++j) {
            s->back[j * STATES + i] = s->above[j];
            s->onto[i] -= s->above[j] * s->r[j];
        }
    }
    if (!s->hasDistances && !(s->hasDistances = findDistances(m, t))) return 0;

    if (!fieldAt(m, t, besideSurfaces(s, -1), mean)) return 0;
    for (j = 0; j < n; ++j) {
        if (!fieldAt(m, t, besideSurfaces(s, j), s->rate)) return 0;
        for (i = 0; i < STATES; ++i) s->change[j * STATES + i] = s->rate[i] - mean[i];
    }
    for (j = 0; j < n; ++j) {
        s->share[j] = -s->along[j];
        for (i = 0; i < STATES; ++i) s->share[j] -= s->gradient[j * STATES + i] * mean[i];
        for (k = 0; k < n; ++k) {
            double sum = 0;
            for (i = 0; i < STATES; ++i) sum += s->gradient[j * STATES + i] * s->change[k * STATES + i];
            s->matrix[j * n + k] = sum;
            if (j == k && !(sum > 0)) return 0; /* leads away: no motion on the surface */
        }
    }
    if (!factorise(s->matrix, s->pivots, s->scale, n)) return 0;
    substitute(s->matrix, s->pivots, s->share, n);
    for (i = 0; i < STATES; ++i)
        for (j = 0; j < n; ++j)
            mean[i] += s->share[j] * s->change[j * STATES + i] - decay * s->back[j * STATES + i] * s->r[j];
    return allFinite(s->share, n) && allFinite(mean, STATES);
}

static int ratesAt(Instance* m, double t, const double* x, double* xdot) {
    return m->sliding.count > 0 ? slidingField(m, t, x, xdot) : fieldAt(m, t, x, xdot);
}

/* The root functions; those of held surfaces are positive while the motion stays on them. */
static int rootsAt(Instance* m, double t, const double* x, double* values) {
    static const double leaveBeyond = 1e-8; /* a share this far beyond its end: the field clearly leads away */
    double unused[AT_LEAST_ONE(STATES)];
    Sliding* const s = &m->sliding;
    int j;
    if (!relationsAt(m, t, x, values)) return 0;
    if (s->count == 0) return 1;
    if (!slidingField(m, t, x, unused)) return 0;
    for (j = 0; j < s->count; ++j) values[s->root[j]] = fmin(s->share[j], 1 - s->share[j]) + leaveBeyond;
    return 1;
}

static int isHeld(const Sliding* s, int root) {
    int j;
    for (j = 0; j < s->count; ++j)
        if (s->root[j] == root) return 1;
    return 0;
}

/* Leaves the surfaces whose mean has come to one side; the state goes there, clear of the others. */
static void leaveSurfaces(Instance* m, double t) {
    static const double clearOf = 256;
    double unused[AT_LEAST_ONE(STATES)];
    Sliding* const s = &m->sliding;
    const int count = s->count;
    int i, j;
    if (count == 0) return;
    if (!slidingField(m, t, m->x, unused)) {
        s->count = 0;
        return;
    }
    s->count = 0;
    for (j = 0; j < count; ++j) {
        const double share = s->share[j];
        if (share > 0 && share < 1) {
            s->root[s->count++] = s->root[j];
            continue;
        }
        for (i = 0; i < STATES; ++i)
            m->x[i] += (share <= 0 ? 1 : -1) * clearOf * s->distance[j] * s->back[j * STATES + i];
    }
    s->hasDistances = 0;
}

/* Takes a surface among those that hold the motion, if it attracts from both sides. */
static void joinSurface(Instance* m, double t, int root) {
    double unused[AT_LEAST_ONE(STATES)];
    Sliding* const s = &m->sliding;
    int j, holds;
    if (isHeld(s, root) || s->count == ROOTS) return;
    s->root[s->count++] = root;
    s->hasDistances = 0;
    holds = slidingField(m, t, m->x, unused);
    for (j = 0; j < s->count; ++j) holds = holds && s->share[j] > 0 && s->share[j] < 1;
    if (holds)
        memcpy(m->x, s->onto, sizeof m->x);
    else
        --s->count;
    s->hasDistances = s->hasDistances && holds;
}

/* A delayed signal of the model's own is kept as it is now; before the start it has always been what it is there. */
static int rememberTaps(Instance* m, double t, const double* x) {
#if TAPS > 0
    double values[TAPS];
    int i;
    setSlots(m, t);
    if (!outputs(&m->equations, t, x, m->slots, m->y) || !taps(&m->equations, values)) return 0;
    for (i = 0; i < TAPS; ++i)
        if (!remember(&m->host, &m->taps[i], t, values[i], t - longestDelay(m->delay, INPUTS + i))) return 0;
#else
    (void)m;
    (void)t;
    (void)x;
#endif
    return 1;
}

static int refreshOutputs(Instance* m) {
    if (!prepare(m)) return 0;
    if (!m->areOutputsOld) return 1;
    if (m->phase <= initializationMode) {
        int i;
        for (i = 0; i < TAPS; ++i) m->taps[i].count = 0;
        if (!rememberTaps(m, m->time, m->x)) return 0;
    }
    setSlots(m, m->time);
    if (!outputs(&m->equations, m->time, m->x, m->slots, m->y)) return 0;
    m->areOutputsOld = 0;
    return 1;
}

static int refreshDerivatives(Instance* m) {
    if (!prepare(m)) return 0;
    if (!m->areDerivativesOld) return 1;
    if (!ratesAt(m, m->time, m->x, m->xdot)) return 0;
    m->areDerivativesOld = 0;
    return 1;
}

/* ---- integration (Co-Simulation) ----
   RODAS, a Rosenbrock method of order 4(3) (Hairer & Wanner, Solving Ordinary Differential Equations II, section
   IV.7): L-stable, so that stiff models take no small steps, and without an inner iteration that could fail where
   friction or a valve bends the field. One Jacobian a step by differences. */

static const double rodasGamma = 0.25;
static const double rodasA[5][5] = {
    {0},
    {1.544},
    {0.9466785280815826, 0.2557011698983284},
    {3.314825187068521, 2.896124015972201, 0.9986419139977817},
    {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
};
static const double rodasC[6][5] = {
    {0},
    {-5.6688},
    {-2.430093356833875, -0.2063599157091915},
    {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
    {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
    {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054},
};
static const double rodasTime[6] = {0, 0.386, 0.21, 0.63, 1, 1};
static const double rodasD[6] = {0.25, -0.1043, 0.1035, -0.0362, 0, 0};

static int isCrossed(const Instance* m, int root) {
    return m->rootBefore[root] != 0 && (m->rootBefore[root] > 0) != (m->rootAfter[root] > 0);
}

/* Notes the relations that are on their other side at a point of a step, those of held surfaces left out. */
static int touch(Instance* m, double t, const double* x, int* isTouched) {
    int i;
    *isTouched = 0;
    if (ROOTS == 0) return 1;
    if (!relationsAt(m, t, x, m->rootAfter)) return 0;
    for (i = 0; i < ROOTS; ++i)
        if (isCrossed(m, i) && !isHeld(&m->sliding, i)) *isTouched = m->isTouched[i] = 1;
    return 1;
}

/* Jacobian and the rate of the rates in time, at (t, x) where the rates are m->rate. Differences stay on
   this side of every switch: across one they would say that the model is infinitely stiff. */
static int linearise(Instance* m, double t, double h) {
    const double root = sqrt(DBL_EPSILON);
    int i, j, isAcross;
    double later = t + root * fmax(fabs(t), h);
    memcpy(m->moved, m->x, sizeof m->moved);
    for (j = 0; j < STATES; ++j) {
        const double size = root * fmax(fabs(m->x[j]), stateNominal[j]);
        m->moved[j] = m->x[j] + (m->x[j] < 0 ? -size : size);
        if (!touch(m, t, m->moved, &isAcross)) return 0;
        if (isAcross) m->moved[j] = m->x[j] - (m->moved[j] - m->x[j]);
        if (!ratesAt(m, t, m->moved, m->along)) return 0;
        for (i = 0; i < STATES; ++i) m->jacobian[i * STATES + j] = (m->along[i] - m->rate[i]) / (m->moved[j] - m->x[j]);
        m->moved[j] = m->x[j];
    }
    if (!ratesAt(m, later, m->x, m->along)) return 0;
    for (i = 0; i < STATES; ++i) m->along[i] = (m->along[i] - m->rate[i]) / (later - t);
    return allFinite(m->jacobian, STATES * STATES) && allFinite(m->along, STATES);
}

/* One step from (t, x) to m->next; *error: its estimated error over what is tolerated. */
static int tryStep(Instance* m, double t, double h, double* error) {
    int i, j, k, isAcross;
    memset(m->isTouched, 0, sizeof m->isTouched);
    for (i = 0; i < STATES; ++i)
        for (j = 0; j < STATES; ++j)
            m->matrix[i * STATES + j] = (i == j ? 1 / (h * rodasGamma) : 0) - m->jacobian[i * STATES + j];
    if (!factorise(m->matrix, m->pivots, m->scale, STATES)) return 0;
    for (k = 0; k < 6; ++k) {
        double* const stage = m->stage[k];
        if (k < 5) {
            for (i = 0; i < STATES; ++i) {
                m->at[i] = m->x[i];
                for (j = 0; j < k; ++j) m->at[i] += rodasA[k][j] * m->stage[j][i];
            }
        } else {
            for (i = 0; i < STATES; ++i) m->at[i] += m->stage[4][i];
        }
        if (k == 0)
            memcpy(stage, m->rate, sizeof m->rate);
        else if (!touch(m, t + rodasTime[k] * h, m->at, &isAcross) || !ratesAt(m, t + rodasTime[k] * h, m->at, stage))
            return 0;
        for (i = 0; i < STATES; ++i) {
            stage[i] += h * rodasD[k] * m->along[i];
            for (j = 0; j < k; ++j) stage[i] += rodasC[k][j] / h * m->stage[j][i];
        }
        substitute(m->matrix, m->pivots, stage, STATES);
    }
    *error = 0;
    for (i = 0; i < STATES; ++i) {
        const double last = m->stage[5][i];
        m->next[i] = m->at[i] + last;
        *error = fmax(*error, fabs(last) / (m->tolerance * fmax(fabs(m->x[i]), fabs(m->next[i])) +
                                            1e-3 * m->tolerance * stateNominal[i]));
    }
    return allFinite(m->next, STATES) && isfinite(*error);
}

/* The end of a step that was tried: its root functions and all that switched. */
static int touchEnd(Instance* m, double t, int* isSwitched) {
    int i;
    *isSwitched = 0;
    if (ROOTS == 0 || STATES == 0) return 1;
    if (!rootsAt(m, t, m->next, m->rootAfter)) return 0;
    for (i = 0; i < ROOTS; ++i) {
        if (isCrossed(m, i)) m->isTouched[i] = 1;
        if (m->isTouched[i]) *isSwitched = 1;
    }
    return 1;
}

/* After a step that switched: surfaces are left, and taken where they hold the motion. */
static int meetSurfaces(Instance* m, double t) {
    int i, isLeft = 0;
    for (i = 0; i < ROOTS; ++i)
        if (m->isTouched[i] && isHeld(&m->sliding, i)) isLeft = 1, m->isTouched[i] = 0;
    if (isLeft) leaveSurfaces(m, t);
    for (i = 0; i < ROOTS; ++i)
        if (m->isTouched[i]) joinSurface(m, t, i);
    return rootsAt(m, t, m->x, m->rootAfter);
}

/* Where the next point of a delayed input arrives: the integrator steps onto it. */
static double nextArrival(const Instance* m, double t, double end) {
    const double least = fmax(1e-9 * (end - t), 64 * DBL_EPSILON * fabs(end));
    double next = end;
    int d;
    for (d = 0; d < DELAYS; ++d) {
        const History* h;
        int i;
        if (delayedInput[d] < 0) continue;
        h = &m->inputs[delayedInput[d]];
        i = lastBefore(h, t - m->delay[d] + least) + 1;
        if (i < h->count && h->time[i] + m->delay[d] < next - least) next = h->time[i] + m->delay[d];
    }
    return next;
}

/* Delayed signals need points between the ends of a step: of the cubic through states and rates there. */
static int rememberTapsWithin(Instance* m, double t, double h, const double* before, const double* rateBefore) {
#if TAPS > 0
    enum { pieces = 24 };
    int k, i;
    for (k = 1; k < pieces; ++k) {
        const double s = (double)k / pieces, r = 1 - s;
        for (i = 0; i < STATES; ++i)
            m->at[i] = r * r * (1 + 2 * s) * before[i] + s * s * (3 - 2 * s) * m->x[i] +
                       h * s * r * (r * rateBefore[i] - s * m->rate[i]);
        if (!rememberTaps(m, t + s * h, m->at)) return 0;
    }
    return rememberTaps(m, t + h, m->x);
#else
    (void)m;
    (void)t;
    (void)h;
    (void)before;
    (void)rateBefore;
    return 1;
#endif
}

/* From m->time to the end. Where a relation switches, steps are halved until one just crosses it. Where that, or the
   error, asks for ever more steps in a hundredth of the way (a field that jumps without saying so), steps of a fixed
   size lead on. */
static int integrate(Instance* m, double end) {
    enum { mostSwitches = 50, mostTries = 2000 };
    const double span = end - m->time, finest = 1e-6 * span;
    double before[AT_LEAST_ONE(STATES)], rateBefore[AT_LEAST_ONE(STATES)];
    double t = m->time, counted = t, error = 0;
    int switches = 0, tries = 0, mayGrow = 1;
    if (!(m->step > 0)) m->step = 0.01 * span;
    leaveSurfaces(m, t); /* inputs and parameters may have jumped */
    if (!ratesAt(m, t, m->x, m->rate)) return 0;
    if (ROOTS > 0 && !rootsAt(m, t, m->x, m->rootBefore)) return 0;
    while (end - t > 16 * DBL_EPSILON * fabs(end)) {
        const int isStuck = switches > mostSwitches || tries > mostTries;
        const double least = isStuck ? 1e-4 * span : ROOTS > 0 ? 0.1 * finest : 0;
        const double floor = fmax(least, 16 * DBL_EPSILON * fmax(fabs(t), span));
        double stop = nextArrival(m, t, end), h = fmax(m->step, floor);
        const int isLinearised = STATES == 0 || linearise(m, t, h);
        int isDone = 0;
        if (STATES == 0) h = stop - t;
        while (!isDone) {
            const int reaches = t + h * (1 + 1e-6) >= stop;
            int isGood, isSwitched = 0;
            ++tries;
            if (reaches) h = stop - t;
            isGood = STATES == 0 || (isLinearised && tryStep(m, t, h, &error));
            isGood = isGood && touchEnd(m, reaches ? stop : t + h, &isSwitched);
            if (!isGood) {
                if (h <= floor && m->sliding.count > 0) {
                    m->sliding.count = 0;
                    ++switches;
                    if (!ratesAt(m, t, m->x, m->rate) || !rootsAt(m, t, m->x, m->rootBefore)) return 0;
                    break;
                }
                if (h <= floor) {
                    m->time = t;
                    return 0;
                }
                m->step = h = fmax(0.25 * h, floor);
                mayGrow = 0;
            } else if (error > 1 && h > floor) {
                m->step = h = fmax(h * fmax(0.2, 0.9 * pow(error, -0.25)), floor);
                mayGrow = 0;
            } else if (isSwitched && h > fmax(finest, floor) && !isStuck) {
                m->step = h = fmax(0.5 * h, fmax(finest, floor));
                mayGrow = 0;
            } else {
                const double grown = h * fmin(mayGrow ? 5.0 : 1.0, 0.9 * pow(fmax(error, 1e-8), -0.25));
                const double from = t;
                memcpy(before, m->x, sizeof before);
                memcpy(rateBefore, m->rate, sizeof rateBefore);
                if (STATES > 0) memcpy(m->x, m->next, sizeof m->x);
                /* A step cut short by the end says nothing against the one before it. */
                if (!reaches || grown > m->step) m->step = grown;
                t = reaches ? stop : t + h;
                m->time = t;
                if (ROOTS > 0 && (isSwitched || h <= finest)) ++switches;
                if (isSwitched && !isStuck && !meetSurfaces(m, t)) return 0;
                memcpy(m->rootBefore, m->rootAfter, sizeof m->rootBefore);
                if (!ratesAt(m, t, m->x, m->rate)) return 0;
                if (!rememberTapsWithin(m, from, t - from, before, rateBefore)) return 0;
                mayGrow = isDone = 1;
                if (t - counted > 0.01 * span) {
                    counted = t;
                    switches = tries = 0;
                }
            }
        }
    }
    return 1;
}

/* ---- common functions ---- */

FMI2_FUNCTION(const char*, fmi2GetTypesPlatform)(void) { return "default"; }
FMI2_FUNCTION(const char*, fmi2GetVersion)(void) { return "2.0"; }

static void toStart(Instance* m) {
    int i;
    m->phase = instantiated;
    m->time = m->startTime = m->inputTime = 0;
    m->tolerance = defaultTolerance;
    m->hasStopTime = 0;
    m->step = 0;
    m->sliding.count = 0;
    memset(&m->equations, 0, sizeof m->equations);
    memset(m->slope, 0, sizeof m->slope);
    if (PARAMETERS > 0) memcpy(m->p, parameterStart, sizeof m->p);
    if (INPUTS > 0) memcpy(m->u, inputStart, sizeof m->u);
    for (i = 0; i < (int)(sizeof m->inputs / sizeof *m->inputs); ++i) m->inputs[i].count = 0;
    for (i = 0; i < (int)(sizeof m->taps / sizeof *m->taps); ++i) m->taps[i].count = 0;
    m->areParametersNew = m->isStartNew = m->areOutputsOld = m->areDerivativesOld = 1;
}

FMI2_FUNCTION(fmi2Component, fmi2Instantiate)
(fmi2String instanceName, fmi2Type type, fmi2String guid, fmi2String resources, const fmi2CallbackFunctions* callbacks,
 fmi2Boolean visible, fmi2Boolean loggingOn) {
    Host host;
    Instance* m;
    (void)resources;
    (void)visible;
    if (!callbacks) return NULL;
    host.callbacks = *callbacks;
    host.name = (char*)(instanceName ? instanceName : "");
    host.isLogging = loggingOn;
    if (!instanceName || !*instanceName) {
        say(&host, fmi2Error, "the instance needs a name");
        return NULL;
    }
    if (!guid || strcmp(guid, modelGuid) != 0) {
        say(&host, fmi2Error, "the modelDescription.xml is of another model: its guid is not %s", modelGuid);
        return NULL;
    }
    if (type == fmi2ModelExchange && !HAS_MODEL_EXCHANGE) {
        say(&host, fmi2Error, "this model is for Co-Simulation only: it needs the past of a signal or an input's rate");
        return NULL;
    }
    m = (Instance*)allocate(&host, 1, sizeof *m);
    if (!m) return NULL;
    memset(m, 0, sizeof *m);
    host.name = (char*)allocate(&host, strlen(instanceName) + 1, 1);
    if (!host.name) {
        release(&host, m);
        return NULL;
    }
    strcpy(host.name, instanceName);
    m->host = host;
    m->type = type;
    toStart(m);
    return m;
}

FMI2_FUNCTION(void, fmi2FreeInstance)(fmi2Component c) {
    Instance* const m = (Instance*)c;
    Host host;
    int i;
    if (!m) return;
    host = m->host;
    for (i = 0; i < (int)(sizeof m->inputs / sizeof *m->inputs); ++i) clear(&host, &m->inputs[i]);
    for (i = 0; i < (int)(sizeof m->taps / sizeof *m->taps); ++i) clear(&host, &m->taps[i]);
    release(&host, host.name);
    release(&host, m);
}

FMI2_FUNCTION(fmi2Status, fmi2SetDebugLogging)
(fmi2Component c, fmi2Boolean loggingOn, size_t count, const fmi2String categories[]) {
    (void)count;
    (void)categories;
    if (!c) return fmi2Error;
    ((Instance*)c)->host.isLogging = loggingOn;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SetupExperiment)
(fmi2Component c, fmi2Boolean toleranceDefined, fmi2Real tolerance, fmi2Real startTime, fmi2Boolean stopTimeDefined,
 fmi2Real stopTime) {
    Instance* const m = (Instance*)c;
    if (!m) return fmi2Error;
    if (m->phase != instantiated) return say(&m->host, fmi2Error, "the experiment is set up before the initialization");
    if (!isfinite(startTime) || (stopTimeDefined && !(isfinite(stopTime) && stopTime >= startTime)))
        return say(&m->host, fmi2Error, "fmi2SetupExperiment: there is no time from %g s to %g s", startTime,
                   stopTimeDefined ? stopTime : startTime);
    if (toleranceDefined && tolerance > 0 && isfinite(tolerance)) m->tolerance = fmax(tolerance, 1e-12);
    m->startTime = m->time = m->inputTime = startTime;
    m->hasStopTime = stopTimeDefined;
    m->stopTime = stopTime;
    m->isStartNew = 1;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2EnterInitializationMode)(fmi2Component c) {
    Instance* const m = (Instance*)c;
    if (!m) return fmi2Error;
    if (m->phase != instantiated)
        return say(&m->host, fmi2Error, "fmi2EnterInitializationMode: the instance has started");
    m->phase = initializationMode;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2ExitInitializationMode)(fmi2Component c) {
    Instance* const m = (Instance*)c;
    if (!m) return fmi2Error;
    if (m->phase != initializationMode) return say(&m->host, fmi2Error, "fmi2ExitInitializationMode: not in that mode");
    if (!refreshOutputs(m) || !rememberInputs(m, m->time)) return notSolved(m, fmi2Error);
    m->phase = m->type == fmi2ModelExchange ? eventMode : stepComplete;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2Terminate)(fmi2Component c) {
    if (!c) return fmi2Error;
    ((Instance*)c)->phase = terminated;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2Reset)(fmi2Component c) {
    if (!c) return fmi2Error;
    toStart((Instance*)c);
    return fmi2OK;
}

/* ---- values ---- */

FMI2_FUNCTION(fmi2Status, fmi2GetReal)
(fmi2Component c, const fmi2ValueReference references[], size_t count, fmi2Real values[]) {
    Instance* const m = (Instance*)c;
    size_t i;
    if (!m) return fmi2Error;
    if (isMissing(m, "fmi2GetReal", references, count) || isMissing(m, "fmi2GetReal", values, count)) return fmi2Error;
    for (i = 0; i < count; ++i) {
        const int r = (int)references[i];
        if (r < 0 || r >= VALUES) return say(&m->host, fmi2Error, "fmi2GetReal: there is no value reference %d", r);
        if (r < firstInput) {
            values[i] = m->p[r];
        } else if (r < firstOutput) {
            values[i] = m->u[r - firstInput];
        } else if (r < firstState) {
            if (!refreshOutputs(m)) return notSolved(m, fmi2Discard);
            values[i] = m->y[r - firstOutput];
        } else if (r < firstDerivative) {
            if (!prepare(m)) return notSolved(m, fmi2Discard);
            values[i] = m->x[r - firstState];
        } else {
            if (!refreshDerivatives(m)) return notSolved(m, fmi2Discard);
            values[i] = m->xdot[r - firstDerivative];
        }
    }
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SetReal)
(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Real values[]) {
    Instance* const m = (Instance*)c;
    size_t i;
    if (!m) return fmi2Error;
    if (isMissing(m, "fmi2SetReal", references, count) || isMissing(m, "fmi2SetReal", values, count)) return fmi2Error;
    for (i = 0; i < count; ++i) {
        const int r = (int)references[i];
        if (r < 0 || r >= firstOutput)
            return say(&m->host, fmi2Error, "fmi2SetReal: value reference %d is neither a parameter nor an input", r);
        if (!isfinite(values[i]))
            return say(&m->host, fmi2Error, "fmi2SetReal: %g is no value for value reference %d", values[i], r);
        if (r < firstInput) {
            if (m->p[r] == values[i]) continue;
            if (isFixed[r] && m->phase > initializationMode)
                return say(&m->host, fmi2Error,
                           "fmi2SetReal: the parameter with value reference %d is fixed after the start", r);
            m->p[r] = values[i];
            m->areParametersNew = 1;
        } else {
            m->u[r - firstInput] = values[i];
        }
        m->isStartNew = m->areOutputsOld = m->areDerivativesOld = 1;
    }
    return fmi2OK;
}

/* The model has variables of type Real alone. */
#define NO_VALUES(kind, type)                                                                     \
    FMI2_FUNCTION(fmi2Status, fmi2Get##kind)                                                      \
    (fmi2Component c, const fmi2ValueReference references[], size_t count, type values[]) {       \
        (void)references;                                                                         \
        (void)values;                                                                             \
        return c && count == 0 ? fmi2OK : fmi2Error;                                              \
    }                                                                                             \
    FMI2_FUNCTION(fmi2Status, fmi2Set##kind)                                                      \
    (fmi2Component c, const fmi2ValueReference references[], size_t count, const type values[]) { \
        (void)references;                                                                         \
        (void)values;                                                                             \
        return c && count == 0 ? fmi2OK : fmi2Error;                                              \
    }
NO_VALUES(Integer, fmi2Integer)
NO_VALUES(Boolean, fmi2Boolean)
NO_VALUES(String, fmi2String)

/* What modelDescription.xml says this model cannot do. */
static fmi2Status unsupported(fmi2Component c, const char* function) {
    return c ? say(&((Instance*)c)->host, fmi2Error, "%s is not supported", function) : fmi2Error;
}

FMI2_FUNCTION(fmi2Status, fmi2GetFMUstate)(fmi2Component c, fmi2FMUstate* state) {
    (void)state;
    return unsupported(c, "fmi2GetFMUstate");
}
FMI2_FUNCTION(fmi2Status, fmi2SetFMUstate)(fmi2Component c, fmi2FMUstate state) {
    (void)state;
    return unsupported(c, "fmi2SetFMUstate");
}
FMI2_FUNCTION(fmi2Status, fmi2FreeFMUstate)(fmi2Component c, fmi2FMUstate* state) {
    (void)state;
    return unsupported(c, "fmi2FreeFMUstate");
}
FMI2_FUNCTION(fmi2Status, fmi2SerializedFMUstateSize)(fmi2Component c, fmi2FMUstate state, size_t* size) {
    (void)state;
    (void)size;
    return unsupported(c, "fmi2SerializedFMUstateSize");
}
FMI2_FUNCTION(fmi2Status, fmi2SerializeFMUstate)
(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    (void)state;
    (void)bytes;
    (void)size;
    return unsupported(c, "fmi2SerializeFMUstate");
}
FMI2_FUNCTION(fmi2Status, fmi2DeSerializeFMUstate)
(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate* state) {
    (void)state;
    (void)bytes;
    (void)size;
    return unsupported(c, "fmi2DeSerializeFMUstate");
}
FMI2_FUNCTION(fmi2Status, fmi2GetDirectionalDerivative)
(fmi2Component c, const fmi2ValueReference unknowns[], size_t unknownCount, const fmi2ValueReference knowns[],
 size_t knownCount, const fmi2Real along[], fmi2Real result[]) {
    (void)unknowns;
    (void)unknownCount;
    (void)knowns;
    (void)knownCount;
    (void)along;
    (void)result;
    return unsupported(c, "fmi2GetDirectionalDerivative");
}

/* ---- Model Exchange ---- */

FMI2_FUNCTION(fmi2Status, fmi2EnterEventMode)(fmi2Component c) {
    if (!c) return fmi2Error;
    ((Instance*)c)->phase = eventMode;
    return fmi2OK;
}

/* Relations are evaluated as they stand, so there is nothing to iterate. */
FMI2_FUNCTION(fmi2Status, fmi2NewDiscreteStates)(fmi2Component c, fmi2EventInfo* info) {
    if (!c || !info) return fmi2Error;
    info->newDiscreteStatesNeeded = fmi2False;
    info->terminateSimulation = fmi2False;
    info->nominalsOfContinuousStatesChanged = fmi2False;
    info->valuesOfContinuousStatesChanged = fmi2False;
    info->nextEventTimeDefined = fmi2False;
    info->nextEventTime = 0;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2EnterContinuousTimeMode)(fmi2Component c) {
    if (!c) return fmi2Error;
    ((Instance*)c)->phase = continuousTimeMode;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2CompletedIntegratorStep)
(fmi2Component c, fmi2Boolean noStateIsSetBack, fmi2Boolean* enterEventMode, fmi2Boolean* terminateSimulation) {
    (void)noStateIsSetBack;
    if (!c || !enterEventMode || !terminateSimulation) return fmi2Error;
    *enterEventMode = fmi2False;
    *terminateSimulation = fmi2False;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SetTime)(fmi2Component c, fmi2Real time) {
    Instance* const m = (Instance*)c;
    if (!m) return fmi2Error;
    if (!isfinite(time)) return say(&m->host, fmi2Error, "fmi2SetTime: %g s is no time", time);
    m->time = m->inputTime = time;
    m->isStartNew = m->areOutputsOld = m->areDerivativesOld = 1;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2SetContinuousStates)(fmi2Component c, const fmi2Real x[], size_t count) {
    Instance* const m = (Instance*)c;
    if (!m) return fmi2Error;
    if (isMissing(m, "fmi2SetContinuousStates", x, count)) return fmi2Error;
    if (count != STATES) return say(&m->host, fmi2Error, "fmi2SetContinuousStates: the model has %d states", STATES);
    if (STATES > 0) memcpy(m->x, x, STATES * sizeof(double));
    m->areOutputsOld = m->areDerivativesOld = 1;
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetDerivatives)(fmi2Component c, fmi2Real xdot[], size_t count) {
    Instance* const m = (Instance*)c;
    if (!m) return fmi2Error;
    if (isMissing(m, "fmi2GetDerivatives", xdot, count)) return fmi2Error;
    if (count != STATES) return say(&m->host, fmi2Error, "fmi2GetDerivatives: the model has %d states", STATES);
    if (!refreshDerivatives(m)) return notSolved(m, fmi2Discard);
    if (STATES > 0) memcpy(xdot, m->xdot, STATES * sizeof(double));
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetEventIndicators)(fmi2Component c, fmi2Real indicators[], size_t count) {
    Instance* const m = (Instance*)c;
    if (!m) return fmi2Error;
    if (isMissing(m, "fmi2GetEventIndicators", indicators, count)) return fmi2Error;
    if (count != ROOTS) return say(&m->host, fmi2Error, "fmi2GetEventIndicators: the model has %d of them", ROOTS);
    if (ROOTS == 0) return fmi2OK;
    if (!prepare(m) || !rootsAt(m, m->time, m->x, indicators)) return notSolved(m, fmi2Discard);
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetContinuousStates)(fmi2Component c, fmi2Real x[], size_t count) {
    Instance* const m = (Instance*)c;
    if (!m) return fmi2Error;
    if (isMissing(m, "fmi2GetContinuousStates", x, count)) return fmi2Error;
    if (count != STATES) return say(&m->host, fmi2Error, "fmi2GetContinuousStates: the model has %d states", STATES);
    if (!prepare(m)) return notSolved(m, fmi2Discard);
    if (STATES > 0) memcpy(x, m->x, STATES * sizeof(double));
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetNominalsOfContinuousStates)(fmi2Component c, fmi2Real nominals[], size_t count) {
    Instance* const m = (Instance*)c;
    if (!m) return fmi2Error;
    if (isMissing(m, "fmi2GetNominalsOfContinuousStates", nominals, count)) return fmi2Error;
    if (count != STATES)
        return say(&m->host, fmi2Error, "fmi2GetNominalsOfContinuousStates: the model has %d states", STATES);
    if (STATES > 0) memcpy(nominals, stateNominal, STATES * sizeof(double));
    return fmi2OK;
}

/* ---- Co-Simulation ---- */

FMI2_FUNCTION(fmi2Status, fmi2SetRealInputDerivatives)
(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Integer orders[],
 const fmi2Real values[]) {
    Instance* const m = (Instance*)c;
    size_t i;
    if (!m) return fmi2Error;
    if (isMissing(m, "fmi2SetRealInputDerivatives", references, count) ||
        isMissing(m, "fmi2SetRealInputDerivatives", orders, count) ||
        isMissing(m, "fmi2SetRealInputDerivatives", values, count))
        return fmi2Error;
    for (i = 0; i < count; ++i) {
        const int r = (int)references[i];
        if (!isfinite(values[i]))
            return say(&m->host, fmi2Error, "fmi2SetRealInputDerivatives: %g is no slope for value reference %d",
                       values[i], r);
        if (r < firstInput || r >= firstOutput || orders[i] != 1)
            return say(&m->host, fmi2Error,
                       "fmi2SetRealInputDerivatives: the first derivative of an input is taken, no other");
        m->slope[r - firstInput] = values[i];
        m->areOutputsOld = m->areDerivativesOld = 1;
    }
    return fmi2OK;
}

FMI2_FUNCTION(fmi2Status, fmi2GetRealOutputDerivatives)
(fmi2Component c, const fmi2ValueReference references[], size_t count, const fmi2Integer orders[], fmi2Real values[]) {
    (void)references;
    (void)orders;
    (void)values;
    return count == 0 && c ? fmi2OK : unsupported(c, "fmi2GetRealOutputDerivatives");
}

FMI2_FUNCTION(fmi2Status, fmi2DoStep)
(fmi2Component c, fmi2Real currentCommunicationPoint, fmi2Real communicationStepSize,
 fmi2Boolean noSetFMUStatePriorToCurrentPoint) {
    Instance* const m = (Instance*)c;
    double end, slack;
    int i, isSolved;
    (void)noSetFMUStatePriorToCurrentPoint;
    if (!m) return fmi2Error;
    if (m->phase != stepComplete) return say(&m->host, fmi2Error, "fmi2DoStep: the slave is not initialized");
    end = currentCommunicationPoint + communicationStepSize;
    if (!(communicationStepSize > 0) || !isfinite(end))
        return say(&m->host, fmi2Error, "fmi2DoStep: a step of %g s leads nowhere", communicationStepSize);
    slack = 1e-9 * fmax(fabs(end), communicationStepSize);
    if (fabs(currentCommunicationPoint - m->time) > slack)
        return say(&m->host, fmi2Error, "fmi2DoStep: the slave is at t = %.9g s, not at %.9g s", m->time,
                   currentCommunicationPoint);
    if (m->hasStopTime && end > m->stopTime + slack)
        return say(&m->host, fmi2Error, "fmi2DoStep: the step ends after the stop time of %g s", m->stopTime);
    m->equations.failure = NULL;
    if (!prepare(m) || !rememberInputs(m, m->time)) return notSolved(m, fmi2Error);
    isSolved = integrate(m, end);
    if (isSolved) m->time = end;
    m->areOutputsOld = m->areDerivativesOld = 1;
    isSolved = isSolved && refreshOutputs(m) && refreshDerivatives(m) && rememberInputs(m, end);
    /* From here inputs stand still where they have come to, until they are set again. */
    for (i = 0; i < INPUTS; ++i) {
        m->u[i] += m->slope[i] * (m->time - m->inputTime);
        m->slope[i] = 0;
    }
    m->inputTime = m->time;
    return isSolved ? fmi2OK : notSolved(m, fmi2Discard);
}

FMI2_FUNCTION(fmi2Status, fmi2CancelStep)(fmi2Component c) { return unsupported(c, "fmi2CancelStep"); }

FMI2_FUNCTION(fmi2Status, fmi2GetStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Status* value) {
    (void)kind;
    (void)value;
    return c ? fmi2Discard : fmi2Error;
}
FMI2_FUNCTION(fmi2Status, fmi2GetRealStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Real* value) {
    if (!c || !value) return fmi2Error;
    if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
    *value = ((Instance*)c)->time;
    return fmi2OK;
}
FMI2_FUNCTION(fmi2Status, fmi2GetIntegerStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Integer* value) {
    (void)kind;
    (void)value;
    return c ? fmi2Discard : fmi2Error;
}
FMI2_FUNCTION(fmi2Status, fmi2GetBooleanStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2Boolean* value) {
    if (!c || !value) return fmi2Error;
    if (kind != fmi2Terminated) return fmi2Discard;
    *value = fmi2False;
    return fmi2OK;
}
FMI2_FUNCTION(fmi2Status, fmi2GetStringStatus)(fmi2Component c, const fmi2StatusKind kind, fmi2String* value) {
    (void)kind;
    (void)value;
    return c ? fmi2Discard : fmi2Error;
}
