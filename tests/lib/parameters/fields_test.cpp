#include "parameters/fields.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using delabole::any_number;
using delabole::at_least;
using delabole::between;
using delabole::Described;
using delabole::Dimension;
using delabole::display_unit;
using delabole::FieldInfo;
using delabole::FieldTable;
using delabole::for_each_named_number;
using delabole::for_each_number;
using delabole::inlined;
using delabole::Interval;
using delabole::more_than;
using delabole::number;
using delabole::NumberType;
using delabole::section;
using delabole::visit_fields;
using delabole::with_scalar;
using delabole::within;

// A small house with one member of every kind that fields.hpp lists.

enum class Colour { grey, green };

template <class T = double>
struct Depth {
    T depth;
    static constexpr auto fields() {
        return FieldTable{number("depth", &Depth::depth, Dimension::length, at_least(0), "depth")};
    }
};

template <class T = double>
struct Ratio {
    T ratio;
    static constexpr auto fields() {
        return FieldTable{number("ratio", &Ratio::ratio, Dimension::ratio, within(0, 1), "ratio")};
    }
};

template <class T = double>
struct Smooth {
    T friction;
    static constexpr std::string_view kind = "smooth";
    static constexpr auto fields() {
        return FieldTable{number("friction", &Smooth::friction, Dimension::angle, within(0, 1.5), "friction")};
    }
};

template <class T = double>
struct Rough {
    T friction;
    T roughness;
    static constexpr std::string_view kind = "rough";
    static constexpr auto fields() {
        return FieldTable{number("friction", &Rough::friction, Dimension::angle, within(0, 1.5), "friction"),
                          number("roughness", &Rough::roughness, Dimension::angle, within(0, 1.5), "roughness")};
    }
};

template <class T = double>
struct House {
    std::string name;
    Colour colour;
    T weight;
    std::optional<T> cohesion;
    Depth<T> cellar;
    std::optional<Depth<T>> well;
    std::variant<Smooth<T>, Rough<T>> wall;
    std::variant<Depth<T>, Ratio<T>> level;
    std::vector<Depth<T>> pit;
    static constexpr auto fields() {
        return FieldTable{section("name", &House::name, "text"),
                          section("colour", &House::colour, "word"),
                          number("weight", &House::weight, Dimension::unit_weight, more_than(0), "weight"),
                          number("cohesion", &House::cohesion, Dimension::stress, at_least(0), "cohesion"),
                          section("cellar", &House::cellar, "section"),
                          section("well", &House::well, "optional section"),
                          section("wall", &House::wall, "keyed variant"),
                          inlined(&House::level, "inlined variant"),
                          section("pit", &House::pit, "array")};
    }
};

House<> plain_house() {
    return {.name = "plain",
            .colour = Colour::grey,
            .weight = 1,
            .cohesion = std::nullopt,
            .cellar = {2},
            .well = std::nullopt,
            .wall = Smooth<>{3},
            .level = Depth<>{4},
            .pit = {}};
}

House<> full_house() {
    return {.name = "full",
            .colour = Colour::green,
            .weight = 1,
            .cohesion = 2,
            .cellar = {3},
            .well = Depth<>{4},
            .wall = Rough<>{0.5, 0.6},
            .level = Ratio<>{0.7},
            .pit = {{8}, {9}}};
}

using NamedNumbers = std::vector<std::pair<std::string, double>>;

NamedNumbers named_numbers(const House<>& house) {
    NamedNumbers found;
    for_each_named_number(
        house, [&](const std::string& path, const FieldInfo&, double value) { found.emplace_back(path, value); });
    return found;
}

static_assert(Described<House<>> && Described<const House<>>);
static_assert(!Described<double> && !Described<std::string>);
static_assert(NumberType<double> && NumberType<const double> && NumberType<long double>);
static_assert(!NumberType<std::string> && !NumberType<Colour> && !NumberType<Depth<>>);
static_assert(!NumberType<std::optional<double>> && !NumberType<std::vector<double>>);

TEST(Interval, ClosedEndsBelongToItAndOpenEndsDoNot) {
    EXPECT_TRUE(within(0, 1).contains(0));
    EXPECT_TRUE(within(0, 1).contains(1));
    EXPECT_FALSE(between(0, 1).contains(0));
    EXPECT_FALSE(between(0, 1).contains(1));
    EXPECT_TRUE(between(0, 1).contains(std::numeric_limits<double>::denorm_min()));
    EXPECT_FALSE(more_than(0).contains(0));
    EXPECT_TRUE(at_least(0).contains(0));
    EXPECT_FALSE(at_least(0).contains(-std::numeric_limits<double>::denorm_min()));
}

TEST(Interval, NeverContainsNaN) {
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    for (const Interval& interval : {any_number(), at_least(0), more_than(0), within(0, 1), between(0, 1)}) {
        EXPECT_FALSE(interval.contains(not_a_number));
    }
    EXPECT_TRUE(any_number().contains(-1e300));
}

TEST(DisplayUnit, ConvertsToSI) {
    EXPECT_EQ(display_unit(Dimension::ratio).si_per_unit, 1);
    EXPECT_EQ(display_unit(Dimension::length).si_per_unit, 1);
    EXPECT_EQ(display_unit(Dimension::area).si_per_unit, 1);
    EXPECT_EQ(display_unit(Dimension::stress).si_per_unit, 1000);
    EXPECT_EQ(display_unit(Dimension::unit_weight).si_per_unit, 1000);
    EXPECT_EQ(display_unit(Dimension::volume).si_per_unit, 1);
    EXPECT_EQ(display_unit(Dimension::force).si_per_unit, 1000);
    EXPECT_EQ(display_unit(Dimension::force_per_length).si_per_unit, 1000);
    EXPECT_EQ(display_unit(Dimension::moment_per_length).si_per_unit, 1000);
    // pi / 180 rounded once, times 180 rounded once: two halves of an ulp.
    EXPECT_NEAR(delabole::degrees(180), std::numbers::pi, 4 * std::numeric_limits<double>::epsilon());
}

TEST(DisplayUnit, EveryDimensionButRatioNamesItsUnitInColumns) {
    EXPECT_EQ(display_unit(Dimension::ratio).suffix, "");
    EXPECT_EQ(display_unit(Dimension::angle).suffix, "_deg");
    EXPECT_EQ(display_unit(Dimension::length).suffix, "_m");
    EXPECT_EQ(display_unit(Dimension::area).suffix, "_m2");
    EXPECT_EQ(display_unit(Dimension::stress).suffix, "_kPa");
    EXPECT_EQ(display_unit(Dimension::unit_weight).suffix, "_kN_per_m3");
    EXPECT_EQ(display_unit(Dimension::volume).suffix, "_m3");
    EXPECT_EQ(display_unit(Dimension::force).suffix, "_kN");
    EXPECT_EQ(display_unit(Dimension::force_per_length).suffix, "_kN_per_m");
    EXPECT_EQ(display_unit(Dimension::moment_per_length).suffix, "_kN_m_per_m");
}

TEST(VisitFields, GoesThroughTheTableInOrder) {
    const House<> house = full_house();
    std::vector<std::string_view> keys;
    visit_fields(house, [&](const FieldInfo& info, const auto&) { keys.push_back(info.key); });
    const std::vector<std::string_view> expected = {"name", "colour", "weight", "cohesion", "cellar",
                                                    "well", "wall",   "",       "pit"};
    EXPECT_EQ(keys, expected);
}

TEST(ForEachNumber, TellsDimensionAndRangeOfEachMember) {
    const House<> house = full_house();
    std::vector<Dimension> dimensions;
    for_each_number(house, [&](const double& value, const FieldInfo& info) {
        EXPECT_TRUE(info.range.contains(value)) << info.key;
        dimensions.push_back(info.dimension);
    });
    using enum Dimension;
    const std::vector<Dimension> expected = {unit_weight, stress, length, length, angle, angle, ratio, length, length};
    EXPECT_EQ(dimensions, expected);
}

TEST(ForEachNumber, ReachesWhatItVisits) {
    House<> house = full_house();
    for_each_number(house, [](double& value, const FieldInfo&) { value *= 10; });
    EXPECT_EQ(house.weight, 10);
    EXPECT_EQ(house.cohesion, 20);
    EXPECT_EQ(house.cellar.depth, 30);
    EXPECT_EQ(house.well->depth, 40);
    EXPECT_EQ(std::get<Rough<>>(house.wall).roughness, 6);
    EXPECT_EQ(std::get<Ratio<>>(house.level).ratio, 7);
    EXPECT_EQ(house.pit[1].depth, 90);
    EXPECT_EQ(house.name, "full");
}

TEST(ForEachNamedNumber, SkipsWhatIsAbsent) {
    const NamedNumbers expected = {{"weight", 1}, {"cellar.depth", 2}, {"wall.friction", 3}, {"depth", 4}};
    EXPECT_EQ(named_numbers(plain_house()), expected);
}

TEST(ForEachNamedNumber, NamesSectionsWithADotArraysFromOneAndInlinedKeysBare) {
    const NamedNumbers expected = {{"weight", 1},     {"cohesion", 2},        {"cellar.depth", 3},
                                   {"well.depth", 4}, {"wall.friction", 0.5}, {"wall.roughness", 0.6},
                                   {"ratio", 0.7},    {"pit[1].depth", 8},    {"pit[2].depth", 9}};
    EXPECT_EQ(named_numbers(full_house()), expected);
}

TEST(WithScalar, KeepsEveryMemberAndAlternative) {
    const auto wide = with_scalar<House<long double>>(full_house());
    EXPECT_EQ(wide.name, "full");
    EXPECT_EQ(wide.colour, Colour::green);
    EXPECT_EQ(wide.cohesion, 2.0L);
    EXPECT_EQ(wide.well->depth, 4.0L);
    // 0.6 and 0.7 are not representable: the wider number must be the double's value, not a new 0.6.
    EXPECT_EQ(std::get<Rough<long double>>(wide.wall).roughness, static_cast<long double>(0.6));
    EXPECT_EQ(std::get<Ratio<long double>>(wide.level).ratio, static_cast<long double>(0.7));
    ASSERT_EQ(wide.pit.size(), 2U);
    EXPECT_EQ(wide.pit[1].depth, 9.0L);
    EXPECT_EQ(named_numbers(with_scalar<House<>>(wide)), named_numbers(full_house()));
}

TEST(WithScalar, LeavesAbsentWhatIsAbsent) {
    const auto wide = with_scalar<House<long double>>(plain_house());
    EXPECT_FALSE(wide.cohesion.has_value());
    EXPECT_FALSE(wide.well.has_value());
    EXPECT_TRUE(wide.pit.empty());
    EXPECT_EQ(wide.wall.index(), 0U);
    EXPECT_EQ(wide.level.index(), 0U);
}

}  // namespace
