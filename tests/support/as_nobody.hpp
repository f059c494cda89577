#pragma once
/// What a program may do that is not root's.
#include <gtest/gtest.h>
#include <unistd.h>

namespace clast {

/// Takes root's rights away while it lasts; of any other user nothing.
class AsNobody {
 public:
  AsNobody() : root_(::geteuid() == 0) {
    constexpr uid_t kNobody = 65534;
    if (!root_) return;
    EXPECT_EQ(::seteuid(kNobody), 0);
  }
  ~AsNobody() {
    if (!root_) return;
    EXPECT_EQ(::seteuid(0), 0);
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  bool root_;
};

}  // namespace clast
