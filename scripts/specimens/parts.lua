-- parts.lua: what the specimens of this folder have in common: dimensions, pins, and measurements.
--
-- A specimen is a function of its dimensions, in m, N/m and Pa, each with a default. It returns a plate and a table
-- of what belongs to it:
--
--   local p, at = require "specimens.compact_tension" { W = 50*mm, a = 25*mm, load = 1e4 }
--   local s = simulate(p, { spacing = 0.5*mm, horizon = 2*mm })
--   s:relax()
--   print(at.measured(s), at.displacement)    -- of the gauges: in the simulation, and of the handbook
--
--   at.load          force per thickness, N/m
--   at.gauges        two places; their distance is what the handbook's displacement is of
--   at.measured(s)   how much it has grown in a simulation, m
--   at.displacement  the same from the handbook, for that load, the E of the material, and nu = 1/3
--   at.K             stress intensity of the handbook, Pa sqrt(m); nil without a crack
--   at.stress        nominal stress, Pa; nil where the standard has none
--
-- Bending specimens and the Brazilian disc take supports = "rollers" or "platens", the rigid bodies of the standard,
-- instead of "pins". All take: material; load, or velocity (m/s, with which the pins move apart, for s:quasistatic); time, the
-- amplitude of either. Forces are spread smoothly over pins and balance each other: no specimen needs a clamp to be
-- in equilibrium, except the L-panel. The spacing should divide the sizes of a specimen, so that its crack runs between
-- two rows of nodes and sums over pins are exact.
--
-- Errors are of the first order in the horizon: the rim of a plate of bonds is soft, and so are the faces of a crack.
-- Twice the result with half the horizon less that with the whole comes within 3 % of the displacements and 1.5 % of
-- K of the handbooks, for all specimens (tests/scripts/specimens_test.cpp).
local parts = {}

parts.nu = 1/3 -- of a plate of bonds in plane stress

local loading = { material = true, load = true, velocity = true, time = true }
local texts = { material = true, time = true, supports = true }

local function names_of(defaults)
  local names = {}
  for name in pairs(defaults) do names[#names + 1] = name end
  for name in pairs(loading) do if not defaults[name] then names[#names + 1] = name end end
  table.sort(names)
  return table.concat(names, ", ")
end

local function is_size(value, may_be_zero)
  return type(value) == "number" and value < math.huge and (value > 0 or may_be_zero and value == 0)
end

local function check_dimensions(who, given, defaults)
  if type(given) ~= "table" then error(who .. " takes a table of dimensions", 4) end
  for name, value in pairs(given) do
    if defaults[name] == nil and not loading[name] then
      error(string.format("%s: unknown dimension '%s'; it takes %s", who, name, names_of(defaults)), 4)
    end
    if not texts[name] and not is_size(value, defaults[name] == 0) then
      error(string.format("%s: %s is %s, it must be a number above 0", who, name, value), 4)
    end
  end
end

-- Returns the given dimensions, completed by `defaults`: values, or functions of all dimensions. Refuses unknown names,
-- and sizes that are not above 0; what is 0 by default may be 0.
function parts.dimensions(who, given, defaults)
  check_dimensions(who, given or {}, defaults)
  local o = setmetatable({}, { __index = function(all, name)
    local value = defaults[name]
    if type(value) == "function" then value = value(all) end
    all[name] = value
    return value
  end })
  for name, value in pairs(given or {}) do o[name] = value end
  for name in pairs(defaults) do local _ = o[name] end -- asks for each, which stores it
  if type(o.material) == "string" then o.material = material(o.material) end
  return o
end

-- Refuses what the standard has no solution for, in the words of the caller of the specimen.
function parts.check(who, holds, what)
  if not holds then error(who .. ": " .. what, 3) end
end

-- Acts on a square of side `size` around a place by the force {fx, fy} (N/m): densest in its middle, zero at its
-- rim, so that its sum over nodes is exact if the spacing divides the square, and to 0.1 % from 8 nodes on. With
-- o.velocity the square moves along the force instead, by `share` of it: 1/2 where another pin moves the other way,
-- which is the default.
function parts.pin(p, o, place, size, force, share)
  local x, y = place[1], place[2]
  local from, to = { x - size/2, y - size/2 }, { x + size/2, y + size/2 }
  p:nofail { from = from, to = to }
  if o.velocity then
    local speed = o.velocity*(share or 1/2)/math.sqrt(force[1]^2 + force[2]^2)
    p:move { from = from, to = to, axis = math.abs(force[1]) > math.abs(force[2]) and "x" or "y", time = o.time,
             velocity = { speed*force[1], speed*force[2] } }
    return
  end
  local function bell(distance) return (1 + math.cos(2*math.pi*distance/size))/size end
  p:body_force { from = from, to = to, time = o.time, force = function(at_x, at_y)
    local density = bell(at_x - x)*bell(at_y - y)
    return force[1]*density, force[2]*density
  end }
end

-- Presses a roller of this radius, or a platen (with `to`), against the specimen from outside, by the force {fx, fy}
-- (N/m) or at o.velocity along it; without a force it stands. `place` is a centre, or a corner.
function parts.press(p, o, place, size, force)
  local body = { time = force and o.time or nil }
  if force and o.velocity then
    local speed = o.velocity/math.sqrt(force[1]^2 + force[2]^2)
    body.velocity = { speed*force[1], speed*force[2] }
  else
    body.force = force
  end
  if type(size) == "table" then
    body.from, body.to = place, size
    p:platen(body)
  else
    body.centre, body.radius = place, size
    p:roller(body)
  end
end

-- Reads o.supports: "pins", forces inside the specimen, or the bodies that the standard has.
function parts.has_bodies(who, o, bodies)
  if o.supports ~= "pins" and o.supports ~= bodies then
    error(who .. ': supports must be "pins" or "' .. bodies .. '"', 3)
  end
  return o.supports == bodies
end

-- A beam of depth h on two rollers `span` apart, pressed in the middle by a third: as pins half as wide,
-- or, if it has_bodies, as rollers of the diameter `roller`.
function parts.bend(has_bodies, p, o, middle, h, span, roller)
  if has_bodies then
    parts.press(p, o, { middle, h + roller/2 }, roller/2, { 0, -o.load })
    for _, side in ipairs { 1, -1 } do parts.press(p, o, { middle + side*span/2, -roller/2 }, roller/2) end
    return
  end
  local pin = roller/2
  parts.pin(p, o, { middle, h - pin/2 }, pin, { 0, -o.load })
  for _, side in ipairs { 1, -1 } do
    parts.pin(p, o, { middle + side*span/2, pin/2 }, pin, { 0, o.load/2 })
  end
end

-- Returns points of an arc, both ends included; angles in rad.
function parts.arc(points, centre, radius, from, to)
  local count = 24
  for k = 0, count do
    local angle = from + (to - from)*k/count
    points[#points + 1] = { centre[1] + radius*math.cos(angle), centre[2] + radius*math.sin(angle) }
  end
end

-- Returns the node next to a place, which may lie on the rim: the lattice may be smaller than the plate.
local function node_at(s, p, place)
  local half = math.sqrt(p.width*p.height/s.nodes)/2 -- of the spacing
  local function inside(x, size) return math.max(half, math.min(x, size - half)) end
  return s:at { inside(place[1], p.width), inside(place[2], p.height) }
end

-- Completes the table that a specimen returns: `axis` is "ux" or "uy", the direction of the gauges.
function parts.gauged(p, at, axis)
  function at.measured(s)
    local one, other = node_at(s, p, at.gauges[1]), node_at(s, p, at.gauges[2])
    if one.x == other.x and one.y == other.y then
      error("both gauges lie on one node: choose a spacing with which the crack runs between two rows of nodes", 2)
    end
    return other[axis] - one[axis]
  end
  return at
end

-- Solves a specimen under its load and returns what the gauges measure, and K (nil without a crack), from the
-- strain energies of two more solutions whose cracks differ by four spacings: G = dU/da at constant force, for each
-- of `tips` ends, and K = sqrt(E G).
function parts.solve(specimen, dimensions, lattice, tips)
  local function solved(grown)
    local o = {}
    for name, value in pairs(dimensions) do o[name] = value end
    o.a = grown
    local p, at = specimen(o)
    local s = simulate(p, lattice)
    s:relax()
    return s, at
  end
  local s, at = solved(dimensions.a)
  local measured = at.measured(s)
  if not at.K then return measured, nil, at, s end
  local step = 2*lattice.spacing
  local longer, shorter = solved(at.a + step), solved(at.a - step)
  local G = (longer.energy.strain - shorter.energy.strain)/(2*step*(tips or 1))
  return measured, math.sqrt(at.E*G), at, s
end

return parts
