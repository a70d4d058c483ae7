// Many collisions of two disks from a table.
#pragma once

#include <string>
#include <string_view>

namespace carom {

/// Collides the pair of every row of a CSV text and returns the same rows with vx1_after,vy1_after,vx2_after,vy2_after
/// appended (shortest decimals that read back to the same bits). The header must have x1,y1,vx1,vy1,m1 and
/// x2,y2,vx2,vy2,m2, in any order; other columns are kept. Pairs are taken to be in contact where they stand.
/// Throws one Error with every bad row as name:line:column (the first 20, then how many more).
std::string collide_batch(std::string_view csv, const std::string& name, double restitution);

}  // namespace carom
