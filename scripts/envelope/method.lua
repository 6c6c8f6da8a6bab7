-- method.lua: horizons of 2 to 16 spacings, and all ways to weigh and calibrate bonds.
--
-- A crack runs between two long edges that are pulled apart; the scene is its own mirror image.
-- Expected: mirror images differ by exactly nothing; with the constants of the lattice E is that of the material.
--
--   hackle run scripts/envelope/method.lua --set m=16 --set quadrature=area
local parts = require "envelope.parts"
local o = options { m = 4, precision = "f64", quadrature = "full", micromodulus = "constant", surface = "none",
                    constants = "lattice", plane = "stress", alpha = 0, steps = 150, fidelity = 0, fused = false }
local dx = 1*mm
local p = plate { width = 60*dx, height = 40*dx, material = parts.glass { alpha = o.alpha }, plane = o.plane }
p:crack { from = { 0, 20*dx }, to = { 24*dx, 20*dx } }
p:traction { edge = "top", stress = { 0, 20*MPa } }
p:traction { edge = "bottom", stress = { 0, -20*MPa } }
local s = simulate(p, { spacing = dx, horizon = o.m*dx, precision = o.precision, quadrature = o.quadrature, micromodulus = o.micromodulus,
                        surface = o.surface, constants = o.constants, fidelity = o.fidelity, fused = o.fused })
s:step(o.steps)
parts.near("difference of mirror images", parts.asymmetry(s, 60, 40), 0, 0, "the scene is its mirror image", "m")
expect { "broken bonds", got = s.damage.broken_bonds, min = 1, source = "five times the strength of the crack" }
if o.constants == "lattice" then parts.near("E over that of the material", s.E/65e9, 1, 1e-9, "calibrated on this lattice") end
