#pragma once
/// Two-sample test of clustered values.
#include <cstdint>
#include <optional>

#include "core/statistics/bootstrap.hpp"
#include "core/statistics/sample_tests.hpp"

namespace clast {

/// Two-sample Kolmogorov-Smirnov test of clustered values, with a p-value from random permutations.
/// Values of a cluster in both samples are permuted within the cluster. A cluster in one sample is
/// assigned to either as a whole. p = (1 + number of permutations with at least the observed
/// distance D)/(1 + draws). If there is only one cluster, p is that of `two_sample_ks_test`. The
/// same holds if that p is smaller, no permutation reaches D, and all clusters are in both samples.
/// @param cluster_count  number of clusters
/// @param draws  number of random permutations, positive
/// @return D and p; empty if a sample is empty
/// @cite smirnov1939, phipson2010
std::optional<TestResult> clustered_ks_test(const ClusteredValues& a, const ClusteredValues& b,
                                            std::size_t cluster_count, std::uint64_t seed,
                                            std::size_t draws = 9999);

}  // namespace clast
