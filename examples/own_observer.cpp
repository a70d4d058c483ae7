// An observer of one's own: the mean free path of a tagged disk.
#include <carom/carom.hpp>
#include <cstdio>

class FreePath : public carom::Observer {
 public:
  void on_window(const carom::WindowRecord& window) override {
    for (const carom::Collision& collision : window.collisions) {
      if (collision.i == kTagged || collision.j == kTagged) ++contacts_;
    }
    // The speed at the window's start stands for the whole window: right on average.
    path_ += length(window.before.disks.velocity(kTagged)) * window.before.clock.length;
  }

  [[nodiscard]] double mean() const { return path_ / static_cast<double>(contacts_); }

 private:
  static constexpr carom::DiskId kTagged = 0;
  long contacts_ = 0;
  double path_ = 0;
};

int main() {
  carom::GasPreset gas;
  gas.disks = 100;
  gas.packing = 0.2;
  FreePath free_path;
  carom::Simulation simulation(carom::realize(carom::make_gas(gas).scene));
  simulation.add_observer(free_path);
  simulation.run_until(200);
  std::printf("mean free path of disk 0: %.2f diameters\n", free_path.mean());
}
