#include "limit_equilibrium/stepped_base/critical_base.hpp"

#include "numerics/constants.hpp"
#include "numerics/scalar_search.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr int inclination_points = 16;

struct Range {
    double lower;
    double upper;
};

class BaseSearch {
  public:
    BaseSearch(const ColumnScene<>& scene, const CriticalBaseSearch<>& request, const ColumnSafety& factor_of_safety)
        : scene_(scene), request_(request), factor_of_safety_(factor_of_safety) {
        if (request.under == SearchCondition::dry_slope) {
            scene_.water = Dry{};
            if (scene_.slide_head) {
                scene_.slide_head->water.reset();
            }
        }
    }

    const ColumnScene<>& scene() const { return scene_; }
    int evaluations() const { return evaluations_; }

    double value() {
        ++evaluations_;
        const double found = factor_of_safety_(scene_);
        return std::isfinite(found) ? found : infinity;
    }

    void put_inclination(double inclination) {
        with_layout([&](auto& layout) { layout.base_inclination = inclination; });
    }
    void put_extent(double height) {
        with_layout([&](auto& layout) { layout.base_end_height = height; });
    }

    Range inclinations() {
        double joint_dip = 0;
        with_layout([&](auto& layout) { joint_dip = layout.joint_dip; });
        return {request_.lower_inclination.value_or(degrees(90) - joint_dip),
                request_.upper_inclination.value_or(scene_.slope->face_dip * (1 - 1e-3))};
    }

    ScalarMinimum over_extent() {
        const Range range = extents();
        const auto at = [&](double height) { return put_extent(height), value(); };
        ScalarMinimum minimum = minimise(at, range, extent_points(range));
        if (std::isfinite(minimum.value)) {
            minimum.value = at(minimum.position);
        }
        return minimum;
    }

    ScalarMinimum over_inclination(bool with_extent) {
        bool extent_at_boundary = false;
        const auto at = [&](double inclination) {
            put_inclination(inclination);
            if (!with_extent) {
                return value();
            }
            const ScalarMinimum extent = over_extent();
            extent_at_boundary = extent.at_boundary;
            return extent.value;
        };
        ScalarMinimum minimum = minimise(at, inclinations(), inclination_points);
        if (std::isfinite(minimum.value)) {
            minimum.value = at(minimum.position);
            minimum.at_boundary = minimum.at_boundary || extent_at_boundary;
        }
        return minimum;
    }

  private:
    template <class Function>
    void with_layout(const Function& function) {
        if (auto* continuous = std::get_if<ContinuousColumns<>>(&scene_.columns)) {
            function(*continuous);
        } else if (auto* classical = std::get_if<ClassicalColumns<>>(&scene_.columns)) {
            function(*classical);
        }
    }

    template <class Function>
    ScalarMinimum minimise(const Function& at, const Range& range, int points) {
        const double step = 1e-7 * (range.upper - range.lower);
        const auto slope = [&](double position) {
            const double below = std::max(range.lower, position - step);
            const double above = std::min(range.upper, position + step);
            return (at(above) - at(below)) / (above - below);
        };
        return minimise_scalar(at, slope, range.lower, range.upper, points);
    }

    // Range of heights at which the base may end: up to where it meets the ground, unless the request ends it before.
    Range extents() {
        const double height = scene_.slope->height;
        const double lower = request_.lower_end_height.value_or(height / 100);
        if (request_.upper_end_height) {
            return {lower, *request_.upper_end_height};
        }
        with_layout([](auto& layout) { layout.base_end_height.reset(); });
        const ColumnShapes<> shapes = make_shapes(scene_.slope, scene_.columns);
        if (shapes.check != ColumnCheck::valid) {
            return {lower, 2 * height};
        }
        const ColumnShape<>& last = shapes.columns.back();
        const PlanePoint<> end = detail::turned_back(shapes.base, PlanePoint<>(last.base_u + last.width, last.base_v));
        return {lower, std::max(end.y(), 2 * lower)};
    }

    // There may be one minimum for every column.
    int extent_points(const Range& range) {
        double rise_per_column = range.upper;
        with_layout([&](auto& layout) {
            rise_per_column = layout.spacing * std::sin(layout.base_inclination) /
                              std::cos(layout.base_inclination - (degrees(90) - layout.joint_dip));
        });
        return static_cast<int>(std::clamp(4 * range.upper / rise_per_column, 16.0, 64.0));
    }

    ColumnScene<> scene_;
    const CriticalBaseSearch<>& request_;
    const ColumnSafety& factor_of_safety_;
    int evaluations_ = 0;
};

}  // namespace

CriticalBase find_critical_base(const ColumnScene<>& scene, const CriticalBaseSearch<>& request,
                                const ColumnSafety& factor_of_safety) {
    CriticalBase critical;
    critical.scene = scene;
    if (!scene.slope || std::holds_alternative<BlockColumns<>>(scene.columns)) {
        critical.check = ColumnCheck::slope_needed;
        return critical;
    }
    BaseSearch search(scene, request, factor_of_safety);
    if (const Range range = search.inclinations(); !(range.lower < range.upper)) {
        critical.check = ColumnCheck::base_does_not_daylight;
        return critical;
    }
    const ScalarMinimum minimum = request.find == CriticalBaseFeature::extent
                                      ? search.over_extent()
                                      : search.over_inclination(request.find == CriticalBaseFeature::both);
    critical.evaluations = search.evaluations();
    if (!std::isfinite(minimum.value)) {
        critical.check = make_columns(scene).check;
        critical.factor_of_safety = infinity;
        return critical;
    }
    critical.scene.columns = search.scene().columns;
    critical.check = make_columns(critical.scene).check;
    critical.factor_of_safety = minimum.value;
    critical.at_boundary = minimum.at_boundary;
    return critical;
}

}  // namespace delabole
