// Usage: sample_report FOLDER. Draws every kind of figure and collects them, with an animation, in FOLDER/report.html.
#include "plots/report/report.hpp"
#include "samples.hpp"

#include <iostream>

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: sample_report FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = arguments[1];
    std::vector<delabole::FigureFiles> drawn;
    bool good = true;
    for (const auto& [name, figure] : delabole::samples::figures()) {
        drawn.push_back(delabole::write_figure(figure, folder / "figures", name));
        if (!drawn.back().message.empty()) {
            std::cerr << name << ": " << drawn.back().message << "\n";
        }
        good = good && drawn.back().status == delabole::FigureStatus::ok;
    }
    delabole::Report report = delabole::samples::report(drawn);
    report.add(delabole::samples::animation());
    delabole::write_report(report, folder / "report.html");
    return good ? 0 : 1;
}
