#include "plots/figures/stereonet.hpp"
#include "samples.hpp"
#include "series_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace delabole {
namespace {

bool names(const Figure& figure, std::string_view text) {
    std::vector<std::string> texts = legends(figure);
    for (const Label& label : figure.labels) {
        texts.push_back(label.text);
    }
    return std::ranges::any_of(texts, [&](const std::string& one) { return one.find(text) != std::string::npos; });
}

TEST(StereonetFigure, NamesWhatItShows) {
    const Figure poles = pole_figure(samples::stereonet());
    for (const std::string_view text :
         {"joint set a 80/102.5", "joint set b 85/282.5", "cleavage", "face 70/102.5", "daylight envelope",
          "planes dipping 20°", "poles that slide, ±20°", "poles that topple", "sampled poles, at most 150",
          "density of the sampled poles, 2, 4, 8"}) {
        EXPECT_TRUE(names(poles, text)) << text;
    }
    const Figure planes = plane_figure(samples::stereonet());
    for (const std::string_view text :
         {"joint set c 47.5/110", "face 70/102.5", "lines plunging 20°", "wedges that slide", "secondary zone",
          "toppling columns", "lines of intersection"}) {
        EXPECT_TRUE(names(planes, text)) << text;
    }
}

// A ground of its own would hide contours and circles.
TEST(StereonetFigure, OfPolesHasNoNamesOverThePoles) {
    for (const Label& label : pole_figure(samples::stereonet()).labels) {
        EXPECT_FALSE(label.boxed) << label.text;
    }
}

TEST(StereonetFigure, GivesPlanesToATenthOfADegree) {
    StereonetDrawing drawing = samples::stereonet();
    drawing.joint_set.front().mean = {degrees(36.78), degrees(99.28)};
    EXPECT_TRUE(names(pole_figure(drawing), "joint set a 36.8/99.3"));
}

TEST(StereonetFigure, KeepsEverythingButItsTicksOnTheNet) {
    StereonetDrawing drawing = samples::stereonet();
    for (const NetProjection projection : {NetProjection::equal_area, NetProjection::equal_angle}) {
        drawing.projection = projection;
        for (const Figure& figure : {pole_figure(drawing), plane_figure(drawing)}) {
            double furthest = 0;
            const auto include = [&](const Polyline& points, double allowed) {
                for (const Point& point : points) {
                    if (std::isfinite(point.x())) {
                        EXPECT_LE(point.norm(), allowed);
                        furthest = std::max(furthest, point.norm());
                    }
                }
            };
            constexpr double rounding = 1e-12;
            for (const Points& points : all<Points>(figure)) {
                include(points.points, 1 + rounding);
            }
            for (const Region& region : all<Region>(figure)) {
                include(region.outline, 1 + rounding);
            }
            const std::vector<Line> lines = all<Line>(figure);
            for (std::size_t index = 0; index < lines.size(); ++index) {
                // The ticks come last; the longest stands at north.
                include(lines[index].points, index + 1 == lines.size() ? 1.06 : 1 + rounding);
            }
            EXPECT_GT(furthest, 1.03);
        }
    }
}

// North is up and east is right: the face dips to 102.5, so that its great circle lies in the east half and the poles
// of planes dipping like it in the west half.
TEST(StereonetFigure, IsALowerHemisphereWithNorthUp) {
    const Figure figure = pole_figure(samples::stereonet());
    for (const Line& line : all<Line>(figure)) {
        if (line.width == 4) {  // the face
            EXPECT_GT(line.points[line.points.size() / 2].x(), 0.2);
        }
        if (line.legend.starts_with("daylight")) {
            EXPECT_LT(line.points[line.points.size() / 2].x(), -0.2);
        }
    }
    for (const Points& points : all<Points>(figure)) {
        if (points.size == 2 && points.colour == Colour::blue) {  // joint set a
            EXPECT_LT(points.points[0].x(), -0.8);
        }
        if (points.size == 2 && points.colour == Colour::vermilion) {  // joint set b
            EXPECT_GT(points.points[0].x(), 0.8);
        }
    }
    const auto north = std::ranges::find(figure.labels, "N", &Label::text);
    ASSERT_NE(north, figure.labels.end());
    EXPECT_GT(north->at.y(), 1);
}

TEST(StereonetFigure, LeavesOutZonesInWhichNothingMoves) {
    StereonetDrawing drawing = samples::stereonet();
    drawing.slope.face_dip = degrees(15);
    EXPECT_TRUE(all<Region>(pole_figure(drawing)).empty());
    EXPECT_FALSE(names(pole_figure(drawing), "poles that"));
    drawing.joint_set.clear();
    drawing.intersection.clear();
    EXPECT_TRUE(all<Points>(plane_figure(drawing)).empty());
    EXPECT_FALSE(names(pole_figure(drawing), "density"));
}

// Nine of the ten intersections of the Delabole sets lie within a few degrees of the common strike.
TEST(StereonetFigure, GathersLabelsOfLinesThatLieTogether) {
    const Figure figure = plane_figure(samples::stereonet());
    const auto has = [&](std::string_view text) {
        return std::ranges::any_of(figure.labels, [&](const Label& label) { return label.text == text; });
    };
    EXPECT_TRUE(has("1–3, 5–10"));
    EXPECT_TRUE(has("4"));
}

TEST(StereonetFigure, HasNoFrame) {
    const std::string script = gnuplot_script(plane_figure(samples::stereonet()), "net");
    EXPECT_NE(script.find("set border 0"), std::string::npos);
    EXPECT_NE(script.find("unset xtics"), std::string::npos);
    EXPECT_EQ(script.find("set xlabel"), std::string::npos);
}

TEST(StereonetFigure, DrawsEveryMeasuredPole) {
    const StereonetDrawing drawing = samples::measured_stereonet();
    std::size_t small_marks = 0;
    for (const Points& points : all<Points>(pole_figure(drawing))) {
        small_marks += points.size < 1 ? points.points.size() : 0;
    }
    EXPECT_EQ(small_marks, drawing.joint_set.size() * 30 + 2);
    EXPECT_TRUE(names(pole_figure(drawing), "measured poles of no set"));
    EXPECT_TRUE(names(kamb_figure(drawing), "standard deviations above uniform poles"));
}

// The area of a petal says how much lies in it, and planes that dip east strike north.
TEST(StereonetFigure, RosetteShowsStrikesAtBothEnds) {
    const std::vector<Orientation> planes{
        {degrees(40), degrees(93)}, {degrees(40), degrees(272)}, {degrees(40), degrees(5)}};
    const std::vector<Region> petals = all<Region>(rosette_figure("strikes", planes, {1, 3, 1}));
    ASSERT_EQ(petals.size(), 4U);  // two classes, two ends of each
    double furthest_north = 0;
    double furthest_east = 0;
    for (const Region& petal : petals) {
        for (const Point& point : petal.outline) {
            furthest_north = std::max(furthest_north, std::abs(point.y()));
            furthest_east = std::max(furthest_east, std::abs(point.x()));
        }
    }
    EXPECT_NEAR(furthest_north, 1, 0.01);   // the largest reaches the circle, but for the turn of its middle
    EXPECT_NEAR(furthest_east, 0.5, 0.01);  // a quarter of its area
}

TEST(WedgeFigure, ShowsTheWedgeBetweenFaceAndUpperSurface) {
    const Figure figure = wedge_figure(samples::wedge());
    EXPECT_TRUE(figure.equal_scales);
    EXPECT_TRUE(names(figure, "tension crack, inside the rock"));
    EXPECT_TRUE(names(figure, "direction of sliding"));
    WedgeDrawing whole = samples::wedge();
    whole.cracked = false;
    whole.crack_1 = whole.crack_2 = whole.line_end;
    EXPECT_FALSE(names(wedge_figure(whole), "tension crack"));
    EXPECT_FALSE(names(slid_wedge_figure(whole), "tension crack"));
}

}  // namespace
}  // namespace delabole
