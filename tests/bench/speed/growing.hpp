#pragma once

#include "core/fit/problem.hpp"

/// Problems of any size, with measurements that the model itself made.
namespace analogon::speed {

/// A chain of masses with a heat source at one end and the ambient at the other, from the library's blocks; the
/// temperatures of the first, the middle and the last are measured. `isRod`: a rod of one length in ever finer slices,
/// which grows stiffer with their number.
FitProblem thermalChain(int masses, bool isRod, int samples, int fitted);

/// A square net of conductances between nodes without mass, heated at one corner and held at the one across, with
/// masses in the middle and at a third corner: all its nodes are one block of linear equations. `side`: nodes of an
/// edge.
FitProblem thermalNet(int side, int samples, int fitted);

/// An electric pump whose shaft ends without mass in a load that grows with the square of the speed. `sticks`: with a
/// friction beside it, so that the equation for the speed has no closed solution.
FitProblem pump(int samples, bool sticks);

/// The same pump in several recordings.
FitProblem pumpRecordings(int recordings, int samples);

}  // namespace analogon::speed
