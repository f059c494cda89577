#include "core/statistics/sobol_sequence.hpp"

#include <array>
#include <bit>
#include <string>

#include "core/error.hpp"
#include "core/random.hpp"

namespace clast {
namespace {

/// A primitive polynomial x^degree + ... + 1 and the first direction numbers that go with it.
struct Polynomial {
  std::uint32_t degree;
  std::uint32_t inner;  ///< its coefficients between the first and the last, as bits
  std::array<std::uint32_t, 7> first;
};

/// Direction numbers from the second dimension on (Joe and Kuo, 2008).
constexpr std::array<Polynomial, kMaxSobolDimensions - 1> kPolynomials{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
}};

/// Direction numbers of a dimension, from 0, as whole numbers of 2^-bits.
std::vector<std::uint64_t> direction_numbers(std::size_t dimension, std::size_t bits) {
  std::vector<std::uint64_t> numbers(bits);
  if (dimension == 0) {
    for (std::size_t i = 0; i < bits; ++i) numbers[i] = std::uint64_t{1} << (bits - 1 - i);
    return numbers;
  }
  const Polynomial& polynomial = kPolynomials[dimension - 1];
  const std::uint32_t degree = polynomial.degree;
  for (std::size_t i = 0; i < bits; ++i) {
    if (i < degree) {
      numbers[i] = std::uint64_t{polynomial.first[i]} << (bits - 1 - i);
      continue;
    }
    numbers[i] = numbers[i - degree] ^ (numbers[i - degree] >> degree);
    for (std::uint32_t k = 1; k < degree; ++k) {
      if ((polynomial.inner >> (degree - 1 - k)) & 1) numbers[i] ^= numbers[i - k];
    }
  }
  return numbers;
}

/// Multiplies the binary digits of each number by a random lower triangular matrix with ones on
/// its diagonal, the same for all.
void multiply_digits(std::vector<std::uint64_t>& numbers, std::size_t bits, Random& random) {
  std::vector<std::uint64_t> rows(bits);  // row r: which digits make digit r, the first on top
  for (std::size_t r = 0; r < bits; ++r) {
    const std::uint64_t above = r == 0 ? 0 : random.next_bits() >> (64 - r);
    rows[r] = ((above << 1 | 1) << (bits - 1 - r));
  }
  for (std::uint64_t& number : numbers) {
    std::uint64_t product = 0;
    for (std::size_t r = 0; r < bits; ++r) {
      const auto digit = static_cast<std::uint64_t>(std::popcount(rows[r] & number) & 1);
      product |= digit << (bits - 1 - r);
    }
    number = product;
  }
}

void check_dimensions(std::size_t dimensions) {
  if (dimensions >= 1 && dimensions <= kMaxSobolDimensions) return;
  throw InputError("a Sobol sequence of " + std::to_string(dimensions) +
                   " dimensions: must be from 1 to " + std::to_string(kMaxSobolDimensions));
}

}  // namespace

SobolSequence::SobolSequence(std::size_t dimensions) : point_(dimensions, 0) {
  check_dimensions(dimensions);
  for (std::size_t d = 0; d < dimensions; ++d) {
    const std::vector<std::uint64_t> numbers = direction_numbers(d, kBits);
    directions_.insert(directions_.end(), numbers.begin(), numbers.end());
  }
}

SobolSequence::SobolSequence(std::size_t dimensions, std::uint64_t seed) : point_(dimensions, 0) {
  check_dimensions(dimensions);
  Random seeds(seed);
  for (std::size_t d = 0; d < dimensions; ++d) {
    Random random(seeds.next_bits());
    std::vector<std::uint64_t> numbers = direction_numbers(d, kBits);
    multiply_digits(numbers, kBits, random);
    directions_.insert(directions_.end(), numbers.begin(), numbers.end());
    point_[d] = random.next_bits() >> (64 - kBits);
  }
}

std::vector<double> SobolSequence::next_point() {
  std::vector<double> coordinates;
  for (const std::uint64_t digits : point_) {
    coordinates.push_back(static_cast<double>(digits) * 0x1.0p-52);
  }
  // In Gray code order, consecutive points differ by one direction number.
  const auto changed = static_cast<std::size_t>(std::countr_one(count_++)) % kBits;
  for (std::size_t d = 0; d < point_.size(); ++d) point_[d] ^= directions_[d * kBits + changed];
  return coordinates;
}

}  // namespace clast
