#include "app/analogon-cli/command_line.hpp"
#include "core/base/guard.hpp"
#include "core/base/memory.hpp"

int main(int argc, char** argv) {
    analogon::guardProgram();
    analogon::growHeap();
    const analogon::StackGuard stack;
    return analogon::cli::run(argc, argv);
}
