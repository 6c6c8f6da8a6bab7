-- compression.lua: compression to 90 %.
--
-- A square pressed at the start by a share of its size, which cannot break, swings back; or its ends are driven together.
-- Expected: kinetic and strain energy keep their sum within (omega dt)^2/4, 1 % where dt is a tenth of the limit; compressed bonds are
-- stiffer by 1/(1 - share)^2, so the step is shorter by 1 - share. Driven, the ledger closes to that, the ends are where they are
-- led to, and mirror images are alike to the last bit.
--
--   hackle run scripts/envelope/compression.lua --set share=0.9
local parts = require "envelope.parts"
local o = options { share = 0.5, precision = "f64", driven = false, safety = 0, G0 = 2e10, steps = 200, contact = false }
local dx, n = 1*mm, 20
local fine = o.safety == 0
local safety = fine and 0.1*(1 - o.share) or o.safety
local p = plate { width = n*dx, height = n*dx, material = parts.glass { G0 = o.G0 } }
if o.contact then p:contact {} end
local way = 0.5*o.share*n*dx
if o.driven then
  p:move { edge = "top", depth = 2*dx, displacement = { 0, -way }, time = ramp(40*us) }
  p:move { edge = "bottom", depth = 2*dx, displacement = { 0, way }, time = ramp(40*us) }
else
  p:initial { displacement = function(x, y) return -o.share*x, -o.share*y end }
end
local s = simulate(p, { spacing = dx, precision = o.precision, safety = safety })
local rounding = parts.rounding[o.precision]
if o.driven then
  s:run(40*us)
  parts.near("open share of the ledger", s.energy.residual/s.energy.external, 0, 0.01, "leapfrog: (omega dt)^2/4")
  parts.near("way of the ends", -s:at { 0.5*n*dx, n*dx }.uy/way, 1, 1e3*rounding, "as led")
  parts.near("difference of mirror images", parts.asymmetry(s, n, n), 0, 0, "a symmetric scene")
else
  local start, worst = s.energy.strain, 0
  for _ = 1, 10 do
    s:step(math.ceil(0.1*o.steps*(fine and 1/(1 - o.share) or 1)))
    worst = math.max(worst, math.abs((s.energy.kinetic + s.energy.strain)/start - 1))
  end
  if fine and o.G0 == 2e10 and not o.contact then parts.near("energy over that at the start, minus 1", worst, 0, 0.01, "leapfrog: (omega dt)^2/4") end
end
local sum = parts.sums(s, n, n)
expect { "largest displacement", got = sum.far, min = 0, max = 1*m, source = "it stays near" }
parts.near("momentum over the sum of |v|", math.sqrt(sum.px^2 + sum.py^2)/sum.size, 0, 1e5*rounding, "no force from outside, or opposite ones")
