#include "plots/drawing/atomic_file.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

namespace delabole {
namespace {

using Names = std::vector<std::string>;

// Every write beyond so many bytes of a file fails, as on a full disk.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        handler_ = ::signal(SIGXFSZ, SIG_IGN);
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        ::signal(SIGXFSZ, handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

std::string message_of_writing(const std::filesystem::path& path, std::string_view text) {
    try {
        write_file_atomically(path, text);
    } catch (const OutputError& error) {
        EXPECT_EQ(error.path(), path);
        EXPECT_FALSE(error.reason().empty());
        return error.what();
    }
    return "written";
}

TEST(AtomicFile, WritesAndReplacesWholeFiles) {
    const ScratchFolder folder;
    const std::string bytes("a\0b\r\n", 5);
    write_file_atomically(folder.path() / "result.json", bytes);
    EXPECT_EQ(content_of(folder.path() / "result.json"), bytes);
    write_file_atomically(folder.path() / "result.json", "");
    EXPECT_EQ(content_of(folder.path() / "result.json"), "");
    EXPECT_EQ(folder.names(), Names{"result.json"});
}

TEST(AtomicFile, LeavesTheRightsToTheUmask) {
    const ScratchFolder folder;
    const mode_t before = ::umask(027);
    write_file_atomically(folder.path() / "result.json", "{}");
    ::umask(before);
    struct stat status {};
    ASSERT_EQ(::stat((folder.path() / "result.json").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST(AtomicFile, NamesPathAndReasonWhenTheFolderIsMissing) {
    const ScratchFolder folder;
    const auto path = folder.path() / "missing" / "result.json";
    EXPECT_EQ(message_of_writing(path, "x"), "cannot write " + path.string() + ": No such file or directory");
}

TEST(AtomicFile, KeepsTheOldFileAndLeavesNothingWhenTheDiskIsFull) {
    const ScratchFolder folder;
    const auto path = folder.path() / "result.json";
    write_file_atomically(path, "old");
    {
        const FileSizeLimit limit(4096);
        EXPECT_EQ(message_of_writing(path, std::string(100'000, 'x')),
                  "cannot write " + path.string() + ": File too large");
    }
    EXPECT_EQ(content_of(path), "old");
    EXPECT_EQ(folder.names(), Names{"result.json"});
}

TEST(AtomicFile, RefusesWhatIsNotARegularFile) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path() / "folder");
    EXPECT_EQ(message_of_writing(folder.path() / "folder", "x"),
              "cannot write " + (folder.path() / "folder").string() + ": it is a folder");
    // Renaming over a device would replace it for the whole system.
    EXPECT_EQ(message_of_writing("/dev/full", "x"), "cannot write /dev/full: it is not a regular file");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

// An archive from somebody else may hold one that leads to a file of the user's.
TEST(AtomicFile, RefusesASymbolicLink) {
    const ScratchFolder folder;
    write_file_atomically(folder.path() / "real", "old");
    for (const char* target : {"real", "missing"}) {
        const auto link = folder.path() / "link";
        std::filesystem::create_symlink(target, link);
        EXPECT_EQ(message_of_writing(link, "new"),
                  "cannot write " + link.string() +
                      ": it is a symbolic link, and none is followed out of the result folder: remove it");
        EXPECT_TRUE(std::filesystem::is_symlink(link));
        std::filesystem::remove(link);
    }
    EXPECT_EQ(content_of(folder.path() / "real"), "old");
    EXPECT_EQ(folder.names(), Names{"real"});
}

TEST(OutputFolder, RefusesASymbolicLinkWithinResults) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder.path() / "real");
    std::filesystem::create_symlink("real", folder.path() / "figures");
    EXPECT_THROW(create_output_subfolder(folder.path() / "figures"), OutputError);
    create_output_folder(folder.path() / "figures");
    create_output_subfolder(folder.path() / "frames");
    EXPECT_EQ(folder.names(), (Names{"figures", "frames", "real"}));
}

TEST(EndOfLinks, IsWhereTheLastOneLeads) {
    const ScratchFolder folder;
    std::filesystem::create_symlink("b", folder.path() / "a");
    std::filesystem::create_symlink("missing", folder.path() / "b");
    EXPECT_EQ(end_of_links(folder.path() / "a"), folder.path() / "missing");
    EXPECT_EQ(end_of_links(folder.path() / "no_link"), folder.path() / "no_link");
    std::filesystem::create_symlink("loop", folder.path() / "loop");
    EXPECT_THROW(end_of_links(folder.path() / "loop"), OutputError);
}

TEST(AtomicFile, RefusesAFolderThatIsNotWritable) {
    const ScratchFolder folder;
    using std::filesystem::perms;
    std::filesystem::permissions(folder.path(), perms::owner_read | perms::owner_exec | perms::group_read |
                                                    perms::group_exec | perms::others_read | perms::others_exec);
    // Root may write everywhere, so that it has to be someone else for a moment.
    const bool root = ::geteuid() == 0;
    ASSERT_TRUE(!root || ::seteuid(65534) == 0);
    const std::string message = message_of_writing(folder.path() / "result.json", "x");
    ASSERT_TRUE(!root || ::seteuid(0) == 0);
    EXPECT_EQ(message, "cannot write " + (folder.path() / "result.json").string() + ": Permission denied");
}

// A process that was killed holds no lock any more; one that is writing does.
TEST(AtomicFile, RemovesAbandonedPartsOfThatFileAlone) {
    const ScratchFolder folder;
    const auto path = folder.path() / "checkpoint";
    const Names others{".checkpoint.1.2.3.part", ".checkpoint.1.part", ".checkpoint.a.2.part", ".checkpoint.part",
                       ".checkpoint2.1.2.part",  "checkpoint",         "checkpoint.1.2.part"};
    for (const std::string& name : others) {
        write_file_atomically(folder.path() / name, "other");
    }
    const auto abandoned = folder.path() / ".checkpoint.1.2.part";
    const auto written = folder.path() / (".checkpoint." + std::to_string(::getpid()) + ".7.part");
    write_file_atomically(abandoned, "half");
    write_file_atomically(written, "half");
    const int writer = ::open(written.c_str(), O_WRONLY | O_CLOEXEC);
    ASSERT_EQ(::flock(writer, LOCK_EX | LOCK_NB), 0);
    remove_abandoned_parts(path);
    EXPECT_FALSE(std::filesystem::exists(abandoned));
    EXPECT_TRUE(std::filesystem::exists(written));
    ::close(writer);
    remove_abandoned_parts(path);
    EXPECT_EQ(folder.names(), others);
    remove_abandoned_parts(folder.path() / "missing" / "checkpoint");
}

TEST(AtomicFile, WritersAndARemoverDoNotDisturbEachOther) {
    const ScratchFolder folder;
    const auto path = folder.path() / "checkpoint";
    std::atomic<bool> writing = true;
    std::thread remover([&] {
        while (writing) {
            remove_abandoned_parts(path);
        }
    });
    for (int round = 0; round < 200; ++round) {
        EXPECT_EQ(message_of_writing(path, std::to_string(round)), "written");
    }
    writing = false;
    remover.join();
    EXPECT_EQ(content_of(path), "199");
    EXPECT_EQ(folder.names(), Names{"checkpoint"});
}

TEST(AtomicFile, ManyWritersOfOneFileLeaveOneWholeFile) {
    const ScratchFolder folder;
    std::vector<std::thread> writers;
    for (const char letter : {'a', 'b', 'c', 'd'}) {
        writers.emplace_back([&folder, letter] {
            for (int round = 0; round < 20; ++round) {
                write_file_atomically(folder.path() / "result", std::string(20'000, letter));
            }
        });
    }
    for (std::thread& writer : writers) {
        writer.join();
    }
    const std::string content = content_of(folder.path() / "result");
    ASSERT_EQ(content.size(), 20'000U);
    EXPECT_EQ(content, std::string(20'000, content[0]));
    EXPECT_EQ(folder.names(), Names{"result"});
}

TEST(OutputFolder, IsCreatedWithItsParents) {
    const ScratchFolder folder;
    create_output_folder(folder.path() / "a" / "b");
    create_output_folder(folder.path() / "a" / "b");
    EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "a" / "b"));
}

TEST(OutputFolder, CannotTakeThePlaceOfAFile) {
    const ScratchFolder folder;
    write_file_atomically(folder.path() / "a", "");
    EXPECT_THROW(create_output_folder(folder.path() / "a"), OutputError);
    EXPECT_THROW(create_output_folder(folder.path() / "a" / "b"), OutputError);
}

}  // namespace
}  // namespace delabole
