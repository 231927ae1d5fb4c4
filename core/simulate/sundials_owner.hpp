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

/// Vectors of the same kind as another.
class VectorArray {
public:
    VectorArray(N_Vector like, int count) : array_(N_VCloneVectorArray(count, like)), count_(count) {}
    ~VectorArray() { N_VDestroyVectorArray(array_, count_); }
    VectorArray(const VectorArray&) = delete;
    VectorArray& operator=(const VectorArray&) = delete;
    N_Vector* get() const { return array_; }
    double* operator[](int k) const { return N_VGetArrayPointer(array_[k]); }

private:
    N_Vector* array_;
    int count_;
};

}  // namespace analogon
