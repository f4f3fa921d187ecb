#pragma once

#include "seal.hpp"

#include <string>

#include <scree/files/checksum.hpp>

namespace scree::test {

// The bytes of a state file with a seal that fits them, as anyone can write it.
inline std::string resealed(const std::string& bytes, state_file::Seal seal = {.program_version = "0"}) {
  seal.bytes = bytes.size();
  seal.checksum = 0;
  files::Checksum checksum;
  const std::string content = bytes.substr(state_file::Seal::size), text = seal.text();
  checksum.add(text.data(), text.size());
  checksum.add(content.data(), content.size());
  seal.checksum = checksum.value();
  return seal.text() + content;
}

}  // namespace scree::test
