// image_file_test.cpp: files appear whole or not at all, and reading never hangs.
#include <raster/image/file.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "image_testing.h"

namespace {

namespace fs = std::filesystem;
using raster::Bytes;
using raster::ErrorKind;
using raster::testing::bytes_of;
using raster::testing::content;
using ::testing::HasSubstr;

/// Runs `body` in a child process and gives the status of waitpid; the body's value is the exit code.
int in_child(const std::function<int()>& body) {
    std::fflush(nullptr);  // or the child would print what waits in the parent's buffers
    const pid_t child = ::fork();
    if (child == 0) ::_exit(body());
    int status = -1;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}

/// Root may write everywhere; the child gives that up.
void become_nobody() {
    if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(99);
}

class File : public raster::testing::InFolder {};

TEST_F(File, WhatIsWrittenIsRead) {
    const Bytes bytes = bytes_of(std::string("line\r\n\0\xff", 8));
    ASSERT_TRUE(raster::write_file(in_folder("a"), bytes));
    const auto read = raster::read_file(in_folder("a"), 100);
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, bytes);
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, PiecesBecomeOneFile) {
    const auto in_thousands = [](const raster::Sink& sink) {
        for (int i = 0; i < 1000; ++i) EXPECT_TRUE(sink(bytes_of(std::to_string(i) + "\n")));
    };
    ASSERT_TRUE(raster::write_file_in_pieces(in_folder("a"), in_thousands));
    EXPECT_THAT(content(in_folder("a")), ::testing::StartsWith("0\n1\n2\n"));
    EXPECT_THAT(content(in_folder("a")), ::testing::EndsWith("\n998\n999\n"));
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, PiecesThatAreNotFinishedLeaveTheOldFileAndNothingElse) {
    ASSERT_TRUE(raster::write_file(in_folder("a"), bytes_of("old")));
    {
        auto file = raster::FileInPieces::open(in_folder("a"));
        ASSERT_TRUE(file);
        EXPECT_TRUE(file->append(bytes_of("new")));
        EXPECT_EQ(content(in_folder("a")), "old");
        EXPECT_EQ(file_count(), 2u);
    }
    EXPECT_EQ(content(in_folder("a")), "old");
    EXPECT_EQ(file_count(), 1u);
    auto file = raster::FileInPieces::open(in_folder("a"));
    ASSERT_TRUE(file);
    EXPECT_TRUE(file->append(bytes_of("new")));
    EXPECT_TRUE(file->append(bytes_of("er")));
    EXPECT_TRUE(file->finish());
    EXPECT_EQ(content(in_folder("a")), "newer");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, APieceThatCannotBeWrittenIsAnErrorAndEndsTheWriting) {
    int written = 0;
    const auto status = raster::write_file_in_pieces("/dev/full", [&](const raster::Sink& sink) {
        while (written < 1000 && sink(bytes_of("x"))) ++written;
        EXPECT_FALSE(sink(bytes_of("y")));
    });
    ASSERT_FALSE(status);
    EXPECT_THAT(status.error().message, HasSubstr("No space left on device"));
    EXPECT_EQ(written, 0);
}

TEST_F(File, AnEmptyFileIsAFile) {
    ASSERT_TRUE(raster::write_file(in_folder("a"), {}));
    const auto read = raster::read_file(in_folder("a"), 0);
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->empty());
}

TEST_F(File, ALongerFileIsReplacedByAShorterOne) {
    ASSERT_TRUE(raster::write_file(in_folder("a"), bytes_of(std::string(100000, 'x'))));
    ASSERT_TRUE(raster::write_file(in_folder("a"), bytes_of("short")));
    EXPECT_EQ(content(in_folder("a")), "short");
}

TEST_F(File, ANameAsLongAsTheSystemAllowsIsWritten) {
    EXPECT_TRUE(raster::write_file(in_folder(std::string(255, 'n')), bytes_of("x")));
    const auto status = raster::write_file(in_folder(std::string(256, 'n')), bytes_of("x"));
    ASSERT_FALSE(status);
    EXPECT_THAT(status.error().message, HasSubstr("File name too long"));
}

TEST_F(File, ANameWithoutAFolderIsInTheCurrentOne) {
    const int status = in_child([&] {
        if (::chdir(folder.c_str()) != 0) return 1;
        return raster::check_writable("plain") && raster::write_file("plain", bytes_of("x")) ? 0 : 2;
    });
    EXPECT_EQ(status, 0);
    EXPECT_EQ(content(in_folder("plain")), "x");
}

// RLIMIT_FSIZE stops a process at an exact byte: SIGXFSZ kills it there, or write() fails if that is ignored.
TEST_F(File, KilledAtAnyByteTheOldFileIsIntact) {
    ASSERT_TRUE(raster::write_file(in_folder("a"), bytes_of("old")));
    for (const rlim_t stop : {1u, 4096u, 99999u}) {
        const int status = in_child([&] {
            const rlimit no_core{0, 0}, limit{stop, stop};
            ::setrlimit(RLIMIT_CORE, &no_core);
            ::setrlimit(RLIMIT_FSIZE, &limit);
            ::signal(SIGXFSZ, SIG_DFL);
            (void)!raster::write_file(in_folder("a"), bytes_of(std::string(100000, 'n')));
            return 0;
        });
        EXPECT_TRUE(WIFSIGNALED(status)) << status;
        EXPECT_EQ(content(in_folder("a")), "old");
    }
}

TEST_F(File, WhenTheDiskRefusesTheOldFileIsIntactAndNothingIsLeft) {
    ASSERT_TRUE(raster::write_file(in_folder("a"), bytes_of("old")));
    const int status = in_child([&] {
        const rlimit limit{5000, 5000};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::signal(SIGXFSZ, SIG_IGN);
        const auto status = raster::write_file(in_folder("a"), bytes_of(std::string(100000, 'n')));
        if (status || status.error().kind != ErrorKind::input_output) return 1;
        return status.error().message == in_folder("a") + ": cannot write: File too large" ? 0 : 2;
    });
    EXPECT_EQ(status, 0);
    EXPECT_EQ(content(in_folder("a")), "old");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, KilledBetweenManyWritesTheFileIsAlwaysOneOfThemWhole) {
    const std::string a(500000, 'a'), b(400000, 'b');
    const Bytes bytes_a = bytes_of(a), bytes_b = bytes_of(b);
    ASSERT_TRUE(raster::write_file(in_folder("f"), bytes_a));
    for (int round = 1; round <= 8; ++round) {
        int done[2];
        ASSERT_EQ(::pipe(done), 0);
        const pid_t writer = ::fork();
        if (writer == 0) {
            for (;;) {
                (void)!raster::write_file(in_folder("f"), bytes_b);
                (void)!raster::write_file(in_folder("f"), bytes_a);
                if (::write(done[1], "x", 1) != 1) ::_exit(1);
            }
        }
        char byte;
        for (int i = 0; i < round; ++i) ASSERT_EQ(::read(done[0], &byte, 1), 1);
        ::kill(writer, SIGKILL);
        ASSERT_EQ(::waitpid(writer, nullptr, 0), writer);
        ::close(done[0]);
        ::close(done[1]);
        const std::string now = content(in_folder("f"));
        EXPECT_TRUE(now == a || now == b) << now.size() << " bytes";
    }
}

TEST_F(File, ThreadsWritingTheSameFileLeaveOneOfTheirs) {
    std::vector<std::thread> threads;
    for (char c = 'a'; c < 'e'; ++c) {
        threads.emplace_back([this, c] {
            for (int i = 0; i < 20; ++i)
                EXPECT_TRUE(raster::write_file(in_folder("f"), bytes_of(std::string(10000, c))));
        });
    }
    for (std::thread& thread : threads) thread.join();
    const std::string now = content(in_folder("f"));
    EXPECT_EQ(now, std::string(10000, now[0]));
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(File, AFileThatHappensToHaveATemporarysNameIsSpared) {
    const std::string start = in_folder(".raster-" + std::to_string(::getpid()) + "-");
    std::vector<std::string> others;
    for (int i = 0; i < 900; ++i) others.push_back(start + std::to_string(i) + ".tmp");
    for (const std::string& other : others) std::ofstream(other) << "keep";
    EXPECT_TRUE(raster::write_file(in_folder("f"), bytes_of("new")));
    EXPECT_EQ(content(in_folder("f")), "new");
    for (const std::string& other : others) EXPECT_EQ(content(other), "keep");
}

TEST_F(File, ANewFileObeysTheUmaskAndAReplacedOneKeepsItsMode) {
    const mode_t before = ::umask(027);
    EXPECT_TRUE(raster::write_file(in_folder("new"), bytes_of("x")));
    ::umask(before);
    EXPECT_EQ(fs::status(in_folder("new")).permissions(), fs::perms(0640));

    fs::permissions(in_folder("new"), fs::perms(0604));
    EXPECT_TRUE(raster::write_file(in_folder("new"), bytes_of("y")));
    EXPECT_EQ(fs::status(in_folder("new")).permissions(), fs::perms(0604));
}

TEST_F(File, ALinkStaysAndWhatItLeadsToIsReplaced) {
    fs::create_directory(in_folder("real"));
    ASSERT_TRUE(raster::write_file(in_folder("real/old"), bytes_of("old")));
    fs::create_symlink("real/old", in_folder("one"));
    fs::create_symlink("one", in_folder("two"));
    fs::create_symlink("real/not-yet", in_folder("dangling"));

    EXPECT_TRUE(raster::write_file(in_folder("two"), bytes_of("new")));
    EXPECT_TRUE(raster::write_file(in_folder("dangling"), bytes_of("made")));

    EXPECT_TRUE(fs::is_symlink(in_folder("one")) && fs::is_symlink(in_folder("two")));
    EXPECT_EQ(content(in_folder("real/old")), "new");
    EXPECT_EQ(content(in_folder("real/not-yet")), "made");
}

TEST_F(File, ALinkToItselfIsAnErrorOfTheSystem) {
    fs::create_symlink("self", in_folder("self"));
    const std::string self = in_folder("self");
    for (const auto& status : {raster::write_file(self, {}), raster::check_writable(self)}) {
        ASSERT_FALSE(status);
        EXPECT_THAT(status.error().message, HasSubstr("Too many levels of symbolic links"));
    }
}

TEST(FileSpecial, AFullDeviceIsAnErrorAndTheNullDeviceIsNot) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    const auto status = raster::write_file("/dev/full", bytes_of("x"));
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().kind, ErrorKind::input_output);
    EXPECT_EQ(status.error().message, "/dev/full: cannot write: No space left on device");
    EXPECT_TRUE(raster::write_file("/dev/null", bytes_of("x")));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_TRUE(raster::check_writable("/dev/null"));
}

TEST_F(File, AFifoIsWrittenDirectlyAndInFull) {
    ASSERT_EQ(::mkfifo(in_folder("fifo").c_str(), 0600), 0);
    const std::string text(500000, 'p');  // far more than a pipe holds
    std::thread writer([&] { EXPECT_TRUE(raster::write_file(in_folder("fifo"), bytes_of(text))); });
    EXPECT_EQ(content(in_folder("fifo")), text);
    writer.join();
    EXPECT_TRUE(fs::is_fifo(in_folder("fifo")));
}

TEST_F(File, DashIsStandardOutputAfterWhatWasPrinted) {
    const int status = in_child([&] {
        const int out = ::open(in_folder("out").c_str(), O_WRONLY | O_CREAT, 0600);
        ::dup2(out, 1);
        std::fputs("first ", stdout);
        return raster::check_writable("-") && raster::write_file("-", bytes_of("second")) ? 0 : 1;
    });
    EXPECT_EQ(status, 0);
    EXPECT_EQ(content(in_folder("out")), "first second");
}

TEST(FileSpecial, AClosedOrFullStandardOutputIsAnError) {
    const int closed = in_child([] {
        ::close(1);
        const auto status = raster::write_file("-", bytes_of("x"));
        const char* words = "standard output: cannot write: Bad file descriptor";
        return !status && status.error().message == words ? 0 : 1;
    });
    EXPECT_EQ(closed, 0);
    const int full = in_child([] {
        ::dup2(::open("/dev/full", O_WRONLY), 1);
        const auto status = raster::write_file("-", bytes_of("x"));
        const char* words = "standard output: cannot write: No space left on device";
        return !status && status.error().message == words ? 0 : 1;
    });
    EXPECT_EQ(full, 0);
}

TEST_F(File, AMissingFolderOrAFolderAsTargetIsToldBeforehandAndWhenWriting) {
    std::ofstream(in_folder("plain")) << "x";
    const std::pair<std::string, std::string> cases[] = {
        {in_folder("none/x.png"), "No such file or directory"}, {in_folder("plain/x.png"), "Not a directory"},
        {folder, "Is a directory"},                             {folder + "/", "Is a directory"},
        {in_folder("newfolder/"), "No such file or directory"}, {"", "No such file or directory"},
        {std::string("a\0b", 3), "Invalid argument"},
    };
    for (const auto& [path, words] : cases) {
        for (const auto& status : {raster::check_writable(path), raster::write_file(path, bytes_of("x"))}) {
            ASSERT_FALSE(status) << path;
            EXPECT_EQ(status.error().kind, ErrorKind::input_output);
            EXPECT_THAT(status.error().message, HasSubstr(words)) << path;
        }
    }
    EXPECT_EQ(file_count(), 1u);
    EXPECT_TRUE(raster::check_writable(in_folder("new.png")));
    EXPECT_TRUE(raster::check_writable(in_folder("plain")));
    EXPECT_EQ(file_count(), 1u) << "checking must not make a file";
}

TEST_F(File, AReadOnlyFolderOrFileIsRefusedBeforehandAndWhenWriting) {
    fs::create_directory(in_folder("locked"));
    fs::permissions(in_folder("locked"), fs::perms(0555));
    fs::create_directory(in_folder("open"));
    fs::permissions(in_folder("open"), fs::perms(0777));
    const int status = in_child([&] {
        become_nobody();
        const Bytes bytes = bytes_of("x");
        const std::string new_file = in_folder("locked/x.png"), protected_file = in_folder("open/x.png");
        std::ofstream(protected_file) << "keep";
        fs::permissions(protected_file, fs::perms(0444));
        for (const std::string& path : {new_file, protected_file}) {
            for (const auto& status : {raster::check_writable(path), raster::write_file(path, bytes)}) {
                if (status || status.error().kind != ErrorKind::input_output) return 1;
                if (status.error().message.find("Permission denied") == std::string::npos) return 2;
            }
        }
        return content(protected_file) == "keep" ? 0 : 3;
    });
    EXPECT_EQ(status, 0);
}

TEST_F(File, ReadingRefusesWhatIsNoRegularFileWithoutWaiting) {
    ASSERT_EQ(::mkfifo(in_folder("fifo").c_str(), 0600), 0);
    const std::pair<std::string, std::string> cases[] = {
        {in_folder("fifo"), "not a regular file"},
        {"/dev/zero", "not a regular file"},
        {folder, "Is a directory"},
        {in_folder("none"), "No such file or directory"},
        {std::string("/dev/null\0.png", 14), "Invalid argument"},
    };
    for (const auto& [path, words] : cases) {
        const auto read = raster::read_file(path, 1000);
        ASSERT_FALSE(read) << path;
        EXPECT_EQ(read.error().kind, ErrorKind::input_output);
        EXPECT_THAT(read.error().message, HasSubstr(words)) << path;
    }
}

TEST_F(File, ReadingIsBounded) {
    ASSERT_TRUE(raster::write_file(in_folder("a"), bytes_of(std::string(1000, 'x'))));
    EXPECT_TRUE(raster::read_file(in_folder("a"), 1000));
    EXPECT_TRUE(raster::read_file(in_folder("a"), std::numeric_limits<std::size_t>::max()));
    const auto read = raster::read_file(in_folder("a"), 999);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::bad_input);
    EXPECT_EQ(read.error().message, in_folder("a") + ": larger than the limit of 999 bytes");
}

TEST_F(File, AHugeFileIsRefusedBeforeMemoryIsTaken) {
    std::ofstream(in_folder("sparse")) << "x";
    fs::resize_file(in_folder("sparse"), std::uintmax_t(1) << 40);
    EXPECT_FALSE(raster::read_file(in_folder("sparse"), std::size_t(1) << 30));
}

TEST(FileSpecial, AFileThatCallsItselfEmptyIsReadToItsEnd) {
    if (!fs::exists("/proc/self/status")) GTEST_SKIP() << "no /proc";
    const auto read = raster::read_file("/proc/self/status", 100000);
    ASSERT_TRUE(read);
    EXPECT_GT(read->size(), 100u);
    EXPECT_FALSE(raster::read_file("/proc/self/status", 100));
}

}  // namespace
