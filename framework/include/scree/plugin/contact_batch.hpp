#pragma once

#include <type_traits>

#include <scree/plugin/abi.h>

namespace scree {

// The batch of contacts that is passed to a law, in double or in float.
template <class T>
using ContactBatch =
    std::conditional_t<std::is_same_v<T, float>, scree_contact_batch_single, scree_contact_batch>;

}  // namespace scree
