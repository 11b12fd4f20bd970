// Tables and figures over time.
#include "cases/program/models/relaxation/figures.hpp"
#include "plots/drawing/text.hpp"

#include <cmath>
#include <functional>

namespace delabole {

namespace {

// A column of the history.
struct Column {
    std::string name;
    Dimension dimension;
    std::function<double(const HistoryLine&)> value;
};

std::string name_of(double number) {
    return std::to_string(static_cast<std::size_t>(number));
}

std::vector<Column> energy_columns() {
    std::vector<Column> columns;
    const auto add = [&](const auto& field) {
        // the share of the residual is a ratio and has no place here
        if (field.info.dimension == Dimension::energy_per_length) {
            columns.push_back(
                {std::string(field.info.key), field.info.dimension,
                 [member = field.member](const HistoryLine& line) { return std::invoke(member, line.energy); }});
        }
    };
    field_table<EnergyBalance>.for_each(add);
    return columns;
}

std::vector<Column> monitor_columns(const HistoryRequest& request) {
    std::vector<Column> columns;
    for (std::size_t index = 0; index < request.block.size(); ++index) {
        const std::string block = "block_" + name_of(request.block[index].block) + "_";
        const auto add = [&](const std::string& name, Dimension dimension, auto member) {
            columns.push_back({block + name, dimension,
                               [index, member](const HistoryLine& line) { return line.block[index].*member; }});
        };
        add("x", Dimension::length, &MonitoredBlock::x);
        add("y", Dimension::length, &MonitoredBlock::y);
        add("rotation", Dimension::angle, &MonitoredBlock::rotation);
        add("velocity_x", Dimension::speed, &MonitoredBlock::velocity_x);
        add("velocity_y", Dimension::speed, &MonitoredBlock::velocity_y);
        add("angular_velocity", Dimension::angular_speed, &MonitoredBlock::angular_velocity);
    }
    for (std::size_t index = 0; index < request.contact.size(); ++index) {
        const ContactMonitor& monitor = request.contact[index];
        const std::string contact = "contact_" + name_of(monitor.block) + "_" + name_of(monitor.other) + "_";
        const auto add = [&](const std::string& name, Dimension dimension, auto member) {
            columns.push_back({contact + name, dimension,
                               [index, member](const HistoryLine& line) { return line.contact[index].*member; }});
        };
        add("horizontal", Dimension::force_per_length, &MonitoredContact::horizontal);
        add("vertical", Dimension::force_per_length, &MonitoredContact::vertical);
        add("normal", Dimension::force_per_length, &MonitoredContact::normal);
        add("overlap", Dimension::length, &MonitoredContact::overlap);
    }
    return columns;
}

std::vector<Column> bolt_columns(const HistoryLine& any) {
    std::vector<Column> columns;
    for (std::size_t bolt = 0; bolt < any.bolt.size(); ++bolt) {
        columns.push_back({"bolt_" + std::to_string(bolt + 1) + "_force", Dimension::force_per_length,
                           [bolt](const HistoryLine& line) { return line.bolt[bolt]; }});
    }
    return columns;
}

std::string history_csv(const HistoryRequest& request, const RelaxationHistory& history) {
    std::vector<Column> columns{{"time", Dimension::time, [](const HistoryLine& line) { return line.time; }},
                                {"tilt", Dimension::angle, [](const HistoryLine& line) { return line.tilt; }}};
    for (auto&& more : {monitor_columns(request), bolt_columns(history.front()), energy_columns()}) {
        columns.insert(columns.end(), more.begin(), more.end());
    }
    std::vector<std::string> titles;
    for (const Column& column : columns) {
        titles.push_back(column_name(column.name, column.dimension));
    }
    CsvTable csv(titles);
    for (const HistoryLine& line : history) {
        std::vector<Cell> row;
        for (const Column& column : columns) {
            row.emplace_back(in_display_unit(column.value(line), column.dimension));
        }
        csv.add_row(row);
    }
    return csv.text();
}

std::vector<std::size_t> free_blocks(const RelaxationScene& scene) {
    std::vector<std::size_t> blocks;
    for (std::size_t block = 0; block < scene.block.size(); ++block) {
        if (!scene.block[block].fixed) {
            blocks.push_back(block);
        }
    }
    return blocks;
}

// Returns the abbreviation of the thesis's tables for blocks between two print edits (Tables 5.1 to 5.5).
std::string movement_word(double slip, double size) {
    constexpr double least_share = 1e-6;  // of the block; a smaller slip is the elastic deformation of the springs
    if (std::abs(slip) <= least_share * size) {
        return "-";
    }
    return slip < 0 ? "F.S." : "B.S.";
}

std::string movements_csv(const RelaxationRun& made) {
    const Bodies bodies = make_bodies(made.scene);
    const std::vector<std::size_t> blocks = free_blocks(made.scene);
    std::vector<std::string> titles{"time_s"};
    for (const std::size_t block : blocks) {
        titles.push_back("block_" + std::to_string(block + 1));
    }
    CsvTable csv(titles);
    for (std::size_t index = 1; index < made.history.size(); ++index) {
        std::vector<Cell> row{made.history[index].time};
        for (const std::size_t block : blocks) {
            const double slip = made.history[index].base_slip[block] - made.history[index - 1].base_slip[block];
            row.emplace_back(movement_word(slip, bodies.radius[block]));
        }
        csv.add_row(row);
    }
    return csv.text();
}

Table movement_table(const RelaxationRun& made) {
    const Bodies bodies = make_bodies(made.scene);
    Table table{
        "Intervals in which each block slid over its base: forward (F.S.), backward (B.S.), not at all (-). "
        "movements.csv has every interval.",
        {"block"_number, "F.S."_number, "B.S."_number, "-"_number}};
    constexpr std::size_t most_rows = 60;
    for (const std::size_t block : free_blocks(made.scene)) {
        std::array<int, 3> count{};
        for (std::size_t index = 1; index < made.history.size(); ++index) {
            const std::string word = movement_word(
                made.history[index].base_slip[block] - made.history[index - 1].base_slip[block], bodies.radius[block]);
            ++count[word == "F.S." ? 0 : word == "B.S." ? 1 : 2];
        }
        if (table.rows.size() < most_rows) {
            table.rows.push_back({std::to_string(block + 1), std::to_string(count[0]), std::to_string(count[1]),
                                  std::to_string(count[2])});
        }
    }
    return table;
}

constexpr std::size_t most_curves = 16;
constexpr std::array curve_colours{Colour::blue,   Colour::vermilion, Colour::green, Colour::orange,
                                   Colour::purple, Colour::sky,       Colour::grey,  Colour::black};

Figure curves(const RelaxationHistory& history, const std::vector<Column>& columns, const std::string& title,
              const Axis& axis) {
    Figure figure{.title = title};
    figure.x = {.title = "time", .unit = "s"};
    figure.y = axis;
    for (std::size_t index = 0; index < columns.size(); ++index) {
        Line line{.legend = human_name(columns[index].name)};
        const bool again = index >= curve_colours.size();
        line.colour = curve_colours[(again ? index - 1 : index) % curve_colours.size()];
        line.dash = again ? Dash::dashed : Dash::solid;
        // A wider line is visible on both sides of another curve that covers it.
        line.width *= index == 0 ? 2 : 1;
        constexpr double rounding = 1e-12;  // m, rad, N/m or J/m
        bool any = false;
        for (const HistoryLine& entry : history) {
            const double value = columns[index].value(entry);
            any = any || std::abs(value) > rounding;
            line.points.emplace_back(entry.time, in_display_unit(value, columns[index].dimension));
        }
        if (any) {
            figure.series.emplace_back(std::move(line));
        }
    }
    return figure;
}

// The first columns of the monitors, as many as can be distinguished in a figure.
std::vector<Column> monitored(const HistoryRequest& request, Dimension dimension, std::string_view beginning) {
    std::vector<Column> columns = monitor_columns(request);
    std::erase_if(columns, [&](const Column& column) {
        return column.dimension != dimension || !column.name.starts_with(beginning);
    });
    columns.resize(std::min(columns.size(), most_curves));
    return columns;
}

std::vector<Column> rotations(const RelaxationScene& scene) {
    std::vector<Column> columns;
    for (const std::size_t block : free_blocks(scene)) {
        columns.push_back({"block " + std::to_string(block + 1), Dimension::angle,
                           [block](const HistoryLine& line) { return line.rotation[block]; }});
    }
    columns.resize(std::min(columns.size(), most_curves));
    return columns;
}

}  // namespace

void append_bolt_forces(const RelaxationRun& made, const Sheet& sheet) {
    RelaxationHistory lines = made.history;
    Points yields{.legend = "begins to yield", .colour = Colour::vermilion};
    std::vector<char> yielded;
    for (const MotionFrame& frame : made.frames) {
        HistoryLine line;
        line.time = frame.time;
        const std::vector<BoltOutcome> bolts = bolt_outcomes(made.scene, frame.bolt);
        yielded.resize(bolts.size());
        for (std::size_t bolt = 0; bolt < bolts.size(); ++bolt) {
            line.bolt.push_back(bolts[bolt].force);
            if (bolts[bolt].yielded > 0 && yielded[bolt] == 0) {
                yielded[bolt] = 1;
                yields.points.emplace_back(frame.time, in_display_unit(bolts[bolt].force, Dimension::force_per_length));
            }
        }
        if (made.history.empty()) {
            lines.push_back(std::move(line));
        }
    }
    if (lines.empty()) {
        return;
    }
    auto bolts = bolt_columns(lines.front());
    bolts.resize(std::min(bolts.size(), most_curves));
    Figure figure = curves(lines, bolts, "Forces in bolts",
                           {.title = "tension", .unit = human_unit(display_unit(Dimension::force_per_length).symbol)});
    if (figure.series.empty()) {
        return;
    }
    figure.series.emplace_back(std::move(yields));
    sheet.draw(
        figure, "bolts",
        "Tension of each bolt per metre of slope, where it is greatest along the bolt; points: it begins to yield.");
}

void append_history(const HistoryRequest& request, const RelaxationRun& made, const Sheet& sheet) {
    if (made.history.empty()) {
        return;
    }
    sheet.write("history.csv", history_csv(request, made.history));
    sheet.write("movements.csv", movements_csv(made));
    sheet.add(Heading{"History"});
    sheet.add(Folded{"Sliding of each block in time", {movement_table(made)}});
    const std::string unit = human_unit(display_unit(Dimension::energy_per_length).symbol);
    const auto draw = [&](const Figure& figure, const std::string& name, const std::string& caption) {
        if (!figure.series.empty()) {
            sheet.draw(figure, name, caption);
        }
    };
    draw(curves(made.history, energy_columns(), "Energies", {.title = "energy since the start", .unit = unit}),
         "energies", "Energy balance: applied work becomes all the others.");
    draw(curves(made.history, rotations(made.scene), "Rotations", {.title = "rotation out of the slope", .unit = "°"}),
         "rotations", "How the blocks turn, anticlockwise positive.");
    draw(curves(made.history, monitored(request, Dimension::length, "block_"), "Displacements",
                {.title = "displacement", .unit = human_unit(display_unit(Dimension::length).symbol)}),
         "displacements",
         "How far the centroids of the blocks of [[history.block]] have moved along the axes of the scene, in which "
         "gravity is tilted.");
    draw(curves(made.history, monitored(request, Dimension::force_per_length, "contact_"), "Contact forces",
                {.title = "force on the first block",
                 .unit = human_unit(display_unit(Dimension::force_per_length).symbol)}),
         "monitored_contacts",
         "Forces between the blocks of [[history.contact]] along the axes of the scene, and the sum of what presses at "
         "their corners.");
}

}  // namespace delabole
