-- strip_speed.lua: how fast a crack runs in a strip that is stretched beforehand, and what J says of it.
--
-- A strip of height H between held grips at rest, stretched to G = C11 e^2 H/2 = `ratio` G0 (Rice 1967); the bonds at the tip
-- then break. For a semi-endless crack Freund (1990) has v = c_R (1 - G0/G) until waves return from the grips; later a
-- strip only has G at its disposal, whatever the speed. Prints v over c_R, Freund's value, the mean of J over G, the
-- energy of broken bonds per way of the tip over G0: the rest is radiated. What was found: tests/README.md.
--
--   hackle run tests/verification/strip_speed.lua -q --set ratio=1.5

local o = options { ratio = 1.5, m = 4, rows = 40, length = 8 }
local H, dx = 20*mm, 20*mm/o.rows
local grip, middle = o.m*dx, H/2 + o.m*dx
local lattice = { spacing = dx, horizon = o.m*dx }
local probe = simulate(plate { width = H, height = H, material = "duran50" }, lattice)
local E, nu, G0, c_R = probe.E, probe.nu, probe.G0, probe.c_R
local height = H + dx -- between the nodes that are held
local e = math.sqrt(2*o.ratio*G0*(1 - nu^2)/(E*height))

local p = plate { width = o.length*H, height = H + 2*grip, material = "duran50" }
p:crack { from = {0, middle}, to = {2*H, middle} }
for edge, sign in pairs { top = 1, bottom = -1 } do
  p:move { edge = edge, depth = grip, displacement = {0, sign*e*height/2} }
  p:nofail { edge = edge, depth = middle - (o.m + 1)*dx } -- one straight crack
end
local s = simulate(p, lattice)
s:relax()
local at_rest = s:fracture().J

local function course(from, to)
  local first, last, sum, count
  while s:cracks().right < from do s:run(0.5*us) end
  sum, count, first = 0, 0, { s:cracks().right, s.time, s.energy.broken }
  while s:cracks().right < to do
    s:run(0.5*us)
    sum, count = sum + s:fracture().J, count + 1
  end
  last = { s:cracks().right, s.time, s.energy.broken }
  local way = last[1] - first[1]
  return way/(last[2] - first[2])/c_R, sum/count/at_rest, (last[3] - first[3])/way/G0
end

print(string.format("J at rest over C11 e^2 H/2: %.3f", at_rest/(o.ratio*G0)))
print("| way | v/c_R | Freund | J over that at rest | broken energy per way over G0 |")
print("| --- | --- | --- | --- | --- |")
for _, part in ipairs { {2.1, 2.6}, {3, o.length - 2} } do
  local v, J, spent = course(part[1]*H, part[2]*H)
  print(string.format("| %.1f to %.1f H | %.3f | %.3f | %.3f | %.3f |", part[1] - 2, part[2] - 2, v, 1 - G0/at_rest, J, spent))
end
