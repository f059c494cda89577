#pragma once
/// How likely the observed figures are for values of the unknowns.
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "study/calibrate/calibration_study.hpp"
#include "study/calibrate/figure_scatter.hpp"
#include "study/calibrate/surrogate.hpp"

namespace clast::study_detail {

/// Figures of all members, and how they scatter.
struct MemberStatistics {
  Eigen::MatrixXd places;  ///< shares of the ranges, a column per member
  Eigen::MatrixXd values;  ///< figures by members
  std::vector<SiteStatistics> groups;
  std::vector<std::vector<StatisticScatter>> scatter;  ///< of each group, each member
};

/// @param simulated  outcomes of each site, each member
MemberStatistics compute_member_statistics(const CalibrationStudy& study, const std::vector<SiteDescription>& sites,
                             const std::vector<std::vector<std::vector<ReleaseOutcome>>>& simulated,
                             unsigned threads);

/// A normal synthetic likelihood of the observed figures: mean from the surrogates; variance of the
/// field's sample, of the choice of release points, and of the surrogate. Scatter is that of the
/// members near the answer, which is found in a few rounds.
/// @cite wood2010, kennedy2001
class SyntheticLikelihood {
 public:
  /// @throws InputError  a fitted figure that too few members have, named
  SyntheticLikelihood(const CalibrationStudy& study, const MemberStatistics& figures,
                      unsigned threads);

  /// Figures that have a surrogate, fitted or kept ones.
  std::vector<Eigen::Index> known(bool fitted) const;
  /// Of some figures by places: mean, and variance of the surrogate.
  struct Expected {
    Eigen::MatrixXd mean;
    Eigen::MatrixXd variance;
  };
  Expected expected(const Eigen::MatrixXd& places, const std::vector<Eigen::Index>& which) const;
  Eigen::VectorXd mean(std::size_t figure, const Eigen::MatrixXd& places) const;

  /// Logarithm of the likelihood of the fitted figures at places.
  Eigen::VectorXd log_likelihood(const Eigen::MatrixXd& places) const;
  /// Squared distance of the observed figures from the expected ones in units of their covariance.
  /// @param fitted  of the fitted ones; else of the kept ones
  Eigen::VectorXd squared_distance(const Eigen::MatrixXd& places, bool fitted) const;

  /// Covariance of some figures without the surrogate's part.
  Eigen::MatrixXd scatter(const std::vector<Eigen::Index>& which) const;
  Eigen::VectorXd observed(const std::vector<Eigen::Index>& which) const;
  /// None where too few members have the figure for a surrogate.
  std::optional<SurrogateQuality> quality(std::size_t figure) const {
    if (!surrogates_[figure]) return std::nullopt;
    return surrogates_[figure]->quality;
  }

 private:
  void estimate_scatter(const MemberStatistics& figures);
  void pool_scatter(const MemberStatistics& figures, const Eigen::VectorXd& weights);

  unsigned threads_;
  std::vector<std::optional<Surrogate>> surrogates_;
  std::vector<bool> fitted_;
  Eigen::VectorXd observed_;
  Eigen::MatrixXd scatter_;
};

}  // namespace clast::study_detail
