-- dog_bone.lua: the dumbbell for tension, type I of ASTM D638.
--
-- A narrow section of width w and length 4.4 w between shoulders of radius 5.85 w, which widen it to 1.46 w; 12.7 w
-- long in all: 165 mm for w = 13 mm. The grips pull at their ends.
-- Handbook: lengthening of the gauge length G = 3.85 w: F G/(E w); stress F/w.
-- Expected: lengthening 3.3 % above the handbook with a horizon of w/6.5; 1.6 % with w/13.
-- With surface = "energy" both are within 0.2 %.
--
--   local p, at = require "specimens.dog_bone" { w = 13*mm, load = 1e4 }
local parts = require "specimens.parts"

local defaults = {
  w = 13*mm,
  narrow = function(o) return o.w*57/13 end,
  gauge = function(o) return o.w*50/13 end,
  wide = function(o) return o.w*19/13 end,
  length = function(o) return o.w*165/13 end,
  radius = function(o) return o.w*76/13 end,
  load = 1e3,
  material = "pmma",
}

-- One quarter of the outline, from the middle of its lower side to the right end; the others are its images.
local function lower_right(o)
  local middle, axis = o.length/2, o.wide/2
  local turn = math.acos(1 - (o.wide - o.w)/2/o.radius)
  local points = {}
  parts.arc(points, { middle + o.narrow/2, axis - o.w/2 - o.radius }, o.radius, math.pi/2, math.pi/2 - turn)
  points[#points + 1] = { o.length, 0 }
  return points
end

local function outline(o)
  local quarter, points = lower_right(o), {}
  for k = #quarter, 1, -1 do points[#points + 1] = { o.length - quarter[k][1], quarter[k][2] } end
  for k = 1, #quarter do points[#points + 1] = quarter[k] end
  for k = #points, 1, -1 do points[#points + 1] = { points[k][1], o.wide - points[k][2] } end
  return points
end

return function(given)
  local o = parts.dimensions("dog_bone", given, defaults)
  local shoulder = math.sqrt(math.max(0, o.radius^2 - (o.radius - (o.wide - o.w)/2)^2))
  parts.check("dog_bone", o.wide > o.w and o.gauge <= o.narrow and o.narrow + 2*shoulder + 2*o.wide <= o.length,
              "it needs w < wide, gauge <= narrow, and grips twice as long as they are wide")
  local middle, axis, grip = o.length/2, o.wide/2, o.wide

  local p = plate { width = o.length, height = o.wide, outline = { points = outline(o) }, material = o.material }
  for _, side in ipairs { 1, -1 } do
    parts.pin(p, o, { middle + side*(o.length - grip)/2, axis }, grip, { side*o.load, 0 })
  end

  local E, F = o.material.E, o.load
  return p, parts.gauged(p, {
    E = E, load = F,
    gauges = { { middle - o.gauge/2, axis }, { middle + o.gauge/2, axis } },
    stress = F/o.w,
    displacement = F*o.gauge/(E*o.w),
  }, "ux")
end
