// One impact from the command line: key=value words in, a line of key=value results out.

#include "impact.hpp"

#include <cstdio>
#include <iostream>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

namespace {

using namespace reference;

const char* const help = R"(reference_impact key=value...: the continuous contact laws, one impact.

law=linear     k=, kt=, gammat=0, slip=spring|total, and e= or gamma=0
law=hertz      E=, nu=, E_b=, nu_b= (as of a), e=1, history=rescaled|displacement|potential
both           tension=cut|allowed  mu=0 (or inf)  mud= (of what slides, as mu)
body a         dimension=3  radius=  density= or mass=  speed=1 angle=0 (degrees from the normal) or velocity=x,y,z
               spin=x,y,z  position=x,y,z
wall           (default) below the body, y up in two dimensions and z in three; normal=x,y,z point=x,y,z
body           below it: radius_b= (as of a), density_b= or mass_b=, velocity_b=, spin_b=, position_b=
gap=0          between body a, where it is not placed, and the wall or body
tolerance=1e-11 relaxed_limit=1e-13
samples=n      further lines: the motion at n times that divide the contact evenly

The speed is along the first axis and towards the wall or body. Results: velocity, spin and position of a (and b) at
the end of the contact; impulses on a; energies. Example:
  reference_impact law=hertz E=7e10 nu=0.3 e=0.5 tension=cut mu=0.3 history=rescaled radius=0.005 density=2500 \
    speed=1 angle=75 spin=0,100,0 wall
)";

class Words {
 public:
  Words(int count, char** words) {
    for (int i = 1; i < count; ++i) {
      const std::string word = words[i];
      const auto equals = word.find('=');
      values_[word.substr(0, equals)] = equals == std::string::npos ? "" : word.substr(equals + 1);
    }
  }
  bool has(const std::string& key) const { return values_.count(key) > 0; }
  std::string text(const std::string& key, const std::string& otherwise) {
    asked_[key] = true;
    const auto found = values_.find(key);
    return found == values_.end() ? otherwise : found->second;
  }
  double number(const std::string& key, double otherwise) {
    const std::string value = text(key, "");
    return has(key) ? std::stod(value) : otherwise;
  }
  Vector vector(const std::string& key, const Vector& otherwise) {
    const std::string value = text(key, "");
    if (!has(key)) return otherwise;
    Vector v;
    if (std::sscanf(value.c_str(), "%lf,%lf,%lf", &v.x, &v.y, &v.z) != 3)
      throw std::invalid_argument(key + ": x,y,z");
    return v;
  }
  template <class Choice>
  Choice choice(const std::string& key, const std::map<std::string, Choice>& choices, Choice otherwise) {
    const std::string value = text(key, "");
    if (!has(key)) return otherwise;
    const auto found = choices.find(value);
    if (found == choices.end()) throw std::invalid_argument(key + "=" + value + "?");
    return found->second;
  }
  void check_all_asked() const {
    for (const auto& [key, value] : values_)
      if (!asked_.count(key)) throw std::invalid_argument("what is " + key + "? See --help");
  }

 private:
  std::map<std::string, std::string> values_;
  std::map<std::string, bool> asked_;
};

Law law_of(Words& words) {
  Law law;
  law.kind = words.choice<LawKind>("law", {{"linear", LawKind::linear}, {"hertz", LawKind::hertz}}, law.kind);
  law.tension =
      words.choice<Tension>("tension", {{"allowed", Tension::allowed}, {"cut", Tension::cut}}, law.tension);
  law.friction = words.number("mu", 0);
  if (words.has("mud")) law.dynamic_friction = words.number("mud", 0);
  if (words.has("e")) law.restitution = words.number("e", 1);
  if (law.kind == LawKind::linear) {
    law.normal_stiffness = words.number("k", 0);
    law.normal_damping = words.number("gamma", 0);
    law.tangential_stiffness = words.number("kt", 0);
    law.tangential_damping = words.number("gammat", 0);
    law.slip_rule = words.choice<SlipRule>("slip", {{"spring", SlipRule::spring}, {"total", SlipRule::total}},
                                           law.slip_rule);
    return law;
  }
  law.youngs_modulus = words.number("E", 0);
  law.poissons_ratio = words.number("nu", 0);
  law.other_youngs_modulus = words.number("E_b", law.youngs_modulus);
  law.other_poissons_ratio = words.number("nu_b", law.poissons_ratio);
  law.history = words.choice<History>("history",
                                      {{"displacement", History::displacement},
                                       {"rescaled", History::rescaled},
                                       {"potential", History::potential}},
                                      law.history);
  return law;
}

double mass_of(Words& words, const std::string& suffix, const Body& body) {
  constexpr double pi = std::numbers::pi;
  const double size = body.radius * body.radius * pi * (body.dimension == 2 ? 1 : 4.0 / 3 * body.radius);
  return words.number("mass" + suffix, size * words.number("density" + suffix, 0));
}

Impact impact_of(Words& words) {
  Impact impact;
  impact.law = law_of(words);
  impact.relaxed_limit = words.number("relaxed_limit", impact.relaxed_limit);
  Body& a = impact.a;
  a.dimension = static_cast<int>(words.number("dimension", 3));
  const Vector up = a.dimension == 2 ? Vector{0, 1, 0} : Vector{0, 0, 1};
  a.radius = words.number("radius", 0);
  a.mass = mass_of(words, "", a);
  const double angle = words.number("angle", 0) * std::numbers::pi / 180, speed = words.number("speed", 1);
  a.velocity = words.vector("velocity", speed * (Vector{std::sin(angle), 0, 0} - std::cos(angle) * up));
  a.spin = words.vector("spin", {});
  const double gap = words.number("gap", 0);
  words.text("wall", "");
  words.text("body", "");
  if (!words.has("body")) {
    const Wall wall{words.vector("point", {}), words.vector("normal", up)};
    a.position = words.vector("position", wall.point + (a.radius + gap) * direction(wall.normal));
    impact.other = wall;
    return impact;
  }
  Body b = a;
  b.radius = words.number("radius_b", a.radius);
  b.mass = words.has("mass_b") || words.has("density_b") ? mass_of(words, "_b", b) : a.mass;
  b.position = words.vector("position_b", {});
  b.velocity = words.vector("velocity_b", {});
  b.spin = words.vector("spin_b", {});
  a.position = words.vector("position", b.position + (a.radius + b.radius + gap) * up);
  impact.other = b;
  return impact;
}

std::string text(const Vector& v) {
  std::ostringstream out;
  out.precision(15);
  out << v.x << ',' << v.y << ',' << v.z;
  return out.str();
}

void print(const Outcome& o) {
  std::cout.precision(15);
  std::cout << "touched=" << o.touched << " velocity=" << text(o.a.velocity) << " spin=" << text(o.a.spin)
            << " position=" << text(o.a.position);
  if (const Body* b = std::get_if<Body>(&o.other))
    std::cout << " velocity_b=" << text(b->velocity) << " spin_b=" << text(b->spin)
              << " position_b=" << text(b->position);
  std::cout << " first_touch=" << o.first_touch << " contact_time=" << o.contact_time
            << " pushing_time=" << o.pushing_time << " largest_overlap=" << o.largest_overlap
            << " normal_impulse=" << o.normal_impulse << " tangential_impulse=" << text(o.tangential_impulse)
            << " dissipated_normal=" << o.dissipated.normal
            << " dissipated_tangential=" << o.dissipated.tangential
            << " dissipated_friction=" << o.dissipated.friction
            << " dissipated_release=" << o.dissipated.release << " created=" << o.created
            << " remaining_elastic=" << o.remaining_elastic << " slides=" << o.slides
            << " switches=" << o.switches << " energy_residual=" << o.energy_residual << " steps=" << o.steps
            << '\n';
  for (const Sample& s : o.samples) {
    std::cout << "time=" << s.time << " overlap=" << s.overlap << " velocity=" << text(s.a.velocity)
              << " spin=" << text(s.a.spin) << " position=" << text(s.a.position)
              << " spring=" << text(s.spring) << " force=" << text(s.force) << " sliding=" << s.sliding
              << '\n';
  }
}

void run(Words& words) {
  Impact impact = impact_of(words);
  const double tolerance = words.number("tolerance", 1e-11);
  const int samples = static_cast<int>(words.number("samples", 0));
  words.check_all_asked();
  Outcome outcome = integrate(impact, tolerance);
  for (int i = 0; i < samples; ++i)
    impact.sample_times.push_back(outcome.first_touch + outcome.contact_time * i / std::max(samples - 1, 1));
  if (samples > 0) outcome = integrate(impact, tolerance);
  print(outcome);
}

}  // namespace

int main(int count, char** words) try {
  Words given(count, words);
  if (count < 2 || given.has("--help") || given.has("help")) {
    std::cout << help;
    return 0;
  }
  run(given);
} catch (const std::exception& error) {
  std::cerr << "reference_impact: " << error.what() << '\n';
  return 1;
}
