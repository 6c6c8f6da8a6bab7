-- bars.lua: bars, a cantilever and a ring at rest and in motion.
--
-- Bodies that are thin against the horizon, with corrected surfaces (surface = "energy"), E of the material and nu = 1/3.
-- Errors are of the first order in the horizon (src/lattice/README.md 3.10): 3 % are allowed at twenty rows, 6 % at ten.
-- Expected: E and the frequency to 1 %, the others within that.
--
--   hackle run scripts/validation/bars.lua
--   hackle validate --quick bars

local o = options { quick = false }
local m, E, rho, h, load = 3, 65*GPa, 2235, 10*mm, 10*kPa
local rows = o.quick and 10 or 20
local dx = h/rows
local numerics = { spacing = dx, horizon = m*dx, surface = "energy" }
local first_order = 0.03*20/rows

local function relaxed(p)
  local s = simulate(p, numerics)
  s:relax { tolerance = 1e-9 }
  return s
end

do
  local p = plate { width = 10*h, height = h, material = "duran50" }
  p:clamp { edge = "left", depth = dx, axis = "x", name = "grip" }
  p:traction { edge = "right", stress = {load, 0} }
  local s = relaxed(p)
  local strain = s:read { "strain", from = {2.5*h, h/2}, to = {7.5*h, h/2} }
  expect { "bar in tension: Young's modulus", unit = "Pa", got = load/strain, value = E, relative = 0.01,
           source = "E of the material" }
  local narrowing = s:read { "strain", from = {5*h, 0.25*h}, to = {5*h, 0.75*h} }
  expect { "bar in tension: Poisson's ratio", got = -narrowing/strain, value = 1/3, relative = 0.07,
           source = "plane stress of bonds; the lattice has 0.318 along its axes, 0.349 across (m = 3)" }
  expect { "bar in tension: force on its grip", unit = "N/m", got = s:reaction("grip").fx, value = load*h,
           relative = 1e-6, source = "balance" }
end

do
  local p = plate { width = 8*h + m*dx, height = h, material = "duran50" }
  p:clamp { edge = "left", depth = m*dx, name = "wall" }
  p:traction { edge = "right", stress = {0, load} }
  local s = relaxed(p)
  local x = 8*h + m*dx - dx/2
  local l, force, I, G = 8*h - dx/2, load*h, h^3/12, E/(2*(1 + 1/3))
  expect { "cantilever: deflection of its end", unit = "m", got = s:read { "point", at = {x, h/2}, of = "uy" },
           value = force*l^3/(3*E*I) + 1.2*force*l/(G*h), relative = first_order, source = "Timoshenko" }
end

do
  local outer, inner = 20*mm, 10*mm
  local half = outer + dx
  local p = plate { width = 2*half, height = 2*half, material = "duran50" }
  p:keep { centre = {half, half}, radius = outer }
  p:hole { centre = {half, half}, radius = inner, name = "bore" }
  p:pressure { rim = "bore", pressure = load }
  local s = simulate(p, { spacing = dx, horizon = 4*dx, surface = "energy", quadrature = "area" })
  s:relax { tolerance = 1e-9 }
  local ux, uy = s:values("displacement_x"), s:values("displacement_y")
  local r, sum, count = 0.5*(inner + outer), 0, 720
  for k = 1, count do
    local x, y = math.cos(2*math.pi*k/count), math.sin(2*math.pi*k/count)
    local at = {half + r*x, half + r*y}
    sum = sum + ux:at(at)*x + uy:at(at)*y
  end
  expect { "ring under inner pressure: widening", unit = "m", got = sum/count, relative = first_order*4/m, -- its horizon is longer
           value = load*inner^2/(outer^2 - inner^2)*((2/3)*r + (4/3)*outer^2/r)/E, source = "Lame" }
end

-- Half a period of the first longitudinal mode of a free bar.
do
  local l = 6*h
  local p = plate { width = l, height = h, material = "duran50" }
  local k = math.pi/l
  p:initial { velocity = function(x, y)
    return -1e-4*math.cos(k*x), -1e-4/3*k*(y - h/2)*math.sin(k*x)
  end }
  local s = simulate(p, numerics)
  local wanted = math.sqrt(E/rho)*(1 - (math.pi*h/(3*l))^2/24)/(2*l)
  local function apart()
    local sum = 0
    for row = 1, rows do
      sum = sum + s:at({l, (row - 0.5)*dx}).ux - s:at({0, (row - 0.5)*dx}).ux
    end
    return sum
  end
  while s.time < 0.4/wanted do s:step(1) end
  local before, now = apart(), apart()
  while now*before > 0 and s.time < 0.75/wanted do
    before = now
    s:step(1)
    now = apart()
  end
  expect { "free bar: first longitudinal frequency", unit = "Hz", got = 0.5/(s.time - s.dt*now/(now - before)),
           value = wanted, relative = 0.01, source = "Rayleigh and Love" }
end
