#include "ranks/rank_failure.hpp"

#include "ranks/messages.hpp"

#include <array>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <scree/error.hpp>

namespace scree {

namespace {

// A failure as messages have it: kind, exit status, then what is said in three texts, each ended by 0.
enum class Kind : char { none, error, memory, other };

std::vector<char> packed(Kind kind, ExitStatus status, const std::array<std::string, 3>& texts) {
  std::vector<char> message = {char(kind), char(status)};
  for (const std::string& text : texts) {
    message.insert(message.end(), text.begin(), text.end());
    message.push_back('\0');
  }
  return message;
}

std::vector<char> message_of(const std::exception_ptr& failure) {
  if (!failure) return packed(Kind::none, ExitStatus::success, {});
  try {
    std::rethrow_exception(failure);
  } catch (const Error& error) {
    return packed(Kind::error, error.status(), {error.place(), error.problem(), error.cure()});
  } catch (const std::bad_alloc&) {
    return packed(Kind::memory, ExitStatus::failure, {});
  } catch (const std::exception& exception) {
    return packed(Kind::other, ExitStatus::failure, {exception.what()});
  } catch (...) {
    return packed(Kind::other, ExitStatus::failure, {"of unknown type"});
  }
}

[[noreturn]] void throw_message(const std::vector<char>& message) {
  std::array<std::string, 3> texts;
  const char* next = message.data() + 2;
  for (std::string& text : texts) {
    text = next;
    next += text.size() + 1;
  }
  if (Kind(message[0]) == Kind::memory) throw std::bad_alloc();
  if (Kind(message[0]) == Kind::error)
    throw Error(texts[0], texts[1], texts[2], ExitStatus(std::uint8_t(message[1])));
  throw std::runtime_error(texts[0]);
}

}  // namespace

void RankFailure::keep(std::exception_ptr error) {
  const std::lock_guard lock(*mutex_);
  if (!error_) error_ = std::move(error);
}

void RankFailure::throw_on_all(Ranks& ranks) {
  const std::exception_ptr own = std::exchange(error_, nullptr);
  std::vector<std::vector<char>> to_first(ranks.size());
  to_first[0] = message_of(own);
  const std::vector<std::vector<char>> messages = exchange_items(ranks, to_first);
  if (ranks.rank() > 0) throw SharedFailure("a rank has failed");
  for (const std::vector<char>& message : messages)
    if (Kind(message[0]) != Kind::none) throw_message(message);
  throw std::logic_error("no rank has failed");
}

}  // namespace scree
