#pragma once

#include <optional>
#include <string>
#include <vector>

namespace analogon {

/// The environment with OPENBLAS_NUM_THREADS=1; nothing where it asks for a number of threads already.
std::optional<std::vector<std::string>> withOneBlasThread(char* const* environment);

/// Begins the program anew with one thread of OpenBLAS, where that is the BLAS of this machine and nobody has asked for
/// a number. It starts a thread a core while the program is loaded, each of which asks for a buffer of 128 MiB again
/// and again until it gets one: under a limit of memory below that the program would never end. The library reads its
/// environment when it prepares itself; so this is for .preinit_array, which is called before, with the arguments and
/// the environment of the program.
void askForOneBlasThread(char** arguments, char** environment);

}  // namespace analogon
