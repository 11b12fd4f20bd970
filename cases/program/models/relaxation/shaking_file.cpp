#include "cases/program/models/relaxation/shaking_file.hpp"

#include "cases/program/reader/data_table.hpp"

#include <utility>

namespace delabole {

namespace {

constexpr std::size_t largest_bytes = std::size_t{16} << 20U;
constexpr std::size_t most_entries = 20'000;  // a case with that many entries written out can still be read

void check_record(Reading& reading, const std::vector<ShakingPoint>& record, const std::vector<Node>& rows) {
    if (record.empty()) {
        reading.complain({.line = 1, .column = 1}, "", "", "has no entries below the names of its columns");
    } else if (record.size() > most_entries) {
        reading.complain(rows[most_entries].place, "", "",
                         "is the first line beyond " + std::to_string(most_entries) + " entries: more are not read");
    }
    for (std::size_t index = 1; index < record.size(); ++index) {
        if (!(record[index].time > record[index - 1].time)) {
            reading.complain(rows[index].place, "time", readable_quantity(record[index].time, Dimension::time),
                             "must be more than that of the line before, " +
                                 readable_quantity(record[index - 1].time, Dimension::time));
            return;
        }
    }
}

}  // namespace

std::vector<ShakingPoint> shaking_of_csv(std::string_view text, std::string_view name) {
    return parse_table<ShakingPoint>(text, name, check_record);
}

void take_shaking_file(Reading& reading, RelaxationStudy& study, const std::filesystem::path& folder,
                       const std::string& prefix) {
    if (!study.model.shaking_file) {
        return;
    }
    const std::string key = prefix + "shaking_file";
    // A mechanism's own record replaces that of the case, whether given in the case or by a file.
    if (reading.knows(prefix + "shaking")) {
        reading.complain_at(key, "and " + prefix + "shaking exclude each other");
        return;
    }
    study.model.shaking = read_table_file(reading, key, folder / *std::exchange(study.model.shaking_file, std::nullopt),
                                          "a record of shaking", largest_bytes, shaking_of_csv);
}

}  // namespace delabole
