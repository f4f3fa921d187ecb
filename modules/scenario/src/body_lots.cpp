#include "particles_keys.hpp"
#include "readers.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <unordered_set>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/plugin/abi.h>

namespace scree::scenario {

namespace {

[[noreturn]] void refuse_id(const BodyLot& lot, std::int64_t id) {
  if (lot.table.has(particles_keys.file))
    throw lot.table.error(particles_keys.file,
                          fmt::format("two bodies have the id {}, one of them in this file", id),
                          "set keep_ids = false to number the bodies of the file anew");
  throw lot.table.error(particle_keys.id, fmt::format("two bodies have the id {}", id),
                        "give every body a different id, or no id");
}

void refuse_shared_ids(const std::vector<BodyLot>& lots) {
  std::unordered_set<std::int64_t> used;
  for (const BodyLot& lot : lots)
    for (const Body& body : lot.bodies)
      if (body.id > 0 && !used.insert(body.id).second) refuse_id(lot, body.id);
}

std::vector<IdRange> ranges_of(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  std::vector<IdRange> ranges;
  for (const std::int64_t id : ids)
    if (!ranges.empty() && ranges.back().last + 1 == id)
      ranges.back().last = id;
    else
      ranges.push_back({id, id});
  return ranges;
}

std::string text_of(const std::vector<IdRange>& ids) {
  const IdRange all = {ids.front().first, ids.back().last};
  if (all.first == all.last) return fmt::format("id {}", all.first);
  return fmt::format("ids {} {} {}", all.first, ids.size() == 1 ? "to" : "...", all.last);
}

}  // namespace

std::size_t BodySource::count() const {
  std::size_t count = 0;
  for (const IdRange& range : ids) count += std::size_t(range.last - range.first + 1);
  return count;
}

std::string BodySource::text() const {
  std::string text = fmt::format("{}: {}", name, counted(count(), "body", "bodies"));
  if (!origin.empty()) text += " " + origin;
  return ids.empty() ? text : text + "; " + text_of(ids);
}

std::vector<BodyLot> body_lots(const document::Table& root) {
  UniqueNames names("particles");
  std::vector<BodyLot> lots;
  for (const char* key : {"particles", "particle"})
    for (const document::Table& table : root.tables(key)) {
      lots.push_back({table, table.string(particles_keys.name, ""), "", {}, {}});
      if (table.has(particles_keys.name)) names.add(table, lots.back().name);
    }
  // After the given names, so that none of them is in use.
  const std::size_t tables = root.tables("particles").size();
  std::string single;
  for (std::size_t k = 0; k < lots.size(); ++k) {
    if (!lots[k].name.empty()) continue;
    if (k < tables)
      lots[k].name = names.add_or_number(lots[k].table, "particles");
    else
      lots[k].name = single = single.empty() ? names.add_or_number(lots[k].table, "particle") : single;
  }
  return lots;
}

void number_bodies(const document::Table& root, std::vector<BodyLot>& lots, bool keep_all) {
  for (BodyLot& lot : lots)
    if (!lot.own_ids && !keep_all)
      for (Body& body : lot.bodies) body.id = 0;
  refuse_shared_ids(lots);
  std::int64_t last = 0;
  for (const BodyLot& lot : lots)
    for (const Body& body : lot.bodies) last = std::max(last, body.id);
  for (BodyLot& lot : lots)
    for (Body& body : lot.bodies) {
      if (body.id > 0) continue;
      if (last == SCREE_MAX_ID)
        throw root.error("no id is left for a body without one, because ids end at 1e15",
                         "give that body an id, or use smaller ones");
      body.id = ++last;
    }
}

std::vector<BodySource> sources_of(const std::vector<BodyLot>& lots) {
  std::vector<BodySource> sources;
  std::vector<std::vector<std::int64_t>> ids;
  std::map<std::string_view, std::size_t> places;
  for (const BodyLot& lot : lots) {
    const auto [place, is_new] = places.emplace(lot.name, sources.size());
    if (is_new) sources.push_back({lot.name, lot.origin, {}}), ids.emplace_back();
    for (const Body& body : lot.bodies) ids[place->second].push_back(body.id);
  }
  for (std::size_t k = 0; k < sources.size(); ++k) sources[k].ids = ranges_of(std::move(ids[k]));
  return sources;
}

}  // namespace scree::scenario
