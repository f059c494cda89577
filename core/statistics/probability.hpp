#pragma once
/// Tail probabilities of the distributions that tests are judged by.
namespace clast {

/// P(X <= z) of the standard normal.
double normal_cdf(double z);
/// The z that a standard normal is below with probability `p`.
/// @param p  in (0, 1)
double normal_quantile(double p);

/// P(X > x) of chi-squared: the regularised upper incomplete gamma function Q(freedom/2, x/2).
/// @param x        finite, not negative
/// @param freedom  degrees of freedom, positive
/// @cite dlmf
double chi_squared_upper_tail(double x, double degrees_of_freedom);

/// P(|T| > |t|) of Student's t: the regularised incomplete beta function
/// I_x(freedom/2, 1/2) at x = freedom/(freedom + t^2).
/// @cite dlmf
double student_two_sided_tail(double t, double degrees_of_freedom);
/// The t that Student's t is below with probability `p`.
/// @param p  in (0, 1)
double student_quantile(double p, double degrees_of_freedom);
/// P(T > t) of the non-central t, whose normal number has the mean `centre`.
double noncentral_student_upper_tail(double t, double degrees_of_freedom, double centre);

/// P(K > x) of Kolmogorov's limit distribution of sqrt(n) D.
/// @cite kolmogorov1933
double kolmogorov_upper_tail(double x);

}  // namespace clast
