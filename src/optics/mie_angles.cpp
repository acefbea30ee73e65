#include "optics/mie_angles.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace airlight {

MieAngles::MieAngles(std::span<const double> cosines, std::size_t terms)
    : angle_count_(cosines.size()), term_count_(terms), terms_((cosines.size() + lanes - 1) / lanes * terms) {
    for (std::size_t angle = 0; angle < cosines.size(); ++angle) {
        const double nu = cosines[angle];
        double pi_before = 0.0;
        double pi_n = 1.0;
        for (std::size_t i = 0; i < terms; ++i) {
            const double n = static_cast<double>(i + 1);
            const double tau_n = n * nu * pi_n - (n + 1.0) * pi_before;
            const double factor = (2.0 * n + 1.0) / (n * (n + 1.0));
            Term& term = terms_[angle / lanes * terms + i];
            term.sum[angle % lanes] = factor * (pi_n + tau_n);
            term.difference[angle % lanes] = factor * (pi_n - tau_n);
            pi_before = std::exchange(pi_n, ((2.0 * n + 1.0) * nu * pi_n - (n + 1.0) * pi_before) / n);
        }
    }
}

void MieAngles::add_mueller_11(const MieSeries& series, double weight, std::span<double> sum) const {
    assert(series.a.size() <= term_count_ && sum.size() == angle_count_);
    for (std::size_t first = 0; first < angle_count_; first += lanes) {
        const Term* term = &terms_[first / lanes * term_count_];
        double plus_re[lanes]{}, plus_im[lanes]{}, minus_re[lanes]{}, minus_im[lanes]{};
        for (std::size_t i = 0; i < series.a.size(); ++i, ++term) {
            const std::complex<double> plus = series.a[i] + series.b[i];
            const std::complex<double> minus = series.a[i] - series.b[i];
            for (std::size_t j = 0; j < lanes; ++j) {
                plus_re[j] += plus.real() * term->sum[j];
                plus_im[j] += plus.imag() * term->sum[j];
                minus_re[j] += minus.real() * term->difference[j];
                minus_im[j] += minus.imag() * term->difference[j];
            }
        }
        // (|S1|^2 + |S2|^2) / 2 = (|S1 + S2|^2 + |S1 - S2|^2) / 4
        for (std::size_t j = 0; j < lanes && first + j < angle_count_; ++j)
            sum[first + j] +=
                0.25 * weight * (plus_re[j] * plus_re[j] + plus_im[j] * plus_im[j] + minus_re[j] * minus_re[j] + minus_im[j] * minus_im[j]);
    }
}

}  // namespace airlight
