#include "fitting/probability/statistics.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_qrng.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace delabole {

double chi_square_quantile(double probability, double degrees_of_freedom) {
    if (!(probability > 0 && probability < 1 && degrees_of_freedom > 0)) {
        throw std::invalid_argument("chi_square_quantile: needs 0 < probability < 1 and degrees_of_freedom > 0");
    }
    return gsl_cdf_chisq_Pinv(probability, degrees_of_freedom);
}

std::vector<std::vector<double>> sobol_points(std::size_t dimension, std::size_t count) {
    if (dimension == 0) {
        return {{}};
    }
    if (dimension > 40) {
        throw std::invalid_argument("sobol_points: " + std::to_string(dimension) + " dimensions, at most 40");
    }
    const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> generator(
        gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimension)), &gsl_qrng_free);
    if (!generator) {
        throw std::bad_alloc();
    }
    std::vector<std::vector<double>> points(count, std::vector<double>(dimension));
    for (std::vector<double>& point : points) {
        gsl_qrng_get(generator.get(), point.data());
    }
    return points;
}

}  // namespace delabole
