#pragma once

#include "contacts/contacts.hpp"
#include "ranks/rank_share.hpp"

namespace scree {

class StateHash;

// Adds what laws keep of pairs to a hash, in scene order. share: ranks that have the pairs together, of which
// the first gets the hash; null if these are all pairs.
void add_histories(StateHash& hash, const Contacts& contacts, const BodyOrder& order, RankShare* share);

}  // namespace scree
