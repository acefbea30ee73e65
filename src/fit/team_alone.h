// A team of this process alone.
// Uses jobs; team.cpp and team_mpi.cpp decide when it is asked.
#pragma once

#include <vector>

#include "fit/jobs.h"

namespace airlight {

// What a run that was told to stop says.
Error interrupted();

// As Team::computed(), one job after the other; each job may use all cores.
Result<std::vector<std::vector<double>>> computed_alone(std::span<const Job> jobs, const JobStore& store, std::string_view step,
                                                        const Progress& progress);

}  // namespace airlight
