// Lines that tell how far a long command is, on standard error.
#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

namespace braitenlab {

class Progress {
public:
    using Clock = std::chrono::steady_clock;

    // `what`: the parts, "runs"; `all` of them, of which `before` were complete when the command began. The first line
    // comes after `first`, the next ones after 10 s each.
    Progress(std::string what, std::size_t all, std::size_t before, std::ostream&, Clock::time_point now = Clock::now(),
             std::chrono::seconds first = pause);

    static constexpr std::chrono::seconds pause{10};

    // Writes "braitenctl: 24 of 240 runs, about 90 s left" when it is time. `done`: parts that are complete.
    void at(std::size_t done, Clock::time_point now = Clock::now());

private:
    std::string what_;
    std::size_t all_, before_;
    std::ostream& out_;
    Clock::time_point begun_, next_;
};

// Of a command that begins now, on standard error. A person at a terminal gets the first line after a second.
Progress progress_of(std::string what, std::size_t all, std::size_t before = 0);

}  // namespace braitenlab
