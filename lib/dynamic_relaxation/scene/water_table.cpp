#include "dynamic_relaxation/scene/water_table.hpp"

#include <algorithm>

namespace delabole {

double water_table_height(const std::vector<SectionPoint>& table, double x) {
    const auto after = std::upper_bound(table.begin(), table.end(), x,
                                        [](double at, const SectionPoint& point) { return at < point.x; });
    if (after == table.begin() || after == table.end()) {
        return after == table.end() ? table.back().y : table.front().y;
    }
    const SectionPoint& before = *(after - 1);
    return before.y + (x - before.x) / (after->x - before.x) * (after->y - before.y);
}

std::vector<FaceDepth> depths_along(const std::vector<SectionPoint>& table, const PlanePoint<>& start,
                                    const PlanePoint<>& end) {
    const PlanePoint<> face = end - start;
    const double length = face.norm();
    std::vector<FaceDepth> depths;
    const auto add = [&](const FaceDepth& next) {
        // The face crosses the water table here.
        if (!depths.empty() && (depths.back().depth < 0) != (next.depth < 0)) {
            const FaceDepth& last = depths.back();
            const double at = last.place + last.depth / (last.depth - next.depth) * (next.place - last.place);
            if (at > last.place && at < next.place) {
                depths.push_back({at, 0});
            }
        }
        depths.push_back(next);
    };
    add({0, water_table_height(table, start.x()) - start.y()});
    const auto add_kink = [&](const SectionPoint& kink) {
        const double share = (kink.x - start.x()) / face.x();
        if (share * length > depths.back().place && share * length < length) {
            add({share * length, kink.y - (start.y() + share * face.y())});
        }
    };
    const auto by_x = [](const SectionPoint& point, double x) { return point.x < x; };
    const auto first = std::lower_bound(table.begin(), table.end(), std::min(start.x(), end.x()), by_x);
    const auto last = std::lower_bound(first, table.end(), std::max(start.x(), end.x()), by_x);
    if (face.x() > 0) {
        std::for_each(first, last, add_kink);
    } else {
        std::for_each(std::make_reverse_iterator(last), std::make_reverse_iterator(first), add_kink);
    }
    add({length, water_table_height(table, end.x()) - end.y()});
    for (FaceDepth& depth : depths) {
        depth.depth = std::max(depth.depth, 0.0);
    }
    return depths;
}

}  // namespace delabole
