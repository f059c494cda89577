#pragma once
/// Which of many numbers are wanted, listed without a branch for each: what is due next is as good
/// as random to the processor, and a wrong guess costs more than a needless store.
#include <cstddef>
#include <cstdint>
#include <vector>

namespace clast::dem_detail {

class NumberList {
 public:
  /// @param most  no more numbers are offered until the next call
  void clear(std::uint32_t most) {
    if (numbers_.size() <= most) numbers_.resize(most + 1);
    count_ = 0;
  }
  void add_if(bool wanted, std::uint32_t number) {
    numbers_[count_] = number;
    count_ += wanted ? 1 : 0;
  }

  /// Lists those before `end` that are wanted.
  template <class Wanted>
  void list(std::uint32_t end, const Wanted& wanted) {
    clear(end);
    std::uint32_t* const to = numbers_.data();
    std::size_t count = 0;
    for (std::uint32_t number = 0; number < end; ++number) {
      to[count] = number;
      count += wanted(number) ? 1 : 0;
    }
    count_ = count;
  }

  std::size_t size() const { return count_; }
  std::uint32_t operator[](std::size_t i) const { return numbers_[i]; }
  const std::uint32_t* begin() const { return numbers_.data(); }
  const std::uint32_t* end() const { return numbers_.data() + count_; }

 private:
  std::vector<std::uint32_t> numbers_;  ///< one more than can be wanted
  std::size_t count_ = 0;
};

}  // namespace clast::dem_detail
