#include "report_support.hpp"

using namespace scree::test;

TEST_CASE("the page of a spectrum has its curves, peaks and methods", "[report]") {
  const TemporaryFolder folder;
  folder.write("spectrum.json", R"({"version": "1", "status": "finished", "title": "Chain",
    "methods": [{"method": "linear", "frequencies": 3, "steps": 0, "wall_s": 0.01, "notes": ["a note"]},
                {"method": "sweep", "frequencies": 3, "steps": 100, "wall_s": 2, "notes": []}]})");
  folder.write(
      "spectrum.csv",
      "method,frequency [Hz],wall.z.amplitude [1/m],wall.z.phase [rad]\nlinear,10,1,0\nlinear,20,5,0\n"
      "linear,30,0,0\nsweep,10,1.1,0\nsweep,20,4.9,0\nsweep,30,1,0\n");
  folder.write(
      "peaks.csv",
      "method,column,frequency [Hz],frequency_error [Hz],width [Hz],width_error [Hz],quality,quality_error,"
      "amplitude,amplitude_error,amplitude_unit,phase [rad],difference [Hz],wavelengths\n"
      "linear,wall.z,19.25,0.012,2,0.1,9.6,0.5,5.2,0.1,1/m,0,0,\n");
  const std::string page = checked_page(folder);
  for (const char* part : {"The spectrum finished.", "wall.z over the frequency of the drive",
                           "<desc>wall.z per drive (1/m) over frequency (Hz); sweep; linear; peaks</desc>",
                           "19.250 ± 0.012", "5.20 ± 0.10 1/m", "a note", "--by all"})
    CHECK_THAT(page, Catch::Contains(part));
  CHECK_THAT(page, !Catch::Contains("wavelengths"));
}
