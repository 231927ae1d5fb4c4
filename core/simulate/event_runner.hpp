#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/eval/rank_deficient.hpp"
#include "core/simulate/delay_history.hpp"
#include "core/simulate/event_run.hpp"
#include "core/simulate/recorded_drive.hpp"
#include "core/simulate/sundials_owner.hpp"

namespace analogon {

/// A simulation of a model with events, from its start to its end.
class EventRun {
public:
    EventRun(const HybridModel& model, const System& system, const std::vector<std::string>& names,
             const EventRunOptions& options, const Progress& progress, RecordedDrive* drive = nullptr);
    Outcome<EventTrajectory> run();

private:
    static constexpr double never = std::numeric_limits<double>::infinity();
    static constexpr double hysteresis = 1e-10;  // of a relation, beside the sizes that it compares

    /// The size of a time: those that differ by less than some rounding errors of it are one. A run of picoseconds has
    /// none of a second.
    double sizeOf(double time) const {
        return std::max(std::fabs(time), std::min(1.0, options_.stop - options_.start));
    }
    static bool isUpward(Operation operation) {
        return operation == Operation::Greater || operation == Operation::GreaterEqual;
    }

    /// A sample: when it came, and how often.
    struct Clock {
        double start{}, interval{}, count{};
        double next() const { return start + count * interval; }
    };

    /// A time of the run, and what is told there where it was worked out.
    struct RowPoint {
        double time{};
        std::vector<double> x, row;
    };

    double rowInterval() const;
    bool areRatesDecided();
    void tellUndecided();
    Diagnostics fail(Text message, Text hint = {});
    bool failed(Text message, Text hint = {});
    bool takeSlots();
    bool read(double t, const double* x, std::vector<double>& readings);
    EventPoint point();
    bool takeSample();
    bool takeLastSamples();
    double gridTime(double interval) const;
    bool isStopped(Text reason, bool isCancelled);
    bool hasNoTangent();
    bool beginTangents(const std::set<int>& crossed);
    EventMoment momentOf(const std::set<int>& crossed) const;
    void takeDelayed(double t);
    bool readNow(bool isInitial);
    bool takeStarts();
    bool solveStarts(bool isInitial);
    bool rememberEvent();
    bool rememberStep(double begin, double end);
    double offsetOf(int step) const;
    void judge(const std::set<int>& crossed, bool isFirst, bool isSingle);
    bool hasNoValue(const std::string& variable);
    std::string nameOf(int slot) const;
    bool settleOnce(const std::set<int>& crossed, int round, bool isInitial, bool isStart, int& moved);
    void turnRelations();
    bool settle(const std::set<int>& crossed, bool isInitial);
    bool pass(const std::vector<double>& entry, const std::set<int>& crossed, int moved);
    bool reinitialise(bool& isDone);
    bool check();
    bool event(const std::set<int>& crossed);
    bool initialise();
    bool startClocks();
    double nextTimeEvent() const;
    std::size_t rootCount() const;
    void rootValues(const std::vector<double>& readings, double* values) const;
    static int rates(double t, N_Vector y, N_Vector ydot, void* self);
    static int tangentRates(int K, double t, N_Vector y, N_Vector, N_Vector* yS, N_Vector* ySdot, void* self,
                            N_Vector scratch, N_Vector);
    void putTangents();
    bool takeTangents(double t);
    bool setUpTangents();
    void findScales();
    static int slopes(double t, N_Vector y, N_Vector, SUNMatrix to, void* self, N_Vector scratch, N_Vector, N_Vector);
    bool setUpSlopes();
    static int roots(double t, N_Vector y, double* values, void* self);
    bool setUp();
    bool restart();
    bool isSameMotion(const std::vector<double>& slots) const;
    bool advance(double interval);
    bool timeEvent(bool isEvent);
    bool handle(const std::set<int>& crossed, bool isStop = false);
    bool checkHere();
    bool rowAt(double t, const std::vector<double>& x, std::vector<double>& row);
    bool record();
    void tell(const RowPoint& point);
    int columnThatJumps() const;
    void tellJump();

    const HybridModel& model_;
    const System& system_;
    const std::vector<std::string>& names_;
    const EventRunOptions& options_;
    const Progress& progress_;
    RecordedDrive* drive_;     // null: a class by itself
    EventTangents* tangents_;  // null: none
    Workspace workspace_;
    Workspace slopes_;  // with a direction for each state
    bool hasSlopes_{};  // with the parameters in force
    bool isExact_{};    // the matrix of the integrator is made of them
    std::vector<double> along_, jacobian_;
    std::size_t n_;
    std::vector<double> slots_, readings_, rootReadings_, x_, u_, values_, taken_;
    std::vector<char> isDue_;                  // by step of the program
    std::vector<std::pair<int, int>> source_;  // by name: slot, or -1 and which of the observed
    std::vector<int> handles_;
    std::vector<int> slotAt_, readingAt_;  // parameter, output of the system
    std::vector<double> parameters_, outputs_, inputRates_, scales_, dx_, dxdot_;
    std::vector<std::pair<std::vector<double>, std::vector<double>>> clockTangents_;  // of start and interval
    std::vector<Clock> clocks_;                                                       // by sample
    std::vector<DelayHistory> delays_;
    std::vector<int> delayedInputs_;  // by delay; -1: nobody reads it
    std::size_t lastSwitched_{};      // relation
    std::vector<char> hasSwitched_;   // by relation: since the discrete quantities were last at rest
    std::vector<int> pending_;        // samples that come true at this event
    std::set<std::size_t> warned_;
    std::vector<RowPoint> path_;            // from the last row through the ends of the steps since
    std::vector<double> least_, greatest_;  // of the rows so far, by name
    UndecidedScope undecided_;
    EventTrajectory result_;
    Diagnostics faults_;
    double time_{}, lastEvent_{-never};
    long grid_{};
    int crowded_{}, passes_{};
    bool isPassing_{};  // the last event round found no rest, and took what came first
    bool isTerminated_{}, isRound_{};
    std::chrono::steady_clock::time_point began_;
    Owned<SUNContext, FreeContext> context_;
    Owned<N_Vector, FreeVector> y_;
    Owned<N_Vector, FreeVector> absolute_;
    Owned<SUNMatrix, FreeMatrix> matrix_;
    Owned<SUNLinearSolver, FreeSolver> solver_;
    std::unique_ptr<VectorArray> sensitivities_;
    std::unique_ptr<void, FreeCvodes> cvodes_;
};

}  // namespace analogon
