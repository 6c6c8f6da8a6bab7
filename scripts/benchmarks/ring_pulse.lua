-- ring_pulse.lua: an elastic pulse spreads as a ring in an intact plate.
--
-- A small bulge of displacement, a Gaussian along the radius, is released in the middle of a plate; a ring spreads
-- (the usual wave test of the field: PDMATLAB2D WavePropagation.m, with its ratio of width to plate, 1/30). The times
-- at which the ring passes two nodes give its speed, which is compared with c_p = sqrt(E/(rho (1 - nu^2))) of plane
-- stress, E and nu those of the lattice (nu 0.317 at m = 4).
-- Expected: within 2 % of c_p; no bond breaks.
--
--   hackle run scripts/benchmarks/ring_pulse.lua

local o = options { spacing = 0.5*mm, m = 4 }
local E, rho, width, half = 65*GPa, 2235, 3*mm, 50*mm

local xx, xy = 0, 0
for a = -o.m, o.m do
  for b = -o.m, o.m do
    local r2 = a*a + b*b
    if r2 > 0 and r2 <= o.m^2 then xx, xy = xx + a^4/r2^1.5, xy + a*a*b*b/r2^1.5 end
  end
end
local nu = xy/xx
local c_p = math.sqrt(E/(rho*(1 - nu^2)))

local p = plate { width = 2*half, height = 2*half, material = "duran50" }
p:initial { displacement = function(x, y)
  local dx, dy = x - half, y - half
  local bulge = 1e-6*math.exp(-(dx*dx + dy*dy)/(width*width))
  return bulge*dx/width, bulge*dy/width
end }
local s = simulate(p, { spacing = o.spacing, horizon = o.m*o.spacing })

-- The crest passes a node when its displacement is largest: fits a parabola through the largest value and its
-- neighbours.
local places = { {half + 20*mm, half}, {half + 40*mm, half} }
local best, last = { {u = 0}, {u = 0} }, { {}, {} }
local crest = {}
while s.time < 45*mm/c_p do
  s:step(1)
  for k, place in ipairs(places) do
    local node = s:at(place)
    local h = last[k]
    h[1], h[2], h[3] = h[2], h[3], node.ux
    if h[1] and h[2] > best[k].u and h[2] >= h[1] and h[2] >= h[3] then
      best[k].u = h[2]
      crest[k] = { t = s.time - s.dt*(1 - 0.5*(h[1] - h[3])/(h[1] - 2*h[2] + h[3])), x = node.x }
    end
  end
end
local speed = (crest[2].x - crest[1].x)/(crest[2].t - crest[1].t)
print(string.format("ring %.0f m/s, c_p %.0f m/s: %.2f %%; %d bonds broken",
                    speed, c_p, 100*speed/c_p, s.damage.broken_bonds))

expect { "speed of a ring-shaped pulse", unit = "m/s", got = speed, value = c_p, relative = 0.02, source = "sqrt(E/(rho (1 - nu^2)))" }
expect { "bonds broken by it", got = s.damage.broken_bonds, value = 0, source = "its strain is far below s0" }
