#include "fit/least_squares.h"

#include <Eigen/Core>
#include <cassert>
#include <cmath>
#include <unsupported/Eigen/NonLinearOptimization>

namespace airlight {

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;  // column by column: a column is a parameter

std::span<const double> view(const Vector& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }
std::span<double> view(Vector& v) { return {v.data(), static_cast<std::size_t>(v.size())}; }

// The problem in the form that Eigen asks for.
class Functor {
public:
    Functor(const LeastSquares& problem, Eigen::Index parameters) : problem_(problem), parameters_(parameters) {}

    Eigen::Index inputs() const { return parameters_; }
    Eigen::Index values() const { return problem_.residuals; }
    int operator()(const Vector& x, Vector& residuals) const {
        problem_.evaluate(view(x), view(residuals));
        return 0;
    }
    int df(const Vector& x, Matrix& jacobian) const {
        if (problem_.differentiate) {
            problem_.differentiate(view(x), {jacobian.data(), static_cast<std::size_t>(jacobian.size())});
            return 0;
        }
        Vector here(values()), beside(values()), y = x;
        problem_.evaluate(view(x), view(here));
        for (Eigen::Index i = 0; i < inputs(); ++i) {
            const double step = 1e-7 * std::max(1.0, std::abs(x[i]));
            y[i] = x[i] + step;
            problem_.evaluate(view(y), view(beside));
            jacobian.col(i) = (beside - here) / step;
            y[i] = x[i];
        }
        return 0;
    }

private:
    const LeastSquares& problem_;
    Eigen::Index parameters_;
};

}  // namespace

LeastSquaresFit least_squares(const LeastSquares& problem, std::vector<double> start) {
    assert(problem.evaluate && problem.residuals >= static_cast<int>(start.size()));
    Vector x = Eigen::Map<const Vector>(start.data(), static_cast<Eigen::Index>(start.size()));
    Functor functor(problem, x.size());
    Eigen::LevenbergMarquardt<Functor> solver(functor);
    solver.parameters.maxfev = problem.evaluations;
    solver.parameters.ftol = problem.tolerance;
    solver.parameters.xtol = problem.tolerance;
    solver.minimize(x);
    const double rms = solver.fvec.norm() / std::sqrt(static_cast<double>(problem.residuals));
    assert(std::isfinite(rms));
    return {{x.data(), x.data() + x.size()}, rms};
}

}  // namespace airlight
