// Frames for ParaView, read back by a parser of their own.
#include "plots/report/frames.hpp"

#include "plots/drawing/atomic_file.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

// Nine significant digits.
constexpr double digits = 5e-9;

struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::vector<Element> children;
    std::string text;

    const Element& child(const std::string& wanted) const {
        for (const Element& element : children) {
            if (element.name == wanted) {
                return element;
            }
        }
        ADD_FAILURE() << "no <" << wanted << "> in <" << name << ">";
        static const Element none;
        return none;
    }
    const Element& array(const std::string& wanted) const {
        for (const Element& element : children) {
            if (element.attributes.count("Name") != 0 && element.attributes.at("Name") == wanted) {
                return element;
            }
        }
        ADD_FAILURE() << "no array " << wanted;
        static const Element none;
        return none;
    }
    std::vector<double> numbers() const {
        std::vector<double> result;
        std::istringstream stream(text);
        for (std::string word; stream >> word;) {
            char* end = nullptr;
            result.push_back(std::strtod(word.c_str(), &end));
            EXPECT_EQ(*end, '\0') << word;
            EXPECT_TRUE(std::isfinite(result.back())) << word;
        }
        return result;
    }
    std::size_t count(const std::string& attribute) const {
        return static_cast<std::size_t>(std::stoul(attributes.at(attribute)));
    }
};

// Enough of XML for these files: elements, attributes, text; a prologue. Throws on anything that is not well-formed.
class XmlReader {
  public:
    explicit XmlReader(const std::string& text) : text_(text) {}

    Element document() {
        expect("<?xml version=\"1.0\"?>\n");
        Element root = element();
        skip_space();
        if (at_ != text_.size()) {
            throw std::runtime_error("something after the root");
        }
        return root;
    }

  private:
    void expect(const std::string& word) {
        if (text_.compare(at_, word.size(), word) != 0) {
            throw std::runtime_error("expected " + word + " at " + std::to_string(at_));
        }
        at_ += word.size();
    }
    void skip_space() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) {
            ++at_;
        }
    }
    std::string until(const std::string& stops) {
        const std::size_t end = text_.find_first_of(stops, at_);
        if (end == std::string::npos) {
            throw std::runtime_error("no end");
        }
        std::string word = text_.substr(at_, end - at_);
        at_ = end;
        return word;
    }
    Element element() {
        Element result;
        expect("<");
        result.name = until(" />");
        for (skip_space(); text_[at_] != '>' && text_[at_] != '/'; skip_space()) {
            const std::string attribute = until("=");
            expect("=\"");
            if (!result.attributes.emplace(attribute, until("\"")).second) {
                throw std::runtime_error(attribute + " twice");
            }
            expect("\"");
        }
        if (text_[at_] == '/') {
            expect("/>");
            return result;
        }
        expect(">");
        while (true) {
            result.text += until("<");
            if (text_.compare(at_, 2, "</") == 0) {
                expect("</" + result.name + ">");
                return result;
            }
            result.children.push_back(element());
        }
    }

    const std::string& text_;
    std::size_t at_ = 0;
};

Element read_xml(const std::string& text) {
    return XmlReader(text).document();
}

BlockFrame sample() {
    BlockFrame frame;
    frame.time = 0.125;
    frame.tilt = 0.325;
    frame.movements = {"stays", "slides_forward", "fixed"};
    frame.blocks = {{{{0, 0}, {1, 0}, {1, 3}, {0, 3}}, 1, false, 1, {-0.25, 1e-7}, 0.01, {-0.3, 0.4}},
                    {{{1, 0}, {2, 0}, {1.5, 2}}, 2, false, 0, {0, 0}, 0, {0, 0}},
                    {{{-3, -1}, {5, -1}, {5, 0}, {1.0 / 3, 0.1}, {-3, 0}}, 3, true, 2, {0, 0}, 0, {0, 0}}};
    frame.contacts = {{{0, 0}, {12.5, 1e5}, 1e5, -12.5, true, 1, 3}, {{1, 0}, {0, 2e4}, 2e4, 0, false, 2, 3}};
    return frame;
}

// Checks what VTK requires of PolyData, whatever is in it.
const Element& checked_piece(const Element& file) {
    EXPECT_EQ(file.name, "VTKFile");
    EXPECT_EQ(file.attributes.at("type"), "PolyData");
    const Element& piece = file.child("PolyData").child("Piece");
    const std::size_t points = piece.count("NumberOfPoints");
    const Element& coordinates = piece.child("Points").array("Points");
    EXPECT_EQ(coordinates.attributes.at("NumberOfComponents"), "3");
    EXPECT_EQ(coordinates.numbers().size(), 3 * points);
    std::size_t cells = 0;
    for (const std::string kind : {"Verts", "Lines", "Strips", "Polys"}) {
        const std::size_t count = piece.count("NumberOf" + kind);
        cells += count;
        if (count == 0) {
            continue;
        }
        const std::vector<double> connectivity = piece.child(kind).array("connectivity").numbers();
        const std::vector<double> offsets = piece.child(kind).array("offsets").numbers();
        EXPECT_EQ(offsets.size(), count);
        EXPECT_EQ(offsets.back(), static_cast<double>(connectivity.size()));
        EXPECT_TRUE(std::is_sorted(offsets.begin(), offsets.end()));
        for (const double point : connectivity) {
            EXPECT_LT(point, static_cast<double>(points));
        }
    }
    for (const auto& [place, size] : {std::pair{"PointData", points}, std::pair{"CellData", cells}}) {
        for (const Element& array : piece.child(place).children) {
            const bool vector = array.attributes.count("NumberOfComponents") != 0;
            EXPECT_EQ(array.numbers().size(), (vector ? 3 : 1) * size) << array.attributes.at("Name");
            EXPECT_EQ(array.attributes.at("format"), "ascii");
        }
    }
    return piece;
}

TEST(Frames, BlocksComeBack) {
    const BlockFrame frame = sample();
    const Element file = read_xml(blocks_vtp(frame));
    const Element& piece = checked_piece(file);
    ASSERT_EQ(piece.count("NumberOfPolys"), 3U);
    ASSERT_EQ(piece.count("NumberOfPoints"), 12U);
    const std::vector<double> coordinates = piece.child("Points").array("Points").numbers();
    const std::vector<double> offsets = piece.child("Polys").array("offsets").numbers();
    EXPECT_EQ(offsets, (std::vector<double>{4, 7, 12}));
    std::size_t point = 0;
    for (const FrameBlock& block : frame.blocks) {
        for (const Point& corner : block.outline) {
            EXPECT_NEAR(coordinates[3 * point], corner.x(), digits * std::abs(corner.x()));
            EXPECT_NEAR(coordinates[3 * point + 1], corner.y(), digits * std::abs(corner.y()));
            EXPECT_EQ(coordinates[3 * point + 2], 0);
            ++point;
        }
    }
    const Element& data = piece.child("CellData");
    EXPECT_EQ(data.array("block").numbers(), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(data.array("fixed").numbers(), (std::vector<double>{0, 0, 1}));
    EXPECT_EQ(data.array("movement").numbers(), (std::vector<double>{1, 0, 2}));
    EXPECT_EQ(data.array("rotation").numbers(), (std::vector<double>{0.01, 0, 0}));
    EXPECT_EQ(data.array("displacement").numbers(), (std::vector<double>{-0.25, 1e-7, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(data.array("velocity").numbers(), (std::vector<double>{-0.3, 0.4, 0, 0, 0, 0, 0, 0, 0}));
    EXPECT_NEAR(data.array("speed").numbers()[0], 0.5, digits);
}

TEST(Frames, SayTheirMoment) {
    for (const std::string& text : {blocks_vtp(sample()), contacts_vtp(sample())}) {
        const Element file = read_xml(text);
        const Element& fields = file.child("PolyData").child("FieldData");
        EXPECT_EQ(fields.array("TimeValue").numbers(), std::vector<double>{0.125});
        EXPECT_EQ(fields.array("tilt").numbers(), std::vector<double>{0.325});
    }
}

TEST(Frames, MovementsAreNamed) {
    const Element file = read_xml(blocks_vtp(sample()));
    const Element& words = file.child("PolyData").child("FieldData").array("movement_words");
    EXPECT_EQ(words.attributes.at("NumberOfTuples"), "3");
    std::string text;
    for (const double letter : words.numbers()) {
        text += letter == 0 ? '|' : static_cast<char>(letter);
    }
    EXPECT_EQ(text, "stays|slides_forward|fixed|");
}

TEST(Frames, ContactsComeBack) {
    const Element file = read_xml(contacts_vtp(sample()));
    const Element& piece = checked_piece(file);
    EXPECT_EQ(piece.count("NumberOfVerts"), 2U);
    const Element& data = piece.child("PointData");
    EXPECT_EQ(data.array("force").numbers(), (std::vector<double>{12.5, 1e5, 0, 0, 2e4, 0}));
    EXPECT_EQ(data.array("normal_force").numbers(), (std::vector<double>{1e5, 2e4}));
    EXPECT_EQ(data.array("shear_force").numbers(), (std::vector<double>{-12.5, 0}));
    EXPECT_EQ(data.array("sliding").numbers(), (std::vector<double>{1, 0}));
    EXPECT_EQ(data.array("block").numbers(), (std::vector<double>{1, 2}));
    EXPECT_EQ(data.array("other").numbers(), (std::vector<double>{3, 3}));
}

TEST(Frames, NothingAtAllIsAFileToo) {
    for (const std::string& text : {blocks_vtp({}), contacts_vtp({})}) {
        const Element file = read_xml(text);
        EXPECT_EQ(checked_piece(file).count("NumberOfPoints"), 0U);
    }
}

// A run that blew up: VTK would stop reading at the first "nan".
TEST(Frames, WhatIsNotFiniteIsLeftOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    BlockFrame frame = sample();
    frame.tilt = nan;
    frame.blocks[0].velocity.x() = infinite;
    frame.blocks[1].outline[1].y() = nan;
    frame.contacts[0].normal_force = -infinite;
    const Element file = read_xml(blocks_vtp(frame));
    EXPECT_EQ(checked_piece(file).child("CellData").array("block").numbers(), std::vector<double>{3});
    const Element contact_file = read_xml(contacts_vtp(frame));
    EXPECT_EQ(checked_piece(contact_file).count("NumberOfPoints"), 1U);
    // The squares of these velocities overflow.
    frame = sample();
    frame.blocks[0].velocity = {1e200, 1e200};
    frame.blocks[1].rotation = 1e-310;  // too small for some readers
    const Element fast = read_xml(blocks_vtp(frame));
    checked_piece(fast);
}

TEST(Frames, CollectionsListTimesAndFiles) {
    const Element file = read_xml(collection_pvd({{0, "a.vtp"}, {0.05, "b & \"c\".vtp"}}));
    EXPECT_EQ(file.attributes.at("type"), "Collection");
    const Element& collection = file.child("Collection");
    ASSERT_EQ(collection.children.size(), 2U);
    EXPECT_EQ(collection.children[1].attributes.at("timestep"), "0.05");
    EXPECT_EQ(collection.children[1].attributes.at("file"), "b &amp; &quot;c&quot;.vtp");
}

std::vector<std::string> files_in(const std::string& pvd) {
    std::vector<std::string> names;
    const Element file = read_xml(pvd);
    for (const Element& data_set : file.child("Collection").children) {
        names.push_back(data_set.attributes.at("file"));
    }
    return names;
}

TEST(FrameFolder, HoldsWhatItsCollectionsList) {
    const ScratchFolder scratch;
    const std::filesystem::path folder = scratch.path() / "frames";
    FrameFolder frames(folder, "two_blocks");
    const auto add = [](FrameFolder& to, double time) {
        BlockFrame frame = sample();
        frame.time = time;
        to.add(frame);
    };
    for (const double time : {0.0, 0.1, 0.2}) {
        add(frames, time);
    }
    for (const std::string kind : {"blocks", "contacts"}) {
        const std::vector<std::string> names = files_in(content_of(folder / ("two_blocks_" + kind + ".pvd")));
        ASSERT_EQ(names.size(), 3U);
        EXPECT_EQ(names[2], "two_blocks_" + kind + "_00002.vtp");
        for (const std::string& name : names) {
            const Element file = read_xml(content_of(folder / name));
            checked_piece(file);
        }
    }
    EXPECT_THROW(FrameFolder(folder / "two_blocks_blocks.pvd", "x"), OutputError);
    // A shorter run in the same folder leaves nothing of the longer one.
    FrameFolder again(folder, "two_blocks");
    add(again, 0.0);
    EXPECT_TRUE(std::filesystem::exists(folder / "two_blocks_blocks_00000.vtp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "two_blocks_blocks_00001.vtp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "two_blocks_contacts_00002.vtp"));
}

}  // namespace
}  // namespace delabole
