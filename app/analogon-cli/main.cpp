#include "app/analogon-cli/command_line.hpp"
#include "app/analogon-cli/interrupt.hpp"
#include "core/base/guard.hpp"
#include "core/base/memory.hpp"

namespace {

/// Called before the libraries of the program prepare themselves, which takes longer than all that main() does first.
__attribute__((section(".preinit_array"), used)) void (*atTheBeginning)() = analogon::cli::Interrupt::listen;

}  // namespace

int main(int argc, char** argv) {
    analogon::guardProgram();
    analogon::growHeap();
    const analogon::StackGuard stack;
    return analogon::cli::run(argc, argv);
}
