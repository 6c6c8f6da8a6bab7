-- dcb_curve.lua: load against opening of a double cantilever beam, at rest and in slow growth, beside linear elastic
-- fracture mechanics.
--
-- Two arms of height h, opened by a column of nodes each, which may turn. K = F/sqrt(h) (3.46 a/h + 2.38), Srawley and Gross
-- 1966; opening 8 F/(E h^3) ((a + 0.6 h)^3 + a h^2), ASTM D3433. The arms do not break: a free crack would turn into one.
-- Columns: opening and force over those at which LEFM lets the crack grow, force over LEFM's, way of the tip in h,
-- energy of broken bonds per way of the tip over G0. n: nodes of an arm. What was found: tests/README.md.
--
--   hackle run tests/verification/dcb_curve.lua -q --set n=24

local o = options { n = 24, m = 3, increments = 16, reach = 1.6, surface = "energy", quadrature = "full" }
local h = 12*mm
local dx = h/o.n
local line, a0, width = 0.5*h + dx/2, 4*h - dx/2, 10.5*h -- the column of nodes at `line` is moved

local p = plate { width = width, height = 2*h, material = "pmma" }
p:crack { from = {0, h}, to = {line + a0, h} }
for _, side in ipairs { 1, -1 } do
  local y, free = h + side*h/2, (o.m + 1)*dx
  p:move { from = {line - 0.4*dx, y - h/4}, to = {line + 0.4*dx, y + h/4}, axis = "y", velocity = {0, side/2} }
  p:nofail { from = {0, side > 0 and h + free or 0}, to = {width, side > 0 and 2*h or h - free} }
end
p:nofail { from = {0, 0}, to = {2*h, 2*h} }
local s = simulate(p, { spacing = dx, horizon = o.m*dx, surface = o.surface, quadrature = o.quadrature })
local E, G0 = s.E, s.G0

local function force_of(a) return math.sqrt(E*G0*h)/(3.46*a/h + 2.38) end
local function opening_of(F, a) return 8*F/(E*h^3)*((a + 0.6*h)^3 + a*h^2) end
local F_c = force_of(a0)
local d_c = opening_of(F_c, a0)

-- The force of LEFM at an opening.
local function lefm(d)
  if d < d_c then return F_c*d/d_c end
  local short, long = a0, 3*a0
  for _ = 1, 60 do
    local a = (short + long)/2
    if opening_of(force_of(a), a) < d then short = a else long = a end
  end
  return force_of(short)
end

print("| opening | force | over LEFM | way of the tip | energy per way |")
print("| --- | --- | --- | --- | --- |")
local before = s:cracks().right
for _ = 1, o.increments do
  s:quasistatic { duration = o.reach*d_c/o.increments, increments = 1 }
  local d = s:read { "extension", from = {line, h/2}, to = {line, 1.5*h} }
  local F, way = math.abs(s.reactions[1].fy), s:cracks().right - before
  print(string.format("| %.3f | %.3f | %.3f | %.3f | %s |", d/d_c, F/F_c, F/lefm(d), way/h,
                      way > 2*o.m*dx and string.format("%.3f", s.energy.broken/G0/way) or ""))
end
