#include "study/uncertain.hpp"

#include <cmath>

namespace clast {
namespace {

double drawn_once(const Uncertain& number, Random& random) {
  switch (number.law) {
    case Uncertain::Law::kFixed:
      return number.first;
    case Uncertain::Law::kUniform:
      return random.uniform(number.first, number.second);
    case Uncertain::Law::kNormal:
      return number.first + number.second * random.normal();
    case Uncertain::Law::kLogNormal:
      return number.first * std::exp(number.second * random.normal());
  }
  return number.first;
}

}  // namespace

double Uncertain::central() const { return law == Law::kUniform ? 0.5 * (first + second) : first; }

double Uncertain::draw(Random& random) const {
  // Mean and median lie inside the range, so about every second draw does at worst.
  while (true) {
    const double value = drawn_once(*this, random);
    if (fixed() || (value > low && value <= high)) return value;
  }
}

}  // namespace clast
