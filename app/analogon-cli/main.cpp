#include "app/analogon-cli/command_line.hpp"
#include "core/base/memory.hpp"

int main(int argc, char** argv) {
    analogon::growHeap();
    return analogon::cli::run(argc, argv);
}
