// A law that does, where it is asked for a force, what ends or holds the program.

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <numbers>
#include <stdexcept>
#include <unistd.h>

#include <scree/plugin/contact_law.hpp>

namespace {

enum Deed { throws, throws_number, crashes, aborts, exits, exits_at_once, loops, crashes_when_configured };

struct Hostile : scree::ContactLaw {
  int deed = throws;

  static constexpr scree::About about = {"hostile", "ends or holds the program", "f = 0", "—"};
  void declare(scree::Declaration& d) {
    d.choice("deed", deed,
             "throws|throws_number|crashes|aborts|exits|exits_at_once|loops|crashes_when_configured",
             "what it does");
  }
  void prepare(const scree::Setup&) {
    if (deed == crashes_when_configured) std::raise(SIGSEGV);
  }
  std::uint32_t closed_forms(const scree_encounter& e, scree_closed_form* forms, std::uint32_t) const {
    forms[0] = {"contact_time", "s", "t_c", std::numbers::pi * std::sqrt(e.reduced_mass / 5000)};
    return 1;
  }
  void act() const {
    if (deed == throws) throw std::runtime_error("boo");
    if (deed == throws_number) throw 42;
    if (deed == crashes) std::raise(SIGSEGV);
    if (deed == aborts) std::abort();
    if (deed == exits) std::exit(0);
    if (deed == exits_at_once) _exit(0);
    while (deed == loops) pause();
  }
};

struct Kernel : Hostile {
  template <int D, class T>
  using History = scree::NoHistory<D, T>;
  template <int D, class T>
  void force(const scree::Contact<D, T, reads>&, History<D, T>&, scree::LawOutput<D, T>&) const {
    act();
  }
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(Hostile, Kernel)
