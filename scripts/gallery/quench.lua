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

-- Damage beyond the cold skin counts as a crack.
local count, inside = 0, false
for x = o.spacing/2, 50*mm, o.spacing do
  local on = s:cracks { from = {x - o.spacing/4, 1*mm}, to = {x + o.spacing/4, 2*mm} }.nodes > 0
  if on and not inside then count = count + 1 end
  inside = on
end
expect { "cracks that leave the cold skin", got = count, min = 10, source = "Jiang et al., ICF13 paper 1218 (abstract): an array of cracks" }
expect { "top of the cracks: none goes through", unit = "m", got = s:cracks().top, max = 9*mm, source = "Jiang et al., ICF13 paper 1218 (abstract)" }
