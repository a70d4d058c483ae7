// The symbols of the source text.
#pragma once

#include <string>

#include "expression.hpp"

namespace carom::explaining {

/// What belongs to one disk. n, t: along normal and tangent; f: after the collision; x, y: components.
struct DiskSymbols {
  explicit DiskSymbols(const std::string& index)
      : m(symbol("m" + index, "m_" + index)),
        radius(symbol("R" + index, "R_" + index)),
        x(symbol("x" + index, "x_" + index)),
        y(symbol("y" + index, "y_" + index)),
        v(symbol("v" + index, "\\mathbf{v}_" + index)),
        vx(scalar(index, "x")),
        vy(scalar(index, "y")),
        vn(scalar(index, "n")),
        vt(scalar(index, "t")),
        vnf(scalar(index, "nf")),
        vtf(scalar(index, "tf")),
        vnfx(scalar(index, "nfx")),
        vnfy(scalar(index, "nfy")),
        vtx(scalar(index, "tx")),
        vty(scalar(index, "ty")),
        vf(symbol("v" + index + "f", "\\mathbf{v}_{" + index + "f}")),
        vfx(scalar(index, "fx")),
        vfy(scalar(index, "fy")) {}

  Expr m, radius, x, y;
  Expr v, vx, vy;     ///< velocity before
  Expr vn, vt;        ///< its parts
  Expr vnf, vtf;      ///< the parts after
  Expr vnfx, vnfy;    ///< vector along the normal, after
  Expr vtx, vty;      ///< vector along the tangent
  Expr vf, vfx, vfy;  ///< velocity after

 private:
  static Expr scalar(const std::string& index, const std::string& which) {
    return symbol("v" + index + which, "v_{" + index + which + "}");
  }
};

/// All symbols of a derivation.
struct Symbols {
  DiskSymbols one{"1"}, two{"2"};
  Expr e = symbol("e", "e");
  Expr time = symbol("t_c", "t_c");
  Expr dx = symbol("Δx", "\\Delta x"), dy = symbol("Δy", "\\Delta y");
  Expr n = symbol("n", "\\mathbf{n}"), distance = symbol("|n|", R"(\lvert \mathbf{n} \rvert)");
  Expr t = symbol("t", "\\mathbf{t}");
  Expr un = symbol("un", "\\mathbf{un}"), unx = symbol("un_x", "\\mathit{un}_x"),
       uny = symbol("un_y", "\\mathit{un}_y");
  Expr ut = symbol("ut", "\\mathbf{ut}"), utx = symbol("ut_x", "\\mathit{ut}_x"),
       uty = symbol("ut_y", "\\mathit{ut}_y");
  Expr lost = symbol("Q", "Q");
  Expr px = symbol("P_x", "P_x"), py = symbol("P_y", "P_y");
  Expr pxf = symbol("P_xf", "P_{xf}"), pyf = symbol("P_yf", "P_{yf}");
  Expr k = symbol("K", "K"), kf = symbol("K_f", "K_f");
  Expr j = symbol("J", "J"), jx = symbol("J_x", "J_x"), jy = symbol("J_y", "J_y");
};

}  // namespace carom::explaining
