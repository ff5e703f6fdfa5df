/* SPDX-License-Identifier: Apache-2.0
 * exp, log and pow of toothseg.dll: the one with fused multiplications where the processor has them. glibc, which has
 * the same algorithms, chooses by the same two properties: one machine gives the same bytes under Linux and under
 * Windows. */

double exp_fused(double), log_fused(double), pow_fused(double, double);
double exp_plain(double), log_plain(double), pow_plain(double, double);
double exp(double), log(double), pow(double, double);

static int fused(void) {
  return __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx2");
}

double exp(double x) {
  return fused() ? exp_fused(x) : exp_plain(x);
}
double log(double x) {
  return fused() ? log_fused(x) : log_plain(x);
}
double pow(double x, double y) {
  return fused() ? pow_fused(x, y) : pow_plain(x, y);
}
