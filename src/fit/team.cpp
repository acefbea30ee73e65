// A build without MPI: a team is this process.
#include "fit/team.h"

#include "fit/team_alone.h"

namespace airlight {

Team::Team() = default;
Team::~Team() = default;

Result<std::vector<std::vector<double>>> Team::computed(std::span<const Job> jobs, const JobStore& store, std::string_view step,
                                                        const Progress& progress) {
    return computed_alone(jobs, store, step, progress);
}

}  // namespace airlight
