-- spin.lua: a plate that spins, up to 1e5 turns.
--
-- The rim has a share of the speed of waves; without a number of turns it spins for 400 steps and may burst.
-- Expected: leapfrog with central forces keeps angular momentum, to a rounding of each step, either way; a plate that holds keeps
-- its energy.
--
--   hackle run scripts/envelope/spin.lua --set share=0.3 --set turns=1000
local parts = require "envelope.parts"
local o = options { share = 0.1, turns = 0, n = 40, s0 = 1e-3, precision = "f64", m = 4 }
local dx = 1*mm
local p = plate { width = o.n*dx, height = o.n*dx, material = parts.glass { s0 = o.s0 } }
local turn = o.share*5686/(0.5*o.n*dx*math.sqrt(2))
p:initial { velocity = function(x, y) return -turn*(y - 0.5*o.n*dx), turn*(x - 0.5*o.n*dx) end }
local s = simulate(p, { spacing = dx, precision = o.precision, horizon = o.m*dx })
local before = parts.sums(s, o.n, o.n)
local steps = o.turns > 0 and math.ceil(o.turns*2*math.pi/turn/s.dt) or 400
s:step(steps)
local after = parts.sums(s, o.n, o.n)
local rounding = 10*(1 + math.sqrt(steps))*parts.rounding[o.precision]
parts.near("angular momentum over that at the start", after.L/before.L, 1, rounding, "no moment from outside")
parts.near("momentum over the sum of |v|", math.sqrt(after.px^2 + after.py^2)/after.size, 0, rounding, "no force from outside")
if o.turns > 0 then
  parts.near("broken bonds", s.damage.broken_bonds, 0, 0, "the plate holds")
  expect { "kinetic and strain energy over those at the start", got = (s.energy.kinetic + s.energy.strain)/s.energy.external, min = 0.95, max = 1.05, source = "nothing takes energy" }
end
