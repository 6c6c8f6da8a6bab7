-- SPDX-License-Identifier: MIT
-- The material library of `material "name"`. E in Pa, rho in kg/m3, G0 in J/m2, fringe in N/m; the
-- unit constants of scripts may be used here.
return {
  -- G0 is the energy release rate measured while cracks branch, not the quasi-static toughness (3 to 8 J/m2).
  duran50 = {
    title = "Duran 50 glass", E = 65*GPa, rho = 2235, nu = 0.2, G0 = 204, fringe = 136.5e3,
    source = "Ha & Bobaru 2010, Int. J. Fract. 162:229; fringe: 546 nm over the 4.0e-12 m2/N of its maker",
  },
  soda_lime = {
    title = "Soda-lime glass", E = 72*GPa, rho = 2440, nu = 0.22, G0 = 3.8,
    source = "crack branching deck of PDMATLAB2D, after Bobaru & Zhang 2015, Int. J. Fract. 196:59",
  },
  -- The other value in use, which like that of Duran 50 was measured while cracks branch.
  soda_lime_branching = {
    title = "Soda-lime glass (G0 at branching)", E = 72*GPa, rho = 2440, nu = 0.22, G0 = 135,
    source = "deck of a 2-D peridynamic code after Ha & Bobaru 2010, Int. J. Fract. 162:229; nu unconfirmed",
  },
  homalite100 = {
    title = "Homalite-100", E = 4.55*GPa, rho = 1230, nu = 0.31, G0 = 38.46, fringe = 22e3,
    source = "crack branching example of PyPD, after Bobaru & Zhang 2015, section 5.2; nu and fringe from memory, unconfirmed",
  },
  pmma = {
    title = "PMMA", E = 3.09*GPa, rho = 1180, nu = 0.35, G0 = 300,
    source = "preset of PhAST, after Bleyer, Roux-Langlois & Molinari 2017, Int. J. Fract. 204:79",
  },
  maraging_steel = {
    title = "Maraging steel 18Ni1900", E = 190*GPa, rho = 8000, nu = 0.3, G0 = 22.13e3,
    source = "Kalthoff test in decks of PhAST, after Borden et al. 2012, Comput. Methods Appl. Mech. Eng. 217-220:77",
  },
  borden_glass = {
    title = "Glass of Borden et al.", E = 32*GPa, rho = 2450, nu = 0.2, G0 = 3,
    source = "decks of PhAST, after Borden et al. 2012, Comput. Methods Appl. Mech. Eng. 217-220:77",
  },
  alumina = {
    title = "Alumina", E = 370*GPa, rho = 3980, nu = 0.22, G0 = 24, alphaT = 7.5e-6,
    source = "usual values of dense alumina, from memory, unconfirmed: check before you compare with a test",
  },
}
