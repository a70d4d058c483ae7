// An observer of one's own: the mean free path of a tagged disk.
#include <carom/carom.hpp>
#include <cstdio>

class FreePath : public carom::Observer {
 public:
  void on_window(const carom::WindowRecord& window) override {
    for (const carom::Collision& collision : window.collisions) {
      if (collision.i != kTagged && collision.j != kTagged) continue;
      ++contacts_;
    }
    // Between contacts a disk flies straight, so the state at the start tells its speed well enough for a gas.
    path_ += length(window.before.disks.velocity(kTagged)) * window.before.clock.length;
  }

  [[nodiscard]] double mean() const { return path_ / static_cast<double>(contacts_); }

 private:
  static constexpr carom::DiskId kTagged = 0;
  long contacts_ = 0;
  double path_ = 0;
};

int main() {
  FreePath free_path;
  carom::Simulation simulation(carom::realize(carom::make_gas({.disks = 100, .packing = 0.2}).scene));
  simulation.add_observer(free_path);
  simulation.run_until(200);
  std::printf("mean free path of disk 0: %.2f diameters\n", free_path.mean());
}
