// How far a long job is, and a way to stop it: handed down to every job that may take more than a second.
#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>

namespace airlight {

// What a long job is given. Jobs call `report` from any thread, some ten times a second at most, and return early,
// with an error that says so, soon after `stop` is requested.
struct Progress {
    std::function<void(std::string_view step, double fraction)> report = [](std::string_view, double) {};
    std::stop_token stop = {};
};

// The progress of one part of a longer job: the part's 0 to 1 is the job's `begin` to `begin + share`.
Progress part_of(const Progress& whole, double begin, double share);

// Draws one line on a terminal: the step, a fraction, and the time left; on a file or a pipe, a line each ten seconds.
class ProgressLine {
public:
    explicit ProgressLine(bool quiet = false);
    ~ProgressLine();  // ends the line

    Progress progress(std::stop_token stop = {});

private:
    using Clock = std::chrono::steady_clock;
    void draw(std::string_view step, double fraction);

    std::mutex mutex_;
    bool quiet_;
    bool terminal_;
    bool open_ = false;
    std::string step_;
    Clock::time_point step_start_;
    double step_begin_ = 0.0;  // the fraction at its first report: a job that goes on from earlier does not begin at 0
    Clock::time_point last_drawn_;
};

// "3 s", "2 min 05 s", "1 h 10 min".
std::string duration_text(double seconds);

}  // namespace airlight
