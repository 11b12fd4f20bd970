#include "version/version.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace {

using delabole::revision;
using delabole::version;

TEST(Version, IsThatOfTheProject) {
    EXPECT_EQ(version(), PROJECT_VERSION);
}

TEST(Version, RevisionIsACommitOrUnknown) {
    const std::regex pattern("unknown|[0-9a-f]{12,}(-modified)?");
    EXPECT_TRUE(std::regex_match(std::string(revision()), pattern)) << revision();
}

}  // namespace
