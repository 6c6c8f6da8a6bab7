-- nonsense.lua: input that makes no sense.
--
-- One quantity in turn is no number, not finite, of the wrong sign or beyond its bounds.
-- Expected: a refusal before the run that says what to do.
--
--   hackle run scripts/envelope/nonsense.lua --set what=spacing --set value=0/0
local o = options { what = "spacing", value = 0/0 }
local dx = 1*mm
local given = { width = 24*dx, height = 18*dx, spacing = dx, horizon = 4*dx, E = 65e9, rho = 2235, nu = 0.2, G0 = 200, alpha = 0, alphaT = 1e-6,
                stress = 1*MPa, rate = 0, change = 0, v = 0, step = 1e-8, fidelity = 0, safety = 0.9, duration = 1*us, stiffness = 15 }
given[o.what] = o.value
local g = given
local p = plate { width = g.width, height = g.height, material = material { E = g.E, rho = g.rho, nu = g.nu, G0 = g.G0, alpha = g.alpha, alphaT = g.alphaT } }
p:traction { edge = "top", stress = { 0, g.stress } }
p:damping { rate = g.rate }
p:temperature { change = g.change }
p:initial { velocity = { g.v, 0 } }
p:contact { stiffness = g.stiffness }
local s = simulate(p, { spacing = g.spacing, horizon = g.horizon, step = g.step, fidelity = g.fidelity, safety = g.safety })
s:run(g.duration)
