#include "app/analogon-cli/command_line.hpp"

int main(int argc, char** argv) { return analogon::cli::run(argc, argv); }
