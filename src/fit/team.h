// Who computes jobs: this process alone, or the ranks of an MPI run, among which rank 0 hands the jobs out.
// All ranks run the same program: each calls computed() with the same jobs, and each gets all results.
// Uses jobs. MPI is an option of the build (AIRLIGHT_MPI); without it a team is this process.
#pragma once

#include <memory>
#include <vector>

#include "core/parallel.h"
#include "fit/jobs.h"

namespace airlight {

class Team {
public:
    // Joins the run that mpirun began, if one did.
    Team();
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    // Whether this process speaks for all: prints, and writes what the user asked for.
    bool leads() const { return rank_ == 0; }
    int size() const { return size_; }

    // The numbers of every job, in the order of the jobs: taken from the store where they are there, else computed and stored.
    // Rank 0 alone reads and writes the store, so ranks need not share a disk. Whoever is killed loses the job at work and no
    // other: a run of the same jobs goes on from there, and ends in the same bits on any number of ranks.
    // Fails with the first error of a job, or if `progress` asks to stop.
    Result<std::vector<std::vector<double>>> computed(std::span<const Job> jobs, const JobStore& store, std::string_view step,
                                                      const Progress& progress);

private:
    int rank_ = 0;
    int size_ = 1;
    bool mpi_ = false;
    std::unique_ptr<ThreadLimit> threads_;  // this rank's share of its machine
};

}  // namespace airlight
