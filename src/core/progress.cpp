#include "core/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace airlight {

std::string duration_text(double seconds) {
    const long whole = std::max(0L, static_cast<long>(seconds + 0.5));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

Progress part_of(const Progress& whole, double begin, double share) {
    return {[=](std::string_view step, double fraction) { whole.report(step, begin + share * fraction); }, whole.stop};
}

ProgressLine::ProgressLine(bool quiet) : quiet_(quiet), terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
    if (open_) std::fputc('\n', stderr);
}

Progress ProgressLine::progress(std::stop_token stop) {
    return {[this](std::string_view step, double fraction) { draw(step, fraction); }, std::move(stop)};
}

void ProgressLine::draw(std::string_view step, double fraction) {
    if (quiet_) return;
    const std::lock_guard lock(mutex_);
    const Clock::time_point now = Clock::now();
    if (step != step_) {
        if (open_) std::fputc('\n', stderr);
        open_ = false;
        step_ = step;
        step_start_ = last_drawn_ = now;
        step_begin_ = fraction;
    }
    const auto interval = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(10'000);
    if (now - last_drawn_ < interval) return;
    last_drawn_ = now;

    const double spent = std::chrono::duration<double>(now - step_start_).count();
    const double share = fraction - step_begin_;
    const std::string left = share > 0.01 ? duration_text(spent / share * (1.0 - fraction)) + " left" : "";
    const std::string line = fmt::format("{}: {:3.0f} %  {}", step, 100.0 * fraction, left);
    if (terminal_) {
        fmt::print(stderr, "\r{:<70}", line);
        open_ = true;
    } else {
        fmt::print(stderr, "{}\n", line);
    }
    std::fflush(stderr);
}

}  // namespace airlight
