-- homalite.lua: branching without reflected waves.
--
-- Homalite-100, 400 x 200 mm, a crack to the middle (PyPD's deck after section 5.2 of Bobaru & Zhang
-- 2015). In Homalite a crack branches although no wave has come back from an edge (Bobaru & Hu 2012).
-- Expected: one fork or more, symmetric.
--
--   hackle run scripts/benchmarks/homalite.lua

local o = options { load = 1*MPa, spacing = 1*mm, horizon = 4*mm }

local p = plate { width = 400*mm, height = 200*mm, material = "homalite100" }
p:crack { from = {0, 100*mm}, to = {200*mm, 100*mm} }
for edge, pull in pairs { top = o.load, bottom = -o.load } do
  p:traction { edge = edge, stress = {0, pull} }:nofail { edge = edge, depth = o.horizon }
end

local s = simulate(p, { spacing = o.spacing, horizon = o.horizon })
s:movie { "homalite.mp4", every = 2*us }
s:run(400*us)
s:frame { "homalite.png" }
print(s:report())
