#include "eval/cost.h"

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <string>
#include <vector>

#include "core/parallel.h"

namespace airlight {

namespace {

constexpr std::size_t picture_directions = 20'000;

double seconds(clockid_t clock) {
    std::timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// The least of some runs: what else uses a core's caches only ever slows them. Long ones run once.
double best_seconds(const std::function<void()>& run) {
    double best = std::numeric_limits<double>::infinity(), all = 0.0;
    for (int i = 0; i < 5 && all < 0.5; ++i) {
        const double start = seconds(CLOCK_PROCESS_CPUTIME_ID);
        run();
        const double spent = seconds(CLOCK_PROCESS_CPUTIME_ID) - start;
        best = std::min(best, spent);
        all += spent;
    }
    return best;
}

// The last `name ... size="N"` of glibc's report, which is that of all arenas together.
std::size_t last_size(const std::string& report, const std::string& name) {
    const std::size_t at = report.rfind(name);
    if (at == std::string::npos) return 0;
    const std::string word = "size=\"";
    const std::size_t size = report.find(word, at);
    return size == std::string::npos ? 0 : std::strtoull(report.c_str() + size + word.size(), nullptr, 10);
}

// Bytes allocated from the heap by all threads. Unlike mallinfo2(), malloc_info() sees the arenas of all of them.
std::size_t heap_bytes() {
    char* text = nullptr;
    std::size_t length = 0;
    std::FILE* memory = open_memstream(&text, &length);
    if (memory == nullptr) return 0;
    malloc_info(0, memory);
    std::fclose(memory);
    const std::string report(text, length);
    std::free(text);
    const std::size_t taken = last_size(report, "<system type=\"current\"") + last_size(report, "<total type=\"mmap\"");
    const std::size_t free = last_size(report, "<total type=\"fast\"") + last_size(report, "<total type=\"rest\"");
    return taken > free ? taken - free : 0;
}

// Over the upper hemisphere, so that no two are alike.
std::vector<Direction> directions(std::size_t count) {
    std::vector<Direction> result;
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = 0.6180339887498949 * static_cast<double>(i);
        result.push_back({std::acos((static_cast<double>(i) + 0.5) / static_cast<double>(count)), 2.0 * pi * (turn - std::floor(turn))});
    }
    return result;
}

}  // namespace

Result<std::unique_ptr<Sky>> measured_making(const std::function<Result<std::unique_ptr<Sky>>()>& make, MakingCost& cost) {
    const std::size_t bytes = heap_bytes();
    const double start = seconds(CLOCK_PROCESS_CPUTIME_ID);
    Result<std::unique_ptr<Sky>> sky = make();
    cost.core_seconds = seconds(CLOCK_PROCESS_CPUTIME_ID) - start;
    const std::size_t now = heap_bytes();
    cost.bytes = now > bytes ? now - bytes : 0;
    return sky;
}

double picture_seconds(const AskingCost& cost) {
    return cost.dome_seconds + static_cast<double>(picture_directions) * cost.direction_seconds;
}

Result<AskingCost> asking_cost(const Sky& sky, const Condition& condition) {
    const ThreadLimit one(1);
    AskingCost cost;
    // A first dome touches what a model keeps for later ones; those show what each costs.
    Result<std::unique_ptr<SkyDome>> dome = sky.dome(condition.altitude, condition.sun_zenith_deg * deg);
    if (!dome) return dome.error();
    cost.dome_seconds = best_seconds([&] { dome = sky.dome(condition.altitude, condition.sun_zenith_deg * deg); });
    if (!dome) return dome.error();
    // More directions until the clock sees them well, or a picture is full.
    for (std::size_t count = 4;; count = std::min(4 * count, picture_directions)) {
        const std::vector<Direction> asked = directions(count);
        std::vector<float> radiance(count * sky.wavelengths().size());
        const double spent = best_seconds([&] { (*dome)->radiances(asked, radiance); });
        cost.direction_seconds = spent / static_cast<double>(count);
        if (spent > 0.05 || count == picture_directions) return cost;
    }
}

}  // namespace airlight
