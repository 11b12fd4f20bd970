// One item of a chapter reproduced into a folder of its own.
#pragma once

#include "cases/program/thesis/reproduction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

namespace delabole::testing {

class ReproductionTest : public ::testing::Test {
  protected:
    explicit ReproductionTest(ReproductionChapter chapter)
        : chapter_(std::move(chapter)),
          path_(std::filesystem::temp_directory_path() /
                (chapter_.name + "_" + ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
        std::filesystem::remove_all(path_);
    }
    ~ReproductionTest() override { std::filesystem::remove_all(path_); }
    ReproductionTest(const ReproductionTest&) = delete;
    ReproductionTest& operator=(const ReproductionTest&) = delete;

    Reproduction reproduce(const std::string& name) const {
        const auto item = std::ranges::find(chapter_.items, name, &ReproductionItem::name);
        Options options;
        options.out = path_.string();
        options.quiet = true;
        const ResultFolder folder(options, name, OnInterrupt::stop);
        Report report;
        return item->reproduce({folder, report});
    }

    const std::filesystem::path& path() const { return path_; }

    // The settings of both ranges in a figure's script.
    std::string scale_of(const std::string& figure) const {
        std::ifstream script(path_ / "figures" / (figure + ".gp"));
        std::string ranges;
        for (std::string line; std::getline(script, line);) {
            ranges += line.find("range [") == 5 ? line + "\n" : "";
        }
        return ranges;
    }

  private:
    ReproductionChapter chapter_;
    std::filesystem::path path_;
};

}  // namespace delabole::testing
