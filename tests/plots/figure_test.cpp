#include "plots/drawing/figure.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/process.hpp"
#include "samples.hpp"
#include "scratch_folder.hpp"
#include "tests/support/no_number.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <locale>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace delabole {
namespace {

using Names = std::vector<std::string>;

class Environment {
  public:
    Environment(const char* name, const char* value)
        : name_(name), before_(std::getenv(name) ? std::getenv(name) : "") {
        ::setenv(name, value, 1);
    }
    ~Environment() { ::setenv(name_, before_.c_str(), 1); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    const char* name_;
    std::string before_;
};

Figure simple_figure() {
    return {.title = "it's factor_of_safety, 50 % `date` @{x}^2",
            .x = {.title = "a_b", .unit = "kN/m³"},
            .y = {.ticks = {{1, "50 %"}}},
            .series = {Line{.points = {{0, 1.0 / 3}, {1234.5, 1}}, .legend = "c_1 & <2>"}}};
}

TEST(GnuplotScript, IsReadableText) {
    const std::string script = gnuplot_script(simple_figure(), "figure");
    for (const char* line :
         {"# Draw again, in this folder: gnuplot figure.gp\n", "set encoding utf8\n", "set clip two\n",
          "set xlabel 'a_b (kN/m³)'\n", "$series_1 << EOD\n0 0.333333333333\n1234.5 1\nEOD\n",
          "set ytics ('50 %%' 1)\n", "set output 'figure.svg'\n", "set output 'figure.png'\n",
          "plot $series_1 using 1:2 with lines"}) {
        EXPECT_NE(script.find(line), std::string::npos) << line << "not in:\n" << script;
    }
}

// noenhanced: '_' and '^' stay letters. Single quotes: back quotes do not run commands.
TEST(GnuplotScript, TakesTextsLiterally) {
    const std::string script = gnuplot_script(simple_figure(), "figure");
    EXPECT_NE(script.find("set title 'it'.\"'\".'s factor_of_safety, 50 % `date` @{x}^2'\n"), std::string::npos)
        << script;
    EXPECT_NE(script.find(" 'c_1 & <2>' at "), std::string::npos);
    std::size_t terminals = 0;
    for (std::size_t at = script.find("set terminal"); at != std::string::npos;
         at = script.find("set terminal", at + 1)) {
        const std::string settings = script.substr(at, script.find('\n', at) - at);
        EXPECT_NE(settings.find(" noenhanced "), std::string::npos);
        EXPECT_NE(settings.find(" rounded "), std::string::npos) << "mitred ends of lines";
        ++terminals;
    }
    EXPECT_EQ(terminals, 2U);
}

TEST(GnuplotScript, CannotBeBrokenOutOfByATextWithLineBreaks) {
    Figure figure = simple_figure();
    figure.title = "one\nset output '/tmp/elsewhere'";
    figure.labels = {{.at = {0, 0}, .text = "two\nlines\r'"}};
    const std::string script = gnuplot_script(figure, "figure");
    EXPECT_EQ(script.find("\nset output '/tmp"), std::string::npos) << script;
    EXPECT_NE(script.find("set label 'two'.\"\\n\".'lines '.\"'\".''"), std::string::npos) << script;
}

struct CommaForPoint : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(GnuplotScript, DoesNotDependOnTheLocale) {
    for (const auto& [name, figure] : samples::figures()) {
        const std::string script = gnuplot_script(figure, name);
        const std::locale before = std::locale::global(std::locale(std::locale(), new CommaForPoint));
        const std::string elsewhere = gnuplot_script(figure, name);
        std::locale::global(before);
        EXPECT_EQ(script, elsewhere) << name;
    }
}

TEST(GnuplotScript, BreaksLinesAndLeavesOutPointsThatAreNotFinite) {
    Figure figure{.series = {Line{.points = {{not_a_number, 0}, {0, 0}, {1, infinity}, {2, 2}}},
                             Points{.points = {{0, 0}, {1, not_a_number}, {-infinity, 1}, {3, 3}}}}};
    const std::string script = gnuplot_script(figure, "figure");
    EXPECT_NE(script.find("$series_1 << EOD\n0 0\nnan nan\n2 2\nEOD\n"), std::string::npos) << script;
    EXPECT_NE(script.find("$series_2 << EOD\n0 0\n3 3\nEOD\n"), std::string::npos) << script;
    EXPECT_EQ(script.find("inf"), std::string::npos) << script;
}

// A square turned by 12 deg, of which three corners lie beyond two edges of the plot: gnuplot itself fills outside of
// it.
TEST(GnuplotScript, CutsRegionsOffAtTheRangesOfTheAxes) {
    const Region square{.outline = {{-5, -6}, {4.8, -3.9}, {2.7, 5.9}, {-7.1, 3.8}}};
    const std::string script = gnuplot_script({.x = {.range = std::pair{0.0, 10.0}},
                                               .y = {.range = std::pair{4.0, -10.0}},
                                               .series = {square, Region{.outline = {{11, 0}, {12, 0}, {12, 1}}}}},
                                              "figure");
    const std::string begin = "$series_1 << EOD\n";
    const std::size_t data = script.find(begin) + begin.size();
    std::istringstream rows(script.substr(data, script.find("EOD\n", data) - data));
    constexpr double rounding = 1e-9;  // of cuts, and of the twelve digits written
    Polyline drawn;
    for (double x = 0, y = 0; rows >> x >> y;) {
        EXPECT_GE(x, -rounding);
        EXPECT_LE(y, 4 + rounding);
        drawn.emplace_back(x, y);
    }
    EXPECT_EQ(drawn.size(), 4U);  // the corner within, a cut of either edge, and the corner of the plot
    EXPECT_EQ(script.find("$series_2"), std::string::npos) << script;
}

TEST(WriteFigure, DrawsEveryKindOfFigureWithoutARemark) {
    const ScratchFolder folder;
    for (const auto& [name, figure] : samples::figures()) {
        const FigureFiles files = write_figure(figure, folder.path() / "figures", name);
        EXPECT_EQ(files.status, FigureStatus::ok) << name << ": " << files.message;
        EXPECT_EQ(files.message, "") << name;
        EXPECT_GT(std::filesystem::file_size(files.svg), 5000U) << name;
        EXPECT_GT(std::filesystem::file_size(files.png), 5000U) << name;
    }
}

// gnuplot's own way to write a quote within quotes, '', fails at the beginning of a text: figures were missing.
TEST(WriteFigure, DrawsTextsThatBeginOrEndWithQuotes) {
    const ScratchFolder folder;
    for (const std::string text : {"'", "''", "'quoted'", "\n'a''", "\"", "\\'"}) {
        Figure figure{
            .title = text,
            .x = {.title = text, .unit = text, .ticks = {{1, text}}},
            .y = {.title = text},
            .series = {Line{.points = {{0, 0}, {2, 1}}, .legend = text}, Points{.points = {{1, 1}}, .legend = text}},
            .labels = {{.at = {1, 0.5}, .text = text}}};
        const FigureFiles files = write_figure(figure, folder.path(), "figure");
        EXPECT_EQ(files.status, FigureStatus::ok) << text << ": " << files.message;
    }
}

TEST(WriteFigure, ReplacesNoSymbolicLink) {
    const ScratchFolder folder;
    write_file_atomically(folder.path() / "real", "precious");
    for (const char* name : {"figure.gp", "figure.svg", "figure.png"}) {
        std::filesystem::create_symlink("real", folder.path() / name);
        EXPECT_EQ(write_figure(simple_figure(), folder.path(), "figure").status, FigureStatus::cannot_write) << name;
        std::filesystem::remove(folder.path() / name);
    }
    EXPECT_EQ(content_of(folder.path() / "real"), "precious");
}

TEST(WriteFigure, LeavesScriptAndPicturesAndNothingElse) {
    const ScratchFolder folder;
    ASSERT_EQ(write_figure(simple_figure(), folder.path(), "figure").status, FigureStatus::ok);
    EXPECT_EQ(folder.names(), (Names{"figure.gp", "figure.png", "figure.svg"}));
    const std::string svg = content_of(folder.path() / "figure.svg");
    EXPECT_NE(svg.find("it's factor_of_safety, 50 % `date` @{x}^2"), std::string::npos);
    EXPECT_NE(svg.find("c_1 &amp; &lt;2>"), std::string::npos);
    EXPECT_NE(svg.find(">50 %<"), std::string::npos);
}

TEST(WriteFigure, ScriptCanBeDrawnAgainByHandInAMovedFolder) {
    const ScratchFolder folder;
    ASSERT_EQ(write_figure(simple_figure(), folder.path() / "first", "figure").status, FigureStatus::ok);
    const std::string svg = content_of(folder.path() / "first" / "figure.svg");
    std::filesystem::rename(folder.path() / "first", folder.path() / "moved");
    std::filesystem::remove(folder.path() / "moved" / "figure.svg");
    const ProcessResult run =
        run_program(find_program("gnuplot").value(), {"figure.gp"}, folder.path() / "moved", std::chrono::seconds(30));
    EXPECT_TRUE(run.succeeded) << run.output;
    EXPECT_EQ(content_of(folder.path() / "moved" / "figure.svg"), svg);
}

TEST(WriteFigure, DrawsAnEmptyFrameWithoutData) {
    const ScratchFolder folder;
    const Figure nothing{
        .series = {Line{}, Points{}, Region{}, Boxes{}, HeatMap{}, Line{.points = {{infinity, 0}}, .legend = "x"}}};
    for (const Figure& figure : {Figure{}, nothing}) {
        const FigureFiles files = write_figure(figure, folder.path(), "figure");
        EXPECT_EQ(files.status, FigureStatus::ok) << files.message;
        EXPECT_EQ(files.message, "");
        EXPECT_NE(content_of(files.svg).find("no data"), std::string::npos);
    }
}

TEST(WriteFigure, DrawsEveryMarkColourAndArrow) {
    const ScratchFolder folder;
    Figure figure{.arrows = {{.from = {0, 0}, .to = {1, 1}},
                             {.from = {0, 1}, .to = {1, 0}, .colour = Colour::blue, .both_heads = true},
                             {.from = {0, infinity}, .to = {1, 0}}}};
    for (int mark = 0; mark <= static_cast<int>(Marker::cross); ++mark) {
        figure.series.emplace_back(
            Points{.points = {{1.0 * mark, 1}}, .legend = "mark", .marker = static_cast<Marker>(mark)});
    }
    for (int colour = 0; colour <= static_cast<int>(Colour::white); ++colour) {
        figure.series.emplace_back(Region{.outline = {{1.0 * colour, 0}, {colour + 1.0, 0}, {1.0 * colour, 1}},
                                          .colour = static_cast<Colour>(colour)});
    }
    const FigureFiles files = write_figure(figure, folder.path(), "figure");
    EXPECT_EQ(files.status, FigureStatus::ok) << files.message;
    EXPECT_NE(content_of(files.svg).find(">mark<"), std::string::npos);
    const std::string script = content_of(files.script);
    EXPECT_NE(script.find("set arrow from 0,1 to 1,0 heads"), std::string::npos);
    EXPECT_EQ(script.find("inf"), std::string::npos);
}

// Six short names take two rows, while one below the other they would take a quarter of the picture; a name longer than
// the picture is wide is written smaller.
TEST(GnuplotScript, LegendFlowsBelowThePlot) {
    Figure figure;
    for (const char* name : {"ground", "failure plane", "crack", "water", "observed", "predicted"}) {
        figure.series.emplace_back(Line{.points = {{0, 0}, {1, 1}}, .legend = name});
    }
    const auto size_of_canvas = [](const std::string& script) {
        std::smatch size;
        EXPECT_TRUE(std::regex_search(script, size, std::regex("set terminal svg size (\\d+),(\\d+)")));
        return std::pair{std::stod(size[1]), std::stod(size[2])};
    };
    const std::string script = gnuplot_script(figure, "figure");
    const auto [width, height] = size_of_canvas(script);
    EXPECT_LT(height, figure.height + 3.5 * text_height);
    const std::regex entry(R"(set label 10\d\d '([^']+)' at screen (\S+),screen (\S+) left)");
    const std::string first_terminal = script.substr(0, script.find("set terminal pngcairo"));
    double row = 1;
    double right = 0;
    int entries = 0;
    for (std::sregex_iterator at(first_terminal.begin(), first_terminal.end(), entry), end; at != end; ++at) {
        const double left = std::stod((*at)[2]) * width;
        EXPECT_TRUE(std::stod((*at)[3]) < row || left > right) << (*at)[1];
        row = std::stod((*at)[3]);
        right = left + 0.5 * text_height * static_cast<double>((*at)[1].length());  // of narrow letters
        EXPECT_LT(right, width) << (*at)[1];
        ++entries;
    }
    EXPECT_EQ(entries, 6);

    const auto bottom_of_plot = [&](const std::string& name) {
        figure.x.ticks = {{0.5, name}};
        const std::string named = gnuplot_script(figure, "figure");
        std::smatch margin;
        EXPECT_TRUE(std::regex_search(named, margin, std::regex("set bmargin at screen (\\S+)")));
        return std::stod(margin[1]) * size_of_canvas(named).second;
    };
    EXPECT_GT(bottom_of_plot("twice\nthe\nmodel\nerror"), bottom_of_plot("1") + 1.2 * text_height)
        << "the fourth line of a name stood in the legend";
    figure.x.ticks.clear();

    figure.series = {Line{.points = {{0, 0}, {1, 1}}, .legend = std::string(80, 'x')}};
    std::smatch letters;
    const std::string long_name = gnuplot_script(figure, "figure");
    ASSERT_TRUE(std::regex_search(long_name, letters, std::regex("xx' at .* left font ',([0-9.]+)'")));
    EXPECT_LT(std::stod(letters[1]), 0.7 * text_height);
}

TEST(WriteFigure, DrawsASinglePointAndAMapWithoutAnyAnswer) {
    const ScratchFolder folder;
    const Figure point{.series = {Points{.points = {{3, 0}}}}};
    const Figure map{.series = {HeatMap{.x_values = {0, 1},
                                        .y_values = {0, 1},
                                        .values = Eigen::MatrixXd::Constant(2, 2, infinity),
                                        .no_answer_legend = "no answer"}}};
    for (const Figure& figure : {point, map}) {
        const FigureFiles files = write_figure(figure, folder.path(), "figure");
        EXPECT_EQ(files.status, FigureStatus::ok) << files.message;
    }
}

TEST(WriteFigure, SaysThatGnuplotIsMissingAndKeepsTheScript) {
    const ScratchFolder folder;
    ASSERT_EQ(write_figure(simple_figure(), folder.path(), "figure").status, FigureStatus::ok);
    const Environment path("PATH", "");
    const FigureFiles files = write_figure(simple_figure(), folder.path(), "figure");
    EXPECT_EQ(files.status, FigureStatus::gnuplot_missing);
    EXPECT_NE(files.message.find("gnuplot is not installed"), std::string::npos) << files.message;
    // Pictures of the earlier run are removed, as they would pass for pictures of this one.
    EXPECT_EQ(folder.names(), Names{"figure.gp"});
}

TEST(WriteFigure, ReportsWhatGnuplotSays) {
    const ScratchFolder folder;
    GnuplotRuns runs;
    const FigureFiles files =
        write_script_and_draw("set encoding utf8\nplot nonsense(x\n", folder.path(), "figure", runs);
    EXPECT_EQ(files.status, FigureStatus::gnuplot_failed);
    EXPECT_EQ(files.message, "gnuplot failed on figure.gp (exit code 1): \"../figure.gp\" line 2: ')' expected");
    EXPECT_EQ(folder.names(), Names{"figure.gp"});
}

TEST(WriteFigure, DoesNotTrustAnExitCodeOfZero) {
    const ScratchFolder folder;
    for (const char* script : {"", "set terminal svg\nset output 'figure.svg'\nset output\n",
                               "set terminal svg\nset output 'figure.svg'\nplot x\nset output 'figure.png'\n"}) {
        GnuplotRuns runs;
        const FigureFiles files = write_script_and_draw(script, folder.path(), "figure", runs);
        EXPECT_EQ(files.status, FigureStatus::gnuplot_failed) << script;
        EXPECT_NE(files.message.find("empty or incomplete picture"), std::string::npos) << files.message;
        EXPECT_EQ(folder.names(), Names{"figure.gp"});
    }
}

// A gnuplot that hangs once cost its time limit for each of up to 34 figures.
TEST(WriteFigure, GivesUpAfterTheFirstGnuplotThatDoesNotEnd) {
    const ScratchFolder folder;
    GnuplotRuns runs{.time_limit = std::chrono::seconds(1)};
    const FigureFiles first = write_script_and_draw("pause 30\n", folder.path(), "first", runs);
    EXPECT_EQ(first.status, FigureStatus::gnuplot_failed);
    EXPECT_NE(first.message.find("no end within 1 s"), std::string::npos) << first.message;
    const FigureFiles second = write_figure(simple_figure(), folder.path(), "second", runs);
    EXPECT_EQ(second.status, FigureStatus::gnuplot_failed);
    EXPECT_NE(second.message.find("not run because it had not ended on first.gp"), std::string::npos) << second.message;
    EXPECT_EQ(folder.names(), (Names{"first.gp", "second.gp"}));
}

TEST(WriteFigure, SaysWhereItCannotWrite) {
    const ScratchFolder folder;
    write_file_atomically(folder.path() / "file", "");
    const FigureFiles files = write_figure(simple_figure(), folder.path() / "file", "figure");
    EXPECT_EQ(files.status, FigureStatus::cannot_write);
    EXPECT_NE(files.message.find("cannot write " + (folder.path() / "file").string()), std::string::npos)
        << files.message;

    std::filesystem::create_directory(folder.path() / "figure.gp");
    EXPECT_EQ(write_figure(simple_figure(), folder.path(), "figure").status, FigureStatus::cannot_write);
    EXPECT_EQ(folder.names(), (Names{"figure.gp", "file"}));
}

TEST(WriteFigure, RefusesNamesThatLeaveTheFolder) {
    const ScratchFolder folder;
    for (const char* name : {"", "../figure", "a/b", "it's", ".hidden"}) {
        EXPECT_THROW(write_figure(simple_figure(), folder.path(), name), std::invalid_argument) << name;
    }
}

TEST(RunProgram, ReportsExitSignalAndTimeLimit) {
    const std::filesystem::path shell = find_program("sh").value();
    const auto run = [&](const char* command, int seconds) {
        return run_program(shell, {"-c", command}, "/", std::chrono::seconds(seconds));
    };
    EXPECT_TRUE(run("cat", 10).succeeded) << "standard input is empty";
    EXPECT_EQ(run("echo here; pwd >&2", 10).output, "here\n/\n");
    EXPECT_EQ(run("exit 3", 10).problem, "exit code 3");
    EXPECT_EQ(run("kill -TERM $$", 10).problem, "stopped by signal 15");
    EXPECT_EQ(run("exec sleep 20", 1).problem, "no end within 1 s");
    const ProcessResult given_up =
        run_program(shell, {"-c", "exec sleep 20"}, "/", std::chrono::seconds(20), [] { return true; });
    EXPECT_TRUE(given_up.given_up);
    EXPECT_EQ(given_up.problem, "given up");
    EXPECT_EQ(run("yes | head -c 1000000", 10).output.size(), 65536U);
    EXPECT_FALSE(run_program("/nowhere/gnuplot", {}, "/", std::chrono::seconds(1)).succeeded);
    EXPECT_FALSE(run_program(shell, {}, "/nowhere", std::chrono::seconds(1)).succeeded);
}

TEST(FindProgram, PassesOverFoldersAndEmptyEntries) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path() / "gnuplot");
    const Environment path("PATH", ("::" + folder.path().string() + ":").c_str());
    EXPECT_EQ(find_program("gnuplot"), std::nullopt);
}

}  // namespace
}  // namespace delabole
