#include "exchange.hpp"

#include <utility>

namespace carom::page {
namespace {

std::string the_input;
std::string the_text;
std::vector<double> the_numbers;

}  // namespace

std::string_view input() noexcept { return the_input; }

void answer(std::string text) noexcept { the_text = std::move(text); }

double* answer_numbers(std::vector<double> numbers) noexcept {
  the_numbers = std::move(numbers);
  return the_numbers.data();
}

}  // namespace carom::page

/// Room for so many bytes of text, which the page then writes there.
CAROM_EXPORT char* carom_input(std::size_t size) {
  carom::page::the_input.assign(size, ' ');
  return carom::page::the_input.data();
}

CAROM_EXPORT const char* carom_text() { return carom::page::the_text.data(); }
CAROM_EXPORT std::size_t carom_text_size() { return carom::page::the_text.size(); }
