// How far a fitted model is from the truth it was fitted to.
// Uses nothing.
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace airlight {

// Root of the mean square of (model - truth) / truth, over directions of equal solid angle.
class RelativeRms {
public:
    // A truth of zero says nothing of relative differences, and is passed over.
    void add(double model, double truth, double weight = 1.0) {
        if (!(truth > 0.0)) return;
        sum_ += weight * (model / truth - 1.0) * (model / truth - 1.0);
        weight_ += weight;
    }
    void add(const RelativeRms& other) { sum_ += other.sum_, weight_ += other.weight_; }
    double value() const { return weight_ > 0.0 ? std::sqrt(sum_ / weight_) : 0.0; }

private:
    double sum_ = 0.0;
    double weight_ = 0.0;
};

// One line of what `airlight fit` reports.
struct ResidualLine {
    std::string condition;
    double relative_rms;
};
using Residuals = std::vector<ResidualLine>;

}  // namespace airlight
