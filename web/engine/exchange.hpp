// How the page and the engine hand things to each other: numbers as arrays in the engine's memory, text as UTF-8.
#pragma once

#include <emscripten.h>

#include <exception>
#include <string>
#include <string_view>
#include <vector>

/// Seen by the page under its own name.
#define CAROM_EXPORT extern "C" EMSCRIPTEN_KEEPALIVE

namespace carom::page {

/// What the page wrote into the buffer it got from carom_input(); valid until it asks for the next.
std::string_view input() noexcept;

/// The text that carom_text() and carom_text_size() give the page; valid until the next one.
void answer(std::string text) noexcept;

/// Numbers whose address is handed to the page; valid until the next call that answers in numbers.
double* answer_numbers(std::vector<double> numbers) noexcept;

/// Does what the page asked for. What is thrown becomes the text, one line per problem, and `failed` the result.
template <class Result, class Work>
Result guarded(Result failed, Work&& work) noexcept {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    answer(std::string("out of memory"));
  } catch (const std::exception& error) {
    answer(std::string(error.what()));
  }
  return failed;
}

}  // namespace carom::page
