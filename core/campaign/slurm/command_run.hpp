#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace analogon {

/// What another program said, and how it ended.
struct CommandOutput {
    int status{-1};  // of its exit; -1: it ended by a signal or did not begin
    std::string out, error;

    bool isGood() const { return status == 0; }
    /// What it said of a fault, in one line.
    std::string words() const;
};

/// The program of this name on PATH.
std::optional<std::filesystem::path> programOnPath(const std::string& name);

/// Runs a program to its end, without standard input, apart from Ctrl-C of this terminal; when the work is to stop, it
/// is ended. `command`: its path and its arguments.
CommandOutput runCommand(const std::vector<std::string>& command, const std::stop_token& stop = {});

/// The words of a line as a shell takes them apart: blanks separate, quotes and the backslash keep. Empty: a quote is
/// not closed.
std::optional<std::vector<std::string>> splitWords(const std::string& line);

/// One word for a shell, whatever it holds.
std::string shellWord(const std::string& text);

}  // namespace analogon
