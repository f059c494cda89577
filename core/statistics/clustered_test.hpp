#pragma once
/// Two-sample test of clustered values.
#include <cstdint>
#include <optional>

#include "core/statistics/bootstrap.hpp"
#include "core/statistics/sample_tests.hpp"

namespace clast {

/// Kolmogorov-Smirnov distance D of two samples of clustered values, with a permutation p-value:
/// the values of a cluster shared by both samples are permuted within it; a cluster of one sample
/// is assigned to either sample as a whole. If group membership has no effect within clusters, all
/// such permutations are equally likely. p is (1 + permutations with at least D)/(1 + draws), or
/// the smaller p of two_sample_ks_test, which is conservative here, if no permutation reaches D and
/// all clusters are shared. With one cluster it is two_sample_ks_test.
/// @param clusters  number of clusters
/// @param draws  positive
/// @return empty if a sample is empty
/// @cite smirnov1939, phipson2010
std::optional<TestResult> clustered_ks_test(const ClusteredValues& a, const ClusteredValues& b,
                                            std::size_t clusters, std::uint64_t seed,
                                            std::size_t draws = 9999);

}  // namespace clast
