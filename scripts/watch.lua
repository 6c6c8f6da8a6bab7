-- watch.lua: notes when a crack starts and forks, for the expectations of a scene.
--
--   local seen = require "watch" (s, 0.5*us)      -- looks every 0.5 us
--   s:run(32*us)
--   print(seen.first, seen.fork, seen.place)      -- time of the first broken bond; time and place (x) of the fork; nil without one
--
-- seen.speed is the largest speed of the right end of the crack over 5 us, m/s; seen.through the time when cracks reach both
-- the left and the right edge.
local function speed_of(tips)
  local now = tips[#tips]
  for k = #tips - 1, 1, -1 do
    if now.t - tips[k].t > 4.9*us then return (now.x - tips[k].x)/(now.t - tips[k].t) end
  end
  return 0
end

local function look(s, t, seen, tips)
  local found = s:cracks()
  if found.nodes == 0 then return end
  tips[#tips + 1] = { t = t, x = found.right }
  seen.speed = math.max(seen.speed, speed_of(tips))
  if found.fork and not seen.fork then seen.fork, seen.place = t, found.fork end
  local width = seen.width
  if not seen.through and found.left < s.spacing and found.right > width - s.spacing then seen.through = t end
end

return function(s, every, width)
  local seen, tips = { width = width or math.huge, speed = 0 }, {}
  s:on { "break", call = function(t) seen.first = t end }
  s:on { "every", every = every, call = function(t) look(s, t, seen, tips) end }
  return seen
end
