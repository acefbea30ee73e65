#include "fit/team_alone.h"

#include <atomic>

#include "core/parallel.h"

namespace airlight {

Error interrupted() { return {"", "the fit was interrupted", "Run the same command again: what was finished is kept."}; }

namespace {

Result<std::vector<double>> stored_or_computed(const Job& job, const JobStore& store, const Progress& progress) {
    if (std::optional<std::vector<double>> stored = store.load(job.key)) return std::move(*stored);
    Result<std::vector<double>> numbers = job.compute(progress);
    if (!numbers && progress.stop.stop_requested()) return interrupted();
    if (!numbers) return numbers;
    if (const Result<Done> saved = store.save(job.key, *numbers); !saved) return saved.error();
    return numbers;
}

// How far many jobs are.
class Count {
public:
    Count(std::size_t jobs, std::string_view step, const Progress& progress) : jobs_(jobs), step_(step), progress_(progress) {}
    void finished_one() { report(0.0, ++finished_); }
    Progress of_the_next() {
        return {[this](std::string_view, double fraction) { report(fraction, finished_); }, progress_.stop};
    }

private:
    void report(double fraction, std::size_t finished) {
        progress_.report(step_, (static_cast<double>(finished) + fraction) / static_cast<double>(jobs_));
    }
    std::size_t jobs_;
    std::string_view step_;
    const Progress& progress_;
    std::atomic<std::size_t> finished_ = 0;
};

}  // namespace

Result<std::vector<std::vector<double>>> computed_alone(std::span<const Job> jobs, const JobStore& store, std::string_view step,
                                                        const Progress& progress) {
    std::vector<std::vector<double>> all(jobs.size());
    std::vector<std::optional<Error>> errors(jobs.size());
    std::atomic<bool> failed = false;
    Count count(jobs.size(), step, progress);
    const auto run = [&](std::size_t i) {
        if (failed) return;
        const Progress part = jobs[i].one_core ? Progress{.stop = progress.stop} : count.of_the_next();
        Result<std::vector<double>> numbers =
            progress.stop.stop_requested() ? Result<std::vector<double>>(interrupted()) : stored_or_computed(jobs[i], store, part);
        if (numbers) all[i] = std::move(*numbers);
        else errors[i] = numbers.error();
        failed = failed || !numbers;
        count.finished_one();
    };
    if (!jobs.empty() && jobs.front().one_core) parallel_for(jobs.size(), run);
    else
        for (std::size_t i = 0; i < jobs.size(); ++i) run(i);
    for (const std::optional<Error>& error : errors)
        if (error) return *error;
    return all;
}

}  // namespace airlight
