// The Mueller element M11 of many spheres at the same scattering angles: the sums that size distributions need.
// Theory: docs/theory.md, section 3.3. Uses mie.h.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "optics/mie.h"

namespace airlight {

// The functions of the scattering angle in Mie's series, kept so that a sphere costs four multiplications a term and angle
// (mie_amplitudes() finds them anew for each sphere). Bytes: 16 times cosines times terms.
class MieAngles {
public:
    // For series of at most `terms` terms; each cosine from -1 to 1.
    MieAngles(std::span<const double> cosines, std::size_t terms);

    std::size_t angle_count() const { return angle_count_; }
    std::size_t term_count() const { return term_count_; }

    // Adds weight * M11 at each cosine to `sum`, of shape [angle_count()].
    void add_mueller_11(const MieSeries& series, double weight, std::span<double> sum) const;

private:
    // Four angles at a time: their sums stay in registers.
    static constexpr std::size_t lanes = 4;
    // (2n + 1) / (n (n + 1)) times pi_n + tau_n and times pi_n - tau_n, which S1 + S2 and S1 - S2 are made of.
    struct Term {
        std::array<double, lanes> sum;
        std::array<double, lanes> difference;
    };

    std::size_t angle_count_;
    std::size_t term_count_;
    std::vector<Term> terms_;  // [angle_count / lanes, rounded up][term_count]
};

}  // namespace airlight
