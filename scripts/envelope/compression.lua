-- compression.lua: compression to 90 %.
--
-- A square pressed at the start by a share of its size, which cannot break, swings back; or its ends are driven together.
-- Expected: kinetic and strain energy keep their sum within (omega dt)^2/4, 1 % for a tenth of the limit, or the run says what is
-- lost.
--
--   hackle run scripts/envelope/compression.lua --set share=0.9
local parts = require "envelope.parts"
local o = options { share = 0.5, precision = "f64", driven = false, safety = 0.1, G0 = 2e10, steps = 200, contact = false }
local dx, n = 1*mm, 20
local p = plate { width = n*dx, height = n*dx, material = parts.glass { G0 = o.G0 } }
if o.contact then p:contact {} end
if o.driven then
  p:move { edge = "top", depth = 2*dx, displacement = { 0, -0.5*o.share*n*dx }, time = ramp(40*us) }
  p:move { edge = "bottom", depth = 2*dx, displacement = { 0, 0.5*o.share*n*dx }, time = ramp(40*us) }
else
  p:initial { displacement = function(x, y) return -o.share*x, -o.share*y end }
end
local s = simulate(p, { spacing = dx, precision = o.precision, safety = o.safety })
if o.driven then s:run(40*us) else
  local start, worst = s.energy.strain, 0
  for _ = 1, 10 do
    s:step(o.steps//10)
    worst = math.max(worst, math.abs((s.energy.kinetic + s.energy.strain)/start - 1))
  end
  if o.share <= 0.5 and o.G0 == 2e10 and o.safety <= 0.1 and not o.contact then parts.near("energy over that at the start, minus 1", worst, 0, 0.01, "leapfrog: (omega dt)^2/4") end
end
local sum = parts.sums(s, n, n)
expect { "largest displacement", got = sum.far, min = 0, max = 1*m, source = "it stays near" }
if not o.driven then parts.near("momentum over the sum of |v|", math.sqrt(sum.px^2 + sum.py^2)/sum.size, 0, 1e5*parts.rounding[o.precision], "no force from outside") end
