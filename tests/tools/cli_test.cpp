#include "program.hpp"

#include <sstream>

using namespace scree::test;

TEST_CASE("the help of each verb shows an example and every option", "[tools]") {
  const Workspace w;
  for (const char* verb : {"run", "check", "describe", "render", "export", "fields", "campaign", "spectrum",
                           "cycles", "modes", "quasi-static"}) {
    const Outcome help = w.scree(std::string(verb) + " --help");
    CHECK(help.status == 0);
    CHECK(help.err.empty());
    CHECK(contains(help.out, std::string("Example: scree ") + verb + " "));
    CHECK(contains(w.scree("--help").out, std::string("\n  ") + verb + " "));
  }
  for (const char* option : {"--out", "--set", "--threads", "--overwrite", "--quiet", "--plugins"})
    CHECK(contains(w.scree("run --help").out, option));
  CHECK(w.scree("--version").out.starts_with("scree 0."));
  CHECK(contains(w.scree("--version").out, " (commit "));
}

TEST_CASE("check summarises a scene and writes nothing", "[tools]") {
  const Workspace w(with(discs, "[scene]", "[scene]\ntitle = 'Nine discs'"));
  const Outcome good = w.scree("check scene.toml --set time.duration=0.5");
  CHECK(good.status == 0);
  CHECK(good.out.starts_with("scene.toml: valid, Nine discs\n  9 bodies in 2D, 4 walls, 1 contact law, "));
  CHECK(contains(good.out, "  stage run: 0.5 s, 50000 steps\n"));
  CHECK_FALSE(w.has("runs"));
}

TEST_CASE("check tells how many bodies are fixed", "[tools]") {
  const Workspace w(std::string(discs) + "[[group]]\nname = 'bottom'\nwhere.y = [0, 0.02]\nfixed = true\n");
  CHECK(contains(w.scree("check scene.toml").out, "\n  9 bodies (3 fixed) in 2D, 4 walls, "));
}

TEST_CASE("check tells which points a chart leaves out at the start", "[tools]") {
  const Workspace w(
      std::string(discs) +
      "[[chart]]\nname = 'time'\nprobe = 'energy'\ny = 'kinetic_translation'\nlog_x = true\n"
      "[[chart]]\nname = 'work'\nprobe = 'energy'\ny = ['work', 'kinetic_translation', 'residual']\n"
      "log_y = true\n"
      "[[chart]]\nname = 'all'\nprobe = 'energy'\ny = 'kinetic_translation'\nlog_y = true\n");
  const Outcome checked = w.scree("check scene.toml");
  CHECK(
      contains(checked.out,
               "\n  chart time: at t = 0 s there is no logarithm of time, so that these points are left out\n"
               "  chart work: at t = 0 s there is no logarithm of work, residual, so that these points are "
               "left out\n"));
  CHECK_FALSE(contains(checked.out, "chart all"));
}

TEST_CASE("check tells the extent of the bodies, the wall time to expect, and numbers in other units",
          "[tools]") {
  const Workspace w(with(discs, "duration = 1e-4", "duration = 100"));
  const std::string told = w.scree("check scene.toml").out;
  CHECK_THAT(told, Catch::Contains("\n  bodies from (") && Catch::Contains(" m, radius 0.01 m\n"));
  // Ten million steps.
  CHECK_THAT(told, Catch::Contains(" of wall time without pictures, at ") &&
                       Catch::Contains(" M particle-steps/s, the speed of the first"));
  const Outcome light = w.scree("check scene.toml --set material.density=2.5");
  CHECK(light.status == 0);
  CHECK_THAT(light.err, Catch::Contains("has a density of 2.5 kg/m^3; glass has 2500 kg/m^3"));
  CHECK_THAT(w.scree("check scene.toml --set particles.radius=2").err,
             Catch::Contains("has a radius of 2 m; give lengths in m"));
}

TEST_CASE("check tells the largest overlap at the start, and warns of a large one", "[tools]") {
  const auto checked = [](const char* second) {
    return Workspace(
               with(discs,
                    "[particles]\nlattice = { kind = 'square', count = [3, 3], gap = 0.1 }\nradius = 0.01\n"
                    "random_velocity = 0.1\n",
                    "[[particle]]\nradius = 0.01\nposition = [0, 0]\n[[particle]]\nradius = 0.01\n"
                    "position = [" +
                        std::string(second) + ", 0]\n"))
        .scree("check scene.toml");
  };
  const Outcome small = checked("0.0199");
  CHECK(contains(small.out,
                 "  largest overlap at t = 0: 0.01 of the smaller radius, particle 1 and particle 2\n"));
  CHECK(small.err.empty());
  const Outcome large = checked("0.018");
  CHECK(large.status == 0);
  CHECK(large.err.starts_with(
      "scree: warning: particle 1 and particle 2 overlap by 0.2 of the smaller radius at t = 0"));
  CHECK_FALSE(contains(checked("0.021").out, "largest overlap"));
}

TEST_CASE("check finds the same errors as run", "[tools]") {
  const Workspace w;
  check_refused(w, w.scree("check scene.toml --set time.step=-1"),
                "--set time.step=-1: ", "give a step above 0");
  check_refused(w, w.scree("check scene.toml --set contact.normal_stiffness=1e14"),
                "scene.toml:4:8: the time step of 1e-05 s is too long: the contacts of law "
                "'linear_spring_dashpot' allow ",
                "time.step_guard = false to run it anyway");
  const Workspace walls(with(discs, "'energy'", "'particles'\nids = [99]"));
  check_refused(walls, walls.scree("check scene.toml"),
                "scene.toml:25:10: probe particles: a body with the id 99 does not exist; ",
                "numbered from 1, after the largest id given");
}

TEST_CASE("describe lists all plug-ins by kind", "[tools]") {
  const Outcome list = Workspace().scree("describe");
  CHECK(list.status == 0);
  for (const char* part :
       {"contact laws, [[contact]]\n  ", "\n  linear_spring_dashpot ", "boundaries, [[boundary]]\n  box ",
        "body forces, [[body_force]]\n", "\n  gravity ", "probes, [[probe]]\n  arrival "})
    CHECK(contains(list.out, part));
  CHECK_FALSE(contains(list.out, "cannot be used"));
}

TEST_CASE("describe prints equations, parameters and closed forms", "[tools]") {
  const Workspace w;
  const Outcome law = w.scree("describe linear_spring_dashpot");
  for (const char* part :
       {"\nequations\n  f_n = ", "\n  normal_stiffness       number above 0 (N/m); required\n",
        "\n  tension                one of allowed, cut; default allowed\n", "Give parameters as KEY=VALUE"})
    CHECK(contains(law.out, part));
  // Two equal spheres of 1 mm and 1000 kg/m³ with k = 100 N/m: t_c = π √(m/2k).
  const Outcome forms = w.scree(
      "describe linear_spring_dashpot normal_stiffness=100 normal_damping=0 --radius 1e-3 "
      "--density 1000");
  CHECK(contains(forms.out, "\n  contact_time     0.000454652 s  "));
  CHECK(contains(forms.out, "\n  restitution      1  "));
}

TEST_CASE("describe prints the columns of a probe with unit and meaning, those of a pattern once",
          "[tools]") {
  const Workspace w;
  const Outcome box = w.scree("describe probe/box");
  CHECK(contains(box.out, "\n  length_z [m]            3D only; distance between the walls\n"));
  CHECK(contains(box.out,
                 "\n  solid_fraction [1]      volume of the bodies with centres between the walls / "));
  CHECK(contains(w.scree("describe energy").out, "\n  residual [J]  "));
  const Outcome walls = w.scree("describe walls");
  CHECK(contains(walls.out, "\n  normal_force_<n> [N]      above 0 in compression\n"));
  CHECK_FALSE(contains(walls.out, "normal_force_1"));
  const Outcome contact = w.scree("describe probe/contact");
  CHECK(contains(contact.out, "\n  overlap_<n>_<n> [m] "));
  CHECK(contains(contact.out, "\n  overlap_<n>_wall<n> [m] "));
  CHECK(contains(w.scree("describe orientation").out, "\n  angle_<n> [rad]  2D only; since the start"));
  CHECK(contains(w.scree("describe lock_in").out, "\n  amplitude [unit of the column] "));
}

TEST_CASE("every column of every probe has a meaning", "[tools]") {
  const Outcome all = Workspace().scree("describe --all");
  std::istringstream lines(all.out);
  int columns = 0;
  bool in_table = false;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `"))
      in_table = line.starts_with("| column ") || (in_table && line.starts_with("|---"));
    if (!in_table || !line.starts_with("| `")) continue;
    ++columns;
    INFO(line);
    CHECK_FALSE(line.ends_with("|  |"));
    CHECK_FALSE(line.ends_with("; |"));
  }
  CHECK(columns > 100);
}

TEST_CASE("describe takes two dimensions for a law of discs", "[tools]") {
  const Workspace w;
  const std::string law =
      "describe disc_angular normal_stiffness=100 tangential_stiffness=100 friction=0.2 normal_damping=0";
  // m* of two discs of 5 mm and 2000 kg/m²: π R² ρ/2.
  CHECK(contains(w.scree(law).out, "two equal discs, R = 0.005 m, density 2000 kg/m^2 (m* = 0.0785398 kg, "));
  const Outcome wrong = w.scree(law + " --dimension 3");
  CHECK(wrong.status == 2);
  CHECK(contains(wrong.err, "disc_angular: a law of discs; "));
}

TEST_CASE("describe shows all plug-ins of a name, or the one of a kind", "[tools]") {
  const Workspace w;
  const Outcome both = w.scree("describe box"), one = w.scree("describe probe/box");
  CHECK(both.out.starts_with("box, boundary: "));
  CHECK(contains(both.out, "\nbox, probe: "));
  CHECK(one.out.starts_with("box, probe: "));
  CHECK_FALSE(contains(one.out, "boundary: "));
}

TEST_CASE("describe takes a file for a state, and a plug-in of its name for the plug-in", "[tools]") {
  const Workspace w;
  w.write("box", "x");
  check_refused(w, w.scree("describe none.h5"), "none.h5: there is no such file", "; check the path");
  check_refused(w, w.scree("describe scene.toml"), "scene.toml: is not a state file of scree",
                "; give one that scree has written");
  CHECK(contains(w.scree("describe box").out, "box, boundary: "));
}

TEST_CASE("HDF5 is loaded only to read or write a state", "[tools]") {
  const Workspace w;
  const Outcome check = w.shell("LD_DEBUG=files scree check scene.toml");
  CHECK(check.status == 0);
  CHECK(contains(check.err, "libfmt.so"));
  CHECK_FALSE(contains(check.err, "hdf5"));
}

TEST_CASE("describe refuses unknown names and options", "[tools]") {
  const Workspace w;
  const auto refused = [&](const std::string& arguments, const std::string& begin, const std::string& end) {
    check_refused(w, w.scree("describe " + arguments), begin, end);
  };
  refused("gravty", "no plug-in or table 'gravty'; ", "did you mean 'gravity'?");
  refused("linear_spring_dashpot normal_stifness=1",
          "'normal_stifness=1': linear_spring_dashpot has no parameter ", "did you mean 'normal_stiffness'?");
  refused("linear_spring_dashpot normal_stiffness", "'normal_stiffness': has no '='; ", "give KEY=VALUE");
  refused("linear_spring_dashpot normal_stiffness=stiff",
          "'normal_stiffness=stiff': 'stiff' is not a number; ", "give a number such as 5e3");
  refused("linear_spring_dashpot normal_stiffness=nan",
          "linear_spring_dashpot.normal_stiffness = nan is out of range; ", "give a number above 0 (N/m)");
  refused("linear_spring_dashpot tension=ct", "'tension=ct': 'ct' is not a valid choice; ",
          "did you mean 'cut'?");
  refused("gravity acceleration=1", "'acceleration=1': gravity is a body force ", "omit the value");
  refused("linear_spring_dashpot --radius inf", "--radius: inf is not a number above 0; ",
          "see scree describe --help");
}

#if SCREE_TEST_PICTURES
TEST_CASE("render redraws the snapshots of a run", "[tools]") {
  const Workspace w(std::string(discs) + "[snapshot]\nevery = 1e-4\n");
  REQUIRE(w.run().status == 0);
  const Outcome drawn = w.scree("render out --out pictures --color-by speed --width 300 --height 200");
  CHECK(drawn.status == 0);
  CHECK(drawn.out == "pictures/frame_0000000000.png\npictures/frame_0000000010.png\n");
  CHECK(w.has("pictures/frame_0000000010.png"));
  const Workspace empty;
  check_refused(empty, empty.scree("render ."), ".: contains no particles_*.vtp; ",
                "([snapshot] every = <s>)");
}

TEST_CASE("render takes single files of any name, and refuses others in one line", "[tools]") {
  const Workspace w(std::string(discs) + "[snapshot]\nevery = 1e-4\n");
  REQUIRE(w.run().status == 0);
  std::filesystem::copy(w / "out/snapshots/particles_0000000010.vtp", w / "a.vtp");
  CHECK(w.scree("render a.vtp --out pictures --width 300 --height 200").out == "pictures/a.png\n");
  for (const char* other :
       {"out/snapshots/particles.pvd", "out/run.json", "out/snapshots/contacts_0000000010.vtp"}) {
    const Outcome refused = w.scree(std::string("render ") + other + " --out no");
    CHECK(refused.status == 2);
    CHECK(refused.err.starts_with(std::string("scree: ") + other + ": "));
    CHECK(contains(refused.err, "; give a particles_<step>.vtp file"));
    CHECK_FALSE(w.has("no"));
  }
  const Outcome range = w.scree("render out --color-range 3,1");
  CHECK(range.status == 2);
  CHECK(contains(range.err, "--color-range 3,1: is not a range; give two numbers"));
}

TEST_CASE("render replaces pictures of its run, and other files only with --overwrite", "[tools]") {
  const Workspace w(std::string(discs) +
                    "[snapshot]\nevery = 1e-4\nimage_every = 1e-4\nwidth = 200\nheight = 200\n");
  REQUIRE(w.run().status == 0);
  const std::string call = "render out --width 200 --height 200 --color-by speed ";
  const std::string before = w.text("out/images/frame_0000000010.png");
  for (const char* options : {"", "--out out/images"}) {
    CHECK(w.scree(call + options).status == 0);
    CHECK(w.text("out/images/frame_0000000010.png") != before);
  }
  std::filesystem::create_directory(w / "pictures");
  const auto refused = [&](const std::string& arguments, const std::string& file, const std::string& line) {
    w.write(file, "mine");
    const Outcome outcome = w.scree(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err == "scree: " + file + ": " + line + "\n");
    CHECK(w.text(file) == "mine");
    std::filesystem::remove(w / file);
  };
  const std::string there = "is there already; give another --out, or --overwrite";
  refused(call + "--out pictures", "pictures/frame_0000000010.png", there);
  CHECK_FALSE(w.has("pictures/frame_0000000000.png"));
  refused(call + "--movie movie.mp4", "movie.mp4", "is there already; give another --movie, or --overwrite");
  CHECK(contains(w.scree(call + "--movie movie.txt").err,
                 "is not a name of a movie; give one that ends in .mp4"));
  std::filesystem::copy(w / "out/snapshots/particles_0000000010.vtp", w / "a.vtp");
  refused("render a.vtp", "a.png", there);
  // A picture in the run that is not of the run.
  std::filesystem::copy(w / "out/snapshots/particles_0000000010.vtp",
                        w / "out/snapshots/particles_0000000007.vtp");
  refused(call, "out/images/frame_0000000007.png",
          "is there and was not written by a run; move it elsewhere, or give another --out");
  w.write("pictures/frame_0000000010.png", "mine");
  CHECK(w.scree(call + "--out pictures --overwrite").status == 0);
  CHECK(w.text("pictures/frame_0000000010.png") != "mine");
}

TEST_CASE("render joins the pictures to a movie with ffmpeg, or says that it is not there", "[tools]") {
  const Workspace w(std::string(discs) + "[snapshot]\nevery = 5e-5\n");
  REQUIRE(w.run().status == 0);
  const std::string call = "scree render out --movie out.mp4 --width 300 --height 200";
  const Outcome without = w.shell("PATH=/nowhere\n" + call);
  CHECK(without.status == 2);
  CHECK(contains(without.err, "--movie: the program ffmpeg is not on the PATH; install it"));
  CHECK_FALSE(w.has("out/images"));
  // Keeps what it is given: its arguments, and the pictures in the order of their names.
  w.write(
      "ffmpeg",
      "#!/bin/sh\nfor last; do :; done\necho \"$@\" > \"${last%/*}/arguments\"\ncat ??????.png > \"$last\"\n");
  const Outcome with_it = w.shell("chmod +x ffmpeg; PATH=$PWD:$PATH\n" + call + " --rate 12");
  INFO(with_it.err);
  CHECK(with_it.status == 0);
  CHECK(with_it.out.ends_with("frame_0000000010.png\nout.mp4\n"));
  CHECK(contains(w.text("arguments"), "-framerate 12 -i %06d.png "));
  std::string pictures;
  for (const char* step : {"00", "05", "10"})
    pictures += w.text(std::string("out/images/frame_00000000") + step + ".png");
  CHECK(w.text("out.mp4") == pictures);
  w.write("ffmpeg", "#!/bin/sh\necho 'no such codec' >&2\nexit 1\n");
  const Outcome failed = w.shell("chmod +x ffmpeg; PATH=$PWD:$PATH\n" + call + " --overwrite");
  CHECK(failed.status == 1);
  CHECK(contains(failed.err, "out.mp4: ffmpeg failed (no such codec); "));
}
#endif

TEST_CASE("a failure to write the output gives a failure status", "[tools]") {
  const Outcome full = Workspace().shell("scree describe > /dev/full");
  CHECK(full.status == 1);
  CHECK(full.err == "scree: standard output cannot be written; free disk space or redirect it elsewhere\n");
}

TEST_CASE("describe folds keys that differ in an axis or a side only", "[tools]") {
  const Workspace w;
  const std::string box = w.scree("describe boundary/box").out;
  CHECK(contains(box, "\n  stress_{x,y,z}_{low,high} "));
  CHECK(contains(box, "\n  {x,y,z}_{low,high} "));
  CHECK(contains(box, "\n  stress_{x,y,z} "));
  CHECK_FALSE(contains(box, "stress_x_low"));
  const std::string all = w.scree("describe --all").out;
  CHECK(contains(
      all,
      "[box](#box), [cone](#cone), [cylinder](#cylinder), [disc](#disc), [mesh](#mesh), [periodic](#periodic), "
      "[plane](#plane), "));
  CHECK(contains(all, "[box](#box-1)"));
}

TEST_CASE("describe shows the keys of a table, and KEYS.md is what it prints of all", "[tools]") {
  const Workspace w;
  const Outcome time = w.scree("describe time");
  CHECK(time.status == 0);
  CHECK(contains(time.out, "number (s) above 0; required"));
  CHECK(contains(w.scree("describe tme").err, "no plug-in or table 'tme'; did you mean 'time'?"));
  // To renew: scree describe --all > scenarios/KEYS.md
  CHECK(w.scree("describe --all").out ==
        text_of(std::filesystem::path(SCREE_TEST_SOURCE) / "scenarios/KEYS.md"));
}
