#pragma once

#include "contacts/contacts.hpp"
#include "contacts/forces.hpp"

#include <cstddef>
#include <vector>

#include <scree/contact_list.hpp>
#include <scree/scene.hpp>

namespace scree {

// Springs that a scene gives its contacts at the start, by what became of them.
struct StartSprings {
  std::size_t placed = 0;
  std::size_t apart = 0;         // their bodies do not touch, or have no contact that the scene evaluates
  std::size_t without_room = 0;  // the law keeps no tangential spring, or keeps more than a spring
};

// Gives touching pairs their springs, without the components along the normal. A law has room for one if its
// history begins with spring_x, spring_y and, in three dimensions, spring_z.
StartSprings place_springs(const std::vector<Scene::Spring>& springs, const ContactList& touching,
                           const std::vector<LawInstance>& laws, int dimension, Contacts& contacts,
                           const BodyOrder& order);

}  // namespace scree
