#pragma once
/// Do two samples differ whose values come in clusters?
#include <cstdint>
#include <optional>

#include "core/statistics/bootstrap.hpp"
#include "core/statistics/sample_tests.hpp"

namespace clast {

/// The largest distance D of the cumulative shares, with p from random deals that leave clusters as
/// they are: of a cluster that both samples share, its values are dealt anew to the two, as many to
/// each as before; a cluster that only one sample has goes to one of them as a whole. Under the
/// null hypothesis that what a value belongs to makes no difference in any cluster, every such deal
/// is as likely as the one found. p is (1 + deals with at least D)/(1 + draws), or the smaller p of
/// two_sample_ks_test where no deal reaches D and all clusters are shared, of which that test is the
/// careful side. With one cluster it is two_sample_ks_test.
/// @param clusters  how many there are
/// @param draws     positive
/// @return none when either sample is empty
/// @cite smirnov1939, phipson2010
std::optional<TestResult> clustered_ks_test(const ClusteredValues& a, const ClusteredValues& b,
                                       std::size_t clusters, std::uint64_t seed,
                                       std::size_t draws = 9999);

}  // namespace clast
