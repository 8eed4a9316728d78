#include "app/ctl/progress.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace braitenlab {

Progress::Progress(std::string what, std::size_t all, std::size_t before, std::ostream& out, Clock::time_point now,
                   std::chrono::seconds pause)
    : what_(std::move(what)), all_(all), before_(before), out_(out), begun_(now), next_(now + pause), pause_(pause) {}

void Progress::at(std::size_t done, Clock::time_point now) {
    if (now < next_ || done >= all_ || done <= before_) return;
    next_ = now + pause_;
    const double passed = std::chrono::duration<double>(now - begun_).count();
    const double left = passed * static_cast<double>(all_ - done) / static_cast<double>(done - before_);
    out_ << fmt::format("braitenctl: {} of {} {}, about {:.0f} s left\n", done, all_, what_, std::ceil(left))
         << std::flush;
}

}  // namespace braitenlab
