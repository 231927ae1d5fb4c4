#pragma once

#include <cvodes/cvodes.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <memory>
#include <type_traits>

/// What the C library of the integrator gives, freed with its owner.
namespace analogon {

struct FreeContext {
    void operator()(SUNContext c) const { SUNContext_Free(&c); }
};
struct FreeVector {
    void operator()(N_Vector v) const { N_VDestroy(v); }
};
struct FreeMatrix {
    void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
};
struct FreeSolver {
    void operator()(SUNLinearSolver s) const { SUNLinSolFree(s); }
};
struct FreeCvodes {
    void operator()(void* memory) const { CVodeFree(&memory); }
};
template <class T, class Free>
using Owned = std::unique_ptr<std::remove_pointer_t<T>, Free>;

}  // namespace analogon
