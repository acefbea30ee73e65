// A build with MPI (AIRLIGHT_MPI): rank 0 hands out jobs, the others compute them.
#include <mpi.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "fit/team.h"
#include "fit/team_alone.h"

namespace airlight {

namespace {

// Messages between rank 0 and a worker. A worker says that it is free, or brings a result; rank 0 answers with a job, or the end.
constexpr int to_leader = 1, numbers_tag = 2, to_worker = 3, error_tag = 4;
constexpr int free_for_work = -1, no_more = -2;
struct Message {
    int job = free_for_work;
    int failed = 0;
    int count = 0;  // of numbers, or of the bytes of an error, that follow
};
constexpr int words = 3;

using Numbers = std::vector<double>;

// A started MPI program has one of these; a program that was just called has none, and must not wait for others.
bool started_by_mpirun() {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMIX_RANK"})
        if (std::getenv(name) != nullptr) return true;
    return false;
}

std::string text_of(const Error& e) { return e.where + '\n' + e.what + '\n' + e.remedy; }
Error error_of(const std::string& text) {
    const std::size_t first = text.find('\n'), second = text.find('\n', first + 1);
    return {text.substr(0, first), text.substr(first + 1, second - first - 1), text.substr(second + 1)};
}

// Rank 0 may wait long: it sleeps between looks, for a waiting MPI call takes a whole core.
Message next_message(int& from) {
    MPI_Status status;
    for (int there = 0; there == 0;) {
        MPI_Iprobe(MPI_ANY_SOURCE, to_leader, MPI_COMM_WORLD, &there, &status);
        if (there == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    from = status.MPI_SOURCE;
    Message message;
    MPI_Recv(&message, words, MPI_INT, from, to_leader, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    return message;
}

// What rank 0 knows of the work.
struct Ledger {
    std::span<const Job> jobs;
    const JobStore& store;
    std::vector<Numbers> results;
    std::vector<int> open;  // to be computed; the next one last
    std::string error;      // the first one
};

void take_result(Ledger& ledger, const Message& message, int from) {
    if (message.failed != 0) {
        std::string text(static_cast<std::size_t>(message.count), ' ');
        MPI_Recv(text.data(), message.count, MPI_CHAR, from, error_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        if (ledger.error.empty()) ledger.error = text;
        return;
    }
    const auto job = static_cast<std::size_t>(message.job);
    Numbers& numbers = ledger.results[job];
    numbers.resize(static_cast<std::size_t>(message.count));
    MPI_Recv(numbers.data(), message.count, MPI_DOUBLE, from, numbers_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (const Result<Done> saved = ledger.store.save(ledger.jobs[job].key, numbers); !saved && ledger.error.empty())
        ledger.error = text_of(saved.error());
}

void lead(Ledger& ledger, int workers, std::string_view step, const Progress& progress) {
    const std::size_t all = ledger.open.size();
    std::size_t done = 0;
    while (workers > 0) {
        int from = 0;
        const Message message = next_message(from);
        if (message.job != free_for_work) {
            take_result(ledger, message, from);
            ++done;
        }
        if (all > 0) progress.report(step, static_cast<double>(done) / static_cast<double>(all));
        if (progress.stop.stop_requested() && ledger.error.empty()) ledger.error = text_of(interrupted());
        int next = no_more;
        if (!ledger.open.empty() && ledger.error.empty()) {
            next = ledger.open.back();
            ledger.open.pop_back();
        }
        MPI_Send(&next, 1, MPI_INT, from, to_worker, MPI_COMM_WORLD);
        if (next == no_more) --workers;
    }
}

void work(std::span<const Job> jobs, const Progress& progress) {
    Message message;
    MPI_Send(&message, words, MPI_INT, 0, to_leader, MPI_COMM_WORLD);
    for (;;) {
        int job = no_more;
        MPI_Recv(&job, 1, MPI_INT, 0, to_worker, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        if (job == no_more) return;
        const Result<Numbers> numbers = jobs[static_cast<std::size_t>(job)].compute(Progress{.stop = progress.stop});
        const std::string error = numbers ? "" : text_of(progress.stop.stop_requested() ? interrupted() : numbers.error());
        message = {job, numbers ? 0 : 1, static_cast<int>(numbers ? numbers->size() : error.size())};
        MPI_Send(&message, words, MPI_INT, 0, to_leader, MPI_COMM_WORLD);
        if (numbers) MPI_Send(numbers->data(), message.count, MPI_DOUBLE, 0, numbers_tag, MPI_COMM_WORLD);
        else MPI_Send(error.data(), message.count, MPI_CHAR, 0, error_tag, MPI_COMM_WORLD);
    }
}

// Rank 0's error, or its results, to all.
Result<std::vector<Numbers>> shared(Ledger& ledger) {
    int length = static_cast<int>(ledger.error.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    ledger.error.resize(static_cast<std::size_t>(length));
    if (length > 0) {
        MPI_Bcast(ledger.error.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
        return error_of(ledger.error);
    }
    for (Numbers& numbers : ledger.results) {
        int count = static_cast<int>(numbers.size());
        MPI_Bcast(&count, 1, MPI_INT, 0, MPI_COMM_WORLD);
        numbers.resize(static_cast<std::size_t>(count));
        MPI_Bcast(numbers.data(), count, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    }
    return std::move(ledger.results);
}

}  // namespace

Team::Team() {
    if (!started_by_mpirun()) return;
    int level = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    mpi_ = true;
    // The ranks of one machine share its cores.
    MPI_Comm machine;
    int beside = 1;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &beside);
    MPI_Comm_free(&machine);
    const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    threads_ = std::make_unique<ThreadLimit>(std::max(1, cores / beside));
}

Team::~Team() {
    if (mpi_) MPI_Finalize();
}

Result<std::vector<Numbers>> Team::computed(std::span<const Job> jobs, const JobStore& store, std::string_view step,
                                            const Progress& progress) {
    if (size_ == 1) return computed_alone(jobs, store, step, progress);
    Ledger ledger{jobs, store, std::vector<Numbers>(jobs.size()), {}, ""};
    if (leads()) {
        for (std::size_t i = jobs.size(); i-- > 0;)
            if (std::optional<Numbers> stored = store.load(jobs[i].key)) ledger.results[i] = std::move(*stored);
            else ledger.open.push_back(static_cast<int>(i));
        lead(ledger, size_ - 1, step, progress);
    } else {
        work(jobs, progress);
    }
    return shared(ledger);
}

}  // namespace airlight
