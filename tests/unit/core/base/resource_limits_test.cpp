// The limits of control groups, told by trees of files as the system has them.
#include "ryosen/base/resource_limits.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <fstream>

#include "tests/unit/core/io/io_helpers.h"

namespace ryosen {
namespace {

constexpr std::uint64_t mib = std::uint64_t{1} << 20;

class ResourceLimitsTest : public testing::Test {
 protected:
  void SetUp() override {
    rlimit limit;
    for (const auto resource : {RLIMIT_AS, RLIMIT_DATA})
      if (::getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) GTEST_SKIP() << "limited by ulimit";
  }

  void write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_.path() / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  // What is lacking for that many MiB in use; "" where nothing is.
  std::string lack(std::uint64_t need_mib) const {
    const ControlGroups groups{folder_.path() / "list", folder_.path()};
    const auto failure = lack_of_memory({"This", "これ"}, {0, 0, need_mib * mib}, groups);
    if (!failure) return "";
    EXPECT_EQ(failure->exit_code, ExitCode::out_of_memory);
    EXPECT_TRUE(failure->message.code == "out_of_memory");
    return failure->message.text.en;
  }
  // A group of version 2, or of memory in version 1.
  void group_v2(const std::string& folder, const std::string& whole, std::uint64_t used_mib) const {
    write(folder + "/memory.max", whole + "\n");
    write(folder + "/memory.current", std::to_string(used_mib * mib) + "\n");
  }
  void group_v1(const std::string& folder, std::uint64_t whole, std::uint64_t used_mib) const {
    write("memory" + folder + "/memory.limit_in_bytes", std::to_string(whole) + "\n");
    write("memory" + folder + "/memory.usage_in_bytes", std::to_string(used_mib * mib) + "\n");
  }
  static std::string bytes(std::uint64_t number_mib) { return std::to_string(number_mib * mib); }
  static std::string sentence(const std::string& need, const std::string& left, const std::string& whole) {
    return "This needs about " + need + " more memory, and the control group (cgroup) leaves " + left + " of its " +
           whole + "; raise that limit.";
  }

  io_test::TemporaryFolder folder_;
};

TEST_F(ResourceLimitsTest, of_a_group_of_version_2) {
  write("list", "0::/user/session\n");
  group_v2("user/session", bytes(300), 100);
  EXPECT_EQ(lack(200), "");
  EXPECT_EQ(lack(201), sentence("201 MiB", "200 MiB", "300 MiB"));
}

TEST_F(ResourceLimitsTest, of_the_groups_around_a_group) {
  write("list", "0::/user/session\n");
  group_v2("user/session", "max", 100);
  group_v2("user", bytes(2048), 1900);
  EXPECT_EQ(lack(148), "");
  EXPECT_EQ(lack(149), sentence("149 MiB", "148 MiB", "2.0 GiB"));
  group_v2("user/session", bytes(150), 100);  // what is left of the inner one counts, and is said, first
  EXPECT_EQ(lack(50), "");
  EXPECT_EQ(lack(149), sentence("149 MiB", "50 MiB", "150 MiB"));
  group_v2("user/session", bytes(4000), 100);
  EXPECT_EQ(lack(149), sentence("149 MiB", "148 MiB", "2.0 GiB"));
}

// Within a container the list may name groups of which only the outermost is seen, at the root.
TEST_F(ResourceLimitsTest, of_a_root_that_is_not_the_systems) {
  write("list", "0::/outside/of/the/container\n");
  group_v2(".", bytes(64), 16);
  EXPECT_EQ(lack(48), "");
  EXPECT_EQ(lack(49), sentence("49 MiB", "48 MiB", "64 MiB"));
  write("list", "0::/../sibling\n");
  EXPECT_NE(lack(49), "");
}

TEST_F(ResourceLimitsTest, of_groups_of_version_1) {
  constexpr std::uint64_t none = 9223372036854771712u;
  write("list", "12:cpu,cpuacct:/a\n4:memory:/a/b:c\n1:name=systemd:/\n0::/\n");
  group_v1("/a/b:c", none, 700);
  group_v1("/a", 1024 * mib, 700);
  group_v1("", none, 9000);
  EXPECT_EQ(lack(324), "");
  EXPECT_EQ(lack(325), sentence("325 MiB", "324 MiB", "1.0 GiB"));
  group_v1("/a/b:c", 800 * mib, 700);
  EXPECT_EQ(lack(101), sentence("101 MiB", "100 MiB", "800 MiB"));
  write("list", "4:hugetlb,memory:/a/b:c\n");
  EXPECT_NE(lack(101), "");
  write("list", "4:cpuset,memory_of_another_kind:/a/b:c\n0::/\n");
  EXPECT_EQ(lack(101), "");
}

// Caches of files are given back when something needs the room.
TEST_F(ResourceLimitsTest, but_for_what_can_be_taken_back) {
  write("list", "0::/g\n");
  group_v2("g", bytes(500), 450);
  write("g/memory.stat", "anon 5\ninactive_file " + bytes(200) + "\nactive_file " + bytes(100) + "\nslab_reclaimable " +
                             bytes(50) + "\nslab_unreclaimable 7\n");
  EXPECT_EQ(lack(400), "");
  EXPECT_EQ(lack(401), sentence("401 MiB", "400 MiB", "500 MiB"));

  write("list", "4:memory:/g\n");
  group_v1("/g", 500 * mib, 450);
  write("memory/g/memory.stat", "inactive_file " + bytes(9) + "\nactive_file " + bytes(9) + "\ntotal_inactive_file " +
                                    bytes(100) + "\ntotal_active_file " + bytes(50) + "\n");
  EXPECT_EQ(lack(200), "");
  EXPECT_EQ(lack(201), sentence("201 MiB", "200 MiB", "500 MiB"));
}

TEST_F(ResourceLimitsTest, none_where_nothing_is_told) {
  EXPECT_EQ(lack(1u << 20), "");
  write("list", "");
  EXPECT_EQ(lack(1u << 20), "");
  write("list", "0::/g\nwithout colons\n:\n4:memory:\n");
  EXPECT_EQ(lack(1u << 20), "");
  write("g/memory.max", "");
  write("g/memory.current", "not a number");
  EXPECT_EQ(lack(1u << 20), "");
  group_v2("g", bytes(10), 20);  // the limit was lowered later
  EXPECT_EQ(lack(1), sentence("1 MiB", "0 MiB", "10 MiB"));
  EXPECT_EQ(lack(0), "");
}

}  // namespace
}  // namespace ryosen
