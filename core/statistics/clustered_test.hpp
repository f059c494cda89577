#pragma once
/// Two-sample test of clustered values.
#include <cstdint>
#include <optional>

#include "core/statistics/bootstrap.hpp"
#include "core/statistics/sample_tests.hpp"

namespace clast {

/// Kolmogorov-Smirnov test of two samples of clustered values, with a permutation p-value. Values
/// of clusters in both samples are permuted within the cluster. Other clusters are assigned as a
/// whole. If the samples do not differ within clusters, all such permutations are equally likely. p
/// = (1 + permutations with at least the observed distance D)/(1 + draws). If no permutation
/// reaches D and all clusters are in both samples, the p of `two_sample_ks_test` is used if it is
/// smaller; it is conservative here. It is also used if there is only one cluster.
/// @param cluster_count  number of clusters
/// @param draws  number of random permutations, positive
/// @return D and p; empty if a sample is empty
/// @cite smirnov1939, phipson2010
std::optional<TestResult> clustered_ks_test(const ClusteredValues& a, const ClusteredValues& b,
                                            std::size_t cluster_count, std::uint64_t seed,
                                            std::size_t draws = 9999);

}  // namespace clast
