#include "transport/harmonics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace airlight {

std::vector<float> legendre_values(const HarmonicLayout& layout, double mu) {
    std::vector<float> values(static_cast<std::size_t>(layout.count()));
    const double sine = std::sqrt(std::max(0.0, 1.0 - mu * mu));
    // Orthonormal over mu alone: p_mm, then upwards in l. [Press2007, sec. 6.7]
    double diagonal = std::sqrt(0.5);
    for (int m = 0; m <= layout.degree; ++m) {
        if (m > 0) diagonal *= -sine * std::sqrt((2.0 * m + 1.0) / (2.0 * m));
        // Over the azimuth, cos^2(m phi) integrates to 2 pi for m = 0 and to pi otherwise.
        const double norm = m == 0 ? 1.0 / std::sqrt(2.0 * std::numbers::pi) : 1.0 / std::sqrt(std::numbers::pi);
        double previous = 0.0;
        double p = diagonal;
        double old_factor = 1.0;
        for (int l = m; l <= layout.degree; ++l) {
            values[static_cast<std::size_t>(layout.index(l, m))] = static_cast<float>(norm * p);
            const double next = l + 1.0;
            const double factor = std::sqrt((4.0 * next * next - 1.0) / (next * next - static_cast<double>(m) * m));
            const double raised = factor * (mu * p - previous / old_factor);
            previous = p;
            p = raised;
            old_factor = factor;
        }
    }
    return values;
}

}  // namespace airlight
