#pragma once
/// Distribution functions of test statistics.
namespace clast {

/// Returns P(X <= z) of the standard normal distribution.
double normal_cdf(double z);
/// Returns the quantile of the standard normal distribution.
/// @param p  in (0, 1)
double normal_quantile(double p);

/// Returns P(X > x) of the chi-squared distribution.
/// @param x  finite, not negative
/// @param degrees_of_freedom  positive
/// @cite dlmf
double chi_squared_upper_tail(double x, double degrees_of_freedom);

/// Returns P(|T| > |t|) of Student's t distribution.
/// @cite dlmf
double student_two_sided_tail(double t, double degrees_of_freedom);
/// Returns the quantile of Student's t distribution.
/// @param p  in (0, 1)
double student_quantile(double p, double degrees_of_freedom);
/// Returns P(T > t) of the non-central t distribution with the given non-centrality.
double noncentral_student_upper_tail(double t, double degrees_of_freedom, double noncentrality);

/// Returns P(K > x) of Kolmogorov's limit distribution of sqrt(n) D.
/// @cite kolmogorov1933
double kolmogorov_upper_tail(double x);

}  // namespace clast
