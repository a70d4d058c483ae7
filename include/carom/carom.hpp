// Everything carom offers to a program that links it: load a scene, run it, watch it, save it.
//
//   const carom::SceneFile file = carom::read_scene("gas.toml");
//   carom::Simulation simulation(carom::realize(file.scene));
//   simulation.run_until(100);
//   const carom::Summary summary = carom::summarize(simulation);
#pragma once

#include "carom/base/error.hpp"
#include "carom/base/random.hpp"
#include "carom/base/simd.hpp"
#include "carom/base/vec2.hpp"
#include "carom/carom/presets.hpp"
#include "carom/carom/run_scene.hpp"
#include "carom/carom/scene_keys.hpp"
#include "carom/carom/sweep.hpp"
#include "carom/carom/version.hpp"
#include "carom/explain/explain.hpp"
#include "carom/io/collide_batch.hpp"
#include "carom/io/collisions_csv.hpp"
#include "carom/io/file.hpp"
#include "carom/io/output_directory.hpp"
#include "carom/io/report.hpp"
#include "carom/io/run_results.hpp"
#include "carom/io/scene_file.hpp"
#include "carom/io/sweep_files.hpp"
#include "carom/io/xyz.hpp"
#include "carom/predict/contact.hpp"
#include "carom/rule/batch.hpp"
#include "carom/rule/collision.hpp"
#include "carom/rule/decomposition.hpp"
#include "carom/rule/one_dimension.hpp"
#include "carom/run/exhaustion.hpp"
#include "carom/run/settings.hpp"
#include "carom/run/simulation.hpp"
#include "carom/run/summary.hpp"
#include "carom/state/scene.hpp"
#include "carom/state/state.hpp"
#include "carom/state/system.hpp"
#include "carom/state/validate.hpp"
#include "carom/window/collision.hpp"
