#include "core/campaign/slurm/command_run.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <utility>

#include "core/base/pipe.hpp"

namespace analogon {

namespace {

/// Everything between fork and exec: system calls alone.
[[noreturn]] void becomeProgram(char* const* arguments, int out, int error) {
    setpgid(0, 0);
    const int in = open("/dev/null", O_RDONLY);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(error, STDERR_FILENO);
    execv(arguments[0], arguments);
    _exit(127);
}

/// Both streams until they end, or the program is ended since the work is to stop.
void listenTo(pid_t process, const Pipe& out, const Pipe& error, CommandOutput& output, const std::stop_token& stop) {
    std::array<pollfd, 2> watched{pollfd{out.read.number(), POLLIN, 0}, pollfd{error.read.number(), POLLIN, 0}};
    while (watched[0].fd >= 0 || watched[1].fd >= 0) {
        if (stop.stop_requested()) {
            kill(process, SIGKILL);
            return;
        }
        if (poll(watched.data(), watched.size(), 20) <= 0) continue;
        if (watched[0].revents != 0 && !readSome(out.read.number(), output.out)) watched[0].fd = -1;
        if (watched[1].revents != 0 && !readSome(error.read.number(), output.error)) watched[1].fd = -1;
    }
}

}  // namespace

std::string CommandOutput::words() const {
    std::string said = error.empty() ? out : error;
    std::replace(said.begin(), said.end(), '\n', ' ');
    while (said.ends_with(' ')) said.pop_back();
    return said.empty() ? "it ended with status " + std::to_string(status) : said;
}

std::optional<std::filesystem::path> programOnPath(const std::string& name) {
    const char* variable = std::getenv("PATH");
    const std::string path = variable ? variable : "";
    for (std::size_t at = 0, end = 0; end != std::string::npos; at = end + 1) {
        end = path.find(':', at);
        const std::string folder = path.substr(at, end == std::string::npos ? end : end - at);
        std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / name;
        std::error_code code;
        if (std::filesystem::is_regular_file(file, code) && access(file.c_str(), X_OK) == 0) return file;
    }
    return std::nullopt;
}

CommandOutput runCommand(const std::vector<std::string>& command, const std::stop_token& stop) {
    CommandOutput output;
    std::optional<Pipe> out = Pipe::make(), error = Pipe::make();
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t process = out && error ? fork() : -1;
    if (process < 0) {
        output.error = "no process can be started";
        return output;
    }
    if (process == 0) becomeProgram(arguments.data(), out->write.number(), error->write.number());
    out->write.reset();
    error->write.reset();
    listenTo(process, *out, *error, output, stop);
    int status = 0;
    waitpid(process, &status, 0);
    if (WIFEXITED(status)) output.status = WEXITSTATUS(status);
    return output;
}

std::optional<std::vector<std::string>> splitWords(const std::string& line) {
    std::vector<std::string> words;
    bool isWord = false;
    char quote = 0;
    std::string word;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote == 0 && (c == ' ' || c == '\t' || c == '\n')) {
            if (isWord) words.push_back(std::exchange(word, {}));
            isWord = false;
            continue;
        }
        isWord = true;
        if (quote == 0 && (c == '\'' || c == '"'))
            quote = c;
        else if (c == quote)
            quote = 0;
        else if (c == '\\' && quote != '\'' && i + 1 < line.size())
            word += line[++i];
        else
            word += c;
    }
    if (quote != 0) return std::nullopt;
    if (isWord) words.push_back(word);
    return words;
}

std::string shellWord(const std::string& text) {
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

}  // namespace analogon
