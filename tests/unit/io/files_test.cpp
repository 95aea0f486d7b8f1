// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <string_view>
#include <thread>

#include "deltamesh/io.h"

namespace deltamesh::files_test {
namespace {

namespace fs = std::filesystem;

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

class Files : public testing::Test {
 protected:
  void SetUp() override { ASSERT_NE(mkdtemp(folder_.data()), nullptr); }
  void TearDown() override { fs::remove_all(folder_); }
  std::string in_folder(const char* name) const { return folder_ + '/' + name; }
  std::size_t count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), {}));
  }
  std::string text_of(const std::string& path) const {
    const auto bytes = read_file(path);
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : "(no file)";
  }

 private:
  std::string folder_ = testing::TempDir() + "deltamesh_files_XXXXXX";
};

TEST_F(Files, WritesAndReplaces) {
  const std::string path = in_folder("a");
  ASSERT_TRUE(write_file(path, bytes_of("first, longer")));
  ASSERT_TRUE(write_file(path, bytes_of("second")));
  EXPECT_EQ(text_of(path), "second");
  ASSERT_TRUE(write_file(path, {}));
  EXPECT_EQ(text_of(path), "");
  EXPECT_EQ(count(), 1U);
}

TEST_F(Files, KeepsLinks) {
  ASSERT_TRUE(write_file(in_folder("real"), bytes_of("old")));
  fs::create_symlink("real", in_folder("link"));
  ASSERT_TRUE(write_file(in_folder("link"), bytes_of("new")));
  EXPECT_TRUE(fs::is_symlink(in_folder("link")));
  EXPECT_EQ(text_of(in_folder("real")), "new");
  EXPECT_EQ(count(), 2U);
}

TEST_F(Files, ModesAreThoseOfNewFilesOrOfTheFileBefore) {
  const auto mode_of = [&](const char* name) {
    return fs::status(in_folder(name)).permissions() & fs::perms::all;
  };
  const mode_t before = umask(027);
  ASSERT_TRUE(write_file(in_folder("a"), bytes_of("new")));
  umask(before);
  EXPECT_EQ(mode_of("a"), fs::perms{0640});
  for (const fs::perms mode : {fs::perms{0666}, fs::perms{0600}, fs::perms{0755}}) {
    fs::permissions(in_folder("a"), mode);
    ASSERT_TRUE(write_file(in_folder("a"), bytes_of("newer")));
    EXPECT_EQ(mode_of("a"), mode);
  }
}

TEST_F(Files, TheUmaskStaysWhileFilesAreWritten) {
  std::atomic<bool> done = false;
  bool open_to_all = false;
  const mode_t before = umask(022);
  std::thread other([&] {
    while (!done) {
      const std::string path = in_folder("other");
      const int descriptor = open(path.c_str(), O_WRONLY | O_CREAT, 0666);
      struct stat status {};
      open_to_all = open_to_all || fstat(descriptor, &status) != 0 || (status.st_mode & 022U) != 0;
      close(descriptor);
      unlink(path.c_str());
    }
  });
  for (int i = 0; i < 60; ++i) {
    fs::remove(in_folder("a"));
    EXPECT_TRUE(write_file(in_folder("a"), bytes_of("x")));
  }
  done = true;
  other.join();
  umask(before);
  EXPECT_FALSE(open_to_all);
}

TEST_F(Files, LeavesNothingBehindOnFailure) {
  fs::create_directory(in_folder("folder"));
  EXPECT_EQ(write_file(in_folder("folder"), bytes_of("x")).error().code, ErrorCode::kFileWrite);
  EXPECT_EQ(write_file(in_folder("none/a"), bytes_of("x")).error().code, ErrorCode::kFileWrite);
  EXPECT_EQ(write_file("/dev/full", bytes_of("x")).error().code, ErrorCode::kFileWrite);
  EXPECT_EQ(count(), 1U);
}

TEST_F(Files, SeveralAreWrittenAllOrNone) {
  ASSERT_TRUE(write_file(in_folder("a"), bytes_of("old")));
  const auto write_with = [&](const std::string& other) {
    return write_files(std::array{NewFile{in_folder("a"), bytes_of("new")}, NewFile{other, bytes_of("other")},
                                  NewFile{in_folder("b"), bytes_of("newest")}});
  };
  fs::create_symlink("a", in_folder("link"));
  for (const std::string& path : {in_folder("none/c"), std::string("/dev/full"), in_folder("link")}) {
    const auto written = write_with(path);
    ASSERT_FALSE(written) << path;
    EXPECT_EQ(written.error().code, ErrorCode::kFileWrite);
    EXPECT_EQ(written.error().where, 1U);
    EXPECT_EQ(text_of(in_folder("a")), "old");
    EXPECT_EQ(count(), 2U);
  }
  ASSERT_TRUE(write_with("/dev/null"));
  ASSERT_TRUE(write_with(in_folder("c")));
  EXPECT_EQ(text_of(in_folder("a")) + text_of(in_folder("b")) + text_of(in_folder("c")), "newnewestother");
  EXPECT_EQ(count(), 4U);
}

TEST_F(Files, ReadsOnlyFiles) {
  EXPECT_EQ(read_file(in_folder("none")).error().code, ErrorCode::kFileOpen);
  EXPECT_EQ(read_file(in_folder("")).error().code, ErrorCode::kFileOpen);
}

}  // namespace
}  // namespace deltamesh::files_test
