#include "cases/program/reader/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace delabole {
namespace {

double si(std::string_view text, Dimension dimension) {
    const ParsedQuantity parsed = parse_quantity(text, dimension);
    EXPECT_EQ(parsed.status, QuantityStatus::ok) << text << ": " << parsed.message;
    return parsed.value;
}

QuantityStatus status(std::string_view text, Dimension dimension) {
    const ParsedQuantity parsed = parse_quantity(text, dimension);
    EXPECT_EQ(parsed.status == QuantityStatus::ok, parsed.message.empty());
    return parsed.status;
}

TEST(Units, UnitsOfRockMechanics) {
    EXPECT_DOUBLE_EQ(si("225 ft", Dimension::length), 68.58);
    EXPECT_DOUBLE_EQ(si("7in", Dimension::length), 0.1778);
    EXPECT_DOUBLE_EQ(si("30 lbf/in^2", Dimension::stress), 30 * 6894.757293168359);
    EXPECT_DOUBLE_EQ(si("0.20 MN/m^2", Dimension::stress), 0.2e6);
    EXPECT_DOUBLE_EQ(si("0.2 MPa", Dimension::stress), 0.2e6);
    EXPECT_DOUBLE_EQ(si("26 kN/m3", Dimension::unit_weight), 26e3);
    EXPECT_DOUBLE_EQ(si("26 kN m-3", Dimension::unit_weight), 26e3);
    EXPECT_DOUBLE_EQ(si("165 lbf/ft3", Dimension::unit_weight), 165 * 157.08746384624618);
    EXPECT_DOUBLE_EQ(si("2000 psf", Dimension::stress), si("2000 lbf/ft2", Dimension::stress));
    EXPECT_DOUBLE_EQ(si("2 ksf", Dimension::stress), si("2000 lbf/ft2", Dimension::stress));
    EXPECT_DOUBLE_EQ(si("165 pcf", Dimension::unit_weight), si("165 lbf/ft3", Dimension::unit_weight));
    EXPECT_DOUBLE_EQ(si("25 KPa", Dimension::stress), 25e3);
    EXPECT_DOUBLE_EQ(si("400 kN/m", Dimension::force_per_length), 400e3);
    EXPECT_DOUBLE_EQ(si("100 lbf", Dimension::force), 444.82216152605);
    EXPECT_DOUBLE_EQ(si("2 yd3", Dimension::volume), 2 * 0.764554857984);
    EXPECT_DOUBLE_EQ(si("5 kN m/m", Dimension::moment_per_length), 5e3);
    EXPECT_DOUBLE_EQ(si("3 m²", Dimension::area), 3);
    EXPECT_DOUBLE_EQ(si("2.7 t/m3", Dimension::density), 2700);
    EXPECT_DOUBLE_EQ(si("2e6 N/m/m", Dimension::stiffness), 2e6);
    EXPECT_DOUBLE_EQ(si("3 ms", Dimension::time), 3e-3);
    EXPECT_DOUBLE_EQ(si("36 km/h", Dimension::speed), 10);
    EXPECT_DOUBLE_EQ(si("9.81 m/s2", Dimension::acceleration), 9.81);
    EXPECT_DOUBLE_EQ(si("60 deg/min", Dimension::angular_speed), degrees(1));
    EXPECT_DOUBLE_EQ(si("2 rad / s", Dimension::angular_speed), 2);
    EXPECT_DOUBLE_EQ(si("5 kJ/m", Dimension::energy_per_length), 5e3);
    EXPECT_DOUBLE_EQ(si("50 %", Dimension::ratio), 0.5);
    EXPECT_DOUBLE_EQ(si("0.2 m/m", Dimension::ratio), 0.2);
    EXPECT_EQ(si("90 deg", Dimension::angle), degrees(90));
    EXPECT_EQ(si("89.9°", Dimension::angle), degrees(89.9));
    EXPECT_EQ(si("0.5 rad", Dimension::angle), 0.5);
    EXPECT_EQ(si(" +1e1  m ", Dimension::length), 10);
}

TEST(Units, WhatIsWrongIsTold) {
    EXPECT_EQ(status("high", Dimension::length), QuantityStatus::not_a_number);
    EXPECT_EQ(status("", Dimension::length), QuantityStatus::not_a_number);
    EXPECT_EQ(status("12", Dimension::length), QuantityStatus::missing_unit);
    EXPECT_EQ(status("0", Dimension::stress), QuantityStatus::missing_unit);
    EXPECT_EQ(status("0.5", Dimension::ratio), QuantityStatus::missing_unit);
    EXPECT_EQ(status("12 furlangs", Dimension::length), QuantityStatus::unknown_unit);
    EXPECT_EQ(status("1,5 m", Dimension::length), QuantityStatus::unknown_unit);
    EXPECT_EQ(status("12 s", Dimension::length), QuantityStatus::wrong_dimension);
    EXPECT_EQ(status("12 deg", Dimension::length), QuantityStatus::wrong_dimension);
    EXPECT_EQ(status("12 %", Dimension::angle), QuantityStatus::wrong_dimension);
    EXPECT_EQ(status("12 m", Dimension::angle), QuantityStatus::wrong_dimension);
    for (const std::string_view text : {"12 deg", "12 1/s", "12 Hz", "12 m/s", "12 deg/m", "12 deg/", "12 deg/s/s"}) {
        EXPECT_EQ(status(text, Dimension::angular_speed), QuantityStatus::wrong_dimension) << text;
    }
    EXPECT_EQ(status("inf m", Dimension::length), QuantityStatus::not_finite);
    EXPECT_EQ(status("nan m", Dimension::length), QuantityStatus::not_finite);
    EXPECT_EQ(status("1e999 m", Dimension::length), QuantityStatus::not_finite);
    EXPECT_EQ(status("1e308 km", Dimension::length), QuantityStatus::not_finite);
    EXPECT_EQ(parse_quantity("12 s", Dimension::length).message,
              "\"s\" is the wrong kind of unit: a length is expected, e.g. \"10 m\"");
    EXPECT_EQ(unitless_quantity(12, Dimension::length).status, QuantityStatus::missing_unit);
    EXPECT_EQ(unitless_quantity(std::numeric_limits<double>::quiet_NaN(), Dimension::ratio).status,
              QuantityStatus::not_finite);
}

// udunits2 takes each of these for a unit, which would change the value without a word.
TEST(Units, NothingHidesInAUnit) {
    for (const std::string_view text : {"30 2 m", "30 m 2", "30 m*2", "30 m.2", "30 m/2", "30 m @ 3", "30 (2) m"}) {
        EXPECT_EQ(status(text, Dimension::length), QuantityStatus::unknown_unit) << text;
    }
    EXPECT_EQ(status("30 kPa degree", Dimension::stress), QuantityStatus::wrong_dimension);
    EXPECT_EQ(status("30 m rad", Dimension::length), QuantityStatus::wrong_dimension);
    EXPECT_EQ(status("30 m-1", Dimension::length), QuantityStatus::wrong_dimension);
}

TEST(Units, WrittenQuantitiesReadBackIdentically) {
    for (const Dimension dimension :
         {Dimension::ratio, Dimension::angle, Dimension::length, Dimension::area, Dimension::stress, Dimension::volume,
          Dimension::force, Dimension::unit_weight, Dimension::force_per_length, Dimension::moment_per_length,
          Dimension::energy_per_length, Dimension::density, Dimension::stiffness, Dimension::time, Dimension::speed,
          Dimension::acceleration, Dimension::angular_speed}) {
        double value = 1.2345678e-7;
        for (int count = 0; count < 200; ++count, value *= 1.37) {
            const std::string text = written_quantity(value, dimension);
            if (dimension == Dimension::ratio) {
                EXPECT_EQ(std::stod(text), value);
            } else {
                EXPECT_EQ(si(text.substr(1, text.size() - 2), dimension), value) << text;
            }
        }
    }
    EXPECT_EQ(written_quantity(degrees(40), Dimension::angle), "\"40 deg\"");
    EXPECT_EQ(written_quantity(26e3, Dimension::unit_weight), "\"26 kN/m3\"");
}

TEST(Units, RangesReadLikeSentences) {
    EXPECT_EQ(readable_range(more_than(0), Dimension::length), "more than 0 m");
    EXPECT_EQ(readable_range(at_least(0), Dimension::stress), "at least 0 kPa");
    EXPECT_EQ(readable_range(within(0, degrees(89.9)), Dimension::angle), "from 0 to 89.9 deg");
    EXPECT_EQ(readable_range(between(0, degrees(90)), Dimension::angle), "between 0 and 90 deg (ends excluded)");
    EXPECT_EQ(readable_range({.lower = 0, .upper = degrees(90), .lower_open = true}, Dimension::angle),
              "more than 0 and at most 90 deg");
    EXPECT_EQ(readable_range(any_number(), Dimension::length), "");
}

}  // namespace
}  // namespace delabole
