// A law that ends the program without a word, with the status of success: in a force, or where the library is
// unloaded. Or that holds it, or ends it by the system call itself, once the file exists that the environment
// names.

#include <cstdlib>
#include <sys/syscall.h>
#include <unistd.h>

#include <scree/plugin/contact_law.hpp>

namespace {

struct Ending {
  bool armed = false;
  ~Ending() {
    if (armed) _exit(0);
  }
} ending;

enum Where { in_force, unloading, holding, system_call };

struct EndsRun : scree::ContactLaw {
  int where = 0;
  static constexpr scree::About about = {"ends_run", "ends the program", "f = 0", "—"};
  void declare(scree::Declaration& d) {
    d.choice("where", where, "force|unloading|holding|system_call", "where it does");
  }
  void prepare(const scree::Setup&) { ending.armed = where == unloading; }
  std::uint32_t closed_forms(const scree_encounter&, scree_closed_form*, std::uint32_t) const { return 0; }
};

struct Kernel : EndsRun {
  template <int D, class T>
  using History = scree::NoHistory<D, T>;
  template <int D, class T>
  void force(const scree::Contact<D, T, reads>&, History<D, T>&, scree::LawOutput<D, T>&) const {
    if (where == in_force) _exit(0);
    const char* file = std::getenv("SCREE_TEST_ENDS_AT");
    if (!file || access(file, F_OK) != 0) return;
    while (where == holding) pause();
    if (where == system_call) syscall(SYS_exit_group, 0);
  }
};

}  // namespace

SCREE_CONTACT_LAW_PLUGIN(EndsRun, Kernel)
