#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "core/base/file_handle.hpp"
#include "core/base/outcome.hpp"

namespace analogon {

/// What is told of a unit that a worker was given.
struct WorkerEvent {
    std::size_t unit{};
    std::string death;  // how its worker ended meanwhile, with its last words; empty: the unit was worked on to its end
};

/// Processes that are given units to work on, one at a time. A worker says "ready", then reads lines "INDEX NAME" and
/// answers each with "INDEX". One that dies costs the unit that it had, and another one takes its place. All end with
/// this process, however that ends.
class WorkerPool {
public:
    /// `command`: the program and its arguments.
    WorkerPool(std::vector<std::string> command, int size);
    ~WorkerPool();  // kills them
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    bool isFree() const;
    /// Gives a unit to a worker that is free; a process is started where there is none.
    Outcome<Done> give(std::size_t unit, const std::string& name);
    /// What happens within this time. Fault: a worker ended before any was ready, with what it said.
    Outcome<std::vector<WorkerEvent>> wait(std::chrono::milliseconds time);

private:
    struct Worker {
        pid_t process{};  // 0: none
        FileHandle in, out, error;
        std::optional<std::size_t> unit;
        std::string answer, words;  // that was read so far
    };
    Outcome<Done> start(Worker& worker);
    void read(Worker& worker, std::vector<WorkerEvent>& events);
    static std::string bury(Worker& worker);

    std::vector<std::string> command_;
    std::vector<Worker> workers_;
    bool hasBegun_{};  // some worker was ready
};

}  // namespace analogon
