// delabole reproduce
#include "cases/program/commands/commands.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/terminal/progress.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "fitting/work/parallel.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "version/version.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <mutex>
#include <optional>
#include <utility>

namespace delabole {

namespace {

const std::vector<ReproductionChapter>& chapters() {
    static const std::vector<ReproductionChapter> all = {chapter_2(), chapter_3(),          chapter_4(),
                                                         chapter_5(), appendix_a_chapter(), published_problems()};
    return all;
}

struct Chosen {
    std::string name;  // of the result folder
    std::string title;
    std::vector<const ReproductionItem*> items;
};

// An item may occur twice: Fig 3.4 belongs to chapter 3 and, through its equation, to chapter 4.
bool has(const std::vector<const ReproductionItem*>& items, const std::string& name) {
    return std::ranges::any_of(items, [&](const ReproductionItem* item) { return item->name == name; });
}

// The items of a chapter, a single item, or all items.
Chosen choose(const std::string& what) {
    Chosen chosen{what.empty() ? "thesis" : what, "Thesis: printed and computed", {}};
    for (const ReproductionChapter& chapter : chapters()) {
        const bool whole = what.empty() || what == chapter.name;
        for (const ReproductionItem& item : chapter.items) {
            const ReproductionCost most = what.empty() ? ReproductionCost::seconds : ReproductionCost::minutes;
            const bool wanted = what == item.name || (whole && item.cost <= most);
            if (wanted && !has(chosen.items, item.name)) {
                chosen.items.push_back(&item);
                chosen.title = what.empty() ? chosen.title : chapter.title;
            }
        }
    }
    if (chosen.items.empty()) {
        std::vector<std::string> names;
        for (const auto& [name, meaning] : reproducible()) {
            names.push_back(name);
        }
        throw UsageError("reproduce: nothing is called '" + what + "'; the names are " + list_in_words(names) +
                         suggestion(what, names));
    }
    return chosen;
}

// Reports the progress of all items from that of the item at work.
class ItemsProgress {
  public:
    ItemsProgress(const std::vector<const ReproductionItem*>& items, bool quiet) : items_(items), progress_(quiet) {
        for (const ReproductionItem* item : items) {
            total_ += weight(*item);
        }
    }

    // The share done of `item`.
    void report(std::size_t item, double share, const std::string& what) {
        double done = share * weight(*items_[item]);
        for (std::size_t before = 0; before < item; ++before) {
            done += weight(*items_[before]);
        }
        progress_.report(done / total_, items_[item]->name + (what.empty() ? "" : ": " + what));
    }

  private:
    static double weight(const ReproductionItem& item) { return item.cost == ReproductionCost::minutes ? 30 : 1; }

    const std::vector<const ReproductionItem*>& items_;
    double total_ = 0;
    Progress progress_;
};

}  // namespace

void run_part(const ResultFolder& folder, const PartOfWork& part, std::size_t count,
              const std::function<void(std::size_t)>& task) {
    std::mutex reporting;
    std::size_t done = 0;
    run_tasks(count, folder.threads(), [&](std::size_t number) {
        if (interrupt_flag()) {
            return;
        }
        task(number);
        const std::scoped_lock lock(reporting);
        const double share = static_cast<double>(++done) / static_cast<double>(count);
        folder.report_progress(part.begin + share * (part.end - part.begin), part.what);
    });
    stop_if_interrupted();
}

std::string columns_in_words(const std::vector<std::string_view>& does) {
    std::vector<std::string> parts;
    for (std::size_t first = 0; first < does.size();) {
        std::size_t next = first + 1;
        while (next < does.size() && does[next] == does[first]) {
            ++next;
        }
        const bool several = next > first + 1;
        parts.push_back(std::to_string(first + 1) + (several ? "-" + std::to_string(next) : "") + " " +
                        std::string(does[first].substr(0, does[first].size() - (several ? 1 : 0))));
        first = next;
    }
    return list_in_words(parts);
}

std::string difference_in_words(double difference) {
    return std::abs(difference) < 1e-9 ? "0" : number_in_words(difference);
}

std::vector<std::pair<std::string, std::string>> reproducible() {
    std::vector<std::pair<std::string, std::string>> names;
    for (const ReproductionChapter& chapter : chapters()) {
        names.emplace_back(chapter.name, "all that follows: " + chapter.meaning);
        for (const ReproductionItem& item : chapter.items) {
            if (std::ranges::find(names, item.name, &std::pair<std::string, std::string>::first) == names.end()) {
                names.emplace_back(item.name, item.meaning);
            }
        }
    }
    return names;
}

namespace {

// Names the items that take minutes and are left out when everything is reproduced.
std::string left_out() {
    std::vector<std::string> names;
    for (const ReproductionChapter& chapter : chapters()) {
        for (const ReproductionItem& item : chapter.items) {
            if (item.cost == ReproductionCost::minutes) {
                names.push_back(item.name);
            }
        }
    }
    return "left out, because they take minutes: " + list_in_words(names);
}

}  // namespace

ExitCode reproduce_command(const std::string& what, const Options& options) {
    const Stopwatch watch;
    const Chosen chosen = choose(what);
    ResultFolder folder(options, chosen.name, OnInterrupt::stop);
    Report report{chosen.title, "The analysis of toppling failure using models and numerical methods", {}};
    Json json;
    json["status"] = "ok";
    std::vector<PrintedRow> rows;
    std::optional<ItemsProgress> progress(std::in_place, chosen.items, options.quiet);
    for (std::size_t number = 0; number < chosen.items.size(); ++number) {
        const ReproductionItem* item = chosen.items[number];
        folder.on_progress([&](double share, const std::string& doing) { progress->report(number, share, doing); });
        Reproduction result;
        try {
            stop_if_interrupted();
            folder.report_progress(0, "");
            result = item->reproduce({folder, report});
        } catch (const Interrupted&) {
            progress.reset();
            std::cerr << "delabole: interrupted at " << item->name
                      << "; nothing is kept of it: the same command begins anew\n";
            return ExitCode::not_converged;
        }
        json[item->name] = result.json;
        for (const PrintedRow& row : result.rows) {
            rows.push_back(row);
            rows.back().place = item->place;
            Json one = {{"what", row.what},
                        {"printed", row.printed},
                        {"computed", row.computed},
                        {"remark", in_words(row.remark)}};
            if (row.remark.verdict != RowVerdict::none) {
                one["met"] = row.remark.verdict == RowVerdict::met;
            }
            if (!row.clean.empty()) {
                one["clean_engine"] = row.clean;
            }
            json[item->name]["printed_and_computed"].push_back(one);
        }
    }
    progress.reset();
    const RowCounts counts = count_rows(rows);
    json["counts"] = {{"met", counts.met},
                      {"not_met", counts.not_met},
                      {"beside", counts.beside},
                      {"not_printed", counts.not_printed}};
    const std::string counted = in_words(counts);
    const std::string missing = what.empty() ? left_out() : "";
    report.add(Heading{"Count"});
    report.add(Paragraph{counted + (missing.empty() ? "" : "; " + missing)});
    Json source;
    source["program"] = "delabole " + std::string(version());
    source["revision"] = std::string(revision());
    source["wall_seconds"] = watch.seconds();
    json["provenance"] = source;
    report.add(Heading{"Provenance"});
    report.add(provenance_block(source));
    folder.write_report(report);
    folder.write("result.json", json_text(json));
    if (options.json) {
        std::cout << json_text(json);
    } else if (!options.quiet) {
        constexpr std::size_t width = 118;  // that of the table
        std::cout << screen_table(rows) << '\n'
                  << wrapped(counted, width) << '\n'
                  << wrapped(missing, width) << (missing.empty() ? "" : "\n") << "report in "
                  << (folder.path() / "report.html").string() << '\n';
    }
    return ExitCode::ok;
}

}  // namespace delabole
