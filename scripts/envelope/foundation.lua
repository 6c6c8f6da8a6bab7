-- foundation.lua: elastic foundations from soft to rigid.
--
-- A plate that is moved as a whole swings on its springs; the step takes the springs into account.
-- Expected: u = u0 cos(omega t), omega = sqrt(stiffness/rho), with the frequency of leapfrog: sin(omega' dt/2) = omega dt/2.
--
--   hackle run scripts/envelope/foundation.lua --set stiffness=1e20
local parts = require "envelope.parts"
local o = options { stiffness = 1e13, precision = "f64", steps = 200 }
local dx, u0 = 1*mm, 1e-6
local p = plate { width = 24*dx, height = 18*dx, material = parts.glass() }
p:foundation { stiffness = o.stiffness }
p:initial { displacement = { u0, 0 } }
local s = simulate(p, { spacing = dx, precision = o.precision })
s:step(o.steps)
local omega = math.sqrt(o.stiffness/2235)
local discrete = 2*math.asin(0.5*omega*s.dt)/s.dt
local node = s:at { 12.5*dx, 9.5*dx }
parts.near("displacement over that at the start", node.ux/u0, math.cos(discrete*s.time), 100*o.steps*parts.rounding[o.precision], "u0 cos(omega t) of leapfrog")
