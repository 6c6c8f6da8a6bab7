-- SPDX-License-Identifier: MIT
-- The material library: what `material "name"` knows. E in Pa, rho in kg/m3, G0 in J/m2; the unit constants of
-- scripts are known here.
return {
  -- G0 is the energy release rate measured while cracks branch, not the quasi-static toughness (3 to 8 J/m2).
  duran50 = {
    title = "Duran 50 glass", E = 65*GPa, rho = 2235, nu = 0.2, G0 = 204,
    source = "Ha & Bobaru 2010, Int. J. Fract. 162:229",
  },
  soda_lime = {
    title = "Soda-lime glass", E = 72*GPa, rho = 2440, nu = 0.22, G0 = 3.8,
    source = "crack branching deck of PDMATLAB2D, after Bobaru & Zhang 2015, Int. J. Fract. 196:59",
  },
}
