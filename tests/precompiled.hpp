// SPDX-License-Identifier: MIT
// What src/precompiled.hpp is for rooms, for their tests.
#pragma once

#include <random>
#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../src/precompiled.hpp"
