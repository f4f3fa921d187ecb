#include "ranks/rank_commands.hpp"

#include <span>

namespace scree {

namespace {

// What comes before the lines.
struct Header {
  RankCommand command;
  std::uint64_t length;  // of the text (bytes)
};

void broadcast(Ranks& ranks, Header& header) {
  ranks.broadcast(std::as_writable_bytes(std::span(&header, 1)));
}

void broadcast(Ranks& ranks, std::string& text) {
  if (!text.empty()) ranks.broadcast(std::as_writable_bytes(std::span(text)));
}

}  // namespace

void send_command(Ranks& ranks, RankCommand command, const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  Header header = {command, text.size()};
  broadcast(ranks, header);
  broadcast(ranks, text);
}

ReceivedCommand receive_command(Ranks& ranks) {
  Header header = {};
  broadcast(ranks, header);
  std::string text(header.length, '\0');
  broadcast(ranks, text);
  ReceivedCommand received = {header.command, {}};
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin);
    received.lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return received;
}

}  // namespace scree
