#include "cases/program/reader/outline_file.hpp"

#include "cases/program/reader/line_chains.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/ordinary_file.hpp"
#include "fitting/work/bare_number.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>

namespace delabole {

namespace {

constexpr std::size_t largest_bytes = std::size_t{64} << 20U;
constexpr std::size_t most_corners = 20000;

constexpr std::string_view blank = " \t\r\n";

template <class Number>
std::optional<Number> number_of(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    const auto number = bare_number<Number>(text);
    return number && std::isfinite(static_cast<double>(*number)) ? number : std::nullopt;
}

std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

// Drawing programs do not tell the names of layers apart by case.
bool same_layer(std::string_view one, std::string_view other) {
    const auto upper = [](char letter) { return std::toupper(static_cast<unsigned char>(letter)); };
    return std::ranges::equal(one, other, {}, upper, upper);
}

// A group code and its value, which a DXF file has on two lines.
struct Group {
    int code = 0;
    std::string_view value = {};
};

constexpr std::array<std::string_view, 5> curves{"ARC", "CIRCLE", "ELLIPSE", "SPLINE", "HELIX"};
constexpr std::array<std::string_view, 8> passed_over{"TEXT",   "MTEXT",  "POINT",    "DIMENSION",
                                                      "LEADER", "ATTDEF", "VIEWPORT", "MULTILEADER"};

// Length in metres of the unit with that number in $INSUNITS.
std::optional<double> metres_of_unit(int number) {
    switch (number) {
    case 0:
    case 6:
        return 1;
    case 1:
        return 0.0254;
    case 2:
        return 0.3048;
    case 4:
        return 1e-3;
    case 5:
        return 1e-2;
    case 7:
        return 1e3;
    default:
        return std::nullopt;
    }
}

class DxfReader {
  public:
    // Blanks after the last line are removed here, since checking them at every line would take lines times blanks
    // steps.
    DxfReader(std::string_view text, const std::optional<std::string>& layer)
        : text_(text.substr(0, text.find_last_not_of(blank) + 1)), wanted_(layer) {}

    OutlineFile read();

  private:
    // False at the end of the file, or if the file is not a DXF.
    bool next() {
        if (text_.empty()) {
            return false;
        }
        ++line_;
        const auto code = number_of<int>(next_line(text_));
        if (!code) {
            complain("line " + std::to_string(line_) + " should be a group code of a DXF file");
            return false;
        }
        ++line_;
        group_ = {*code, trimmed(next_line(text_))};
        return true;
    }

    void complain(std::string problem) {
        if (problem_.empty()) {
            problem_ = std::move(problem);
        }
    }

    double coordinate() {
        const auto number = number_of<double>(group_.value);
        if (!number) {
            complain("line " + std::to_string(line_) + " should be a number");
        }
        return number.value_or(0);
    }

    // A complaint about an entity is kept until the entity ends, because its layer, which may be one to pass over,
    // comes after its kind.
    void complain_of_entity(std::string problem) {
        if (entity_problem_.empty()) {
            entity_problem_ = std::move(problem);
        }
    }

    void begin_entity();
    void take_group();
    void end_entity();
    void set_x(std::size_t index) {
        if (chain_.point.size() <= index) {
            chain_.point.resize(index + 1);
        }
        chain_.point[index].x = coordinate();
    }

    std::string_view text_;
    std::size_t line_ = 0;
    Group group_ = {};
    std::string problem_ = {};
    std::string_view section_ = {};
    std::string_view variable_ = {};  // of the header
    std::string_view entity_ = {};
    bool in_polyline_ = false;  // between POLYLINE and SEQEND
    LineChain chain_ = {};
    std::string entity_problem_ = {};
    const std::optional<std::string>& wanted_;  // layer
    std::vector<LineChain> chains_ = {};
    std::set<std::string> layers_ = {};  // that have lines
    double unit_ = 1;                    // m
};

// A POLYLINE includes its VERTEX entities up to SEQEND; every other entity ends where the next one begins.
void DxfReader::end_entity() {
    if (in_polyline_) {
        return;
    }
    if (!chain_.point.empty()) {
        layers_.emplace(chain_.layer.substr(0, 30));
    }
    if (!wanted_ || same_layer(chain_.layer, *wanted_)) {
        if (!entity_problem_.empty()) {
            complain(std::move(entity_problem_));
        }
        if (!chain_.point.empty()) {
            chains_.push_back(std::move(chain_));
        }
    }
    chain_ = {};
    entity_problem_ = {};
}

void DxfReader::begin_entity() {
    entity_ = group_.value;
    if (entity_ == "SEQEND") {
        in_polyline_ = false;
        end_entity();
        return;
    }
    if (entity_ == "VERTEX" && in_polyline_) {
        chain_.point.push_back({0, 0});
        return;
    }
    if (in_polyline_) {
        complain("has a POLYLINE that does not end, before line " + std::to_string(line_));
    }
    end_entity();
    if (std::find(curves.begin(), curves.end(), entity_) != curves.end()) {
        complain_of_entity("has a curve, " + std::string(entity_) + " at line " + std::to_string(line_) +
                           ": an outline consists of straight parts; replace it by a polyline");
    } else if (entity_ == "POLYLINE") {
        in_polyline_ = true;
    } else if (entity_ != "LINE" && entity_ != "LWPOLYLINE" &&
               std::find(passed_over.begin(), passed_over.end(), entity_) == passed_over.end()) {
        complain_of_entity("has an entity that is no part of an outline, " + std::string(entity_.substr(0, 30)) +
                           " at line " + std::to_string(line_));
    }
}

void DxfReader::take_group() {
    const bool light = entity_ == "LWPOLYLINE";
    const bool vertex = entity_ == "VERTEX";
    if (entity_ == "LINE") {
        switch (group_.code) {
        case 10:
            set_x(0);
            break;
        case 11:
            set_x(1);
            break;
        case 20:
        case 21:
            chain_.point.resize(std::max<std::size_t>(chain_.point.size(), group_.code == 20 ? 1 : 2));
            chain_.point[group_.code == 20 ? 0 : 1].y = coordinate();
            break;
        default:
            break;
        }
    } else if (light || vertex) {
        if (group_.code == 10) {
            set_x(light ? chain_.point.size() : chain_.point.size() - 1);
        } else if (group_.code == 20 && !chain_.point.empty()) {
            chain_.point.back().y = coordinate();
        } else if (group_.code == 42 && coordinate() != 0) {
            complain_of_entity("has a polyline with an arc in it, line " + std::to_string(line_) +
                               ": an outline consists of straight parts; replace the arc by several");
        }
    }
    if (group_.code == 8 && !vertex) {
        chain_.layer = group_.value;
    }
    if ((light || entity_ == "POLYLINE") && group_.code == 70) {
        chain_.closed = (number_of<int>(group_.value).value_or(0) & 1) != 0;
    }
}

std::string layer_names(const std::set<std::string>& layers) {
    constexpr std::size_t most_named = 8;
    std::vector<std::string> named(layers.begin(), layers.end());
    if (named.size() > most_named) {
        named.resize(most_named);
        named.emplace_back("others");
    }
    return list_in_words(named);
}

// "; they lie on the layers fault and ground: name that of the outline with scene.outline_layer", if there are several.
std::string layers_in_words(const std::vector<LineChain>& chains) {
    std::set<std::string> layers;
    for (const LineChain& chain : chains) {
        layers.emplace(chain.layer.substr(0, 30));
    }
    return layers.size() < 2 ? ""
                             : "; they lie on the layers " + layer_names(layers) +
                                   ": name that of the outline with scene.outline_layer";
}

OutlineFile DxfReader::read() {
    bool ended = false;
    while (problem_.empty() && !ended && next()) {
        if (group_.code == 0) {
            const bool in_entities = section_ == "ENTITIES";
            if (group_.value == "EOF" || group_.value == "ENDSEC") {
                if (in_entities) {
                    end_entity();
                    entity_ = {};
                }
                ended = group_.value == "EOF";
                section_ = {};
            } else if (group_.value == "SECTION") {
                section_ = "?";
            } else if (in_entities) {
                begin_entity();
            }
        } else if (section_ == "?" && group_.code == 2) {
            section_ = group_.value;
        } else if (section_ == "HEADER") {
            if (group_.code == 9) {
                variable_ = group_.value;
            } else if (variable_ == "$INSUNITS" && group_.code == 70) {
                const auto unit = metres_of_unit(number_of<int>(group_.value).value_or(-1));
                if (!unit) {
                    complain("is in a unit of length ($INSUNITS " + std::string(group_.value.substr(0, 10)) +
                             ") that is none of m, km, cm, mm, ft, in");
                }
                unit_ = unit.value_or(1);
            }
        } else if (section_ == "ENTITIES") {
            take_group();
        }
    }
    if (problem_.empty() && !ended) {
        complain("is no DXF file, or not a whole one: it does not end with EOF");
    }
    std::erase_if(chains_, [](const LineChain& chain) { return chain.point.size() < 2; });
    if (problem_.empty() && chains_.empty()) {
        complain("has no LINE, LWPOLYLINE or POLYLINE that could be an outline" +
                 (wanted_ ? " on the layer " + *wanted_ : std::string()) +
                 (wanted_ && !layers_.empty() ? "; there are some on " + layer_names(layers_) : std::string()));
    }
    if (problem_.empty() && chains_.size() > most_corners) {
        complain("has more than " + std::to_string(most_corners) + " lines");
    }
    if (!problem_.empty()) {
        return {{}, problem_};
    }
    const std::string layers = layers_in_words(chains_);
    std::vector<LineChain> outlines = joined(std::move(chains_));
    if (outlines.size() > 1) {
        const std::string gap = layers.empty() ? gap_in_words(outlines, unit_) : "";
        return {{},
                "has " + std::to_string(outlines.size()) + " separate lines: an outline is one, closed" + layers +
                    (gap.empty() ? "" : "; the narrowest gap between them is " + gap)};
    }
    if (!outlines.front().closed) {
        return {{}, "has a line that is not closed: the gap between its ends is " + gap_in_words(outlines, unit_)};
    }
    if (outlines.front().joined) {
        turn_anticlockwise(outlines.front().point);
    }
    OutlineFile file;
    for (const SectionPoint& point : outlines.front().point) {
        file.outline.push_back({unit_ * point.x, unit_ * point.y});
    }
    return file;
}

OutlineFile checked(OutlineFile file) {
    if (file.problem.empty() && file.outline.size() < 3) {
        file.problem = "has fewer than three corners";
    }
    if (file.problem.empty() && file.outline.size() > most_corners) {
        file.problem = "has more than " + std::to_string(most_corners) + " corners";
    }
    // A coordinate that is finite in kilometres may overflow in metres.
    const auto finite = [](const SectionPoint& corner) { return std::isfinite(corner.x) && std::isfinite(corner.y); };
    if (file.problem.empty() && !std::ranges::all_of(file.outline, finite)) {
        file.problem = "has a corner that is not finite in metres";
    }
    if (!file.problem.empty()) {
        file.outline.clear();
    }
    return file;
}

}  // namespace

OutlineFile outline_of_dxf(std::string_view text, const std::optional<std::string>& layer) {
    return checked(DxfReader(text, layer).read());
}

OutlineFile outline_of_csv(std::string_view text) {
    OutlineFile file;
    if (trimmed(next_line(text)) != "x_m,y_m") {
        file.problem = "should begin with the line x_m,y_m";
    }
    for (std::size_t line = 2; file.problem.empty() && !text.empty(); ++line) {
        const std::string_view row = trimmed(next_line(text));
        if (row.empty()) {
            continue;
        }
        const std::size_t comma = std::min(row.find(','), row.size());
        const auto x = number_of<double>(row.substr(0, comma));
        const auto y = comma < row.size() ? number_of<double>(row.substr(comma + 1)) : std::nullopt;
        if (!x || !y) {
            file.problem = "line " + std::to_string(line) + " should be two numbers with a comma between them";
        } else {
            file.outline.push_back({*x, *y});
        }
    }
    return checked(std::move(file));
}

OutlineFile read_outline_file(const std::filesystem::path& path, const std::optional<std::string>& layer) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter + 32) : letter;
    });
    if (ending != ".dxf" && ending != ".csv") {
        return {{}, "must end in .dxf or .csv"};
    }
    if (ending == ".csv" && layer) {
        return {{}, "is no drawing: scene.outline_layer is a layer of a DXF"};
    }
    FileContent content = read_ordinary_file(path, "an outline", largest_bytes);
    if (!content.fault.empty()) {
        return {{}, std::move(content.fault)};
    }
    return ending == ".dxf" ? outline_of_dxf(content.bytes, layer) : outline_of_csv(content.bytes);
}

}  // namespace delabole
