#include "report_support.hpp"

using namespace scree::test;

TEST_CASE("the page of modes has what the record and the tables say", "[report]") {
  const TemporaryFolder folder;
  folder.write("modes.json",
               R"({"version": "1", "status": "finished", "title": "Box", "bodies": 30, "rattlers": 2,
    "complete": true, "elastic": {"unit": "Pa", "shear_modulus": 12345678}, "expect": []})");
  std::string rows = "kind,frequency [Hz]\n";
  for (int k = 0; k < 40; ++k) rows += "vibrating," + std::to_string(100 + k) + "\n";
  folder.write("modes.csv", rows);
  write(folder, "charts/density.png", "\x89PNG\r\n\x1a\n");
  const std::string page = checked_page(folder);
  for (const char* part :
       {"The study of modes finished.", "<dt>rattlers</dt><dd>2</dd>", "<dt>complete</dt><dd>yes</dd>",
        "<h2>Elastic constants</h2>", "12.3457\u00A0MPa", "modes.csv, its beginning: 30 of 40 rows",
        "frequency (Hz)", "<figcaption>density</figcaption>"})
    CHECK_THAT(page, Catch::Contains(part));
}
