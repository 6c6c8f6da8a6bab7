-- quench.lua: hot alumina dropped into water. Parallel cracks start all along the cold edge; some stop early,
-- some run deep.
--
-- The lower edge of a plate is cooled by 300 K within a skin that fades over 1 mm; strength scatters a little,
-- otherwise all cracks would be the same.
-- Expected: ten cracks or more leave the cold skin; none goes through the plate.
--
--   hackle run scripts/gallery/quench.lua

local o = options { cooling = 300, skin = 1*mm, spacing = 0.1*mm }

local p = plate { width = 50*mm, height = 10*mm, material = "alumina" }
p:strength    { modulus = 15, correlation = 0.5*mm, seed = 7 }
p:temperature { change = function(x, y) return -o.cooling*math.exp(-(y/o.skin)) end, time = ramp(2*us) }
p:damping     { rate = 1e5 }

local s = simulate(p, { spacing = o.spacing })
s:movie { "quench.mp4", every = 0.2*us }
s:run(20*us)
s:frame { "quench.png" }
print(s:report())
