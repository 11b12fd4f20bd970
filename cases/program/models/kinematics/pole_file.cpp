#include "cases/program/models/kinematics/pole_file.hpp"

#include "cases/program/case/model_cases.hpp"
#include "cases/program/reader/data_table.hpp"
#include "fitting/work/bare_number.hpp"
#include "kinematics/kinematics.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

namespace delabole {

namespace {

constexpr std::size_t largest_pole_file = std::size_t{16} << 20U;

struct PoleCell {
    std::string_view text;
    int column;  // of its first character, from 1
};

std::string_view unquoted(std::string_view text) {
    constexpr std::string_view blank = " \t\r\"";
    const std::size_t begin = text.find_first_not_of(blank);
    return begin == std::string_view::npos ? "" : text.substr(begin, text.find_last_not_of(blank) + 1 - begin);
}

std::vector<PoleCell> cells_of(std::string_view line, char separator) {
    std::vector<PoleCell> cells;
    for (std::size_t begin = 0; begin <= line.size();) {
        const std::size_t end = std::min(line.find(separator, begin), line.size());
        cells.push_back({unquoted(line.substr(begin, end - begin)), static_cast<int>(begin) + 1});
        begin = end + 1;
    }
    return cells;
}

// "Dip Direction (deg)" -> "dipdirection"
std::string plain_name(std::string_view name) {
    std::string plain;
    for (const char letter : name.substr(0, name.find('('))) {
        if (std::isalpha(static_cast<unsigned char>(letter)) != 0) {
            plain += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
        }
    }
    return plain.size() > 3 && plain.ends_with("deg") ? plain.substr(0, plain.size() - 3) : plain;
}

std::optional<std::size_t> column_named(const std::vector<PoleCell>& header,
                                        std::initializer_list<std::string_view> names) {
    for (std::size_t column = 0; column < header.size(); ++column) {
        if (std::ranges::find(names, plain_name(header[column].text)) != names.end()) {
            return column;
        }
    }
    return std::nullopt;
}

// Two columns that together give a plane.
struct PoleColumns {
    std::size_t inclination;
    std::size_t azimuth;
    Orientation (*plane)(double inclination, double azimuth);
    std::optional<std::size_t> quantity = std::nullopt;
};

std::optional<PoleColumns> columns_of(const std::vector<PoleCell>& header) {
    const auto dip = column_named(header, {"dip"});
    if (const auto direction = column_named(header, {"dipdirection", "dipdir", "dipazimuth", "ddr"});
        dip && direction) {
        return PoleColumns{*dip, *direction, [](double inclination, double azimuth) {
                               return Orientation{inclination, wrapped_azimuth(azimuth)};
                           }};
    }
    if (const auto strike = column_named(header, {"strike", "strikeright", "strikerhr"}); dip && strike) {
        return PoleColumns{*dip, *strike, [](double inclination, double azimuth) {
                               return Orientation{inclination, wrapped_azimuth(azimuth + degrees(90))};
                           }};
    }
    const auto trend = column_named(header, {"trend", "poletrend"});
    const auto plunge = column_named(header, {"plunge", "poleplunge"});
    if (trend && plunge) {
        return PoleColumns{*plunge, *trend, [](double inclination, double azimuth) {
                               return plane_with_normal(direction_of({inclination, azimuth}));
                           }};
    }
    return std::nullopt;
}

class PoleReader {
  public:
    explicit PoleReader(std::string_view name) : reading_(std::string(name)) {}

    std::vector<Orientation> planes(std::string_view text) {
        if (text.starts_with("\xEF\xBB\xBF")) {
            text.remove_prefix(3);
        }
        int line = 0;
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            const std::string_view content = text.substr(begin, end - begin);
            begin = end + 1;
            ++line;
            if (unquoted(content).empty() || unquoted(content).starts_with('#')) {
                continue;
            }
            if (!columns_) {
                read_header(content, line);
            } else if (!read_row(cells_of(content, separator_), line)) {
                reading_.complain(
                    {.line = line, .column = 1}, "", "",
                    "is the first line beyond " + std::to_string(most_poles) + " planes: more are not read");
                break;
            }
        }
        if (planes_.empty() && reading_.clean()) {
            reading_.complain({.line = 1, .column = 1}, "", "", "has no planes below the names of its columns");
        }
        reading_.finish();
        return std::move(planes_);
    }

  private:
    void read_header(std::string_view content, int line) {
        for (const char candidate : {';', '\t', ','}) {
            if (content.find(candidate) != std::string_view::npos) {
                separator_ = candidate;
                break;
            }
        }
        const std::vector<PoleCell> header = cells_of(content, separator_);
        for (const PoleCell& cell : header) {
            const std::string name = shown(cell.text);
            names_.push_back(name.substr(1, name.size() - 2));
        }
        columns_ = columns_of(header);
        if (columns_) {
            columns_->quantity = column_named(header, {"quantity"});
        } else {
            reading_.complain({.line = line, .column = 1}, "", "",
                              "must name the columns dip and dip_direction, strike and dip, or trend and plunge");
            reading_.finish();
        }
    }

    // Whether the planes of the row have room among most_poles.
    bool read_row(const std::vector<PoleCell>& cells, int line) {
        const auto inclination = number_in(cells, columns_->inclination, line, 0, 90, "of degrees ");
        const auto azimuth = number_in(cells, columns_->azimuth, line, -360, 360, "of degrees ");
        const auto quantity = columns_->quantity
                                  ? number_in(cells, *columns_->quantity, line, 1, most_poles, "of poles ")
                                  : std::optional(1.0);
        if (!inclination || !azimuth || !quantity) {
            return planes_.size() < most_poles;
        }
        const auto more = static_cast<std::size_t>(*quantity);
        const bool fits = planes_.size() + more <= most_poles;
        planes_.insert(planes_.end(), fits ? more : 0, columns_->plane(degrees(*inclination), degrees(*azimuth)));
        return fits;
    }

    // Degrees may have a fraction.
    std::optional<double> number_in(const std::vector<PoleCell>& cells, std::size_t column, int line, double lowest,
                                    double highest, const std::string& unit) {
        const std::string& name = names_[column];
        if (column >= cells.size()) {
            reading_.complain({.line = line, .column = 1}, "", "", "has no " + name + ": too few columns");
            return std::nullopt;
        }
        const std::string_view text = cells[column].text;
        const bool whole = column == columns_->quantity;
        const auto value = bare_number(text);
        if (!value || !(*value >= lowest && *value <= highest) || (whole && std::floor(*value) != *value)) {
            reading_.complain({.line = line, .column = cells[column].column}, name, shown(text),
                              std::string("must be a ") + (whole ? "whole " : "") + "number " + unit + "from " +
                                  std::to_string(static_cast<int>(lowest)) + " to " +
                                  std::to_string(static_cast<int>(highest)));
            return std::nullopt;
        }
        return value;
    }

    Reading reading_;
    char separator_ = ',';
    std::vector<std::string> names_;  // of the columns, as the file writes them
    std::optional<PoleColumns> columns_;
    std::vector<Orientation> planes_;
};

}  // namespace

std::vector<Orientation> planes_of_csv(std::string_view text, std::string_view name) {
    return PoleReader(name).planes(text);
}

void take_files(Reading& reading, KinematicsStudy& study, const std::filesystem::path& folder,
                const std::string& prefix) {
    for (std::size_t index = 0; index < study.model.poles.size(); ++index) {
        PoleSurvey& survey = study.model.poles[index];
        if (!survey.file) {
            continue;
        }
        const std::string key = prefix + indexed("poles", index) + ".file";
        if (!survey.plane.empty()) {
            reading.complain_at(key, "and " + indexed("poles", index) + ".plane exclude each other");
            continue;
        }
        survey.plane = read_table_file(reading, key, folder / *std::exchange(survey.file, std::nullopt),
                                       "a table of poles", largest_pole_file, planes_of_csv);
    }
}

}  // namespace delabole
