#include "plots/drawing/figure.hpp"

#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/process.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace delabole {

namespace {

namespace fs = std::filesystem;

void check_name(const std::string& name) {
    const auto allowed = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
    };
    if (name.empty() || !std::all_of(name.begin(), name.end(), allowed)) {
        throw std::invalid_argument("figure name \"" + name + "\": only letters, digits, '_' and '-' are allowed");
    }
}

constexpr std::string_view beginning_of_scratch = ".drawing-";
constexpr std::size_t letters_of_scratch = 6;  // mkdtemp replaces that many letters

// A folder that is removed with its contents at the end.
class ScratchFolder {
  public:
    explicit ScratchFolder(const fs::path& parent) {
        std::string pattern =
            (parent / (std::string(beginning_of_scratch) + std::string(letters_of_scratch, 'X'))).string();
        if (!::mkdtemp(pattern.data())) {
            throw OutputError(parent, std::generic_category().message(errno));
        }
        path_ = pattern;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

std::string read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// After a failed plot or on a full disk gnuplot leaves a truncated or empty picture, sometimes with exit code 0. The
// end of the file shows whether it is complete.
bool svg_complete(const std::string& content) {
    const std::size_t end = content.rfind("</svg>");
    return content.find("<svg") != std::string::npos && end != std::string::npos && content.size() - end < 16;
}

bool png_complete(const std::string& content) {
    return content.starts_with("\x89PNG\r\n\x1a\n") && content.size() > 12 &&
           content.compare(content.size() - 8, 4, "IEND") == 0;
}

// gnuplot's message without the echo of the script: the lines that state the problem, joined by "; ".
std::string remark(const std::string& output) {
    std::string joined;
    std::size_t begin = 0;
    while (begin < output.size()) {
        const std::size_t end = std::min(output.find('\n', begin), output.size());
        std::string line = output.substr(begin, end - begin);
        begin = end + 1;
        line.erase(0, line.find_first_not_of(" \t\r^"));
        // This warning is ignored, because the legend is laid out by this program itself.
        if (line.find("fitting plot titles") != std::string::npos) {
            continue;
        }
        if (line.find("line ") != std::string::npos || line.find("arning") != std::string::npos) {
            joined += (joined.empty() ? "" : "; ") + line;
        }
    }
    return joined;
}

// ": " and the message, or the beginning of gnuplot's output, on one line; empty if there was none.
std::string explanation(const std::string& output) {
    std::string text = remark(output);
    if (text.empty()) {
        text = output.substr(0, 200);
        std::replace(text.begin(), text.end(), '\n', ' ');
    }
    return text.empty() ? text : std::string(": ").append(text);
}

// gnuplot does not report a full disk but leaves an incomplete picture. Since the disk is the cause and not gnuplot,
// OutputError is thrown.
void check_room(const fs::path& scratch, const fs::path& picture) {
    constexpr std::size_t more_than_a_picture = std::size_t{1} << 20U;
    const fs::path probe = scratch / "room";
    try {
        write_file_atomically(probe, std::string(more_than_a_picture, ' '));
    } catch (const OutputError& error) {
        throw OutputError(picture, error.reason());
    }
    std::error_code ignored;
    fs::remove(probe, ignored);
}

void draw(FigureFiles& files, const fs::path& folder, GnuplotRuns& runs) {
    const std::optional<fs::path> gnuplot = find_program("gnuplot");
    if (!gnuplot) {
        files.status = FigureStatus::gnuplot_missing;
        files.message = "gnuplot is not installed (not found in PATH); the script " + files.script.filename().string() +
                        " was written and can be drawn later";
        return;
    }
    if (!runs.none_because.empty()) {
        files.status = FigureStatus::gnuplot_failed;
        files.message = "gnuplot was not run because " + runs.none_because + "; the script " +
                        files.script.filename().string() + " was written and can be drawn later";
        return;
    }
    const ScratchFolder scratch(folder);
    // -d: the user's own start-up file is not read, so that the figure is the same for everyone.
    const ProcessResult run = run_program(*gnuplot, {"-d", (".." / files.script.filename()).string()}, scratch.path(),
                                          runs.time_limit, runs.give_up);
    if (run.timed_out) {
        runs.none_because = "it had not ended on " + files.script.filename().string();
    }
    const fs::path new_svg = scratch.path() / files.svg.filename();
    const fs::path new_png = scratch.path() / files.png.filename();
    files.status = FigureStatus::gnuplot_failed;
    const bool complete = run.succeeded && svg_complete(read_file(new_svg)) && png_complete(read_file(new_png));
    if (!complete) {
        check_room(scratch.path(), files.svg);
    }
    if (!run.succeeded) {
        files.message = "gnuplot failed on " + files.script.filename().string() + " (" + run.problem + ")" +
                        explanation(run.output);
        return;
    }
    if (!complete) {
        files.message = "gnuplot left an empty or incomplete picture for " + files.script.filename().string() +
                        explanation(run.output);
        return;
    }
    for (const auto& [from, to] : {std::pair{new_svg, files.svg}, std::pair{new_png, files.png}}) {
        std::error_code error;
        fs::rename(from, to, error);
        if (error) {
            throw OutputError(to, error.message());
        }
    }
    files.status = FigureStatus::ok;
    files.message = remark(run.output);
}

}  // namespace

void add_line(Figure& figure, Line line) {
    if (!line.points.empty()) {
        figure.series.emplace_back(std::move(line));
    }
}

void remove_abandoned_drawings(const std::filesystem::path& folder) {
    std::error_code error;
    std::vector<fs::path> abandoned;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(beginning_of_scratch) && name.size() == beginning_of_scratch.size() + letters_of_scratch &&
            entry->is_directory(error) && !entry->is_symlink(error)) {
            abandoned.push_back(entry->path());
        }
    }
    for (const fs::path& scratch : abandoned) {
        fs::remove_all(scratch, error);
    }
}

FigureFiles write_script_and_draw(const std::string& script, const std::filesystem::path& folder,
                                  const std::string& name, GnuplotRuns& runs) {
    check_name(name);
    FigureFiles files{
        .script = folder / (name + ".gp"), .svg = folder / (name + ".svg"), .png = folder / (name + ".png")};
    try {
        create_output_subfolder(folder);
        refuse_link(files.svg);
        refuse_link(files.png);
        write_file_atomically(files.script, script);
        draw(files, folder, runs);
    } catch (const OutputError& error) {
        files.status = FigureStatus::cannot_write;
        files.message = error.what();
        files.write_error = error;
    }
    if (files.status != FigureStatus::ok) {
        for (const fs::path& stale : {files.svg, files.png}) {
            std::error_code ignored;
            fs::remove(stale, ignored);
        }
    }
    return files;
}

FigureFiles write_figure(const Figure& figure, const std::filesystem::path& folder, const std::string& name) {
    GnuplotRuns runs;
    return write_figure(figure, folder, name, runs);
}

FigureFiles write_figure(const Figure& figure, const std::filesystem::path& folder, const std::string& name,
                         GnuplotRuns& runs) {
    check_name(name);
    return write_script_and_draw(gnuplot_script(figure, name), folder, name, runs);
}

}  // namespace delabole
