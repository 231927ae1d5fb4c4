#pragma once

#include <vector>

namespace analogon::ui {

/// Where a logarithmic axis has marks, in ascending order.
struct LogTicks {
    std::vector<double> labelled, minor;
};

/// Round values from `low` to `high` (both positive) on an axis that is `length` pixels long: whole decades, 1-3, 1-2-5
/// or 1-2-3-5-7 within a decade, or equal steps where the axis covers less than that, as many as stand `gap` pixels
/// apart or more. Minor ones are the digits between them.
LogTicks logTicks(double low, double high, double length, double gap);

}  // namespace analogon::ui
