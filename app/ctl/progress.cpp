#include "app/ctl/progress.h"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <utility>

#include <fmt/format.h>

#include "app/platform/platform.h"

namespace braitenlab {

Progress::Progress(std::string what, std::size_t all, std::size_t before, std::ostream& out, Clock::time_point now,
                   std::chrono::seconds first)
    : what_(std::move(what)), all_(all), before_(before), out_(out), begun_(now), next_(now + first) {}

void Progress::at(std::size_t done, Clock::time_point now) {
    if (now < next_ || done >= all_ || done <= before_) return;
    next_ = now + pause;
    const double passed = std::chrono::duration<double>(now - begun_).count();
    const double left = passed * static_cast<double>(all_ - done) / static_cast<double>(done - before_);
    out_ << fmt::format("braitenctl: {} of {} {}, about {:.0f} s left\n", done, all_, what_, std::ceil(left))
         << std::flush;
}

Progress progress_of(std::string what, std::size_t all, std::size_t before) {
    return {std::move(what),
            all,
            before,
            std::cerr,
            Progress::Clock::now(),
            is_terminal(stderr) ? std::chrono::seconds(1) : Progress::pause};
}

}  // namespace braitenlab
