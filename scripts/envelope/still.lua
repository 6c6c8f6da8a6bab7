-- still.lua: nothing is ever loaded.
--
-- A plate with cracks, holes and every option, to which nothing happens.
-- Expected: no displacement, no broken bond, no energy, exactly.
--
--   hackle run scripts/envelope/still.lua --set m=2
local parts = require "envelope.parts"
local o = options { m = 4, precision = "f64", alpha = 0, contact = false, hole = false, cracks = 0, scatter = false, damping = 0, surface = "none" }
local dx = 1*mm
local p = plate { width = 40*dx, height = 30*dx, material = parts.glass { alpha = o.alpha } }
if o.contact then p:contact {} end
if o.hole then p:hole { centre = { 20*dx, 15*dx }, radius = 6*dx } end
if o.scatter then p:strength { modulus = 5 } end
if o.damping > 0 then p:damping { rate = o.damping } end
if o.cracks > 0 then p:random_cracks { count = o.cracks, length = { 1*dx, 10*dx } } end
local s = simulate(p, { spacing = dx, horizon = o.m*dx, precision = o.precision, surface = o.surface })
s:step(300)
parts.near("largest displacement", s:values "displacement":max().value, 0, 0, "nothing acts", "m")
parts.near("broken bonds", s.damage.broken_bonds, 0, 0, "nothing acts")
parts.near("kinetic and strain energy", s.energy.kinetic + s.energy.strain, 0, 0, "nothing acts")
