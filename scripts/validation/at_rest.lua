-- at_rest.lua: plates with a hole, an ellipse and a crack, a squeezed disc, heat: equilibrium against closed forms.
--
-- The plate with a round hole has the exact displacements of Kirsch on its rim, so that its size does not matter; those with an
-- ellipse and a crack are eight times as wide, with Tada's correction for the crack.
-- A crack is open a part of a horizon beyond its end, and rims are soft and stepped: openings are allowed half a horizon over
-- the half axis a; so are the ends of a bar between walls.
-- Expected: stresses beyond a horizon from the hole to 5 %, openings to 7.5 %, strains of the disc to 3 %.
--
--   hackle run scripts/validation/at_rest.lua
--   hackle validate --quick at_rest

local E = 65*GPa

local function relaxed(p, numerics)
  local s = simulate(p, numerics)
  s:relax { tolerance = 1e-8 }
  return s
end

-- Displacement over strain, relative to the centre of a hole of radius R, tension along x.
local function kirsch(x, y, R, nu)
  local r, t = math.sqrt(x*x + y*y), math.atan(y, x)
  local mu, kappa, q = 0.5/(1 + nu), (3 - nu)/(1 + nu), R/math.sqrt(x*x + y*y)
  local radial = R/(8*mu)*((kappa - 1)/q + 2*q + (2/q + 2*(kappa + 1)*q - 2*q^3)*math.cos(2*t))
  local around = R/(8*mu)*(-2/q - 2*(kappa - 1)*q - 2*q^3)*math.sin(2*t)
  return radial*math.cos(t) - around*math.sin(t), radial*math.sin(t) + around*math.cos(t)
end

do
  local m, dx, strain = 3, 0.5*mm, 1e-6
  local side, R = 150*dx, 15*dx
  local nu = simulate(plate { width = 10*dx, height = 10*dx, material = "duran50" }, { spacing = dx, horizon = m*dx }).nu
  local p = plate { width = side, height = side, material = "duran50" }
  p:hole { centre = {side/2, side/2}, radius = R }
  for _, edge in ipairs { "left", "right", "bottom", "top" } do
    p:move { edge = edge, depth = 2*m*dx, displacement = function(x, y)
      local ux, uy = kirsch(x - side/2, y - side/2, R, nu)
      return strain*ux, strain*uy
    end }
  end
  local s = relaxed(p, { spacing = dx, horizon = m*dx })
  local places = {}
  for k = 0, 12 do places[#places + 1] = (1.25 + 0.25*k)*R/mm end
  expect { "stress beside a hole under tension", unit = "Pa", at = places, along = "distance from its centre in mm",
           value = function(y) return s.E*strain*0.5*(2 + (R/(y*mm))^2 + 3*(R/(y*mm))^4) end,
           got = function(y)
             local ex = s:read { "strain", from = {side/2 - dx/2, side/2 + y*mm}, to = {side/2 + dx/2, side/2 + y*mm} }
             local ey = s:read { "strain", from = {side/2, side/2 + y*mm - dx}, to = {side/2, side/2 + y*mm + dx} }
             return s.E/(1 - s.nu^2)*(ex + s.nu*ey)
           end,
           relative = 0.05, source = "Kirsch" }
end

-- The openings of an ellipse with half axes a and b across the load, and of a crack.
do
  local m, dx, a, b, load = 3, 0.5*mm, 10*mm, 4*mm, 1*MPa
  local side = 16*a
  local function pulled(defect)
    local p = plate { width = side, height = side, material = "duran50" }
    defect(p)
    p:traction { edge = "top", stress = {0, load} }
    p:traction { edge = "bottom", stress = {0, -load} }
    return relaxed(p, { spacing = dx, horizon = m*dx, surface = "energy" })
  end
  local middle = side/2
  local ellipse = pulled(function(p) p:hole { centre = {middle, middle}, radii = {a, b} } end)
  local y = b + 0.5*dx
  expect { "opening of an elliptical hole, 10 by 4 mm", unit = "m", relative = 0.5*m*dx/a,
           got = ellipse:read { "extension", from = {middle + dx/2, middle - y}, to = {middle + dx/2, middle + y} },
           value = 2*load/E*(2*a + b), source = "Inglis" }
  local crack = pulled(function(p) p:crack { from = {middle - a, middle}, to = {middle + a, middle} } end)
  local alpha = 2*a/side
  local wide = -0.071 - 0.535*alpha + 0.169*alpha^2 + 0.020*alpha^3 - 1.071/alpha*math.log(1 - alpha)
  expect { "opening of a crack of 20 mm", unit = "m", at = {0, 1, 2, 3, 4, 5, 6, 7, 8}, along = "distance from its middle in mm",
           value = function(x) return wide*4*load/E*math.sqrt(a^2 - (x*mm)^2) end,
           got = function(x)
             return crack:read { "opening", from = {middle + x*mm, middle - dx/2}, to = {middle + x*mm, middle + dx/2} }
           end,
           relative = 0.5*m*dx/a, source = "Westergaard; Tada for the width of the plate" }
end

-- A disc between two short arcs: Hondros' strains at its centre.
do
  local dx, cells = 0.25*mm, 40
  local R, pressure = cells*dx, 1*MPa
  local p = plate { width = 2*R, height = 2*R, material = "duran50" }
  p:keep { centre = {R, R}, radius = R }
  local chord = 0
  for i = 1, cells do
    if ((i - 0.5)^2 + (cells - 0.5)^2)*dx^2 <= R^2 then chord = chord + 2*dx end
  end
  local half = math.asin(0.5*chord/R)
  p:traction { edge = "top", stress = {0, -pressure} }
  p:traction { edge = "bottom", stress = {0, pressure} }
  local s = relaxed(p, { spacing = dx, horizon = 4*dx, quadrature = "area" })
  local k, g = 2*pressure/math.pi, 4.5*dx
  local across, along = k*(math.sin(2*half) - half), -k*(math.sin(2*half) + half)
  expect { "squeezed disc: strain across at its centre", relative = 0.03, value = (across - along/3)/E, source = "Hondros",
           got = s:read { "strain", from = {R - g, R + dx/2}, to = {R + g, R + dx/2} } }
  expect { "squeezed disc: strain along at its centre", relative = 0.03, value = (along - across/3)/E, source = "Hondros",
           got = s:read { "strain", from = {R + dx/2, R - g}, to = {R + dx/2, R + g} } }
end

-- A free plate expands; between walls it presses.
do
  local alphaT, heat, dx = 3e-6, 10, 1*mm
  local glass = material { like = "duran50", alphaT = alphaT }
  local free = plate { width = 40*mm, height = 20*mm, material = glass }
  free:temperature { change = heat }
  local s = relaxed(free, { spacing = dx, horizon = 4*dx })
  expect { "strain of a heated free plate", value = alphaT*heat, relative = 1e-3, source = "alphaT dT",
           got = s:read { "strain", from = {10*mm, 10*mm}, to = {30*mm, 10*mm} } }
  local held = plate { width = 100*mm, height = 20*mm, material = glass }
  held:temperature { change = heat }
  held:clamp { edge = "left", depth = dx, axis = "x", name = "wall" }
  held:clamp { edge = "right", depth = dx, axis = "x" }
  s = relaxed(held, { spacing = dx, horizon = 4*dx, surface = "energy" })
  expect { "pressure of a heated bar between walls", unit = "Pa", value = E*alphaT*heat, relative = 4*dx/(100*mm), source = "E alphaT dT",
           got = math.abs(s:reaction("wall").fx)/(20*mm) }
end
