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
local seen = require "watch" (s, 2*us)
s:movie { "homalite.mp4", every = 2*us }
s:run(400*us)
s:frame { "homalite.png" }
print(s:report())

expect { "place of the first fork: beyond the crack", unit = "m", got = seen.place, min = 200*mm, source = "Bobaru & Hu 2012 (abstract)" }
expect { "branches at the end", got = s:cracks().bands, min = 2, source = "Bobaru & Hu 2012 (abstract)" }
expect { "nodes on cracks above, less those below", value = 0, source = "symmetry of the scene",
         got = s:cracks { from = {0, 100*mm}, to = {400*mm, 200*mm} }.nodes - s:cracks { from = {0, 0}, to = {400*mm, 100*mm} }.nodes }
expect { "largest speed over c_R", got = seen.speed/s.c_R, min = 0.40, max = 0.50,
         source = "Ravi-Chandar & Knauss 1984: terminal speed 0.45 c_R", confirmed = false,
         reason = "a crack in a plane has no microbranches, which hold back a real one" }
