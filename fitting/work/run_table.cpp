#include "fitting/work/run_table.hpp"

#include "fitting/work/bare_number.hpp"
#include "numerics/fnv_1a.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <locale>
#include <set>
#include <sstream>

namespace delabole {

namespace {

constexpr std::string_view failure_column = "failure";
constexpr std::string_view profile_column = "profile";
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> names_of(const std::vector<Quantity>& quantities) {
    std::vector<std::string> names;
    std::ranges::transform(quantities, std::back_inserter(names), &Quantity::name);
    return names;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
    std::vector<std::string_view> cells;
    std::size_t begin = 0;
    for (std::size_t end = 0; end != std::string_view::npos; begin = end + 1) {
        end = line.find(separator, begin);
        cells.push_back(line.substr(begin, end == std::string_view::npos ? end : end - begin));
    }
    return cells;
}

// Keeps the corners between two others from which the chain departs by more than the tolerance (Ramer 1972, Douglas &
// Peucker 1973).
void keep_corners(const Polyline& line, std::size_t first, std::size_t last, double tolerance, Polyline& kept) {
    std::size_t farthest = first;
    double greatest = tolerance;
    const Point along = (line[last] - line[first]).normalized();
    for (std::size_t corner = first + 1; corner < last; ++corner) {
        const Point offset = line[corner] - line[first];
        const double distance = std::abs(along.x() * offset.y() - along.y() * offset.x());
        if (distance > greatest) {
            greatest = distance;
            farthest = corner;
        }
    }
    if (farthest != first) {
        keep_corners(line, first, farthest, tolerance, kept);
        keep_corners(line, farthest, last, tolerance, kept);
    } else {
        kept.push_back(line[last]);
    }
}

Polyline corners_of(const Polyline& line) {
    constexpr double share_of_extent = 2e-4;
    if (line.size() < 3) {
        return line;
    }
    Eigen::AlignedBox<double, 2> box;
    for (const Point& point : line) {
        box.extend(point);
    }
    Polyline kept{line.front()};
    keep_corners(line, 0, line.size() - 1, share_of_extent * box.diagonal().norm(), kept);
    return kept;
}

constexpr int digits_of_inputs = 12;
constexpr int digits_of_outputs = 9;
constexpr int digits_of_profile = 6;

double rounded(double value, int digits) {
    std::array<char, 32> text{};
    const auto written =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    std::from_chars(text.data(), written.ptr, value);
    return value;
}

// The prediction as a reader of the table will find it, with rounded numbers.
RunTable::Outcome as_written(const Prediction& prediction) {
    RunTable::Outcome outcome{std::string(prediction.failure), prediction.outputs, corners_of(prediction.profile)};
    for (double& output : outcome.outputs) {
        output = rounded(output, digits_of_outputs);
    }
    for (Point& corner : outcome.profile) {
        corner = {rounded(corner.x(), digits_of_profile), rounded(corner.y(), digits_of_profile)};
    }
    return outcome;
}

bool agree(const RunTable::Key& one, const RunTable::Key& other) {
    constexpr double tolerance = 1e-9;
    return std::ranges::equal(one, other, [](const auto& left, const auto& right) {
        const double size = std::max(std::abs(left.second), std::abs(right.second));
        return left.first == right.first && std::abs(left.second - right.second) <= tolerance * size;
    });
}

// Where each column of a table goes.
struct Columns {
    std::vector<std::pair<std::size_t, std::size_t>> inputs;   // column, index of the input
    std::vector<std::pair<std::size_t, std::size_t>> outputs;  // column, index of the output
    std::size_t failure = 0;
    std::size_t profile = 0;
    std::size_t count = 0;
};

[[noreturn]] void refuse(std::size_t line, const std::string& reason) {
    throw RunTableError("line " + std::to_string(line) + ": " + reason);
}

Columns columns_of(std::string_view header, std::size_t line, const std::vector<std::string>& inputs,
                   const std::vector<std::string>& outputs) {
    const std::vector<std::string_view> names = split(header, ',');
    const auto failure = std::ranges::find(names, failure_column);
    if (failure == names.end() || names.back() != profile_column) {
        refuse(line, "the columns must be inputs, 'failure', outputs and 'profile'");
    }
    Columns columns;
    columns.failure = static_cast<std::size_t>(failure - names.begin());
    columns.profile = names.size() - 1;
    columns.count = names.size();
    for (std::size_t column = 0; column < columns.profile; ++column) {
        if (column == columns.failure) {
            continue;
        }
        const bool is_input = column < columns.failure;
        const std::vector<std::string>& known = is_input ? inputs : outputs;
        const auto place = std::ranges::find(known, names[column]);
        if (place == known.end()) {
            refuse(line,
                   "'" + std::string(names[column]) + "' is no " + (is_input ? "input" : "output") + " of the model");
        }
        (is_input ? columns.inputs : columns.outputs)
            .emplace_back(column, static_cast<std::size_t>(place - known.begin()));
    }
    return columns;
}

double number_of(std::string_view cell, std::size_t line) {
    const auto number = bare_number(cell);
    if (!number || std::isnan(*number)) {
        refuse(line, "'" + std::string(cell) + "' is no number");
    }
    return *number;
}

Polyline profile_of(std::string_view cell, std::size_t line) {
    std::vector<double> coordinates;
    if (!cell.empty()) {
        for (const std::string_view number : split(cell, ' ')) {
            coordinates.push_back(number_of(number, line));
        }
    }
    if (coordinates.size() % 2 != 0) {
        refuse(line, "the profile has an odd number of coordinates");
    }
    Polyline profile;
    for (std::size_t index = 0; index < coordinates.size(); index += 2) {
        profile.emplace_back(coordinates[index], coordinates[index + 1]);
    }
    return profile;
}

}  // namespace

RunTable::Key RunTable::key_of(std::span<const Assignment> assignments) {
    std::map<std::size_t, double> values;
    for (const Assignment& assignment : assignments) {
        values[assignment.input] = assignment.value;
    }
    return {values.begin(), values.end()};
}

RunTable::RunTable(const ModelInterface& model, std::string_view description)
    : inputs_(names_of(model.inputs)), outputs_(names_of(model.outputs)) {
    std::ostringstream hash;
    hash << std::hex << std::setw(16) << std::setfill('0') << fnv_1a(description);
    model_ = "# runs of model " + hash.str();
}

void RunTable::read(std::string_view text) {
    std::map<Key, Outcome> runs;
    Columns columns;
    std::size_t number = 0;
    for (const std::string_view line : split(text, '\n')) {
        ++number;
        if (number == 1) {
            if (line != model_) {
                refuse(number, "the table was made for another model; this one needs '" + model_ + "'");
            }
        } else if (number == 2) {
            columns = columns_of(line, number, inputs_, outputs_);
        } else if (!line.empty()) {
            const std::vector<std::string_view> cells = split(line, ',');
            if (cells.size() != columns.count) {
                refuse(number, std::to_string(cells.size()) + " cells instead of " + std::to_string(columns.count));
            }
            Key key;
            for (const auto& [column, input] : columns.inputs) {
                if (!cells[column].empty()) {
                    key.emplace_back(input, number_of(cells[column], number));
                }
            }
            std::ranges::sort(key);
            Outcome outcome{std::string(cells[columns.failure]), {}, profile_of(cells[columns.profile], number)};
            if (outcome.failure.empty()) {
                outcome.outputs.assign(outputs_.size(), nothing);
                for (const auto& [column, output] : columns.outputs) {
                    if (!cells[column].empty()) {
                        outcome.outputs[output] = number_of(cells[column], number);
                    }
                }
            }
            runs.insert_or_assign(std::move(key), std::move(outcome));
        }
    }
    if (columns.count == 0) {
        refuse(number, "the text ends before its columns");
    }
    runs_.merge(runs);
}

const RunTable::Outcome& RunTable::add(const Key& key, const Outcome& outcome) {
    return runs_.try_emplace(key, outcome).first->second;
}

const RunTable::Outcome* RunTable::find(const Key& key) const {
    auto run = runs_.find(key);
    if (run == runs_.end()) {
        run = std::ranges::find_if(runs_, [&](const auto& known) { return agree(known.first, key); });
    }
    return run == runs_.end() ? nullptr : &run->second;
}

std::string RunTable::text() const {
    std::set<std::size_t> inputs;
    std::set<std::size_t> outputs;
    for (const auto& [key, outcome] : runs_) {
        for (const auto& [input, value] : key) {
            inputs.insert(input);
        }
        for (std::size_t output = 0; output < outcome.outputs.size(); ++output) {
            if (!std::isnan(outcome.outputs[output])) {
                outputs.insert(output);
            }
        }
    }
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << model_ << '\n';
    for (const std::size_t input : inputs) {
        text << inputs_[input] << ',';
    }
    text << failure_column << ',';
    for (const std::size_t output : outputs) {
        text << outputs_[output] << ',';
    }
    text << profile_column << '\n';
    for (const auto& [key, outcome] : runs_) {
        text << std::setprecision(digits_of_inputs);
        for (const std::size_t input : inputs) {
            const auto value = std::ranges::find(key, input, &Key::value_type::first);
            if (value != key.end()) {
                text << value->second;
            }
            text << ',';
        }
        text << outcome.failure << ',' << std::setprecision(digits_of_outputs);
        for (const std::size_t output : outputs) {
            if (output < outcome.outputs.size() && !std::isnan(outcome.outputs[output])) {
                text << outcome.outputs[output];
            }
            text << ',';
        }
        text << std::setprecision(digits_of_profile);
        const char* before = "";
        for (const Point& corner : outcome.profile) {
            text << before << corner.x() << ' ' << corner.y();
            before = " ";
        }
        text << '\n';
    }
    return text.str();
}

ModelInterface tabled(ModelInterface model, TabledRuns& runs) {
    const auto predict = model.predict;
    model.predict = [predict, &runs](std::span<const Assignment> assignments) {
        RunTable::Key key = RunTable::key_of(assignments);
        std::vector<Assignment> as_read;
        for (auto& [input, value] : key) {
            value = rounded(value, digits_of_inputs);
            as_read.push_back({input, value});
        }
        const RunTable::Outcome* known = runs.known.find(key);
        const RunTable::Outcome outcome = known != nullptr ? *known : as_written(predict(as_read));
        const std::lock_guard lock(runs.mutex);
        runs.found += known != nullptr ? 1 : 0;
        const RunTable::Outcome& used = runs.used.add(key, outcome);
        return Prediction{used.failure, used.outputs, used.profile};
    };
    return model;
}

}  // namespace delabole
