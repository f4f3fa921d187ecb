#include <scree/fields/field_recorder.hpp>
#include <scree/fields/field_sums.hpp>

namespace scree::fields {

namespace {

FieldFrame frame_of(const FieldSetting& setting, const FieldInput& input, unsigned threads) {
  ThreadPool pool(threads, ThreadPool::IfTooFew::use_fewer);
  FieldSums sums(setting.grid, setting.kernel);
  sums.add(input, pool);
  return {input.time, sums.means()};
}

class Recorder : public FieldRecorder {
 public:
  FieldSetting setting(const GridRequest& request, const FieldInput& input) override {
    return {grid_for(request, input), kernel_for(request, input)};
  }
  std::string vti(const FieldSetting& setting, const FieldInput& input, unsigned threads) override {
    return format_vti(setting.grid, frame_of(setting, input, threads));
  }
  std::string csv_rows(const FieldSetting& setting, const FieldInput& input, unsigned threads) override {
    return format_csv_rows(setting.grid, frame_of(setting, input, threads));
  }
  std::string csv_header(int dimension) override { return format_csv_header(dimension); }
  std::string pvd(const std::vector<TimedFile>& files) override { return format_pvd(files); }
};

}  // namespace

}  // namespace scree::fields

extern "C" [[gnu::visibility("default")]] scree::fields::FieldRecorder* scree_create_field_recorder(
    int version) {
  static scree::fields::Recorder recorder;
  return version == scree::fields::recorder_version ? &recorder : nullptr;
}
