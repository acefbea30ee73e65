// Long computations in jobs whose results are kept: what is finished is on disk, whole and checked, and is never done twice.
// Uses core and the keys of tables; knows nothing of what the numbers mean.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/progress.h"
#include "core/result.h"
#include "transport/table_key.h"

namespace airlight {

// A part of a computation: some numbers that depend on nothing but the key, on whatever machine they are computed.
struct Job {
    TableKey key;
    std::function<Result<std::vector<double>>(const Progress&)> compute;
    bool one_core = false;  // else it uses all cores itself
};

// The hash of all that a job's numbers depend on, put together piece by piece.
class JobKey {
public:
    explicit JobKey(std::string_view what) { add(what); }
    JobKey& add(std::string_view text);
    JobKey& add(std::span<const double> numbers);
    JobKey& add(const TableKey& key);
    TableKey hash() const;

private:
    std::string bytes_;
};

// A folder of finished jobs, one file each, named by its key. Any number of programs may share it.
class JobStore {
public:
    // The folder is made when it is first needed; an empty path keeps nothing.
    explicit JobStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

    // The numbers of a job that is there and is whole; none if it is absent, or is damaged and has to be computed again.
    std::optional<std::vector<double>> load(const TableKey& key) const;

    // Written whole or not at all.
    Result<Done> save(const TableKey& key, std::span<const double> numbers) const;

private:
    std::filesystem::path path(const TableKey& key) const { return folder_ / (key_text(key) + ".job"); }
    std::filesystem::path folder_;
};

}  // namespace airlight
