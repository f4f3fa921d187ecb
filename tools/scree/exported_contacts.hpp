#pragma once

#include <filesystem>

#include <scree/packing/contact_table.hpp>
#include <scree/plugin_host.hpp>

namespace scree::tool {

// The contacts of a state, of the last state of a run, or of one particles_*.vtp with the contacts_*.vtp
// beside it. Throws Error if there are none to be had.
packing::ContactTable contacts_in(const std::filesystem::path& source, PluginHost& host);

}  // namespace scree::tool
