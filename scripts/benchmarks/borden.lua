-- borden.lua: the branching benchmark of Borden et al. 2012 (CMAME 217-220:77).
--
-- Glass with E 32 GPa and G0 3 J/m2, 100 x 40 mm, a crack to the middle, 1 MPa suddenly on both long edges.
-- Their crack (in a phase field) branches at about 34 to 37 us, 65 to 70 mm, below 0.6 of the Rayleigh speed.
-- Expected: the first bond at 9.4 us, one fork at 65 mm (visible at 35 us).
--
--   hackle run scripts/benchmarks/borden.lua

local o = options { load = 1*MPa, spacing = 0.25*mm, horizon = 1*mm }

local p = plate { width = 100*mm, height = 40*mm, material = "borden_glass" }
p:crack { from = {0, 20*mm}, to = {50*mm, 20*mm} }
for edge, pull in pairs { top = o.load, bottom = -o.load } do
  p:traction { edge = edge, stress = {0, pull} }:nofail { edge = edge, depth = o.horizon }
end

local s = simulate(p, { spacing = o.spacing, horizon = o.horizon })
s:movie { "borden.mp4", every = 0.5*us }
s:run(80*us)
s:frame { "borden.png" }
print(s:report())
