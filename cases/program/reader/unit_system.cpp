#include "cases/program/reader/unit_system.hpp"

#include <udunits2.h>

#include <clocale>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

namespace delabole {
namespace {

struct FreeSystem {
    void operator()(ut_system* system) const { ut_free_system(system); }
};
struct FreeUnit {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
    void operator()(cv_converter* converter) const { cv_free(converter); }
};
using System = std::unique_ptr<ut_system, FreeSystem>;
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

// Sets decimal points for this thread: udunits2 reads the numbers of its database in the locale of the process, which a
// program in Python may have set.
class DecimalPoints {
  public:
    DecimalPoints() : points_(::newlocale(LC_NUMERIC_MASK, "C", nullptr)), before_(::uselocale(points_)) {}
    ~DecimalPoints() {
        ::uselocale(before_);
        ::freelocale(points_);
    }
    DecimalPoints(const DecimalPoints&) = delete;
    DecimalPoints& operator=(const DecimalPoints&) = delete;

  private:
    locale_t points_;
    locale_t before_;  // that the thread had before
};

System read_database() {
    ut_set_error_message_handler(ut_ignore);
    System system(ut_read_xml(nullptr));
    if (!system) {
        throw std::runtime_error("the unit database of udunits2 cannot be read: is it installed?");
    }
    return system;
}

}  // namespace

const DimensionWords& dimension_words(Dimension dimension) {
    static constexpr auto words = std::to_array<DimensionWords>({
        {"", "a ratio", "0.5"},
        {"rad", "an angle", "\"40 deg\""},
        {"m", "a length", "\"10 m\""},
        {"m2", "an area", "\"10 m2\""},
        {"m3", "a volume", "\"100 m3\""},
        {"Pa", "a stress", "\"25 kPa\""},
        {"N/m3", "a unit weight", "\"26 kN/m3\""},
        {"N", "a force", "\"100 kN\""},
        {"N/m", "a force per metre run", "\"100 kN/m\""},
        {"N m/m", "a moment per metre run", "\"100 kN m/m\""},
        {"J/m", "an energy per metre run", "\"10 J/m\""},
        {"kg/m3", "a density", "\"2700 kg/m3\""},
        {"N/m/m", "a stiffness per metre run", "\"1000 MN/m/m\""},
        {"s", "a time", "\"1 s\""},
        {"m/s", "a speed", "\"0.1 m/s\""},
        {"m/s2", "an acceleration", "\"9.81 m/s2\""},
        {"rad/s", "an angular speed", "\"1 deg/s\""},
        {"", "a ratio", "0.5"},
    });
    static_assert(words.size() == enum_names(Dimension{}).size());
    return words[static_cast<std::size_t>(dimension)];
}

UnitFactor unit_factor(std::string_view unit, Dimension dimension) {
    // The parser of udunits2 keeps its state in global variables.
    static std::mutex parsing;
    const std::lock_guard lock(parsing);
    const DecimalPoints points;
    static const System system = read_database();

    const Unit from(ut_parse(system.get(), std::string(unit).c_str(), UT_UTF8));
    if (!from) {
        return {};
    }
    const Unit to(ut_parse(
        system.get(), dimension == Dimension::ratio ? "1" : std::string(dimension_words(dimension).si_symbol).c_str(),
        UT_UTF8));
    if (!to || ut_are_convertible(from.get(), to.get()) == 0) {
        return {.known = true, .si_per_unit = std::nullopt};
    }
    const Converter converter(ut_get_converter(from.get(), to.get()));
    if (!converter) {
        return {.known = true, .si_per_unit = std::nullopt};
    }
    const double factor = cv_convert_double(converter.get(), 1.0);
    const bool linear = cv_convert_double(converter.get(), 0.0) == 0.0 &&
                        std::abs(cv_convert_double(converter.get(), 2.0) - 2 * factor) <= 1e-15 * std::abs(factor);
    // udunits2 regards a reciprocal unit as convertible (s and Hz), but its converter is not linear.
    if (!linear || !(factor > 0) || !std::isfinite(factor)) {
        return {.known = true, .si_per_unit = std::nullopt};
    }
    return {.known = true, .si_per_unit = factor};
}

}  // namespace delabole
