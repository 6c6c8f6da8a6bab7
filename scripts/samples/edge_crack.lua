-- edge_crack.lua: the paper's first plate. A crack runs and forks once.
--
-- A glass plate with a crack from its left edge to the middle is pulled apart by sudden stresses
-- on both long edges (paper, Figs. 3 and 4; 12 MPa).
-- Expected: the crack starts at 6 us and forks once, symmetrically, 67 mm from the left edge (visible at 25 us).
--
--   hackle run scripts/samples/edge_crack.lua
--   hackle validate --quick edge_crack
--   hackle run scripts/samples/edge_crack.lua --set spacing=0.25*mm --set horizon=1*mm

local o = options { load = 12*MPa, spacing = 0.5*mm, horizon = 2*mm }

-- 1. The scene: exact geometry, no mesh.
local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
p:crack    { from = {0, 20*mm}, to = {50*mm, 20*mm} }
p:traction { edge = "top",    stress = {0,  o.load} }
p:traction { edge = "bottom", stress = {0, -o.load} }

-- The loaded edges must not crumble: a sudden load on the soft rim breaks bonds in the corners within a
-- microsecond.
p:nofail   { edge = "top",    depth = o.horizon }
p:nofail   { edge = "bottom", depth = o.horizon }

-- 2. The lattice and the output.
local s = simulate(p, { spacing = o.spacing, horizon = o.horizon })
local seen = require "watch" (s, 0.5*us)
s:movie  { "edge_crack.mp4", field = "damage", every = 0.25*us }
s:record { "edge_crack.h5",  every = 1*us }

-- 3. Break it.
s:run(32*us)
s:frame  { "edge_crack.png", field = "damage" }
print(s:report())

-- 4. What it should give, with the options above.
expect { "first broken bond", unit = "s", got = seen.first, min = 5*us, max = 9*us, source = "paper, Fig. 4; Freund: 7.05 us" }
expect { "fork seen", unit = "s", got = seen.fork, min = 19*us, max = 27*us, source = "independent runs: 21 to 23 us, seen a horizon later" }
expect { "place of the fork", unit = "m", got = seen.place, value = 67*mm, tolerance = 5*mm, source = "independent runs of this plate" }
expect { "branches", got = s:cracks().bands, value = 2, source = "paper, Fig. 4: one symmetric fork" }
expect { "largest speed over c_R", got = seen.speed/s.c_R, max = 1, source = "Freund: a crack is slower than Rayleigh waves" }
expect { "residual of the energy over the work", got = math.abs(s.energy.residual)/s.energy.external, max = 0.015, source = "the ledger" }
