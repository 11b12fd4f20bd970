#include "plots/report/frames.hpp"

#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/svg.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

namespace delabole {

namespace {

void append(std::string& text, double value) {
    constexpr int digits = 9;
    std::array<char, 32> buffer{};
    // Neither "-0" nor denormal numbers, which some readers of the format reject.
    const double shown = std::abs(value) < std::numeric_limits<double>::min() ? 0 : value;
    const auto end =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), shown, std::chars_format::general, digits);
    text.append(buffer.data(), end.ptr);
}

void append(std::string& text, const Point& point) {
    append(text, point.x());
    text += ' ';
    append(text, point.y());
    text += " 0";
}

void append(std::string& text, std::size_t value) {
    text += std::to_string(value);
}

void append(std::string& text, int value) {
    text += std::to_string(value);
}

void append(std::string& text, bool value) {
    text += value ? '1' : '0';
}

template <class T>
constexpr std::string_view type_of = "Int32";
template <>
constexpr std::string_view type_of<double> = "Float64";
template <>
constexpr std::string_view type_of<Point> = "Float64";
template <>
constexpr std::string_view type_of<std::size_t> = "Int64";
template <>
constexpr std::string_view type_of<bool> = "UInt8";

// An array with one value per line; `value_of` gives the value of an item.
template <class Items, class ValueOf>
std::string data_array(std::string_view name, const Items& items, ValueOf value_of) {
    using Value = std::decay_t<decltype(std::invoke(value_of, *items.begin()))>;
    std::string text = "<DataArray type=\"";
    text.append(type_of<Value>).append("\" Name=\"").append(name);
    text += std::is_same_v<Value, Point> ? "\" NumberOfComponents=\"3\" format=\"ascii\">\n" : "\" format=\"ascii\">\n";
    for (const auto& item : items) {
        append(text, std::invoke(value_of, item));
        text += '\n';
    }
    return text + "</DataArray>\n";
}

std::string field_number(std::string_view name, double value) {
    std::string text = "<DataArray type=\"Float64\" Name=\"";
    text.append(name).append("\" NumberOfTuples=\"1\" format=\"ascii\">\n");
    append(text, std::isfinite(value) ? value : 0);
    return text + "\n</DataArray>\n";
}

// VTK stores texts as the numbers of their bytes, each text ended by a zero.
std::string field_words(std::string_view name, const std::vector<std::string>& words) {
    std::string text = "<Array type=\"String\" Name=\"";
    text.append(name)
        .append("\" NumberOfTuples=\"")
        .append(std::to_string(words.size()))
        .append("\" format=\"ascii\">");
    for (const std::string& word : words) {
        text += '\n';
        for (const char letter : word) {
            text += std::to_string(static_cast<int>(static_cast<unsigned char>(letter))) + ' ';
        }
        text += '0';
    }
    return text + "\n</Array>\n";
}

std::string file_of(std::string_view type, std::string_view content) {
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"";
    text.append(type).append("\" version=\"0.1\" byte_order=\"LittleEndian\">\n").append(content);
    return text + "</VTKFile>\n";
}

struct Piece {
    std::size_t points = 0;
    std::string point_data = {};
    std::string cell_data = {};
    std::string coordinates = {};
    std::string_view cells = {};  // the kind of the cells: Verts or Polys
    std::size_t cell_count = 0;
    std::string connectivity = {};
};

std::string poly_data(const std::string& field_data, const Piece& piece) {
    std::string text = "<PolyData>\n<FieldData>\n" + field_data + "</FieldData>\n<Piece NumberOfPoints=\"" +
                       std::to_string(piece.points) + "\"";
    for (const std::string_view kind : {"Verts", "Lines", "Strips", "Polys"}) {
        text.append(" NumberOf").append(kind).append("=\"");
        text += std::to_string(kind == piece.cells ? piece.cell_count : 0) + "\"";
    }
    text += ">\n<PointData>\n" + piece.point_data + "</PointData>\n<CellData>\n" + piece.cell_data +
            "</CellData>\n<Points>\n" + piece.coordinates + "</Points>\n";
    text.append("<").append(piece.cells).append(">\n").append(piece.connectivity);
    text.append("</").append(piece.cells).append(">\n</Piece>\n</PolyData>\n");
    return file_of("PolyData", text);
}

// Every corner is a point of its own, so the connectivity counts 0, 1, 2, ... through all cells.
std::string connectivity(const std::vector<std::size_t>& ends) {
    std::vector<std::size_t> numbers(ends.empty() ? 0 : ends.back());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    return data_array("connectivity", numbers, std::identity{}) + data_array("offsets", ends, std::identity{});
}

bool drawable(const FrameBlock& block) {
    return block.outline.size() >= 3 &&
           std::ranges::all_of(block.outline, [](const Point& corner) { return corner.allFinite(); }) &&
           block.displacement.allFinite() && std::isfinite(block.rotation) && block.velocity.allFinite() &&
           std::isfinite(block.velocity.norm());
}

bool drawable(const FrameContact& contact) {
    return contact.at.allFinite() && contact.force.allFinite() && std::isfinite(contact.normal_force) &&
           std::isfinite(contact.shear_force);
}

template <class Item>
std::vector<Item> drawable_of(const std::vector<Item>& items) {
    std::vector<Item> result = items;
    std::erase_if(result, [](const Item& item) { return !drawable(item); });
    return result;
}

// ParaView looks for the time under the name TimeValue.
std::string moment_of(const BlockFrame& frame) {
    return field_number("TimeValue", frame.time) + field_number("tilt", frame.tilt);
}

}  // namespace

std::string blocks_vtp(const BlockFrame& frame) {
    const std::vector<FrameBlock> blocks = drawable_of(frame.blocks);
    Polyline corners;
    std::vector<std::size_t> ends;
    for (const FrameBlock& block : blocks) {
        corners.insert(corners.end(), block.outline.begin(), block.outline.end());
        ends.push_back(corners.size());
    }
    Piece piece;
    piece.points = corners.size();
    piece.cells = "Polys";
    piece.cell_count = blocks.size();
    piece.coordinates = data_array("Points", corners, std::identity{});
    piece.connectivity = connectivity(ends);
    piece.cell_data =
        data_array("block", blocks, &FrameBlock::number) + data_array("fixed", blocks, &FrameBlock::fixed) +
        data_array("movement", blocks, &FrameBlock::movement) +
        data_array("displacement", blocks, &FrameBlock::displacement) +
        data_array("rotation", blocks, &FrameBlock::rotation) + data_array("velocity", blocks, &FrameBlock::velocity) +
        data_array("speed", blocks, [](const FrameBlock& block) { return block.velocity.norm(); });
    return poly_data(moment_of(frame) + field_words("movement_words", frame.movements), piece);
}

std::string contacts_vtp(const BlockFrame& frame) {
    const std::vector<FrameContact> contacts = drawable_of(frame.contacts);
    std::vector<std::size_t> ends(contacts.size());
    std::iota(ends.begin(), ends.end(), std::size_t{1});
    Piece piece;
    piece.points = contacts.size();
    piece.cells = "Verts";
    piece.cell_count = contacts.size();
    piece.coordinates = data_array("Points", contacts, &FrameContact::at);
    piece.connectivity = connectivity(ends);
    piece.point_data = data_array("force", contacts, &FrameContact::force) +
                       data_array("normal_force", contacts, &FrameContact::normal_force) +
                       data_array("shear_force", contacts, &FrameContact::shear_force) +
                       data_array("sliding", contacts, &FrameContact::sliding) +
                       data_array("block", contacts, &FrameContact::block) +
                       data_array("other", contacts, &FrameContact::other);
    return poly_data(moment_of(frame), piece);
}

std::string collection_pvd(const std::vector<CollectedFile>& files) {
    std::string text = "<Collection>\n";
    for (const CollectedFile& file : files) {
        text += "<DataSet timestep=\"";
        append(text, file.time);
        text += "\" group=\"\" part=\"0\" file=\"" + escape_html(file.name) + "\"/>\n";
    }
    return file_of("Collection", text + "</Collection>\n");
}

FrameFolder::FrameFolder(std::filesystem::path folder, std::string name)
    : folder_(std::move(folder)), name_(std::move(name)) {
    create_output_subfolder(folder_);
    for (const std::string_view kind : {"blocks", "contacts"}) {
        // Collections are removed first, so that they never list files that no longer exist.
        std::error_code error;
        std::filesystem::remove(folder_ / collection_name(kind), error);
        for (std::size_t index = 0; std::filesystem::remove(folder_ / file_name(kind, index), error); ++index) {
        }
    }
}

std::string FrameFolder::collection_name(std::string_view kind) const {
    std::string text = name_;
    return text.append("_").append(kind).append(".pvd");
}

std::string FrameFolder::file_name(std::string_view kind, std::size_t index) const {
    constexpr std::size_t width = 5;
    const std::string number = std::to_string(index);
    std::string text = name_;
    text.append("_").append(kind).append("_");
    return text + std::string(width - std::min(width, number.size()), '0') + number + ".vtp";
}

std::vector<std::string> FrameFolder::file_names(std::size_t frames) const {
    std::vector<std::string> names;
    for (const std::string_view kind : {"blocks", "contacts"}) {
        names.push_back(collection_name(kind));
        for (std::size_t index = 0; index < frames; ++index) {
            names.push_back(file_name(kind, index));
        }
    }
    return names;
}

void FrameFolder::write_collection(std::string_view kind) const {
    std::vector<CollectedFile> files;
    for (std::size_t index = 0; index < times_.size(); ++index) {
        files.push_back({times_[index], file_name(kind, index)});
    }
    write_file_atomically(folder_ / collection_name(kind), collection_pvd(files));
}

void FrameFolder::add(const BlockFrame& frame) {
    write_file_atomically(folder_ / file_name("blocks", times_.size()), blocks_vtp(frame));
    write_file_atomically(folder_ / file_name("contacts", times_.size()), contacts_vtp(frame));
    times_.push_back(frame.time);
    write_collection("blocks");
    write_collection("contacts");
}

}  // namespace delabole
