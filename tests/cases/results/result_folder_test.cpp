#include "cases/program/results/result_folder.hpp"

#include "cases/program/results/folder_claim.hpp"
#include "cases/program/terminal/plain_output.hpp"
#include "plots/drawing/atomic_file.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace delabole {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

// The folder does not exist at first, and is removed with everything in it.
class Folder : public ::testing::Test {
  protected:
    Folder()
        : outside_(fs::temp_directory_path() / ("delabole-result-folder-" + std::to_string(::getpid()))),
          path_(outside_ / "results" / "slope") {
        fs::remove_all(outside_);
        fs::create_directory(outside_);
    }
    ~Folder() override { fs::remove_all(outside_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    const fs::path& outside() const { return outside_; }
    const fs::path& path() const { return path_; }

    void write(const std::string& name, const std::string& text = "x") const {
        fs::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name) << text;
    }

    std::string read(const std::string& name) const {
        std::ifstream file(path_ / name);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    Names names() const {
        Names found;
        for (const auto& entry : fs::recursive_directory_iterator(path_)) {
            found.push_back(entry.path().lexically_relative(path_).string());
        }
        std::ranges::sort(found);
        return found;
    }

    std::string refusal() const {
        try {
            const FolderClaim claim(path_);
        } catch (const OutputError& error) {
            return error.what();
        }
        return "";
    }

  private:
    fs::path outside_;
    fs::path path_;
};

using FolderClaimTest = Folder;

TEST_F(FolderClaimTest, NextResultTakesThePlaceOfTheEarlierAndOfNothingElse) {
    {
        FolderClaim claim(path());
        claim.enter({"results.csv", "figures/section.svg", "frames/run_1.vtp", "result.json"});
        for (const char* name : {"results.csv", "figures/section.svg", "frames/run_1.vtp", "result.json", "notes.csv",
                                 "figures/mine.svg"}) {
            write(name);
        }
    }
    FolderClaim claim(path());
    EXPECT_EQ(names().size(), 9U) << "the earlier result stays until there is another";
    claim.enter({"history.csv"});
    EXPECT_EQ(names(), (Names{"figures", "figures/mine.svg", "files.txt", "notes.csv"}));
    claim.enter({"history.csv", "report.html"});
    const std::string list = read("files.txt");
    EXPECT_EQ(list.substr(list.find('\n') + 1), "history.csv\nreport.html\n");
}

// Formerly only the unfinished parts of checkpoints were removed.
TEST_F(FolderClaimTest, NextResultRemovesWhatAKillLeftHalfWritten) {
    {
        FolderClaim claim(path());
        claim.enter({"results.csv", "figures/section.svg", "frames/run_1.vtp"});
        for (const char* name :
             {".results.csv.12.0.part", "figures/.section.svg.12.1.part", "frames/.run_1.vtp.12.2.part",
              "figures/.drawing-aB3xYz/section.svg", "figures/.drawing-mine/section.svg", ".notes.csv.12.0.part",
              "figures/.section.svg.part"}) {
            write(name);
        }
    }
    FolderClaim claim(path());
    claim.enter({});
    EXPECT_EQ(names(), (Names{".notes.csv.12.0.part", "figures", "figures/.drawing-mine",
                              "figures/.drawing-mine/section.svg", "figures/.section.svg.part", "files.txt"}));
}

TEST_F(FolderClaimTest, IsOfOneProcessAtATime) {
    auto claim = std::make_unique<FolderClaim>(path());
    EXPECT_EQ(refusal(),
              "cannot write " + path().string() +
                  ": another delabole is writing a result there: wait for it, or name another folder (--out)");
    claim->enter({"results.csv"});
    claim.reset();
    EXPECT_EQ(refusal(), "");
}

TEST_F(FolderClaimTest, LeavesNothingWhereNothingWasWritten) {
    { const FolderClaim claim(path()); }
    EXPECT_FALSE(fs::exists(path().parent_path()));
    write("notes.txt");
    { const FolderClaim claim(path()); }
    EXPECT_EQ(names(), Names{"notes.txt"});
    {
        const FolderClaim claim(path() / "deeper");
        write("deeper/relaxation.checkpoint");
    }
    EXPECT_EQ(names(), (Names{"deeper", "deeper/relaxation.checkpoint", "notes.txt"}));
}

// The folder, and with it the list, may come from somebody else.
TEST_F(FolderClaimTest, RemovesNothingElsewhereWhateverItsListSays) {
    {
        FolderClaim claim(path());
        claim.enter({"results.csv"});
    }
    std::ofstream(outside() / "precious") << "kept";
    fs::create_directory(outside() / "folder");
    std::ofstream(outside() / "folder" / "precious") << "kept";
    write("other/precious");
    fs::create_symlink(outside() / "folder", path() / "figures");
    fs::create_symlink(outside() / "precious", path() / "link");
    {
        std::ofstream list(path() / "files.txt", std::ios::app);
        list << "../../precious\n"
             << (outside() / "precious").string() << "\nfigures/precious\nfigures/../../../precious\nlink\n"
             << "other/precious\n..\n.\n\nfigures/..\nhalf_a_line";
    }
    write("half_a_line");
    FolderClaim claim(path());
    claim.enter({"results.csv"});
    for (const fs::path& precious : {outside() / "precious", outside() / "folder" / "precious",
                                     path() / "other" / "precious", path() / "link", path() / "half_a_line"}) {
        EXPECT_TRUE(fs::exists(fs::symlink_status(precious))) << precious;
    }
}

TEST_F(FolderClaimTest, RefusesAFileThatIsNotItsList) {
    write("files.txt", "results.csv\n");
    write("results.csv");
    EXPECT_EQ(refusal(), "cannot write " + (path() / "files.txt").string() +
                             ": it is not a list of delabole's files: move it away, or name another folder");
    EXPECT_EQ(names(), (Names{"files.txt", "results.csv"}));
    fs::remove(path() / "files.txt");
    EXPECT_NE(refusal().find("results.csv: it was not written by delabole"), std::string::npos) << refusal();
    EXPECT_EQ(names(), Names{"results.csv"});
    fs::remove(path() / "results.csv");
    {
        FolderClaim claim(path());
        claim.enter({"results.csv"});
    }
    constexpr std::uintmax_t hundred_gigabytes = 100'000'000'000;  // sparse: the disk holds only the first lines
    fs::resize_file(path() / "files.txt", hundred_gigabytes);
    EXPECT_NE(refusal().find("it is not a list of delabole's files"), std::string::npos) << refusal();
    fs::remove(path() / "files.txt");
    fs::create_symlink("results.csv", path() / "files.txt");
    EXPECT_NE(refusal().find("it is a symbolic link"), std::string::npos) << refusal();
    fs::remove(path() / "files.txt");
    fs::create_directory(path() / "files.txt");
    EXPECT_NE(refusal(), "");
}

TEST(InDisplayUnit, TakesRoundingForZero) {
    EXPECT_EQ(in_display_unit(-1.3e-15, Dimension::length), 0);
    EXPECT_EQ(in_display_unit(2e-17, Dimension::angle), 0);
    EXPECT_EQ(in_display_unit(1e-9, Dimension::length), 1e-9) << "an overlap of stiff springs";
    EXPECT_EQ(in_display_unit(-3.5e-10, Dimension::force_per_length), 0) << "beside columns of 1e6 N/m";
    EXPECT_EQ(in_display_unit(-1e-7, Dimension::moment_per_length), 0);
    EXPECT_EQ(in_display_unit(1.5e-17, Dimension::energy_per_length), 0);
    EXPECT_EQ(in_display_unit(1e-20, Dimension::ratio), 1e-20) << "a probability";
}

TEST(InTableDigits, HasFourButCountsAreWhole) {
    EXPECT_EQ(in_table_digits(degrees(8.14944), Dimension::angle), "8.149 deg");
    EXPECT_EQ(in_table_digits(2446351.2, Dimension::force_per_length), "2446 kN/m");
    EXPECT_EQ(in_table_digits(12345, Dimension::ratio), "12345") << "blocks";
}

TEST(CsvTable, TextsAreNoFormulasAndNumbersStayNumbers) {
    CsvTable table({"name"});
    for (const char* text : {"=1+2", "+cmd|' /C calc'!A0", "-2+3", "@SUM(A1)", "\tx", "\rx", "\nx", "=\"a\",b"}) {
        table.add_row({text});
    }
    for (const char* text : {"-1.5", "+1e3", "-inf", "a=b", "'=1", ""}) {
        table.add_row({text});
    }
    table.add_row({-2.5});
    EXPECT_EQ(table.text(),
              "name\n\"'=1+2\"\n\"'+cmd|' /C calc'!A0\"\n\"'-2+3\"\n\"'@SUM(A1)\"\n\"'\tx\"\n\"'\rx\"\n"
              "\"'\nx\"\n\"'=\"\"a\"\",b\"\n-1.5\n+1e3\n-inf\na=b\n'=1\n\n-2.5\n");
}

TEST(PlainText, ShowsControlCharactersAsTheirNumbers) {
    EXPECT_EQ(plain_text("\x1b]0;title\a"), "\\u001b]0;title\\u0007");
    EXPECT_EQ(plain_text("a\tb\nc\rd\x7f"), "a\tb\nc\\u000dd\\u007f");
    EXPECT_EQ(plain_text("\u009b31m \u202egpj.exe"), "\\u009b31m \\u202egpj.exe");
    EXPECT_EQ(plain_text(std::string_view("\0", 1)), "\\u0000");
    EXPECT_EQ(plain_text("dip 35°, kN/m³, φ, 山, 😀"), "dip 35°, kN/m³, φ, 山, 😀");
}

TEST(PlainText, ReplacesWhatIsNoUtf8) {
    EXPECT_EQ(plain_text("\x9b"
                         "31m"),
              "\uFFFD31m");
    EXPECT_EQ(plain_text("\xc2"), "\uFFFD");
    EXPECT_EQ(plain_text("\xc1\x9b"), "\uFFFD\uFFFD") << "an overlong control character";
    EXPECT_EQ(plain_text("\xe0\x82\x9b"), "\uFFFD\uFFFD\uFFFD") << "an overlong control character";
    EXPECT_EQ(plain_text("\xe2\x82\x1b"), "\uFFFD\uFFFD\\u001b");
    EXPECT_EQ(plain_text("\xf5\x80\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD");
}

TEST(PlainOutput, TakesTextInAnyPieces) {
    std::ostringstream stream;
    const std::string text = "a\u009b\x1b°😀\n";
    {
        const PlainOutput plain(stream);
        for (const char byte : text) {
            stream << byte << std::flush;
        }
        stream << 1.5 << "\xc2";
    }
    EXPECT_EQ(stream.str(), "a\\u009b\\u001b°😀\n1.5\uFFFD");
    stream << "\x1b";
    EXPECT_TRUE(stream.str().ends_with('\x1b')) << "the stream prints as before";
}

TEST(PlainOutput, PassesFailuresOn) {
    std::ofstream full("/dev/full");
    {
        const PlainOutput plain(full);
        full << "x" << std::flush;
        EXPECT_FALSE(full);
    }
}

}  // namespace
}  // namespace delabole
