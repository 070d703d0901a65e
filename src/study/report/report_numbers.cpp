#include "study/report/report_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pedzone::study {
namespace {

constexpr int kMostDecimals = 6;
constexpr int kDigits = 2;       // of an uncertainty
constexpr int kValueDigits = 3;  // of a value whose uncertainty is not told
constexpr const char* kMinus = "\u2212";
constexpr const char* kDash = "\u2013";

/// Decimals that show `digits` significant digits of a value.
int decimals(double value, int digits) {
  if (!(value > 0.0) || !std::isfinite(value)) return 0;
  return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(value))), 0, kMostDecimals);
}

}  // namespace

int decimals_for(double uncertainty) { return decimals(uncertainty, kDigits); }

std::string number_text(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  const bool zero = text.find_first_not_of("0.") == std::string::npos;
  return std::signbit(value) && !zero ? kMinus + text : text;
}

std::string signed_text(double value, int decimals) {
  const std::string text = number_text(value, decimals);
  return value > 0.0 && text.find_first_not_of("0.") != std::string::npos ? '+' + text : text;
}

std::string with_unit(const std::string& number, std::string_view unit) {
  return unit.empty() ? number : fmt::format("{} {}", number, unit);
}

std::string digits_text(const std::optional<double>& value) {
  if (!value) return kDash;
  return number_text(*value, decimals(std::abs(*value), kValueDigits));
}

std::string mean_text(const SampleSummary& sample, int decimals) {
  return sample.mean ? number_text(*sample.mean, decimals) : digits_text({});
}

std::string count_text(std::size_t count, std::string_view one, std::string_view more) {
  return fmt::format("{} {}", count, count == 1 ? one : more);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

int decimals_of(const Comparison& comparison) {
  const PairedDifference& difference = comparison.difference;
  if (difference.student && !difference.all_equal) {
    return decimals_for((difference.student->high - difference.student->low) / 2.0);
  }
  const double size =
      std::max(std::abs(difference.mean), std::abs(comparison.reference.mean.value_or(0.0)));
  return decimals(size, kValueDigits);
}

std::optional<double> percent_of(const Comparison& comparison) {
  constexpr double kPercent = 100.0;
  // Of a mean below 0 there are no percents, and nothing falls by more than all of it.
  if (!comparison.relative || comparison.reference.mean.value_or(0.0) < 0.0) return {};
  if (*comparison.relative < -1.0) return {};
  return kPercent * *comparison.relative;
}

std::string percent_text(double percent) {
  constexpr double kSmall = 9.95;  // what is rounded to 10
  const double size = std::abs(percent);
  const bool nearly_all = size >= 99.0 && size < 99.95;  // "100 %" would be all
  return fmt::format("{:.{}f} %", size, size < kSmall || nearly_all ? 1 : 0);
}

std::string signed_percent(double percent) {
  const std::string text = percent_text(percent);
  if (text == "0.0 %") return text;
  return (percent < 0.0 ? kMinus : "+") + text;
}

}  // namespace pedzone::study
