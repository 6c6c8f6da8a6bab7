-- photoelastic.lua: the paper's first plate in a polariscope.
--
-- The edge-cracked plate under 12 MPa, filmed as isochromatics: dark where the two principal stresses
-- differ by a whole number of fringes. The load arrives with a pulse; loops of fringes run ahead of the
-- crack and split with it. The script also makes a movie of the opening plate with magnified displacements,
-- and one that follows the tip.
-- Expected: fringes crowd around the tip, and the crack forks once, as in samples/edge_crack.lua.
--
--   hackle run scripts/gallery/photoelastic.lua
--   hackle run scripts/gallery/photoelastic.lua --set spacing=0.125*mm --set horizon=0.5*mm

local o = options { spacing = 0.25*mm, horizon = 1*mm }

local p = plate { width = 100*mm, height = 40*mm, material = "duran50" }
p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
for edge, pull in pairs { top = 12*MPa, bottom = -12*MPa } do
  p:traction { edge = edge, stress = {0, pull} }:nofail { edge = edge, depth = 2*mm }
end

local s = simulate(p, { spacing = o.spacing, horizon = o.horizon })
s:movie { "fringes.mp4", field = "fringes", every = 0.25*us }
s:movie { "opening.mp4", field = "stress_1", deformed = true, load_curve = true, energy = true, every = 0.25*us }
s:movie { "tip.webm", field = "damage", second = "von_mises", zoom = {50*mm, 20*mm, 12*mm}, follow = "right",
          every = 0.25*us, width = 960 }
s:run(32*us)
s:frame { "photoelastic.png", field = "fringes" }
print(s:report())

expect { "branches", got = s:cracks().bands, value = 2, source = "samples/edge_crack.lua" }
expect { "place of the fork", unit = "m", got = s:cracks().fork, value = 67*mm, tolerance = 3*mm, source = "samples/edge_crack.lua" }
