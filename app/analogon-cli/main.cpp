#include "app/analogon-cli/command_line.hpp"
#include "app/analogon-cli/interrupt.hpp"
#include "core/base/blas_threads.hpp"
#include "core/base/guard.hpp"
#include "core/base/memory.hpp"

namespace {

/// Called before the libraries of the program prepare themselves, which takes longer than all that main() does first.
void begin(int, char** arguments, char** environment) {
    analogon::askForOneBlasThread(arguments, environment);
    analogon::cli::Interrupt::listen();
}
__attribute__((section(".preinit_array"), used)) void (*atTheBeginning)(int, char**, char**) = begin;

}  // namespace

int main(int argc, char** argv) {
    analogon::guardProgram();
    analogon::growHeap();
    const analogon::StackGuard stack;
    return analogon::cli::run(argc, argv);
}
