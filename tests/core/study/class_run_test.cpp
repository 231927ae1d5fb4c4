#include "core/study/class_run.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

FlatModel ramps() {
    const Outcome<Library> library = Library().withSource(
        std::make_shared<const Source>("m.mo", "model M Real x[10] = {k*time for k in 1:10}; end M;"));
    EXPECT_TRUE(library) << format(library.diagnostics());
    Outcome<FlatModel> flat = flatten(*library, "M");
    EXPECT_TRUE(flat) << format(flat.diagnostics());
    return flat ? std::move(*flat) : FlatModel{};
}

ClassRun runOf(double interval, std::size_t mostValues) {
    const FlatModel model = ramps();
    EventRunOptions options;
    options.interval = interval;
    const auto all = [&](const System& system) { return tracedNames(model, system); };
    const Outcome<ClassRun> run = runAlone(model, all, options, {}, mostValues);
    EXPECT_TRUE(run) << format(run.diagnostics());
    return run ? *run : ClassRun{};
}

// Ten variables at ten thousand instants are 100 000 values.
TEST(ClassRun, TellsFewerRowsThanAskedForWhereTheyWouldBeTooManyValues) {
    EXPECT_NEAR(runOf(1e-4, 200'000).interval, 1e-4, 1e-12);
    const ClassRun thinned = runOf(1e-4, 40'000);
    EXPECT_NEAR(thinned.interval, 2.5e-4, 1e-12);
    EXPECT_NEAR(static_cast<double>(thinned.trajectory.time.size()), 4001, 2);
    EXPECT_NEAR(runOf(1e-4, 10).interval, 1.0 / 2500, 1e-12) << "never fewer than 2500";
}

}  // namespace
}  // namespace analogon
