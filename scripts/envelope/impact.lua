-- impact.lua: impactors from a crawl to above the speed of waves, light and heavy.
--
-- A disc hits the plate.
-- Expected: the momentum of disc and plate together is that of the disc at the start.
--
--   hackle run scripts/envelope/impact.lua --set v=1e4
local parts = require "envelope.parts"
local o = options { v = 10, density = 7850, precision = "f64", friction = 0, restitution = 1, steps = 400, safety = 0.9 }
local dx, nx, ny = 1*mm, 40, 30
local p = plate { width = nx*dx, height = ny*dx, material = parts.glass() }
p:impactor { centre = { -4.001*dx, 15*dx }, radius = 4*dx, velocity = { o.v, 0 }, density = o.density, friction = o.friction,
             restitution = o.restitution, name = "disc" }
local s = simulate(p, { spacing = dx, precision = o.precision, safety = o.safety })
s:step(o.steps - 1)
local earlier = s:reaction("disc").ux
s:step(1)
local disc, sum = s:reaction "disc", parts.sums(s, nx, ny)
local mass, node = o.density*math.pi*(4*dx)^2, 2235*dx*dx
local pushed = math.abs(disc.fx)*s.dt
parts.near("momentum along x over that of the disc", (mass*(disc.ux - earlier)/s.dt + node*sum.px)/(mass*o.v), 1, 1e-3 + 1e4*parts.rounding[o.precision] + pushed/(mass*math.abs(o.v)), "Newton; v lags by half a step")
